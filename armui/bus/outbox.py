"""The queue of frames to be sent, with a second queue for the stop, which is always sent first.

Two locks, never taken together by a thread that waits. The queue's lock is held for microseconds,
while frames are put in or taken out; every thread may wait for it. The driver's lock is held while
one frame is in the driver, which may take any time: only the sending thread waits for it without a
limit.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import can

from armui.bus.send_errors import flush_transmit_queue, obeys_its_timeout, queue_is_full
from armui.protocol.frame import Frame
from armui.protocol.motion_frames import is_motion_frame
from armui.system.clock import steady_s
from armui.ways.passes import Pass

if TYPE_CHECKING:
    import can

    from armui.bus.press import Press

KEEP_S: Final = 0.5
"""A batch that could not begin within this time is dropped: a command must not act late."""

BLOCKED_S: Final = 0.5
"""The bus counts as blocked when nothing could be sent for this long."""

_PATIENCE_S: Final = 0.02
"""The time the caller of a stop waits for the frame in the driver, or for the sending thread."""
_SEND_TIMEOUT_S: Final = 0.05
"""The time a driver is given to take one frame; some ignore it (S3)."""


class UnpassedMotionError(Exception):
    """A part of the program was about to send a motion frame without a pass of the gate."""


@dataclass(eq=False, slots=True)
class _Batch:
    """The frames of one call of :meth:`Outbox.put`: all go out, or none.

    Attributes:
        frames: Its frames that have not been sent yet.
        until_s: After this time none of it may begin.
        command: The number of the command it belongs to; ``None``: of none.
        press: The press it belongs to; ``None``: of none.
        begun: True once its first frame has been sent; the rest must follow.
    """

    frames: deque[Frame]
    until_s: float
    command: int | None
    press: Press | None = None
    begun: bool = False

    def is_late(self, now_s: float) -> bool:
        """Return whether it may not begin any more."""
        return self.until_s < now_s or (self.press is not None and self.press.is_over(now_s))


class _Port:
    """One open bus: its driver, and who may be held up by it.

    Attributes:
        driver: Held while a frame is in the driver.
        in_driver_since_s: Since when a frame is in the driver; ``None`` if none is.
        direct: A stop is written by the thread that asks for it; else by the sending thread.
    """

    def __init__(self, bus: can.BusABC, *, direct: bool) -> None:
        self.bus = bus
        self.direct = direct
        self.driver = threading.Lock()
        self.in_driver_since_s: float | None = None


class Outbox:
    """Queues frames for one bus; used by the sending thread and by the threads that send.

    Args:
        clock: Monotonic time in seconds.
        listen_only: Only urgent frames are sent.
        sent: A bounded queue that receives every sent frame with its time.
    """

    def __init__(
        self,
        clock: Callable[[], float] = steady_s,
        *,
        listen_only: bool = False,
        sent: deque[tuple[Frame, float]] | None = None,
    ) -> None:
        self._clock = clock
        self._sent: deque[tuple[Frame, float]] = deque(maxlen=0) if sent is None else sent
        self._listen_only = listen_only
        self._changed = threading.Condition(threading.Lock())
        self._port: _Port | None = None
        self._batches: deque[_Batch] = deque()
        self._urgent: deque[Frame] = deque()
        self._dropped = self._frames_out = 0
        self._failing_since_s: float | None = None
        self._last_failure_s = 0.0

    @property
    def dropped(self) -> int:
        """The number of ordinary frames dropped by a stop, by age, or for a newer command."""
        return self._dropped

    @property
    def frames_out(self) -> int:
        """The number of frames that drivers have taken."""
        return self._frames_out

    @property
    def empty(self) -> bool:
        """True if nothing waits and no frame is in the driver."""
        port = self._port
        return not (self._batches or self._urgent or (port is not None and port.driver.locked()))

    @property
    def blocked(self) -> bool:
        """True if nothing has been sent for half a second although frames wait."""
        with self._changed:
            return self._is_blocked(self._clock())

    def attach(self, bus: can.BusABC, *, threaded: bool = False) -> None:
        """Send on this bus from now on, and drop frames left from before.

        Args:
            bus: The bus to send on.
            threaded: True if a sending thread serves the bus. A stop then goes through that thread
                unless the back-end is known to return in time: a driver may block for seconds.
        """
        self._use(_Port(bus, direct=not threaded or obeys_its_timeout(bus)))

    def detach(self) -> None:
        """Send nothing any more, and drop all frames that wait."""
        self._use(None)

    def _use(self, port: _Port | None) -> None:
        with self._changed:
            self._port = port
            self._drop_waiting()
            self._urgent.clear()
            self._failing_since_s = None
            self._changed.notify_all()

    def put(
        self,
        frames: Iterable[Frame],
        keep_s: float = KEEP_S,
        command: int | None = None,
        passed: Pass | None = None,
        press: Press | None = None,
    ) -> bool:
        """Queue frames in order, as one batch: all of them go out, or none.

        A batch is dropped as a whole before its first frame is out. Once its first frame is out the
        rest follows, unless it is dropped by a stop, by a newer command, by the loss of the device,
        or after half a second in which nothing could be sent.

        Args:
            frames: The frames to send.
            keep_s: A batch that could not begin within this time is dropped.
            command: The number of the command it belongs to; see :meth:`void`.
            passed: The gate's pass, without which no motion frame is taken (safety S35). What is
                urgent needs none: stop, halt, and what ends a motion.
            press: The press it belongs to: what is sent again does not begin too late either.

        Returns:
            True if they were queued; false without a bus, or in listen-only mode.

        Raises:
            UnpassedMotionError: There is a motion frame among them, and no pass.
        """
        now_s = self._clock()
        batch = _Batch(deque(frames), now_s + keep_s, command, press)
        if passed is None and any(map(is_motion_frame, batch.frames)):
            names = ", ".join(f"0x{frame.arbitration_id:03X}" for frame in batch.frames)
            raise UnpassedMotionError(f"no pass of the gate for {names}: ask it before sending")
        with self._changed:
            if self._port is None or self._listen_only:
                return False
            self._drop_old(now_s)
            if batch.frames:
                self._batches.append(batch)
                self._changed.notify_all()
            return True

    def holds(self, command: int) -> bool:
        """Return whether a frame of a command is not out yet."""
        with self._changed:
            return any(batch.command == command for batch in self._batches)

    def void(self, newest: int) -> None:
        """Drop every waiting batch that belongs to a command older than this one."""
        with self._changed:
            outdated = [
                batch
                for batch in self._batches
                if batch.command is not None and batch.command < newest
            ]
            for batch in outdated:
                self._batches.remove(batch)
                self._dropped += len(batch.frames)

    def put_urgent(self, frames: Sequence[Frame]) -> bool:
        """Send frames before everything else, and drop every ordinary frame.

        The call returns within some 20 ms whatever the driver does.

        Returns:
            True if all of them were sent. The others stay first in the queue of the sending thread,
            as long as there is a bus.
        """
        with self._changed:
            port = self._port
            if port is not None:
                # The stop is queued before anything is dropped, so that nothing can lose it (S3);
                # a frame that is queued already is not added again.
                self._urgent.extend(frame for frame in frames if frame not in self._urgent)
            self._drop_waiting()
            if port is None:
                return False
        if port.direct:
            self._send_urgent(port)
        with self._changed:
            if not self._are_out(frames):
                self._changed.notify_all()
                self._await(frames, port)
            return self._port is port and self._are_out(frames)

    def let_urgent_out(self, within_s: float) -> None:
        """Wait for the sending thread to have sent what is urgent, for a time at most."""
        with self._changed:
            self._changed.wait_for(lambda: self._port is None or not self._urgent, within_s)

    def wait_for_work(self, bus: can.BusABC) -> bool:
        """Wait until a frame is to be sent on this bus; return false once it is detached."""
        with self._changed:
            self._changed.wait_for(lambda: not self._is_on(bus) or self._batches or self._urgent)
            return self._is_on(bus)

    def send_waiting(self) -> bool:
        """Send the frames that wait, stop frames first; called by the sending thread.

        Returns:
            True if nothing is left; a full transmit queue leaves the rest for the next call.

        Raises:
            can.CanError, OSError: The bus is gone.
        """
        port = self._port
        if port is None:
            return True
        while True:
            with port.driver:
                frame, batch = self._next(port)
                if frame is None:
                    return True
                if self._send(port, frame, batch, _SEND_TIMEOUT_S):
                    continue
                if self.blocked:
                    # What the driver still holds would go out late, when the cable is back (S17).
                    flush_transmit_queue(port.bus)
                return False

    # With the queue's lock held -------------------------------------------------------------------

    def _is_on(self, bus: can.BusABC) -> bool:
        return self._port is not None and self._port.bus is bus

    def _are_out(self, frames: Sequence[Frame]) -> bool:
        return not any(frame in self._urgent for frame in frames)

    def _await(self, frames: Sequence[Frame], port: _Port) -> None:
        """Wait briefly for the sending thread, unless the driver is known to be blocked."""
        now_s = self._clock()
        since_s = [port.in_driver_since_s, self._failing_since_s]
        if all(each is None or now_s - each <= _PATIENCE_S for each in since_s):
            self._changed.wait_for(
                lambda: self._port is not port or self._are_out(frames), _PATIENCE_S
            )

    def _is_blocked(self, now_s: float) -> bool:
        in_driver_s = self._port.in_driver_since_s if self._port is not None else None
        if in_driver_s is not None and now_s - in_driver_s >= BLOCKED_S:
            return True
        since_s = self._failing_since_s
        # A single frame with a short time to live that met a full queue does not show a blocked
        # bus.
        return since_s is not None and self._last_failure_s - since_s >= 0.8 * BLOCKED_S

    def _drop_waiting(self) -> None:
        self._dropped += sum(len(batch.frames) for batch in self._batches)
        self._batches.clear()

    def _drop_old(self, now_s: float) -> None:
        blocked = self._is_blocked(now_s)
        while self._batches and (
            # A batch that has begun goes on while it can, so that the arm gets all of a command
            # (S7).
            blocked if self._batches[0].begun else self._batches[0].is_late(now_s)
        ):
            self._dropped += len(self._batches.popleft().frames)

    # One frame ------------------------------------------------------------------------------------

    def _send_urgent(self, port: _Port) -> None:
        """Write the stop from this very thread; the driver's lock is waited for a moment only."""
        if port.driver.acquire(timeout=_PATIENCE_S):
            try:
                while True:
                    frame, batch = self._next(port)
                    if frame is None or batch is not None:
                        break
                    if not self._send(port, frame, batch, 0.0):
                        break
            except Exception:  # noqa: BLE001, S110 - a driver's error must not reach the caller
                pass  # The sending thread gets the same error, and reports the loss of the bus.
            finally:
                port.driver.release()

    def _next(self, port: _Port) -> tuple[Frame | None, _Batch | None]:
        """Return the next frame to send, and its batch; it stays queued until it was sent."""
        with self._changed:
            if self._port is not port:
                return None, None
            if self._urgent:
                return self._urgent[0], None
            self._drop_old(self._clock())
            if not self._batches:
                return None, None
            return self._batches[0].frames[0], self._batches[0]

    def _send(self, port: _Port, frame: Frame, batch: _Batch | None, timeout_s: float) -> bool:
        """Put one frame on the bus; return false if the transmit queue is full at the moment."""
        message = can.Message(
            arbitration_id=frame.arbitration_id, data=frame.data, is_extended_id=False, check=False
        )
        port.in_driver_since_s = began_s = self._clock()
        try:
            port.bus.send(message, timeout=timeout_s)
        except Exception as error:
            if not queue_is_full(error):
                raise
            self._failed(port, began_s)
            return False
        finally:
            port.in_driver_since_s = None
        self._sent.append((frame, began_s))
        self._frames_out += 1
        self._is_out(port, frame, batch, began_s)
        return True

    def _failed(self, port: _Port, began_s: float) -> None:
        with self._changed:
            if self._port is port:
                self._last_failure_s = self._clock()
                if self._failing_since_s is None:
                    self._failing_since_s = began_s

    def _is_out(self, port: _Port, frame: Frame, batch: _Batch | None, began_s: float) -> None:
        """Remove a sent frame from its queue, unless the queue has been emptied meanwhile."""
        with self._changed:
            if self._port is not port:
                return
            since_s = began_s if self._failing_since_s is None else self._failing_since_s
            self._failing_since_s = None
            if batch is None:
                if self._urgent and self._urgent[0] is frame:
                    self._urgent.popleft()
            elif self._batches and self._batches[0] is batch:
                batch.begun = True
                if batch.press is not None:
                    batch.press.begun = True
                batch.frames.popleft()
                late = self._clock() - since_s >= BLOCKED_S
                if late:
                    self._dropped += len(batch.frames)
                if late or not batch.frames:
                    self._batches.popleft()
            self._changed.notify_all()


_RETRY_S: Final = 0.005
"""The pause before the next attempt after a full transmit queue."""

_END_S: Final = 0.2
"""The time to wait for the thread's end: the driver may hold it for longer."""


class SendingThread(threading.Thread):
    """Sends the frames of an outbox as long as one bus is attached to it.

    It is a daemon: a driver that never returns does not keep the program from ending.

    Attributes:
        failure: The driver's exception when the bus was lost; the thread has ended then.
    """

    def __init__(self, outbox: Outbox, bus: can.BusABC) -> None:
        super().__init__(name="bus sender", daemon=True)
        self._outbox = outbox
        self._bus = bus
        self._pause = threading.Event()
        self.failure: Exception | None = None

    def run(self) -> None:
        """Send until the bus is detached or gone."""
        try:
            while self._outbox.wait_for_work(self._bus):
                if not self._outbox.send_waiting():
                    self._pause.wait(_RETRY_S)
        except Exception as error:  # noqa: BLE001 - a driver error: the bus thread reports it
            self.failure = error

    def end(self) -> None:
        """Wait up to 0.2 s for the thread to end; the bus must be detached before."""
        self.join(_END_S)
