"""What is the same in most pictures: drawn once, then only laid over."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QRectF, Qt
from PySide6.QtGui import QPainter, QPixmap

if TYPE_CHECKING:
    from collections.abc import Callable


class KeptLayer:
    """Keeps an image of what was drawn last."""

    def __init__(self) -> None:
        self._key: object = None
        self._image: QPixmap | None = None
        self._place = QPoint()

    def paint(
        self,
        painter: QPainter,
        key: object,
        room: Callable[[], QRectF],
        draw: Callable[[QPainter], object],
    ) -> None:
        """Lay it over.

        Args:
            painter: Of the widget.
            key: All that the drawing depends on, beside font and pixels of the painter.
            room: What it covers; asked where something has changed.
            draw: Draws it; likewise.
        """
        wanted = (key, painter.device().devicePixelRatio(), painter.font())
        if wanted != self._key:
            self._key = wanted
            frame = room().toAlignedRect()
            self._image = None
            if not frame.isEmpty():
                self._place = frame.topLeft()
                ratio = painter.device().devicePixelRatio()
                self._image = QPixmap(frame.size() * ratio)
                self._image.setDevicePixelRatio(ratio)
                self._image.fill(Qt.GlobalColor.transparent)
                own = QPainter(self._image)
                own.setRenderHints(painter.renderHints())
                own.setFont(painter.font())
                own.translate(-frame.topLeft())
                draw(own)
                own.end()
        if self._image is not None:
            painter.drawPixmap(self._place, self._image)
