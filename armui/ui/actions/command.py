"""Something that the command palette can do, and why that is not possible now."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from PySide6.QtCore import QCoreApplication

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, Operation
from armui.ui import words
from armui.ui.actions.keys import SHORTCUTS
from armui.ui.words.text import Text

Reason = Callable[[OperatingState], str]
"""Returns in words why something cannot be done now; empty: it can."""


def always(_now: OperatingState) -> str:
    """Return no reason: it can be done whatever the arm does."""
    return ""


def while_editing(_now: OperatingState) -> str:
    """Say what must be done before parameters can be saved or given up."""
    return QCoreApplication.translate("Action", "Press Edit in the panel first.")


def with_angles(now: OperatingState) -> str:
    """Say that the joint angles must be heard first."""
    return words.why_not(None if now.angles_known else Refusal(RefusalCode.JOINTS_UNKNOWN))


def with_pose(now: OperatingState) -> str:
    """Say that the pose of the flange must be heard first."""
    return words.why_not(None if now.pose_known else Refusal(RefusalCode.POSE_UNKNOWN))


class Command(NamedTuple):
    """Something that can be done.

    Attributes:
        name: Its own, with its place before the dot; of its shortcut, too, if it has one.
        called: What the palette calls it; ``None``: as the list of shortcuts does.
        target: The object name of the button that does it, or of the field it leads to. Empty: the
            window does it.
        does: The operation that it carries out, or why it cannot be done, where it is none.
        arguments: Those of the operation that its reason depends on.
        leads: It is only led to while its page is not seen, as an operation that is shown first.
        risky: Nobody should come upon it by mistake, as upon an operation that asks first.
    """

    name: str
    called: Text | None = None
    target: str = ""
    does: Operation | Reason = always
    arguments: Mapping[str, object] = MappingProxyType({})
    leads: bool = False
    risky: bool = False

    def why_not(self, now: OperatingState) -> str:
        """Return in words why it cannot be done where its button is not seen; empty: it can."""
        if isinstance(self.does, Operation):
            return words.why_not(self.does.why_not(now, **self.arguments))
        return self.does(now)

    @property
    def shown_first(self) -> bool:
        """Whether it is never done where the operator has not seen its page."""
        return self.leads or (isinstance(self.does, Operation) and self.does.shown_first)

    @property
    def dangerous(self) -> bool:
        """Whether it may lose a zero, a setting, or the power that holds the arm."""
        asks = isinstance(self.does, Operation) and self.does.consent is Consent.PRESS
        return self.risky or asks

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
