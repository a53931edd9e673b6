"""Tells the operator when the arm comes, goes and answers, and when frames are lost."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from armui.arm.state import FRESH_FOR_S, PAUSE_S
from armui.control.context import Context, ControllerPart
from armui.control.events import Notice
from armui.control.link.link_state import LinkState
from armui.control.requests import reports
from armui.control.requests.reports import OFFLINE_NOTICE, ONLINE
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.link.connection import Connection
    from armui.control.operations.outcome_events import EmitEvent

FRAMES_DROPPED = Notice(
    "frames_dropped",
    "{count} frames were lost before the program could read them ({total} since connecting): "
    "the computer is too busy, or the adapter too slow.",
    Level.WARNING,
    EventKind.ODDITY,
    streams=True,
)

FEEDBACK_LATE = Notice(
    "feedback_late",
    "Feedback arrived late: no joint angles came for {value} ms. The computer, the adapter or the "
    "bus was busy; nothing about the arm is concluded from that.",
    Level.WARNING,
    EventKind.ODDITY,
    streams=True,
)

OFFLINE_BUSY = Notice(
    "offline_busy",
    "The arm is offline: nothing is heard from it, and it may still be moving. This computer "
    "itself stood still for {value} ms meanwhile: close what keeps it busy. If this comes again on "
    "a quiet computer, check the arm's power, the CAN cable and the bit rate.",
    Level.WARNING,
    EventKind.LINK,
)

_EVERY_S: Final = 10.0
"""Further losses and gaps are reported at most this often, so as not to fill the event log."""
_STOOD_STILL_S: Final = 0.25
"""A loss of the arm is reported as the computer's own if the ticks, every 33 ms, just paused for
longer than this."""


class LinkWatch:
    """Reports events of the connection; :meth:`reset` tells it that another one begins.

    Args:
        connection: The way to the arm.
        emit_event: Takes the events.
    """

    def __init__(self, connection: Connection, emit_event: EmitEvent) -> None:
        self._connection = connection
        self._emit_event = emit_event
        self._was_online = False
        self._answers_told = False
        self._looked_s = self._still_until_s = -math.inf
        self._still_s = 0.0

    def follow_online(self, now_s: float) -> None:
        """Tell the operator when the arm has come or gone."""
        gap_s, self._looked_s = now_s - self._looked_s, now_s
        if _STOOD_STILL_S < gap_s < math.inf:
            self._still_s, self._still_until_s = gap_s, now_s
        link = self._connection.link
        online = link is LinkState.ONLINE
        if online is self._was_online:
            return
        self._was_online = online
        if online:
            self._answers_told = False
        if link is LinkState.OFFLINE and now_s - self._still_until_s < FRESH_FOR_S:
            self._emit_event(OFFLINE_BUSY, value=round(1e3 * self._still_s))
        elif link in {LinkState.ONLINE, LinkState.OFFLINE}:
            self._emit_event(ONLINE if online else OFFLINE_NOTICE)

    def follow_handshake(self, state: ArmState) -> None:
        """Tell the operator the arm's answers, once it has answered everything."""
        handshake = self._connection.handshake
        if handshake is None or not handshake.done or self._answers_told:
            return
        self._answers_told = True
        for notice, figures in reports.on_handshake(state, handshake.generation):
            self._emit_event(notice, **figures)

    def arm_came(self) -> None:
        """Tell the answers once more, because the arm that came may be another one."""
        self._answers_told = False

    def reset(self) -> None:
        """Regard the arm as offline, because another connection begins."""
        self._was_online = False
        self._looked_s = self._still_until_s = -math.inf


class DroppedFrames(ControllerPart):
    """Tells the first loss of frames at once, and further losses at most every 10 s.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._reported = 0
        self._reported_s: float | None = None

    def follow_arm(self) -> None:
        """Compare the count; called regularly while a device is open."""
        dropped = self._context.connection.frames_dropped
        if dropped <= self._reported:
            return
        now_s = self._context.clock()
        if self._reported_s is None or now_s - self._reported_s >= _EVERY_S:
            self._context.emit_event(FRAMES_DROPPED, count=dropped - self._reported, total=dropped)
            self._reported, self._reported_s = dropped, now_s

    def forget_arm(self) -> None:
        """Count from 0 again, as the next device does."""
        self._reported, self._reported_s = 0, None


class LateFeedback(ControllerPart):
    """Tells the first gap in the arrival of the angles at once, and the longest of 10 s later.

    Shorter ones than :data:`PAUSE_S` end nothing and are not told; after half a second without any
    feedback the arm is offline, and that is told instead.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._seen_s = self._reported_s = -math.inf
        self._longest_s = 0.0

    def follow_arm(self) -> None:
        """Look for another gap; called regularly while a device is open."""
        context = self._context
        gap, device, now_s = context.state().gap, context.connection.device, context.clock()
        if gap is not None and gap.at_s > self._seen_s:
            self._seen_s, self._longest_s = gap.at_s, max(self._longest_s, gap.value)
        live = device is not None and device.recorded is None
        if live and self._longest_s > PAUSE_S and now_s - self._reported_s >= _EVERY_S:
            context.emit_event(FEEDBACK_LATE, value=round(1e3 * self._longest_s))
            self._reported_s, self._longest_s = now_s, 0.0

    def forget_arm(self) -> None:
        """Forget what was not told yet: it was of another connection."""
        self._longest_s = 0.0
