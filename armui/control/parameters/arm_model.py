"""The arm's model for planning: its reported values, and the factory's for unread ones."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from armui.arm.models import ArmModel, model_data
from armui.arm.tool_capsule import ToolCapsule
from armui.kinematics.arm_kinematics import Kinematics
from armui.trajectory.planning.user_frames import frames_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState

HOME_DEG: Final = (0.0,) * 6


def arm_model(controller: ArmController) -> ArmModel:
    """Return the model of the connected arm, or of an arm as it leaves the factory."""
    now, cartesian = controller.operating_state, controller.cartesian
    arm = planning_model(controller.state, now, cartesian.tool, cartesian.tool_radius_mm)
    frames = tuple(frames_of(controller.cell.cell).items())
    arm = replace(
        arm, held=controller.cell.held_shape, frames=frames, rising=controller.cell.rising
    )
    if arm.stroke_mm is None or not controller.gripper.is_calibrated:
        return arm
    return replace(arm, widest_mm=controller.gripper.calibrated_mm(arm.stroke_mm))


def planning_model(
    state: ArmState,
    now: OperatingState,
    tool: Sequence[float] = (0.0, 0.0, 0.0),
    tool_radius_mm: float = 0.0,
) -> ArmModel:
    """Return the model of an arm as heard, with a tool on its flange.

    Args:
        state: The arm's state.
        now: The operating state.
        tool: The tool centre point in the flange; its first three figures count, in mm.
        tool_radius_mm: The radius of the capsule that stands for the tool.
    """
    handle, data = state.teaching_handle, model_data(now.model)
    return ArmModel(
        limits=now.limits,
        accelerations_deg_s2=tuple(
            factory if heard is None else heard.value
            for heard, factory in zip(
                state.accelerations_deg_s2, data.accelerations_deg_s2, strict=True
            )
        ),
        end_limits=None if state.end_limits is None else state.end_limits.value,
        kinematics=Kinematics(now.model_fit.geometry),
        tool_mm=data.tool_mm(tool[2]),
        tool=tool_capsule(tool, tool_radius_mm),
        gripper_turned_deg=data.gripper.turned_deg,
        kind=now.model_fit.kind,
        stroke_mm=(handle.value.stroke_limit_mm or None) if handle is not None else None,
    )


def tool_capsule(tool: Sequence[float], radius_mm: float) -> ToolCapsule | None:
    """Return the shape of a tool, or ``None`` if its tip is the flange's centre."""
    x, y, z = tool[:3]
    return ToolCapsule((x, y, z), radius_mm) if any((x, y, z)) else None


def start_deg(controller: ArmController) -> tuple[float, ...]:
    """Return the six angles at which a run would begin: as measured, or home if unknown.

    An arm that lies outside its limits is brought inside first.
    """
    ways = controller.gate.ways_inside()
    return ways[-1] if ways else tuple(controller.state.angles_deg() or HOME_DEG)
