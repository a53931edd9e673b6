"""The record of a command that was begun, with its outcome: pure."""

from __future__ import annotations

import enum
from dataclasses import dataclass, field
from itertools import count
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason
from armui.control.event_log.observed import Observed
from armui.control.link.link_state import LINK_LOST
from armui.telemetry.events import EventOutcome, Level

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.arm.refusal import Refusal

ENDED_BY_STOP = Reason(
    "ended_by_stop",
    "The stop came first; this is not sent again. Check the state of the arm, then repeat it.",
)
ARM_CHANGED = Reason(
    "arm_changed",
    "The arm was silent meanwhile, or another arm answers: nothing more was sent. See that it "
    "is the right arm, then try again.",
)
SETTING_UNANSWERED = Reason(
    "setting_unanswered",
    "The arm did not answer (0x476). Nothing says that it took this over: read the values "
    "again, then save once more.",
)
SETTING_NOT_READ_BACK = Reason(
    "setting_not_read_back",
    "The arm did not answer when asked for the value: what it holds is not known. Read again.",
)
ORDER_TOO_LATE = Reason(
    "order_too_late",
    "Nothing was sent: the arm was still being set or asked something a second after the "
    "press. Try again.",
)
NOTHING_LEFT = Reason(
    "nothing_left",
    "The CAN device took no frame within a second of the press. Check the CAN cable and the arm's "
    "power, then try again.",
)
ANSWERED = Observed("answered", "Answered with 0x476 (setting {index})")


_CUT_OFF: Final = frozenset({LINK_LOST, ENDED_BY_STOP, ARM_CHANGED})
_IN_VAIN: Final = frozenset(
    {
        SETTING_UNANSWERED,
        SETTING_NOT_READ_BACK,
        ORDER_TOO_LATE,
    }
)
_NUMBERS: Final[Callable[[], int]] = count(1).__next__


class Ending(enum.Enum):
    """The ways in which a command ends."""

    SENT = enum.auto()
    """The command was sent; the arm does not confirm it."""
    ANSWERED = enum.auto()
    """The arm has answered (0x476); the effect cannot be read back."""
    DONE = enum.auto()
    """The effect was read back from the arm."""
    REFUSED = enum.auto()
    """The arm has refused it, or the program has after the operator's press."""
    FAILED = enum.auto()
    """The arm has not done it, or not in time."""
    CUT_OFF = enum.auto()
    """Something else has ended it: a stop, another command, the loss of the arm."""


@dataclass(eq=False, slots=True)
class Started:
    """The record of a command from its beginning to its end.

    Attributes:
        operation: The id of the operation, or another name if the command is none.
        number: Counts up over the whole program.
        answer: The arm's last answer (0x476).
        result: The last known result; ``None`` if the operator is told nothing.
        ending: The way it ended, or ``None`` while it goes on.
    """

    operation: str
    number: int = field(default_factory=_NUMBERS, init=False)
    answer: EventOutcome | None = field(default=None, init=False)
    result: EventOutcome | None = field(default=None, init=False)
    ending: Ending | None = field(default=None, init=False)

    def answered(self, index: int, at_s: float) -> None:
        """Note the arm's answer (0x476).

        Args:
            index: The setting that the answer names.
            at_s: Monotonic time.
        """
        figures = {"index": f"0x{index:02X}"}
        self.answer = EventOutcome(ANSWERED.id, at_s, Level.DONE, figures)

    def report(self, result: EventOutcome) -> None:
        """Note an interim result."""
        if self.ending is None:
            self.result = result

    def close(self, ending: Ending, result: EventOutcome | None = None) -> None:
        """Note the way it ended; the first one counts.

        Args:
            ending: The way it ended.
            result: The result as told to the operator.
        """
        if self.ending is None:
            self.ending, self.result = ending, result or self.result


def refusal_of(answer: Started | Refusal | None) -> Refusal | None:
    """Return why an operation did not begin, or ``None``."""
    return None if isinstance(answer, Started) else answer


def ending_of(refusal: Refusal) -> Ending:
    """Return the way a command ends by this reason: cut off, failed or refused."""
    if refusal.reason in _CUT_OFF:
        return Ending.CUT_OFF
    return Ending.FAILED if refusal.reason in _IN_VAIN else Ending.REFUSED
