"""The thread that hands frames to the driver, so that a driver that blocks holds nobody else."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    import can

    from armui.bus.outbox import Outbox

_RETRY_S: Final = 0.005
"""How long to leave a full transmit queue alone."""

_END_S: Final = 0.2
"""How long the end is waited for: the driver may hold the thread for longer."""


class SendingThread(threading.Thread):
    """Sends what waits in an outbox as long as one bus is attached to it.

    A daemon: a driver that never returns does not keep the program from ending.

    Attributes:
        failure: Why the bus is gone, once the driver has said so; the thread has ended then.
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
        except Exception as error:  # noqa: BLE001 - drivers of others raise anything; the bus thread tells
            self.failure = error

    def end(self) -> None:
        """Wait for the end, for a moment; the bus must be detached before."""
        self.join(_END_S)
