"""The state of the arm's reference for the operator, and the reasons that follow from it: pure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from armui.arm.refusal import Reason, Refusal

REFERENCE_IN_DOUBT = Reason(
    "reference_in_doubt",
    "Joint {joints} may stand elsewhere than it reports: its reference is in doubt. Check it, or "
    "agree to motions in the line above the panels. Single motions up to {maximum} % need no "
    "agreement.",
)
REFERENCE_CHECK_OPEN = Reason(
    "reference_check_open",
    "The reference is being checked: nothing moves but what the check drives. Finish the check, "
    "or close its window.",
)

SLOW_PERCENT: Final = 10
"""Single motions up to this speed need no agreement while a reference is in doubt."""


@dataclass(frozen=True, slots=True)
class ReferenceStatus:
    """The state of the arm's reference.

    Attributes:
        doubtful: The joints (1–6) whose reference is in doubt.
        allowed: The operator has agreed to motions in spite of that.
        checking: The reference check is open.
        looked: In the check, the arm was looked at as a whole.
        by_hand: In the check, the joints that nothing may drive.
        unanswered: In the check, the joints that are still to be answered for.
        cannot_drive: Why the check cannot drive a joint now, or ``None``.
        slipped: The joints that slipped at the last resume, as ``J1 -5.0°``, until that is noted.
    """

    doubtful: tuple[int, ...] = ()
    allowed: bool = False
    checking: bool = False
    looked: bool = False
    by_hand: tuple[int, ...] = ()
    unanswered: tuple[int, ...] = ()
    cannot_drive: Refusal | None = None
    slipped: str = ""

    @property
    def joints(self) -> str:
        """The joints in doubt for a sentence, as ``2, 5``."""
        return ", ".join(map(str, self.doubtful))

    def why_doubtful(self) -> Refusal | None:
        """Return that joints are in doubt, agreed to or not, as a reason, or ``None``."""
        if not self.doubtful:
            return None
        return REFERENCE_IN_DOUBT(joints=self.joints, maximum=SLOW_PERCENT)

    def why_not_run(self) -> Refusal | None:
        """Return why no run may begin or go on, or ``None``."""
        if self.checking:
            return REFERENCE_CHECK_OPEN()
        return None if self.allowed else self.why_doubtful()

    def why_not_move(self, percent: float) -> Refusal | None:
        """Return why no motion at a speed, in percent, may begin, or ``None``."""
        slow = percent <= SLOW_PERCENT and not self.checking
        return None if slow else self.why_not_run()
