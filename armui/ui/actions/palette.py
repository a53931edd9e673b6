"""The command palette: finds any command by a part of its name (Ctrl+K)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QAbstractListModel, QEvent, QObject, QRect, QSize, Qt, QTimer
from PySide6.QtGui import QColor, QFontMetrics, QKeyEvent, QPainter, QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QLineEdit,
    QListView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.ui.actions.names import Names, read_names
from armui.ui.actions.palette_items import PaletteItem, PaletteItems, nothing_to_do
from armui.ui.actions.search import SearchText, is_named, rank
from armui.ui.background import Background, Job
from armui.ui.dialogs.base import ArmDialog
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.table_model import Index

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_SIDE_PX: Final = 12
_GAP_PX: Final = 10
_ONE_LINE_PX: Final = 32
_TWO_LINES_PX: Final = 50


_SIZE_PX: Final = (440, 600)
"""The size of the palette: as wide as the panel it covers, so that the picture stays visible."""
_FOLLOW_MS: Final = 200
_TO_THE_LIST: Final = frozenset(
    {Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown}
)


class PaletteModel(QAbstractListModel):
    """The items found by the search, the best first."""

    def __init__(self) -> None:
        super().__init__()
        self._items: list[PaletteItem] = []

    def show_items(self, items: Sequence[PaletteItem]) -> None:
        """Show these items."""
        self.beginResetModel()
        self._items = list(items)
        self.endResetModel()

    def item(self, row: int) -> PaletteItem | None:
        """Return the item of a row, or ``None`` if there is no such row."""
        return self._items[row] if 0 <= row < len(self._items) else None

    def row_of(self, name: str) -> int:
        """Return the row of a command by its name; -1 if it is not listed."""
        rows = (row for row, each in enumerate(self._items) if each.command.name == name)
        return next(rows, -1)

    def rowCount(self, parent: Index | None = None) -> int:  # noqa: N802 - the name Qt calls
        """Return the number of items."""
        return 0 if parent is not None and parent.isValid() else len(self._items)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Return the texts of an item; under ``UserRole`` the item itself."""
        item = self.item(index.row())
        if item is None:
            return None
        if role in {Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole}:
            return "  ".join(filter(None, (item.title, item.place, item.command.keys, item.reason)))
        if role == Qt.ItemDataRole.ToolTipRole:
            return item.reason or None
        return item if role == Qt.ItemDataRole.UserRole else None


class PaletteDelegate(QStyledItemDelegate):
    """Draws title, place and keys in one line, and the reason against the command below."""

    def __init__(self, view: QWidget) -> None:
        super().__init__(view)
        self._view = view

    def sizeHint(self, _option: QStyleOptionViewItem, index: Index) -> QSize:
        """Return a height with room for the reason, if there is one."""
        item: PaletteItem = index.data(Qt.ItemDataRole.UserRole)
        return QSize(200, _TWO_LINES_PX if item.reason else _ONE_LINE_PX)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """Draw a row."""
        item: PaletteItem = index.data(Qt.ItemDataRole.UserRole)
        colors = colors_of(self._view)
        rect: QRect = option.rect
        chosen = index == self._view.currentIndex()  # type: ignore[attr-defined]
        painter.save()
        if chosen:
            painter.fillRect(rect, QColor(colors.accent_pale))
            painter.fillRect(QRect(rect.left(), rect.top(), 3, rect.height()), colors.accent)
        line = QRect(rect.left() + _SIDE_PX, rect.top(), rect.width() - 2 * _SIDE_PX, _ONE_LINE_PX)
        middle = Qt.AlignmentFlag.AlignVCenter
        plain, small = scaled_font(self._view, 1.0), scaled_font(self._view, 0.9)
        if item.command.keys:
            painter.setFont(small)
            painter.setPen(QColor(colors.muted))
            painter.drawText(line, middle | Qt.AlignmentFlag.AlignRight, item.command.keys)
            taken = QFontMetrics(small).horizontalAdvance(item.command.keys) + _GAP_PX
            line.setRight(line.right() - taken)
        painter.setFont(scaled_font(self._view, 1.0, bold=chosen))
        painter.setPen(QColor(colors.muted if item.reason else colors.text))
        metrics = QFontMetrics(painter.font())
        title = metrics.elidedText(item.title, Qt.TextElideMode.ElideRight, line.width())
        painter.drawText(line, middle, title)
        line.setLeft(line.left() + metrics.horizontalAdvance(title) + _GAP_PX)
        painter.setFont(plain)
        painter.setPen(QColor(colors.muted))
        place = QFontMetrics(plain).elidedText(
            item.place, Qt.TextElideMode.ElideRight, max(0, line.width())
        )
        painter.drawText(line, middle, place)
        if item.reason:
            below = rect.adjusted(_SIDE_PX, _ONE_LINE_PX - 6, -_SIDE_PX, -4)
            painter.setFont(small)
            reason = QFontMetrics(small).elidedText(
                item.reason, Qt.TextElideMode.ElideRight, below.width()
            )
            painter.drawText(below, middle, reason)
        painter.restore()


class CommandPalette(ArmDialog):
    """A search field above a list; Enter carries out the chosen command by its own button.

    What moves the arm is not chosen by the search alone, unless its name is typed (S14): a synonym
    may mean something else to the operator.

    It is a window beside the others, and intercepts none of their keys and presses: stop and halt
    work as everywhere, and it has them as well.

    Args:
        controller: Receives the emergency stop, and gives the reasons why something cannot be done.
        items: The commands offered.
        background: Reads the file of names.
        parent: The main window.
    """

    def __init__(
        self,
        controller: ArmController,
        items: PaletteItems,
        background: Background,
        parent: QWidget,
    ) -> None:
        super().__init__(controller, parent)
        self.setObjectName("command_palette")
        self._source = items
        self._names = Names()
        self._later: dict[str, tuple[bool, bool]] = {}
        self._items: list[tuple[PaletteItem, SearchText]] = []
        self._unnamed: set[str] = set()
        self.search = named("palette_search", QLineEdit(clearButtonEnabled=True))
        self.search.installEventFilter(self)
        self.list = named("palette_list", QListView())
        self._model = PaletteModel()
        self.list.setModel(self._model)
        self.list.setItemDelegate(PaletteDelegate(self.list))
        self.list.setUniformItemSizes(False)
        self.list.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._message = named("palette_message", MessageLine())
        fill(self.body, self.search, (self.list, 1), self._message)
        self.resize(*_SIZE_PX)
        self._timer = QTimer(self, interval=_FOLLOW_MS, singleShot=True)
        self._timer.timeout.connect(self._gather)
        controller.operating_state_changed.connect(self._follow)
        self.search.textChanged.connect(self._show_found)
        self.list.activated.connect(self._on_chosen)
        self.list.clicked.connect(self._on_chosen)
        self.list.selectionModel().currentChanged.connect(self._message.hide)
        self.retranslate_ui()
        background.begin_here(Job(self._take_names), read_names)

    # -- what is offered ----------------------------------------------------------------------

    def _take_names(self, names: Names | Refusal) -> None:
        if isinstance(names, Names):
            self._names = names
            if self.isVisible():
                self._gather()

    def _follow(self) -> None:
        if self.isVisible() and not self._timer.isActive():
            self._timer.start()

    def _gather(self) -> None:
        """Update the items and their reasons; the chosen item stays chosen."""
        if not self.isVisible():
            return
        self._items = [(item, self._search_text(item)) for item in self._source.now()]
        self._show_found(keep=True)

    def _search_text(self, item: PaletteItem) -> SearchText:
        command = item.command
        also = () if command.operation is None else (command.operation_title.text(),)
        return self._names.search_text((item.title, *also), item.place, command.synonyms)

    def _show_found(self, *_args: object, keep: bool = False) -> None:
        query = self.search.text()
        before = self._chosen() if keep else None
        told = self._message.isVisible() and before is not None
        if not keep:  # else keep the order: a row must not move while the operator reads it
            self._later = {
                item.command.name: (bool(item.reason), not item.seen) for item, _ in self._items
            }
        self._unnamed = {
            item.command.name
            for item, _ in self._items
            if item.moves
            and not is_named(query, self._names.search_text((item.title,), item.place))
        }
        ranked = [(rank(query, text), place) for place, (_, text) in enumerate(self._items)]
        found = [(self._order(how, place), place) for how, place in ranked if how is not None]
        found.sort()
        self._model.show_items([self._items[place][0] for _, place in found])
        row = -1 if before is None else self._model.row_of(before.command.name)
        first = self._model.item(0)
        if row < 0 and first is not None and first.command.name not in self._unnamed:
            row = 0
        self.list.setCurrentIndex(self._model.index(row, 0))
        chosen = self._chosen()
        if chosen is None:
            self._show_reason(None)
        else:
            # a reason stays visible only while the command that it belongs to is chosen
            same = before is not None and chosen.command.name == before.command.name
            self._message.setVisible(told and same)

    def _order(self, how: tuple[int, ...], place: int) -> tuple[object, ...]:
        """Return the sort key of an item: among equal matches, what can be done now is first.

        What needs a page to be opened comes after what is visible. Dangerous commands are last, and
        before them unnamed ones that move the arm: Enter must not choose one while anything else
        matches.
        """
        command = self._items[place][0].command
        if not self.search.text().strip():
            return (place,)
        *match, length = how
        last = command.dangerous, command.name in self._unnamed
        return *last, match, self._later[command.name], length

    def _chosen(self) -> PaletteItem | None:
        return self._model.item(self.list.currentIndex().row())

    def _show_reason(self, item: PaletteItem | None) -> None:
        """Show the reason against the chosen item, or that nothing was found or chosen."""
        if item is None and self._model.rowCount():
            text = self.tr("It moves the arm: choose it by the arrow keys, or type its name.")
            self._message.show_message(text)
        elif item is None:
            text = self.tr(
                "No command has that name. Search in Chinese, English, pinyin or initials."
            )
            self._message.show_message(text)
        else:
            self._message.show_message(item.reason, Level.WARNING)
        self._message.show()

    # -- what the operator does ---------------------------------------------------------------

    def _on_chosen(self) -> None:
        chosen = self._chosen()
        if chosen is None:
            self._show_reason(None)
            return
        item = self._source.again(chosen)
        was_seen = chosen.seen and item.seen
        if not item.reason and item.must_be_opened:
            item = self._show_page(item)
        if item.reason or not self.isVisible():
            self._show_reason(item)
            return
        self.close()
        self._source.carry_out(item, was_seen=was_seen)

    def _show_page(self, item: PaletteItem) -> PaletteItem:
        """Open the page of an item, and return the item in its new state."""
        item = self._source.show(item)
        self._gather()
        if not item.seen and not item.reason:
            item = replace(item, reason=nothing_to_do())
        if item.reason:
            self.raise_()
            self.activateWindow()
            self.search.setFocus()
        return item

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Handle arrow keys and Enter in the search field: move through the list, carry out."""
        pressed = event.type() == QEvent.Type.KeyPress
        if watched is self.search and pressed and isinstance(event, QKeyEvent):
            if event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}:
                self._on_chosen()
                return True
            if event.key() in _TO_THE_LIST:
                self.list.event(event)
                return True
        return super().eventFilter(watched, event)

    def showEvent(self, event: QShowEvent) -> None:
        """Start a new search at each opening."""
        super().showEvent(event)
        if event.spontaneous():
            return
        self.search.clear()
        self.search.setFocus()
        self._gather()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Commands"))
        self.search.setPlaceholderText(self.tr("Name, pinyin or initials, in Chinese or English"))
        self.search.setAccessibleName(self.tr("Search for a command"))
        self.list.setAccessibleName(self.tr("Commands found"))
        self._gather()
