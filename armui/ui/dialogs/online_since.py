"""Since when the arm has been heard without a break."""

from __future__ import annotations

from PySide6.QtCore import QObject

from armui.control.arm_controller import ArmController
from armui.control.operating_state import LinkState, OperatingState


class OnlineSince(QObject):
    """Remembers when the arm came online.

    The protocol does not tell for how long an arm has been switched on; this is what is known.

    Args:
        controller: Tells whether the arm is online.
        parent: Whom it ends with.
    """

    def __init__(self, controller: ArmController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._since_s: float | None = None
        self._controller = controller
        controller.operating_state_changed.connect(self._on_state_changed)
        self._on_state_changed(controller.operating_state)

    def seconds(self) -> float | None:
        """For so long it has been online, by its feedback; ``None``: it is not."""
        now_s = self._controller.state.last_feedback_s
        if self._since_s is None or now_s is None:
            return None
        return max(0.0, now_s - self._since_s)

    def _on_state_changed(self, now: OperatingState) -> None:
        if now.link is not LinkState.ONLINE:
            self._since_s = None
        elif self._since_s is None:
            self._since_s = self._controller.state.last_feedback_s
