"""Follows the arm's identifier offsets (0x470) from requests and feedback: pure.

What moves is 0x2A1–0x2A8 and 0x150–0x15F. The feedback tells its own offset; the offset of the
commands cannot be heard or asked for, so it is known only from what was set and seen to be taken.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final

from armui.arm.state import ArmState, is_fresh
from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codes import ArmStatusCode, ControlMode

_SILENT_S: Final = 0.5
"""Other feedback is taken for the same arm's after the known one was silent for this time."""
_SETTLED_S: Final = 0.05
"""A status received this long after the setting already reflects it."""


@dataclass(frozen=True, slots=True)
class RequestedOffset:
    """Offsets that were sent to the arm and have not been seen in use.

    Attributes:
        addressing: The offsets that were sent.
        since_s: The monotonic time of sending.
        answered_s: The time at which 0x476 confirmed that the arm keeps them, or ``None``.
        ends_input: True if sent to a teaching input: any feedback of it then shows that it has
            obeyed.
    """

    addressing: Addressing
    since_s: float
    answered_s: float | None = None
    ends_input: bool = False


class OffsetFollower:
    """Determines the identifiers under which the arm is addressed.

    Two arms with different offsets are never mixed: as long as the feedback in use goes on, other
    feedback is another arm's.

    Attributes:
        addressing: The offsets in use.
        control_known: True if the arm is known to take commands under them: false for an arm that
            was found with shifted feedback and has not been set since.
        requested: The offsets that were sent and may come into use at any time.
        keeps_input: True if the arm has answered that it keeps the role of a teaching input, and
            has not been heard as one since.
    """

    def __init__(self, addressing: Addressing = Addressing()) -> None:  # noqa: B008 - frozen
        self.addressing = addressing
        self.control_known = True
        self.requested: RequestedOffset | None = None
        self.keeps_input = False
        self._listening_since_s: float | None = None

    @property
    def certain(self) -> bool:
        """True if commands reach the arm.

        Feedback and commands move together: while the old feedback is heard, the old commands reach
        the arm, unless only the commands are to move.
        """
        requested = self.requested
        moves_unseen = (
            requested is not None
            and requested.addressing.feedback_offset == self.addressing.feedback_offset
        )
        return self.control_known and not moves_unseen

    def request(self, addressing: Addressing, now_s: float, *, ends_input: bool = False) -> None:
        """Note offsets that were sent to the arm, which may use them now or later."""
        same = addressing == self.addressing and self.control_known
        requested = RequestedOffset(addressing, now_s, ends_input=ends_input)
        self.requested = None if same and self.requested is None else requested

    def answered(self, now_s: float) -> None:
        """Note the arm's answer (0x476) that it keeps the offsets sent last."""
        if self.requested is not None:
            self.requested = replace(self.requested, answered_s=now_s)

    def listen_anew(self, now_s: float) -> None:
        """Restart the time within which the known feedback must be heard again."""
        self._listening_since_s = now_s

    def follow_arm(self, state: ArmState, now_s: float, *, came: bool) -> bool:
        """Take in the feedback; return whether other identifiers have just come into use.

        Args:
            state: The arm as heard.
            now_s: Monotonic time.
            came: True if it has just come online: after a power cycle it uses the offsets it keeps.
        """
        if self._listening_since_s is None or came:
            self._listening_since_s = now_s
        requested = self.requested
        if requested is not None and self._taken_unseen(requested, state, came=came):
            return self._use(requested.addressing, now_s, known=True)
        if came and self.addressing.control_offset:
            self.control_known = False  # it may be another arm than the one that was set
        own = OFFSETS.index(self.addressing.feedback_offset)
        since_s = self._listening_since_s
        if now_s - max(state.status_heard_s[own] or since_s, since_s) < _SILENT_S:
            return False
        heard = [
            offset
            for offset, at_s in zip(OFFSETS, state.status_heard_s, strict=True)
            if is_fresh(at_s, now_s) and offset != self.addressing.feedback_offset
        ]
        if requested is not None and requested.addressing.feedback_offset in heard:
            return self._use(requested.addressing, now_s, known=True)
        if not heard:
            return False
        # The feedback does not show the offset of the commands: the one in use is kept, as
        # unknown; 0x00 would be a guess.
        return self._use(Addressing(heard[0], self.addressing.control_offset), now_s, known=False)

    def _taken_unseen(self, requested: RequestedOffset, state: ArmState, *, came: bool) -> bool:
        """Return whether only the commands' offset changed, in standby or at the arm's next start.

        The feedback does not show it, so the arm must have answered that it keeps the setting: if a
        lost frame counted as taken, every later command would go to an identifier nobody hears.
        """
        if requested.addressing.feedback_offset != self.addressing.feedback_offset:
            return False
        if requested.answered_s is None and not (came and requested.ends_input):
            return False
        since_s = requested.since_s if requested.answered_s is None else requested.answered_s
        status = state.status
        if status is None or status.at_s < since_s + _SETTLED_S:
            return False
        standby = status.value.control_mode == ControlMode.STANDBY
        return came or (standby and status.value.arm_status != ArmStatusCode.EMERGENCY_STOP)

    def _use(self, addressing: Addressing, now_s: float, *, known: bool) -> bool:
        moved = addressing != self.addressing
        self.addressing, self.control_known = addressing, known
        self.requested = None
        self._listening_since_s = now_s
        return moved
