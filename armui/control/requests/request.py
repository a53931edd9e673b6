"""An action that is sent, repeated if need be, and followed until seen in the feedback or late."""

from __future__ import annotations

import enum
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from armui.arm.state import ArmState
from armui.control.context import Context
from armui.protocol.frame import Frame


class RequestOutcome(enum.Enum):
    """How a request stands."""

    WAITING = enum.auto()
    DONE = enum.auto()
    TIMED_OUT = enum.auto()


@dataclass(slots=True)
class Request:
    """An action that is over when the arm says so.

    Attributes:
        context: The way to the arm, and what is known of it.
        frames: What to send.
        seen: Whether the arm's feedback shows the action done.
        repeat_s: Send again after so long without the effect (real arms want some commands twice).
        attempts: How often to send at most; the last attempt waits ``repeat_s`` too.
    """

    context: Context
    frames: Sequence[Frame]
    seen: Callable[[ArmState], bool]
    repeat_s: float = 0.5
    attempts: int = 3
    _sent: int = 0
    _next_s: float = 0.0

    def advance(self) -> RequestOutcome:
        """Look at what was heard, send if it is time to; called regularly until not ``WAITING``."""
        state, now_s = self.context.state(), self.context.clock()
        if self._sent and self.seen(state):
            return RequestOutcome.DONE
        if now_s < self._next_s:
            return RequestOutcome.WAITING
        if self._sent == self.attempts:
            return RequestOutcome.TIMED_OUT
        self.context.connection.send(self.frames)
        self._sent += 1
        self._next_s = now_s + self.repeat_s
        return RequestOutcome.WAITING
