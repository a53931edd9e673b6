"""What each part of the controller is given: the way to the arm, and what is known of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from armui.arm.refusal import Refusal
from armui.arm.state import ArmState
from armui.control.situation import Situation

if TYPE_CHECKING:
    from armui.control.connection import Connection


class Tell(Protocol):
    """Tells the operator something: the code of a notice and its figures."""

    def __call__(self, code: str, **params: object) -> None: ...  # noqa: D102 - said above


@dataclass(frozen=True, slots=True)
class Context:
    """What the parts share.

    Attributes:
        connection: The way to the arm.
        tell: Takes the notices.
        clock: Monotonic time in seconds.
        state: The arm as last heard.
        situation: What the operator can do now, computed anew.
    """

    connection: Connection
    tell: Tell
    clock: Callable[[], float]
    state: Callable[[], ArmState]
    situation: Callable[[], Situation]

    def refuse(self, refusal: Refusal) -> Refusal:
        """Tell the operator why something was not done; returns the reason."""
        self.tell("refused", reason=refusal)
        return refusal


class Part(Protocol):
    """A part of the controller that follows something over time."""

    def advance(self) -> None:
        """Look at what was heard and move on; called at each tick while a device is open."""

    def halt(self) -> None:
        """An emergency stop was asked for, or the arm has stopped: give up what would move it."""

    def forget(self) -> None:
        """The arm is gone, lost or disconnected on purpose: no answer will come."""
