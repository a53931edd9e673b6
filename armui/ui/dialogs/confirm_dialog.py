"""A question before something that the operator might regret."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QPushButton, QWidget

from armui.control.arm_controller import ArmController
from armui.ui.dialogs.base import ArmDialog
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.hold_button import HoldButton
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.text_label import text_label

_SIGN_PX: Final = 36
_TEXT_WIDTH_PX: Final = 520


class ConfirmDialog(ArmDialog):
    """Says what is going to happen; nothing does unless the button that names it is pressed.

    Enter and Escape both mean no. Its emergency stop stops, and never asks a question itself.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window that asks.
        title: The question in a few words.
        text: What will physically happen, and what to do before.
        action_label: What the button does, in a word.
        hold: The button must be held for a second: for what a double click must not do.
    """

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        *,
        title: str,
        text: str,
        action_label: str,
        hold: bool = False,
    ) -> None:
        super().__init__(controller, parent)
        self.set_title(title)
        self._sign = QLabel()
        self._text = QLabel(text)
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setWordWrap(True)
        self._text.setMinimumWidth(_TEXT_WIDTH_PX)
        content = in_row(spacing=16)
        content.addWidget(self._sign, 0, Qt.AlignmentFlag.AlignTop)
        content.addWidget(self._text, 1, Qt.AlignmentFlag.AlignTop)
        self.body.addLayout(content)

        self._hint = text_label(rank="muted")
        self._hint.setVisible(hold)
        self.action_button: QPushButton
        if hold:
            self.action_button = HoldButton(action_label)
            self.action_button.held.connect(self.accept)
        else:
            self.action_button = push_button("", action_label, on_enter=False)
            self.action_button.clicked.connect(self.accept)
        self.cancel_button = push_button(on_enter=True)
        self.cancel_button.clicked.connect(self.reject)
        fill(self.footer, self._hint, STRETCH, self.action_button, self.cancel_button)
        self.cancel_button.setFocus()
        self._recolor()
        self.retranslate_ui()

    def show_text(self, text: str) -> None:
        """Say something else."""
        self._text.setText(text)

    def text(self) -> str:
        """What it says."""
        return self._text.text()

    def retranslate_ui(self) -> None:
        """Only what is not the asker's: how to answer."""
        self._hint.setText(self.tr("Hold the button, or the space bar on it, for one second."))
        self.cancel_button.setText(self.tr("Cancel"))

    def _recolor(self) -> None:
        ink = colors_of(self).warn
        self._sign.setPixmap(icons.pixmap("warning", ink, _SIGN_PX, self.devicePixelRatioF()))
