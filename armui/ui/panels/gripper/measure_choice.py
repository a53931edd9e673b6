"""Whether the gripper is told openings or angles (generation 2, from S-V1.8-8)."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QLabel, QSizePolicy, QWidget

from armui.ui.widgets.buttons import caption, choice_button
from armui.ui.widgets.enable_or_explain import enable_or_explain
from armui.ui.widgets.layouts import in_row

_LABEL_PX: Final = 58
"""As wide as those of the figures below."""


class MeasureChoice(QWidget):
    """Two buttons, one of them chosen.

    Signals:
        chosen: Whether angles are to be told.
    """

    chosen = Signal(bool)

    def __init__(self) -> None:
        super().__init__()
        self._label = QLabel()
        self._label.setMinimumWidth(_LABEL_PX)
        self._group = QButtonGroup(self)
        self._opening = choice_button("gripper_by_opening")
        self._angle = choice_button("gripper_by_angle")
        layout = in_row(self._label, on=self, spacing=6, margins=0)
        for place, button in enumerate((self._opening, self._angle)):
            button.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            self._group.addButton(button, place)
            layout.addWidget(button, 1)
        self._group.idClicked.connect(lambda place: self.chosen.emit(place == 1))

    def show_choice(self, *, by_angle: bool, why_not: str) -> None:
        """Show what counts now.

        Args:
            by_angle: Whether angles are told.
            why_not: The reason against angles; empty: there is none.
        """
        (self._angle if by_angle else self._opening).setChecked(True)
        enable_or_explain(self._angle, why_not, self.tr("Tells the gripper an angle."))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._label.setText(self.tr("Target as"))
        caption(self._opening, self.tr("Opening (mm)"), whose=self._label.text())
        caption(self._angle, self.tr("Angle (°)"), whose=self._label.text())
