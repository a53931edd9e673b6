"""What went wrong in the program itself, in one line, with a text to copy for its developers."""

from __future__ import annotations

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from armui.control.events import Level
from armui.system.failures import Failure
from armui.ui.widgets.buttons import push_button
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.translated import Translated


class FailureLine(Translated, QWidget):
    """Hidden until something goes wrong; shows the newest failure, and how often it happened."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("failure_line")
        self._failure: Failure | None = None
        self._motion_ended = True
        self._message = MessageLine()
        self._copy = push_button("failure_copy_button")
        self._copy.clicked.connect(self._on_copy)
        self._close = push_button("failure_close_button")
        self._close.clicked.connect(self.hide)
        in_row((self._message, 1), self._copy, self._close, on=self, margins=(8, 4, 8, 4))
        self.retranslate_ui()
        self.hide()

    def text(self) -> str:
        """What it says now."""
        return self._message.text()

    def show_failure(self, failure: Failure, *, motion_ended: bool) -> None:
        """Tell of a failure; the same one again only counts.

        Args:
            failure: What went wrong.
            motion_ended: Whether every motion of this program was ended because of it.
        """
        again = self._failure is not None and self._failure.error == failure.error
        self._failure, self._motion_ended = failure, motion_ended
        self._say()
        if not again:
            self.show()

    def _on_copy(self) -> None:
        if self._failure is not None:
            QGuiApplication.clipboard().setText(self._failure.text)

    def _say(self) -> None:
        if self._failure is None:
            return
        if self._motion_ended:
            text = self.tr(
                "An error in the program ({error}). The emergency stop works; every motion of this "
                "program has been ended. Copy the details for the developers."
            )
        else:
            text = self.tr(
                "An error in the program ({error}). The emergency stop works; the part that failed "
                "can move nothing, and no motion was ended. Copy the details for the developers."
            )
        text = text.format(error=self._failure.error)
        if self._failure.count > 1:
            text += " " + self.tr("It has happened {count} times.").format(
                count=self._failure.count
            )
        self._message.show_message(text, Level.FAULT)

    def retranslate_ui(self) -> None:
        """Say everything again, in the language of now."""
        self._copy.setText(self.tr("Copy details"))
        self._close.setText(self.tr("Close"))
        for button in (self._copy, self._close):
            button.setAccessibleName(button.text())
        self._say()
