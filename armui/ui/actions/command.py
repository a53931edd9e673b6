"""The commands that panels, pages and windows hand to the command palette."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Protocol

from PySide6.QtCore import QCoreApplication, QObject
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget

from armui.control.link.link_state import why_unreachable
from armui.control.motion.cartesian import POSE_UNKNOWN
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, Operation
from armui.control.safety.interlocks import JOINTS_UNKNOWN
from armui.ui import words
from armui.ui.actions.keys import SHORTCUTS
from armui.ui.words.text import Text

Target = QWidget | QAction
"""The widget or action that carries out a command: a button, a field that it leads to, or an
action.
"""
Needs = Callable[[OperatingState], str]
"""Returns in words what is missing for a command; empty if nothing is."""


def no_reason(*_: object) -> str:
    """Return an empty reason: nothing is needed."""
    return ""


def while_editing(_now: OperatingState) -> str:
    """Return the sentence that parameters can be saved or cancelled only while they are edited."""
    return QCoreApplication.translate("Action", "Press Edit in the panel first.")


def with_angles(now: OperatingState) -> str:
    """Return the reason if the joint angles are not known; empty otherwise."""
    unknown = None if now.angles_known else JOINTS_UNKNOWN()
    return words.why_not(why_unreachable(now.link) or unknown)


def with_simulated(now: OperatingState) -> str:
    """Return the reason if no simulated arm of this program is connected; empty otherwise."""
    if now.device is not None and now.device.simulated:
        return ""
    return QCoreApplication.translate("Action", "Only a simulated arm has them: connect one.")


def with_pose(now: OperatingState) -> str:
    """Return the reason if the pose of the flange is not known; empty otherwise."""
    unknown = None if now.pose_known else POSE_UNKNOWN()
    return words.why_not(why_unreachable(now.link) or unknown)


@dataclass(frozen=True, slots=True)
class Command:
    """A command of a panel, page or window, declared before that is created.

    Attributes:
        name: Its stable name: the key of its place, a dot, the act; its shortcut has the same name.
        own_title: The title in the palette; ``None``: that of its shortcut or of its operation.
        operation: The operation on the arm that it carries out, if it is one.
        arguments: The arguments of the operation that its reason depends on.
        needs: Returns from the operating state what is missing while its target is not visible, or
            is an action.
        leads: True if only its page is opened while that is hidden, as for an operation that is
            shown first.
        presses: True if its button is pressed; otherwise the command only brings the operator to
            it.
        risky: True if it never comes first in the list, like an operation that asks first.
        synonyms: Other names of it in both languages; see :func:`also`.
    """

    name: str
    own_title: Text | None = None
    operation: Operation | None = None
    arguments: Mapping[str, object] = field(default_factory=dict)
    needs: Needs = no_reason
    leads: bool = False
    presses: bool = True
    risky: bool = False
    synonyms: tuple[str, ...] = ()

    def refusal(self, now: OperatingState) -> str:
        """Return in words why its operation is not allowed now; empty if it is."""
        if self.operation is None:
            return ""
        return words.why_not(self.operation.why_not(now, **self.arguments))

    @property
    def shown_first(self) -> bool:
        """True if it is never carried out before the operator has seen its page."""
        return self.leads or (self.operation is not None and self.operation.shown_first)

    @property
    def only_led_to(self) -> bool:
        """True if its button is never pressed from the list, as one that must be held."""
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
        """The title of its operation, which is searched as well.

        Raises:
            KeyError: It has no operation.
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
    """Return other names of a command, given in one text with spaces between them.

    ``python -m tests.translations`` finds the Chinese ones by this call and adds their pinyin.
    """
    return tuple(names.split())


def new_action(parent: QObject, act: Callable[[], object]) -> QAction:
    """Return an action of the window without a button that calls a function."""
    action = QAction(parent)
    action.triggered.connect(lambda _on=False: act())
    return action


def of_place(place: str, commands: Iterable[Command]) -> tuple[Command, ...]:
    """Return the commands of a part that exists in several places, named for one of them.

    Args:
        place: The key of the place.
        commands: The part's commands, whose names are the acts alone.
    """
    return tuple(replace(each, name=f"{place}.{each.name}") for each in commands)


class Offering(Protocol):
    """A widget, or another part of the window, with commands for the palette."""

    @property
    def commands(self) -> Sequence[Command]:
        """The commands, in the order in which they are listed."""

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""


@dataclass(frozen=True, slots=True)
class CommandSource:
    """A part of the window with its commands, created or not.

    Attributes:
        commands: Its commands.
        owner: Returns the part, or ``None`` if it was not created yet.
        show: Shows the part; ``None`` for a permanent part of the main window.
        why_not: Returns the reason why it cannot be shown.
        asks_first: True if showing it may first ask about unsaved work.
    """

    commands: Sequence[Command]
    owner: Callable[[], Offering | None]
    show: Callable[[], object] | None = None
    why_not: Callable[[], str] = no_reason
    asks_first: bool = False


def source_of(part: Offering) -> CommandSource:
    """Return the source of a permanent part of the main window."""
    return CommandSource(part.commands, lambda: part)
