"""The guided check of the arm's reference: the next joint, and what was answered: pure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.limits import JOINTS

FITS_DEG: Final = 2.0
"""A joint that reports its mark within this fits: marks are read by eye."""
_WITHOUT_MARK: Final = frozenset({2, 3})
"""The joints that the maker gives no mark: a taught pose serves."""


@dataclass(frozen=True, slots=True)
class CheckStep:
    """One joint of the check.

    Attributes:
        joint: The joint (1–6).
        by_hand: It is brought to its mark by hand, with the motors off; otherwise it may be driven.
        mark_deg: The angle it must report there; ``None`` for a joint with neither a mark nor a
            taught pose, which is judged by eye.
    """

    joint: int
    by_hand: bool
    mark_deg: float | None


class ReferenceCheck:
    """The answers of one check, joint by joint; the joints in doubt come first.

    Args:
        doubtful: The joints in doubt: nothing drives them.
        pose_deg: The pose taught as reference; empty: none.

    Attributes:
        looked: The arm was looked at as a whole; before that nothing is driven.
    """

    def __init__(self, doubtful: Sequence[int], pose_deg: Sequence[float]) -> None:
        self._by_hand = set(doubtful)
        self._pose_deg = tuple(pose_deg)
        self._answers: dict[int, float] = {}
        self.looked = False

    @property
    def by_hand(self) -> tuple[int, ...]:
        """The joints that nothing drives in this check."""
        return tuple(sorted(self._by_hand))

    @property
    def steps(self) -> tuple[CheckStep, ...]:
        """The joints in the order of the check."""
        joints = sorted(JOINTS, key=lambda joint: (joint not in self._by_hand, joint))
        return tuple(CheckStep(each, each in self._by_hand, self._mark(each)) for each in joints)

    @property
    def next(self) -> CheckStep | None:
        """The first joint that is not answered for, or ``None``."""
        return next((step for step in self.steps if step.joint not in self._answers), None)

    @property
    def unanswered(self) -> tuple[int, ...]:
        """The joints that are not answered for."""
        return tuple(joint for joint in JOINTS if joint not in self._answers)

    @property
    def off_deg(self) -> dict[int, float]:
        """The joints that are off, each with its degrees."""
        return {j: off for j, off in sorted(self._answers.items()) if abs(off) > FITS_DEG}

    def suspect(self, joints: Sequence[int]) -> None:
        """Note joints that do not stand where the picture shows them: nothing drives them."""
        self._by_hand.update(joints)
        for joint in joints:
            self._answers.pop(joint, None)

    def answered(self, joint: int) -> float | None:
        """Return by how many degrees a joint was said to be off, or ``None``."""
        return self._answers.get(joint)

    def answer(self, joint: int, off_deg: float) -> None:
        """Note by how many degrees a joint reports another angle than where it stands."""
        self._answers[joint] = off_deg

    def take_back(self, joint: int) -> None:
        """Forget the answer for a joint."""
        self._answers.pop(joint, None)

    def _mark(self, joint: int) -> float | None:
        if joint not in _WITHOUT_MARK:
            return 0.0
        return self._pose_deg[joint - 1] if self._pose_deg else None
