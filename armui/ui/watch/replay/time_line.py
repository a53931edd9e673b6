"""The time line of a log: faults, stops and commands, and the place of the replay."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QHelpEvent, QPainter, QPainterPath, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from armui.control.event_log.log_events import entry_of
from armui.session.session import MarkKind
from armui.ui import format as fmt
from armui.ui.format import NOTHING
from armui.ui.theme import Colors, colors_of
from armui.ui.watch.events.event_table import EventColumn
from armui.ui.watch.replay.log_time import moment, wall_time
from armui.ui.watch.replay.mark_places import MarkPlaces, end_of
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from collections.abc import Sequence

    import numpy as np
    from numpy.typing import NDArray
    from PySide6.QtCore import QEvent
    from PySide6.QtGui import QKeyEvent, QMouseEvent, QPaintEvent, QWheelEvent

    from armui.session.session import SessionMark


_HEIGHT_PX: Final = 62
_EDGE_PX: Final = 10.0
_FAULT_ROW: Final = QRectF(0, 6, 0, 9)
_COMMAND_ROW: Final = QRectF(0, 27, 0, 9)
_EPISODE_ROW: Final = QRectF(0, 15.5, 0, 11)
_DISCARDED_ROW: Final = QRectF(0, 19.5, 0, 3)
_ROWS: Final = {
    MarkKind.FAULT: _FAULT_ROW,
    MarkKind.EPISODE: _EPISODE_ROW,
    MarkKind.DISCARDED: _DISCARDED_ROW,
}
"""The rows of the marks that have a duration."""
_DRAWN: Final = (
    *(MarkKind.NOTE, MarkKind.DISCARDED, MarkKind.EPISODE, MarkKind.COMMAND),
    *(MarkKind.FAULT, MarkKind.STOP),
)
"""The kinds of marks, the last above the others."""
_STOP_Y: Final = 21.0
_LABELS_Y: Final = 40.0
_NEAR_PX: Final = 5.0
_LEAST_PX: Final = 2.0
_MOST_TOLD: Final = 8
_CLOSEST_S: Final = 0.05
"""The length of time shown at the closest zoom."""
_WHEEL: Final = 1.25
_STEP_S: Final = 1.0
_SMALL_STEP_S: Final = 0.1


def mark_text(mark: SessionMark) -> str:
    """Return the text of a mark: source, event, answer and result, in the operator's language."""
    entry = entry_of(mark, wall_time)
    parts = [f"{EventColumn.WHO.read(entry)}: {EventColumn.TEXT.read(entry)}"]
    for column in (EventColumn.ANSWER, EventColumn.RESULT):
        text = column.read(entry)
        if text not in {"", NOTHING}:
            parts.append(f"{column.title} {text}")
    if entry.count > 1:
        parts.append(EventColumn.COUNT.read(entry))
    return " · ".join(parts)


class TimeLine(Translated, QWidget):
    """A press goes to a place, a drag scrubs, the wheel zooms; ← and → go 1 s, with Shift 0.1 s.

    Signals:
        wanted: The log time to go to.
    """

    wanted = Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("time_line")
        self._start_s, self._end_s = 0.0, 1.0
        self._from_s, self._to_s = 0.0, 1.0
        self._at_s = 0.0
        self._marks: Sequence[SessionMark] = ()
        self._places = MarkPlaces((), 1.0)
        self._shapes: dict[MarkKind, QPainterPath] = {}
        self._span_of_shapes: tuple[float, float, float] | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.retranslate_ui()

    def show_log(self, start_s: float, end_s: float, marks: Sequence[SessionMark]) -> None:
        """Show a log from its beginning to its end."""
        self._start_s, self._end_s = start_s, max(end_s, start_s + _CLOSEST_S)
        self._from_s, self._to_s = self._start_s, self._end_s
        self.show_marks(marks)

    def show_marks(self, marks: Sequence[SessionMark]) -> None:
        """Show other marks of the same log."""
        self._marks = marks
        self._places = MarkPlaces(marks, self._end_s)
        self._span_of_shapes = None
        self.update()

    def show_position(self, at_s: float) -> None:
        """Set the replay's time; a zoomed time line follows it."""
        if at_s == self._at_s:
            return
        self._at_s = at_s
        if not self._from_s <= at_s <= self._to_s:
            width_s = self._to_s - self._from_s
            self._show_span(at_s - 0.1 * width_s, width_s)
        self.update()

    @property
    def shown_s(self) -> tuple[float, float]:
        """The log times at its ends."""
        return self._from_s, self._to_s

    def place_px(self, at_s: float) -> float:
        """Return the x coordinate of a log time, in pixels."""
        width_px = max(1.0, self.width() - 2 * _EDGE_PX)
        return _EDGE_PX + (at_s - self._from_s) / (self._to_s - self._from_s) * width_px

    def time_at(self, x_px: float) -> float:
        """Return the log time at an x coordinate in pixels."""
        width_px = max(1.0, self.width() - 2 * _EDGE_PX)
        share = min(max((x_px - _EDGE_PX) / width_px, 0.0), 1.0)
        return self._from_s + share * (self._to_s - self._from_s)

    def told_at(self, x_px: float) -> list[str]:
        """Return the texts of the marks at an x coordinate in pixels."""
        near_s = self.time_at(x_px + _NEAR_PX) - self.time_at(x_px)
        at_s = self.time_at(x_px)
        found = []
        for mark in self._marks:
            ended_s = end_of(mark, self._end_s) or mark.at_s
            if mark.at_s - near_s <= at_s <= ended_s + near_s:
                lasting = fmt.duration(ended_s - mark.at_s, 3) if ended_s > mark.at_s else ""
                words = f"{moment(mark.at_s)}  {mark_text(mark)}"
                found.append(f"{words} ({lasting})" if lasting else words)
        return found

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self.setAccessibleName(self.tr("Timeline of the log"))
        self.update()

    def _recolor(self) -> None:
        self.update()

    def sizeHint(self) -> QSize:
        """Return a size for three rows and the times."""
        return QSize(600, _HEIGHT_PX)

    # The operator -----------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Go to the place of the press."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.wanted.emit(self.time_at(event.position().x()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go to the place of the pointer while dragging."""
        if event.buttons() & Qt.MouseButton.LeftButton:
            self.wanted.emit(self.time_at(event.position().x()))

    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        """Show the whole log again."""
        self._from_s, self._to_s = self._start_s, self._end_s
        self.update()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom about the pointer."""
        steps = event.angleDelta().y() / 120.0
        whole_s = self._end_s - self._start_s
        before_s = self._to_s - self._from_s
        width_s = min(max(before_s * _WHEEL**-steps, _CLOSEST_S), whole_s)
        at_s = self.time_at(event.position().x())
        share = (at_s - self._from_s) / before_s
        self._show_span(at_s - share * width_s, width_s)
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go a little way, or to an end."""
        small = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        step_s = _SMALL_STEP_S if small else _STEP_S
        goals = {
            Qt.Key.Key_Left: self._at_s - step_s,
            Qt.Key.Key_Right: self._at_s + step_s,
            Qt.Key.Key_Home: self._start_s,
            Qt.Key.Key_End: self._end_s,
        }
        goal_s = goals.get(Qt.Key(event.key()))
        if goal_s is None:
            super().keyPressEvent(event)
        else:
            self.wanted.emit(min(max(goal_s, self._start_s), self._end_s))

    def event(self, event: QEvent) -> bool:
        """Show a tooltip on the marks under the pointer."""
        if isinstance(event, QHelpEvent):
            lines = self.told_at(event.pos().x())
            shown = lines[:_MOST_TOLD]
            if len(lines) > _MOST_TOLD:
                shown.append("…")
            text = "\n".join(shown) or moment(self.time_at(event.pos().x()))
            QToolTip.showText(event.globalPos(), text, self)
            return True
        return super().event(event)

    def _show_span(self, from_s: float, width_s: float) -> None:
        from_s = min(max(from_s, self._start_s), self._end_s - width_s)
        self._from_s, self._to_s = from_s, from_s + width_s
        self.update()

    # Drawing ----------------------------------------------------------------------------------

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the time line."""
        colors = colors_of(self)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        width_px = self.width() - 2 * _EDGE_PX
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.sunken))
        painter.drawRoundedRect(QRectF(_EDGE_PX - 2, 4, width_px + 4, 34), 4, 4)
        painter.setBrush(QColor(colors.replay_pale))
        begin_px = self.place_px(max(self._start_s, self._from_s))
        here_px = self.place_px(min(max(self._at_s, self._from_s), self._to_s))
        painter.drawRect(QRectF(begin_px, 4, max(0.0, here_px - begin_px), 34))
        self._draw_marks(painter, colors)
        self._draw_times(painter, colors)
        self._draw_position(painter, colors, here_px)
        if self.hasFocus():
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QPen(QColor(colors.replay), 1.0))
            painter.drawRoundedRect(QRectF(self.rect()).adjusted(1, 1, -1, -1), 4, 4)
        painter.end()

    def _draw_marks(self, painter: QPainter, colors: Colors) -> None:
        """Draw faults and episodes as bars, stops as triangles, commands as ticks.

        The length of a bar is the duration; a discarded episode is a thin grey one.
        """
        inks = {
            MarkKind.EPISODE: colors.ok,
            MarkKind.DISCARDED: colors.muted,
            MarkKind.NOTE: colors.muted,
            MarkKind.COMMAND: colors.accent,
            MarkKind.FAULT: colors.stop,
            MarkKind.STOP: colors.stop_strong,
        }
        painter.setPen(Qt.PenStyle.NoPen)
        for kind, path in self._shapes_of_marks().items():
            painter.setBrush(QColor(inks[kind]))
            painter.drawPath(path)

    def _shapes_of_marks(self) -> dict[MarkKind, QPainterPath]:
        """Return a path for each kind of marks, topmost last; cached until the span changes."""
        width_px = max(1.0, self.width() - 2 * _EDGE_PX)
        span = self._from_s, self._to_s, width_px
        if span != self._span_of_shapes:
            self._span_of_shapes = span
            self._shapes = {kind: _shape(kind, self._places.within(kind, *span)) for kind in _DRAWN}
        return self._shapes

    def _draw_times(self, painter: QPainter, colors: Colors) -> None:
        """Draw the times since the beginning, as many as fit."""
        painter.setPen(QColor(colors.muted))
        metrics = painter.fontMetrics()
        room_px = metrics.horizontalAdvance(fmt.clock(self._end_s - self._start_s, 3)) + 24
        span_s = self._to_s - self._from_s
        count = max(1, int((self.width() - 2 * _EDGE_PX) / room_px))
        step_s = _round_step(span_s / count)
        first = math.ceil((self._from_s - self._start_s) / step_s)
        for number in range(first, first + count + 2):
            since_s = number * step_s
            x = self.place_px(self._start_s + since_s)
            text = fmt.clock(since_s, 3)
            text = text.partition(".")[0] if step_s >= 1.0 else text
            width = metrics.horizontalAdvance(text)
            left = min(max(x - width / 2, 0.0), self.width() - width)
            if x > self.width() - _EDGE_PX + 1:
                break
            painter.drawLine(QPointF(x, _LABELS_Y - 2), QPointF(x, _LABELS_Y + 1))
            box = QRectF(left, _LABELS_Y + 1, width + 2, metrics.height())
            painter.drawText(box, Qt.AlignmentFlag.AlignLeft, text)

    def _draw_position(self, painter: QPainter, colors: Colors, x_px: float) -> None:
        painter.setPen(QPen(QColor(colors.replay), 2.0))
        painter.drawLine(QPointF(x_px, 2), QPointF(x_px, 40))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.replay))
        painter.drawEllipse(QPointF(x_px, 4), 4.5, 4.5)


def _shape(kind: MarkKind, places_px: NDArray[np.float64]) -> QPainterPath:
    """Return all marks of a kind as one path, which is drawn fast however many there are."""
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.WindingFill)
    row = _ROWS.get(kind, _COMMAND_ROW)
    for begin_px, end_px in (places_px + _EDGE_PX).tolist():
        if kind is MarkKind.STOP:
            path.addPolygon(_triangle(begin_px))
            path.closeSubpath()
        else:
            width_px = max(_LEAST_PX, end_px - begin_px) if kind in _ROWS else _LEAST_PX
            path.addRect(QRectF(begin_px, row.top(), width_px, row.height()))
    return path


def _triangle(x_px: float) -> QPolygonF:
    return QPolygonF(
        [
            QPointF(x_px - 5, _STOP_Y - 4),
            QPointF(x_px + 5, _STOP_Y - 4),
            QPointF(x_px, _STOP_Y + 4),
        ]
    )


def _round_step(least_s: float) -> float:
    """Return the next longer step of clock units, in seconds."""
    steps = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800)
    longer = next((each for each in steps if each >= least_s), None)
    return longer if longer is not None else 3600.0 * max(1, math.ceil(least_s / 3600.0))
