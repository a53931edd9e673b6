"""The plots one below the other, all over the same time, drawn a dozen times a second."""

from __future__ import annotations

import time
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QPoint, Qt, QTimer, Signal
from PySide6.QtWidgets import QLabel, QWidget

from armui.telemetry.quantities import QUANTITIES
from armui.ui.watch.curve_cache import CurveBook
from armui.ui.watch.curves_item import polygon
from armui.ui.watch.plot_layout import PlotLayout
from armui.ui.watch.plot_pane import PlotPane, TakesQuantities
from armui.ui.watch.time_axis import TimeStrip
from armui.ui.watch.time_frame import TimeFrame
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import bare_area, in_column
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from datetime import datetime

    from PySide6.QtGui import QResizeEvent, QShowEvent

    from armui.telemetry.store import Telemetry
    from armui.ui.watch.curves_item import Missing
    from armui.ui.watch.graph import Graph
    from armui.ui.watch.time_frame import Axis, Range


PICTURE_MS: Final = 80
"""The period of drawing: twelve pictures a second, fewer of a long time."""
_STEP_PX: Final = 2.0
_SLOWEST_MS: Final = 500
"""The longest period of drawing, however long the time shown."""
_VALUES_EVERY_S: Final = 0.25
"""The period of updating the figures beside the names."""
CURSORS: Final = 2
_BREATH_MS: Final = 1
"""The pause between pieces of work; with 0 the next one would come before the window's events."""
_AT_ONCE_S: Final = 0.004
"""The longest drawing before the thread handles other events, such as a press."""


def clock_time(at: datetime) -> str:
    """Return the time of day, to the millisecond."""
    return f"{at:%H:%M:%S}.{at.microsecond // 1000:03d}"


class DropStrip(TakesQuantities, Translated, QLabel):
    """An area onto which quantities can be dropped.

    Signals:
        dropped: The keys, and the plot they come from or ``None``.
    """

    dropped = Signal(object, object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("drop_strip")
        self.setProperty("rank", "muted")
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setWordWrap(True)
        self.setAcceptDrops(True)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set its text in the operator's language."""
        self.setText(self.tr("Drag a quantity into a plot, or here for a plot of its own"))


class PlotBoard(QWidget):
    """Draws the visible plots; hidden it does nothing.

    Args:
        telemetry: The series of the curves.

    Attributes:
        telemetry: As given.
        plot_layout: The curves of each plot.
        frame: The time shown.
        panes: The plots.
        cursors_s: Monotonic times of the cursors; ``None`` for hidden ones.
        values_at_cursor: True if the values beside the names are those at the first cursor.
        times: The times, below the plots.

    Signals:
        plots_changed: The curves or their plots have changed.
        frame_changed: The time has changed, or was paused or continued.
        cursors_changed: The cursors have moved.
        refused: Something can't be added, because there are too many ``"plots"`` or ``"curves"``.
        menu_wanted: A plot's index, the key under the mouse or ``None``, and the place on the
            screen.
    """

    plots_changed = Signal()
    frame_changed = Signal()
    cursors_changed = Signal()
    refused = Signal(str)
    menu_wanted = Signal(int, object, QPoint)

    def __init__(self, telemetry: Telemetry, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.telemetry = telemetry
        self.plot_layout = PlotLayout()
        self.frame = TimeFrame()
        self.panes: list[PlotPane] = []
        self._book = CurveBook(telemetry, polygon)
        self._picture_s = 0.0
        self.cursors_s: list[float | None] = [None] * CURSORS
        self.values_at_cursor = False
        self._chosen = 0
        self._valued_s = 0.0
        self._dirty = True
        self._missing: Missing | None = None
        self._waiting: list[PlotPane] = []
        self._column = named("plot_column", QWidget())
        self._area = area = bare_area(self._column)
        self._stack = in_column(on=self._column, spacing=4, margins=0)
        self.times = TimeStrip(self)
        self._strip = DropStrip(self)
        self._strip.dropped.connect(lambda keys, plot: self.take(keys, plot, None))
        in_column((area, 1), self.times, self._strip, on=self, spacing=4, margins=0)
        self._timer = SeenTimer(self, PICTURE_MS, self._on_tick)
        self._rebuild()

    # What is drawn ----------------------------------------------------------------------------

    @property
    def chosen(self) -> int:
        """The plot to which a double click in the list adds."""
        return min(self._chosen, max(len(self.panes) - 1, 0))

    def show_plots(self, plots: Sequence[Sequence[str]]) -> None:
        """Show other plots."""
        self.plot_layout.show(tuple(tuple(plot) for plot in plots))
        self._after_change()

    def take(self, keys: Sequence[str], source: int | None, place: int | None) -> None:
        """Draw quantities in a plot, or in a new one (``None``); they leave their old plot."""
        why_not = self.plot_layout.why_not(keys, place)
        if why_not is not None:
            self.refused.emit(why_not)
            return
        if source is None or source >= len(self.plot_layout.plots):
            self.plot_layout.add(keys, place)
        else:
            for key in keys:
                if key in self.plot_layout.plots[source]:
                    self.plot_layout.move(key, source, place)
        self._after_change()

    def remove(self, place: int, key: str | None) -> None:
        """Remove a curve, or the whole plot."""
        if key is None:
            self.plot_layout.remove_plot(place)
        else:
            self.plot_layout.remove(place, key)
        self._after_change()

    def reveal(self, place: int) -> None:
        """Select a plot, and scroll to it."""
        if place < len(self.panes):
            self._choose(place)
            self._area.ensureWidgetVisible(self.panes[place])
        elif place < len(self.plot_layout.plots):
            # the plot is not created yet: try again soon
            QTimer.singleShot(_BREATH_MS, self, lambda: self.reveal(place))

    def _after_change(self) -> None:
        self.frame.forget_plots()
        self._rebuild()
        self.plots_changed.emit()
        self.frame_changed.emit()

    def _rebuild(self) -> None:
        """Keep the panes before the first changed plot, and create the others one at a time.

        Creating one takes some milliseconds; in between the thread handles other events.
        """
        plots = self.plot_layout.plots
        same = 0
        for pane, keys in zip(self.panes, plots, strict=False):
            if tuple(each.key for each in pane.quantities) != keys:
                break
            same += 1
        for pane in self.panes[same:]:
            pane.hide()
            pane.deleteLater()
        del self.panes[same:]
        self._book.show(QUANTITIES[key] for plot in plots for key in plot)
        self._build_next()

    @property
    def built(self) -> bool:
        """True if every plot has been created."""
        return len(self.panes) == len(self.plot_layout.plots)

    def _build_next(self) -> None:
        if not self.built:
            place = len(self.panes)
            pane = self._new_pane(place, self.plot_layout.plots[place])
            self.panes.append(pane)
            self._stack.insertWidget(place, pane, len(pane.graphs))
            QTimer.singleShot(_BREATH_MS, self, self._build_next)
        self._choose(self.chosen)
        self.draw_soon()

    def _new_pane(self, place: int, keys: tuple[str, ...]) -> PlotPane:
        pane = PlotPane(self.telemetry, self._book, place, keys, self._column)
        pane.dropped.connect(lambda what, source: self.take(what, source, place))
        pane.menu_wanted.connect(partial(self.menu_wanted.emit, place))
        pane.pressed.connect(partial(self._choose, place))
        for graph in pane.graphs:
            box, axis = graph.box, (place, graph.unit)
            box.framed.connect(partial(self._on_framed, axis))
            box.turned.connect(self._on_turned)
            box.turned_height.connect(partial(self._on_turned_height, graph, axis))
            box.panned.connect(self._on_panned)
            box.cursor_dragged.connect(self._on_cursor_dragged)
            box.clicked.connect(self._on_clicked)
            box.drag_finished.connect(self.frame.settle)
        return pane

    def _choose(self, place: int) -> None:
        self._chosen = place
        for each, pane in enumerate(self.panes):
            pane.set_chosen(wanted=each == place)

    # Time -------------------------------------------------------------------------------------

    def now_s(self) -> float:
        """Return the present monotonic time of the series, in seconds."""
        return self.telemetry.now_s()

    def edge_s(self) -> float:
        """Return the monotonic time that is zero on the axis."""
        return self.frame.edge_s(self.now_s())

    def pause(self, *, wanted: bool) -> None:
        """Pause, or follow the present again."""
        if wanted:
            self.frame.pause(self.now_s())
        else:
            self.frame.resume()
        self._frame_moved()

    def set_span(self, span_s: float) -> None:
        """Set the length of time shown."""
        self.frame.set_span(span_s)
        self._frame_moved()

    def undo(self) -> None:
        """Undo the last zoom."""
        self.frame.undo()
        self._frame_moved()

    def show_all_heights(self, place: int) -> None:
        """Fit a plot's height to its curves again."""
        for graph in self.panes[place].graphs:
            self.frame.zoom_height((place, graph.unit), None)
        self.frame.settle()
        self._frame_moved()

    def show_moment(self, at_s: float) -> None:
        """Show a monotonic time, and move the first cursor there."""
        self.frame.show_moment(self.now_s(), at_s)
        self.cursors_s[0] = at_s
        self._frame_moved()
        self._cursors_moved()

    def _on_framed(self, axis: Axis, begin_s: float, end_s: float, heights: Range | None) -> None:
        self.frame.zoom(self.now_s(), begin_s, end_s, axis, heights)
        self._frame_moved()

    def _on_turned(self, factor: float, at_s: float) -> None:
        self.frame.wheel(factor, at_s)
        self._frame_moved()

    def _on_turned_height(self, graph: Graph, axis: Axis, factor: float, at: float) -> None:
        low, high = graph.heights
        self.frame.zoom_height(axis, (at - (at - low) * factor, at + (high - at) * factor))
        self._frame_moved()

    def _on_panned(self, by_s: float) -> None:
        self.frame.pan(self.now_s(), by_s)
        self._frame_moved()

    def _frame_moved(self) -> None:
        self.draw_soon()
        self.frame_changed.emit()

    # Cursors ----------------------------------------------------------------------------------

    @property
    def has_cursors(self) -> bool:
        """True if a cursor is shown."""
        return any(each is not None for each in self.cursors_s)

    def show_cursors(self, *, wanted: bool) -> None:
        """Show or hide the cursors."""
        shown, edge_s = self.frame.shown, self.edge_s()
        places = (shown.begin_s + shown.span_s / 3, shown.begin_s + 2 * shown.span_s / 3)
        self.cursors_s = [edge_s + place if wanted else None for place in places]
        self._cursors_moved()

    def _on_cursor_dragged(self, number: int, at_s: float) -> None:
        shown = self.frame.shown
        self.cursors_s[number] = self.edge_s() + min(max(at_s, shown.begin_s), shown.end_s)
        self._cursors_moved()

    def _on_clicked(self, at_s: float) -> None:
        """Move the nearer cursor to the time of a click."""
        at_s += self.edge_s()
        near = [
            (abs(each - at_s), number)
            for number, each in enumerate(self.cursors_s)
            if each is not None
        ]
        if near:
            self.cursors_s[min(near)[1]] = at_s
            self._cursors_moved()

    def _cursors_moved(self) -> None:
        self.draw_soon()
        self.cursors_changed.emit()

    # Drawing ----------------------------------------------------------------------------------

    def show_missing(self, missing: Missing | None) -> None:
        """Mark a time whose curves are not loaded yet, or none with ``None``."""
        if missing != self._missing:
            self._missing = missing
            self.draw_soon()

    def draw_soon(self) -> None:
        """Draw as soon as possible, because something has changed."""
        self._dirty = True
        if self._timer.isActive() and self._timer.interval() > PICTURE_MS:
            self._timer.start(PICTURE_MS)

    def _period_ms(self) -> int:
        """Return the time in which curves move by two pixels: nothing new is seen before."""
        width_px = self.panes[0].graphs[0].width_px if self.panes else 1
        period_ms = round(1e3 * _STEP_PX * self.frame.shown.span_s / width_px)
        return min(max(period_ms, PICTURE_MS), _SLOWEST_MS)

    def _on_tick(self) -> None:
        if self.window().isMinimized():
            return
        now_s = self.now_s()
        if self.frame.live or self._dirty:
            self._dirty = False
            self._waiting, self._picture_s = self._seen(), now_s
            self._book.begin_picture()
            self._draw_some()
        self._timer.setInterval(self._period_ms())
        looked_s = time.monotonic()  # not `now_s`: a replay's time may stand still
        if looked_s - self._valued_s >= _VALUES_EVERY_S:
            self._valued_s = looked_s
            for pane in self._seen():
                pane.show_values(now_s, self.cursors_s[0] if self.values_at_cursor else None)

    def _draw_some(self) -> None:
        """Draw plots for a few milliseconds; others may have the thread before the next ones."""
        began_s = time.perf_counter()
        while self._waiting:
            pane = self._waiting.pop(0)
            if pane in self.panes:
                self._draw_pane(pane, self._picture_s)
            if self._waiting and time.perf_counter() - began_s > _AT_ONCE_S:
                QTimer.singleShot(_BREATH_MS, self, self._draw_some)
                return

    def draw(self, now_s: float) -> None:
        """Draw all visible plots at once."""
        self._book.begin_picture()
        for pane in self._seen():
            self._draw_pane(pane, now_s)

    def _draw_pane(self, pane: PlotPane, now_s: float) -> None:
        shown, edge_s = self.frame.shown, self.frame.edge_s(now_s)
        pane.advance(shown, edge_s, now_s)
        pane.show_missing(self._missing)
        pane.show_cursors(self.cursors_s, edge_s)
        at_begin = clock_time(self.telemetry.wall_time(edge_s + shown.begin_s))
        begin = "" if self.frame.live else at_begin
        self.times.show_times((shown.begin_s, shown.end_s), pane.ends_px(self.times), begin)

    def _seen(self) -> list[PlotPane]:
        return [pane for pane in self.panes if not pane.visibleRegion().isEmpty()]

    def showEvent(self, event: QShowEvent) -> None:
        """Draw the changes."""
        super().showEvent(event)
        self.draw_soon()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Draw for the new width."""
        super().resizeEvent(event)
        self.draw_soon()

    def changeEvent(self, event: QEvent) -> None:
        """Draw again after a change of colours."""
        if event.type() == QEvent.Type.PaletteChange:
            self.draw_soon()
        super().changeEvent(event)
