"""The page 总线: every frame on the bus, by identifier or in order of time."""

from __future__ import annotations

from datetime import datetime, timedelta
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QHeaderView, QMenu, QStackedWidget

from armui.arm.refusal_codes import RefusalCode
from armui.telemetry.bus_senders import Sender
from armui.telemetry.bus_statistics import BusStatistics
from armui.telemetry.bus_trace import TRACE_FRAMES, TraceSnapshot
from armui.ui.actions.keys import listen_for
from armui.ui.watch.bus.bus_summary import BusSummary
from armui.ui.watch.bus.filter_bar import FilterBar
from armui.ui.watch.bus.frame_model import FrameModel
from armui.ui.watch.bus.frame_texts import FrameTexts
from armui.ui.watch.bus.frame_views import FrameTree, TraceList
from armui.ui.watch.bus.send_box import SendBox
from armui.ui.watch.bus.trace_model import TraceModel
from armui.ui.widgets.buttons import named
from armui.ui.widgets.curve_menu import show_curves
from armui.ui.widgets.layouts import fill
from armui.ui.widgets.page import Page
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.table_model import Index

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from PySide6.QtGui import QContextMenuEvent, QHideEvent, QShowEvent

    from armui.control.arm_controller import ArmController
    from armui.telemetry.bus_statistics import BusSnapshot, FrameRow

LOOK_MS: Final = 100
"""The figures are shown anew so often."""
_SOON_MS: Final = 5
"""Frames that are left are counted so soon, after whatever else the thread has to do."""
_RUNNING_FRAMES: Final = 300
"""So many are shown in order of time while they run by; all that are kept once they stand."""


class BusPage(Page):
    """Listens to the bus only while it is shown, and counts from then on.

    Args:
        controller: Knows the bus.

    Attributes:
        statistics: What was counted.
        filter_bar: Which frames are shown.
        tree: Frames by identifier.
        trace: Frames in order of time.
        send_box: Sends a frame by hand.
    """

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
        self.send_box = SendBox(controller)
        self._timer = SeenTimer(self, LOOK_MS, self.look)
        self._soon = QTimer(self, interval=_SOON_MS, singleShot=True)
        self._lay_out()
        self._connect()
        self.retranslate_ui()

    def _lay_out(self) -> None:
        self.body.setSpacing(8)
        fill(self.body, self.summary, self.filter_bar, (self._views, 1), self.send_box)

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
        """Count from now on, and show what comes."""
        self.filter_bar.pause.setChecked(False)
        self._clock_zero = datetime.now().astimezone() - timedelta(seconds=self._now_s())
        self.statistics.clear()
        self.summary.begin()
        self.model.clear()
        self.trace_model.show_trace(None)
        self._snapshot = self.statistics.snapshot()
        self._show()

    def look(self) -> None:
        """Count what came, and show it unless the figures are to stand."""
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
        if not self.statistics.take():
            self._soon.start()

    def _is_leader(self) -> bool:
        operating_state = self._controller.operating_state
        other = operating_state.other_host
        leads = other is not None and other.reason.code == RefusalCode.LEADER_ARM
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
        """The frames of these rows; the newest in sight while they run by."""
        changed = self.filter_bar.wanted.changed_since_s is not None
        if changed and self._snapshot is not None:
            # there it is each single frame that must have changed
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
            time=self._clock_text(snapshot.since_s).partition(".")[0], count=snapshot.frames
        )
        paused = ""
        if self._standing is not None:
            stands = self.tr("Paused: the figures are those of {time}")
            paused = stands.format(time=self._clock_text(snapshot.at_s))
        if self.statistics.codec is not None and not self.statistics.generation_known:
            unknown = self.tr("Generation not known yet: read as generation 2")
            counted = f"{unknown} · {counted}"
        self.summary.show_bus(snapshot, self._now_s(), counted, paused)

    def _clock_text(self, at_s: float) -> str:
        at = self._clock_zero + timedelta(seconds=at_s)
        return f"{at:%H:%M:%S}.{at.microsecond // 1000:03d}"

    def _on_trace_wanted(self, wanted: bool) -> None:
        self._views.setCurrentWidget(self.trace if wanted else self.tree)
        self._show()
        if wanted:
            self.trace.scrollToBottom()

    # One frame --------------------------------------------------------------------------------

    def quantities_at(self, place: QPoint) -> list[str]:
        """The keys of what is shown at a place of the page."""
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
        """What can be done with a frame."""
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
                self.tr("Into the fields for sending"),
                lambda: self.send_box.take(row.arbitration_id, row.data),
            )
        return menu

    def _on_copy(self) -> None:
        chosen = sorted({each.row() for each in self.trace.selectedIndexes()})
        channel = "can0" if self._device is None else str(self._device.channel)
        zero_s = self._clock_zero.timestamp()
        lines = self.trace_model.lines(chosen, channel.replace(" ", "_"), zero_s)
        if lines:
            QGuiApplication.clipboard().setText("\n".join(lines) + "\n")

    def headers(self) -> Mapping[str, QHeaderView]:
        """The columns are kept."""
        return {"bus": self.tree.header(), "bus_trace": self.trace.header()}

    def take_focus(self) -> None:
        """The keys are for the frames."""
        (self.tree if self._views.currentIndex() == 0 else self.trace).setFocus()

    # The page -------------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Listen."""
        super().showEvent(event)
        self.statistics.forget_waiting()
        self._device = self._controller.operating_state.device
        self.begin()
        self._controller.bus.add_tap(self.statistics)

    def hideEvent(self, event: QHideEvent) -> None:
        """Listen no more."""
        self._soon.stop()
        self._controller.bus.remove_tap(self.statistics)
        super().hideEvent(event)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Bus monitor"))
        self.tree.setAccessibleName(self.tr("Frames by identifier"))
        self.trace.setAccessibleName(self.tr("Frames in order of time"))
        self._reread()
        self._show()
