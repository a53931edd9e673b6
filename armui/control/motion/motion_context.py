"""The context of the parts that move the arm: what all share, with the gate."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from armui.control.context import Context
from armui.control.safety.gate import Gate


@dataclass(frozen=True, slots=True)
class MotionContext(Context):
    """The context of those parts of the controller that move the arm.

    Attributes:
        gate: Returns what checks every motion.
    """

    gate: Callable[[], Gate]

    def send_percent(self, percent: int) -> bool:
        """Send another speed percentage in the arm's present mode; return false if impossible.

        It changes how fast the arm goes on a way that was passed, and no way.

        While a motion is held back, or may be, only 0 % is sent: any other value would set it
        going. One that is slow by itself is given no more than its own.
        """
        self.observe()
        authority = self.authority
        percent = min(percent, authority.most_percent)
        refusal = authority.why_no_speed(percent)
        mode = None if refusal is not None else authority.mode_in_force()
        passed = self.gate().ask_no_way()
        if mode is None or not self.connection.send(
            self.speed_frames(mode, percent), passed=passed
        ):
            return False
        self.authority.told_percent(percent)
        return True


class MovingPart(Protocol):
    """A part of the controller that moves the arm."""

    @property
    def _context(self) -> MotionContext: ...


def drop_waiting(part: MovingPart) -> None:
    """Drop the motion that waits: a press of another one voids it, even one that is refused."""
    part._context.gate().drop_single()  # noqa: SLF001 - as an operation does
