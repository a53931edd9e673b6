"""What the command palette offers: the catalogue, seen or not, and what else is on the screen."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QAbstractButton, QApplication, QDialog, QMenu, QToolButton, QWidget

from armui.ui.actions.catalogue import actions
from armui.ui.actions.command import Command
from armui.ui.actions.places import PANELS, PLACES
from armui.ui.widgets.page import Page
from armui.ui.widgets.press_button import PressButton

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

Doing = Callable[[], object]
Doings = Mapping[str, tuple[Doing, Callable[[], str]]]
"""By the names of actions without a button: what does it, and why that is not possible now."""

_HIDDEN: Final = frozenset({"qt_toolbar_ext_button", "qt_spinbox_lineedit"})


@dataclass(frozen=True, slots=True)
class Offer:
    """One row of the palette.

    Attributes:
        title, place: In the language of now.
        keys: The shortcut; empty: none.
        reason: Why it cannot be done now; empty: it can, as far as is known.
        do: Does it.
        show: Opens the page or window in which it is done, while that is not seen: what keeps it
            from being done is known then.
        point_out: Leads to its button instead, where what it does follows from what stands on that
            page: once it is shown, the button waits for a press of its own.
        name: Of its action in the catalogue; "" for what is only on the screen.
        dangerous: Nobody should come upon it by mistake.
    """

    title: str
    place: str
    keys: str
    reason: str
    do: Doing
    show: Doing | None = None
    point_out: Doing | None = None
    name: str = ""
    dangerous: bool = False

    def is_like(self, other: Offer) -> bool:
        """Whether it is the same one, of another moment."""
        return (self.title, self.place) == (other.title, other.place)


class Offers:
    """Gathers them.

    Args:
        window: The main window: buttons are looked for in it and in its dialogs.
        controller: Who knows why not.
        doings: What has no button.
        openers: By place what opens it, and why that is not possible now.
        show_panel: Goes to a panel, by its key.
    """

    def __init__(
        self,
        window: QWidget,
        controller: ArmController,
        doings: Doings,
        openers: Doings,
        show_panel: Callable[[str], object],
    ) -> None:
        self._window = window
        self._controller = controller
        self._doings = doings
        self._openers = openers
        self._show_panel = show_panel

    def now(self, apart_from: QWidget) -> list[Offer]:
        """All of them, as things stand.

        Args:
            apart_from: The palette, whose own buttons are none of them.
        """
        known = {action.target for action in actions()}
        offers = [
            replace(self._of(action), name=action.name, dangerous=action.dangerous)
            for action in actions()
        ]
        return [*offers, *self._of_windows(known, apart_from)]

    # -- the catalogue ------------------------------------------------------------------------

    def _of(self, action: Command) -> Offer:
        title, place = action.title.text(), PLACES[action.place].text()
        place = "" if place == title else place
        if not action.target:
            do, reason = self._doings[action.name]
            why_not = reason() or action.why_not(self._controller.operating_state)
            return Offer(title, place, action.keys, why_not, do)
        do = partial(self.do, action)
        seen = self._seen(action)
        if seen is not None:
            return Offer(title, place, action.keys, _why_not(seen), do)
        if action.place in self._openers:
            show, why = self._openers[action.place]
            point_out = partial(self.point_out, action) if action.shown_first else None
            return Offer(title, place, action.keys, why(), do, show, point_out)
        reason_text = action.why_not(self._controller.operating_state)
        if not reason_text and action.place not in PANELS:
            reason_text = nothing_to_do()
        return Offer(title, place, action.keys, reason_text, do)

    def do(self, action: Command) -> None:
        """Do what an action does, by its button: what that asks first is asked.

        What sends the arm somewhere by a panel that was not in sight is only led to.
        """
        was_seen = self._seen(action) is not None
        if action.target not in {f"menu_{panel}" for panel in PANELS}:
            self._show_place(action.place)
        seen = self._seen(action)
        if isinstance(seen, QAction):
            seen.trigger()
        elif seen is not None and action.shown_first and not was_seen:
            lead_to(seen)
        elif seen is not None:
            use(seen)

    def point_out(self, action: Command) -> None:
        """Lead the operator to the button, which has just come into sight, and press nothing."""
        seen = self._seen(action)
        if isinstance(seen, QWidget):
            lead_to(seen)

    def _show_place(self, place: str) -> None:
        """Go to a panel; what is not saved in the present one asks first, and then nothing else."""
        if place in PANELS:
            self._show_panel(place)

    def _seen(self, action: Command) -> QWidget | QAction | None:
        """What does it, if that is shown; of pages with the same buttons that of its place."""
        found: list[QWidget | QAction] = [
            *self._window.findChildren(QWidget, action.target),
            *self._window.findChildren(QAction, action.target),
        ]
        return next((each for each in found if _is_shown(each, action.place)), None)

    # -- what else is on the screen -----------------------------------------------------------

    def _of_windows(self, known: set[str], apart_from: QWidget) -> Iterator[Offer]:
        for window in QApplication.topLevelWidgets():
            if window is apart_from or not window.isVisible() or not self._is_ours(window):
                continue
            told: set[tuple[str, str]] = set()
            for button in window.findChildren(QAbstractButton):
                title = button.text().strip() or button.accessibleName()
                unwanted = isinstance(button, PressButton) or button.objectName() in known
                if unwanted or not _is_worth_telling(button, title):
                    continue
                place = _place_of(button)
                if (title, place) in told:
                    continue
                told.add((title, place))
                keys = button.shortcut().toString(button.shortcut().SequenceFormat.NativeText)
                yield Offer(title, place, keys, _why_not(button), _using(button))
            yield from _of_menus(window, told, known)

    def _is_ours(self, window: QWidget) -> bool:
        parent: QWidget | None = window
        while parent is not None and parent is not self._window:
            parent = parent.parentWidget()
        return parent is not None


def _is_worth_telling(button: QAbstractButton, title: str) -> bool:
    said = any(letter.isalpha() for letter in title)
    return said and button.isVisible() and button.objectName() not in _HIDDEN


def _place_of(widget: QWidget) -> str:
    """The page or the dialog that something stands in; empty: the main window itself."""
    each: QWidget | None = widget
    while each is not None:
        if isinstance(each, Page):
            return each.title
        if isinstance(each, QDialog):
            return each.windowTitle()
        each = each.parentWidget()
    return ""


def _is_shown(thing: QWidget | QAction, place: str) -> bool:
    """Whether something is seen, and stands on the page of a place if it is one of pages."""
    each = thing if isinstance(thing, QWidget) else thing.parent()
    while isinstance(each, QMenu):  # it is not seen before it is asked for: its owner is
        each = each.parent()
    if not isinstance(each, QWidget) or not each.isVisible():
        return False
    page: QWidget | None = each
    while page is not None and not isinstance(page, Page):
        page = page.parentWidget()
    return page is None or page.key == place


def _of_menus(window: QWidget, told: set[tuple[str, str]], known: set[str]) -> Iterator[Offer]:
    """The actions of tables and lists, which have a menu and keys, but maybe no button."""
    for action in window.findChildren(QAction):
        owner = action.parent()
        title = action.text()
        named = action.objectName().startswith("action_") and action.objectName() not in known
        if not (named and isinstance(owner, QWidget) and owner.isVisible()):
            continue
        if any(isinstance(each, QToolButton) for each in action.associatedObjects()):
            continue  # told by its button
        place = _place_of(owner)
        if (title, place) not in told:
            told.add((title, place))
            keys = action.shortcut().toString(action.shortcut().SequenceFormat.NativeText)
            reason = "" if action.isEnabled() else action.toolTip()
            yield Offer(title, place, keys, reason, action.trigger)


def _using(widget: QWidget) -> Doing:
    return lambda: use(widget) if widget.isVisible() else None


def nothing_to_do() -> str:
    """Why a button that is not there cannot be pressed."""
    return QCoreApplication.translate("Action", "There is nothing for it to do now.")


def _why_not(seen: QWidget | QAction) -> str:
    if seen.isEnabled():
        return ""
    name = seen.text() if isinstance(seen, QAction) else seen.accessibleName()
    return seen.toolTip() or name


def use(widget: QWidget) -> None:
    """Press a button, or bring the operator to what cannot be pressed by a key alone."""
    from armui.ui.widgets.hold_button import HoldButton  # noqa: PLC0415 - faster start

    if isinstance(widget, QAbstractButton) and not isinstance(widget, HoldButton):
        widget.window().activateWindow()
        widget.click()
        return
    lead_to(widget)


def lead_to(widget: QWidget) -> None:
    """Give the keyboard to something, and press nothing."""
    widget.window().activateWindow()
    widget.setFocus()
    select = getattr(widget, "selectAll", None)
    if select is not None:
        select()
