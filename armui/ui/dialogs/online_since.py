"""Remembers the time at which the arm came online, for the window «About this arm»."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class OnlineSince(QObject):
    """Remembers the time at which the arm came online.

    The protocol does not report for how long an arm has been switched on; this is the nearest to
    it.

    Args:
        controller: Gives the arm's state.
        parent: The object with which it ends.
    """

    def __init__(self, controller: ArmController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._since_s: float | None = None
        self._controller = controller
        controller.operating_state_changed.connect(self._on_state_changed)
        self._on_state_changed(controller.operating_state)

    def seconds(self) -> float | None:
        """Return for how long the arm has been online, or ``None`` if it is offline."""
        now_s = self._controller.state.last_feedback_s
        if self._since_s is None or now_s is None:
            return None
        return max(0.0, now_s - self._since_s)

    def _on_state_changed(self, now: OperatingState) -> None:
        if now.link is not LinkState.ONLINE:
            self._since_s = None
        elif self._since_s is None:
            self._since_s = self._controller.state.last_feedback_s
