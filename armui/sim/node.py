"""Runs the simulated arm on any python-can bus, by hand or in real time."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import can

from armui.protocol.frame import Frame
from armui.sim.arm_loop import ArmLoop
from armui.sim.faults.schedule import Fault
from armui.sim.firmware import Firmware

_MOST_A_POLL: Final = 1_000
"""The most frames received in a period. A bus carries some 40; a flood must not keep the arm from
sending.
"""

_BUS_ERRORS: Final = (can.CanError, OSError)


class Node(ArmLoop):
    """One simulated arm on one bus.

    The bus belongs to the caller, who closes it after `stop`.
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
        super().__init__(firmware, remember=remember, faults=faults, seed=seed)
        self._bus = bus

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
        return frames

    def _is_worth_hearing(self, message: can.Message) -> bool:
        """Return whether it is a classic data frame, not the arm's own (udp_multicast echoes)."""
        return not (
            message.arbitration_id in self._feedback_ids
            or message.is_error_frame
            or message.is_remote_frame
            or message.is_extended_id
            or message.is_fd
        )

    def _send(self, frames: list[Frame]) -> int:
        """Sends a burst; when the bus refuses a frame, the rest of the burst is lost with it."""
        for sent, frame in enumerate(frames):
            message = can.Message(
                arbitration_id=frame.arbitration_id, data=frame.data, is_extended_id=False
            )
            try:
                self._bus.send(message)
            except _BUS_ERRORS:
                return sent
        return len(frames)
