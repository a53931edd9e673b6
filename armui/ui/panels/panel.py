"""The base of every panel of the operation area: a title, parts below one another, a message."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QEvent
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QBoxLayout, QLayout, QScrollArea, QWidget

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.arm_controller import ArmController
from armui.control.events import Event, Level
from armui.control.link.link_state import LINK_LOST, NOT_CONNECTED, LinkState
from armui.control.operating_state import OperatingState
from armui.control.operations.started import Started, refusal_of
from armui.control.safety.interlocks import ARM_FAULT, STOP_REQUESTED, STOPPED
from armui.control.safety.recovery_steps import UNHINDERED, Step, StepKind
from armui.ui import words
from armui.ui.actions.act import HasActs
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_LEVELS: Final = {
    NOT_CONNECTED: Level.INFO,
    LINK_LOST: Level.FAULT,
    STOPPED: Level.FAULT,
    STOP_REQUESTED: Level.FAULT,
    ARM_FAULT: Level.FAULT,
}
_GAP_PX: Final = 10
_BELOW_PX: Final = 7
"""Below the message, which has some room of its own."""
_HEAD_PX: Final = 36
"""The height of a head with or without buttons, so that the content keeps its place."""
_SAID_ONLY_HERE: Final = UNHINDERED | {StepKind.STATUS_UNKNOWN}
"""The steps whose line does not give the reason: nothing is wrong, or the panel names what is
silent.
"""


def level_of(refusal: Refusal) -> Level:
    """Return the severity of a reason against an action; the operator can remedy most."""
    return _LEVELS.get(refusal.reason, Level.WARNING)


class Panel(HasActs, Translated, QWidget):
    """Shows news while it is visible, and is updated when it is shown again.

    A subclass creates its widgets, lays them out with :meth:`_stack`, connects with
    :meth:`_listen`, and calls :meth:`retranslate_ui` at the end of its constructor.

    Args:
        controller: The controller of the arm.
        message_name: The object name of the message.
    """

    def __init__(self, controller: ArmController, message_name: str) -> None:
        super().__init__()
        self._controller = controller
        self._operating_state = controller.operating_state
        self._refusal: Refusal | None = None
        self._event: Event | None = None
        self._told_here: tuple[str, ...] = ()
        self._area: QScrollArea | None = None
        self._gap_px = _GAP_PX
        self._title = text_label(rank="title")
        self._message = named(message_name, MessageLine(steady=True))

    # -- what a panel of its own adds ---------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        raise NotImplementedError

    def _show_all(self) -> None:
        """Show everything as it is now."""
        raise NotImplementedError

    def _show_message(self) -> None:
        """Say the one thing that matters most now."""
        raise NotImplementedError

    def _show_state(self, state: ArmState) -> None:
        """Show what the arm says."""

    def _forget_outdated(self, old: OperatingState) -> None:
        """Drop what was said, if the operating state that is left explains it no more."""

    # -- what it finds here -------------------------------------------------------------------

    def heading(self) -> str:
        """Return its title, to which its acts belong."""
        return self._title.text()

    def _listen(self, *told_here: str) -> None:
        """Follow the controller.

        Args:
            told_here: How the codes of the events begin that the panel tells.
        """
        self._told_here = told_here
        self._controller.state_changed.connect(self._on_state_changed)
        self._controller.operating_state_changed.connect(self._on_operating_state_changed)
        self._controller.noticed.connect(self._on_noticed)
        self._controller.step_changed.connect(self._on_step_changed)

    def _on_step_changed(self, _step: Step) -> None:
        if self.isVisible():
            self._show_message()

    def _unless_told(self, reason: Refusal | None) -> Refusal | None:
        """Return a standing reason, unless the line of the next step says it already."""
        now = self._operating_state
        if reason not in (now.unreachable, now.cannot_enable, now.cannot_move):
            return reason  # of this panel alone: no step leads out of it
        if now.link is LinkState.NO_DEVICE:
            return None
        told = self._controller.recovery.step.kind not in _SAID_ONLY_HERE
        return None if told else reason

    def _on_noticed(self, event: Event) -> None:
        if event.code.startswith(self._told_here):
            self._refusal, self._event = None, event
            self._show_message()

    def _on_state_changed(self, state: ArmState) -> None:
        if self.isVisible():
            self._show_state(state)

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        old, self._operating_state = self._operating_state, operating_state
        self._forget_outdated(old)
        if self.isVisible():
            self._show_all()

    def _stack(
        self, *parts: QWidget | QLayout, head: QLayout | None = None, gap_px: int = _GAP_PX
    ) -> None:
        """Lay the panel out: its title, the parts below one another, the message.

        What scrolls takes the room that is left; if nothing does, the room stays empty below.

        Args:
            parts: From top to bottom.
            head: Holds the title and what stands beside it; the title alone where there is none.
            gap_px: Between the parts.
        """
        self._gap_px = gap_px
        layout = in_column(on=self, spacing=gap_px, margins=(16, 14, 16, _BELOW_PX))
        self._title.setMinimumHeight(_HEAD_PX)
        for part in (head or self._title, *parts, self._message):
            if isinstance(part, QLayout):
                layout.addLayout(part)
            else:
                layout.addWidget(part, 1 if isinstance(part, QScrollArea) else 0)
        self._area = next((part for part in parts if isinstance(part, QScrollArea)), None)
        layout.addStretch(0 if self._area else 1)

    def _share_room(self) -> None:
        """Keep no room for a message where the card would scroll for it.

        There it comes right below the card, of which it takes the lower end: the buttons must not
        move when something is said.
        """
        area, message, layout = self._area, self._message, self.layout()
        card = None if area is None else area.widget()
        if area is None or card is None or not isinstance(layout, QBoxLayout):
            return
        layout.activate()
        shown_px = 0 if message.isHidden() else message.height() + self._gap_px
        end = layout.itemAt(layout.count() - 1)
        spare_px = 0 if end is None else end.geometry().height()
        room_px = area.height() + shown_px + spare_px - message.kept_px() - self._gap_px
        short = _least_height(card, area.viewport().width()) > room_px
        place = layout.indexOf(area) + 1 if short else layout.count() - 2
        if layout.indexOf(message) != place:
            layout.removeWidget(message)
            layout.insertWidget(place, message)
        message.setVisible(bool(message.text()) or not short)

    def _accepted(self, answer: Started | Refusal | None) -> bool:
        """Show the controller's answer and return whether it was a yes."""
        self._refusal = refusal_of(answer)
        self._show_message()
        return self._refusal is None

    def _show_refusal(self, refusal: Refusal | None, event: Event | None = None) -> None:
        """Show a refusal, otherwise the last event, otherwise nothing."""
        if refusal is not None:
            self._message.show_message(words.refusal(refusal), level_of(refusal))
        elif event is not None:
            self._message.show_message(words.event(event), event.level)
        else:
            self._message.show_message("")
        self._share_room()

    def _ask_to_hold(
        self,
        title: str,
        text: str,
        label: str,
        act: Callable[[], Started | Refusal | None],
        *,
        still: Callable[[], bool] = lambda: True,
        sinks: bool = False,
    ) -> None:
        """Ask before what a double click must not do: the answer is a button that is held.

        Args:
            title: The question in a few words.
            text: What will physically happen, and what to do before.
            label: The word on the button.
            act: The command; its refusal is shown.
            still: Returns true while the question still holds.
            sinks: The arm sinks by it.
        """
        confirm(
            self.window(),
            self._controller,
            title=title,
            text=text,
            action_label=label,
            on_confirmed=lambda: self._accepted(act()),
            hold=True,
            still=still,
            sinks=sinks,
        )

    def showEvent(self, event: QShowEvent) -> None:
        """Update everything that changed while the panel was hidden."""
        super().showEvent(event)
        self._show_all()

    def event(self, event: QEvent) -> bool:
        """Share the room anew when there is more or less of it, or a part needs more or less."""
        room = event.type() in {QEvent.Type.Resize, QEvent.Type.LayoutRequest}
        done = super().event(event)  # which may delete it
        if room:
            self._share_room()
        return done


def _least_height(card: QWidget, width_px: int) -> int:
    """Return how high a card must be to be seen whole, in pixels."""
    least = card.minimumSizeHint().height()
    return max(least, card.heightForWidth(width_px)) if card.hasHeightForWidth() else least
