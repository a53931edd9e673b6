"""A request is sent, repeated if needed, and followed until the feedback shows it or time is up."""

from __future__ import annotations

import enum
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.state import ArmState
from armui.bus.press import Press
from armui.control.context import REFUSED, Context
from armui.control.operations.started import NOTHING_LEFT
from armui.protocol.frame import Frame

if TYPE_CHECKING:
    from armui.control.requests.reports import Report
    from armui.ways.passes import Pass

_LEAVES_WITHIN_S: Final = 0.95
"""A second, less what a driver takes for a frame (safety S14)."""
NOTHING_LEFT_REPORT: Final[Report] = (REFUSED, {"reason": NOTHING_LEFT()})


class RequestOutcome(enum.Enum):
    """The states of a request."""

    WAITING = enum.auto()
    DONE = enum.auto()
    TIMED_OUT = enum.auto()
    NOTHING_LEFT = enum.auto()
    """No frame of it has left within a second of the press, and none will."""


@dataclass(slots=True)
class Request:
    """A request that is over once the arm's feedback shows its effect.

    Attributes:
        context: Gives access to the arm and its state.
        frames: The frames to send.
        seen: Returns whether the arm's feedback shows the action done.
        repeat_s: The time without effect after which to send again (real arms need some commands
            twice).
        attempts: The most times to send; the last attempt waits ``repeat_s`` too.
        passed: The gate's pass, where there is a motion frame among them.
        ends: True if it only ends something in the arm: it may leave later than a second after the
            press.
    """

    context: Context
    frames: Sequence[Frame]
    seen: Callable[[ArmState], bool]
    repeat_s: float = 0.5
    attempts: int = 3
    passed: Pass | None = None
    ends: bool = False
    _press: Press | None = None
    _sent: int = 0
    _sent_s: float = 0.0
    _next_s: float = 0.0

    def advance(self) -> RequestOutcome:
        """Take in the feedback, send if it is time to; called regularly until not ``WAITING``."""
        state, now_s = self.context.state(), self.context.clock()
        if self._sent and self.seen(state):
            return RequestOutcome.DONE
        if not self._sent and not self.ends:
            self._press = Press(now_s + _LEAVES_WITHIN_S)
        if self._press is not None and self._press.is_over(now_s):
            return RequestOutcome.NOTHING_LEFT
        if now_s < self._next_s:
            return RequestOutcome.WAITING
        gap = state.gap
        if self._sent and gap is not None and gap.at_s > self._sent_s:
            # A gap may have delayed the feedback that shows the effect: wait for it once more.
            self._sent_s, self._next_s = math.inf, now_s + self.repeat_s
            return RequestOutcome.WAITING
        if self._sent == self.attempts:
            return RequestOutcome.TIMED_OUT
        self.context.connection.send(self.frames, passed=self.passed, press=self._press)
        self._sent += 1
        self._sent_s, self._next_s = now_s, now_s + self.repeat_s
        return RequestOutcome.WAITING
