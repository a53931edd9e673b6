"""Something that the command palette can do, and what that needs."""

from __future__ import annotations

import enum
from typing import NamedTuple

from armui.ui.actions.keys import SHORTCUTS
from armui.ui.words.text import Text


class Need(enum.Enum):
    """What must be so before something can be done; see :mod:`armui.ui.actions.reasons`."""

    NOTHING = enum.auto()
    MOVE = enum.auto()
    SWITCH_ON = enum.auto()
    SWITCH_OFF = enum.auto()
    ZERO = enum.auto()
    CLEAR = enum.auto()
    ANGLES = enum.auto()
    POSE = enum.auto()
    LAMPS = enum.auto()
    LINKAGE = enum.auto()
    REACH = enum.auto()
    REACH_FREE = enum.auto()
    SETTINGS = enum.auto()
    SETTINGS_FREE = enum.auto()
    EDITING = enum.auto()
    GRIPPER_MOVE = enum.auto()
    GRIPPER = enum.auto()
    GRIPPER_LET_GO = enum.auto()
    TEACHING = enum.auto()
    PLAN = enum.auto()


class Command(NamedTuple):
    """Something that can be done.

    Attributes:
        name: Its own, with its place before the dot; of its shortcut, too, if it has one.
        called: What the palette calls it; ``None``: as the list of shortcuts does.
        target: The object name of the button that does it, or of the field it leads to. Empty: the
            window does it.
        need: What must be so where its button is not seen.
    """

    name: str
    called: Text | None = None
    target: str = ""
    need: Need = Need.NOTHING

    @property
    def title(self) -> Text:
        """What the palette calls it."""
        return self.called or SHORTCUTS[self.name].title

    @property
    def place(self) -> str:
        """Where it is done, a key of :data:`armui.ui.actions.places.PLACES`."""
        return self.name.partition(".")[0]

    @property
    def keys(self) -> str:
        """Its shortcut as this system writes it; empty: it has none."""
        shortcut = SHORTCUTS.get(self.name)
        return "" if shortcut is None else shortcut.text()
