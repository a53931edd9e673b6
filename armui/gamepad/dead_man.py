"""Whether a device may move the arm, and how: the dead-man button and what takes it away; pure.

Moving takes, in this order: the dead-man button pressed with every axis at rest, then an axis
pushed. Axes back at rest end the motion, and it may begin again. The button let go, and whatever
else takes the hold away, ends it until the button has been let go and pressed anew.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from armui.gamepad.device_state import DeviceState
from armui.gamepad.layout import (
    DEAD_ZONES,
    Assignment,
    JogMode,
    centred,
    deflections,
    shaped,
    speed_share,
    strongest,
)

UNATTENDED_S: Final = 10.0
"""So long a hold lasts without any movement of the device."""

SIGN_OF_A_HAND: Final = 0.03
"""An axis that moves by less may do so by itself: the last digits of a stick never stand still."""

_STILL: Final = (0.0,) * 6


class HoldPhase(StrEnum):
    """How far a hold has come."""

    UP = "up"
    """The dead-man button is not pressed."""
    OFF_CENTRE = "off_centre"
    """Pressed while an axis was pushed: that must come back to its centre first."""
    READY = "ready"
    """Pressed, and every axis at rest."""
    MOVING = "moving"
    """Pressed, and an axis is pushed."""
    SPENT = "spent"
    """Still pressed, and taken away: it must be let go first."""


class Loss(StrEnum):
    """What can take a hold away by the device's own state."""

    SILENT = "silent"
    UNATTENDED = "unattended"


@dataclass(frozen=True, slots=True)
class DeviceHold:
    """A hold at a moment.

    Attributes:
        rates: Of each axis of the arm the share of its highest speed, −1 to 1; all 0 unless moving.
        lost: What took it away just now.
    """

    phase: HoldPhase = HoldPhase.UP
    rates: tuple[float, ...] = _STILL
    lost: Loss | None = None


class DeadMan:
    """Follows one device.

    Attributes:
        hold: As of the last look.
    """

    def __init__(self) -> None:
        self.hold = DeviceHold()
        self._seen_up = False
        self._axis: int | None = None
        self._reference: DeviceState | None = None
        self._moved_s = 0.0

    def update(
        self,
        state: DeviceState,
        buttons: Assignment,
        mode: JogMode,
        now_s: float,
        *,
        one_axis: bool,
    ) -> DeviceHold:
        """Look at the device.

        Args:
            state: As it is now.
            buttons: What its buttons do.
            mode: What its axes move.
            now_s: By the program's clock.
            one_axis: Only the axis that was pushed first moves, until all are at rest again.
        """
        self._watch_hand(state, now_s)
        if buttons.dead_man not in state.buttons:
            self._seen_up = True
            self.hold = DeviceHold()
        elif not self._seen_up:
            self.hold = DeviceHold(HoldPhase.SPENT)  # held since before anybody looked
        elif self.hold.phase is not HoldPhase.SPENT:
            self.hold = self._held(state, mode, now_s, one_axis=one_axis)
        else:
            self.hold = DeviceHold(HoldPhase.SPENT)
        return self.hold

    def spend(self) -> None:
        """Take the hold away, if there is one: only a new press begins another."""
        if self.hold.phase is not HoldPhase.UP:
            self.hold = DeviceHold(HoldPhase.SPENT)

    def let_go(self) -> None:
        """The dead-man button was let go, however shortly."""
        self._seen_up = True
        self.hold = DeviceHold()

    def _held(
        self, state: DeviceState, mode: JogMode, now_s: float, *, one_axis: bool
    ) -> DeviceHold:
        if state.silent:
            return DeviceHold(HoldPhase.SPENT, lost=Loss.SILENT)
        if now_s - self._moved_s >= UNATTENDED_S:
            return DeviceHold(HoldPhase.SPENT, lost=Loss.UNATTENDED)
        asked = deflections(state, mode)
        dead_zone = DEAD_ZONES[state.info.kind]
        if centred(asked, dead_zone):
            self._axis = None
            return DeviceHold(HoldPhase.READY)
        if self.hold.phase in {HoldPhase.UP, HoldPhase.OFF_CENTRE}:
            return DeviceHold(HoldPhase.OFF_CENTRE)
        rates = tuple(shaped(each, dead_zone) for each in asked)
        if one_axis:
            rates = self._only_one(rates)
        if not any(rates):  # the one axis that may move is at rest again, and others are not
            return DeviceHold(HoldPhase.OFF_CENTRE)
        share = speed_share(state)
        return DeviceHold(HoldPhase.MOVING, tuple(share * rate for rate in rates))

    def _only_one(self, rates: Sequence[float]) -> tuple[float, ...]:
        if self._axis is None:
            self._axis = strongest(rates)
        return tuple(rate if place == self._axis else 0.0 for place, rate in enumerate(rates))

    def _watch_hand(self, state: DeviceState, now_s: float) -> None:
        """Note when the device last showed that somebody has it in hand."""
        before = self._reference
        if before is None or before.buttons != state.buttons or _moved(before, state):
            self._reference, self._moved_s = state, now_s


def _moved(before: DeviceState, now: DeviceState) -> bool:
    names = before.axes.keys() | now.axes.keys()
    return any(
        abs(now.axes.get(name, 0.0) - before.axes.get(name, 0.0)) > SIGN_OF_A_HAND for name in names
    )
