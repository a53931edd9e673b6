"""The actions of the editor: their texts, keys and places in the menu and the tool bar."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QTableView, QToolButton, QWidget

from armui.ui.actions.keys import SHORTCUTS, keys_of
from armui.ui.widgets.buttons import enable_or_explain, named, push_button
from armui.ui.widgets.flow import Flow, in_flow
from armui.ui.widgets.table_model import TableHint

NAMES: Final = tuple(
    each.name.removeprefix("editor.")
    for each in SHORTCUTS.values()
    if each.place == "editor" and each.name != "editor.send"
)
"""The names of the actions. The key of 发送 belongs to the button below the table."""

_MENU: Final = (
    ("insert_before", "insert_after", "insert_measured", "replace_by_measured", "duplicate"),
    ("cut", "copy", "paste", "delete"),
    ("move_up", "move_down"),
    ("convert", "frame", "go_to"),
    ("find",),
)
"""The right-button menu of the table, in its groups."""

_BAR: Final = (
    *("save", "undo", "redo", "insert_measured", "jog", "go_to", "find"),
    *("insert_after", "duplicate", "delete", "move_up", "move_down"),
)

_EVERYWHERE: Final = "insert_measured"
"""The action whose key counts in every window, so that jogging and inserting need no change of
window.
"""

_OF_WINDOW: Final = frozenset({"save", "find", "jog", "check", "preview"})
"""Actions whose keys count anywhere in the editor's window. Undo is not among them: the focused
widget may have something of its own to undo.
"""

_OF_TABLE: Final = frozenset(name for group in _MENU for name in group) - {"find"}
"""Actions whose keys count while the table has the focus."""


class EditorActions:
    """All actions of the editor by name.

    Args:
        page: The editor; keys of actions on the whole count in it, or in its window.
        table: The table, which has the menu, and the keys of actions on rows.
        handlers: The function of each action.
    """

    def __init__(
        self, page: QWidget, table: QWidget, handlers: Mapping[str, Callable[[], object]]
    ) -> None:
        self._actions: dict[str, QAction] = {}
        self._buttons: dict[str, QToolButton] = {}
        for name in NAMES:
            owner = table if name in _OF_TABLE else page
            action = named(f"action_{name}", QAction(owner))
            if name != _EVERYWHERE:
                action.setShortcut(self.keys(name))
            action.triggered.connect(lambda _checked=False, do=handlers[name]: do())
            in_window = name in _OF_WINDOW
            context = Qt.ShortcutContext
            action.setShortcutContext(
                context.WindowShortcut if in_window else context.WidgetWithChildrenShortcut
            )
            if name not in _OF_TABLE:
                page.addAction(action)
            self._actions[name] = action
        for group in _MENU:
            for name in group:
                table.addAction(self._actions[name])
            parting = QAction(table)
            parting.setSeparator(True)
            table.addAction(parting)
        self._actions["jog"].setCheckable(True)
        self.retranslate()

    @staticmethod
    def keys(name: str) -> QKeySequence:
        """Return the key of an action as set in `SHORTCUTS`."""
        return QKeySequence(keys_of(f"editor.{name}"))

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def bar(self, *more: QWidget) -> Flow:
        """Return a row of buttons for the actions used most.

        Args:
            more: Further widgets after them.
        """
        return in_flow(*map(self.button, _BAR), *more)

    def button(self, name: str) -> QToolButton:
        """Return a new button for an action."""
        button = self._buttons[name] = named(f"editor_{name}", QToolButton())
        button.setDefaultAction(self._actions[name])
        button.setProperty("choice", self._actions[name].isCheckable())
        return button

    def targets(self) -> dict[str, QAction | QToolButton]:
        """Return the target of each action by its name: a button if the bar has one."""
        return {**self._actions, **self._buttons}

    def allow(self, name: str, reason: str, what: str = "") -> None:
        """Enable an action, or disable it with the reason in its tooltip.

        Args:
            name: The name of the action.
            reason: The reason; empty to enable it.
            what: The edit that it undoes or redoes.
        """
        action = self._actions[name]
        quoted = f" “{what}”" if what else ""
        keys = SHORTCUTS[f"editor.{name}"].text()
        enable_or_explain(action, reason, f"{action.text()}{quoted} ({keys})")

    def retranslate(self) -> None:
        """Set all texts in the operator's language; tooltips name the keys."""
        for name, action in self._actions.items():
            shortcut = SHORTCUTS[f"editor.{name}"]
            action.setText(shortcut.title.text())
            action.setIconText(action.text())
            action.setToolTip(f"{action.text()} ({shortcut.text()})")


_HINT_NAMES: Final = ("insert_measured", "insert_after")


class EditorHint(TableHint):
    """Explains how to make the first point: from the arm's position, or by figures.

    Args:
        table: The table.
        actions: The actions that insert a point: the arm's position, or one to be filled in.
    """

    def __init__(self, table: QTableView, actions: EditorActions) -> None:
        self._actions = actions
        self._buttons = [push_button(f"hint_{name}", on_enter=False) for name in _HINT_NAMES]
        super().__init__(table, "editor_hint", *self._buttons)
        for button, name in zip(self._buttons, _HINT_NAMES, strict=True):
            button.clicked.connect(lambda _checked=False, name=name: actions[name].trigger())
        table.model().rowsInserted.connect(self._show_if_empty)
        table.model().rowsRemoved.connect(self._show_if_empty)
        table.model().modelReset.connect(self._show_if_empty)
        # the opened jog box has a button with the same effect
        actions["jog"].toggled.connect(self._buttons[0].setHidden)
        self.retranslate_ui()
        self._show_if_empty()

    def _show_if_empty(self) -> None:
        self.setVisible(self._table.model().rowCount() == 0)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        texts = (self.tr("Insert current pose"), self.tr("Enter a point"))
        for button, name, text in zip(self._buttons, _HINT_NAMES, texts, strict=True):
            keys = self._actions.keys(name)
            button.setText(f"{text}  ({keys.toString(keys.SequenceFormat.NativeText)})")
            button.setAccessibleName(text)
        self.set_texts(
            self.tr("No points yet"),
            self.tr(
                "Bring the arm to the first point, by the jog buttons or by hand, and insert where "
                "it is. Or enter a point as figures. Then the next one."
            ),
        )
