"""The program's line icons, drawn in any colour."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Final

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QGuiApplication, QIcon, QPainter, QPixmap, QPixmapCache
from PySide6.QtSvg import QSvgRenderer

from armui.system.files import read_file

_FOLDER: Final = Path(__file__).parent.parent / "icons"
_DRAWN_IN: Final = "#000000"
_FOR_OTHERS: Final = 2.0
"""The pixel ratio of the icon that is scaled for screens added after it was drawn."""


def pixmap(name: str, color: str, size: int, pixel_ratio: float) -> QPixmap:
    """Return an icon as a picture, cached by Qt.

    Args:
        name: File name in ``armui/ui/icons`` without its ending.
        color: ``#rrggbb``.
        size: Edge in device-independent pixels.
        pixel_ratio: Screen pixels to one of those.
    """
    key = f"armui {name} {color} {size} {pixel_ratio}"
    drawn = QPixmap()
    if not QPixmapCache.find(key, drawn):
        drawn = _draw(name, color, size, pixel_ratio)
        QPixmapCache.insert(key, drawn)
    return drawn


def _draw(name: str, color: str, size: int, pixel_ratio: float) -> QPixmap:
    drawing = _drawing(name).replace(_DRAWN_IN, color)
    result = QPixmap(QSize(size, size) * pixel_ratio)
    result.setDevicePixelRatio(pixel_ratio)
    result.fill(Qt.GlobalColor.transparent)
    painter = QPainter(result)
    QSvgRenderer(QByteArray(drawing.encode())).render(painter, QRectF(0, 0, size, size))
    painter.end()
    return result


@cache
def _drawing(name: str) -> str:
    return read_file(_FOLDER / f"{name}.svg").decode()


def load_all() -> None:
    """Read the files of all icons, so that later drawing does not wait for the disk."""
    for path in _FOLDER.glob("*.svg"):
        _drawing(path.stem)


def icon(name: str, color: str, size: int = 20) -> QIcon:
    """Return an icon, sharp on every present screen; to be made again after a change of theme."""
    result = QIcon()
    screens = QGuiApplication.screens()
    for ratio in sorted({_FOR_OTHERS, *(screen.devicePixelRatio() for screen in screens)}):
        result.addPixmap(pixmap(name, color, size, ratio))
    return result
