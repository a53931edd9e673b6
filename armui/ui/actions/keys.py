"""Every shortcut of the program, once: what presses, what tooltips say and what the list shows."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final, NamedTuple

from PySide6.QtCore import QT_TRANSLATE_NOOP
from PySide6.QtGui import QKeySequence

from armui.ui.actions.places import Title


class Shortcut(NamedTuple):
    """Keys, and what they do where.

    Attributes:
        name: Of the action, with its place before the dot.
        keys: As Qt writes them on every system; or a word, if no single press does it.
        title: What they do.
        by_qt: Whether it is one press that Qt tells apart; else it is only told of here.
    """

    name: str
    keys: str
    title: Title
    by_qt: bool = True

    @property
    def place(self) -> str:
        """Where they count, a key of :data:`armui.ui.actions.places.PLACES`."""
        return self.name.partition(".")[0]

    def text(self) -> str:
        """The keys as this system writes them."""
        if not self.by_qt:
            return self.keys
        return QKeySequence(self.keys).toString(QKeySequence.SequenceFormat.NativeText)


_QTS_OWN: Final = (QT_TRANSLATE_NOOP("QShortcut", "Up"), QT_TRANSLATE_NOOP("QShortcut", "Down"))
"""Keys whose names in Qt's translation are longer than what is printed on them: ours counts."""


# fmt: off
_ONE_PRESS: Final = (
    ("everywhere.palette", "Ctrl+K", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "Command palette: find every function by its name")),
    ("everywhere.guide", "F1", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "User guide, at the place where you are")),
    ("everywhere.shortcuts", "?", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "This list")),
    ("window.settings", "Ctrl+,", "ViewRegion", QT_TRANSLATE_NOOP("ViewRegion", "Settings")),
    ("window.reset_view", "Ctrl+0", "ViewRegion", QT_TRANSLATE_NOOP("ViewRegion", "Reset view")),
    ("view.front", "Ctrl+1", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Front view")),
    ("view.side", "Ctrl+2", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Side view")),
    ("view.top", "Ctrl+3", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Top view")),
    ("view.iso", "Ctrl+4", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Oblique view")),
    ("view.fit", "Ctrl+9", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Fit")),
    ("view.follow", "Ctrl+5", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Follow the tool")),
    ("view.orthographic", "Ctrl+6", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Without perspective")),
    ("view.tool_frame", "Ctrl+7", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Tool frame")),
    ("view.reach", "Ctrl+8", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Workspace")),
    ("view.save", "Ctrl+Alt+S", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Save picture…")),
    ("view.copy", "Ctrl+Alt+C", "ViewBar", QT_TRANSLATE_NOOP("ViewBar", "Copy picture")),
    ("view.handles", "Ctrl+Shift+D", "ViewBar",
     QT_TRANSLATE_NOOP("ViewBar", "Drag the target in the picture")),
    ("motion.home", "Ctrl+Shift+H", "MotionPanel", QT_TRANSLATE_NOOP("MotionPanel", "Home")),
    ("motion.load", "Ctrl+L", "MotionPanel", QT_TRANSLATE_NOOP("MotionPanel", "Load")),
    ("motion.send", "Ctrl+Return", "MotionPanel", QT_TRANSLATE_NOOP("MotionPanel", "Send")),
    ("light.confirm", "Ctrl+Return", "LightPanel", QT_TRANSLATE_NOOP("LightPanel", "Confirm")),
    ("gripper.send", "Ctrl+Return", "GripperPanel", QT_TRANSLATE_NOOP("GripperPanel", "Send")),
    ("parameters.save", "Ctrl+Return", "ParameterButtons",
     QT_TRANSLATE_NOOP("ParameterButtons", "Save")),
    ("parameters.cancel", "Esc", "ParameterButtons",
     QT_TRANSLATE_NOOP("ParameterButtons", "Cancel")),
    ("library.import", "Ctrl+O", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Import files")),
    ("library.create", "Ctrl+N", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Create")),
    ("library.record", "Ctrl+R", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Record")),
    ("library.delete", "Del", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Delete")),
    ("library.duplicate", "Ctrl+D", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Duplicate")),
    ("library.rename", "F2", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Rename")),
    ("library.find", "Ctrl+F", "LibraryBar", QT_TRANSLATE_NOOP("LibraryBar", "Search")),
    ("library.send", "F5", "RunBar", QT_TRANSLATE_NOOP("RunBar", "Send")),
    ("library.undo", "Ctrl+Z", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Undo")),
    ("editor.insert_before", "Ctrl+Shift+Return", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Insert before")),
    ("editor.insert_after", "Ctrl+Return", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Insert after")),
    ("editor.insert_measured", "Ctrl+I", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Insert current pose")),
    ("editor.replace_by_measured", "Ctrl+R", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Replace by current pose")),
    ("editor.duplicate", "Ctrl+D", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Duplicate")),
    ("editor.delete", "Del", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Delete")),
    ("editor.cut", "Ctrl+X", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Cut")),
    ("editor.copy", "Ctrl+C", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Copy")),
    ("editor.paste", "Ctrl+V", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Paste")),
    ("editor.move_up", "Alt+Up", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Move up")),
    ("editor.move_down", "Alt+Down", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Move down")),
    ("editor.convert", "Ctrl+Shift+K", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Convert joint angles ↔ pose")),
    ("editor.go_to", "Ctrl+G", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Go to this point")),
    ("editor.save", "Ctrl+S", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Save")),
    ("editor.undo", "Ctrl+Z", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Undo")),
    ("editor.redo", "Ctrl+Y", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Redo")),
    ("editor.find", "Ctrl+F", "EditorAction",
     QT_TRANSLATE_NOOP("EditorAction", "Find and replace")),
    ("editor.jog", "Ctrl+J", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Jog")),
    ("editor.check", "Ctrl+E", "EditorAction", QT_TRANSLATE_NOOP("EditorAction", "Check")),
    ("editor.send", "F5", "RunBar", QT_TRANSLATE_NOOP("RunBar", "Send")),
    ("plots.undo", "Ctrl+Z", "PlotBar", QT_TRANSLATE_NOOP("PlotBar", "Undo zoom")),
    ("bus.pause", "Ctrl+P", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "Pause, go on")),
    ("bus.copy", "Ctrl+C", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "Copy the chosen rows")),
    ("events.copy", "Ctrl+C", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "Copy the chosen rows")),
    ("replay.play", "Space", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "Play, pause")),
    ("replay.step_back", ",", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "One frame back")),
    ("replay.step", ".", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "One frame on")),
    ("replay.previous_fault", "Shift+N", "Transport",
     QT_TRANSLATE_NOOP("Transport", "Previous fault")),
    ("replay.next_fault", "N", "Transport", QT_TRANSLATE_NOOP("Transport", "Next fault")),
    ("replay.copy", "Ctrl+C", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "Copy the chosen rows")),
)

_TOLD: Final = (
    ("everywhere.stop", "F12, Pause", "StopButton",
     QT_TRANSLATE_NOOP("StopButton", "Emergency stop")),
    ("everywhere.halt", "F9", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "Halt: ends any motion, the motors keep their power")),
    ("everywhere.next", "Tab", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "To the next control; with Shift to the one before")),
    ("everywhere.close", "Esc", "Shortcut", QT_TRANSLATE_NOOP("Shortcut", "Close the dialog")),
    ("view.turn", "← → ↑ ↓", "Help", QT_TRANSLATE_NOOP("Help", "Turn the view")),
    ("view.zoom", "+  −", "Help", QT_TRANSLATE_NOOP("Help", "Zoom in and out")),
    ("view.home", "Home", "Help", QT_TRANSLATE_NOOP("Help", "The first view again")),
    ("jogging.joints", "Q…Y, A…H", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "With Space held: J1 to J6 up, down")),
    ("jogging.place", "↑ ↓ ← → PgUp PgDn", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "With Space held: X, Y, Z of the tool")),
    ("jogging.rotation", "Q…E, A…D", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "With Space held: RX, RY, RZ of the tool")),
    ("library.edit", "Enter", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "Edit the points of the chosen trajectory")),
    ("replay.move", "← →, Home, End", "Shortcut",
     QT_TRANSLATE_NOOP("Shortcut", "On the time line: through the recording")),
)
# fmt: on

SHORTCUTS: Final[Mapping[str, Shortcut]] = {
    **{
        name: Shortcut(name, keys, Title(context, str(source)))
        for name, keys, context, source in _ONE_PRESS
    },
    **{
        name: Shortcut(name, keys, Title(context, str(source)), by_qt=False)
        for name, keys, context, source in _TOLD
    },
}
"""By their names."""


def keys_of(name: str) -> str:
    """The keys of an action, as Qt writes them on every system.

    Raises:
        KeyError: No shortcut has the name.
    """
    return SHORTCUTS[name].keys


def key_text(name: str) -> str:
    """The keys of an action as they are written on this system; empty: it has none."""
    shortcut = SHORTCUTS.get(name)
    return "" if shortcut is None else shortcut.text()
