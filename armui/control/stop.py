"""The emergency stop, followed until the arm itself says that it has stopped."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from armui.arm.state import ArmState
from armui.control.situation import StopState
from armui.protocol.codes import ArmStatusCode
from armui.protocol.frame import Frame

_REPEAT_S: Final = 0.1
_UNCONFIRMED_S: Final = 0.5


class StopKeeper:
    """Sends a stop at once and again every 100 ms until 0x2A1 confirms it.

    A stop asked for while the device is lost is kept and goes out as soon as it is back.

    Args:
        send: Puts frames on the bus past everything that waits; says whether it could.
    """

    def __init__(self, send: Callable[[Sequence[Frame]], bool]) -> None:
        self._send = send
        self._again: Sequence[Frame] = ()
        self._requested_s: float | None = None
        self._last_sent_s = 0.0

    @property
    def requested(self) -> bool:
        """Whether a stop has been asked for that the arm has not confirmed."""
        return self._requested_s is not None

    def unconfirmed(self, now_s: float) -> bool:
        """Whether the confirmation is overdue."""
        return self._requested_s is not None and now_s - self._requested_s > _UNCONFIRMED_S

    def request(
        self, frames: Sequence[Frame], now_s: float, again: Sequence[Frame] | None = None
    ) -> bool:
        """Stop now; says whether the frames are on the bus.

        Args:
            frames: What stops it.
            now_s: Monotonic time.
            again: What is sent while it is not confirmed, if that differs.
        """
        self._again = frames if again is None else again
        if self._requested_s is None:
            self._requested_s = now_s
        self._last_sent_s = now_s
        return self._send(frames)

    def advance(self, state: ArmState, now_s: float) -> bool:
        """Take in what was heard, repeat the stop if due; whether it was confirmed just now."""
        if self._requested_s is None:
            return False
        if state.status is not None and state.status.at_s > self._requested_s and is_stopped(state):
            self._requested_s = None
            return True
        if now_s - self._last_sent_s >= _REPEAT_S:
            self._last_sent_s = now_s
            self._send(self._again)
        return False

    def forget(self) -> None:
        """The device was disconnected on purpose."""
        self._requested_s = None

    def state(self, state: ArmState, *, online: bool, resuming: bool) -> StopState:
        """Where the stop stands.

        Of an arm that has fallen silent nobody knows whether it still is stopped: the button that
        recovers a stopped arm must be one that stops it.
        """
        if self.requested:
            return StopState.REQUESTED
        if resuming:
            return StopState.RESUMING
        return StopState.STOPPED if online and is_stopped(state) else StopState.RUNNING


def is_stopped(state: ArmState) -> bool:
    """Whether the arm's last word on it was that it is stopped."""
    status = state.status
    return status is not None and status.value.arm_status == ArmStatusCode.EMERGENCY_STOP
