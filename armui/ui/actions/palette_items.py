"""The items of the command palette: the commands of every part of the window, seen or not."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QWidget

from armui.ui.actions.command import Command, CommandSource, Target
from armui.ui.widgets.hold_button import HoldButton

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.words.text import Text

Callback = Callable[[], object]
"""Does something that the operator wants."""


@dataclass(frozen=True, slots=True)
class PaletteItem:
    """A row of the palette.

    Attributes:
        title, place: In the present language.
        reason: Why it cannot be done now; empty: it can, as far as is known.
        command: The command.
        source: The part of the window that offers it.
        target: Carries it out; ``None``: its page is not in sight.
        seen: Whether the target is in sight.
    """

    title: str
    place: str
    reason: str
    command: Command
    source: CommandSource
    target: Target | None
    seen: bool

    @property
    def must_be_opened(self) -> bool:
        """True if its page has to be opened before anything more is known of it."""
        return not self.seen and self.source.show is not None and not self.source.asks_first


class PaletteItems:
    """Asks every part of the window what it offers now.

    Args:
        controller: Knows the operating state.
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
        """Return all items as things stand."""
        return [item for source in self._sources for item in self._of(source)]

    def show(self, item: PaletteItem) -> PaletteItem:
        """Open the page of an item; return the item as it stands there."""
        if item.source.show is not None:
            item.source.show()
        return self.again(item)

    def again(self, item: PaletteItem) -> PaletteItem:
        """Return an item as it stands now."""
        return next(each for each in self._of(item.source) if each.command is item.command)

    def carry_out(self, item: PaletteItem, *, was_seen: bool) -> None:
        """Do what an item does, by its own button: what that asks first is asked.

        Args:
            item: As it stands now.
            was_seen: Whether the operator saw the button when choosing; else what sends the arm
                somewhere is only led to.
        """
        if not item.seen:
            item = self.show(item)
        target = item.target
        if not item.seen or target is None:
            return  # its panel asks first what becomes of what is not saved
        if item.command.only_led_to or (item.command.shown_first and not was_seen):
            if isinstance(target, QWidget):
                lead_to(target)
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
            seen = isinstance(target, QAction) or (target is not None and target.isVisible())
            if seen:
                reason = _why_off(target)
            else:
                reason = source.why_not() or command.needs(now) or command.refusal(now)
                reason = reason or (nothing_to_do() if known else "")
            place = "" if place == title else place
            items.append(PaletteItem(title, place, reason, command, source, target, seen))
        return items


def nothing_to_do() -> str:
    """Return why a button that is not there cannot be pressed."""
    return QCoreApplication.translate("Action", "There is nothing to do here right now.")


def _why_off(target: Target | None) -> str:
    if target is None or target.isEnabled():
        return ""
    name = target.text() if isinstance(target, QAction) else target.accessibleName()
    return target.toolTip() or name


def use(widget: QWidget) -> None:
    """Press a button, or bring the operator to what cannot be pressed by a key alone."""
    if isinstance(widget, QAbstractButton) and not isinstance(widget, HoldButton):
        widget.window().activateWindow()
        widget.click()
        return
    lead_to(widget)


def lead_to(widget: QWidget) -> None:
    """Give the keyboard to a widget, and press nothing."""
    widget.window().activateWindow()
    widget.setFocus()
    select = getattr(widget, "selectAll", None)
    if select is not None:
        select()
