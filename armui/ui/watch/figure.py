"""The plots as a picture, drawn from copied data, so in any thread."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QBuffer, QByteArray, QIODevice, QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPen, QPolygonF
from PySide6.QtSvg import QSvgGenerator

from armui.system.atomic import write_whole
from armui.ui.theme import LIGHT
from armui.ui.watch.round_figures import ticks
from armui.ui.watch.time_axis import tick_step_s, time_label

if TYPE_CHECKING:
    from armui.ui.watch.curve_shapes import Line

_WIDTH_PX: Final = 1200.0
_MARGIN_PX: Final = 16.0
_LEFT_PX: Final = 72.0
_PLOT_PX: Final = 150.0
_TICKS: Final = 4
_SCALE: Final = 2
"""The scale of pixel pictures: fine enough for printing."""


@dataclass(frozen=True, slots=True)
class FigurePlot:
    """One plot.

    Attributes:
        names: The names of its curves, each with its colour.
        lines: For each curve its pieces, over monotonic times.
        heights: The range of figures shown.
        title: The common part of the curves' names; "" if none.
        unit: The unit of the figures; "" for codes or bare numbers.
    """

    names: Sequence[tuple[str, str]]
    lines: Sequence[Sequence[Line]]
    heights: tuple[float, float]
    title: str = ""
    unit: str = ""


@dataclass(frozen=True, slots=True)
class CurveFigure:
    """Several plots over the same time.

    Attributes:
        heading: The text on its time.
        plots: The plots from top to bottom.
        edge_s: Monotonic time of the axis' zero.
        begin_s: The left end of the axis, from there.
        end_s: The right end.
        cursors: The names of the cursors, and their places on the axis.
        font: The font of all texts.
    """

    heading: str
    plots: Sequence[FigurePlot]
    edge_s: float
    begin_s: float
    end_s: float
    cursors: Sequence[tuple[str, float]]
    font: QFont


def size_of(figure: CurveFigure) -> QSize:
    """Return its size, in pixels of a screen."""
    line_px = QFontMetricsF(figure.font).height()
    height = 2 * _MARGIN_PX + 3 * line_px + len(figure.plots) * (_PLOT_PX + 2.2 * line_px)
    return QSize(round(_WIDTH_PX), round(height))


def to_image(figure: CurveFigure) -> QImage:
    """Return it as pixels, twice as fine as on a screen."""
    size = size_of(figure)
    image = QImage(size * _SCALE, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(_SCALE)
    image.fill(QColor(LIGHT.surface))
    painter = QPainter(image)
    _draw(painter, figure)
    painter.end()
    return image


def to_png(figure: CurveFigure) -> bytes:
    """Return it as a PNG file."""
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    to_image(figure).save(buffer, "PNG")  # type: ignore[call-overload]
    return bytes(data.data())


def to_svg(figure: CurveFigure) -> bytes:
    """Return it as an SVG file."""
    size = size_of(figure)
    data = QByteArray()
    buffer = QBuffer(data)
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    generator = QSvgGenerator()
    generator.setOutputDevice(buffer)
    generator.setSize(size)
    generator.setViewBox(QRectF(0, 0, size.width(), size.height()))
    generator.setTitle(figure.heading)
    painter = QPainter(generator)
    painter.fillRect(QRectF(0, 0, size.width(), size.height()), QColor(LIGHT.surface))
    _draw(painter, figure)
    painter.end()
    return bytes(data.data())


WRITERS: Final[dict[str, Callable[[CurveFigure], bytes]]] = {"png": to_png, "svg": to_svg}


def write(path: Path, figure: CurveFigure, kind: str) -> None:
    """Write a picture, replacing an existing file in one step.

    Raises:
        OSError: The disk or the folder does not allow it.
    """
    write_whole(path, WRITERS[kind](figure))


def _draw(painter: QPainter, figure: CurveFigure) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setFont(figure.font)
    line_px = QFontMetricsF(figure.font).height()
    painter.setPen(QColor(LIGHT.text))
    painter.drawText(QPointF(_MARGIN_PX, _MARGIN_PX + line_px * 0.8), figure.heading)
    top = _MARGIN_PX + 1.5 * line_px
    width = _WIDTH_PX - _LEFT_PX - 2 * _MARGIN_PX
    for plot in figure.plots:
        _draw_names(painter, plot, top, line_px)
        top += 1.4 * line_px
        _draw_plot(painter, figure, plot, QRectF(_LEFT_PX + _MARGIN_PX, top, width, _PLOT_PX))
        top += _PLOT_PX + 0.8 * line_px
    step_s = tick_step_s(figure.end_s - figure.begin_s, width)
    painter.setPen(QColor(LIGHT.muted))
    for time_s in _times(figure, step_s):
        x = _LEFT_PX + _MARGIN_PX + width * _share(time_s, figure.begin_s, figure.end_s)
        place = QRectF(x - 60.0, top - 0.6 * line_px, 120.0, line_px)
        painter.drawText(place, Qt.AlignmentFlag.AlignCenter, time_label(time_s, step_s))


def _draw_names(painter: QPainter, plot: FigurePlot, top: float, line_px: float) -> None:
    metrics = QFontMetricsF(painter.font())
    left, base = _LEFT_PX + _MARGIN_PX, top + line_px
    if plot.title:
        painter.setPen(QColor(LIGHT.text))
        painter.drawText(QPointF(left, base), plot.title)
        left += metrics.horizontalAdvance(plot.title) + 18.0
    for name, color in plot.names:
        painter.fillRect(QRectF(left, base - 0.4 * line_px, 14.0, 3.0), QColor(color))
        painter.setPen(QColor(LIGHT.text))
        painter.drawText(QPointF(left + 20.0, base), name)
        left += 20.0 + metrics.horizontalAdvance(name) + 18.0


def _draw_plot(painter: QPainter, figure: CurveFigure, plot: FigurePlot, place: QRectF) -> None:
    low, high = plot.heights
    metrics = QFontMetricsF(painter.font())
    for figure_at in ticks(low, high, _TICKS):
        y = place.bottom() - place.height() * _share(figure_at, low, high)
        painter.setPen(QPen(QColor(LIGHT.sunken), 1.0))
        painter.drawLine(QLineF(place.left(), y, place.right(), y))
        painter.setPen(QColor(LIGHT.muted))
        text = f"{figure_at:.6g}"
        x = place.left() - 8.0 - metrics.horizontalAdvance(text)
        painter.drawText(QPointF(x, y + 0.35 * metrics.ascent()), text)
    painter.setPen(QColor(LIGHT.muted))
    unit = QRectF(0.0, place.top() - 1.3 * metrics.height(), place.left() - 8.0, metrics.height())
    painter.drawText(unit, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, plot.unit)
    painter.setPen(QPen(QColor(LIGHT.sunken), 1.0))
    for time_s in _times(figure, tick_step_s(figure.end_s - figure.begin_s, place.width())):
        x = place.left() + place.width() * _share(time_s, figure.begin_s, figure.end_s)
        painter.drawLine(QLineF(x, place.top(), x, place.bottom()))
    painter.save()
    painter.setClipRect(place)
    for (_name, color), lines in zip(plot.names, plot.lines, strict=True):
        painter.setPen(QPen(QColor(color), 1.2))
        for times_s, figures in lines:
            across = (times_s - figure.edge_s - figure.begin_s) / (figure.end_s - figure.begin_s)
            up = (figures - low) / (high - low)
            points = zip(
                (place.left() + place.width() * across).tolist(),
                (place.bottom() - place.height() * up).tolist(),
                strict=True,
            )
            painter.drawPolyline(QPolygonF([QPointF(*point) for point in points]))
    painter.setPen(QPen(QColor(LIGHT.text), 1.0, Qt.PenStyle.DashLine))
    for name, at_s in figure.cursors:
        x = place.left() + place.width() * _share(at_s, figure.begin_s, figure.end_s)
        painter.drawLine(QLineF(x, place.top(), x, place.bottom()))
        painter.drawText(QPointF(x + 4.0, place.top() + metrics.ascent()), name)
    painter.restore()
    painter.setPen(QPen(QColor(LIGHT.border), 1.0))
    painter.drawRect(place)


def _times(figure: CurveFigure, step_s: float) -> list[float]:
    first, last = math.ceil(figure.begin_s / step_s), math.floor(figure.end_s / step_s + 1e-9)
    return [number * step_s for number in range(first, last + 1)]


def _share(value: float, low: float, high: float) -> float:
    return (value - low) / (high - low)
