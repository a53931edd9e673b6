"""What a host can say to the arm: one function a command, each returns the frames in sending order.

All take the codec first and physical units after it (degrees, millimetres, seconds; what else says so in its name).
They raise `EncodeError` for a value the protocol cannot carry and for a command the generation does not have;
whether the arm can do what is asked is not theirs to judge. Direct (MIT) control of motors is left out on purpose.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.protocol.codes import (
    ALL_JOINTS,
    ALL_LAMPS,
    VALID,
    ArcPointNumber,
    ControlMode,
    EndLoad,
    FactoryReset,
    LimitQuery,
    LinkageRole,
    MitMode,
    MotorAction,
    Mounting,
    MoveMode,
    ParameterQuery,
    SilenceMode,
    StopCommand,
    TeachingState,
    TrajectoryCommand,
)
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
            f"MotionCommand.TrajectoryCommand cannot be {int(command)}: the check sum of transferred points "
            "is not documented; play the trajectory from the host instead",
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
    move_mode: MoveMode,
    speed_percent: float,
    mit_mode: MitMode = MitMode.POSITION_VELOCITY,
    dwell_s: float = 0,
    mounting: Mounting = Mounting.UNCHANGED,
) -> list[Frame]:
    """Control mode, kind of motion and speed (0x151).

    Args:
        codec: The arm's codec.
        control_mode: 0–4, in generation 2 also 7.
        move_mode: Kind of motion.
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
    j1, j2, j3, j4, j5, j6 = _counted("JointTarget12", joints_deg, 6, "joint angles", "deg")
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
    x, y, z, rx, ry, rz = _counted("CartesianTarget1", pose, 6, "pose values", "mm and deg")
    return [
        codec.encode("CartesianTarget1", X=x, Y=y),
        codec.encode("CartesianTarget2", Z=z, RX=rx),
        codec.encode("CartesianTarget3", RY=ry, RZ=rz),
    ]


def move_joints(codec: Codec, joints_deg: Sequence[float], *, speed_percent: float) -> list[Frame]:
    """Moves to six joint angles in degrees: targets, then 0x151 with MOVE J."""
    return [
        *joint_target(codec, joints_deg),
        *_can_control(codec, MoveMode.MOVE_J, speed_percent),
    ]


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


def move_gripper_opening(
    codec: Codec, *, opening_mm: float, torque_nm: float, enable: bool = True
) -> list[Frame]:
    """Moves the gripper to an opening with a torque of 0–5 N·m (0x159, generation 2)."""
    return [
        codec.encode("GripperCommand", Opening=opening_mm, Torque=torque_nm, Enable=int(enable))
    ]


def move_gripper_angle(
    codec: Codec, *, angle_deg: float, speed_rad_s: float, enable: bool = True
) -> list[Frame]:
    """Moves the gripper to an angle with a speed (0x159, generation 1)."""
    return [codec.encode("GripperCommand", Angle=angle_deg, Speed=speed_rad_s, Enable=int(enable))]


def disable_gripper(codec: Codec) -> list[Frame]:
    """Cuts the power of the gripper (0x159)."""
    return [codec.encode("GripperCommand")]


def clear_gripper_error(codec: Codec, *, enable: bool = False) -> list[Frame]:
    """Clears the gripper's error, and enables it in the same breath if wished (0x159)."""
    return [codec.encode("GripperCommand", ClearError=1, Enable=int(enable))]


def set_gripper_zero(codec: Codec) -> list[Frame]:
    """Makes the present opening the gripper's zero (0x159, generation 2)."""
    return [codec.encode("GripperCommand", SetZero=VALID)]


def enable_motors(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Powers one joint's motor, or all of them with 7 (0x471)."""
    return [codec.encode("MotorEnable", Joint=joint, Action=MotorAction.ENABLE)]


def disable_motors(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Cuts the power of one joint's motor, or of all with 7: the arm DROPS (0x471)."""
    return [codec.encode("MotorEnable", Joint=joint, Action=MotorAction.DISABLE)]


def query_limits(codec: Codec, joint: int) -> list[Frame]:
    """Asks for a joint's angle and speed limits; answered by LimitFeedback (0x472)."""
    return [codec.encode("LimitQuery", Joint=joint, Query=LimitQuery.ANGLE_AND_SPEED_LIMITS)]


def query_acceleration(codec: Codec, joint: int) -> list[Frame]:
    """Asks for a joint's acceleration limit; answered by AccelerationFeedback (0x472)."""
    return [codec.encode("LimitQuery", Joint=joint, Query=LimitQuery.ACCELERATION_LIMIT)]


def query_end_limits(codec: Codec) -> list[Frame]:
    """Asks for the end's speed and acceleration limits; answered by EndLimitFeedback (0x477)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.END_LIMITS)]


def query_collision_levels(codec: Codec) -> list[Frame]:
    """Asks for the collision protection levels; answered by CollisionFeedback (0x477)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.COLLISION_LEVELS)]


def query_trajectory_index(codec: Codec) -> list[Frame]:
    """Asks for the index of the trajectory (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.TRAJECTORY_INDEX)]


def query_teaching(codec: Codec) -> list[Frame]:
    """Asks for the teaching handle's setting; answered by TeachingFeedback (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.TEACHING_SETTING)]


def query_firmware(codec: Codec) -> list[Frame]:
    """Asks for the firmware version (0x4AF, generation 2).

    Generation 1 stays silent, which is how a host tells the two apart: ask with a codec of generation 2.
    """
    return [codec.encode("FirmwareVersion", Byte0=1)]


def set_limits(
    codec: Codec,
    joint: int,
    *,
    max_angle_deg: float | None,
    min_angle_deg: float | None,
    max_speed: float | None,
) -> list[Frame]:
    """Sets a joint's angle and speed limits (0x474).

    Args:
        codec: The arm's codec.
        joint: 1–6.
        max_angle_deg: None leaves it unchanged (generation 2).
        min_angle_deg: None leaves it unchanged (generation 2).
        max_speed: In rad/s (generation 2) or rpm (generation 1): `codec.unit("LimitSetting", "MaxSpeed")`.
            None leaves it unchanged (generation 2).
    """
    return [
        codec.encode(
            "LimitSetting",
            Joint=joint,
            MaxAngle=max_angle_deg,
            MinAngle=min_angle_deg,
            MaxSpeed=max_speed,
        )
    ]


def set_joint_acceleration(codec: Codec, joint: int, max_acceleration: float | None) -> list[Frame]:
    """Sets the acceleration limit of a joint, or of all with 7 (0x475).

    Args:
        codec: The arm's codec.
        joint: 1–7.
        max_acceleration: In rad/s² (generation 2) or rpm/s (generation 1):
            `codec.unit("JointSetting", "MaxAcceleration")`. None leaves it unchanged (generation 2).
    """
    return [
        codec.encode(
            "JointSetting", Joint=joint, AccelerationValid=VALID, MaxAcceleration=max_acceleration
        )
    ]


def set_joint_zero(codec: Codec, joint: int) -> list[Frame]:
    """Makes the present position of a joint, or of all with 7, its zero (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, SetZero=VALID)]


def clear_joint_error(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Clears the error of a joint, or of all with 7 (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, ClearError=VALID)]


def set_end_limits(
    codec: Codec,
    *,
    max_linear_speed_m_s: float | None,
    max_angular_speed_rad_s: float | None,
    max_linear_acceleration_m_s2: float | None,
    max_angular_acceleration_rad_s2: float | None,
) -> list[Frame]:
    """Sets the end's speed and acceleration limits; None leaves one unchanged in generation 2 (0x479)."""
    return [
        codec.encode(
            "EndLimitSetting",
            MaxLinearSpeed=max_linear_speed_m_s,
            MaxAngularSpeed=max_angular_speed_rad_s,
            MaxLinearAcceleration=max_linear_acceleration_m_s2,
            MaxAngularAcceleration=max_angular_acceleration_rad_s2,
        )
    ]


def reset_end_limits(codec: Codec) -> list[Frame]:
    """Restores the factory values of the end's limits (0x477)."""
    return [codec.encode("ParameterCommand", Reset=FactoryReset.END_LIMITS_TO_FACTORY)]


def reset_joint_limits(codec: Codec) -> list[Frame]:
    """Restores the factory limits, speeds and accelerations of the joints (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Reset=FactoryReset.JOINT_LIMITS_TO_FACTORY)]


def set_end_feedback(codec: Codec, *, on: bool) -> list[Frame]:
    """Switches the feedback 0x481–0x486 on or off (0x477); the code differs between the generations."""
    word = "On" if on else "Off"
    code = codec.code("ParameterCommand", "EndFeedback", word)
    return [codec.encode("ParameterCommand", EndFeedback=code)]


def set_load(codec: Codec, load: EndLoad) -> list[Frame]:
    """Tells the arm what it carries: nothing, half or the full payload (0x477)."""
    return [codec.encode("ParameterCommand", LoadValid=VALID, Load=load)]


def set_collision_levels(codec: Codec, levels: Sequence[int]) -> list[Frame]:
    """Sets the collision protection level of each joint, 0 (none) to 8 (0x47A)."""
    values = _counted("CollisionSetting", levels, 6, "levels", "")
    return [codec.encode("CollisionSetting", **{f"J{j}": v for j, v in enumerate(values, 1)})]


def set_teaching(
    codec: Codec, *, teaching_range_percent: float, stroke_limit_mm: int, friction: int
) -> list[Frame]:
    """Sets the teaching handle (0x47D, generation 2).

    Args:
        codec: The arm's codec.
        teaching_range_percent: 100–200.
        stroke_limit_mm: 0, 70 or 100.
        friction: 1–10.
    """
    return [
        codec.encode(
            "TeachingSetting",
            TeachingRange=teaching_range_percent,
            StrokeLimit=stroke_limit_mm,
            Friction=friction,
        )
    ]


def set_linkage(
    codec: Codec,
    role: LinkageRole,
    *,
    feedback_offset: int = 0,
    control_offset: int = 0,
    target_offset: int = 0,
) -> list[Frame]:
    """Makes the arm a teaching input or a motion output, with identifier offsets 0, 0x10, 0x20 (0x470)."""
    return [
        codec.encode(
            "LinkageSetting",
            Role=role,
            FeedbackOffset=feedback_offset,
            ControlOffset=control_offset,
            TargetOffset=target_offset,
        )
    ]


def set_bus_silence(codec: Codec, mode: SilenceMode) -> list[Frame]:
    """Silences the bus for a firmware upgrade, or ends the silence (0x422)."""
    return [codec.encode("BusSilence", Mode=mode)]


def set_light(
    codec: Codec,
    joint: int,
    rgb: Sequence[int],
    *,
    lamp: int = ALL_LAMPS,
    counter: int = 0,
    enable: bool = True,
) -> list[Frame]:
    """Colours the lamps of a joint (0x121).

    Args:
        codec: The arm's codec.
        joint: 1–6.
        rgb: Red, green, blue, 0–255 each.
        lamp: 0–254, or 255 for all.
        counter: Counts the frames, 0–255.
        enable: False sends a frame that the arm ignores.
    """
    red, green, blue = _counted("LightControl", rgb, 3, "colour values", "")
    return [
        codec.encode(
            "LightControl",
            Enable=int(enable),
            Joint=joint,
            Lamp=lamp,
            Red=red,
            Green=green,
            Blue=blue,
            Counter=counter,
        )
    ]


def _can_control(codec: Codec, move_mode: MoveMode, speed_percent: float) -> list[Frame]:
    return set_mode(
        codec,
        control_mode=ControlMode.CAN_CONTROL,
        move_mode=move_mode,
        speed_percent=speed_percent,
    )


def _counted(
    message: str, values: Sequence[float], count: int, what: str, unit: str
) -> tuple[float, ...]:
    if len(values) != count:
        text = f"{message} wants {count} {what}, not {len(values)}"
        raise EncodeError(text, message=message, value=list(values), unit=unit)
    return tuple(values)
