"""MIT frames as they are read: worked examples, piper-sdk's for the layout of before, today's.

Layout A (up to S-V1.8-7) is what `JointMitCtrl` of piper-sdk sends over the whole range. No kit on
PyPI packs layout B, so a packing of its own is written down here, as one number of 64 bits.
"""

from __future__ import annotations

import math

import can
import pytest
from hypothesis import given
from hypothesis import strategies as st
from piper_sdk.piper_msgs.msg_v2 import ArmMessageMapping, PiperMessage
from piper_sdk.protocol.protocol_v2 import C_PiperParserV2

from armui.protocol.codec import Codec, Message
from armui.protocol.firmware_version import FirmwareVersion
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

A = Codec(Generation.TWO, firmware=FirmwareVersion(1, 8, 7))
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
RANGES_A = {**RANGES, "Torque": (8, -8.0, 8.0)}
RANGES_B = {**RANGES, "Torque": (12, -16.0, 16.0)}


def assert_read(codec: Codec, joint: int, data: bytes, values: dict[str, float], ranges) -> None:
    """Asserts that the frame says the values, each rounded down to a raw step."""
    decoded = codec.decode(Frame(0x159 + joint, data))
    assert isinstance(decoded, Message)
    assert decoded.name == f"MitControl{joint}"
    for name, (bits, low, high) in ranges.items():
        step = (high - low) / (2**bits - 1)
        assert -1e-9 <= values[name] - decoded.signals[name] <= step + 1e-9


@pytest.mark.parametrize(("p", "v", "kp", "kd", "t", "a", "b"), EXAMPLES)
def test_the_worked_examples(p, v, kp, kd, t, a, b):
    values = {"Position": p, "Velocity": v, "Kp": kp, "Kd": kd, "Torque": t}
    assert_read(A, 1, bytes.fromhex(a), values, RANGES_A)
    assert_read(B, 6, bytes.fromhex(b), values, RANGES_B)


def test_each_layout_read_as_the_other():
    """As computed in the table: an A frame read as B has twice the torque and the check in it."""
    *_, older, newer = EXAMPLES[0]  # 2 N·m
    a, b = Frame(0x15A, bytes.fromhex(older)), Frame(0x15A, bytes.fromhex(newer))
    # 16·159 + 8 = 2552: 2552·32/4095 - 16; 2303 // 16 = 143: 143·16/255 - 8
    assert B.decode(a).signals["Torque"] == pytest.approx(3.94, abs=0.005)
    assert A.decode(b).signals["Torque"] == pytest.approx(0.97, abs=0.005)


def values_of(ranges):
    return st.fixed_dictionaries({n: st.floats(low, high) for n, (_, low, high) in ranges.items()})


@given(st.integers(1, 6), values_of(RANGES_A))
def test_layout_a_as_piper_sdk_sends_it(joint, values):
    theirs = PiperMessage()
    mit = theirs.arm_joint_mit_ctrl
    fields = {"Position": "pos_ref", "Velocity": "vel_ref", "Kp": "kp", "Kd": "kd"}
    for name, field in {**fields, "Torque": "t_ref"}.items():
        bits, low, high = RANGES_A[name]
        setattr(mit, field, PARSER.FloatToUint(values[name], low, high, bits))
    theirs.type_ = ArmMessageMapping.get_mapping(can_id=0x159 + joint)
    sent = can.Message()
    assert PARSER.EncodeMessage(theirs, sent)
    assert_read(A, joint, bytes(sent.data), values, RANGES_A)
    assert A.decode(Frame(sent.arbitration_id, bytes(sent.data))).signals["Crc4"] == mit.crc


def packed(values: dict[str, float]) -> bytes:
    word = 0
    for name, (bits, low, high) in RANGES_B.items():
        word = word << bits | math.trunc((values[name] - low) * (2**bits - 1) / (high - low))
    return word.to_bytes(8, "big")


@given(st.integers(1, 6), values_of(RANGES_B))
def test_layout_b_as_packed_by_hand(joint, values):
    assert_read(B, joint, packed(values), values, RANGES_B)


def test_generation_1_has_no_mit():
    assert not isinstance(Codec(Generation.ONE).decode(Frame(0x15A, bytes(8))), Message)
