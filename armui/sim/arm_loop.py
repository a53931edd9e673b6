"""Runs a simulated arm in time: receives its frames, advances it, sends what is due."""

from __future__ import annotations

import logging
import threading
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Iterable
from typing import Final, Self

from armui.protocol.frame import Frame
from armui.sim.faults.faulty_link import FaultyLink
from armui.sim.faults.schedule import Fault, Faults
from armui.sim.firmware import Firmware
from armui.system.clock import steady_s

_LOG: Final = logging.getLogger(__name__)

PERIOD_S: Final = 0.005
"""The period of the loop: it wakes 200 times a second, not for each of 3,000 frames."""

_LONGEST_CATCH_UP_S: Final = 0.25
"""After a longer pause (a computer that slept) the arm skips the missed time."""


class ArmLoop(ABC):
    """One simulated arm on one line; the classes below know what carries its frames.

    Attributes:
        firmware: The arm. While the loop runs, only read it; its `hand_guiding` may be used.
        faults: The faults; plan them before the loop runs.
        link: The faults of the line; must not be changed while the loop runs.
        heard: The frames the arm received, newest last.
        sent: The number of frames sent.
        received: The number of frames received.
        lost: The number of frames the line did not take (full, down, unplugged, a fault of it).
        receive_errors: The number of failures to receive.
        failures: The number of program errors in the loop, which goes on after them.
        worst_lateness_s: The longest delay of the loop behind its clock.
    """

    def __init__(
        self, firmware: Firmware, *, remember: int, faults: Iterable[Fault], seed: int
    ) -> None:
        """Puts an arm on a line.

        Args:
            firmware: The arm.
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
        received = self._receive()
        self.received += len(received)
        reached = link.to_arm(received, arm.time_s)
        self.heard.extend(reached)
        for frame in reached:
            frames += arm.on_frame(frame)
        feedback = arm.step(dt_s)
        if arm.leads is not self._leads:
            self._leads = arm.leads
            self._feedback_ids.clear()  # after a change of role it may receive what it sent before
        self._feedback_ids.update(frame.arbitration_id for frame in feedback)
        to_send, lost = link.to_bus(frames + feedback, arm.time_s, dt_s)
        self.lost += lost
        sent = self._send(to_send)
        self.sent += sent
        self.lost += len(to_send) - sent

    def start(self) -> None:
        """Starts a thread that runs the arm in real time.

        Raises:
            RuntimeError: The thread runs already.
        """
        if self._thread is not None:
            raise RuntimeError("the node runs already; stop it first")
        self._ending.clear()
        self._thread = threading.Thread(target=self.run, name="simulated-arm", daemon=True)
        self._thread.start()

    def stop(self) -> None:
        """Ends the thread and waits for it; does nothing if none runs."""
        if self._thread is not None:
            self._ending.set()
            self._thread.join()
            self._thread = None

    def run(self) -> None:
        """Polls on a grid of the clock until the end; what was missed is caught up in one poll."""
        due_s = steady_s() + PERIOD_S
        while not self._ending.wait(max(due_s - steady_s(), 0.0)):
            late_s = steady_s() - due_s
            self.worst_lateness_s = max(self.worst_lateness_s, late_s)
            periods = 1 + int(late_s / PERIOD_S)
            try:
                self.poll(min(periods * PERIOD_S, _LONGEST_CATCH_UP_S))
            except Exception:  # noqa: BLE001 - any program error: the loop must go on
                # The failure is logged once, and the loop goes on: an arm that falls silent would
                # be worse.
                if not self.failures:
                    _LOG.exception("the simulated arm has failed for a moment; it lives on")
                self.failures += 1
            due_s += periods * PERIOD_S

    @abstractmethod
    def _receive(self) -> list[Frame]:
        """Return the frames that have arrived, counting failures."""

    @abstractmethod
    def _send(self, frames: list[Frame]) -> int:
        """Sends a burst, and returns how many frames of it the line took."""
