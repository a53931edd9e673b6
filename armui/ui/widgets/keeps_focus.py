"""A window in which no control gets the keyboard because another one went away."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget
from shiboken6 import isValid

if TYPE_CHECKING:
    _Base = QWidget
else:
    _Base = object


class KeepsFocus(_Base):
    """Of a window, stands before its Qt class.

    When the control that has the keyboard is disabled or hidden, Qt gives the keyboard to the next
    one, be it the emergency stop or a jog button: whoever presses the space bar a second time would
    press that. Here nobody gets it, and Tab goes on from where it was.
    """

    _left: QWidget | None = None

    def focusNextPrevChild(self, forward: bool) -> bool:  # noqa: N802 - the name Qt calls
        """Move on, if Tab was pressed."""
        now = self.focusWidget()
        if now is not None and now is not self and not _takes_keys(now):
            self._left = now
            now.clearFocus()
            return True
        left, self._left = self._left, None
        if left is None or not isValid(left) or now not in {None, self}:
            return bool(super().focusNextPrevChild(forward))
        return self.go_on_from(left, forward=forward)

    def go_on_from(self, left: QWidget, *, forward: bool) -> bool:
        """Give the keyboard to the next control after one, as Tab would; whether there is one."""
        step = QWidget.nextInFocusChain if forward else QWidget.previousInFocusChain
        each = step(left)
        while each is not None and each is not left:
            restore_parent(each)
            by_tab = bool(each.focusPolicy() & Qt.FocusPolicy.TabFocus)
            if by_tab and each.window() is self and _takes_keys(each):
                reason = Qt.FocusReason
                each.setFocus(reason.TabFocusReason if forward else reason.BacktabFocusReason)
                return True
            each = step(each)
        return False


def restore_parent(widget: QWidget) -> None:
    """Have PySide know whose child a widget is.

    PySide takes what `focusWidget`, `nextInFocusChain` or `childAt` returns for a child of the
    widget that was asked. When that one is deleted, the Python objects of what Qt has made in the
    other, such as the viewport of a table, are called deleted although they live.
    """
    widget.setParent(widget.parentWidget())


def _takes_keys(widget: QWidget) -> bool:
    return widget.isEnabled() and widget.isVisible()
