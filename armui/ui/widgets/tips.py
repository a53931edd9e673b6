"""Moves tooltips that would cover a stop or a lamp beside it."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QApplication, QWidget

_KEPT: Final = "kept_in_sight"
_GAP_PX: Final = 4


def keep_in_sight(widget: QWidget) -> None:
    """Mark a widget, such as a stop or a lamp, that no tooltip may cover."""
    widget.setProperty(_KEPT, True)


def uncover() -> None:
    """Move a visible tooltip away from marked widgets; hide it if there is no room."""
    windows = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
    kept = [
        QRect(each.mapToGlobal(QPoint(0, 0)), each.size())
        for window in windows
        for each in window.findChildren(QWidget)
        if each.property(_KEPT) and each.isVisible()
    ]
    for tip in windows:
        if tip.windowType() is Qt.WindowType.ToolTip:
            _move_off(tip, kept)


def _move_off(tip: QWidget, kept: list[QRect]) -> None:
    place = tip.geometry()
    covered = [each for each in kept if each.intersects(place)]
    if not covered:
        return
    screen = tip.screen().availableGeometry()
    below = max(each.bottom() for each in covered) + _GAP_PX
    above = min(each.top() for each in covered) - place.height() - _GAP_PX
    left = min(each.left() for each in covered) - place.width() - _GAP_PX
    right = max(each.right() for each in covered) + _GAP_PX
    corners = ((place.x(), below), (place.x(), above), (left, place.y()), (right, place.y()))
    for corner in corners:
        there = QRect(QPoint(*corner), place.size())
        if screen.contains(there) and not any(each.intersects(there) for each in kept):
            tip.move(there.topLeft())
            return
    tip.hide()
