"""The system's queue of received frames: sets its length, and counts the frames it lost.

python-can stops at ancillary data that it did not ask for, so SO_RXQ_OVFL can't be switched on in
its sockets. SO_MEMINFO reads the same counter of the kernel (``sk_drops``) without it.
"""

from __future__ import annotations

import contextlib
import os
import socket
import struct
import sys
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    import can

_LOOK_S: Final = 0.5
_WANTED_BYTES: Final = 8 << 20
"""Room for some 10,000 frames as Linux counts them, over a second of the fastest bus."""

_SO_RCVBUFFORCE: Final = 33
_SO_MEMINFO: Final = 55
"""Socket options of Linux that the module socket does not name."""
_MEMINFO: Final = struct.Struct("=9I")
_DROPS: Final = 8
"""The index of ``sk_drops`` in SO_MEMINFO (Linux, asm-generic/socket.h, linux/sock_diag.h)."""

_CAN_ERR_CRTL: Final = 0x004
"""The error class «controller problems» (linux/can/error.h)."""
_RX_OVERFLOW: Final = 0x01
"""The overflow's bit in data byte 1 of a controller error frame (linux/can/error.h)."""


class ReceiveQueue:
    """Makes the receive queue as long as the system allows, and counts lost frames.

    Only Linux counts them, and only for sockets: socketcan and udp_multicast.
    """

    def __init__(self) -> None:
        self._socket: socket.socket | None = None
        self._next_look_s = 0.0
        self._at_opening = 0
        self._by_kernel = 0
        self._of_earlier = 0
        self._by_adapter = 0

    @property
    def dropped(self) -> int:
        """The number of frames lost in the kernel's queue, plus the adapter's overflows."""
        return self._of_earlier + self._by_kernel + self._by_adapter

    def attach(self, bus: can.BusABC) -> None:
        """Watch the queue of an opened device."""
        self.detach()
        self._socket = _socket_of(bus)
        if self._socket is not None:
            _lengthen(self._socket)
            self._at_opening = _drops(self._socket)

    def detach(self) -> None:
        """Stop watching the device; the count is kept."""
        self._of_earlier += self._by_kernel
        self._by_kernel = 0
        if self._socket is not None:
            self._socket.close()
            self._socket = None

    def poll(self, now_s: float) -> None:
        """Read the kernel's counter, at most twice a second."""
        if self._socket is not None and now_s >= self._next_look_s:
            self._next_look_s = now_s + _LOOK_S
            self._by_kernel = _drops(self._socket) - self._at_opening

    def note_error(self, message: can.Message) -> None:
        """Count the overflow that an error frame of the adapter reports."""
        is_of_controller = bool(message.arbitration_id & _CAN_ERR_CRTL)
        if is_of_controller and len(message.data) > 1 and message.data[1] & _RX_OVERFLOW:
            self._by_adapter += 1


def _socket_of(bus: can.BusABC) -> socket.socket | None:
    """Return a second handle on the bus's socket; ``None`` if the bus has no socket."""
    system: str = sys.platform  # `str` for mypy: checked for every system
    if system != "linux":
        return None
    try:
        number = bus.fileno()
        return None if number < 0 else socket.socket(fileno=os.dup(number))
    except Exception:  # noqa: BLE001 - no socket, or a driver's error
        return None


def _lengthen(receiving: socket.socket) -> None:
    """Lengthen the queue as far as the system allows: without rights to net.core.rmem_max."""
    if receiving.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) >= _WANTED_BYTES:
        return
    for option in (_SO_RCVBUFFORCE, socket.SO_RCVBUF):
        with contextlib.suppress(OSError):
            receiving.setsockopt(socket.SOL_SOCKET, option, _WANTED_BYTES)
            return


def _drops(receiving: socket.socket) -> int:
    try:
        told = receiving.getsockopt(socket.SOL_SOCKET, _SO_MEMINFO, _MEMINFO.size)
    except OSError:
        return 0
    return int(_MEMINFO.unpack(told)[_DROPS]) if len(told) == _MEMINFO.size else 0
