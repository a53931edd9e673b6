"""Passes records of one size between two processes, through a pair of sockets."""

from __future__ import annotations

import socket
from typing import Final

_MOST_RECORDS: Final = 1_000
"""The most records read at a time: a flood must not keep the reader from its other work."""
_LONGEST_WAIT_S: Final = 3600.0


class RecordSocket:
    """One end of a pair of sockets: records of one size arrive in the order they were sent.

    One thread may send while another receives. Neither waits for longer than it asks for, whatever
    the other process does.

    Args:
        end: The socket, which belongs to this object from now on.
        size: The size of a record in bytes.
    """

    def __init__(self, end: socket.socket, size: int) -> None:
        if end.family == socket.AF_INET:  # as on Windows: send small records at once
            end.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        # the time limit belongs to a socket object: each thread has an object of its own
        self._receiving, self._sending = end, end.dup()
        self._size = size
        self._part = b""
        self._unsent = b""

    def fileno(self) -> int:
        """Return the number by which the system can be asked whether something has arrived."""
        return self._receiving.fileno()

    def send(self, records: bytes, timeout_s: float | None = 0.0) -> None:
        """Send records, all or none.

        Args:
            records: Their bytes, one record behind the other.
            timeout_s: The longest wait for room; ``None`` for an hour.

        Raises:
            TimeoutError: The other process does not take them.
            OSError: The other end is closed, or this one.
        """
        self._sending.settimeout(_LONGEST_WAIT_S if timeout_s is None else timeout_s)
        self._push()  # complete a record of which a part was sent before
        self._unsent = records
        try:
            self._push()
        except TimeoutError:
            if len(self._unsent) == len(records):
                self._unsent = b""
                raise
            # records of which a part was sent are completed by the next call

    def receive(self, timeout_s: float | None = 0.0) -> bytes:
        """Return the records that have arrived, one behind the other; none: nothing has.

        Args:
            timeout_s: The longest wait for the first; ``None`` for an hour.

        Raises:
            ConnectionError: The other end is closed.
            OSError: This one is.
        """
        self._receiving.settimeout(_LONGEST_WAIT_S if timeout_s is None else timeout_s)
        try:
            arrived = self._receiving.recv(_MOST_RECORDS * self._size)
        except (TimeoutError, BlockingIOError):
            return b""
        if not arrived:
            raise ConnectionResetError("the other process has closed its end")
        arrived = self._part + arrived
        whole = len(arrived) - len(arrived) % self._size
        self._part = arrived[whole:]
        return arrived[:whole]

    def close(self) -> None:
        """Close this end; the other process gets an error when it reads."""
        self._receiving.close()
        self._sending.close()

    def _push(self) -> None:
        """Send the bytes that are not sent yet.

        Raises:
            TimeoutError: There is no room for all of it.
        """
        while self._unsent:
            try:
                sent = self._sending.send(self._unsent)
            except BlockingIOError:
                raise TimeoutError("the other process does not read") from None
            self._unsent = self._unsent[sent:]
