"""Where a small window opens: over the panel or the page that asks, not over the picture."""

from __future__ import annotations

from typing import Final, Protocol, runtime_checkable

from PySide6.QtCore import QRect
from PySide6.QtWidgets import QDialog

_EDGE_PX: Final = 16


@runtime_checkable
class HasRoomForQuestions(Protocol):
    """A window that says where small windows may lie over it; no stop button lies there."""

    def room_for_questions(self) -> QRect:
        """In pixels of the desktop."""


def place(dialog: QDialog) -> None:
    """Move a dialog to the right edge of that room, and to its top.

    One that is wider than the room begins at its left edge; one that is higher goes on below.

    Args:
        dialog: Before it is shown; without a window that has such a room it stays where it is.
    """
    parent = dialog.parentWidget()
    window: object = None if parent is None else parent.window()
    if not isinstance(window, HasRoomForQuestions):
        return
    room = window.room_for_questions()
    dialog.ensurePolished()
    wanted = dialog.size().expandedTo(dialog.sizeHint())
    right = room.x() + room.width() - _EDGE_PX
    dialog.move(max(room.x(), right - wanted.width()), room.y() + _EDGE_PX)
