from __future__ import annotations

import pytest

from armui.protocol import commands
from armui.protocol.codec import Codec, EncodeError, Message
from armui.protocol.database import Generation
from armui.protocol.frame import Frame


@pytest.mark.parametrize("generation", Generation)
def test_joint_feedback_in_degrees(generation):
    codec = Codec(generation)
    # 90.000° = 90000 = 0x00015F90, -0.001° = -1 = 0xFFFFFFFF
    frame = Frame(0x2A5, bytes.fromhex("00015F90 FFFFFFFF"))
    assert codec.decode(frame) == Message("JointFeedback12", {"J1": 90.0, "J2": -0.001})
    assert codec.encode("JointFeedback12", J1=90, J2=-0.001) == frame


def test_move_joints_sends_targets_then_mode():
    frames = commands.move_joints(Codec(Generation.TWO), [1, 0, 0, 0, 0, -1], speed_percent=50)
    assert [str(frame) for frame in frames] == [
        "0x155 [8] 00 00 03 E8 00 00 00 00",
        "0x156 [8] 00 00 00 00 00 00 00 00",
        "0x157 [8] 00 00 00 00 FF FF FC 18",
        "0x151 [8] 01 01 32 00 00 00 00 00",
    ]


def test_refuses_out_of_range():
    with pytest.raises(EncodeError, match=r"ModeControl.SpeedPercent cannot be 101 %"):
        Codec(Generation.ONE).encode("ModeControl", SpeedPercent=101)
