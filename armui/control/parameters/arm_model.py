"""The arm for planning: the values it has reported, the factory's where it has not."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.limits import FACTORY_ACCELERATION_DEG_S2
from armui.arm.model import ArmModel

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

GRIPPER_REACH_MM: Final = 140.0
"""How far the maker's gripper reaches beyond the flange, where no tool centre point is set."""

HOME_DEG: Final = (0.0,) * 6


def arm_model(controller: ArmController) -> ArmModel:
    """What is known of the arm that is connected, or of one as it leaves the factory."""
    state = controller.state
    handle = state.teaching_handle
    tool_z_mm = controller.cartesian.tool[2]
    return ArmModel(
        limits=controller.operating_state.limits,
        accelerations_deg_s2=tuple(
            FACTORY_ACCELERATION_DEG_S2 if heard is None else heard.value
            for heard in state.accelerations_deg_s2
        ),
        end_limits=None if state.end_limits is None else state.end_limits.value,
        kinematics=controller.cartesian.kinematics(),
        tool_mm=tool_z_mm if tool_z_mm > 0.0 else GRIPPER_REACH_MM,
        stroke_mm=(handle.value.stroke_limit_mm or None) if handle is not None else None,
    )


def start_deg(controller: ArmController) -> tuple[float, ...]:
    """Where a run would begin: the measured angles, the home position while there are none."""
    return tuple(controller.state.angles_deg() or HOME_DEG)
