"""The row above panels and pages: the next step, and the present run in its place or beside it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QBoxLayout, QSizePolicy, QWidget

from armui.ui.widgets.layouts import in_row

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.ui.shell.recovery_line import RecoveryLine
    from armui.ui.trajectory.running.run_strip import RunStrip


class StepRow(QWidget):
    """Shows the next step and the run in one row of fixed height, so that nothing below it moves.

    A run replaces a step that says no more than the run. Otherwise both are shown: the step at the
    left of a run's buttons, which keep their place, or at the right of the text of a run that is
    over.

    Args:
        controller: Gives the state of runs.
        recovery: Shows the next step.
    """

    def __init__(self, controller: ArmController, recovery: RecoveryLine) -> None:
        super().__init__()
        self._controller = controller
        self._recovery = recovery
        self._strip: RunStrip | None = None
        self._row = in_row((recovery, 1), on=self, spacing=0, margins=0)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        recovery.step_shown.connect(self._arrange)
        controller.operating_state_changed.connect(self._on_operating_state)

    @property
    def strip(self) -> RunStrip | None:
        """The strip of a run; ``None`` before the first run."""
        return self._strip

    @property
    def go_on_button(self) -> QWidget | None:
        """The visible button that continues a paused or waiting run, or ``None``."""
        return None if self._strip is None else self._strip.go_on_button

    def _on_operating_state(self, operating_state: OperatingState) -> None:
        if not operating_state.running or self._strip is not None:
            return
        from armui.ui.trajectory.running.run_strip import RunStrip  # noqa: PLC0415 - numpy

        self._strip = RunStrip(self._controller)
        self._row.addWidget(self._strip)
        self._strip.turned.connect(self._arrange)
        self._strip.show()

    def _arrange(self) -> None:
        strip = self._strip
        beside = self._recovery.says_more_than_a_run
        with_run = strip is not None and not strip.isHidden()
        self._recovery.setHidden(with_run and not beside)
        if strip is not None:
            strip.stand_beside(beside)
            way = QBoxLayout.Direction
            self._row.setDirection(way.RightToLeft if strip.stands_first else way.LeftToRight)
            self._row.setStretchFactor(strip, 0 if beside else 1)

    def sizeHint(self) -> QSize:
        """Return the size of the line of the next step."""
        return self._recovery.sizeHint()

    def minimumSizeHint(self) -> QSize:
        """Return the same height without a minimal width."""
        return self._recovery.minimumSizeHint()
