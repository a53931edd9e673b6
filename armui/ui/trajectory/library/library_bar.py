"""The buttons and the search above the list of the library, and the keys that press them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QAbstractButton, QLineEdit, QMenu, QTableView, QWidget

from armui.trajectory.files import SUFFIXES
from armui.trajectory.library.store import IndexEntry
from armui.ui.actions.act import Act, ActFamily, HasActs
from armui.ui.actions.command import also
from armui.ui.actions.keys import SHORTCUTS, key_text, keys_of, listen_for
from armui.ui.widgets.buttons import give_menu, named
from armui.ui.widgets.flow import Flow

_OF_TABLE: Final = ("edit", "delete", "rename", "duplicate")
"""Actions whose keys count in the list only: in the search field they edit its text."""
_SEARCH_PX: Final = 120


class LibraryBar(HasActs, QWidget):
    """Buttons and a search field, which emit the operator's wishes.

    Signals:
        wanted: The name of a button that was pressed, or of its key.
        export_wanted: A format, by its suffix.
    """

    wanted = Signal(str)
    export_wanted = Signal(str)
    # keys of the list are no shortcuts of these buttons, which would work in the whole window
    _buttons = ActFamily(
        {
            name: Act(
                SHORTCUTS[f"library.{name}"].title,
                named=f"library_{name}",
                key=f"library.{name}",
                shortcut="",
                synonyms=also("open load file csv 打开 文件") if name == "import" else (),
            )
            for name in ("import", "create", "record", "edit", "delete", "duplicate", "rename")
        }
    )
    _export = Act("Export files", named="library_export", key="library.export")

    def __init__(self) -> None:
        super().__init__()
        self._count, self._unsaved, self._kept = 0, False, ""
        self._export_menu = QMenu(self)
        self.search = named("library_search", QLineEdit(clearButtonEnabled=True))
        self.search.setMinimumWidth(_SEARCH_PX)
        self.search.setAcceptDrops(False)  # the page takes dropped files
        self.search.installEventFilter(self)
        layout = Flow(self)
        for button in self.buttons.values():
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the focus in the list
            layout.addWidget(button)
        for suffix in SUFFIXES:
            action = self._export_menu.addAction(suffix)
            action.setData(suffix)
            action.triggered.connect(lambda _on=False, to=suffix: self.export_wanted.emit(to))
        give_menu(self._export, self._export_menu)
        layout.addWidget(self.search)
        self._flow = layout

    @property
    def buttons(self) -> Mapping[str, QAbstractButton]:
        """The buttons by their names."""
        return {**self._buttons, "export": self._export}

    def add_button(self, button: QAbstractButton) -> None:
        """Add a button that does its work by itself."""
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._flow.insert(len(self.buttons), button)

    def add_before_search(self, widget: QWidget) -> None:
        """Add what also says which trajectories are listed."""
        self._flow.insert(self._flow.indexOf(self.search), widget)

    def listen(self, page: QWidget, table: QTableView) -> None:
        """Connect keys to the buttons.

        Args:
            page: The page: most keys count everywhere in its window.
            table: The list: keys for selected rows count in it only.
        """
        for name, button in self._buttons.items():
            owner = table if name in _OF_TABLE else page
            _key(owner, keys_of(f"library.{name}"), owner is table).triggered.connect(button.click)
        _key(table, "Return", True).triggered.connect(self._buttons["edit"].click)
        listen_for("library.find", page, self._on_find, Qt.ShortcutContext.WindowShortcut)
        self._table = table

    def show_chosen(self, entries: Sequence[IndexEntry]) -> None:
        """Enable the actions possible with the selected entries; the others show their reasons."""
        self._count, self._unsaved = len(entries), any(each.kind == "draft" for each in entries)
        self.show_acts()

    def show_kept(self, why: str) -> None:
        """Disable deleting and renaming of the selected entries for a reason; "" enables them."""
        if why != self._kept:
            self._kept = why
            self.show_acts()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Handle keys of the search field: Escape clears it first, Down leads to the list."""
        if watched is self.search and isinstance(event, QKeyEvent):
            pressed = event.type() == QEvent.Type.KeyPress
            if pressed and event.key() == Qt.Key.Key_Escape and self.search.text():
                self.search.clear()
                return True
            if pressed and event.key() in {Qt.Key.Key_Down, Qt.Key.Key_Return, Qt.Key.Key_Enter}:
                self._to_list()
                return True
        return super().eventFilter(watched, event)

    @_buttons.pressed
    def _on_pressed(self, name: str) -> None:
        self.wanted.emit(name)

    def _to_list(self) -> None:
        """Move the focus from the search to the list, and select its first row if none is."""
        self._table.setFocus()
        if not self._count and self._table.model().rowCount():
            self._table.selectRow(0)

    def _on_find(self) -> None:
        self.search.setFocus()
        self.search.selectAll()

    # Texts ------------------------------------------------------------------------------------

    def retranslate(self) -> None:
        """Set all texts in the operator's language."""
        purposes = {
            ".log": self.tr("text to read and edit, as the library keeps it"),
            ".csv": self.tr("for spreadsheets"),
            ".json": self.tr("for scripts and other programs"),
            ".armui": self.tr("for another armui: a double click opens it"),
        }
        for action in self._export_menu.actions():
            action.setText(f"{action.data()} — {purposes[action.data()]}")
        self.search.setPlaceholderText(self.tr("Search"))
        self.search.setAccessibleName(self.tr("Search"))
        text, key = self.tr("Search in names and notes"), key_text("library.find")
        self.search.setToolTip(f"{text} ({key})")
        self.show_acts()

    @_buttons.tip
    def _tip(self, name: str) -> str:
        return f"{self._buttons[name].text()} ({key_text(f'library.{name}')})"

    @_export.why_not
    def _why_not_export(self) -> str:
        return self._why_not("export")

    @_buttons.why_not
    def _why_not(self, name: str) -> str:
        chosen, saved, alone = bool(self._count), not self._unsaved, self._count == 1
        usable = {
            "edit": alone,
            "delete": chosen,
            "export": chosen and saved,
            "duplicate": alone and saved,
            "rename": alone,
        }
        if usable.get(name, True):
            return self._kept if name in {"delete", "rename"} else ""
        if self._unsaved:
            return self.tr("Not saved yet. Open it and save it first")
        if self._count > 1:
            return self.tr("Choose one trajectory alone")
        return self.tr("Choose a trajectory in the list first")


def _key(owner: QWidget, keys: str, alone: bool) -> QAction:
    """Return an action that a key triggers, in a widget alone or in the window that shows it."""
    action = QAction(owner)
    action.setShortcut(QKeySequence(keys))
    context = Qt.ShortcutContext
    action.setShortcutContext(context.WidgetShortcut if alone else context.WindowShortcut)
    owner.addAction(action)
    return action
