"""The way out of drag teaching, one step at a time: lead to rest, stop, resume, enable."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtWidgets import QFrame, QLabel, QVBoxLayout, QWidget

from armui.control.recovery_steps import Kind, Step
from armui.control.teaching_phase import Phase

_STEPS: Final = 4
_NUMBER: Final[Mapping[Kind, int]] = {
    Kind.RECORDING: 1,
    Kind.REPLAYING: 1,
    Kind.REPLAY_PAUSED: 1,
    Kind.DRAG_MODE_WITHOUT_POWER: 1,
    Kind.OVERSPEED: 1,
    Kind.DRAG_MODE: 1,
    Kind.DRAG_MODE_AT_REST: 2,
    Kind.STOP_REQUESTED: 2,
    Kind.STOPPED: 3,
    Kind.MOTORS_OFF: 4,
    Kind.MOTORS_MIXED: 4,
}
"""Which of the four steps is due. The steps are taken in the line above the panels, where the arm's
own word leads from one to the next."""

_OVER: Final = frozenset({Kind.READY, Kind.NO_DEVICE, Kind.OPENING})


class WayOut(QFrame):
    """Four lines, the one that is due marked; hidden when there is nothing to leave."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("way_out")
        self._leaving = False
        self._due = 0
        self._title = QLabel()
        self._lines = [QLabel() for _ in range(_STEPS)]
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 4, 0, 4)
        layout.setSpacing(4)
        for label in (self._title, *self._lines):
            label.setWordWrap(True)
            layout.addWidget(label)
        self.hide()

    @property
    def due(self) -> int:
        """The step that is due, 1–4; 0 when there is nothing to leave."""
        return self._due if self._leaving else 0

    def show_step(self, phase: Phase | None, step: Step) -> None:
        """Follow the arm: the way out begins with drag teaching and ends with a ready arm."""
        if phase is not None and phase is not Phase.OFF:
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
            sign = "✓" if number < self._due else "▸" if number == self._due else "  "
            label.setText(f"{sign}  {number}. {self._words()[number - 1]}")

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
