"""Odd frames never raise, impossible values always do."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec, InvalidFrame, InvalidFrameKind, Message
from armui.protocol.frame import EncodeError, Frame
from armui.protocol.generation import Generation

CODECS = {generation: Codec(generation) for generation in Generation}
ONE, TWO = CODECS[Generation.ONE], CODECS[Generation.TWO]
LENIENT = {0x158: {1, 8}, 0x422: {1, 8}, 0x470: {4, 8}, 0x4AF: {1, 8}}
"""Sent shorter by generation 1; both generations accept both lengths."""


def frame(arbitration_id: int, payload: str) -> Frame:
    return Frame(arbitration_id, bytes.fromhex(payload))


# --- decoding ---------------------------------------------------------------------------------


@given(
    generation=st.sampled_from(Generation),
    arbitration_id=st.integers(0, 0x7FF),
    data=st.binary(max_size=8),
    offsets=st.tuples(st.sampled_from((0, 0x10, 0x20)), st.sampled_from((0, 0x10, 0x20))),
)
def test_any_frame_is_a_message_or_an_invalid_frame(generation, arbitration_id, data, offsets):
    codec = Codec(generation, Addressing(*offsets)) if any(offsets) else CODECS[generation]
    decoded = codec.decode(Frame(arbitration_id, data))
    if isinstance(decoded, InvalidFrame):
        assert decoded.arbitration_id == arbitration_id
        assert decoded.detail
    else:
        assert decoded.signals.keys() == set(codec.signals(decoded.name))
        assert all(math.isfinite(value) for value in decoded.signals.values())


@given(generation=st.sampled_from(Generation), data=st.data())
def test_what_decodes_encodes_to_the_same_bytes(generation, data):
    """Over the whole range of every message; reserved bits are the only thing lost."""
    codec = CODECS[generation]
    name = data.draw(st.sampled_from(sorted(codec._by_name)))
    layout = codec._by_name[name]
    payload = data.draw(st.binary(min_size=layout.length, max_size=layout.length))
    decoded = codec.decode(Frame(layout.arbitration_id, payload))
    if isinstance(decoded, Message):
        kept = int.from_bytes(payload, "big") & ~layout.reserved_mask
        expected = kept.to_bytes(layout.length, "big")
        assert codec.encode(name, **decoded.signals) == Frame(layout.arbitration_id, expected)


@pytest.mark.parametrize("generation", Generation)
def test_every_wrong_length_is_told(generation):
    codec = CODECS[generation]
    for layout in codec._by_name.values():
        good = LENIENT.get(layout.arbitration_id, {layout.length})
        for length in range(9):
            decoded = codec.decode(Frame(layout.arbitration_id, bytes(length)))
            is_wrong = (
                isinstance(decoded, InvalidFrame) and decoded.kind is InvalidFrameKind.WRONG_LENGTH
            )
            assert is_wrong == (length not in good), (layout.name, length)


@pytest.mark.parametrize("generation", Generation)
@pytest.mark.parametrize("payload", ["03", "03 00 00 00 00 00 00 00"])
def test_short_and_padded_forms_say_the_same(generation, payload):
    decoded = CODECS[generation].decode(frame(0x158, payload))
    assert decoded == Message("ArcPoint", {"Point": 3})


def test_linkage_setting_of_four_bytes_in_generation_2():
    decoded = TWO.decode(frame(0x470, "FA 10 20 10"))
    expected: dict[str, float] = {
        "Role": 0xFA,
        "FeedbackOffset": 0x10,
        "ControlOffset": 0x20,
        "TargetOffset": 0x10,
    }
    assert decoded == Message("LinkageSetting", expected)


def test_wrong_length_names_message_and_lengths():
    invalid_frame = TWO.decode(frame(0x470, "FA 10"))
    assert invalid_frame == InvalidFrame(
        InvalidFrameKind.WRONG_LENGTH, 0x470, "LinkageSetting has 2 bytes instead of 4 or 8"
    )


@pytest.mark.parametrize(
    ("codec", "arbitration_id", "payload", "words"),
    [
        # 0x0E and 0x07 are codes of generation 2 only
        (ONE, 0x2A1, "00 0E 00 00 00 00 00 00", "ArmStatus.Status is 14, not in its table"),
        (ONE, 0x2A1, "07 00 00 00 00 00 00 00", "ArmStatus.ControlMode is 7"),
        (TWO, 0x2A1, "08 10 00 00 00 00 00 00", "ControlMode is 8, not in its table; ArmStatus.St"),
        # 101 %
        (ONE, 0x2A1, "00 00 00 00 00 65 00 00", "SpeedPercent is 101 %, not within 0 to 100 %"),
        (ONE, 0x2A8, "00 00 00 00 00 00 40 00", "GripperFeedback.Enabled is 64"),
        (TWO, 0x47B, "09 00 00 00 00 00 00 00", "CollisionFeedback.J1 is 9, not within 0 to 8"),
        # 5001 = 0x1389
        (TWO, 0x159, "00 00 00 00 13 89 00 00", "Torque is 5.001 N.m, not within 0 to 5 N.m"),
        # 0x8000 is just above "leave unchanged"
        (TWO, 0x479, "80 00 00 00 00 00 00 00", "MaxLinearSpeed is 32.768 m/s"),
        # "zz" = 7A 7A = 31354
        (TWO, 0x181, "72 7A 7A 00 00 00 01", "CpvControl1.Kind is 31354, not in its table"),
        (TWO, 0x187, "77 70 6F 00 00 00 01", "CpvGripper.Kind is 28783"),
        (TWO, 0x488, "0B 00 00 00 00 00 00 00", "DragAssistanceFeedback.J1 is 11"),
        (TWO, 0x191, "01 01 00 00 00 00 00 00", "LeaderZero.Command is 65792"),
    ],
)
def test_values_outside_their_table_are_told_and_still_readable(
    codec, arbitration_id, payload, words
):
    invalid_frame = codec.decode(frame(arbitration_id, payload))
    assert isinstance(invalid_frame, InvalidFrame)
    assert invalid_frame.kind is InvalidFrameKind.VALUE_OUTSIDE_TABLE
    assert words in invalid_frame.detail
    assert invalid_frame.message is not None
    layout = codec.layout(arbitration_id).variant(bytes.fromhex(payload))
    assert invalid_frame.message.signals.keys() == layout.signals.keys()


@pytest.mark.parametrize("codec", [ONE, TWO])
@pytest.mark.parametrize("arbitration_id", [0x471, 0x472, 0x473, 0x474, 0x475, 0x47C])
def test_a_frame_of_a_joint_that_no_arm_has_says_nothing(codec, arbitration_id):
    invalid_frame = codec.decode(frame(arbitration_id, "08 01 00 00 00 00 00 00"))

    assert isinstance(invalid_frame, InvalidFrame)
    assert invalid_frame.kind is InvalidFrameKind.VALUE_OUTSIDE_TABLE
    assert ".Joint is 8" in invalid_frame.detail
    assert invalid_frame.message is None


def test_the_message_beside_an_invalid_frame_is_in_physical_units():
    # 90° = 0x15F90 beside an unknown gripper state
    invalid_frame = ONE.decode(frame(0x2A8, "00 01 5F 90 05 DC 02 00"))
    assert invalid_frame.message == Message(
        "GripperFeedback", {"Angle": 90.0, "Speed": 1.5, "Enabled": 2}
    )


@pytest.mark.parametrize(
    "arbitration_id", [0x0A0, 0x0AF, 0x0B0, 0x0BF, 0x4A0, 0x4AE, 0x4B0, 0x4BF, 0x4C0, 0x4CF]
)
def test_firmware_upgrade_ranges_are_named(arbitration_id):
    for codec in CODECS.values():
        invalid_frame = codec.decode(Frame(arbitration_id, bytes(8)))
        assert invalid_frame.kind is InvalidFrameKind.UNKNOWN_ID
        assert "firmware upgrade range" in invalid_frame.detail


def test_firmware_version_is_an_upgrade_identifier_to_generation_1():
    assert "firmware upgrade range" in ONE.decode(Frame(0x4AF, bytes(8))).detail
    assert isinstance(TWO.decode(Frame(0x4AF, bytes(8))), Message)


def test_other_unknown_identifiers():
    assert TWO.decode(Frame(0x777, b"")) == InvalidFrame(
        InvalidFrameKind.UNKNOWN_ID, 0x777, "0x777 is not in the tables of generation 2"
    )
    assert ONE.decode(Frame(0x47D, bytes(8))).kind is InvalidFrameKind.UNKNOWN_ID


# --- encoding ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("codec", "message", "signals", "words"),
    [
        (TWO, "ModeControl", {"SpeedPercent": 101},
         "ModeControl.SpeedPercent cannot be 101 % (range 0 to 100 %); give 0 to 100 %"),
        (TWO, "ModeControl", {"SpeedPercent": -0.4}, "cannot be -0.4 %"),
        (TWO, "ModeControl", {"SpeedPercent": 100.4}, "cannot be 100.4 %"),
        (TWO, "ModeControl", {"ControlMode": 6}, "give 0 (Standby), 1 (CAN control), 2 (Teaching)"),
        (ONE, "ModeControl", {"ControlMode": 7}, "ModeControl.ControlMode cannot be 7"),
        (TWO, "ModeControl", {"ControlMode": 1.5}, "cannot be 1.5"),
        (TWO, "CollisionSetting", {"J3": 2.5}, "J3 cannot be 2.5 (range 0 to 8); give a whole num"),
        (TWO, "CollisionSetting", {"J3": 9}, "CollisionSetting.J3 cannot be 9 (range 0 to 8)"),
        (TWO, "JointTarget12", {"J1": math.nan}, "J1 cannot be nan deg"),
        (TWO, "JointTarget12", {"J1": math.inf}, "J1 cannot be inf deg"),
        (TWO, "JointTarget12", {"J1": -math.inf}, "give a finite number"),
        (TWO, "JointTarget12", {"J1": 2147483.648},
         "(range -2147483.648 to 2147483.647 deg)"),
        (TWO, "JointTarget12", {"J1": 10**400}, "give a number"),
        (TWO, "JointTarget12", {"J1": "12"}, "J1 cannot be '12' deg"),
        (TWO, "JointTarget12", {"J1": [1.0, 2.0]}, "give a number"),
        (TWO, "JointTarget12", {"J1": 1j}, "give a number"),
        (TWO, "JointTarget12", {"J1": None}, "it cannot be left unchanged"),
        (ONE, "LimitSetting", {"Joint": 1, "MaxAngle": None}, "it cannot be left unchanged"),
        # 327.664 is nearest to a raw step between the range's end and "leave unchanged"
        (TWO, "LimitSetting", {"Joint": 1, "MaxSpeed": 327.664}, "327.67 rad/s (Leave unchanged)"),
        (TWO, "LimitSetting", {"Joint": 1, "MaxSpeed": 400}, "range 0 to 327.66 rad/s"),
        (TWO, "LimitSetting", {}, "LimitSetting.Joint cannot be nothing"),
        (TWO, "GripperCommand", {"Torque": 5.001}, "range 0 to 5 N.m"),
        (ONE, "GripperCommand", {"Opening": 5}, "no signal Opening in this generation; it has Ang"),
        (TWO, "LightControl", {"Joint": 1, "Lamp": 256}, "0 to 254, or 255 (All lamps)"),
        (TWO, "TeachingSetting", {"TeachingRange": 99, "Friction": 1}, "range 100 to 200 %"),
        (TWO, "JointTraget12", {}, "did you mean JointTarget12?"),
        (ONE, "TeachingSetting", {}, "Generation 1 has no message TeachingSetting"),
        (ONE, "x", {}, "see the DBC file"),
        (TWO, "GripperCommand", {"Angle": 5}, "Angle is only there with Measure = 'Angle'"),
        (TWO, "GripperCommand", {"Opening": 5, "Measure": 1}, "only there with Measure = 'Opening"),
        (TWO, "GripperCommand", {"Measure": 2}, "Measure cannot be 2"),
        (TWO, "CpvControl1", {"Action": 0x72}, "CpvControl1.Kind cannot be nothing"),
        (TWO, "CpvControl1", {"Action": 0x72, "Kind": 0x706F, "SpeedKp": 1}, "'Speed Kp'"),
        (TWO, "DragAssistanceSetting", {"J1": 11}, "range 0 to 10"),
    ],
)  # fmt: skip
def test_refuses_in_words(codec, message, signals, words):
    with pytest.raises(EncodeError) as caught:
        codec.encode(message, **signals)
    assert words in str(caught.value)
    assert caught.value.message == message


def test_an_unknown_meaning_leaves_what_every_frame_has():
    # 24 V of nothing: byte 7 is neither opening nor angle; -1.5 N·m = 0xFA24, bit 6
    odd = TWO.decode(frame(0x2A8, "00 01 86 A0 FA 24 40 02"))
    assert odd.kind is InvalidFrameKind.VALUE_OUTSIDE_TABLE
    assert odd.message.signals.keys() & {"Opening", "Angle"} == set()
    assert (odd.message.signals["Torque"], odd.message.signals["Enabled"]) == (-1.5, 1)


def test_what_a_frame_may_lack_is_told_before():
    assert TWO.may_lack("GripperFeedback", "Opening")
    assert not TWO.may_lack("GripperFeedback", "Torque")
    assert not ONE.may_lack("GripperFeedback", "Angle")


def test_the_error_carries_its_parts():
    with pytest.raises(EncodeError) as caught:
        TWO.encode("ModeControl", SpeedPercent=101)
    error = caught.value
    assert (error.signal, error.value, error.minimum, error.maximum, error.unit) == (
        "SpeedPercent", 101, 0, 100, "%",
    )  # fmt: skip


@given(st.floats(-2147483.648, 2147483.647))
def test_rounds_to_the_nearest_step(angle_deg):
    sent = TWO.decode(TWO.encode("JointTarget12", J1=angle_deg)).signals["J1"]
    assert abs(sent - angle_deg) <= 0.0005 * (1 + 1e-9)


@given(generation=st.sampled_from(Generation), data=st.data())
def test_out_of_range_is_never_clamped(generation, data):
    codec = CODECS[generation]
    layout = codec._by_name[data.draw(st.sampled_from(sorted(codec._by_name)))]
    signal = data.draw(st.sampled_from(sorted(layout.signals.values(), key=lambda s: s.name)))
    beyond = data.draw(
        st.floats(min_value=signal.maximum + signal.scale * 0.01, max_value=1e12)
        | st.floats(min_value=-1e12, max_value=signal.minimum - signal.scale * 0.01)
    )
    if any(abs(signal.to_physical(raw) - beyond) < 1e-5 for raw in signal.words):
        return
    with pytest.raises(EncodeError) as caught:
        codec.encode(layout.name, **{signal.name: beyond})
    assert caught.value.message == layout.name


@pytest.mark.parametrize("value", [np.float64(1.5), np.float32(1.5), 1.5])
def test_takes_the_numbers_of_numpy(value):
    # 1.5° = 1500 = 0x5DC
    sent = TWO.encode("JointTarget12", J1=value, J2=np.int64(-1))  # type: ignore[arg-type]
    assert sent == frame(0x155, "00 00 05 DC FF FF FC 18")


def test_none_and_silence_leave_settings_unchanged_in_generation_2():
    unchanged = frame(0x474, "02 7F FF 7F FF 7F FF 00")
    assert TWO.encode("LimitSetting", Joint=2) == unchanged
    assert TWO.encode("LimitSetting", Joint=2, MaxAngle=None, MinAngle=None) == unchanged
    # 0x8000 is the lower end of int16: -3276.8°
    lowest = TWO.encode("LimitSetting", Joint=2, MinAngle=-3276.8)
    assert lowest == frame(0x474, "02 7F FF 80 00 7F FF 00")


def test_words_and_codes():
    assert TWO.word("ArmStatus", "Status", 1) == "Emergency stop"
    assert TWO.word("ArmStatus", "Status", 99) is None
    assert TWO.word("JointFeedback12", "J1", 1.0) is None
    assert TWO.word("LimitSetting", "MaxSpeed", 327.67) == "Leave unchanged"
    assert (ONE.code("ParameterCommand", "EndFeedback", "Off"), TWO.code(
        "ParameterCommand", "EndFeedback", "Off")) == (0, 2)  # fmt: skip
    with pytest.raises(EncodeError, match="it knows Off, On"):
        ONE.code("ParameterCommand", "EndFeedback", "No change")
    assert TWO.unit("DriverFast1", "Speed") == "rad/s"
    assert ONE.unit("DriverFast1", "Speed") == "rpm"
    with pytest.raises(EncodeError, match="has no signal J3"):
        ONE.unit("JointFeedback12", "J3")


def test_exact_is_stricter_than_decodable():
    # byte 6 of 0x2A1 is reserved in generation 1
    limit = frame(0x2A1, "01 00 01 00 00 32 01 00")
    assert (ONE.is_exact(limit), TWO.is_exact(limit)) == (False, True)
    assert isinstance(ONE.decode(limit), Message)
    short = frame(0x158, "01")
    assert (ONE.is_exact(short), TWO.is_exact(short)) == (True, False)


# --- identifier offsets -----------------------------------------------------------------------


def test_offsets_move_feedback_and_commands_only():
    shifted = Codec(Generation.TWO, Addressing(feedback_offset=0x10, control_offset=0x20))
    assert shifted.encode("JointFeedback12", J1=1).arbitration_id == 0x2B5
    assert shifted.encode("ModeControl").arbitration_id == 0x171
    assert shifted.encode("MitControl6").arbitration_id == 0x17F
    assert shifted.encode("MotorEnable", Joint=1, Action=1).arbitration_id == 0x471
    assert shifted.encode("DriverFast1").arbitration_id == 0x251
    assert shifted.decode(frame(0x2B5, "00 00 03 E8 00 00 00 00")).signals["J1"] == 1.0


@pytest.mark.parametrize("arbitration_id", [0x2A5, 0x2C5, 0x150, 0x165])
def test_frames_of_the_other_arm_are_told(arbitration_id):
    shifted = Codec(Generation.TWO, Addressing(feedback_offset=0x10, control_offset=0x20))
    invalid_frame = shifted.decode(Frame(arbitration_id, bytes(8)))
    assert invalid_frame.kind is InvalidFrameKind.UNKNOWN_ID
    assert "other identifier offsets" in invalid_frame.detail


@given(
    feedback=st.sampled_from((0, 0x10, 0x20)),
    control=st.sampled_from((0, 0x10, 0x20)),
    arbitration_id=st.integers(0, 0x7FF),
)
def test_addressing_there_and_back(feedback, control, arbitration_id):
    addressing = Addressing(feedback, control)
    table_id = addressing.from_wire(arbitration_id)
    if table_id is not None:
        assert addressing.to_wire(table_id) == arbitration_id


@pytest.mark.parametrize("offsets", [(0x30, 0), (0, 1), (-0x10, 0)])
def test_addressing_refuses_other_offsets(offsets):
    with pytest.raises(ValueError, match="0x00, 0x10 and 0x20 only"):
        Addressing(*offsets)
