"""A window in which no control gets the focus because another one went away."""

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
    """A mixin for a window, placed before its Qt class.

    When the focused control is disabled or hidden, Qt moves the focus to the next one, even the
    emergency stop or a jog button: a second press of the space bar would press that. Here no
    control gets the focus, and Tab goes on from the former place.
    """

    _left: QWidget | None = None

    def focusNextPrevChild(self, forward: bool) -> bool:  # noqa: N802 - the name Qt calls
        """Move the focus, but only if Tab was pressed; return whether it has moved."""
        now = self.focusWidget()
        if now is not None and now is not self and not _takes_keys(now):
            self._left = now
            # the dialog itself takes the focus: without any, Qt would focus the first control as
            # soon as the window is activated
            self.setFocus()
            return True
        left, self._left = self._left, None
        if left is None or not isValid(left) or now not in {None, self}:
            return bool(super().focusNextPrevChild(forward))
        return self.go_on_from(left, forward=forward)

    def go_on_from(self, left: QWidget, *, forward: bool) -> bool:
        """Focus the next control after one, as Tab would; return whether there is one."""
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
    """Restore PySide's record of a widget's parent.

    PySide takes the result of `focusWidget`, `nextInFocusChain` or `childAt` for a child of the
    widget that was asked. When that one is deleted, Python objects of inner widgets, such as the
    viewport of a table, count as deleted although they live.
    """
    widget.setParent(widget.parentWidget())


def _takes_keys(widget: QWidget) -> bool:
    return widget.isEnabled() and widget.isVisible()
