"""python-can's bus on a line to another process of this program: the simulated arm's."""

from __future__ import annotations

import time
from collections import deque

import can

from armui.protocol.frame import Frame
from armui.protocol.frame_records import ERROR_MARK, pack, unpack
from armui.system.record_socket import RecordSocket


class LineBus(can.BusABC):
    """A bus of two, us and the arm, on which several frames travel in one message.

    A line that takes no more counts as a full transmit queue; its end is a lost device.

    Args:
        channel: The channel's name.
        line: Our end of the line, of records of frames; closed with the bus.
    """

    def __init__(self, channel: str, line: RecordSocket) -> None:
        self._line = line
        self._arrived: deque[Frame] = deque()
        self.channel_info = f"line to {channel}"
        super().__init__(channel)

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Send a classic data frame.

        Raises:
            TimeoutError: The line is full.
            OSError: The other process is gone.
        """
        self._line.send(pack([Frame(msg.arbitration_id, bytes(msg.data))]), timeout)

    def fileno(self) -> int:
        """Return the number of the line's socket."""
        return self._line.fileno()

    def shutdown(self) -> None:
        """Close the bus and the line under it."""
        super().shutdown()
        self._line.close()

    def _recv_internal(self, timeout: float | None) -> tuple[can.Message | None, bool]:
        if not self._arrived:
            self._arrived.extend(unpack(self._line.receive(timeout)))
        if not self._arrived:
            return None, False
        arbitration_id, data = self._arrived.popleft()
        message = can.Message(
            timestamp=time.time(),
            arbitration_id=arbitration_id & ~ERROR_MARK,
            data=data,
            is_extended_id=False,
            is_error_frame=bool(arbitration_id & ERROR_MARK),
            check=False,
        )
        return message, False
