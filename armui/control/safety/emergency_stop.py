"""The emergency stop, followed until the arm itself reports that it has stopped: pure."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.state import ArmState
from armui.control.operating_state import StopState
from armui.protocol.codes import ArmStatusCode
from armui.protocol.frame import Frame

_REPEAT_S: Final = 0.1
"""A stop is sent again after this time until the arm confirms it."""
_UNCONFIRMED_S: Final = 0.5
"""A stop not confirmed after this time is told the operator."""
_BY_ITSELF_S: Final = 10.0
"""A stop older than this goes to an arm that was away only if the operator asks again."""
_AWAY_S: Final = 1.0
"""An arm not heard for this long was away: it may be another one, or switched on again."""


@dataclass(slots=True)
class _Outstanding:
    """A stop that has been asked for and not been confirmed.

    Attributes:
        frames: The frames of the stop.
        since_s: Since when the arm's confirmation is awaited.
        asked_s: The time at which it was last asked for.
        sent_s: The time at which it was last sent.
        reached_s: The time at which the arm was last heard.
        lapsed: True if it is no longer sent automatically.
    """

    frames: Sequence[Frame]
    since_s: float
    asked_s: float
    sent_s: float
    reached_s: float
    lapsed: bool = False


class EmergencyStop:
    """Sends a stop at once, and every 100 ms until 0x2A1 confirms it.

    A stop asked for while the device is lost is kept and goes out as soon as it is back. After ten
    seconds it goes out by itself only to an arm that has been heard all the time; else it has
    lapsed, and the operator either asks for it again or withdraws it.

    Args:
        send: Puts frames on the bus ahead of everything that waits; returns false if it cannot.
    """

    def __init__(self, send: Callable[[Sequence[Frame]], bool]) -> None:
        self._send = send
        self._stop: _Outstanding | None = None

    @property
    def requested(self) -> bool:
        """True if a stop has been asked for that the arm has not confirmed."""
        return self._stop is not None

    @property
    def lapsed(self) -> bool:
        """True if the stop is outstanding and no longer sent automatically."""
        return self._stop is not None and self._stop.lapsed

    def unconfirmed(self, now_s: float) -> bool:
        """Return whether the confirmation is overdue."""
        return self._stop is not None and now_s - self._stop.since_s > _UNCONFIRMED_S

    def request(self, frames: Sequence[Frame], now_s: float) -> bool:
        """Send a stop now; return whether the frames are on the bus."""
        before = self._stop
        since_s = now_s if before is None or before.lapsed else before.since_s
        self._stop = _Outstanding(frames, since_s, asked_s=now_s, sent_s=now_s, reached_s=now_s)
        return self._send(frames)

    def follow_arm(self, state: ArmState, now_s: float, *, online: bool) -> bool:
        """Take in the feedback, repeat a stop that is due; return whether it was just confirmed."""
        stop = self._stop
        if stop is None:
            return False
        if state.status is not None and state.status.at_s > stop.since_s and is_stopped(state):
            self._stop = None
            return True
        # An arm that was away may be another one, or switched on again: for it the stop goes on by
        # itself for ten seconds only, then the operator is asked (S5).
        if now_s - stop.asked_s > _BY_ITSELF_S and now_s - stop.reached_s > _AWAY_S:
            stop.lapsed = True
        if online:
            stop.reached_s = now_s
        if not stop.lapsed and now_s - stop.sent_s >= _REPEAT_S:
            stop.sent_s = now_s
            self._send(stop.frames)
        return False

    def reset(self) -> None:
        """Drop the request: it is withdrawn, or another arm is connected."""
        self._stop = None

    def state(self, state: ArmState, now_s: float, *, online: bool, resuming: bool) -> StopState:
        """Return the state of the stop.

        An arm whose status is not heard may no longer be stopped: for it the button must stop, not
        recover.
        """
        if self.requested:
            return StopState.REQUESTED
        if resuming:
            return StopState.RESUMING
        stopped = online and is_stopped(state) and status_is_fresh(state, now_s)
        return StopState.STOPPED if stopped else StopState.RUNNING


def is_stopped(state: ArmState) -> bool:
    """Return whether the last status heard says that the arm is stopped."""
    status = state.status
    return status is not None and status.value.arm_status == ArmStatusCode.EMERGENCY_STOP


def status_is_fresh(state: ArmState, now_s: float) -> bool:
    """Return whether the status was heard within the last half second."""
    return state.status is not None and state.status.fresh(now_s)


class StopWatch:
    """Watches a confirmed stop: only this program's operator may undo it.

    Attributes:
        holds: True while the operator's stop is confirmed and nobody has undone it.
    """

    def __init__(self) -> None:
        self.holds = False
        self._resumed_s: float | None = None

    def confirmed(self) -> None:
        """Note that the arm has confirmed a stop of the operator."""
        self.holds = True
        self._resumed_s = None

    def undone(self, state: ArmState, now_s: float, *, resuming: bool) -> bool:
        """Return whether somebody else has just undone the stop.

        A resume of this program may be why as long as no status later than it says «stopped».

        Args:
            state: The arm as heard.
            now_s: Monotonic time.
            resuming: True if this program's own resume is under way.
        """
        if resuming:
            self._resumed_s = now_s
        status = state.status
        if not self.holds or status is None or not status.fresh(now_s):
            return False
        if is_stopped(state):
            if self._resumed_s is not None and status.at_s > self._resumed_s:
                self._resumed_s = None
            return False
        self.holds = False
        return self._resumed_s is None

    def reset(self) -> None:
        """Forget the stop, because another connection begins."""
        self.holds = False
