"""The end of drag teaching, one step at a time: lead to rest, stop, resume, enable."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QLabel

from armui.control.devices.teaching_phase import TeachingPhase
from armui.control.safety.recovery_steps import UNHINDERED, Step, StepKind
from armui.ui.widgets.layouts import empty_grid

_STEPS: Final = 4
_SIGN_PX: Final = 14
_NUMBER: Final[Mapping[StepKind, int]] = {
    StepKind.RECORDING: 1,
    StepKind.REPLAYING: 1,
    StepKind.REPLAY_PAUSED: 1,
    StepKind.DRAG_MODE_WITHOUT_POWER: 1,
    StepKind.OVERSPEED: 1,
    StepKind.DRAG_MODE: 1,
    StepKind.DRAG_MODE_AT_REST: 2,
    StepKind.STOP_REQUESTED: 2,
    StepKind.STOPPED: 3,
    StepKind.MOTORS_OFF: 4,
    StepKind.MOTORS_MIXED: 4,
}
"""Which of the four steps is due. The steps are taken in the line above the panels, where the arm's
own word leads from one to the next."""

_OVER: Final = UNHINDERED | {StepKind.NO_DEVICE, StepKind.OPENING}


class TeachingExitSteps(QFrame):
    """Four lines, the one that is due marked; hidden when there is nothing to leave."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("teaching_exit_steps")
        self._leaving = False
        self._due = 0
        self._title = QLabel()
        self._title.setWordWrap(True)
        self._signs = [QLabel() for _ in range(_STEPS)]
        self._lines = [QLabel() for _ in range(_STEPS)]
        grid = empty_grid(self, gaps=(6, 4), margins=0)
        grid.addWidget(self._title, 0, 0, 1, 2)
        for row, (sign, line) in enumerate(zip(self._signs, self._lines, strict=True), start=1):
            sign.setFixedWidth(_SIGN_PX)
            line.setWordWrap(True)
            grid.addWidget(sign, row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(line, row, 1)
        grid.setColumnStretch(1, 1)
        self.hide()

    @property
    def due(self) -> int:
        """The step that is due, 1–4; 0 when there is nothing to leave."""
        return self._due if self._leaving else 0

    def show_step(self, phase: TeachingPhase | None, step: Step) -> None:
        """Follow the arm: the steps begin with drag teaching and end with a ready arm."""
        if phase is not None and phase is not TeachingPhase.OFF:
            self._leaving = True
        elif step.kind in _OVER:
            self._leaving = False
        self._due = _NUMBER.get(step.kind, self._due)
        self.setVisible(self._leaving)
        self._mark()

    def _mark(self) -> None:
        for number, label in enumerate(self._lines, start=1):
            font = label.font()
            font.setBold(number == self._due)
            label.setFont(font)
            sign = "✓" if number < self._due else "▸" if number == self._due else ""
            self._signs[number - 1].setText(sign)
            label.setText(f"{number}. {self._words()[number - 1]}")

    def _words(self) -> tuple[str, ...]:
        return (
            self.tr("End what is under way; lead every joint near its zero by hand."),
            self.tr("Hold the arm. Emergency stop: the motors go limp, the arm sinks."),
            self.tr("Resume: the arm will drop, keep holding it."),
            self.tr("Enable the motors."),
        )

    def retranslate_ui(self) -> None:
        """Put its words into the operator's language."""
        self._title.setText(
            self.tr("To leave drag teaching, take the steps in the line at the top:")
        )
        self._mark()
