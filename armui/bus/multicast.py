"""python-can's bus over UDP multicast, with the frames of this program marked as its own."""

from __future__ import annotations

import re
import threading
import time
from collections import deque
from typing import Any, Final

import can
from can.interfaces.udp_multicast import UdpMulticastBus

from armui.system.clock import steady_s

_WITH_PORT: Final = re.compile(r"(\[(?P<six>[^]]+)\]|(?P<four>[^:]*)):(?P<port>\d{1,5})")
_ECHO_S: Final = 2.0
"""A frame of ours comes back within this time, or it was lost."""


class MulticastBus(UdpMulticastBus):
    """A bus on which each frame sent comes back, as on adapters that say whose it is.

    Its channel is a group, with a port or without: ``239.1.2.3:45000``, ``[ff15::1]:45000``, or
    ``:45000`` for python-can's own group. Two groups on one port hear each other on Linux.

    python-can hands it back as another host's, and every program of this computer sends from the
    same port: only the frame tells. Of two equal ones, the first is taken for ours.
    """

    def __init__(self, channel: str, **more: Any) -> None:
        if named := _WITH_PORT.fullmatch(channel):
            channel = named["six"] or named["four"] or UdpMulticastBus.DEFAULT_GROUP_IPv6
            more["port"] = int(named["port"])
        super().__init__(channel, **more)
        self._sent: deque[tuple[float, int, bytes]] = deque()
        self._lock = threading.Lock()

    def send(self, msg: can.Message, timeout: float | None = None) -> None:
        """Send a frame, and expect it back.

        Raises:
            can.CanError: The system does not take it.
        """
        sent = (steady_s(), msg.arbitration_id, bytes(msg.data))
        with self._lock:
            self._sent.append(sent)
        try:
            super().send(msg, timeout)
        except can.CanError:
            with self._lock:
                self._sent.remove(sent)
            raise

    def _recv_internal(self, timeout: float | None) -> tuple[can.Message | None, bool]:
        message, filtered = super()._recv_internal(timeout)
        if message is not None:
            message.is_rx = not self._is_back(message)
        return message, filtered

    def _is_back(self, message: can.Message) -> bool:
        said = (message.arbitration_id, bytes(message.data))
        # its stamp is the time of day, which may be set meanwhile: only its age counts
        received_s = steady_s() - max(0.0, time.time() - message.timestamp)
        with self._lock:
            while self._sent and self._sent[0][0] < received_s - _ECHO_S:
                self._sent.popleft()
            for sent in self._sent:
                if sent[1:] == said:
                    self._sent.remove(sent)
                    return True
        return False
