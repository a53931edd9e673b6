"""Where the run under way is told in the main window; loaded with the first run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from armui.ui.widgets.layouts import in_column

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.ui.trajectory.running.run_strip import RunStrip


class RunPlace(QWidget):
    """Takes no room before something has run.

    Args:
        controller: Knows whether something runs.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._strip: RunStrip | None = None
        self._column = in_column(on=self, spacing=0, margins=0)
        controller.operating_state_changed.connect(self._on_operating_state)

    @property
    def go_on_button(self) -> QWidget | None:
        """The button that goes on with a run that pauses or waits, while it is seen."""
        return None if self._strip is None else self._strip.go_on_button

    def _on_operating_state(self, operating_state: OperatingState) -> None:
        if not operating_state.running or self._strip is not None:
            return
        from armui.ui.trajectory.running.run_strip import RunStrip  # noqa: PLC0415 - faster start

        self._strip = RunStrip(self._controller)
        self._column.addWidget(self._strip)
        self._strip.show()
