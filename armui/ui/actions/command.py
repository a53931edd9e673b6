"""The commands that panels, pages and windows hand to the command palette."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Protocol

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget

from armui.control.motion.cartesian import POSE_UNKNOWN
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, Operation
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.ui import words
from armui.ui.actions.keys import SHORTCUTS
from armui.ui.words.text import Text

Target = QWidget | QAction
"""Carries out a command: a button, a field that it leads to, or an action."""
Reason = Callable[[OperatingState], str]
"""Returns in words why something cannot be done now; empty: it can."""


def no_reason(*_: object) -> str:
    """Return no reason: nothing stands in the way."""
    return ""


def while_editing(_now: OperatingState) -> str:
    """Say what must be done before parameters can be saved or given up."""
    return QCoreApplication.translate("Action", "Press Edit in the panel first.")


def with_angles(now: OperatingState) -> str:
    """Say that the joint angles must be heard first."""
    return words.why_not(None if now.angles_known else JOINTS_UNKNOWN())


def with_pose(now: OperatingState) -> str:
    """Say that the pose of the flange must be heard first."""
    return words.why_not(None if now.pose_known else POSE_UNKNOWN())


@dataclass(frozen=True, slots=True)
class Command:
    """A command of a panel, page or window, declared before that is made.

    Attributes:
        name: Its stable name: the key of its place, a dot, the act; also that of its shortcut.
        own_title: The title in the palette; ``None``: that of its shortcut or of its operation.
        operation: The operation on the arm that it carries out, if it is one.
        arguments: The arguments of the operation that its reason depends on.
        needs: Tells from the operating state what is missing while its target is not seen.
        leads: It is only led to while its page is not seen, as an operation that is shown first.
        presses: Whether its button is pressed; else it is only led to, seen or not.
        risky: It never comes first in the list, as an operation that asks first.
        synonyms: Other names of it in both languages; see :func:`also`.
    """

    name: str
    own_title: Text | None = None
    operation: Operation | None = None
    arguments: Mapping[str, object] = field(default_factory=dict)
    needs: Reason = no_reason
    leads: bool = False
    presses: bool = True
    risky: bool = False
    synonyms: tuple[str, ...] = ()

    def refusal(self, now: OperatingState) -> str:
        """Return in words why its operation may not be done now; empty: it may."""
        if self.operation is None:
            return ""
        return words.why_not(self.operation.why_not(now, **self.arguments))

    @property
    def shown_first(self) -> bool:
        """True if it is never done where the operator has not seen its page."""
        return self.leads or (self.operation is not None and self.operation.shown_first)

    @property
    def only_led_to(self) -> bool:
        """True if its button is never pressed from the list, as one that has to be held."""
        held = self.operation is not None and self.operation.consent is Consent.HELD
        return held or not self.presses

    @property
    def dangerous(self) -> bool:
        """True if it may lose a zero, a setting, or the power that holds the arm."""
        asks = self.operation is not None and self.operation.consent is Consent.PRESS
        return self.risky or asks

    @property
    def title(self) -> Text:
        """The title in the palette.

        Raises:
            KeyError: It has no title, no shortcut and no operation.
        """
        if self.own_title is not None:
            return self.own_title
        shortcut = SHORTCUTS.get(self.name)
        return self.operation_title if shortcut is None else shortcut.title

    @property
    def operation_title(self) -> Text:
        """The title of its operation, by which it is found as well.

        Raises:
            KeyError: It carries out none.
        """
        if self.operation is None:
            raise KeyError(self.name)
        return Text("Operation", self.operation.title)

    @property
    def place(self) -> str:
        """The key of its place."""
        return self.name.partition(".")[0]

    @property
    def keys(self) -> str:
        """The shortcut as this system writes it; empty: there is none."""
        shortcut = SHORTCUTS.get(self.name)
        return "" if shortcut is None else shortcut.text()


def also(names: str) -> tuple[str, ...]:
    """Return other names of a command, given with spaces between.

    ``python -m tests.translations`` finds the Chinese ones by this call and spells them in pinyin.
    """
    return tuple(names.split())


def new_action(parent: QObject, act: Callable[[], object]) -> QAction:
    """Return an action of the window without a button: it calls a function."""
    action = QAction(parent)
    action.triggered.connect(lambda _on=False: act())
    return action


def allow(action: QAction, reason: str) -> None:
    """Let an action be chosen, or say in its tooltip why it cannot be now."""
    action.setEnabled(not reason)
    action.setToolTip(reason)


def of_place(place: str, commands: Iterable[Command]) -> tuple[Command, ...]:
    """Return the commands of a part that stands in several places, as those of one of them.

    Args:
        place: The key of the place.
        commands: Those of the part; their names are the acts alone.
    """
    return tuple(replace(each, name=f"{place}.{each.name}") for each in commands)


class Offering(Protocol):
    """A widget, or another part of the window, that the command palette knows."""

    @property
    def commands(self) -> Sequence[Command]:
        """The commands, in the order in which they are listed."""

    def command_targets(self) -> Mapping[str, Target]:
        """Return what carries out each command, by the command's name."""


@dataclass(frozen=True, slots=True)
class CommandSource:
    """A part of the window with its commands, whether it has been made yet or not.

    Attributes:
        commands: Its commands.
        owner: Returns the part; ``None``: it has not been made yet.
        show: Brings it into sight; ``None``: it stands in the main window, always.
        why_not: Tells why it cannot be brought into sight.
        asks_first: To show it may ask first what becomes of something that is not saved.
    """

    commands: Sequence[Command]
    owner: Callable[[], Offering | None]
    show: Callable[[], object] | None = None
    why_not: Callable[[], str] = no_reason
    asks_first: bool = False


def source_of(part: Offering) -> CommandSource:
    """Return the source of a part that stands in the main window."""
    return CommandSource(part.commands, lambda: part)
