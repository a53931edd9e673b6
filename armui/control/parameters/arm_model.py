"""The arm's model for planning: its reported values, and the factory's for unread ones."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from armui.arm.models import ArmModel
from armui.control.parameters.planning_model import planning_model
from armui.trajectory.planning.user_frames import frames_of

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

HOME_DEG: Final = (0.0,) * 6


def arm_model(controller: ArmController) -> ArmModel:
    """Return the model of the connected arm, or of an arm as it leaves the factory."""
    now, cartesian = controller.operating_state, controller.cartesian
    arm = planning_model(controller.state, now, cartesian.tool, cartesian.tool_radius_mm)
    frames = tuple(frames_of(controller.cell.cell).items())
    arm = replace(
        arm,
        held=controller.cell.held_shape,
        frames=frames,
        rising=controller.cell.rising,
        around=_around(controller),
    )
    if arm.stroke_mm is None or not controller.gripper.is_calibrated:
        return arm
    return replace(arm, widest_mm=controller.gripper.calibrated_mm(arm.stroke_mm))


def _around(controller: ArmController) -> str:
    area, lowest_mm = controller.area_guard.area, controller.jog_floor.lowest_mm
    zones = "" if area is None else repr((area.in_force.zones, area.margin_mm))
    return zones if lowest_mm is None else f"{zones}{lowest_mm}"


def start_deg(controller: ArmController) -> tuple[float, ...]:
    """Return the six angles at which a run would begin: as measured, or home if unknown.

    An arm that lies outside its limits is brought inside first.
    """
    ways = controller.gate.ways_inside()
    return ways[-1] if ways else tuple(controller.state.angles_deg() or HOME_DEG)
