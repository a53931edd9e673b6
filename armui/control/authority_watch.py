"""Passes the feedback to the authority, and reports to the operator what the authority finds."""

from __future__ import annotations

import math
from collections.abc import Callable
from datetime import datetime
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Refusal
from armui.control.event_log.observed import Observed
from armui.control.events import Notice
from armui.control.link.link_state import LinkState
from armui.control.motion.motion_command import CommandKind, End, MotionCommand, Observation
from armui.control.operating_state import OtherHostReport
from armui.control.operations.started import Ending
from armui.control.safety.command_acknowledgement import AcknowledgementMonitor
from armui.protocol.addressing import OFFSETS
from armui.protocol.codes import TARGET_REFUSALS
from armui.telemetry.events import EventKind, EventOutcome, Level

if TYPE_CHECKING:
    from armui.control.authority import Authority
    from armui.control.link.connection import Connection
    from armui.control.operations.outcome_events import EmitEvent

OTHER_HOST_MOVES = Notice(
    "other_host_moves",
    "Another program controls the arm ({frames}).",
    Level.WARNING,
    EventKind.OTHER_HOST,
)
LEADER_ARM_MOVES = Notice(
    "leader_arm_moves",
    "A leader arm moves this arm ({frames}).",
    Level.WARNING,
    EventKind.OTHER_HOST,
)
OTHER_HOST_GONE = Notice(
    "other_host_gone", "Nobody else controls the arm any more.", Level.INFO, EventKind.OTHER_HOST
)
TAKEN_OVER = Notice(
    "taken_over", "Taken over: this program may move the arm.", Level.DONE, EventKind.COMMAND
)
CANCEL_UNHEEDED = Notice(
    "cancel_unheeded",
    "The arm was told to end its motion and still moves. Stop it, or cut its power.",
    Level.FAULT,
    EventKind.RESULT,
)
MOTION_UNHEEDED = Notice(
    "motion_unheeded",
    "The arm has not taken the last motion: it is heard, and does not move. It may listen "
    "under another control offset (Linkage control), or a frame was lost.",
    Level.FAULT,
    EventKind.RESULT,
)
MOTION_TOO_FAST = Notice(
    "motion_too_fast", "Motion ended: too fast. {reason}", Level.FAULT, EventKind.RESULT
)
ARRIVED = Observed("arrived", "Target reached, as the arm reports")
MOTION_CUT = Observed("motion_cut", "Did not reach its end: {end}")


_NAMED_AFTER_S: Final = 0.1
"""After this time the frames show whether they come from a leader arm or another program."""
_CUT_LEVELS: Final = {End.REPLACED: Level.INFO, End.CANCELLED: Level.INFO}


class AuthorityWatch:
    """Looks at the arm and at other hosts on behalf of the authority.

    Args:
        authority: Knows who moves the arm.
        connection: The way to the arm.
        emit_event: Takes the events.
        end_motion: Ends our motion with a reason.

    Attributes:
        authority: The authority that it feeds.
    """

    def __init__(
        self,
        authority: Authority,
        connection: Connection,
        emit_event: EmitEvent,
        end_motion: Callable[[Refusal], None],
    ) -> None:
        self.authority = authority
        self._connection = connection
        self._emit_event = emit_event
        self._end_motion = end_motion
        self._began: tuple[float, datetime] | None = None
        self._was_commanded = False
        self._was_unheeded = False
        self._voided = 0
        self._acknowledgement = AcknowledgementMonitor()

    def observe(self, now_s: float) -> None:
        """Give the authority all feedback received so far; outdated frames are dropped."""
        connection = self._connection
        if connection.device is None:
            return
        offsets = connection.offsets
        self.authority.observe(
            Observation(
                state=connection.newest,
                traffic=connection.traffic,
                offsets=(offsets.addressing.control_offset,) if offsets.certain else OFFSETS,
                online=connection.link is LinkState.ONLINE,
                now_s=now_s,
                waiting=not connection.idle,
                model=connection.model,
            )
        )
        if self.authority.number != self._voided:
            self._voided = self.authority.number
            connection.void(self._voided)

    def follow_arm(self, now_s: float) -> None:
        """Tell the operator who else moves the arm, and end a motion of ours that is too fast."""
        self.observe(now_s)
        authority = self.authority
        other = authority.other
        named = other.since_s is not None and now_s - other.since_s >= _NAMED_AFTER_S
        commanded = other.commands and (named or self._was_commanded)
        if commanded is not self._was_commanded:
            self._was_commanded = commanded
            notice = LEADER_ARM_MOVES if other.is_leader else OTHER_HOST_MOVES
            self._emit_event(notice if commanded else OTHER_HOST_GONE, frames=other.frames)
        if authority.cancel_unheeded and not self._was_unheeded:
            self._emit_event(CANCEL_UNHEEDED)
        self._was_unheeded = authority.cancel_unheeded
        if authority.holds:
            self._acknowledgement.reset()
        elif self._acknowledgement.observe(
            authority.command, authority.ended, self._connection.newest, now_s
        ):
            unheeded = authority.command or authority.over[-1][0]
            _close(
                unheeded,
                Ending.FAILED,
                EventOutcome(MOTION_UNHEEDED.id, now_s, MOTION_UNHEEDED.level),
            )
            self._emit_event(MOTION_UNHEEDED)
        self._follow_motion(now_s)
        if authority.overspeed is not None:
            reason = authority.overspeed
            self._end_motion(reason)
            self._emit_event(MOTION_TOO_FAST, reason=reason)

    def _follow_motion(self, now_s: float) -> None:
        """Close the commands of ours that have ended, or come to rest; a replay does so itself."""
        authority = self.authority
        command = authority.command
        for over, end in authority.over:
            if command is None or over.started is not command.started:
                level = _CUT_LEVELS.get(end, Level.WARNING)
                cut = EventOutcome(MOTION_CUT.id, now_s, level, {"end": end.name})
                _close(over, Ending.CUT_OFF, cut)
        authority.over.clear()
        if command is None or authority.under_way or authority.holds or self._acknowledgement.waits:
            return
        status = self._connection.newest.status
        refused = status is not None and status.value.arm_status in TARGET_REFUSALS
        refused = refused and not self._is_there(command)
        if status is not None and status.value.reached and not refused:
            _close(command, Ending.DONE, EventOutcome(ARRIVED.id, now_s, Level.DONE))
        else:
            figures = {"end": "refused" if refused else "short"}
            short = EventOutcome(MOTION_CUT.id, now_s, Level.WARNING, figures)
            _close(command, Ending.FAILED, short)

    def _is_there(self, command: MotionCommand) -> bool:
        """Return whether the arm is measured nearer to where a way ends than to where it began."""
        measured_deg, way = self.authority.measured_deg(), command.way
        if measured_deg is None or way is None:
            return False
        return math.dist(measured_deg, way.end_deg) < math.dist(measured_deg, way.begin_deg)

    def take_over(self, now_s: float) -> Refusal | None:
        """Take the arm over from another host that pauses; return ``None``, or why not.

        Its last motion goes on until a motion of ours replaces it.
        """
        self.observe(now_s)
        refusal = self.authority.take_over()
        if refusal is None:
            self._emit_event(TAKEN_OVER)
        return refusal

    def report(self) -> OtherHostReport | None:
        """Return the other host that moves the arm, for the operator; ``None``: there is none."""
        other = self.authority.other
        reason = other.why_not()
        if reason is None:
            self._began = None
            return None
        began_s = other.since_s or 0.0
        if self._began is None or self._began[0] != began_s:
            self._began = (began_s, datetime.now().astimezone())
        return OtherHostReport(
            other.frames, self._began[1], other.rate_hz, reason, other.may_be_taken_over
        )

    def reset(self, now_s: float) -> None:
        """Forget the last connection, because another one begins."""
        self._follow_motion(now_s)
        self._acknowledgement.reset()
        self._was_commanded = self._was_unheeded = False
        self._began = None


def _close(command: MotionCommand, ending: Ending, result: EventOutcome) -> None:
    if command.started is not None and command.kind is not CommandKind.REPLAY:
        command.started.close(ending, result)
