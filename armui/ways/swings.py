"""How far each joint may swing by itself from where the arm stands; for the joint inspection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.ways.law import judge
from armui.ways.way import straight_way

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.ways.law import Marks
    from armui.ways.rules import Rules

_SHARES: Final = (1.0, 0.75, 0.5, 0.25)
_BEYOND_DEG: Final = 0.5
"""Beyond each end so much must be free, too: a joint that is told to turn back does so late."""
LEAST_DEG: Final = 10.0
"""A joint that may swing over less in all is not measured: it hardly comes up to its speed."""


@dataclass(frozen=True, slots=True)
class Swing:
    """The swing of one joint.

    Attributes:
        joint: The joint (1–6).
        below_deg, above_deg: How far it swings to either side of where it stands.
        shortened: Why it swings less far than asked for; ``None`` if it does not.
    """

    joint: int
    below_deg: float
    above_deg: float
    shortened: Refusal | None = None

    @property
    def possible(self) -> bool:
        """True if it is wide enough to be measured."""
        return self.below_deg + self.above_deg >= LEAST_DEG


def swings(
    begin_deg: Sequence[float], amplitude_deg: float, rules: Rules, marks: Marks
) -> tuple[Swing, ...]:
    """Return how far each joint may swing, asked of all rules in force; it takes some time.

    Args:
        begin_deg: Where the arm stands.
        amplitude_deg: How far each is to swing to either side.
        rules: The rules in force.
        marks: How far outside the arm was found.
    """

    def reach(joint: int, sign: float) -> tuple[float, Refusal | None]:
        why = None
        for share in _SHARES:
            there_deg = list(begin_deg)
            there_deg[joint - 1] += sign * (share * amplitude_deg + _BEYOND_DEG)
            refusal = judge(straight_way(begin_deg, there_deg), rules.every, marks).refusal
            if refusal is None:
                return share * amplitude_deg, why
            why = why or refusal
        return 0.0, why

    found = []
    for joint in JOINTS:
        (below, why_below), (above, why_above) = reach(joint, -1.0), reach(joint, 1.0)
        found.append(Swing(joint, below, above, why_below or why_above))
    return tuple(found)
