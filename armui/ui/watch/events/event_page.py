"""The page 事件: all events, the newest last."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QPoint, Qt, QTimer, Signal
from PySide6.QtWidgets import QAbstractItemView, QBoxLayout, QHeaderView, QMenu

from armui.ui.actions.act import HasActs
from armui.ui.actions.keys import listen_for
from armui.ui.theme import colors_of
from armui.ui.watch.events.event_bar import EventBar, EventExport
from armui.ui.watch.events.event_table import EventModel, EventTable, details
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.page import Page
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.text_label import text_label

if TYPE_CHECKING:
    from PySide6.QtGui import QResizeEvent, QShowEvent

    from armui.control.arm_controller import ArmController
    from armui.control.events import Level
    from armui.ui.background import Background
    from armui.ui.watch.events.event_filter import EventFilter

_LOOK_MS: Final = 200
_LEAST_PX: Final = 64
"""The least height of the table: its titles and three rows."""
_DETAIL_PX: Final = 260
_BESIDE_PX: Final = 960
"""In a narrower page the detail beside the table would leave no room for the events."""
_DETAIL_LINES: Final = 4
_UNBOUNDED_PX: Final = 10_000


class EventPage(Page):
    """A table that follows the log, only while it is visible.

    Args:
        controller: Gives the events.
        background: Writes files.

    Signals:
        moment_chosen: The monotonic time of an event that was clicked.
        moment_wanted: The same for one to be shown in the curves, even if they are closed.
    """

    commands = EventBar.commands
    moment_chosen = Signal(float)
    moment_wanted = Signal(float)

    def __init__(self, controller: ArmController, background: Background) -> None:
        super().__init__("events")
        self.setObjectName("event_page")
        self.model = EventModel(controller.events, colors_of(self))
        self.bar = EventBar()
        self.export = EventExport(controller, background, self)
        self.table = EventTable(self.model)
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.table.setMinimumHeight(_LEAST_PX)
        self.detail = text_label("event_detail", wraps=True, plain=True)
        self.detail.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.detail.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self._message = named("event_message", MessageLine(keeps_room=False))
        self.body.setSpacing(4)
        self.detail.hide()
        self._table_and_detail = in_row((self.table, 1), self.detail, spacing=8)
        fill(self.body, self.bar, (self._table_and_detail, 1))
        self.body.addWidget(self._message)
        self._timer = SeenTimer(self, _LOOK_MS, self.refresh)
        self._connect()
        self.retranslate_ui()

    def act_parts(self) -> Iterable[HasActs]:
        """Return the bar, whose acts the page offers."""
        return (self.bar,)

    def _connect(self) -> None:
        self.bar.filter_changed.connect(self._on_filter)
        self.bar.follow_changed.connect(self._on_follow)
        self.bar.follow.clicked.connect(self._on_follow_pressed)
        self.bar.save.wanted.connect(lambda kind: self.export.save(kind, self.model.entries()))
        self.export.message_changed.connect(self._show_message)
        self.table.clicked.connect(self._on_clicked)
        self.table.activated.connect(self._on_activated)
        self.table.customContextMenuRequested.connect(self._open_menu)
        self.table.selectionModel().currentRowChanged.connect(self._show_detail)
        self.model.modelReset.connect(self._on_reset)
        self.model.dataChanged.connect(self._show_detail)
        self.table.verticalScrollBar().actionTriggered.connect(self._on_scrolled)
        listen_for("events.copy", self.table, self.copy_chosen, Qt.ShortcutContext.WidgetShortcut)

    # What is shown ----------------------------------------------------------------------------

    def refresh(self) -> None:
        """Add the events logged since the last call, and their number."""
        if self.model.follow():
            self._show_newest()
        self._show_count()

    def _show_count(self) -> None:
        self.bar.show_count(self.model.rowCount(), self.model.kept)

    def _show_newest(self) -> None:
        if self.bar.follow.isChecked():
            self.table.scrollToBottom()

    def show_entry(self, number: int) -> None:
        """Scroll to an entry and select it, clearing a filter that hides it."""
        self.model.follow()
        if self.model.row_of(number) is None:
            self.bar.show_all()
        row = self.model.row_of(number)
        if row is None:
            return
        self.bar.follow.setChecked(False)
        index = self.model.index(row, 0)
        flags = QItemSelectionModel.SelectionFlag
        self.table.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
        self.table.scrollTo(index, QAbstractItemView.ScrollHint.PositionAtCenter)

    def _show_detail(self) -> None:
        entry = self.table.current()
        text = "" if entry is None else "\n".join(details(entry))
        if self.detail.text() != text:
            self.detail.setText(text)
        self.detail.setVisible(bool(text) or self._is_narrow)

    @property
    def _is_narrow(self) -> bool:
        return self.width() < _BESIDE_PX

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Place the detail beside or below the table, where showing it moves no row."""
        super().resizeEvent(event)
        way = QBoxLayout.Direction
        if self._is_narrow:
            self._table_and_detail.setDirection(way.TopToBottom)
            self.detail.setFixedSize(_UNBOUNDED_PX, _DETAIL_LINES * self.fontMetrics().height())
            self.detail.setMinimumWidth(0)
        else:
            self._table_and_detail.setDirection(way.LeftToRight)
            self.detail.setFixedSize(_DETAIL_PX, _UNBOUNDED_PX)
            self.detail.setMinimumHeight(0)
        self._show_detail()

    def _on_reset(self) -> None:
        self._show_newest()
        self._show_count()
        self._show_detail()

    # What the operator does -------------------------------------------------------------------

    def _on_filter(self, wanted: EventFilter) -> None:
        current = self.table.current()
        self.model.set_filter(wanted)
        row = None if current is None else self.model.row_of(current.number)
        if row is not None:
            self.table.selectRow(row)

    def _on_follow(self, on: bool) -> None:
        if on:
            self.table.scrollToBottom()

    def _on_follow_pressed(self, on: bool) -> None:
        """Deselect the event, and so hide its detail, to follow the newest ones."""
        if on:
            self.table.selectionModel().clear()
            self._show_detail()

    def _on_scrolled(self) -> None:
        """Follow the newest event only while the list is scrolled to its end."""
        # actionTriggered comes before the bar has moved
        QTimer.singleShot(0, self, self._follow_where_it_ends)

    def _follow_where_it_ends(self) -> None:
        bar = self.table.verticalScrollBar()
        self.bar.follow.setChecked(bar.value() >= bar.maximum())

    def _on_clicked(self, index: QModelIndex) -> None:
        self.bar.follow.setChecked(False)
        self.moment_chosen.emit(self.model.entry(index.row()).at_s)

    def _on_activated(self, index: QModelIndex) -> None:
        self.moment_wanted.emit(self.model.entry(index.row()).at_s)

    def copy_chosen(self) -> None:
        """Copy the selected rows."""
        entries = self.table.chosen()
        if entries:
            self.export.copy(entries)

    def _open_menu(self, at: QPoint) -> None:
        index = self.table.indexAt(at)
        if not index.isValid():
            return
        entry = self.model.entry(index.row())
        menu = named("event_menu", QMenu(self))
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(self.tr("Show in the curves"), lambda: self.moment_wanted.emit(entry.at_s))
        if entry.ended_s is not None:
            end_s = entry.ended_s
            menu.addAction(
                self.tr("Show its end in the curves"), lambda: self.moment_wanted.emit(end_s)
            )
        menu.addSeparator()
        menu.addAction(self.tr("Copy"), self.copy_chosen)
        menu.addSeparator()
        menu.addAction(self.tr("Only this kind"), lambda: self.bar.show_only(kind=entry.kind))
        menu.addAction(self.tr("Only this source"), lambda: self.bar.show_only(who=entry.who))
        menu.addAction(self.tr("Show all"), self.bar.show_all)
        menu.popup(self.table.viewport().mapToGlobal(at))

    def _show_message(self, text: str, level: Level) -> None:
        self._message.show_message(text, level)

    def headers(self) -> Mapping[str, QHeaderView]:
        """Return the table's header, whose columns are stored."""
        return {"events": self.table.horizontalHeader()}

    def take_focus(self) -> None:
        """Focus the page: focusing the table would select its first row."""
        self.setFocus()

    # Appearance -------------------------------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Events"))
        self.table.setAccessibleName(self.tr("Events"))
        self.table.setToolTip(self.tr("Double-click: show the moment in the curves"))
        self.model.retranslate()
        self.table.fit_columns()
        self._show_count()
        self._show_detail()

    def _recolor(self) -> None:
        self.model.recolor(colors_of(self))

    def showEvent(self, event: QShowEvent) -> None:
        """Add new events, and scroll to the newest."""
        super().showEvent(event)
        self.refresh()
        self._show_newest()
