"""The model of an arm as heard, with a tool on its flange, for planning."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.models import ArmModel, model_data
from armui.arm.tool_capsule import ToolCapsule
from armui.kinematics.arm_kinematics import Kinematics

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.arm.state import ArmState
    from armui.control.operating_state import OperatingState


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
