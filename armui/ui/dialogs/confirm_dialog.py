"""A question before something that the operator might regret."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QPushButton, QWidget

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
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

    It is asked about the arm that is there when it is made, and withdraws itself, with a line that
    says why, as soon as that is another one, or what it says is no more so. What is pressed is
    looked at once more by what is heard at that very moment.

    Args:
        controller: Whom the emergency stop tells.
        parent: The window that asks.
        title: The question in a few words.
        text: What will physically happen, and what to do before.
        action_label: What the button does, in a word.
        hold: The button must be held for a second: for what a double click must not do.
        concerns_arm: It is about the arm that is there now. A question about files is not.
        still: Whether what it says is still so.
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
        concerns_arm: bool = True,
        still: Callable[[], bool] = lambda: True,
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._asked_for = controller.mark if concerns_arm else None
        self._still = still
        controller.state_changed.connect(self._look)
        controller.operating_state_changed.connect(self._look)
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
            self.action_button = HoldButton(controller, action_label)
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

    def accept(self) -> None:
        """Agree, unless it is about another arm by now."""
        if self.holds():
            super().accept()

    def holds(self) -> bool:
        """Tell whether the arm and what was said are as they were; withdraw the question if not."""
        asked_for = self._asked_for
        if asked_for is not None and not asked_for.is_still(self._controller.mark):
            reason = Refusal(RefusalCode.ARM_CHANGED)
        elif not self._still():
            reason = Refusal(RefusalCode.ASKED_OTHERWISE)
        else:
            return True
        self.reject()
        self._controller.tell_withdrawn(self.windowTitle(), reason)
        return False

    def _look(self) -> None:
        if self.isVisible():
            self.holds()

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
