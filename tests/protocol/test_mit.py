"""MIT frames: the worked examples, piper-sdk for the layout of before, packing by hand for today's.

Layout A (up to S-V1.8-7) is compared with `JointMitCtrl` of piper-sdk over the whole range. No kit
on PyPI packs layout B, so a packing of its own is written down here, as one number of 64 bits.
"""

from __future__ import annotations

import math

import can
import pytest
from hypothesis import given
from hypothesis import strategies as st
from piper_sdk.piper_msgs.msg_v2 import ArmMessageMapping, PiperMessage
from piper_sdk.protocol.protocol_v2 import C_PiperParserV2

from armui.protocol import commands
from armui.protocol.codec import Codec, Message
from armui.protocol.firmware_version import FirmwareVersion, quirks_of
from armui.protocol.frame import EncodeError, Frame
from armui.protocol.generation import Generation

OLDER = FirmwareVersion(1, 8, 7)
A = Codec(Generation.TWO, firmware=OLDER)
B = Codec(Generation.TWO, firmware=FirmwareVersion(1, 8, 8))
PARSER = C_PiperParserV2()

EXAMPLES = [
    # p rad, v rad/s, kp, kd, t N·m, layout A, layout B
    (0.5, 0, 10, 0.8, 2.0, "85 1E 7F F0 51 94 79 F8", "85 1E 7F F0 51 94 78 FF"),
    (0.5, 0, 10, 0.8, 0, "85 1E 7F F0 51 94 77 F6", "85 1E 7F F0 51 94 77 FF"),
    (0, 0, 10, 0.8, 0, "7F FF 7F F0 51 94 77 FD", "7F FF 7F F0 51 94 77 FF"),
    (-0.5, 1.0, 20, 1.0, -1.5, "7A E0 82 D0 A3 99 96 74", "7A E0 82 D0 A3 99 97 3F"),
    (0, 0, 0, 0, 0, "7F FF 7F F0 00 7F F7 F7", "7F FF 7F F0 00 7F F7 FF"),
]
RANGES = {
    "Position": (16, -12.5, 12.5),
    "Velocity": (12, -45.0, 45.0),
    "Kp": (12, 0.0, 500.0),
    "Kd": (12, -5.0, 5.0),
}
TORQUES = {"A": (8, -8.0, 8.0), "B": (12, -16.0, 16.0)}


def setpoint(codec: Codec, joint: int, *values: float) -> Frame:
    p, v, kp, kd, t = values
    (frame,) = commands.mit_setpoint(
        codec, joint, position_rad=p, speed_rad_s=v, kp=kp, kd=kd, torque_nm=t
    )
    return frame


@pytest.mark.parametrize(("p", "v", "kp", "kd", "t", "a", "b"), EXAMPLES)
def test_the_worked_examples(p, v, kp, kd, t, a, b):
    assert setpoint(A, 1, p, v, kp, kd, t) == Frame(0x15A, bytes.fromhex(a))
    assert setpoint(B, 6, p, v, kp, kd, t) == Frame(0x15F, bytes.fromhex(b))


def test_the_whole_chain_for_an_older_arm():
    """S-V1.6-5, joint 2: sign flipped and torque divided by 4."""
    version = FirmwareVersion(1, 6, 5)
    quirks = quirks_of(version)
    sign, factor = quirks.mit_signs[1], quirks.mit_torque_factors[1]
    codec = Codec(Generation.TWO, firmware=version)
    frame = setpoint(codec, 2, sign * 0.5, sign * 0.0, 10, 0.8, sign * 2.0 / factor)
    assert frame == Frame(0x15B, bytes.fromhex("7A E0 7F F0 51 94 77 77"))


def test_each_layout_read_as_the_other():
    """As computed in the table: an A frame read as B has twice the torque and the check in it."""
    *_, older, newer = EXAMPLES[0]  # 2 N·m
    a, b = Frame(0x15A, bytes.fromhex(older)), Frame(0x15A, bytes.fromhex(newer))
    # 16·159 + 8 = 2552: 2552·32/4095 - 16; 2303 // 16 = 143: 143·16/255 - 8
    assert B.decode(a).signals["Torque"] == pytest.approx(3.94, abs=0.005)
    assert A.decode(b).signals["Torque"] == pytest.approx(0.97, abs=0.005)


VALUES = {name: st.floats(low, high) for name, (_, low, high) in RANGES.items()}


def _raw(value: float, bits: int, low: float, high: float) -> int:
    return math.trunc((value - low) * (2**bits - 1) / (high - low))


@given(st.integers(1, 6), st.fixed_dictionaries({**VALUES, "Torque": st.floats(-8.0, 8.0)}))
def test_layout_a_as_piper_sdk_sends_it(joint, values):
    theirs = PiperMessage()
    mit = theirs.arm_joint_mit_ctrl
    fields = {"Position": "pos_ref", "Velocity": "vel_ref", "Kp": "kp", "Kd": "kd"}
    for name, field in fields.items():
        bits, low, high = RANGES[name]
        setattr(mit, field, PARSER.FloatToUint(values[name], low, high, bits))
    mit.t_ref = PARSER.FloatToUint(values["Torque"], -8.0, 8.0, 8)
    theirs.type_ = ArmMessageMapping.get_mapping(can_id=0x159 + joint)
    sent = can.Message()
    assert PARSER.EncodeMessage(theirs, sent)
    ours = setpoint(A, joint, *(values[name] for name in [*fields, "Torque"]))
    assert ours == Frame(sent.arbitration_id, bytes(sent.data))
    assert A.decode(ours).signals["Crc4"] == mit.crc


@given(st.integers(1, 6), st.fixed_dictionaries({**VALUES, "Torque": st.floats(-16.0, 16.0)}))
def test_layout_b_as_packed_by_hand(joint, values):
    word = 0
    for name, (bits, low, high) in {**RANGES, "Torque": TORQUES["B"]}.items():
        word = word << bits | _raw(values[name], bits, low, high)
    ours = setpoint(B, joint, *(values[name] for name in [*RANGES, "Torque"]))
    assert ours == Frame(0x159 + joint, word.to_bytes(8, "big"))
    decoded = B.decode(ours)
    assert isinstance(decoded, Message)
    for name, (bits, low, high) in {**RANGES, "Torque": TORQUES["B"]}.items():
        step = (high - low) / (2**bits - 1)
        assert -1e-9 <= values[name] - decoded.signals[name] <= step + 1e-9


@pytest.mark.parametrize("codec", [A, B], ids="AB")
@pytest.mark.parametrize("end", [0, 1], ids=["lowest", "highest"])
def test_the_ends_of_every_range(codec, end):
    ends = [RANGES[name][1 + end] for name in RANGES]
    torque_nm = TORQUES[codec.quirks.mit_layout.value][1 + end]
    frame = setpoint(codec, 3, *ends, torque_nm)
    decoded = codec.decode(frame).signals
    assert [decoded[name] for name in RANGES] == pytest.approx(ends)
    assert decoded["Torque"] == pytest.approx(torque_nm)


@pytest.mark.parametrize(
    ("codec", "values", "words"),
    [
        (A, (12.51, 0, 0, 0, 0), "Position cannot be 12.51 rad"),
        (A, (0, -45.1, 0, 0, 0), "Velocity cannot be -45.1 rad/s"),
        (A, (0, 0, -0.2, 0, 0), "Kp cannot be -0.2"),
        (A, (0, 0, 0, 5.1, 0), "Kd cannot be 5.1"),
        (A, (0, 0, 0, 0, 8.1), "Torque cannot be 8.1 N.m (range -8 to 8 N.m)"),
        (B, (0, 0, 0, 0, 16.1), "Torque cannot be 16.1 N.m (range -16 to 16 N.m)"),
        (B, (math.nan, 0, 0, 0, 0), "give a finite number"),
    ],
)
def test_nothing_wraps(codec, values, words):
    with pytest.raises(EncodeError) as caught:
        setpoint(codec, 1, *values)
    assert words in str(caught.value)


def test_a_torque_of_today_fits_todays_layout_only():
    assert setpoint(B, 1, 0, 0, 0, 0, 8.1)


@pytest.mark.parametrize(
    ("codec", "word"),
    [(A, "01 04 00 AD 00 00 00 00"), (B, "01 06 00 AD 00 00 00 00")],
)
def test_the_mode_word_has_the_code_of_the_version(codec, word):
    assert commands.set_mit_mode(codec) == [Frame(0x151, bytes.fromhex(word))]


@pytest.mark.parametrize("joint", [0, 7])
def test_there_are_six_joints(joint):
    with pytest.raises(EncodeError, match="1, 2, 3, 4, 5, 6"):
        setpoint(A, joint, 0, 0, 0, 0, 0)


def test_generation_1_has_no_mit():
    with pytest.raises(EncodeError, match="no message MitControl1"):
        setpoint(Codec(Generation.ONE), 1, 0, 0, 0, 0, 0)
