"""The list of everything that can be drawn, by groups; entries are dragged into plots."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QModelIndex, QSortFilterProxyModel, Qt, Signal
from PySide6.QtGui import QColor, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QAbstractItemView, QLineEdit, QTreeView, QWidget

from armui.telemetry.quantities import QUANTITIES, Source
from armui.ui.theme import colors_of
from armui.ui.watch.plot_pane import carry_away
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.translated import Translated
from armui.ui.words import quantities as names

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent

    from armui.telemetry.store import Telemetry

KEYS_ROLE: Final = Qt.ItemDataRole.UserRole
"""The role of an entry's keys; a group has those of all its entries."""
_LOOK_MS: Final = 1000
_WIDTH_PX: Final = 250


class _Tree(QTreeView):
    """A tree whose entries are dragged as the keys of their quantities."""

    def startDrag(self, _actions: Qt.DropAction) -> None:  # noqa: N802 - the name Qt calls
        """Drag the selected quantities."""
        keys: list[str] = []
        for index in self.selectedIndexes():
            keys += index.data(KEYS_ROLE) or ()
        if keys:
            carry_away(self, list(dict.fromkeys(keys)))


class QuantityList(Translated, QWidget):
    """A search field over a tree; quantities never received are muted.

    Args:
        telemetry: Gives the series.

    Signals:
        wanted: The keys that were double-clicked, or chosen with Enter.
    """

    wanted = Signal(object)

    def __init__(self, telemetry: Telemetry, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._telemetry = telemetry
        self._items: dict[str, QStandardItem] = {}
        self._groups: list[tuple[QStandardItem, str]] = []
        self.search = named("quantity_search", QLineEdit(clearButtonEnabled=True))
        self._model = QStandardItemModel(self)
        self._shown = QSortFilterProxyModel(
            self, recursiveFilteringEnabled=True, autoAcceptChildRows=True
        )
        self._shown.setFilterCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        self.tree = named("quantity_tree", _Tree())
        self.tree.setHeaderHidden(True)
        self.tree.setUniformRowHeights(True)
        self.tree.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.tree.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.tree.setDragDropMode(QAbstractItemView.DragDropMode.DragOnly)
        self.tree.setExpandsOnDoubleClick(False)
        in_column(self.search, (self.tree, 1), on=self, spacing=6, margins=0)
        self.setFixedWidth(_WIDTH_PX)
        self._fill()
        self.search.textChanged.connect(self._on_search)
        self.tree.activated.connect(self._on_activated)
        self._timer = SeenTimer(self, _LOOK_MS, self.show_heard)
        self.retranslate_ui()
        # set after filling and naming: each change of the model costs filter and tree a search
        self._shown.setSourceModel(self._model)
        self.tree.setModel(self._shown)
        self.tree.expandToDepth(0)

    def _fill(self) -> None:
        """Add all quantities, grouped by source, then by kind, with the joints as leaves."""
        tops: dict[Source, QStandardItem] = {}
        kinds: dict[tuple[Source, str], QStandardItem] = {}
        for each in QUANTITIES.values():
            if each.source not in tops:
                tops[each.source] = self._group("", each.source)
                self._model.appendRow(tops[each.source])
            parent = tops[each.source]
            if each.number is not None:
                place = (each.source, each.kind)
                if place not in kinds:
                    kinds[place] = self._group(each.key, each.source)
                    parent.appendRow(kinds[place])
                parent = kinds[place]
                parent.setData([*parent.data(KEYS_ROLE), each.key], KEYS_ROLE)
            item = QStandardItem()
            item.setData([each.key], KEYS_ROLE)
            self._items[each.key] = item
            parent.appendRow(item)
        for top in tops.values():
            top.setFlags(Qt.ItemFlag.ItemIsEnabled)

    def _group(self, first: str, source: Source) -> QStandardItem:
        """Return a group's entry; `first` is its first key, or "" for a whole source."""
        item = QStandardItem()
        item.setData([], KEYS_ROLE)
        self._groups.append((item, first or source.value))
        return item

    def retranslate_ui(self) -> None:
        """Set all names in the operator's language."""
        self.search.setPlaceholderText(self.tr("Search"))
        self.search.setAccessibleName(self.tr("Search"))
        self.tree.setAccessibleName(self.tr("Quantities"))
        self.tree.setToolTip(self.tr("Drag into a plot, or double-click to add to the chosen one"))
        for item, first in self._groups:
            if first in QUANTITIES:
                item.setText(names.quantity_kind(QUANTITIES[first]))
            else:
                item.setText(names.quantity_group(Source(first)))
        for key, item in self._items.items():
            item.setText(names.quantity(QUANTITIES[key]))
            item.setToolTip(item.text())
        self.tree.expandToDepth(0)
        self.show_heard()

    def show_heard(self) -> None:
        """Mute quantities that were never received."""
        colors = colors_of(self)
        heard, never = QColor(colors.text), QColor(colors.faint)
        said = {name: series.count > 0 for name, series in self._telemetry.series.items()}
        for key, item in self._items.items():
            color = heard if said[QUANTITIES[key].series] else never
            if item.foreground().color() != color:
                item.setForeground(color)

    def index_of(self, key: str) -> QModelIndex:
        """Return the index of a quantity in the tree, after expanding it."""
        index = self._shown.mapFromSource(self._items[key].index())
        self.tree.expand(index.parent())
        self.tree.scrollTo(index)
        return index

    def _on_search(self, text: str) -> None:
        self._shown.setFilterFixedString(text)
        if text:
            self.tree.expandAll()
        else:
            self.tree.collapseAll()
            self.tree.expandToDepth(0)

    def _on_activated(self, index: QModelIndex) -> None:
        keys: Iterable[str] = index.data(KEYS_ROLE) or ()
        if keys:
            self.wanted.emit(list(keys))

    def showEvent(self, event: QShowEvent) -> None:
        """Update the muted entries."""
        super().showEvent(event)
        self.show_heard()

    def _recolor(self) -> None:
        self.show_heard()
