"""Has the picture show where the tool has been."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.models import model_data
from armui.ui.freshness import is_stale
from armui.viewport.look_alike import look_alike
from armui.viewport.robot_shape import moved
from armui.viewport.tool_trail import ToolTrail

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.viewport.camera import Vector
    from armui.viewport.view import ArmView

_MM: Final = 1000.0
_BETWEEN_S: Final = 0.1
"""A trail that grows is handed over this often: it is copied and drawn as a whole."""


class TrailKeeper:
    """Follows the arm while the picture is seen; what went by hidden is not made up.

    The place is the one whose path is planned: the tool centre point, or the tip of the gripper
    where no tool is set.

    Args:
        controller: Knows the arm and what was sent to it.
        view: Shows the trail.
        length_s: How many seconds of motion are shown.
    """

    def __init__(self, controller: ArmController, view: ArmView, length_s: float) -> None:
        self._controller = controller
        self._view = view
        self._trail = ToolTrail(length_s)
        self._device = controller.operating_state.device
        self._seen: tuple[tuple[float, ...] | None, tuple[float, ...] | None] = (None, None)
        self._is_new = False
        self._handed_over_s = 0.0

    def set_length(self, length_s: float) -> None:
        """Show so many seconds of motion; 0: nothing."""
        self._trail.set_length(length_s)
        if length_s <= 0:
            self._trail.clear()
        self._view.set_trail(self._trail.trail)

    def clear(self) -> None:
        """Begin anew: the tool is another one."""
        self._trail.clear()
        self._view.set_trail(None)

    def follow(self, state: ArmState) -> None:
        """Take the newest state."""
        operating_state = self._controller.operating_state
        if operating_state.device != self._device:
            self._device = operating_state.device
            self.clear()
        angles_deg = state.angles_deg()
        if self._trail.length_s <= 0 or angles_deg is None or not self._view.isVisible():
            return
        if any(is_stale(heard, state, operating_state) for heard in state.joints_deg):
            return
        now_s = state.last_feedback_s or 0.0
        if self._is_new and not 0.0 <= now_s - self._handed_over_s < _BETWEEN_S:
            self._is_new, self._handed_over_s = False, now_s
            self._view.set_trail(self._trail.trail)
        setpoint_deg = self._controller.motion.setpoint_deg
        if look_alike(tuple(angles_deg), self._seen[0]) and setpoint_deg == self._seen[1]:
            return
        self._seen = (tuple(angles_deg), setpoint_deg)
        driven_mm = self._tool_mm(angles_deg)
        if driven_mm is None:
            return
        commanded_mm = None if setpoint_deg is None else self._tool_mm(setpoint_deg)
        self._is_new |= self._trail.add(now_s, driven_mm, commanded_mm)

    def _tool_mm(self, angles_deg: Sequence[float]) -> Vector | None:
        """Where the picture has the tool at six angles."""
        shape = self._view.shape
        if shape is None:
            return None
        x, y, z = self._controller.cartesian.tool[:3]
        model = self._controller.operating_state.model
        reach_mm = model_data(model).tool_mm(z)
        rows = shape.flange(shape.links(angles_deg))
        place = moved(rows, (x / _MM, y / _MM, reach_mm / _MM))
        return (place[0] * _MM, place[1] * _MM, place[2] * _MM)
