"""Runs the simulated arm on any python-can bus, by hand or in real time."""

from __future__ import annotations

import logging
import threading
from collections import deque
from collections.abc import Iterable
from typing import Final, Self

import can

from armui.protocol.frame import Frame
from armui.sim.faults.faulty_link import FaultyLink
from armui.sim.faults.schedule import Fault, Faults
from armui.sim.firmware import Firmware
from armui.system.clock import steady_s

_LOG: Final = logging.getLogger(__name__)

PERIOD_S: Final = 0.005
"""The period of the thread: it wakes 200 times a second, not for each of 3,000 frames."""

_LONGEST_CATCH_UP_S: Final = 0.25
"""After a longer pause (a computer that slept) the arm skips the missed time."""

_MOST_A_POLL: Final = 1_000
"""The most frames received in a period. A bus carries some 40; a flood must not keep the arm from
sending.
"""

_BUS_ERRORS: Final = (can.CanError, OSError)


class Node:
    """One simulated arm on one bus.

    The bus belongs to the caller, who closes it after `stop`.

    Attributes:
        firmware: The arm. While the thread runs, only read it; its `hand_guiding` may be used.
        faults: The faults; plan them before the thread runs.
        link: The faults of the line; must not be changed while the thread runs.
        heard: The frames the arm received, newest last.
        sent: The number of frames sent.
        lost: The number of frames the bus did not take (full, down, unplugged, a fault of the
            line).
        receive_errors: The number of failures to receive.
        failures: The number of program errors in the thread, which goes on after them.
        worst_lateness_s: The longest delay of the thread behind its clock.
    """

    def __init__(
        self,
        firmware: Firmware,
        bus: can.BusABC,
        *,
        remember: int = 10_000,
        faults: Iterable[Fault] = (),
        seed: int = 0,
    ) -> None:
        """Puts an arm on a bus.

        Args:
            firmware: The arm.
            bus: An open bus that does not return the frames sent on it.
            remember: The number of received frames kept in `heard`.
            faults: The planned faults.
            seed: The seed of random faults.
        """
        self.link = FaultyLink(seed)
        self.faults = Faults(firmware, self.link, faults)
        self.firmware = firmware
        self.heard: deque[Frame] = deque(maxlen=remember)
        self.sent = 0
        self.received = 0
        self.lost = 0
        self.receive_errors = 0
        self.failures = 0
        self.worst_lateness_s = 0.0
        self._bus = bus
        self._feedback_ids: set[int] = set()
        self._leads = firmware.leads
        self._ending = threading.Event()
        self._thread: threading.Thread | None = None

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self.stop()

    def poll(self, dt_s: float) -> None:
        """Passes received frames to the arm, advances its time, and sends what is due.

        Args:
            dt_s: The time to advance.
        """
        arm, link = self.firmware, self.link
        self.faults.at(arm.time_s)
        frames: list[Frame] = []
        reached = link.to_arm(self._receive(), arm.time_s)
        self.heard.extend(reached)
        for frame in reached:
            frames += arm.on_frame(frame)
        feedback = arm.step(dt_s)
        if arm.leads is not self._leads:
            self._leads = arm.leads
            self._feedback_ids.clear()  # what it said as a leader it may be told now
        self._feedback_ids.update(frame.arbitration_id for frame in feedback)
        to_send, lost = link.to_bus(frames + feedback, arm.time_s, dt_s)
        self.lost += lost
        self._send(to_send)

    def start(self) -> None:
        """Starts the thread that runs the arm in real time.

        Raises:
            RuntimeError: The thread runs already.
        """
        if self._thread is not None:
            raise RuntimeError("the node runs already; stop it first")
        self._ending.clear()
        self._thread = threading.Thread(target=self._run, name="simulated-arm", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Ends the thread and waits for it; does nothing if none runs."""
        if self._thread is not None:
            self._ending.set()
            self._thread.join()
            self._thread = None

    def _run(self) -> None:
        """Polls on a grid of the monotonic clock; what was missed is caught up in one poll."""
        due_s = steady_s() + PERIOD_S
        while not self._ending.wait(max(due_s - steady_s(), 0.0)):
            late_s = steady_s() - due_s
            self.worst_lateness_s = max(self.worst_lateness_s, late_s)
            periods = 1 + int(late_s / PERIOD_S)
            try:
                self.poll(min(periods * PERIOD_S, _LONGEST_CATCH_UP_S))
            except Exception:  # noqa: BLE001 - whatever it is: the thread lives on
                # one that repeats is told once; an arm that says nothing any more would be worse
                if not self.failures:
                    _LOG.exception("the simulated arm has failed for a moment; it lives on")
                self.failures += 1
            due_s += periods * PERIOD_S

    def _receive(self) -> list[Frame]:
        frames: list[Frame] = []
        try:
            for _ in range(_MOST_A_POLL):
                message = self._bus.recv(timeout=0.0)
                if message is None:
                    break
                if self._is_worth_hearing(message):
                    frames.append(Frame(message.arbitration_id, bytes(message.data)))
        except _BUS_ERRORS:
            self.receive_errors += 1
        self.received += len(frames)
        return frames

    def _is_worth_hearing(self, message: can.Message) -> bool:
        """Tell whether it is a classic data frame, and not the arm's own (udp_multicast echoes)."""
        return not (
            message.arbitration_id in self._feedback_ids
            or message.is_error_frame
            or message.is_remote_frame
            or message.is_extended_id
            or message.is_fd
        )

    def _send(self, frames: list[Frame]) -> None:
        """Sends a burst; when the bus refuses a frame, the rest of the burst is lost with it."""
        for index, frame in enumerate(frames):
            message = can.Message(
                arbitration_id=frame.arbitration_id, data=frame.data, is_extended_id=False
            )
            try:
                self._bus.send(message)
            except _BUS_ERRORS:
                self.lost += len(frames) - index
                return
            self.sent += 1
