"""Below the plots, always in sight: the times of all of them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.ui.theme import colors_of
from armui.ui.watch.time_axis import tick_step_s, time_label

if TYPE_CHECKING:
    from PySide6.QtGui import QPaintEvent


class TimeStrip(QWidget):
    """Labels under the lines of the plots; on the left what the clock showed at zero, if it stands.

    Attributes:
        zero: That time as text; "" while it runs.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._span_s = (-1.0, 0.0)
        self._ends_px = (0.0, 1.0)
        self.zero = ""
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_times(
        self, span_s: tuple[float, float], ends_px: tuple[float, float], zero: str
    ) -> None:
        """Show a time.

        Args:
            span_s: Its ends, on the axis.
            ends_px: Where they are.
            zero: What the clock showed at zero.
        """
        if (span_s, ends_px, zero) != (self._span_s, self._ends_px, self.zero):
            self._span_s, self._ends_px, self.zero = span_s, ends_px, zero
            self.update()

    def labels(self) -> list[tuple[float, str]]:
        """Where each label stands, and what it says."""
        (begin_s, end_s), (left, right) = self._span_s, self._ends_px
        step_s = tick_step_s(end_s - begin_s, right - left)
        first, last = math.ceil(begin_s / step_s - 1e-9), math.floor(end_s / step_s + 1e-9)
        times_s = [number * step_s for number in range(first, last + 1)]
        scale = (right - left) / (end_s - begin_s)
        return [
            (left + (time_s - begin_s) * scale, time_label(time_s, step_s)) for time_s in times_s
        ]

    def sizeHint(self) -> QSize:
        """One line."""
        return QSize(200, self.fontMetrics().height() + 2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        painter = QPainter(self)
        painter.setPen(QColor(colors_of(self).muted))
        taken = 0.0
        if self.zero:
            taken = self.fontMetrics().horizontalAdvance(self.zero) + 8.0
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignVCenter, self.zero)
        for x, text in self.labels():
            width = self.fontMetrics().horizontalAdvance(text)
            left = min(x - width / 2, self.width() - width)
            if left > taken:
                place = QRectF(left, 0, width + 1.0, self.height())
                painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, text)
        painter.end()
