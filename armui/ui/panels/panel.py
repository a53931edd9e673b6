"""The base of every panel of the operation area: a title, parts below one another, a message."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QEvent
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QBoxLayout, QLayout, QScrollArea, QSizePolicy, QSpacerItem, QWidget

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
_SLACK_POLICIES: Final = (QSizePolicy.Policy.Minimum, QSizePolicy.Policy.Fixed)
_GAP_PX: Final = 10
_BELOW_PX: Final = 7
"""The gap below the message, which has a margin of its own."""
_HEAD_PX: Final = 36
"""The height of the head, with or without buttons: all contents begin at the same place."""
_SAID_ONLY_HERE: Final = UNHINDERED | {StepKind.STATUS_UNKNOWN}
"""The steps whose line gives no reason: nothing is wrong, or the panel names what is missing."""


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
        self._slack = QSpacerItem(0, 0, *_SLACK_POLICIES)
        self._gap_px = _GAP_PX
        self._title = text_label(rank="title")
        self._message = named(message_name, MessageLine(steady=True))

    # -- what a panel of its own adds ---------------------------------------------------------

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        raise NotImplementedError

    def _show_all(self) -> None:
        """Update everything that is shown."""
        raise NotImplementedError

    def _show_message(self) -> None:
        """Show the most important message now."""
        raise NotImplementedError

    def _show_state(self, state: ArmState) -> None:
        """Update what depends on the arm's state."""

    def _forget_outdated(self, old: OperatingState) -> None:
        """Drop the message if the operating state that explained it is over."""

    # -- what a panel can use -----------------------------------------------------------------

    def heading(self) -> str:
        """Return its title, to which its acts belong."""
        return self._title.text()

    def _listen(self, *told_here: str) -> None:
        """Follow the controller.

        Args:
            told_here: The prefixes of the codes of events that the panel shows.
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
        """Return a lasting reason, unless the line of the next step shows it already."""
        now = self._operating_state
        if reason not in (now.unreachable, now.cannot_enable, now.cannot_move):
            return reason  # a reason of this panel alone, for which there is no step
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
            head: The row with the title and further widgets; by default the title alone.
            gap_px: Between the parts.
        """
        self._gap_px = gap_px
        layout = in_column(on=self, spacing=gap_px, margins=(16, 14, 16, _BELOW_PX))
        self._title.setMinimumHeight(_HEAD_PX)
        for part in (head or self._title, *parts, self._message):
            if isinstance(part, QLayout):
                layout.addLayout(part)
            elif isinstance(part, QScrollArea):
                layout.addWidget(part, 1)
                layout.addSpacerItem(self._slack)
            else:
                layout.addWidget(part)
        self._area = next((part for part in parts if isinstance(part, QScrollArea)), None)
        layout.addStretch(0 if self._area else 1)

    def _share_room(self) -> None:
        """Keep no room for a message if the card would have to scroll for that.

        The message then takes the lower end of the card, and room that is too low for a message
        stays below the card: the buttons must not move when a message comes.
        """
        area, message, layout = self._area, self._message, self.layout()
        card = None if area is None else area.widget()
        if area is None or card is None or not isinstance(layout, QBoxLayout):
            return
        layout.activate()
        shown_px = 0 if message.isHidden() else message.height() + self._gap_px
        end = layout.itemAt(layout.count() - 1)
        spare_px = self._slack.sizeHint().height() + (0 if end is None else end.geometry().height())
        unused_px = area.height() - _least_height(card, area.viewport().width())
        room_px = unused_px + spare_px + shown_px
        short = room_px < message.kept_px() + self._gap_px
        place = layout.indexOf(area) + 2 if short else layout.count() - 2
        if layout.indexOf(message) != place:
            layout.removeWidget(message)
            layout.insertWidget(place, message)
        said = bool(message.text())
        message.setVisible(said or not short)
        taken_px = message.sizeHint().height() + self._gap_px if said else 0
        slack_px = max(0, room_px - taken_px) if short else 0
        if slack_px != self._slack.sizeHint().height():
            self._slack.changeSize(0, slack_px, *_SLACK_POLICIES)
            layout.invalidate()

    def _accepted(self, answer: Started | Refusal | None) -> bool:
        """Show the controller's answer and return whether it was a yes."""
        self._refusal = refusal_of(answer)
        self._show_message()
        return self._refusal is None

    def _show_outcome(self, refusal: Refusal | None, event: Event | None = None) -> None:
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
        """Ask for a confirmation by a held button, which a double click does not press by mistake.

        Args:
            title: The question in a few words.
            text: What will physically happen, and what to do before.
            label: The word on the button.
            act: The command; its refusal is shown.
            still: Returns true while the question still holds.
            sinks: True if the command lets the arm sink.
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
        """Divide the room again when its size or that of a part has changed."""
        room = event.type() in {QEvent.Type.Resize, QEvent.Type.LayoutRequest}
        done = super().event(event)  # Qt may delete the event in this call
        if room:
            self._share_room()
        return done


def _least_height(card: QWidget, width_px: int) -> int:
    """Return the height in pixels at which a card need not scroll."""
    least = card.minimumSizeHint().height()
    return max(least, card.heightForWidth(width_px)) if card.hasHeightForWidth() else least
