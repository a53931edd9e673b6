"""Where the joints must go for a handle to be where it was dragged to, or why they can't."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.limits import ANGLE_STEP_DEG, check_joints
from armui.arm.refusal import Refusal
from armui.viewport.grips import GripKind, snapped
from armui.viewport.handles import HandleKind

if TYPE_CHECKING:
    from armui.arm.limits import JointLimits
    from armui.kinematics.arm_kinematics import Kinematics
    from armui.viewport.handles import Dragged

COARSE: Final = {GripKind.AXIS: 10.0, GripKind.RING: 15.0, GripKind.JOINT: 5.0}
"""Steps with Ctrl held: mm along an axis, degrees about one."""
FINE: Final = {GripKind.AXIS: 1.0, GripKind.RING: 1.0, GripKind.JOINT: 1.0}
"""Steps with Shift held."""


@dataclass(frozen=True)
class DragBase:
    """What a drag begins with.

    Attributes:
        angles_deg: Of the arm, or of its ghost.
        kind: Which handles.
        tool: The tool centre point in the flange, mm and degrees.
        kinematics: Of the arm.
        limits: Of its joints.
    """

    angles_deg: tuple[float, ...]
    kind: HandleKind
    tool: tuple[float, ...]
    kinematics: Kinematics
    limits: Sequence[JointLimits]


def dragged_to(
    base: DragBase,
    dragged: Dragged,
    near_deg: Sequence[float],
    *,
    coarse: bool = False,
    fine: bool = False,
) -> tuple[float, ...] | Refusal:
    """The six angles with the handle where it was carried.

    Args:
        base: At the beginning of the drag.
        dragged: The handle, and how far.
        near_deg: The angles before: of several ways the nearest is taken.
        coarse: Only in the steps of `COARSE`: to whole coordinates of the base and whole angles of
            a joint, of the tool's own axes to whole steps from where it was.
        fine: Likewise, in those of `FINE`.

    Returns:
        The angles as they can be sent, or why the arm can't stand there.
    """
    grip = dragged.grip
    steps = COARSE if coarse else FINE if fine else {}
    amount = dragged.amount
    if grip.kind is GripKind.JOINT:
        angles = list(base.angles_deg)
        angle_deg = angles[grip.number - 1] + amount
        if grip.kind in steps:
            angle_deg = snapped(angle_deg, steps[grip.kind])
        angles[grip.number - 1] = _rounded(angle_deg)
        return check_joints(angles, base.limits) or tuple(angles)

    from armui.arm.reach import check_pose  # noqa: PLC0415 - numpy, loaded when needed
    from armui.kinematics import poses  # noqa: PLC0415 - as above
    from armui.kinematics.poses import JogFrame  # noqa: PLC0415 - as above

    tool_point = poses.tool_matrix(base.kinematics.matrix(base.angles_deg), base.tool)
    own = base.kind is HandleKind.TOOL_FRAME
    if grip.kind in steps:
        begun_at = 0.0
        if grip.kind is GripKind.AXIS and not own:
            begun_at = float(tool_point[grip.number, 3])
        amount = snapped(begun_at + amount, steps[grip.kind]) - begun_at
    place = grip.number + (3 if grip.kind is GripKind.RING else 0)
    frame = JogFrame.TOOL if own else JogFrame.BASE
    target = poses.shifted(tool_point, place, amount, frame)
    flange = poses.matrix_to_pose(poses.flange_matrix(target, base.tool))
    answer = check_pose(base.kinematics, flange, near_deg, base.limits)
    return answer if isinstance(answer, Refusal) else tuple(map(_rounded, answer))


def _rounded(angle_deg: float) -> float:
    """As an angle is sent."""
    return round(angle_deg / ANGLE_STEP_DEG) * ANGLE_STEP_DEG
