"""One plot: its legend, and for each unit axes and curves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QEvent, QMimeData, QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QDrag, QFontMetricsF, QPainter, QPolygonF
from PySide6.QtWidgets import QApplication, QSizePolicy, QWidget

from armui.arm.state import is_fresh
from armui.telemetry.quantities import QUANTITIES
from armui.ui.override_guard import guarded
from armui.ui.theme import LIGHT_CURVES, colors_of, curve_colors, scaled_font
from armui.ui.watch.curve_cache import CurveBook
from armui.ui.watch.curve_shapes import AutoHeight, together
from armui.ui.watch.curves_item import DrawnCurve
from armui.ui.watch.figure import FigurePlot
from armui.ui.watch.graph import Graph
from armui.ui.widgets import painting
from armui.ui.widgets.layouts import in_column
from armui.ui.words import quantities as names

if TYPE_CHECKING:
    from PySide6.QtGui import (
        QContextMenuEvent,
        QDragEnterEvent,
        QDragMoveEvent,
        QDropEvent,
        QMouseEvent,
        QPaintEvent,
        QResizeEvent,
    )

    from armui.telemetry.quantities import Quantity
    from armui.telemetry.store import Telemetry
    from armui.ui.watch.curve_shapes import Line
    from armui.ui.watch.curves_item import Missing
    from armui.ui.watch.time_frame import Shown


LEAST_PX: Final = 60
"""The least height of the curves; the legend takes as many lines as it needs."""
_SWATCH_PX: Final = 14.0
_GAP_PX: Final = 6.0
_BETWEEN_PX: Final = 18.0
_LINE_PX: Final = 4.0
_WIDEST: Final = "−0000.000"
MIME: Final = "application/x-armui-quantities"
"""The format of dragged quantities: a key on each line, with the source plot after a tab."""


def mime_of(keys: Sequence[str], plot: int | None = None) -> QMimeData:
    """Return quantities as dragged data."""
    data = QMimeData()
    text = "\n".join(keys) if plot is None else "\n".join(f"{key}\t{plot}" for key in keys)
    data.setData(MIME, text.encode())
    return data


def from_mime(data: QMimeData) -> tuple[list[str], int | None]:
    """Return the dragged quantities and their plot; none for other data."""
    if not data.hasFormat(MIME):
        return [], None
    lines = bytes(data.data(MIME).data()).decode("utf-8", "replace").splitlines()
    parts = [line.partition("\t") for line in lines]
    plots = {plot for _key, _tab, plot in parts}
    plot = next(iter(plots)) if len(plots) == 1 else ""
    return [key for key, _tab, _plot in parts], int(plot) if plot.isdecimal() else None


def carry_away(source: QWidget, keys: Sequence[str], plot: int | None = None) -> None:
    """Start a drag of quantities; returns when they are dropped."""
    drag = QDrag(source)
    drag.setMimeData(mime_of(keys, plot))
    drag.exec(Qt.DropAction.MoveAction if plot is not None else Qt.DropAction.CopyAction)


class TakesQuantities:
    """A widget onto which quantities can be dropped; it emits them by its signal ``dropped``."""

    dropped: Any

    @guarded
    def dragEnterEvent(self, event: QDragEnterEvent | QDragMoveEvent) -> None:
        """Accept quantities."""
        if from_mime(event.mimeData())[0]:
            event.acceptProposedAction()

    dragMoveEvent = dragEnterEvent

    @guarded
    def dropEvent(self, event: QDropEvent) -> None:
        """Emit the dropped quantities."""
        keys, plot = from_mime(event.mimeData())
        if keys:
            event.acceptProposedAction()
            self.dropped.emit(keys, plot)


@dataclass(frozen=True, slots=True)
class Entry:
    """One curve in the legend.

    Attributes:
        key: The key of the quantity.
        name: The name in the operator's language.
        color: The colour of the curve.
        value: The value as text; "" if it shall have no room.
        stale: True if not heard for half a second.
    """

    key: str
    name: str
    color: str
    value: str = ""
    stale: bool = False


class Legend(QWidget):
    """The painted legend, in which a new value needs a repaint, but no layout.

    Args:
        plot: The index of its plot, part of dragged data.

    Signals:
        chosen: An entry was clicked: its key.
    """

    chosen = Signal(str)

    def __init__(self, plot: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._entries: tuple[Entry, ...] = ()
        self._title = ""
        self._value_px: dict[str, float] = {}
        self._places: list[QRectF] = []
        self._pressed: QPoint | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    @property
    def entries(self) -> tuple[Entry, ...]:
        """The entries in the order of their curves."""
        return self._entries

    @property
    def title(self) -> str:
        """The text before the entries."""
        return self._title

    def show_entries(self, entries: Sequence[Entry], title: str = "") -> None:
        """Set the entries and the common part of their names."""
        wanted = tuple(entries)
        if (wanted, title) == (self._entries, self._title):
            return
        names = [(each.key, each.name) for each in wanted]
        metrics = QFontMetricsF(self.font())
        grown = False
        for entry in wanted:
            value_px = metrics.horizontalAdvance(entry.value)
            if value_px > self._value_px.get(entry.key, metrics.horizontalAdvance(_WIDEST)):
                # the width never shrinks, so that names do not move with each value
                self._value_px[entry.key] = value_px
                grown = True
        moved = (
            grown
            or title != self._title
            or names != [(each.key, each.name) for each in self._entries]
        )
        self._entries, self._title = wanted, title
        if moved:
            self._arrange()
        self.update()

    def key_at(self, place: QPoint) -> str | None:
        """Return the key of the entry at a place, or ``None``."""
        for rect, entry in zip(self._places, self._entries, strict=True):
            if rect.contains(QPointF(place)):
                return entry.key
        return None

    def place_of(self, key: str) -> QPoint:
        """Return the middle of an entry.

        Raises:
            ValueError: It is not shown.
        """
        keys = [entry.key for entry in self._entries]
        return self._places[keys.index(key)].center().toPoint()

    def _arrange(self) -> None:
        metrics = QFontMetricsF(self.font())
        line_px = metrics.height() + _LINE_PX
        top = 0.0
        left = begin = self._title_px()
        self._places = []
        for entry in self._entries:
            width = _SWATCH_PX + 2 * _GAP_PX + metrics.horizontalAdvance(entry.name)
            width += self._value_px.get(entry.key, metrics.horizontalAdvance(_WIDEST))
            if left > begin and left + width > self.width():
                left, top = begin, top + line_px
            self._places.append(QRectF(left, top, min(width, float(self.width())), line_px))
            left += width + _BETWEEN_PX
        self.setFixedHeight(round(top + line_px))

    def _title_px(self) -> float:
        if not self._title:
            return 0.0
        metrics = QFontMetricsF(scaled_font(self, 1.0, bold=True))
        return metrics.horizontalAdvance(self._title) + _BETWEEN_PX

    def minimumSizeHint(self) -> QSize:
        """Return the size of one line: the entries wrap."""
        return QSize(120, self.fontMetrics().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Wrap the entries again."""
        super().resizeEvent(event)
        self._arrange()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the entries."""
        colors = colors_of(self)
        metrics = QFontMetricsF(self.font())
        painter = QPainter(self)
        if self._title:
            painter.setFont(scaled_font(self, 1.0, bold=True))
            painter.setPen(QColor(colors.text))
            whole = QRectF(0, 0, self._title_px(), metrics.height() + _LINE_PX)
            painter.drawText(whole, Qt.AlignmentFlag.AlignVCenter, self._title)
            painter.setFont(self.font())
        for rect, entry in zip(self._places, self._entries, strict=True):
            middle = rect.center().y()
            painter.fillRect(QRectF(rect.left(), middle - 1.5, _SWATCH_PX, 3.0), entry.color)
            left = rect.left() + _SWATCH_PX + _GAP_PX
            text = QRectF(left, rect.top(), rect.right() - left, rect.height())
            flags = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
            painter.setPen(QColor(colors.muted if entry.stale else colors.text))
            painter.drawText(text, flags, entry.name)
            text.setLeft(left + metrics.horizontalAdvance(entry.name) + _GAP_PX)
            painter.setPen(QColor(colors.muted))
            painter.drawText(text, flags, entry.value)
        painter.end()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Note a possible drag; between the entries the plot handles the press."""
        place = event.position().toPoint()
        if event.button() == Qt.MouseButton.LeftButton and self.key_at(place) is not None:
            self._pressed = place
        else:
            event.ignore()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Drag a quantity."""
        pressed, now = self._pressed, event.position().toPoint()
        if pressed is None:
            return
        key = self.key_at(pressed)
        far = (now - pressed).manhattanLength() >= QApplication.startDragDistance()
        if key is not None and far:
            self._pressed = None
            carry_away(self, [key], self._plot)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Select the entry of a click."""
        key = None if self._pressed is None else self.key_at(event.position().toPoint())
        self._pressed = None
        if key is not None:
            self.chosen.emit(key)


class PlotPane(TakesQuantities, QWidget):
    """Draws some quantities over a given time.

    Args:
        telemetry: The series.
        book: The cache of lines.
        place: The index of the plot.
        keys: The keys of the quantities.

    Attributes:
        quantities: The quantities drawn.
        graphs: One below the other, one for each unit: 0.005 A would lie flat under 40°.
        legend: The names and values.

    Signals:
        dropped: The keys of dropped quantities, and the plot they come from or ``None``.
        menu_wanted: The key under the mouse or ``None``, and the place on the screen.
        pressed: It was clicked, to be selected.
    """

    dropped = Signal(object, object)
    menu_wanted = Signal(object, QPoint)
    pressed = Signal()

    def __init__(
        self,
        telemetry: Telemetry,
        book: CurveBook[QPolygonF],
        place: int,
        keys: Sequence[str],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName(f"plot_{place}")
        self._telemetry = telemetry
        self.quantities: tuple[Quantity, ...] = tuple(QUANTITIES[key] for key in keys)
        self._book = book
        self._place = place
        self._shown: Shown | None = None
        self._chosen = False
        self.legend = Legend(place, self)
        units = dict.fromkeys(each.unit for each in self.quantities)
        self.graphs = tuple(Graph(unit, self) for unit in units)
        self.setAcceptDrops(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        in_column(
            self.legend,
            *((graph, 1) for graph in self.graphs),
            on=self,
            spacing=0,
            margins=(8, 4, 4, 2),
        )
        for graph in self.graphs:
            graph.setMinimumHeight(LEAST_PX)
            graph.box.clicked.connect(lambda _at: self.pressed.emit())
        self.legend.chosen.connect(lambda _key: self.pressed.emit())
        self._take_colors()
        self.show_values(telemetry.now_s())

    @property
    def curve_colors(self) -> dict[str, str]:
        """The colour of each quantity, by key."""
        palette = curve_colors(self)
        return {
            each.key: palette[place % len(palette)] for place, each in enumerate(self.quantities)
        }

    # Drawing ----------------------------------------------------------------------------------

    def advance(self, shown: Shown, edge_s: float, now_s: float) -> None:
        """Draw the curves for a time.

        Args:
            shown: The time from its edge, and the ranges of figures.
            edge_s: Monotonic time of the edge.
            now_s: The present.
        """
        begin_s, end_s = edge_s + shown.begin_s, min(edge_s + shown.end_s, now_s)
        colors = self.curve_colors
        for graph in self.graphs:
            curves, extents = [], []
            for each in self.quantities:
                if each.unit == graph.unit:
                    pieces, extent = self._book.curve(
                        each, begin_s, max(end_s, begin_s), graph.width_px
                    )
                    curves.append(DrawnCurve(colors[each.key], pieces))
                    extents.append(extent)
            zoomed = shown.ranges.get((self._place, graph.unit))
            graph.show_heights(shown, zoomed, together(extents))
            graph.curves.show_curves(curves, edge_s)

    def as_figure(self, shown: Shown, edge_s: float, now_s: float) -> list[FigurePlot]:
        """Return the plots for a picture: for each unit an axis of its own.

        Args:
            shown: The time from its edge, and the ranges of figures.
            edge_s: Monotonic time of the edge.
            now_s: The present.
        """
        begin_s, end_s = edge_s + shown.begin_s, min(edge_s + shown.end_s, now_s)
        book: CurveBook[Line] = CurveBook(self._telemetry, lambda times, figures: (times, figures))
        book.show(self.quantities)
        title, short = names.in_common(self.quantities)
        plots = []
        for graph in self.graphs:
            unit = graph.unit
            colored, curves, extents = [], [], []
            for place, (each, name) in enumerate(zip(self.quantities, short, strict=True)):
                if each.unit == unit:
                    pieces, extent = book.curve(each, begin_s, max(end_s, begin_s), graph.width_px)
                    colored.append((name, LIGHT_CURVES[place % len(LIGHT_CURVES)]))
                    curves.append(pieces)
                    extents.append(extent)
            own = shown.ranges.get((self._place, unit))
            fitted = own or AutoHeight(unit).fit(together(extents), codes=not unit)
            plots.append(FigurePlot(colored, curves, fitted, title, unit))
        return plots

    def show_values(self, now_s: float, at_s: float | None = None) -> None:
        """Show the values beside the names.

        Args:
            now_s: The present.
            at_s: The time of the values; by default the present.
        """
        colors = self.curve_colors
        entries = []
        title, short = names.in_common(self.quantities)
        for each, name in zip(self.quantities, short, strict=True):
            series = self._telemetry.series[each.series]
            latest = (
                series.latest(each.field) if at_s is None else series.value_at(each.field, at_s)
            )
            told_s, value = latest or (None, None)
            stale = not (each.held or is_fresh(told_s, now_s if at_s is None else at_s))
            text = names.quantity_value(each, None if latest is None else value)
            entries.append(Entry(each.key, name, colors[each.key], text, stale))
        self.legend.show_entries(entries, title)

    def show_cursors(self, at_s: Sequence[float | None], edge_s: float) -> None:
        """Draw the cursors at monotonic times."""
        for graph in self.graphs:
            graph.box.cursors = [None if each is None else each - edge_s for each in at_s]
            graph.curves.show_cursors(at_s, colors_of(self).text)

    def show_missing(self, missing: Missing | None) -> None:
        """Mark a time whose curves are not loaded yet."""
        for graph in self.graphs:
            graph.curves.show_missing(missing, colors_of(self).border)

    def ends_px(self, of: QWidget) -> tuple[float, float]:
        """Return the x coordinates of the time axis' ends in another widget, in pixels."""
        graph = self.graphs[0]
        left = graph.mapFromScene(graph.box.sceneBoundingRect().topLeft())
        begin = of.mapFromGlobal(graph.mapToGlobal(left)).x()
        return float(begin), float(begin + graph.width_px)

    # Qt's events ------------------------------------------------------------------------------

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Show the menu of the plot, or of the curve under the mouse."""
        key = self.legend.key_at(self.legend.mapFrom(self, event.pos()))
        self.menu_wanted.emit(key, event.globalPos())
        event.accept()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Select the plot."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.pressed.emit()

    @property
    def chosen(self) -> bool:
        """True if double clicks in the list add to this plot."""
        return self._chosen

    def set_chosen(self, *, wanted: bool) -> None:
        """Select the plot or not, and show that."""
        if wanted != self._chosen:
            self._chosen = wanted
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw a card, with a frame if it is selected."""
        colors = colors_of(self)
        painter = painting.begin(self)
        edge = colors.accent if self._chosen else colors.border
        painting.panel(painter, QRectF(self.rect()), colors.surface, edge, 1)
        painter.end()

    def _take_colors(self) -> None:
        for graph in self.graphs:
            graph.set_colors(colors_of(self))

    def changeEvent(self, event: QEvent) -> None:
        """Update after a change of language or colours."""
        if event.type() == QEvent.Type.PaletteChange:
            self._take_colors()
        if event.type() in {QEvent.Type.PaletteChange, QEvent.Type.LanguageChange}:
            self.show_values(self._telemetry.now_s())
        super().changeEvent(event)
