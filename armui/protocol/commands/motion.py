"""Commands that move or stop the arm: 0x150–0x159 and 0x471."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.protocol.codes import (
    ALL_JOINTS,
    VALID,
    ArcPointNumber,
    ControlMode,
    GripperMeasure,
    MitMode,
    MotorAction,
    Mounting,
    MoveMode,
    StopCommand,
    TeachingState,
    TrajectoryCommand,
)
from armui.protocol.commands.checks import exactly
from armui.protocol.errors import EncodeError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame


def emergency_stop(codec: Codec) -> list[Frame]:
    """All motors go limp under damping; the arm sinks slowly (0x150)."""
    return [codec.encode("MotionCommand", EmergencyStop=StopCommand.EMERGENCY_STOP)]


def resume(codec: Codec) -> list[Frame]:
    """Ends the emergency stop: power is cut at once and the arm DROPS (0x150)."""
    return [codec.encode("MotionCommand", EmergencyStop=StopCommand.RESUME)]


def trajectory_command(codec: Codec, command: TrajectoryCommand) -> list[Frame]:
    """Pauses, continues, clears or aborts trajectories (0x150).

    Transferring points (generation 2) needs a check sum that is not documented, and is refused.

    Raises:
        EncodeError: The command is one of the transfer.
    """
    if command in {TrajectoryCommand.TRANSFER, TrajectoryCommand.TRANSFER_ENDS}:
        raise EncodeError(
            f"MotionCommand.TrajectoryCommand cannot be {int(command)} (range 0 to 6): the check "
            "sum of transferred points is not documented; play the trajectory from the host",
            message="MotionCommand",
            signal="TrajectoryCommand",
            value=int(command),
            minimum=TrajectoryCommand.OFF,
            maximum=TrajectoryCommand.ABORT,
        )
    return [codec.encode("MotionCommand", TrajectoryCommand=command)]


def teaching_command(codec: Codec, command: TeachingState) -> list[Frame]:
    """Starts, stops and replays drag teaching (0x150)."""
    return [codec.encode("MotionCommand", TeachingCommand=command)]


def set_mode(
    codec: Codec,
    *,
    control_mode: ControlMode,
    move_mode: int,
    speed_percent: float,
    mit_mode: MitMode = MitMode.POSITION_VELOCITY,
    dwell_s: float = 0,
    mounting: Mounting = Mounting.UNCHANGED,
) -> list[Frame]:
    """Control mode, kind of motion and speed (0x151).

    Args:
        codec: The arm's codec.
        control_mode: 0–4, in generation 2 also 7.
        move_mode: Kind of motion: a `MoveMode`, in generation 2 also ``MOVE_UNCHANGED``.
        speed_percent: 0–100; 0 means no motion.
        mit_mode: Generation 2 only.
        dwell_s: Pause at a point of an offline trajectory, 0–254 s; 255 ends it. Generation 2 only.
        mounting: Generation 2 only.
    """
    optional = {"MitMode": mit_mode, "DwellTime": dwell_s, "Mounting": mounting}
    return [
        codec.encode(
            "ModeControl",
            ControlMode=control_mode,
            MoveMode=move_mode,
            SpeedPercent=speed_percent,
            **{name: value for name, value in optional.items() if value},
        )
    ]


def joint_target(codec: Codec, joints_deg: Sequence[float]) -> list[Frame]:
    """Target angles of joints 1–6, without starting the motion (0x155–0x157)."""
    j1, j2, j3, j4, j5, j6 = exactly("JointTarget12", joints_deg, 6, "joint angles", "deg")
    return [
        codec.encode("JointTarget12", J1=j1, J2=j2),
        codec.encode("JointTarget34", J3=j3, J4=j4),
        codec.encode("JointTarget56", J5=j5, J6=j6),
    ]


def cartesian_target(codec: Codec, pose: Sequence[float]) -> list[Frame]:
    """Target of the flange, without starting the motion (0x152–0x154).

    Args:
        codec: The arm's codec.
        pose: X, Y, Z in mm and RX, RY, RZ in degrees.
    """
    x, y, z, rx, ry, rz = exactly("CartesianTarget1", pose, 6, "pose values", "mm and deg")
    return [
        codec.encode("CartesianTarget1", X=x, Y=y),
        codec.encode("CartesianTarget2", Z=z, RX=rx),
        codec.encode("CartesianTarget3", RY=ry, RZ=rz),
    ]


def move_joints(codec: Codec, joints_deg: Sequence[float], *, speed_percent: float) -> list[Frame]:
    """Moves to six joint angles in degrees: targets, then 0x151 with MOVE J."""
    return [*joint_target(codec, joints_deg), *_can_control(codec, MoveMode.MOVE_J, speed_percent)]


def move_pose(
    codec: Codec,
    pose: Sequence[float],
    *,
    speed_percent: float,
    move_mode: MoveMode = MoveMode.MOVE_P,
) -> list[Frame]:
    """Moves the flange to a pose: targets, then 0x151 with MOVE P, or MOVE L for a straight line.

    Args:
        codec: The arm's codec.
        pose: X, Y, Z in mm and RX, RY, RZ in degrees.
        speed_percent: 0–100.
        move_mode: MOVE_P, MOVE_L or, in generation 2, MOVE_CPV.
    """
    return [*cartesian_target(codec, pose), *_can_control(codec, move_mode, speed_percent)]


def arc_point(codec: Codec, point: ArcPointNumber) -> list[Frame]:
    """Marks the pose sent just before as start, middle or end of an arc (0x158)."""
    return [codec.encode("ArcPoint", Point=point)]


def move_arc(
    codec: Codec,
    start: Sequence[float],
    middle: Sequence[float],
    end: Sequence[float],
    *,
    speed_percent: float,
) -> list[Frame]:
    """Moves along an arc through three poses (X, Y, Z in mm, RX, RY, RZ in degrees): MOVE C."""
    frames: list[Frame] = []
    points = (ArcPointNumber.START, ArcPointNumber.MIDDLE, ArcPointNumber.END)
    for pose, point in zip((start, middle, end), points, strict=True):
        frames += cartesian_target(codec, pose)
        frames += arc_point(codec, point)
    return frames + _can_control(codec, MoveMode.MOVE_C, speed_percent)


def move_gripper_opening(codec: Codec, *, opening_mm: float, torque_nm: float) -> list[Frame]:
    """Moves the gripper to an opening with a torque of 0–5 N·m (0x159, generation 2)."""
    return [codec.encode("GripperCommand", Opening=opening_mm, Torque=torque_nm, Enable=1)]


def move_gripper_to_angle(codec: Codec, *, angle_deg: float, torque_nm: float) -> list[Frame]:
    """Moves the gripper to an angle with a torque of 0–5 N·m (0x159, from S-V1.8-8)."""
    return [
        codec.encode(
            "GripperCommand",
            Measure=GripperMeasure.ANGLE,
            Angle=angle_deg,
            Torque=torque_nm,
            Enable=1,
        )
    ]


def move_gripper_angle(codec: Codec, *, angle_deg: float, speed_rad_s: float) -> list[Frame]:
    """Moves the gripper to an angle with a speed (0x159, generation 1)."""
    return [codec.encode("GripperCommand", Angle=angle_deg, Speed=speed_rad_s, Enable=1)]


def disable_gripper(codec: Codec) -> list[Frame]:
    """Cuts the power of the gripper (0x159)."""
    return [codec.encode("GripperCommand")]


def clear_gripper_error(codec: Codec) -> list[Frame]:
    """Clears the gripper's error (0x159)."""
    return [codec.encode("GripperCommand", ClearError=1)]


def set_gripper_zero(codec: Codec) -> list[Frame]:
    """Makes the present opening the gripper's zero (0x159, generation 2)."""
    return [codec.encode("GripperCommand", SetZero=VALID)]


def enable_motors(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Powers one joint's motor, or all of them with 7 (0x471)."""
    return [codec.encode("MotorEnable", Joint=joint, Action=MotorAction.ENABLE)]


def disable_motors(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Cuts the power of one joint's motor, or of all with 7: the arm DROPS (0x471)."""
    return [codec.encode("MotorEnable", Joint=joint, Action=MotorAction.DISABLE)]


def _can_control(codec: Codec, move_mode: MoveMode, speed_percent: float) -> list[Frame]:
    return set_mode(
        codec,
        control_mode=ControlMode.CAN_CONTROL,
        move_mode=move_mode,
        speed_percent=speed_percent,
    )
