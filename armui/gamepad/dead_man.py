"""Decides whether a device may move the arm: the dead-man button, and what ends its hold; pure.

Motion begins when the dead-man button is pressed with every axis at rest, and then an axis is
pushed. Axes back at rest end the motion, and it may begin again. Releasing the button, or anything
else that ends the hold, stops it until the button has been released and pressed again.
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
"""A hold ends after this time without any movement of the device."""

SIGN_OF_A_HAND: Final = 0.03
"""A smaller movement of an axis may be noise: the value of a resting stick fluctuates."""

_STILL: Final = (0.0,) * 6


class HoldPhase(StrEnum):
    """The phase of a hold."""

    UP = "up"
    """The dead-man button is not pressed."""
    OFF_CENTRE = "off_centre"
    """Pressed while an axis was pushed: the axis must return to its centre first."""
    READY = "ready"
    """Pressed, with every axis at rest."""
    MOVING = "moving"
    """Pressed, with an axis pushed."""
    SPENT = "spent"
    """Still pressed, but the hold was ended: the button must be released first."""


class Loss(StrEnum):
    """The reasons in the device's own state that end a hold."""

    SILENT = "silent"
    UNATTENDED = "unattended"


@dataclass(frozen=True, slots=True)
class DeviceHold:
    """A hold at a moment.

    Attributes:
        rates: For each axis of the arm the share of its highest speed, −1 to 1; all 0 unless
            moving.
        lost: The reason that has just ended it.
    """

    phase: HoldPhase = HoldPhase.UP
    rates: tuple[float, ...] = _STILL
    lost: Loss | None = None


class DeadMan:
    """Follows the dead-man button of one device.

    Attributes:
        hold: The hold at the last update.
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
        """Process the device's state, and return the hold.

        Args:
            state: The device's present state.
            buttons: The assignment of its buttons.
            mode: The axes it moves.
            now_s: The time by the program's clock.
            one_axis: True if only the axis pushed first moves, until all are at rest again.
        """
        self._watch_hand(state, now_s)
        if buttons.dead_man not in state.buttons:
            self._seen_up = True
            self.hold = DeviceHold()
        elif not self._seen_up:
            # pressed before the first reading: it must be released once before it counts
            self.hold = DeviceHold(HoldPhase.SPENT)
        elif self.hold.phase is not HoldPhase.SPENT:
            self.hold = self._held(state, mode, now_s, one_axis=one_axis)
        else:
            self.hold = DeviceHold(HoldPhase.SPENT)
        return self.hold

    def spend(self) -> None:
        """End the hold, if there is one: only a new press begins another."""
        if self.hold.phase is not HoldPhase.UP:
            self.hold = DeviceHold(HoldPhase.SPENT)

    def release(self) -> None:
        """Note that the dead-man button was released, however briefly."""
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
        # the one axis that may move is at rest again, while others are still pushed
        if not any(rates):
            return DeviceHold(HoldPhase.OFF_CENTRE)
        share = speed_share(state)
        return DeviceHold(HoldPhase.MOVING, tuple(share * rate for rate in rates))

    def _only_one(self, rates: Sequence[float]) -> tuple[float, ...]:
        if self._axis is None:
            self._axis = strongest(rates)
        return tuple(rate if place == self._axis else 0.0 for place, rate in enumerate(rates))

    def _watch_hand(self, state: DeviceState, now_s: float) -> None:
        """Note the time of the last change of a button or of an axis by more than noise."""
        before = self._reference
        if before is None or before.buttons != state.buttons or _moved(before, state):
            self._reference, self._moved_s = state, now_s


def _moved(before: DeviceState, now: DeviceState) -> bool:
    names = before.axes.keys() | now.axes.keys()
    return any(
        abs(now.axes.get(name, 0.0) - before.axes.get(name, 0.0)) > SIGN_OF_A_HAND for name in names
    )
