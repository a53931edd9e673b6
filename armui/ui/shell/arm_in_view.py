"""What the arm says of its place, into the 3D picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.control.operating_state import LinkState
from armui.ui.freshness import is_stale

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.operating_state import OperatingState
    from armui.viewport.view import ArmView


def show_in_view(view: ArmView, state: ArmState, operating_state: OperatingState) -> None:
    """Show angles and pose; what is no longer fresh looks so."""
    joints_stale, pose_stale = (
        any(is_stale(heard, state, operating_state) for heard in six)
        for six in (state.joints_deg, state.pose)
    )
    angles_deg = state.angles_deg()
    if angles_deg is None and operating_state.link is LinkState.LOST:
        view.forget_joints()  # the cable is out, and the arm has not gone to its zeros
    else:
        gripper_mm = None if state.gripper is None else state.gripper.value.opening_mm
        view.set_joints(angles_deg, gripper_mm, stale=joints_stale)
    too_low = operating_state.below_base_mm is not None
    view.set_pose(state.end_pose(), stale=pose_stale, too_low=too_low)
