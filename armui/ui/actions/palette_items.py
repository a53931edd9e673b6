"""The items of the command palette: the commands of every part of the window, visible or not."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QMenu, QToolButton, QWidget

from armui.ui.actions.act import BoundAct, HasActs
from armui.ui.actions.command import Command, CommandSource, Target
from armui.ui.actions.operator_view import why_taken
from armui.ui.widgets.buttons import reason_against
from armui.ui.widgets.hold_button import HoldButton

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.words.text import Text

Callback = Callable[[], object]
"""A function without arguments that does what the operator asked for."""


@dataclass(frozen=True, slots=True)
class PaletteItem:
    """A row of the palette.

    Attributes:
        title, place: The texts in the present language.
        reason: The reason why it cannot be done now; empty if none is known.
        command: The command.
        source: The part of the window that offers it.
        target: Carries it out, or leads to what does; ``None`` if its page is hidden.
        act: The act that it is, if its part declares it as one.
        seen: True if the target is visible.
    """

    title: str
    place: str
    reason: str
    command: Command
    source: CommandSource
    target: Target | None
    act: BoundAct | None
    seen: bool

    @property
    def must_be_opened(self) -> bool:
        """True if its page has to be opened before more is known of it."""
        return not self.seen and self.source.show is not None and not self.source.asks_first

    @property
    def moves(self) -> bool:
        """True if the arm moves as soon as it is carried out."""
        command = self.command
        at_once = not command.only_led_to and (self.seen or not command.shown_first)
        return at_once and command.operation is not None and command.operation.moves


class PaletteItems:
    """Collects the present commands of every part of the window.

    Args:
        controller: Gives the operating state.
        sources: The parts, in the order in which they are listed.
        places: The titles of the places by their keys.
    """

    def __init__(
        self,
        controller: ArmController,
        sources: Sequence[CommandSource],
        places: Mapping[str, Text],
    ) -> None:
        self._controller = controller
        self._sources = sources
        self._places = places

    def now(self) -> list[PaletteItem]:
        """Return all items in their present state."""
        return [item for source in self._sources for item in self._of(source)]

    def show(self, item: PaletteItem) -> PaletteItem:
        """Open the page of an item, and return the item in its new state."""
        if item.source.show is not None:
            item.source.show()
        return self.again(item)

    def again(self, item: PaletteItem) -> PaletteItem:
        """Return an item in its present state."""
        return next(each for each in self._of(item.source) if each.command is item.command)

    def carry_out(self, item: PaletteItem, *, was_seen: bool) -> None:
        """Carry out an item by its own button; a question that the button asks is asked.

        Args:
            item: The item in its present state.
            was_seen: True if the operator saw the button when choosing; otherwise a command that
                moves the arm is only shown.
        """
        if not item.seen:
            item = self.show(item)
        target = item.target
        if not item.seen or target is None:
            return  # not shown yet: a panel with unsaved changes asks first
        if item.command.only_led_to or (item.command.shown_first and not was_seen):
            if isinstance(target, QWidget):
                lead_to(target)
        elif item.act is not None:
            item.act.press()
        elif isinstance(target, QAction):
            target.trigger()
        else:
            use(target)

    def _of(self, source: CommandSource) -> list[PaletteItem]:
        now, owner = self._controller.operating_state, source.owner()
        in_sight = owner is not None and (not isinstance(owner, QWidget) or owner.isVisible())
        targets = owner.command_targets() if owner is not None and in_sight else {}
        known = in_sight or source.show is None
        items = []
        for command in source.commands:
            title, place = command.title.text(), self._places[command.place].text()
            target = targets.get(command.name)
            act = owner.act_of(command.name) if isinstance(owner, HasActs) else None
            if (unfolds := _folded_into(target)) is not None:
                target, act = unfolds, None
            seen = isinstance(target, QAction) or (target is not None and target.isVisible())
            if seen:
                reason = _why_off(target) if act is None else act.reason()
                if isinstance(target, QAction):  # an action is never disabled by itself
                    reason = reason or command.needs(now)
            else:
                reason = source.why_not() or command.needs(now) or command.refusal(now)
                reason = reason or (nothing_to_do() if known else "")
            reason = why_taken(command.name, command.operation) or reason
            place = "" if place == title else place
            items.append(PaletteItem(title, place, reason, command, source, target, act, seen))
        return items


def nothing_to_do() -> str:
    """Return the sentence that a missing button cannot be pressed."""
    return QCoreApplication.translate("Action", "There is nothing to do here right now.")


def _folded_into(target: Target | None) -> QWidget | None:
    """Return the button with the fold-out panel that contains a target, or ``None``."""
    panel = target.window() if isinstance(target, QWidget) else None
    return panel.parentWidget() if isinstance(panel, QMenu) else None


def _why_off(target: Target | None) -> str:
    if target is None or target.isEnabled():
        return ""
    return reason_against(target) or nothing_to_do()


def use(widget: QWidget) -> None:
    """Press a button, or focus a widget that needs more than a press, such as one with a menu."""
    opens = isinstance(widget, QToolButton) and widget.menu() is not None
    if isinstance(widget, QAbstractButton) and not isinstance(widget, HoldButton) and not opens:
        widget.window().activateWindow()
        widget.click()
        return
    lead_to(widget)


def lead_to(widget: QWidget) -> None:
    """Focus a widget without pressing it."""
    widget.window().activateWindow()
    widget.setFocus()
    select = getattr(widget, "selectAll", None)
    if select is not None:
        select()
