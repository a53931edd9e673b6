"""Whose axes − and + go along: the base's or the tool's."""

from __future__ import annotations

from PySide6.QtWidgets import QButtonGroup, QLabel, QSizePolicy, QWidget

from armui.kinematics.poses import JogFrame
from armui.ui.widgets.buttons import caption, choice_button
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.translated import Translated


class FrameChoice(Translated, QWidget):
    """One button a frame; one of them is chosen."""

    def __init__(self) -> None:
        super().__init__()
        self._label = QLabel()
        self._buttons = QButtonGroup(self)
        layout = in_row(self._label, on=self, spacing=6, margins=0)
        for number, frame in enumerate(JogFrame):
            button = choice_button(f"frame_{frame.value}")
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self._buttons.addButton(button, number)
            layout.addWidget(button, 1)
        self._buttons.button(0).setChecked(True)
        self.retranslate_ui()

    @property
    def frame(self) -> JogFrame:
        """The chosen one."""
        return tuple(JogFrame)[self._buttons.checkedId()]

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._label.setText(self.tr("− and + along"))
        for number, text in enumerate((self.tr("Base frame"), self.tr("Tool frame"))):
            caption(self._buttons.button(number), text)
