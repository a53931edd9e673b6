"""The actions of the editor: their words, keys and places in the menu and the tool bar."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, in_row

_TEXTS: Final[Mapping[str, tuple[object, str]]] = {
    "insert_before": (QT_TRANSLATE_NOOP("EditorAction", "Insert before"), "Ctrl+Shift+Return"),
    "insert_after": (QT_TRANSLATE_NOOP("EditorAction", "Insert after"), "Ctrl+Return"),
    "insert_measured": (QT_TRANSLATE_NOOP("EditorAction", "Insert current pose"), "Ctrl+I"),
    "replace_by_measured": (QT_TRANSLATE_NOOP("EditorAction", "Replace by current pose"), "Ctrl+R"),
    "duplicate": (QT_TRANSLATE_NOOP("EditorAction", "Duplicate"), "Ctrl+D"),
    "delete": (QT_TRANSLATE_NOOP("EditorAction", "Delete"), "Del"),
    "cut": (QT_TRANSLATE_NOOP("EditorAction", "Cut"), "Ctrl+X"),
    "copy": (QT_TRANSLATE_NOOP("EditorAction", "Copy"), "Ctrl+C"),
    "paste": (QT_TRANSLATE_NOOP("EditorAction", "Paste"), "Ctrl+V"),
    "move_up": (QT_TRANSLATE_NOOP("EditorAction", "Move up"), "Alt+Up"),
    "move_down": (QT_TRANSLATE_NOOP("EditorAction", "Move down"), "Alt+Down"),
    "convert": (QT_TRANSLATE_NOOP("EditorAction", "Convert joint angles ↔ pose"), "Ctrl+K"),
    "go_to": (QT_TRANSLATE_NOOP("EditorAction", "Go to this point"), "Ctrl+G"),
    "save": (QT_TRANSLATE_NOOP("EditorAction", "Save"), "Ctrl+S"),
    "undo": (QT_TRANSLATE_NOOP("EditorAction", "Undo"), "Ctrl+Z"),
    "redo": (QT_TRANSLATE_NOOP("EditorAction", "Redo"), "Ctrl+Y"),
    "find": (QT_TRANSLATE_NOOP("EditorAction", "Find and replace"), "Ctrl+F"),
    "check": (QT_TRANSLATE_NOOP("EditorAction", "Check"), "Ctrl+E"),
}

_MENU: Final = (
    ("insert_before", "insert_after", "insert_measured", "replace_by_measured", "duplicate"),
    ("cut", "copy", "paste", "delete"),
    ("move_up", "move_down"),
    ("convert", "go_to"),
    ("find",),
)
"""The right-button menu of the table, in its groups."""

_BAR: Final = ("save", "undo", "redo", "insert_measured", "go_to", "find", "check")

_OF_TABLE: Final = frozenset(name for group in _MENU for name in group) - {"find"}
"""Their keys count while the table has the focus."""


class EditorActions:
    """All actions by name.

    Args:
        window: The editor; the keys of what concerns the whole are its.
        table: The menu is its, and the keys of what concerns rows.
        handlers: What each does.
    """

    def __init__(
        self, window: QWidget, table: QWidget, handlers: Mapping[str, Callable[[], object]]
    ) -> None:
        self._actions: dict[str, QAction] = {}
        for name, (_text, keys) in _TEXTS.items():
            owner = table if name in _OF_TABLE else window
            action = named(f"action_{name}", QAction(owner))
            action.setShortcut(QKeySequence(keys))
            action.triggered.connect(lambda _checked=False, do=handlers[name]: do())
            if name in _OF_TABLE:
                action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            else:
                window.addAction(action)
            self._actions[name] = action
        for group in _MENU:
            for name in group:
                table.addAction(self._actions[name])
            parting = QAction(table)
            parting.setSeparator(True)
            table.addAction(parting)
        self.retranslate()

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def bar(self) -> QHBoxLayout:
        """A row of buttons for the actions used most."""
        buttons = [named(f"editor_{name}", QToolButton()) for name in _BAR]
        for name, button in zip(_BAR, buttons, strict=True):
            button.setDefaultAction(self._actions[name])
        return in_row(*buttons, STRETCH, spacing=6)

    def retranslate(self) -> None:
        """Put every word into the operator's language; tooltips name the keys."""
        for name, action in self._actions.items():
            text = QCoreApplication.translate("EditorAction", str(_TEXTS[name][0]))
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            action.setText(text)
            action.setToolTip(f"{text} ({keys})")
