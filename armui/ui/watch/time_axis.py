"""The axes of a plot: times in steps of a clock, and round figures."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, Final

import pyqtgraph as pg
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.ui.format import append_unit
from armui.ui.theme import colors_of
from armui.ui.watch.round_figures import round_step

if TYPE_CHECKING:
    from PySide6.QtGui import QPaintEvent


_STEPS_S: Final = (
    *(0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5),
    *(1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0),
)
_TICK_PX: Final = 90.0
_FIGURE_PX: Final = 19.0
_MINUTES_FROM_S: Final = 10.0
"""The step from which on labels have minutes and seconds."""


def tick_step_s(span_s: float, width_px: float) -> float:
    """Return the step between labels, in seconds."""
    wanted_s = span_s * _TICK_PX / max(width_px, _TICK_PX)
    return next((step_s for step_s in _STEPS_S if step_s >= wanted_s), _STEPS_S[-1])


def time_label(time_s: float, step_s: float) -> str:
    """Return a time on the axis as text: ``-2.5 s``, ``-12:30``."""
    time_s = round(time_s, 6) + 0.0
    if step_s >= _MINUTES_FROM_S and abs(time_s) >= 60.0:
        minutes, seconds = divmod(round(abs(time_s)), 60)
        return f"{'−' if time_s < 0 else ''}{minutes}:{seconds:02d}"
    decimals = max(0, len(f"{step_s:.3f}".rstrip("0")) - 2) if step_s < 1.0 else 0
    text = f"{abs(time_s):.{decimals}f} s"
    return f"−{text}" if time_s < 0 else text


class TimeAxis(pg.AxisItem):  # type: ignore[misc]
    """Ticks in steps of a clock; their labels are below all plots."""

    def __init__(self) -> None:
        super().__init__("bottom", maxTickLength=-4, showValues=False)
        self.enableAutoSIPrefix(False)

    def tickSpacing(self, *span_and_length: float) -> list[tuple[float, float]]:  # noqa: N802
        """Return one spacing of ticks, by the first and last time and the length in pixels."""
        first_s, last_s, length_px = span_and_length
        return [(tick_step_s(last_s - first_s, length_px), 0.0)]


class FigureAxis(pg.AxisItem):  # type: ignore[misc]
    """Round figures with their unit, and space between them.

    Args:
        unit: The unit; "" for codes, which have only whole figures.
    """

    def __init__(self, unit: str) -> None:
        super().__init__("left", maxTickLength=-4)
        self.enableAutoSIPrefix(False)
        self._unit = unit

    def tickSpacing(self, *span_and_length: float) -> list[tuple[float, float]]:  # noqa: N802
        """Return one spacing of ticks, by the range of figures and the length in pixels."""
        low, high, length_px = span_and_length
        step = round_step(low, high, max(1, round(length_px / _FIGURE_PX)))
        return [(step or 1.0 if self._unit else max(step, 1.0), 0.0)]

    def tickStrings(self, *values_scale_spacing: Any) -> list[str]:  # noqa: N802
        """Return figures with their unit, as everywhere else."""
        return [
            append_unit(each, self._unit) for each in super().tickStrings(*values_scale_spacing)
        ]


class TimeStrip(QWidget):
    """Labels under the plots; at the left the time of day at the left end, if it stands still.

    Attributes:
        begin: The time of day at the left end as text; "" while it runs.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._span_s = (-1.0, 0.0)
        self._ends_px = (0.0, 1.0)
        self.begin = ""
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_times(
        self, span_s: tuple[float, float], ends_px: tuple[float, float], begin: str
    ) -> None:
        """Set the time shown.

        Args:
            span_s: Its ends, on the axis.
            ends_px: The places of the ends.
            begin: The time of day at the first of them.
        """
        if (span_s, ends_px, begin) != (self._span_s, self._ends_px, self.begin):
            self._span_s, self._ends_px, self.begin = span_s, ends_px, begin
            self.update()

    def labels(self) -> list[tuple[float, str]]:
        """Return the place and the text of each label."""
        (begin_s, end_s), (left, right) = self._span_s, self._ends_px
        step_s = tick_step_s(end_s - begin_s, right - left)
        first, last = math.ceil(begin_s / step_s - 1e-9), math.floor(end_s / step_s + 1e-9)
        times_s = [number * step_s for number in range(first, last + 1)]
        scale = (right - left) / (end_s - begin_s)
        return [
            (left + (time_s - begin_s) * scale, time_label(time_s, step_s)) for time_s in times_s
        ]

    def sizeHint(self) -> QSize:
        """Return the size of one line."""
        return QSize(200, self.fontMetrics().height() + 2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the labels."""
        painter = QPainter(self)
        painter.setPen(QColor(colors_of(self).muted))
        taken = 0.0
        if self.begin:
            taken = self.fontMetrics().horizontalAdvance(self.begin) + 8.0
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignVCenter, self.begin)
        for x, text in self.labels():
            width = self.fontMetrics().horizontalAdvance(text)
            left = min(x - width / 2, self.width() - width)
            if left > taken:
                place = QRectF(left, 0, width + 1.0, self.height())
                painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, text)
        painter.end()
