"""How far each joint may swing by itself from where the arm stands; for the joint inspection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINT_OUT_OF_LIMITS, JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.ways.law import judge
from armui.ways.way import straight_way

if TYPE_CHECKING:
    from armui.ways.law import Marks
    from armui.ways.rules import Rules

_SHARES: Final = tuple(eighths / 8.0 for eighths in range(8, 0, -1))
_BEYOND_DEG: Final = 0.5
"""The space that must be free beyond each end, as a joint turns back with a delay."""
LEAST_DEG: Final = 10.0
"""A joint that may swing over less in all is not measured: it hardly comes up to its speed."""


SWING_LIMITED = Reason("swing_limited", "Its limits are {minimum}° and {maximum}°.")


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
            why = why or _in_its_words(joint, refusal)
        return 0.0, why

    found = []
    for joint in JOINTS:
        (below, why_below), (above, why_above) = reach(joint, -1.0), reach(joint, 1.0)
        found.append(Swing(joint, below, above, why_below or why_above))
    return tuple(found)


def _in_its_words(joint: int, refusal: Refusal) -> Refusal:
    """Return a reason in the words of a swing, as the operator has typed no angle."""
    own = refusal.reason == JOINT_OUT_OF_LIMITS and refusal.params.get("joint") == joint
    if not own:
        return refusal
    return SWING_LIMITED(**{name: refusal.params[name] for name in ("minimum", "maximum")})
