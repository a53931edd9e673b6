"""The page 总线: every frame on the bus, by identifier or in order of time."""

from __future__ import annotations

import math
from datetime import datetime, timedelta
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPoint, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QHeaderView, QLabel, QMenu, QStackedWidget, QWidget

from armui.control.events import Level
from armui.control.safety.other_command import LEADER_ARM
from armui.telemetry.bus_senders import Sender
from armui.telemetry.bus_statistics import BusStatistics
from armui.telemetry.bus_trace import TRACE_FRAMES, TraceSnapshot
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import HasActs
from armui.ui.actions.keys import listen_for
from armui.ui.theme import colors_of
from armui.ui.watch.bus.cells import KEY_ROLE, RowView
from armui.ui.watch.bus.filter_bar import FilterBar
from armui.ui.watch.bus.frame_model import FrameColumn, FrameModel, FrameTexts
from armui.ui.watch.bus.send_box import SendBox
from armui.ui.watch.bus.trace_model import TraceColumn, TraceModel
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import named
from armui.ui.widgets.curve_menu import set_quantities, show_curves
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.layouts import fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.page import Page
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.table_model import Index, chosen_rows
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import joined

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from PySide6.QtGui import (
        QContextMenuEvent,
        QHideEvent,
        QKeyEvent,
        QMouseEvent,
        QPainter,
        QResizeEvent,
        QShowEvent,
    )
    from PySide6.QtWidgets import QStyleOptionViewItem

    from armui.control.arm_controller import ArmController
    from armui.telemetry.bus_statistics import BusSnapshot, FrameRow


LOOK_MS: Final = 100
"""The period of updating the figures."""
_SOON_MS: Final = 5
"""The pause before the remaining frames are counted, in which the thread does other work."""
_RUNNING_FRAMES: Final = 300
"""The frames shown in order of time while they run; all kept ones are shown in a pause."""
_OLD_S: Final = 1.0
"""Older figures of load and rates are not shown."""
_BUSY_PERCENT: Final = 80.0
"""The bus load from which on a warning is shown."""
_KEYS: Final = ("bus.bus_load", "bus.frames_per_s", "bus.error_frames_per_s")
_ICON_PX: Final = 16
_INDENT_PX: Final = 22
_SAYS_PX: Final = 220
_WIDE: Final = "9000 /s"
"""The widest text of a figure: labels get its width, so that nothing beside them moves."""


class FrameTree(RowView):
    """Frames by identifier; a click on the sign before a signal shows its curve.

    Signals:
        curves_wanted: The keys of quantities to show as curves.
    """

    curves_wanted = Signal(object)

    def __init__(self, model: FrameModel) -> None:
        super().__init__(model)
        self.setObjectName("bus_tree")
        self.setModel(model)
        self.setIndentation(_INDENT_PX)
        self.setExpandsOnDoubleClick(True)
        self.fit_columns(FrameColumn, FrameColumn.DATA, FrameColumn.SAYS)
        header = self.header()
        header.resizeSection(FrameColumn.ID, header.sectionSize(FrameColumn.ID) + _INDENT_PX)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the room of the content column; the last columns scroll if not all fit."""
        header = self.header()
        others = header.length() - header.sectionSize(FrameColumn.SAYS)
        fits = self.viewport().width() - others >= _SAYS_PX
        modes = QHeaderView.ResizeMode
        mode = modes.Stretch if fits else modes.Interactive
        if header.sectionResizeMode(FrameColumn.SAYS) != mode:
            header.setSectionResizeMode(FrameColumn.SAYS, mode)
            header.resizeSection(FrameColumn.SAYS, _SAYS_PX)
        super().resizeEvent(event)

    def drawRow(  # noqa: N802 - the name Qt calls
        self, painter: QPainter, option: QStyleOptionViewItem, index: Index
    ) -> None:
        """Draw a row, with a sign before each signal that can be a curve."""
        super().drawRow(painter, option, index)
        place = self._sign(index)
        if place is not None:
            ratio = self.devicePixelRatioF()
            painter.drawPixmap(
                place, icons.pixmap("plots", colors_of(self).accent, _ICON_PX, ratio)
            )

    def _sign(self, index: Index) -> QRect | None:
        first = index.sibling(index.row(), FrameColumn.ID)
        if not first.data(KEY_ROLE):
            return None
        cell = self.visualRect(first)
        top = cell.center().y() - _ICON_PX // 2
        return QRect(cell.right() - _ICON_PX - 4, top, _ICON_PX, _ICON_PX)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Show the curve at a click on the sign."""
        super().mouseReleaseEvent(event)
        place = event.position().toPoint()
        index = self.indexAt(place)
        sign = self._sign(index) if index.isValid() else None
        left = event.button() is Qt.MouseButton.LeftButton
        if left and sign is not None and sign.adjusted(-4, -4, 4, 4).contains(place):
            self._show_curve(index)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Show the signal's curve at Enter."""
        if event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}:
            self._show_curve(self.currentIndex())
            event.accept()  # else a dialog would press its default button
            return
        super().keyPressEvent(event)

    def _show_curve(self, index: Index) -> None:
        key = index.sibling(index.row(), FrameColumn.ID).data(KEY_ROLE) if index.isValid() else None
        if key:
            self.curves_wanted.emit([key])


class TraceList(RowView):
    """Frames in order of time."""

    def __init__(self, model: TraceModel) -> None:
        super().__init__(model)
        self.setObjectName("bus_trace")
        self.setRootIsDecorated(False)
        self.setItemsExpandable(False)
        self.setModel(model)
        self.fit_columns(TraceColumn, TraceColumn.DATA, TraceColumn.SAYS)


class BusSummary(Translated, QWidget):
    """Four figures in a row.

    Args:
        controller: Gives the state of the connection.

    Attributes:
        message: The line for a fault of the bus, seen while there is one; its page places it.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._lost_before = 0
        self._trouble: tuple[str, Level] = ("", Level.INFO)
        self._names = [text_label(rank="muted") for _ in range(4)]
        self.load, self.rate, self.errors, self.lost = self._values = [
            text_label(name) for name in ("bus_load", "bus_rate", "bus_errors", "bus_lost")
        ]
        for key, value in zip(_KEYS, self._values, strict=False):
            set_quantities(value, key)
        self.paused = text_label("bus_paused", rank="warning")
        self.paused.hide()
        row = in_row(self.paused, on=self, spacing=6, margins=0)
        for name, value in zip(self._names, self._values, strict=True):
            fill(row, name, value)
        self.message = named("bus_message", MessageLine())
        self.message.hide()
        self.retranslate_ui()

    def begin(self) -> None:
        """Count losses from now on."""
        self._lost_before = self._controller.bus.frames_dropped

    def show_bus(
        self, snapshot: BusSnapshot, now_s: float, counted: str, paused: str, read_as: str
    ) -> None:
        """Show the state of the bus.

        Args:
            snapshot: The counts.
            now_s: Monotonic time.
            counted: The text on the beginning of the count.
            paused: The text that the figures are paused, shown in their place; "" if they
                are not.
            read_as: The text that the frames are read as those of a generation that is not known.
        """
        load = self._latest("bus.bus_load", now_s)
        _put(self.load, f"{fmt.number(load, 0)} %" if load is not None else fmt.NOTHING)
        rate = self._latest("bus.frames_per_s", now_s)
        _put(self.rate, f"{fmt.number(rate, 0)} /s" if rate is not None else fmt.NOTHING)
        errors = self._latest("bus.error_frames_per_s", now_s)
        often = f" ({fmt.number(errors, 0)} /s)" if errors else ""
        _put(self.errors, f"{fmt.count(snapshot.error_frames)}{often}")
        _put(self.lost, fmt.count(self._lost))
        if self.toolTip() != counted:
            self.setToolTip(counted)
        if paused != self.paused.text():
            self.paused.setText(paused)
            self.paused.setVisible(bool(paused))
            for figure in (*self._names, *self._values):
                figure.setVisible(not paused)
        self._show_trouble(snapshot, load, read_as)

    @property
    def _lost(self) -> int:
        dropped = self._controller.bus.frames_dropped
        self._lost_before = min(self._lost_before, dropped)  # a newly opened device counts from 0
        return dropped - self._lost_before

    def _latest(self, key: str, now_s: float) -> float | None:
        latest = self._controller.telemetry.latest(key)
        if latest is None or now_s - latest[0] > _OLD_S or not math.isfinite(latest[1]):
            return None
        return latest[1]

    def _show_trouble(self, snapshot: BusSnapshot, load: float | None, read_as: str) -> None:
        operating_state = self._controller.operating_state
        found = [read_as] if read_as else []
        level = Level.WARNING
        if operating_state.link_problem is not None:
            found.append(words.refusal(operating_state.link_problem))
            level = Level.FAULT
        if self._lost:
            text = self.tr(
                "{count} frames were lost before the program could read them: the computer is too "
                "busy, or the adapter too slow. What is shown is not all that was on the bus."
            )
            found.append(text.format(count=fmt.count(self._lost)))
        if load is not None and load >= _BUSY_PERCENT:
            found.append(
                self.tr("The bus is nearly full: frames of low priority come late. Send less.")
            )
        if snapshot.left_out or snapshot.beyond:
            text = self.tr(
                "Not counted here: {late} frames that came while the window was held up, {more} of "
                "identifiers beyond the first {rows}."
            )
            rows = len(snapshot.rows)
            found.append(
                text.format(
                    late=fmt.count(snapshot.left_out), more=fmt.count(snapshot.beyond), rows=rows
                )
            )
        trouble = joined(*found), level
        if trouble != self._trouble:
            self._trouble = trouble
            self.message.show_message(*trouble)
            self.message.setVisible(bool(found))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        texts = (
            self.tr("Bus load"),
            self.tr("Frames"),
            self.tr("Errors"),
            self.tr("Lost"),
        )
        tips = (
            self.tr("Of the bit rate, stuff bits not counted; right button: show as curve"),
            self.tr("Per second, this program's included"),
            self.tr("Errors on the bus that the adapter has reported since the counting began"),
            self.tr("Lost by the system's queue or by the adapter since the counting began"),
        )
        for name, value, text, tip in zip(self._names, self._values, texts, tips, strict=True):
            name.setText(text)
            name.setToolTip(tip)
            value.setToolTip(tip)
            value.setAccessibleName(text)
            value.setMinimumWidth(value.fontMetrics().horizontalAdvance(_WIDE))
        self._trouble = ("", Level.INFO)


def _put(label: QLabel, text: str) -> None:
    """Set a label's text, unless it is the same: setting it costs a layout."""
    if label.text() != text:
        label.setText(text)


class BusPage(Page):
    """Listens to the bus only while it is visible, and counts from then on.

    Args:
        controller: Gives access to the bus.

    Attributes:
        statistics: The counts.
        filter_bar: The filter of frames.
        tree: Frames by identifier.
        trace: Frames in order of time.
        send_box: The box that sends a frame by hand.
    """

    commands = (*FilterBar.commands, *SendBox.commands)

    def __init__(self, controller: ArmController) -> None:
        super().__init__("bus")
        self.setObjectName("bus_page")
        self._controller = controller
        self._now_s = controller.telemetry.now_s
        self.statistics = BusStatistics(self._now_s)
        self._texts = FrameTexts()
        self._clock_zero = datetime.now().astimezone()
        self._snapshot: BusSnapshot | None = None
        self._standing: TraceSnapshot | None = None
        self._device = controller.operating_state.device
        self.summary = BusSummary(controller)
        self.filter_bar = FilterBar(self._now_s)
        self.model = FrameModel(self._texts, self._clock_text, self)
        self.trace_model = TraceModel(self._texts, self._clock_text, self)
        self.tree = FrameTree(self.model)
        self.trace = TraceList(self.trace_model)
        self._views = QStackedWidget()
        self._views.addWidget(self.tree)
        self._views.addWidget(self.trace)
        self.send_box = SendBox(controller, self._texts)
        self._timer = SeenTimer(self, LOOK_MS, self.refresh)
        self._soon = QTimer(self, interval=_SOON_MS, singleShot=True)
        self._lay_out()
        self._connect()
        self.retranslate_ui()

    def act_parts(self) -> Iterable[HasActs]:
        """Return the bar and the box, whose acts the page offers."""
        return self.filter_bar, self.send_box

    def _lay_out(self) -> None:
        self.body.setSpacing(4)
        head = in_flow(self.filter_bar, self.summary, spacing_px=12)
        head.push(self.send_box.unlock)
        fill(self.body, head, self.summary.message, (self._views, 1), self.send_box)

    def _connect(self) -> None:
        self._soon.timeout.connect(self._count)
        self.filter_bar.changed.connect(self._show)
        self.filter_bar.trace_wanted.connect(self._on_trace_wanted)
        self.filter_bar.pause_wanted.connect(self._on_pause)
        self.filter_bar.clear_wanted.connect(self.begin)
        self.tree.curves_wanted.connect(lambda keys: show_curves(self, keys))
        listen_for("bus.copy", self.trace, self._on_copy, Qt.ShortcutContext.WidgetShortcut)

    # Counting ---------------------------------------------------------------------------------

    def begin(self) -> None:
        """Start counting again, and show new frames."""
        self.filter_bar.pause.setChecked(False)
        self._clock_zero = datetime.now().astimezone() - timedelta(seconds=self._now_s())
        self.statistics.clear()
        self.summary.begin()
        self.model.clear()
        self.trace_model.show_trace(None)
        self._snapshot = self.statistics.snapshot()
        self._show()

    def refresh(self) -> None:
        """Count new frames, and show them unless the figures are paused."""
        self._count()
        device = self._controller.operating_state.device
        if device is not None and device != self._device:
            before, self._device = self._device, device
            if before is not None:
                self.begin()
        reread = self._texts.speak(self.statistics.codec)
        leader = self._is_leader()
        self._texts.interface = "" if self._device is None else self._device.interface
        if reread or leader is not self._texts.leader:
            self._texts.leader = leader
            self._reread()
        self.send_box.refresh()
        if self._standing is None:
            self._snapshot = self.statistics.snapshot()
            self._show()
        else:
            self._show_counted()

    def _count(self) -> None:
        if not self.statistics.count_waiting():
            self._soon.start()

    def _is_leader(self) -> bool:
        operating_state = self._controller.operating_state
        other = operating_state.other_host
        leads = other is not None and other.refusal.reason == LEADER_ARM
        return leads or operating_state.teaching_input

    def _reread(self) -> None:
        self._texts.retranslate()
        self.model.retranslate()
        self.trace_model.retranslate()

    def _on_pause(self, paused: bool) -> None:
        self._count()
        self._snapshot = self.statistics.snapshot()
        self._standing = self.statistics.trace.snapshot() if paused else None
        self._show()

    # What is shown ----------------------------------------------------------------------------

    def _show(self) -> None:
        snapshot = self._snapshot
        if snapshot is None:
            return
        wanted = self.filter_bar.wanted
        rows = [each for each in snapshot.rows if wanted.accepts(each, self._texts.words)]
        self.model.show_rows(rows, snapshot.at_s)
        if self._views.currentWidget() is self.trace:
            self._show_trace(rows)
        self._show_counted()

    def _show_trace(self, rows: Sequence[FrameRow]) -> None:
        """Show the frames of these rows in order of time, scrolled to the newest unless paused."""
        changed = self.filter_bar.wanted.changed_since_s is not None
        if changed and self._snapshot is not None:
            # in this view only the frames that brought a change are shown
            wanted = self.filter_bar.wanted.for_trace
            rows = [row for row in self._snapshot.rows if wanted.accepts(row, self._texts.words)]
        running = self._standing is None
        trace = self.statistics.trace.snapshot() if self._standing is None else self._standing
        most = _RUNNING_FRAMES if running else TRACE_FRAMES
        numbers = [row.number for row in rows]
        self.trace_model.show_trace(trace.selected(numbers, only_changed=changed, most=most))
        if running:
            self.trace.scrollToBottom()

    def _show_counted(self) -> None:
        snapshot = self._snapshot
        if snapshot is None:
            return
        text = self.tr("Counted since {time}, when opened or cleared: {count} frames")
        counted = text.format(
            time=self._clock_text(snapshot.since_s).partition(".")[0],
            count=fmt.count(snapshot.frames),
        )
        paused = ""
        if self._standing is not None:
            stands = self.tr("Paused: the figures are those of {time}")
            paused = stands.format(time=self._clock_text(snapshot.at_s))
        unknown = self.statistics.codec is not None and not self.statistics.generation_known
        read_as = self.tr("Generation not known yet: read as generation 2.") if unknown else ""
        self.summary.show_bus(snapshot, self._now_s(), counted, paused, read_as)

    def _clock_text(self, at_s: float) -> str:
        at = self._clock_zero + timedelta(seconds=at_s)
        return f"{at:%H:%M:%S}.{at.microsecond // 1000:03d}"

    def _on_trace_wanted(self, wanted: bool) -> None:
        self._views.setCurrentWidget(self.trace if wanted else self.tree)
        self._show()
        if wanted:
            self.trace.scrollToBottom()

    # Menu and curves of a frame ---------------------------------------------------------------

    def quantities_at(self, place: QPoint) -> list[str]:
        """Return the keys of the quantities at a place of the page."""
        index = self._index_at(place)
        return [] if index is None else self.model.keys_of(index)

    def _index_at(self, place: QPoint) -> Index | None:
        if self._views.currentWidget() is not self.tree:
            return None
        viewport = self.tree.viewport()
        inside = viewport.mapFrom(self, place)
        index = self.tree.indexAt(inside)
        return index if viewport.rect().contains(inside) and index.isValid() else None

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Show the menu of a frame: curves, filter by its identifier, copying."""
        index = self._index_at(event.pos())
        if index is None:
            super().contextMenuEvent(event)
            return
        event.accept()
        self._menu_of(self.model.row_of(index), self.model.keys_of(index)).popup(event.globalPos())

    def _menu_of(self, row: FrameRow, keys: list[str]) -> QMenu:
        menu = named("bus_menu", QMenu(self))
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        if keys:
            menu.addAction(self.tr("Show as curve"), partial(show_curves, self, keys))
        menu.addAction(
            self.tr("Show this identifier alone"),
            lambda: self.filter_bar.ids.setText(f"{row.arbitration_id:03X}"),
        )
        line = f"{row.arbitration_id:03X}#{row.data.hex().upper()}"
        menu.addAction(
            self.tr("Copy {frame}").format(frame=line),
            lambda: QGuiApplication.clipboard().setText(line),
        )
        sendable = not row.flags and row.sender is not Sender.ARM
        if self.send_box.is_open and sendable:
            menu.addAction(
                self.tr("Copy to the send fields"),
                lambda: self.send_box.take(row.arbitration_id, row.data),
            )
        return menu

    def _on_copy(self) -> None:
        chosen = chosen_rows(self.trace)
        channel = "can0" if self._device is None else str(self._device.channel)
        zero_s = self._clock_zero.timestamp()
        lines = self.trace_model.lines(chosen, channel.replace(" ", "_"), zero_s)
        if lines:
            QGuiApplication.clipboard().setText("\n".join(lines) + "\n")

    def headers(self) -> Mapping[str, QHeaderView]:
        """Return the headers, whose columns are stored."""
        return {"bus": self.tree.header(), "bus_trace": self.trace.header()}

    def take_focus(self) -> None:
        """Focus the frames."""
        (self.tree if self._views.currentIndex() == 0 else self.trace).setFocus()

    # The page -------------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Start listening."""
        super().showEvent(event)
        self.statistics.forget_waiting()
        self._device = self._controller.operating_state.device
        self.begin()
        self._controller.bus.add_listener(self.statistics)

    def hideEvent(self, event: QHideEvent) -> None:
        """Stop listening."""
        self._soon.stop()
        self._controller.bus.remove_listener(self.statistics)
        super().hideEvent(event)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Bus monitor"))
        self.tree.setAccessibleName(self.tr("Frames by identifier"))
        self.trace.setAccessibleName(self.tr("Frames in order of time"))
        self._reread()
        self._show()
