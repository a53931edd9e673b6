"""Encodes points of a trajectory as frames, in the arm's protocol generation."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS_OUTSIDE, outside_limits, outside_list
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.kinematics.poses import Pose, pose_to_matrix
from armui.protocol import commands
from armui.protocol.codes import ControlMode, MoveMode
from armui.protocol.generation import Generation
from armui.trajectory.points.program import GripperAngle, GripperOpening, Waypoint

if TYPE_CHECKING:
    from armui.arm.models import ArmModel
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame
    from armui.ways.way import Way

ARC_IS_NONE = Reason(
    "arc_is_none",
    "The three poses lie on a line, or two in one place: that is no arc. Capture others.",
)
ARC_START_UNKNOWN = Reason(
    "arc_start_unknown",
    "The arm has not reported its end pose: an arc has no beginning. Wait for it.",
)
GRIPPER_OTHER_GENERATION = Reason(
    "gripper_other_generation",
    "Row {row}: this arm's protocol moves the gripper by other values (generation 1 by an "
    "angle, generation 2 by an opening). Change the gripper's action.",
)


POINT_NOT_IN_BASE = Reason(
    "point_not_in_base",
    "Row {row} is in the user frame “{name}”, whose place was not worked out. Send it again.",
)


_POSE_MODES: Final = frozenset({MoveMode.MOVE_P, MoveMode.MOVE_L, MoveMode.MOVE_C})


def point_frames(
    codec: Codec, point: Waypoint, state: ArmState, speed_percent: int
) -> list[Frame] | Refusal:
    """Return the frames that send the arm to a point, or why there are none.

    An arc begins at the pose that the arm reports.
    """
    if point.is_joint:
        return commands.move_joints(codec, point.target, speed_percent=speed_percent)
    mode = leading_mode(codec, state, point.move, speed_percent)
    if point.middle is None:
        return mode + commands.move_pose(
            codec, point.target, speed_percent=speed_percent, move_mode=point.move
        )
    start = state.end_pose()
    if start is None:
        return ARC_START_UNKNOWN()
    return mode + commands.move_arc(
        codec, start, point.middle, point.target, speed_percent=speed_percent
    )


def point_way(point: Waypoint, arm: ArmModel, begin_deg: Sequence[float]) -> Way | Refusal:
    """Return the way to a point from where the joints rest, or why there is none.

    Args:
        point: The point; its poses are of the flange.
        arm: The arm.
        begin_deg: The six angles.
    """
    from armui.arm.reach import check_pose, led_joints  # noqa: PLC0415 - scipy
    from armui.kinematics.tool_path import Arc, ArcError, Line, ToolPath  # noqa: PLC0415 - scipy
    from armui.ways.way import Way, joint_way  # noqa: PLC0415 - numpy

    if point.is_joint:
        return joint_way(begin_deg, point.target)
    if point.move is MoveMode.MOVE_P:
        end_deg = check_pose(arm.kinematics, Pose(*point.target), begin_deg, arm.limits)
        return end_deg if isinstance(end_deg, Refusal) else joint_way(begin_deg, end_deg)
    if outside_limits(begin_deg, arm.limits):
        # the arm takes no line that begins outside
        return JOINTS_OUTSIDE(joints=outside_list(begin_deg, arm.limits))
    here, target = arm.kinematics.matrix(begin_deg), pose_to_matrix(point.target)
    path: ToolPath = Line(here, target)
    if point.middle is not None:
        try:
            path = Arc(here, pose_to_matrix(point.middle), target)
        except ArcError:
            return ARC_IS_NONE()
    joints_deg = led_joints(arm.kinematics, path, begin_deg)
    if not isinstance(joints_deg, Refusal):
        return Way(joints_deg)
    # A target out of reach is reported as such, and not as a problem on the way to it.
    end_deg = check_pose(arm.kinematics, Pose(*point.target), begin_deg, arm.limits)
    return end_deg if isinstance(end_deg, Refusal) else joints_deg


def tool_way(point: Waypoint, state: ArmState) -> tuple[Sequence[float], ...]:
    """Return the poses of the flange in a line's or an arc's command; none for other motions."""
    if point.move is MoveMode.MOVE_L:
        return (point.target,)
    start = state.end_pose()
    if point.middle is None or start is None:
        return ()
    return start, point.middle, point.target


def leading_mode(
    codec: Codec, state: ArmState, move_mode: MoveMode, speed_percent: int
) -> list[Frame]:
    """Return 0x151 to precede a pose that the arm would take for a target of another kind.

    An arm in MOVE L that hears a pose sets out in a line before it hears of MOVE P or C. From MOVE
    J nothing goes ahead: there the arm only keeps a pose, and a mode without a new pose might send
    it to an old one.
    """
    mode = None if state.status is None else state.status.value.move_mode
    if mode == move_mode or mode not in _POSE_MODES:
        return []
    return commands.set_mode(
        codec,
        control_mode=ControlMode.CAN_CONTROL,
        move_mode=move_mode,
        speed_percent=speed_percent,
    )


def action_frames(codec: Codec, point: Waypoint) -> list[Frame]:
    """Return the frames for a point's action on arrival."""
    frames: list[Frame] = []
    gripper, light = point.gripper, point.light
    if isinstance(gripper, GripperOpening):
        frames += commands.move_gripper_opening(
            codec, opening_mm=gripper.opening_mm, torque_nm=gripper.torque_nm
        )
    elif isinstance(gripper, GripperAngle):
        frames += commands.move_gripper_angle(
            codec, angle_deg=gripper.angle_deg, speed_rad_s=gripper.speed_rad_s
        )
    if light is not None:
        rgb = (light.red, light.green, light.blue)
        frames += commands.set_light(codec, light.joint, rgb, lamp=light.lamp)
    return frames


def why_not_possible(generation: Generation | None, points: Sequence[Waypoint]) -> Refusal | None:
    """Return why a point cannot be sent, or ``None``: its gripper's action, or its user frame."""
    for row, point in enumerate(points, start=1):
        if point.frame:
            return POINT_NOT_IN_BASE(row=row, name=point.frame)
        angle = isinstance(point.gripper, GripperAngle)
        opening = isinstance(point.gripper, GripperOpening)
        if (generation is Generation.TWO and angle) or (generation is Generation.ONE and opening):
            return GRIPPER_OTHER_GENERATION(row=row)
    return None
