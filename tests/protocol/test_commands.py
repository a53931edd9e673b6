"""Each command against the frames the protocol text asks for."""

from __future__ import annotations

import inspect
from typing import Any

import pytest

from armui.protocol import commands
from armui.protocol.addressing import Addressing
from armui.protocol.codec import Codec
from armui.protocol.codes import (
    ArcPointNumber,
    ControlMode,
    EndLoad,
    LinkageRole,
    MitMode,
    Mounting,
    MoveMode,
    SilenceMode,
    TeachingState,
    TrajectoryCommand,
)
from armui.protocol.frame import EncodeError
from armui.protocol.generation import Generation

ONE, TWO = Codec(Generation.ONE), Codec(Generation.TWO)
POSE = (56.128, 0, 213.266, 0, 85, 0)
# 56128 = 0xDB40, 213266 = 0x34112, 85000 = 0x14C08
POSE_FRAMES = (
    "152 0000DB4000000000",
    "153 0003411200000000",
    "154 00014C0800000000",
)
BY_HAND = {
    "emergency_stop": ["150 0100000000000000"],
    "resume": ["150 0200000000000000"],
    "trajectory_command": ["150 0006000000000000"],
    "teaching_command": ["150 0000010000000000"],
    # 20 % = 0x14, 255 = 0xFF
    "set_mode": ["151 070114ADFF010000"],
    # 1° = 1000 = 0x3E8, -1° = 0xFFFFFC18
    "joint_target": ["155 000003E800000000", "156 0000000000000000", "157 00000000FFFFFC18"],
    "cartesian_target": [*POSE_FRAMES],
    # 50 % = 0x32
    "move_joints": [
        "155 000003E800000000", "156 0000000000000000", "157 00000000FFFFFC18",
        "151 0101320000000000",
    ],
    "move_pose": [*POSE_FRAMES, "151 0102640000000000"],
    "arc_point": ["158 0200000000000000"],
    "move_arc": [
        *POSE_FRAMES, "158 0100000000000000",
        *POSE_FRAMES, "158 0200000000000000",
        *POSE_FRAMES, "158 0300000000000000",
        "151 01030A0000000000",
    ],
    # 70 mm = 0x11170, 1.5 N·m = 0x5DC
    "move_gripper_opening": ["159 0001117005DC0100"],
    "disable_gripper": ["159 0000000000000000"],
    "clear_gripper_error": ["159 0000000000000200"],
    "set_gripper_zero": ["159 00000000000000AE"],
    "enable_motors": ["471 0702000000000000"],
    "disable_motors": ["471 0301000000000000"],
    "query_limits": ["472 0101000000000000"],
    "query_acceleration": ["472 0602000000000000"],
    "query_end_limits": ["477 0100000000000000"],
    "query_collision_levels": ["477 0200000000000000"],
    "query_teaching": ["477 0400000000000000"],
    "query_drag_assistance": ["477 0500000000000000"],
    "query_firmware": ["4AF 0100000000000000"],
    "set_joint_zero": ["475 03AE007FFF000000"],
    "clear_joint_error": ["475 0700007FFFAE0000"],
    "reset_end_limits": ["477 0001000000000000"],
    "reset_joint_limits": ["477 0002000000000000"],
    "set_end_feedback": ["477 0000020000000000"],
    "set_load": ["477 000000AE02000000"],
    # 150 % = 0x96, 100 mm = 0x64
    "set_parameters": ["47D 9664050000000000"],
    "set_linkage": ["470 FA10002000000000"],
    "set_bus_silence": ["422 0100000000000000"],
    "set_light": ["121 0102FFFF80000007"],
    # 45.5° = 45500 = 0xB1BC; 1 N·m = 0x3E8; bits 0 and 2
    "move_gripper_to_angle": ["159 0000B1BC03E80500"],
}  # fmt: skip
CALLS: dict[str, tuple[tuple[Any, ...], dict[str, Any]]] = {
    "trajectory_command": ((TrajectoryCommand.ABORT,), {}),
    "teaching_command": ((TeachingState.START_RECORDING,), {}),
    "set_mode": ((), {
        "control_mode": ControlMode.OFFLINE_TRAJECTORY, "move_mode": MoveMode.MOVE_J,
        "speed_percent": 20, "mit_mode": MitMode.MIT, "dwell_s": 255, "mounting": Mounting.LEVEL,
    }),
    "joint_target": (([1, 0, 0, 0, 0, -1],), {}),
    "cartesian_target": ((POSE,), {}),
    "move_joints": (([1, 0, 0, 0, 0, -1],), {"speed_percent": 50}),
    "move_pose": ((POSE,), {"speed_percent": 100, "move_mode": MoveMode.MOVE_L}),
    "arc_point": ((ArcPointNumber.MIDDLE,), {}),
    "move_arc": ((POSE, POSE, POSE), {"speed_percent": 10}),
    "move_gripper_opening": ((), {"opening_mm": 70, "torque_nm": 1.5}),
    "disable_motors": ((3,), {}),
    "query_limits": ((1,), {}),
    "query_acceleration": ((6,), {}),
    "set_joint_zero": ((3,), {}),
    "set_end_feedback": ((), {"on": False}),
    "set_load": ((EndLoad.FULL,), {}),
    "set_parameters": (
        ("TeachingSetting", {"TeachingRange": 150, "StrokeLimit": 100, "Friction": 5}), {},
    ),
    "set_linkage": (
        (LinkageRole.TEACHING_INPUT,), {"feedback_offset": 0x10, "target_offset": 0x20},
    ),
    "set_bus_silence": ((SilenceMode.SILENCE_FOR_CONTROLLER_UPGRADE,), {}),
    "set_light": ((2, (255, 128, 0)), {"counter": 7}),
    "move_gripper_to_angle": ((), {"angle_deg": 45.5, "torque_nm": 1}),
}  # fmt: skip


def wire(frames) -> list[str]:
    return [f"{frame.arbitration_id:03X} {frame.data.hex().upper()}" for frame in frames]


def test_every_command_is_checked_here():
    one_only = {"move_gripper_angle"}
    told = {
        name: function
        for name, function in inspect.getmembers(commands, inspect.isfunction)
        if function.__module__ == commands.__name__ and not name.startswith("_")
    }
    assert told.keys() == BY_HAND.keys() | one_only
    for function in told.values():
        assert next(iter(inspect.signature(function).parameters)) == "codec"


@pytest.mark.parametrize("name", BY_HAND)
def test_generation_2(name):
    arguments, keywords = CALLS.get(name, ((), {}))
    assert wire(getattr(commands, name)(TWO, *arguments, **keywords)) == BY_HAND[name]


@pytest.mark.parametrize(
    ("message", "joint", "values", "expected"),
    [
        # 150° = 1500 = 0x5DC; unchanged; 3 rad/s = 300 = 0x12C
        ("LimitSetting", 1, {"MaxAngle": 150, "MinAngle": None, "MaxSpeed": 3},
         "474 0105DC7FFF012C00"),
        # 5 rad/s² = 500 = 0x1F4
        ("JointSetting", 2, {"MaxAcceleration": 5}, "475 0200AE01F4000000"),
        # 1.0 = 1000 = 0x3E8
        ("EndLimitSetting", 0, {"MaxLinearSpeed": 1, "MaxAngularSpeed": None,
                                "MaxLinearAcceleration": None, "MaxAngularAcceleration": 1},
         "479 03E87FFF7FFF03E8"),
        ("CollisionSetting", 0, {"J1": 0, "J2": 1, "J3": 2, "J4": 3, "J5": 4, "J6": 8},
         "47A 0001020304080000"),
    ],
)  # fmt: skip
def test_the_values_an_arm_keeps_are_set_by_message(message, joint, values, expected):
    assert wire(commands.set_parameters(TWO, message, values, joint)) == [expected]


def test_generation_1_has_its_own_gripper_lengths_and_codes():
    # 70° = 0x11170, 1.5 rad/s = 0x5DC
    gripper = commands.move_gripper_angle(ONE, angle_deg=70, speed_rad_s=1.5)
    assert wire(gripper) == ["159 0001117005DC0100"]
    assert wire(commands.set_linkage(ONE, LinkageRole.MOTION_OUTPUT)) == ["470 FC000000"]
    assert wire(commands.set_bus_silence(ONE, SilenceMode.LEAVE_SILENCE)) == ["422 00"]
    assert wire(commands.arc_point(ONE, ArcPointNumber.END)) == ["158 03"]
    assert wire(commands.set_end_feedback(ONE, on=True)) == ["477 0000010000000000"]
    assert wire(commands.set_end_feedback(ONE, on=False)) == ["477 0000000000000000"]
    assert wire(commands.set_joint_zero(ONE, 3)) == ["475 03AE000000000000"]
    # 150° = 0x5DC, -150° = 0xFA24, 3000 rpm = 0xBB8
    values = {"MaxAngle": 150, "MinAngle": -150, "MaxSpeed": 3000}
    limits = commands.set_parameters(ONE, "LimitSetting", values, 1)
    assert wire(limits) == ["474 0105DCFA240BB800"]


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: commands.set_parameters(
            ONE, "LimitSetting", {"MaxAngle": None, "MinAngle": 0, "MaxSpeed": 1}, 1),
         "LimitSetting.MaxAngle"),
        (lambda: commands.set_parameters(ONE, "JointSetting", {"MaxAcceleration": None}, 1),
         "JointSetting.MaxAcceleration"),
        (lambda: commands.query_teaching(ONE), "ParameterCommand.Query cannot be 4"),
        (lambda: commands.query_firmware(ONE), "no message FirmwareVersion"),
        (lambda: commands.reset_joint_limits(ONE), "ParameterCommand.Reset cannot be 2"),
        (lambda: commands.set_gripper_zero(ONE), "no signal SetZero"),
        (lambda: commands.move_gripper_opening(ONE, opening_mm=1, torque_nm=1), "no signal"),
        (lambda: commands.set_mode(
            ONE, control_mode=ControlMode.STANDBY, move_mode=MoveMode.MOVE_J, speed_percent=1,
            dwell_s=1), "no signal DwellTime"),
        (lambda: commands.move_gripper_angle(TWO, angle_deg=1, speed_rad_s=1), "no signal Speed"),
        (lambda: commands.trajectory_command(TWO, TrajectoryCommand.TRANSFER), "not documented"),
        (lambda: commands.move_joints(TWO, [0, 0], speed_percent=1), "wants 6 joint angles, not 2"),
        (lambda: commands.set_parameters(TWO, "CollisionSetting", {"J7": 0}), "no signal J7"),
        (lambda: commands.enable_motors(TWO, 0), "MotorEnable.Joint cannot be 0"),
        (lambda: commands.query_limits(TWO, 7), "LimitQuery.Joint cannot be 7"),
        (lambda: commands.set_linkage(TWO, LinkageRole.UNCHANGED, feedback_offset=0x30),
         "FeedbackOffset cannot be 48"),
    ],
)  # fmt: skip
def test_refuses(call, words):
    with pytest.raises(EncodeError, match=words):
        call()


def test_commands_follow_the_arm_to_its_offset():
    codec = Codec(Generation.TWO, Addressing(control_offset=0x10))
    assert wire(commands.emergency_stop(codec)) == ["160 0100000000000000"]
