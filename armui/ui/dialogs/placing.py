"""Where windows open: wholly on a screen; a small one over the panel or the page that asks."""

from __future__ import annotations

from typing import Final, Protocol, runtime_checkable

from PySide6.QtCore import QMargins, QRect
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog

from armui.ui.shell.workspace_layout import Place, fitted

_EDGE_PX: Final = 16
FRAME: Final = QMargins(8, 36, 8, 8)
"""What window systems draw around a window, its title above all; it must be in reach."""


@runtime_checkable
class HasRoomForQuestions(Protocol):
    """A window that says where small windows may lie over it; no stop button lies there."""

    def room_for_questions(self) -> QRect:
        """In pixels of the desktop."""


def place(dialog: QDialog) -> None:
    """Move a dialog to the right edge of that room, and to its top, and fit it on the screen.

    One that is wider than the room begins at its left edge; one that is higher goes on below.

    Args:
        dialog: Before it is shown; without a window that has such a room Qt finds its place.
    """
    parent = dialog.parentWidget()
    window = dialog if parent is None else parent.window()
    # where the operator has moved the window beyond the screen, its dialogs may go, too
    screen = window.screen().availableGeometry().marginsRemoved(FRAME)
    reach = screen if window is dialog else screen.united(window.geometry())
    dialog.ensurePolished()
    wanted = dialog.size().expandedTo(dialog.sizeHint())
    if not isinstance(window, HasRoomForQuestions):
        dialog.resize(dialog.size().boundedTo(reach.size()))
        return
    room = window.room_for_questions()
    left = max(room.x(), room.x() + room.width() - _EDGE_PX - wanted.width())
    wish = Place(left, room.y() + _EDGE_PX, wanted.width(), wanted.height())
    there = _rect_of(fitted(wish, [place_of(reach)]))
    if there.size() == wanted:
        dialog.move(there.topLeft())  # Qt sizes it as it is shown
    else:
        dialog.setGeometry(there)


def screens() -> list[Place]:
    """What a window can fill of each screen, the main one first."""
    main = QGuiApplication.primaryScreen()
    ordered = [main, *(each for each in QGuiApplication.screens() if each is not main)]
    return [place_of(each.availableGeometry().marginsRemoved(FRAME)) for each in ordered]


def place_of(rect: QRect) -> Place:
    """A rectangle of Qt as plain figures."""
    return Place(rect.x(), rect.y(), rect.width(), rect.height())


def _rect_of(place: Place) -> QRect:
    """The other way round."""
    return QRect(place.x, place.y, place.width, place.height)


def on_screen(place: Place) -> QRect:
    """Where a window opens that stood at a place: wholly on a screen there is."""
    return _rect_of(fitted(place, screens()))
