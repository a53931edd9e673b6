"""Ends motion for the operator: the emergency stop, followed until confirmed, and the halt."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState, is_fresh
from armui.control.context import REFUSED
from armui.control.events import Notice
from armui.control.link.link_state import LinkState, why_only_heard, why_unreachable
from armui.control.motion.abort import ending_frames
from armui.control.operating_state import StopState
from armui.control.operations.outcome_events import EmitEvent, close_and_emit, report_and_emit
from armui.control.operations.started import Ending, Started
from armui.control.safety.emergency_stop import EmergencyStop, StopWatch
from armui.protocol import commands
from armui.protocol.addressing import OFFSETS
from armui.protocol.frame import Frame
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.arm.device import Device
    from armui.control.link.connection import Connection

HALT_LISTEN_ONLY = Reason(
    "halt_listen_only",
    "This connection only listens: nothing is sent on it but the emergency stop.",
)
STOP_SENT = Notice(
    "stop_sent",
    "Emergency stop sent. The motors only brake and the arm sinks: hold the arm.",
    Level.WARNING,
    EventKind.COMMAND,
)
STOP_NOT_SENT = Notice(
    "stop_not_sent",
    "The emergency stop is NOT on the bus: no CAN device is open, or it does not take the "
    "frame. Cut the arm's power if it moves.",
    Level.FAULT,
    EventKind.COMMAND,
)
STOP_REACHES_OTHER = Notice(
    "stop_reaches_other",
    "A second arm is heard on this bus (feedback at {feedback}): the stop reaches it, too.",
    Level.WARNING,
    EventKind.RESULT,
    Asker.PROGRAM,
)
STOP_LAPSED = Notice(
    "stop_lapsed",
    "A stop is outstanding: the arm was away for more than 10 seconds and has not confirmed "
    "it. It is not sent by itself any more. Press the emergency stop if the arm must stop.",
    Level.FAULT,
    EventKind.RESULT,
)
STOP_WITHDRAWN = Notice(
    "stop_withdrawn",
    "The outstanding emergency stop was withdrawn; the arm has not confirmed it.",
    Level.WARNING,
    EventKind.RESULT,
    Asker.OPERATOR,
)
STOP_ABANDONED = Notice(
    "stop_abandoned",
    "The arm on {device} has never confirmed its emergency stop, and another device is "
    "connected now. Cut that arm's power if it moves.",
    Level.FAULT,
    EventKind.RESULT,
)
STOP_UNDONE = Notice(
    "stop_undone",
    "The emergency stop was undone, and not by this program: another host has released the "
    "arm, or it was switched off and on. Press the emergency stop again if it must stay.",
    Level.FAULT,
    EventKind.RESULT,
)
HALT_SENT = Notice(
    "halt_sent",
    "Halt sent: the motion ends, the motors keep their power.",
    Level.INFO,
    EventKind.COMMAND,
)
HALT_NOT_OUT = Notice(
    "halt_not_out",
    "The halt is NOT on the bus yet: the adapter does not take it. It goes out as soon as "
    "that is possible. Press the emergency stop if the arm moves.",
    Level.FAULT,
    EventKind.COMMAND,
)
HALT_AT_REST = Notice(
    "halt_at_rest", "The arm stands still and holds.", Level.DONE, EventKind.RESULT
)
STOP_CONFIRMED = Notice(
    "stop_confirmed",
    "The arm has confirmed the emergency stop. Release stands in the line of the next step.",
    Level.WARNING,
    EventKind.RESULT,
)
STOP_UNCONFIRMED = Notice(
    "stop_unconfirmed",
    "The arm has NOT confirmed the emergency stop; it is sent again and again. Cut the arm's "
    "power if it moves.",
    Level.FAULT,
    EventKind.RESULT,
)


_AT_REST_S: Final = 1.3
"""Rest within this time of a halt is its effect: 1 s, and the time to measure it."""


class Stopping:
    """Sends stops and halts on every identifier offset, and follows their effect.

    The offset of the commands cannot be heard, so each of 0x150, 0x160 and 0x170 is sent: the arm
    obeys the one it listens to.

    Args:
        connection: The way to the arm.
        emit_event: Takes the events.
        clock: Monotonic time in seconds.
        end_all: Has every part of the program give up what would move the arm.

    Attributes:
        stop_again: True if a stop that another host undoes is sent again automatically.
    """

    def __init__(
        self,
        connection: Connection,
        emit_event: EmitEvent,
        clock: Callable[[], float],
        end_all: Callable[[], None],
    ) -> None:
        self._connection = connection
        self._emit_event = emit_event
        self._clock = clock
        self._end_all = end_all
        self.emergency_stop = EmergencyStop(connection.send_urgent)
        self._watch = StopWatch()
        self._asked_of: Device | None = None
        self._was_unconfirmed = False
        self._was_lapsed = False
        self._halted_s: float | None = None
        self._stop_started: Started | None = None
        self._halt_started: Started | None = None
        self.stop_again = False

    # The emergency stop -----------------------------------------------------------------------

    def stop(self) -> None:
        """Stop the arm at once: past every other frame, whatever else is under way (0x150)."""
        connection = self._connection
        if connection.device is None:
            started = self._begin_stop()
            started.close(Ending.FAILED)
            self._emit_event(STOP_NOT_SENT, started)
            return
        self._asked_of = connection.device
        self._halted_s = None
        frames = self._on_every_offset(commands.emergency_stop(connection.codec))
        # The stop is handed over first, so that no part of the program that fails can hold it up
        # (S3).
        on_the_bus = self.emergency_stop.request(frames, self._clock())
        self._end_all()
        notice = STOP_SENT if on_the_bus else STOP_NOT_SENT
        self._emit_event(notice, self._begin_stop())
        self._name_others()

    def withdraw(self) -> None:
        """Withdraw a stop that the arm has not confirmed."""
        if self.emergency_stop.requested:
            self.emergency_stop.reset()
            self._close(self._stop_started, Ending.CUT_OFF, STOP_WITHDRAWN)

    def on_connecting(self, device: Device) -> None:
        """Drop an outstanding stop, unless it was meant for this very device."""
        self._watch.reset()
        self._halted_s = None
        if (
            self.emergency_stop.requested
            and self._asked_of is not None
            and not device.same(self._asked_of)
        ):
            self.emergency_stop.reset()
            self._close(self._stop_started, Ending.CUT_OFF, STOP_ABANDONED, device=self._asked_of)

    def follow_arm(self, state: ArmState, now_s: float, *, resuming: bool, still: bool) -> None:
        """Follow stop and halt in the feedback; called at each tick, whatever else fails."""
        emergency_stop = self.emergency_stop
        online = self._connection.link is LinkState.ONLINE
        if emergency_stop.follow_arm(state, now_s, online=online):
            self._watch.confirmed()
            self._close(self._stop_started, Ending.DONE, STOP_CONFIRMED)
        unconfirmed = emergency_stop.unconfirmed(now_s)
        if unconfirmed and not self._was_unconfirmed:
            self._report_stop(STOP_UNCONFIRMED)
        if emergency_stop.lapsed and not self._was_lapsed:
            self._report_stop(STOP_LAPSED)
        self._was_unconfirmed, self._was_lapsed = unconfirmed, emergency_stop.lapsed
        if self._watch.undone(state, now_s, resuming=resuming):
            self._emit_event(STOP_UNDONE)
            # That another host undid the stop is always told; stopping again is a setting (S27).
            if self.stop_again:
                self.stop()
        self._follow_halt(state, now_s, still=still)

    def state(self, state: ArmState, now_s: float, *, resuming: bool) -> StopState:
        """Return the state of the stop; see :meth:`EmergencyStop.state`."""
        online = self._connection.link is LinkState.ONLINE
        return self.emergency_stop.state(state, now_s, online=online, resuming=resuming)

    def _name_others(self) -> None:
        """Warn of the arms heard under other offsets: the stop reaches them, too."""
        own = self._connection.offsets.addressing.feedback_offset
        heard_s = self._connection.newest.status_heard_s
        for offset, at_s in zip(OFFSETS, heard_s, strict=True):
            if offset != own and is_fresh(at_s, self._clock()):
                self._emit_event(STOP_REACHES_OTHER, feedback=f"0x{0x2A1 + offset:03X}")

    def _on_every_offset(self, frames: Sequence[Frame]) -> list[Frame]:
        """Return the frames on this arm's own identifier first, the two others directly behind."""
        addressing = self._connection.codec.addressing
        return [
            Frame(shifted, frame.data)
            for frame in frames
            for shifted in addressing.on_every_offset(frame.arbitration_id)
        ]

    # Halt and hold ----------------------------------------------------------------------------

    def why_no_halt(self) -> Refusal | None:
        """Return the reason against a halt: no arm is heard, or it may only be listened to."""
        device = self._connection.device
        if device is not None and device.listen_only and device.recorded is None:
            return HALT_LISTEN_ONLY()
        if (refusal := why_only_heard(device)) is not None:
            return refusal
        return why_unreachable(self._connection.link)

    def halt(self, end_driven: Callable[[], None]) -> Refusal | None:
        """End any motion with power on (0x150): the joints hold where they come to rest.

        The frames go ahead of everything that waits, which is dropped.

        Args:
            end_driven: Ends whatever this program drives; called when the frames are on their way.
        """
        refusal = self.why_no_halt()
        if refusal is not None:
            self._emit_event(REFUSED, reason=refusal)
            return refusal
        frames = self._on_every_offset(ending_frames(self._connection))
        # The frames go first: what the parts end below must not hold the halt up (S26).
        out = self._connection.send_urgent(frames)
        end_driven()
        self._halted_s = self._clock()
        if self._halt_started is not None:
            self._halt_started.close(Ending.CUT_OFF)
        self._halt_started = Started("halt")
        self._emit_event(HALT_SENT if out else HALT_NOT_OUT, self._halt_started)
        return None

    def _follow_halt(self, state: ArmState, now_s: float, *, still: bool) -> None:
        if self._halted_s is None:
            return
        if still:
            self._halted_s = None
            self._close(self._halt_started, Ending.DONE, HALT_AT_REST)
        elif now_s - max(self._halted_s, _gap_ended_s(state)) > _AT_REST_S:
            self._halted_s = None  # the authority reports a cancel without effect
            if self._halt_started is not None:
                self._halt_started.close(Ending.FAILED)

    # The outcome of stop and halt -------------------------------------------------------------

    def _begin_stop(self) -> Started:
        if self._stop_started is not None:
            self._stop_started.close(Ending.CUT_OFF)
        self._stop_started = Started("stop")
        return self._stop_started

    def _report_stop(self, notice: Notice) -> None:
        report_and_emit(self._emit_event, self._clock(), self._stop_started, notice)

    def _close(
        self, started: Started | None, ending: Ending, notice: Notice, **params: object
    ) -> None:
        close_and_emit(self._emit_event, self._clock(), started, ending, notice, **params)


def _gap_ended_s(state: ArmState) -> float:
    """Return when feedback last came back after a gap: only from then on rest can be measured."""
    return -math.inf if state.gap is None else state.gap.at_s
