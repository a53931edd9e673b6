"""The commands of a host to the arm, one function for each.

Each takes the codec first and physical units after it (degrees and millimetres; any other unit is
in the name), and returns the frames in sending order. All raise `EncodeError` for a value the
protocol cannot carry and for a command the generation does not have; they do not check whether the
arm can do it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from armui.protocol.codes import (
    ALL_JOINTS,
    ALL_LAMPS,
    VALID,
    ArcPointNumber,
    ControlMode,
    EndLoad,
    FactoryReset,
    GripperMeasure,
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
from armui.protocol.frame import EncodeError, Frame

if TYPE_CHECKING:
    from collections.abc import Mapping

    from armui.protocol.codec import Codec

_JOINTS = tuple(f"J{joint}" for joint in range(1, 7))


def _exactly(
    message: str, values: Sequence[float], count: int, what: str, unit: str
) -> tuple[float, ...]:
    """Return the values if there are as many as the message needs.

    Raises:
        EncodeError: There are more or fewer.
    """
    if len(values) != count:
        text = f"{message} wants {count} {what}, not {len(values)}"
        raise EncodeError(text, message=message, value=list(values), unit=unit)
    return tuple(values)


# Motion: 0x150–0x159 and 0x471 -------------------------------------------------------------


def emergency_stop(codec: Codec) -> list[Frame]:
    """Stops the arm: all motors only brake, and it sinks slowly (0x150)."""
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
    """Sets control mode, kind of motion and speed (0x151).

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
    """Sends target angles of joints 1–6 in degrees, without starting the motion (0x155–0x157)."""
    j1, j2, j3, j4, j5, j6 = _exactly("JointTarget12", joints_deg, 6, "joint angles", "deg")
    return [
        codec.encode("JointTarget12", J1=j1, J2=j2),
        codec.encode("JointTarget34", J3=j3, J4=j4),
        codec.encode("JointTarget56", J5=j5, J6=j6),
    ]


def cartesian_target(codec: Codec, pose: Sequence[float]) -> list[Frame]:
    """Sends a target of the flange, without starting the motion (0x152–0x154).

    Args:
        codec: The arm's codec.
        pose: X, Y, Z in mm and RX, RY, RZ in degrees.
    """
    x, y, z, rx, ry, rz = _exactly("CartesianTarget1", pose, 6, "pose values", "mm and deg")
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


# What the arm remembers: 0x121, 0x422, 0x470, 0x474–0x47D -----------------------------------


def set_parameters(
    codec: Codec, message: str, values: Mapping[str, float | None], joint: int = ALL_JOINTS
) -> list[Frame]:
    """Sets values in the arm's memory by one frame (0x474, 0x475, 0x479, 0x47A, 0x47D, 0x487).

    Args:
        codec: The arm's codec.
        message: ``LimitSetting``, ``JointSetting``, ``EndLimitSetting``, ``CollisionSetting``,
            ``TeachingSetting`` or ``DragAssistanceSetting``.
        values: The values by signal, in the unit ``codec.unit(message, signal)``: generation 1
            takes rpm where generation 2 takes rad/s. None leaves a value unchanged (generation 2).
        joint: 1–6 if the message is about one joint; 7 means all in ``JointSetting``.
    """
    signals = dict(values)
    if "Joint" in codec.signals(message):
        signals["Joint"] = joint
    if message == "JointSetting":
        signals["AccelerationValid"] = VALID
    return [codec.encode(message, **signals)]


def set_joint_zero(codec: Codec, joint: int) -> list[Frame]:
    """Makes the present position of a joint, or of all with 7, its zero (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, SetZero=VALID)]


def clear_joint_error(codec: Codec, joint: int = ALL_JOINTS) -> list[Frame]:
    """Clears the error of a joint, or of all with 7 (0x475)."""
    return [codec.encode("JointSetting", Joint=joint, ClearError=VALID)]


def reset_end_limits(codec: Codec) -> list[Frame]:
    """Restores the factory values of the end's limits (0x477)."""
    return [codec.encode("ParameterCommand", Reset=FactoryReset.END_LIMITS_TO_FACTORY)]


def reset_joint_limits(codec: Codec) -> list[Frame]:
    """Restores the factory limits, speeds and accelerations of the joints (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Reset=FactoryReset.JOINT_LIMITS_TO_FACTORY)]


def set_end_feedback(codec: Codec, *, on: bool) -> list[Frame]:
    """Switches the feedback 0x481–0x486 (0x477); the code differs between the generations."""
    word = "On" if on else "Off"
    code = codec.code("ParameterCommand", "EndFeedback", word)
    return [codec.encode("ParameterCommand", EndFeedback=code)]


def set_load(codec: Codec, load: EndLoad) -> list[Frame]:
    """Sets the load of the arm: none, half or the full payload (0x477)."""
    return [codec.encode("ParameterCommand", LoadValid=VALID, Load=load)]


def set_linkage(
    codec: Codec,
    role: LinkageRole,
    *,
    feedback_offset: int = 0,
    control_offset: int = 0,
    target_offset: int = 0,
) -> list[Frame]:
    """Makes the arm a teaching input or a motion output (0x470); offsets are 0, 0x10 or 0x20."""
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
    red, green, blue = _exactly("LightControl", rgb, 3, "colour values", "")
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


# Questions: 0x472, 0x477 and 0x4AF ----------------------------------------------------------


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


def query_teaching(codec: Codec) -> list[Frame]:
    """Asks for the teaching setting; answered by TeachingFeedback (0x477, generation 2)."""
    return [codec.encode("ParameterCommand", Query=ParameterQuery.TEACHING_SETTING)]


def query_drag_assistance(codec: Codec) -> list[Frame]:
    """Asks for the drag assistance levels; answered by DragAssistanceFeedback (0x477).

    Only firmware from S-V1.8-1 on answers.
    """
    return [codec.encode("ParameterCommand", Query=ParameterQuery.DRAG_ASSISTANCE)]


def query_firmware(codec: Codec) -> list[Frame]:
    """Asks for the firmware version (0x4AF, generation 2).

    Generation 1 stays silent, which is how a host tells the two apart: ask with a codec of
    generation 2.
    """
    return [codec.encode("FirmwareVersion", Byte0=1)]
