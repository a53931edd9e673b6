"""All shortcuts of the program, in one place for keys, tooltips and the list of shortcuts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QT_TRANSLATE_NOOP, Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QWidget

from armui.ui.words.text import Text

_QTS_OWN: Final = (QT_TRANSLATE_NOOP("QShortcut", "Up"), QT_TRANSLATE_NOOP("QShortcut", "Down"))
"""Keys whose names in Qt's translation are longer than their labels; our names are used."""


@dataclass(frozen=True, slots=True)
class Shortcut:
    """Keys, with their effect and their place.

    Attributes:
        name: The name of the action, with its place before the dot.
        keys: The keys as Qt writes them on every system; or a word for what is no single press.
        title: The title of the action.
        by_qt: True if Qt recognises it as one press; otherwise it is only listed.
    """

    name: str
    keys: str
    title: Text
    by_qt: bool = True

    @property
    def place(self) -> str:
        """The key of the place where the keys count."""
        return self.name.partition(".")[0]

    def text(self) -> str:
        """Return the keys in this system's notation."""
        if not self.by_qt:
            return self.keys
        return QKeySequence(self.keys).toString(QKeySequence.SequenceFormat.NativeText)


# fmt: off
_TOLD: Final = frozenset((
    "everywhere.stop", "everywhere.halt", "everywhere.slower", "everywhere.next",
    "everywhere.close", "view.turn", "view.zoom", "view.home", "jogging.joints",
    "jogging.place", "jogging.rotation", "replay.move",
))
"""The names of those that are only listed: something else than a shortcut of Qt's acts on them."""
_LISTED: Final = (
    ("everywhere.palette", "Ctrl+K",
     Text("Shortcut", "Command palette: find every function by its name")),
    ("everywhere.shortcuts", "?", Text("Shortcut", "This list")),
    ("everywhere.guide", "F1", Text("Shortcut", "Help, at the place where you are")),
    ("everywhere.episode", "F6", Text("Shortcut", "Begin or end an episode of the log")),
    ("everywhere.discard_episode", "Shift+F6", Text("Shortcut", "Discard the last episode")),
    ("everywhere.faster", "F7", Text("Shortcut", "Faster: run or motion")),
    ("everywhere.slower", "F8", Text("Shortcut", "Slower: run or motion")),
    ("everywhere.halt", "F9",
     Text("Shortcut", "Halt: ends any motion, the motors keep their power")),
    ("everywhere.full_screen", "F11", Text("Action", "Full screen")),
    ("everywhere.stop", "F12, Pause", Text("StopButton", "Emergency stop")),
    ("everywhere.next", "Tab",
     Text("Shortcut", "To the next control; with Shift to the one before")),
    ("everywhere.close", "Esc", Text("Shortcut", "Close the dialog")),
    ("window.settings", "Ctrl+,", Text("MenuFoot", "Settings")),
    ("window.reset_view", "Ctrl+0", Text("MenuFoot", "Reset view")),
    ("view.front", "Ctrl+1", Text("ViewBar", "Front view")),
    ("view.side", "Ctrl+2", Text("ViewBar", "Side view")),
    ("view.top", "Ctrl+3", Text("ViewBar", "Top view")),
    ("view.below", "Ctrl+Alt+3", Text("ViewBar", "View from below")),
    ("view.iso", "Ctrl+4", Text("ViewBar", "Oblique view")),
    ("view.fit", "Ctrl+9", Text("ViewBar", "Fit")),
    ("view.follow", "Ctrl+5", Text("ViewBar", "Follow the tool")),
    ("view.orthographic", "Ctrl+6", Text("ViewBar", "Parallel projection")),
    ("view.tool_frame", "Ctrl+7", Text("ViewBar", "Tool frame")),
    ("view.reach", "Ctrl+8", Text("ViewBar", "Workspace")),
    ("view.area", "Ctrl+Alt+A", Text("ViewBar", "Work area")),
    ("view.frames", "Ctrl+Alt+F", Text("ViewBar", "User frames")),
    ("view.save", "Ctrl+Alt+S", Text("ViewBar", "Save picture…")),
    ("view.copy", "Ctrl+Alt+C", Text("ViewBar", "Copy picture")),
    ("view.handles", "Ctrl+Shift+D", Text("ViewBar", "Drag the target in the picture")),
    ("view.turn", "← → ↑ ↓", Text("Shortcut", "Turn the view")),
    ("view.zoom", "+  −", Text("Shortcut", "Zoom in and out")),
    ("view.home", "Home", Text("Shortcut", "The first view again")),
    ("jogging.joints", "Q…Y, A…H", Text("Shortcut", "With Space held: J1 to J6 up, down")),
    ("jogging.place", "↑ ↓ ← → PgUp PgDn",
     Text("Shortcut", "With Space held: X, Y, Z of the tool")),
    ("jogging.rotation", "Q…E, A…D", Text("Shortcut", "With Space held: RX, RY, RZ of the tool")),
    ("motion.home", "Ctrl+Shift+H", Text("MotionPanel", "Home")),
    ("motion.load", "Ctrl+L", Text("MotionPanel", "Take current")),
    ("motion.send", "Ctrl+Return", Text("MotionPanel", "Send")),
    ("light.confirm", "Ctrl+Return", Text("LightPanel", "Send colour")),
    ("gripper.send", "Ctrl+Return", Text("GripperPanel", "Send")),
    ("parameters.save", "Ctrl+Return", Text("ParameterButtons", "Save")),
    ("parameters.cancel", "Esc", Text("ParameterButtons", "Cancel")),
    ("library.import", "Ctrl+O", Text("LibraryBar", "Import files")),
    ("library.create", "Ctrl+N", Text("LibraryBar", "Create")),
    ("library.record", "Ctrl+R", Text("LibraryBar", "Record motion")),
    ("library.edit", "Enter", Text("LibraryBar", "Edit")),
    ("library.delete", "Del", Text("LibraryBar", "Delete")),
    ("library.duplicate", "Ctrl+D", Text("LibraryBar", "Duplicate")),
    ("library.rename", "F2", Text("LibraryBar", "Rename")),
    ("library.find", "Ctrl+F", Text("LibraryBar", "Search")),
    ("library.send", "F5", Text("RunBar", "Run")),
    ("library.undo", "Ctrl+Z", Text("EditorAction", "Undo")),
    ("editor.insert_before", "Ctrl+Shift+Return", Text("EditorAction", "Insert before")),
    ("editor.insert_after", "Ctrl+Return", Text("EditorAction", "Insert after")),
    ("editor.insert_measured", "Ctrl+I", Text("EditorAction", "Insert current pose")),
    ("editor.replace_by_measured", "Ctrl+R", Text("EditorAction", "Replace with current pose")),
    ("editor.duplicate", "Ctrl+D", Text("EditorAction", "Duplicate")),
    ("editor.delete", "Del", Text("EditorAction", "Delete")),
    ("editor.cut", "Ctrl+X", Text("EditorAction", "Cut")),
    ("editor.copy", "Ctrl+C", Text("EditorAction", "Copy")),
    ("editor.paste", "Ctrl+V", Text("EditorAction", "Paste")),
    ("editor.move_up", "Alt+Up", Text("EditorAction", "Move up")),
    ("editor.move_down", "Alt+Down", Text("EditorAction", "Move down")),
    ("editor.convert", "Ctrl+Shift+K", Text("EditorAction", "Convert joint angles ↔ pose")),
    ("editor.frame", "Ctrl+Shift+F", Text("EditorAction", "User frame…")),
    ("editor.go_to", "Ctrl+G", Text("EditorAction", "Go to this point")),
    ("editor.save", "Ctrl+S", Text("EditorAction", "Save")),
    ("editor.undo", "Ctrl+Z", Text("EditorAction", "Undo")),
    ("editor.redo", "Ctrl+Y", Text("EditorAction", "Redo")),
    ("editor.find", "Ctrl+F", Text("EditorAction", "Find and replace")),
    ("editor.jog", "Ctrl+J", Text("EditorAction", "Jog")),
    ("editor.check", "Ctrl+E", Text("EditorAction", "Check")),
    ("editor.preview", "Ctrl+Shift+E", Text("EditorAction", "Preview")),
    ("editor.send", "F5", Text("RunBar", "Run")),
    ("plots.undo", "Ctrl+Z", Text("PlotBar", "Undo zoom")),
    ("bus.pause", "Ctrl+P", Text("Shortcut", "Pause, continue")),
    ("bus.copy", "Ctrl+C", Text("Shortcut", "Copy the chosen rows")),
    ("events.copy", "Ctrl+C", Text("Shortcut", "Copy the chosen rows")),
    ("replay.play", "Space", Text("Shortcut", "Play, pause")),
    ("replay.step_back", ",", Text("Shortcut", "One frame back")),
    ("replay.step", ".", Text("Shortcut", "One frame on")),
    ("replay.previous_fault", "Shift+N", Text("Transport", "Previous fault")),
    ("replay.next_fault", "N", Text("Transport", "Next fault")),
    ("replay.copy", "Ctrl+C", Text("Shortcut", "Copy the chosen rows")),
    ("replay.move", "← →, Home, End", Text("Shortcut", "On the timeline: through the recording")),
)

# fmt: on

SHORTCUTS: Final[Mapping[str, Shortcut]] = {
    name: Shortcut(name, keys, title, by_qt=name not in _TOLD) for name, keys, title in _LISTED
}
"""The shortcuts by their names."""


def keys_of(name: str) -> str:
    """Return the keys of an action, as Qt writes them on every system.

    Raises:
        KeyError: No shortcut has the name.
    """
    return SHORTCUTS[name].keys


def listen_for(
    name: str,
    place: QWidget,
    act: Callable[[], object],
    context: Qt.ShortcutContext = Qt.ShortcutContext.WidgetWithChildrenShortcut,
) -> QShortcut:
    """Connect the keys of an action to a function, and return the shortcut.

    Args:
        name: The name of the action.
        place: The widget in which they count.
        act: The function.
        context: How far around that widget they count.
    """
    shortcut = QShortcut(QKeySequence(keys_of(name)), place)
    shortcut.setContext(context)
    shortcut.activated.connect(act)
    return shortcut


def key_text(name: str) -> str:
    """Return the keys of an action in this system's notation; empty if it has none."""
    shortcut = SHORTCUTS.get(name)
    return "" if shortcut is None else shortcut.text()
