"""The evidence that the arm heard after a short silence is the one of before: pure.

A cell that was confirmed for an arm stays in force only for that very arm. Two arms of one make
answer alike but for their numbers and limits, and rarely stand alike; one that was switched off,
moved or exchanged has had its motors off.
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.state import is_fresh

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.link.handshake import Handshake

SILENT_S: Final = 10.0
"""An arm that was not heard for this long may be any."""
SAME_PLACE_DEG: Final = 1.0
"""Every joint of the same arm is found this near to where it was."""


class Likeness(enum.Enum):
    """The result of comparing an arm heard after a silence with the one before it."""

    SAME = enum.auto()
    NOT_KNOWN = enum.auto()
    """Its answers have not come yet."""
    OTHER = enum.auto()
    """It may be another one, or was switched off."""


@dataclass(frozen=True, slots=True)
class ArmEvidence:
    """The last answers and angles of an arm, to tell it from another one later.

    Attributes:
        heard_s: Monotonic time at which it was last heard.
        answers: Its answers to the questions for its version and its limits.
        joints_deg: Its six joint angles then.
    """

    heard_s: float
    answers: tuple[object, ...]
    joints_deg: tuple[float, ...]

    def likeness(self, state: ArmState, handshake: Handshake | None, came_s: float) -> Likeness:
        """Return whether an arm that has come is the one of this evidence.

        Args:
            state: The state of that arm, from its feedback since it came.
            handshake: The questions to it.
            came_s: Monotonic time at which it was first heard.
        """
        joints_deg = state.angles_deg()
        enabled = [each.value.enabled for each in state.drivers_slow if each is not None]
        if came_s - self.heard_s >= SILENT_S or not all(enabled):
            return Likeness.OTHER
        if joints_deg is not None and not _continues(self.joints_deg, joints_deg):
            return Likeness.OTHER
        if handshake is None or not handshake.done:
            return Likeness.NOT_KNOWN
        after = evidence_of(state, handshake)
        if after is None:
            answered = _answers(state, handshake) is not None
            return Likeness.NOT_KNOWN if answered else Likeness.OTHER
        return Likeness.SAME if after.answers == self.answers else Likeness.OTHER


def evidence_of(state: ArmState, handshake: Handshake | None) -> ArmEvidence | None:
    """Return the evidence of an arm that is heard; ``None``: it is not known well enough.

    Its answers must be complete, and all its motors recently reported as enabled.
    """
    heard_s, joints_deg = state.last_feedback_s, state.angles_deg()
    if handshake is None or heard_s is None or joints_deg is None:
        return None
    answers = _answers(state, handshake)
    enabled = all(
        each is not None and is_fresh(each.at_s, heard_s) and each.value.enabled
        for each in state.drivers_slow
    )
    return ArmEvidence(heard_s, answers, joints_deg) if answers is not None and enabled else None


def _answers(state: ArmState, handshake: Handshake) -> tuple[object, ...] | None:
    """Return what the arm has answered; ``None`` if a question has no answer."""
    identity = handshake.identity
    if identity is None or not handshake.done or state.joints_without_limits():
        return None
    limits = tuple(each.value for each in state.limits if each is not None)
    accelerations = tuple(each.value for each in state.accelerations_deg_s2 if each is not None)
    # type and batch are shortened by a lost frame, and do not tell arms apart
    said = identity.software, identity.hardware, identity.date, identity.node_number
    return said, limits, accelerations


def _continues(before_deg: tuple[float, ...], now_deg: tuple[float, ...]) -> bool:
    return all(
        abs(now - before) <= SAME_PLACE_DEG for before, now in zip(before_deg, now_deg, strict=True)
    )
