"""Cross-check against the maker's own parser, the PyPI package piper-sdk (generation 2).

A round trip through one codec cannot show a wrong scale or byte order; a second, independent
decoder can. piper-sdk hands out raw integers, so physical values are multiplied by the steps per
unit written down here. Where it and the protocol differ:

- Units stand in its comments only. Those of 0x474 say 0.001 rad/s for the speed; real arms answer
  300 for 3 rad/s, so one step is 0.01 rad/s, as in 0x473. The raw bytes agree.
- The torque of 0x159 it encodes unsigned and decodes signed. The protocol allows 0 to 5 N.m, where
  both are the same; the test keeps below the sign bit.
- Of 0x476 it decodes bytes 0 and 1 only, of 0x151 bytes 0 to 4, of 0x159 no single bits.
- It decodes neither 0x481-0x486 nor most of the host's commands, and encodes neither 0x121 nor
  0x422: those have only their rows of literal bytes.
- Of 0x159 and 0x2A8 it knows the opening only, of MIT the layout of up to S-V1.8-7 (`test_mit`).
- It lets 0x471 address joint 0xFF and 0x472 joint 7, 0x151 carry MIT mode 0xFF, and 0x477 a load of
  3; the protocol's tables have none of these, and the codec refuses them.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from operator import attrgetter

import can
import pytest
from hypothesis import given
from hypothesis import strategies as st
from piper_sdk.piper_msgs.msg_v2 import ArmMessageMapping, PiperMessage
from piper_sdk.protocol.protocol_v2 import C_PiperParserV2

from armui.protocol.codec import Codec, InvalidFrame, Message
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

CODEC = Codec(Generation.TWO)
PARSER = C_PiperParserV2()


@dataclass(frozen=True)
class Counterpart:
    """Where piper-sdk keeps a message: an attribute of its PiperMessage, and the fields in it."""

    arbitration_id: int
    holder: str
    fields: dict[str, str]
    steps_per_unit: dict[str, int] = field(default_factory=dict)

    def steps(self, signal: str) -> int:
        return self.steps_per_unit.get(signal, 1)


def _joints(pattern: str) -> dict[str, str]:
    return {f"J{j}": pattern.format(j) for j in range(1, 7)}


Pairs = dict[int, tuple[str, dict[str, str]]]
"""By identifier: what holds it in piper-sdk, and the names there of ours."""


def _pairs(base: int, names: tuple[str, ...], holder: str, pattern: str) -> Pairs:
    """Two int32 of 0.001 a frame, three frames in a row."""
    return {
        base + k: (
            holder,
            {n: pattern.format(n.removeprefix("J")) for n in names[2 * k : 2 * k + 2]},
        )
        for k in range(3)
    }


AXES = ("X", "Y", "Z", "RX", "RY", "RZ")
JOINTS = tuple(f"J{j}" for j in range(1, 7))
NAMES = {
    0x152: "CartesianTarget1", 0x153: "CartesianTarget2", 0x154: "CartesianTarget3",
    0x155: "JointTarget12", 0x156: "JointTarget34", 0x157: "JointTarget56",
    0x2A2: "EndPose1", 0x2A3: "EndPose2", 0x2A4: "EndPose3",
    0x2A5: "JointFeedback12", 0x2A6: "JointFeedback34", 0x2A7: "JointFeedback56",
}  # fmt: skip


def _thousandths(table: Pairs) -> dict[str, Counterpart]:
    return {
        NAMES[frame_id]: Counterpart(frame_id, holder, fields, dict.fromkeys(fields, 1000))
        for frame_id, (holder, fields) in table.items()
    }


LIMITS = {"MaxAngle": 10, "MinAngle": 10, "MaxSpeed": 100}
END_LIMIT_FIELDS = {
    "MaxLinearSpeed": "end_max_linear_vel", "MaxAngularSpeed": "end_max_angular_vel",
    "MaxLinearAcceleration": "end_max_linear_acc", "MaxAngularAcceleration": "end_max_angular_acc",
}  # fmt: skip
TEACHING_FIELDS = {
    "TeachingRange": "teaching_range_per", "StrokeLimit": "max_range_config",
    "Friction": "teaching_friction",
}  # fmt: skip
LIMIT_FIELDS = {
    "Joint": "motor_num", "MaxAngle": "max_angle_limit", "MinAngle": "min_angle_limit",
    "MaxSpeed": "max_joint_spd",
}  # fmt: skip
JOINT_TARGETS = _thousandths(_pairs(0x155, JOINTS, "arm_joint_ctrl", "joint_{}"))
GRIPPER_COMMAND = Counterpart(
    0x159, "arm_gripper_ctrl", {"Opening": "grippers_angle", "Torque": "grippers_effort",
                                "SetZero": "set_zero"},
    {"Opening": 1000, "Torque": 1000},
)  # fmt: skip

DECODED = {
    **_thousandths(_pairs(0x2A2, AXES, "arm_end_pose", "{}_axis")),
    **_thousandths(_pairs(0x2A5, JOINTS, "arm_joint_feedback", "joint_{}")),
    **JOINT_TARGETS,
    "GripperCommand": GRIPPER_COMMAND,
    "ArmStatus": Counterpart(0x2A1, "arm_status_msgs", {
        "ControlMode": "ctrl_mode", "Status": "arm_status", "MoveMode": "mode_feed",
        "TeachingState": "teach_status", "MotionState": "motion_status",
        "TrajectoryPoint": "trajectory_num",
        **{f"J{j}LimitExceeded": f"err_status.joint_{j}_angle_limit" for j in range(1, 7)},
        **{f"J{j}CommunicationFault": f"err_status.communication_status_joint_{j}"
           for j in range(1, 7)},
    }),
    "GripperFeedback": Counterpart(0x2A8, "gripper_feedback", {
        "Opening": "grippers_angle", "Torque": "grippers_effort",
        "Undervoltage": "foc_status.voltage_too_low",
        "MotorOvertemperature": "foc_status.motor_overheating",
        "Overcurrent": "foc_status.driver_overcurrent",
        "DriverOvertemperature": "foc_status.driver_overheating",
        "SensorFault": "foc_status.sensor_status", "DriverFault": "foc_status.driver_error_status",
        "Enabled": "foc_status.driver_enable_status", "Homed": "foc_status.homing_status",
    }, {"Opening": 1000, "Torque": 1000}),
    **{f"DriverFast{j}": Counterpart(0x250 + j, f"arm_high_spd_feedback_{j}", {
        "Speed": "motor_speed", "Current": "current", "Position": "pos",
    }, {"Speed": 1000, "Current": 1000, "Position": 1000}) for j in range(1, 7)},
    **{f"DriverSlow{j}": Counterpart(0x260 + j, f"arm_low_spd_feedback_{j}", {
        "Voltage": "vol", "DriverTemperature": "foc_temp", "MotorTemperature": "motor_temp",
        "Undervoltage": "foc_status.voltage_too_low",
        "MotorOvertemperature": "foc_status.motor_overheating",
        "Overcurrent": "foc_status.driver_overcurrent",
        "DriverOvertemperature": "foc_status.driver_overheating",
        "CollisionProtection": "foc_status.collision_status",
        "DriverFault": "foc_status.driver_error_status",
        "Enabled": "foc_status.driver_enable_status",
        "StallProtection": "foc_status.stall_status", "BusCurrent": "bus_current",
    }, {"Voltage": 10, "BusCurrent": 1000}) for j in range(1, 7)},
    "ModeControl": Counterpart(0x151, "arm_motion_ctrl_2", {
        "ControlMode": "ctrl_mode", "MoveMode": "move_mode", "SpeedPercent": "move_spd_rate_ctrl",
        "MitMode": "mit_mode", "DwellTime": "residence_time",
    }),
    "LimitFeedback": Counterpart(
        0x473, "arm_feedback_current_motor_angle_limit_max_spd", LIMIT_FIELDS, LIMITS),
    "SettingResponse": Counterpart(0x476, "arm_feedback_resp_set_instruction", {
        "Index": "instruction_index", "ZeroSet": "is_set_zero_successfully",
    }),
    "EndLimitFeedback": Counterpart(
        0x478, "arm_feedback_current_end_vel_acc_param", END_LIMIT_FIELDS,
        dict.fromkeys(END_LIMIT_FIELDS, 1000)),
    "CollisionFeedback": Counterpart(
        0x47B, "arm_crash_protection_rating_feedback", _joints("joint_{}_protection_level")),
    "AccelerationFeedback": Counterpart(0x47C, "arm_feedback_current_motor_max_acc_limit", {
        "Joint": "joint_motor_num", "MaxAcceleration": "max_joint_acc",
    }, {"MaxAcceleration": 100}),
    "TeachingFeedback": Counterpart(
        0x47E, "arm_gripper_teaching_param_feedback", TEACHING_FIELDS),
}  # fmt: skip

ENCODED = {
    **_thousandths(_pairs(0x152, AXES, "arm_motion_ctrl_cartesian", "{}_axis")),
    **JOINT_TARGETS,
    "GripperCommand": GRIPPER_COMMAND,
    "MotionCommand": Counterpart(0x150, "arm_motion_ctrl_1", {
        "EmergencyStop": "emergency_stop", "TrajectoryCommand": "track_ctrl",
        "TeachingCommand": "grag_teach_ctrl",
    }),
    "ModeControl": Counterpart(0x151, "arm_motion_ctrl_2", {
        **DECODED["ModeControl"].fields, "Mounting": "installation_pos",
    }),
    "ArcPoint": Counterpart(0x158, "arm_circular_ctrl", {"Point": "instruction_num"}),
    "LinkageSetting": Counterpart(0x470, "arm_ms_config", {
        "Role": "linkage_config", "FeedbackOffset": "feedback_offset",
        "ControlOffset": "ctrl_offset", "TargetOffset": "linkage_offset",
    }),
    "MotorEnable": Counterpart(
        0x471, "arm_motor_enable", {"Joint": "motor_num", "Action": "enable_flag"}),
    "LimitQuery": Counterpart(0x472, "arm_search_motor_max_angle_spd_acc_limit", {
        "Joint": "motor_num", "Query": "search_content",
    }),
    "LimitSetting": Counterpart(
        0x474, "arm_motor_angle_limit_max_spd_set", LIMIT_FIELDS, LIMITS),
    "JointSetting": Counterpart(0x475, "arm_joint_config", {
        "Joint": "joint_motor_num", "SetZero": "set_motor_current_pos_as_zero",
        "AccelerationValid": "acc_param_config_is_effective_or_not",
        "MaxAcceleration": "max_joint_acc", "ClearError": "clear_joint_err",
    }, {"MaxAcceleration": 100}),
    "ParameterCommand": Counterpart(0x477, "arm_param_enquiry_and_config", {
        "Query": "param_enquiry", "Reset": "param_setting", "EndFeedback": "data_feedback_0x48x",
        "LoadValid": "end_load_param_setting_effective", "Load": "set_end_load",
    }),
    "EndLimitSetting": Counterpart(
        0x479, "arm_end_vel_acc_param_config", END_LIMIT_FIELDS,
        dict.fromkeys(END_LIMIT_FIELDS, 1000)),
    "CollisionSetting": Counterpart(
        0x47A, "arm_crash_protection_rating_config", _joints("joint_{}_protection_level")),
    "TeachingSetting": Counterpart(0x47D, "arm_gripper_teaching_param_config", TEACHING_FIELDS),
}  # fmt: skip


def _sdk_decode(arbitration_id: int, payload: bytes) -> PiperMessage:
    decoded = PiperMessage()
    frame = can.Message(arbitration_id=arbitration_id, data=payload, is_extended_id=False)
    assert PARSER.DecodeMessage(frame, decoded), f"piper-sdk does not know 0x{arbitration_id:03X}"
    return decoded


def _sdk_encode(arbitration_id: int, message: PiperMessage) -> Frame:
    message.type_ = ArmMessageMapping.get_mapping(can_id=arbitration_id)
    sent = can.Message()
    assert PARSER.EncodeMessage(message, sent)
    return Frame(sent.arbitration_id, bytes(sent.data))


def _payloads(name: str) -> st.SearchStrategy[bytes]:
    """Any eight bytes, but for what piper-sdk does not hand out as it came."""
    if name == "ArmStatus":  # it replaces codes beyond its tables
        codes = st.tuples(*[st.integers(0, top) for top in (7, 15, 5, 7, 1)]).map(bytes)
        return st.builds(bytes.__add__, codes, st.binary(min_size=3, max_size=3))
    payloads = st.binary(min_size=8, max_size=8)
    if name == "GripperCommand":  # it takes the sign bit of the torque for a sign, knows no angle
        return payloads.filter(lambda payload: payload[4] < 0x80 and not payload[6] & 4)
    if name in {"LimitFeedback", "AccelerationFeedback"}:  # it knows joints an arm hasn't, too
        joints = st.integers(1, 6).map(lambda joint: bytes([joint]))
        return st.builds(bytes.__add__, joints, st.binary(min_size=7, max_size=7))
    if name == "GripperFeedback":  # nor here
        return payloads.map(lambda payload: payload[:7] + b"\0")
    return payloads


@pytest.mark.parametrize("name", DECODED)
@given(data=st.data())
def test_decodes_the_same_values(name, data):
    counterpart = DECODED[name]
    payload = data.draw(_payloads(name))
    ours = CODEC.decode(Frame(counterpart.arbitration_id, payload))
    if isinstance(ours, InvalidFrame):  # piper-sdk has no opinion on values outside a table
        assert ours.message is not None
        ours = ours.message
    theirs = attrgetter(counterpart.holder)(_sdk_decode(counterpart.arbitration_id, payload))
    assert isinstance(ours, Message)
    assert ours.name == name
    for signal, where in counterpart.fields.items():
        raw = ours.signals[signal] * counterpart.steps(signal)
        assert round(raw) == pytest.approx(raw, abs=1e-6), signal
        assert round(raw) == int(attrgetter(where)(theirs)), signal


@given(payload=st.binary(min_size=8, max_size=8))
def test_firmware_text_is_the_same_bytes(payload):
    ours = CODEC.decode(Frame(0x4AF, payload)).signals
    assert (
        bytes(int(ours[f"Byte{i}"]) for i in range(8)) == _sdk_decode(0x4AF, payload).firmware_data
    )


def _raw_values(name: str, signal: str) -> st.SearchStrategy[int]:
    layout = CODEC._by_name[name].signals[signal]
    codes = st.sampled_from(sorted(layout.words)) if layout.words else st.nothing()
    if layout.exhaustive:
        return codes
    low, high = (round(layout.to_steps(end)) for end in (layout.minimum, layout.maximum))
    return st.integers(low, high) | codes


@pytest.mark.parametrize("name", ENCODED)
@given(data=st.data())
def test_encodes_the_same_bytes(name, data):
    counterpart = ENCODED[name]
    theirs = PiperMessage()
    holder = getattr(theirs, counterpart.holder)
    ours = {}
    for signal, where in counterpart.fields.items():
        raw = data.draw(_raw_values(name, signal), label=signal)
        setattr(holder, where, raw)
        ours[signal] = raw / counterpart.steps(signal)
    if name == "GripperCommand":  # piper-sdk has one status byte for the two bits
        holder.status_code = data.draw(st.integers(0, 3), label="status_code")
        ours |= {"Enable": holder.status_code & 1, "ClearError": holder.status_code >> 1}
    assert CODEC.encode(name, **ours) == _sdk_encode(counterpart.arbitration_id, theirs)
