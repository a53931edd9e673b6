"""A viewer that speaks Foxglove's WebSocket protocol, as its specification has it, and no more.

python -m tests.live.viewer [PORT [SECONDS]] watches everything and prints rate and age.
"""

from __future__ import annotations

import base64
import json
import os
import socket
import struct
import sys
import time
from collections import defaultdict
from typing import Any, NamedTuple

TEXT, BINARY = 1, 2


class Seen(NamedTuple):
    topic: str
    time_ns: int
    data: bytes


class Viewer:
    """One viewer; its topics are known once it is connected.

    Args:
        port: Of the stream.
        buffer: Bytes that wait for it in its own system, if it reads nothing.
    """

    def __init__(self, port: int, buffer: int | None = None) -> None:
        self._socket = socket.socket()
        if buffer is not None:
            self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, buffer)
        self._socket.settimeout(20)
        self._socket.connect(("127.0.0.1", port))
        key = base64.b64encode(os.urandom(16)).decode()
        self._socket.sendall(
            f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\n"
            f"Connection: Upgrade\r\nSec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n"
            "Sec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n".encode()
        )
        self._file = self._socket.makefile("rb")
        while self._file.readline().strip():
            pass
        self.said: list[dict[str, Any]] = []
        self.channels: dict[int, dict[str, Any]] = {}

    def close(self) -> None:
        self._file.close()
        self._socket.close()

    def send(self, message: dict[str, Any]) -> None:
        data, mask = json.dumps(message).encode(), os.urandom(4)
        size = bytes([0x80 | len(data)]) if len(data) < 126 else struct.pack(">BH", 0xFE, len(data))
        masked = bytes(each ^ mask[place % 4] for place, each in enumerate(data))
        self._socket.sendall(b"\x81" + size + mask + masked)

    def watch(self, count: int = 8) -> None:
        """Subscribe to everything, once so many topics are there."""
        while len(self.channels) < count:
            self.read()
        wanted = [{"id": number, "channelId": number} for number in self.channels]
        self.send({"op": "subscribe", "subscriptions": wanted})

    def read(self) -> Seen | None:
        """Wait for the next message; return it if it is one of a topic."""
        kind, size = self._file.read(2)
        if size >= 126:
            size = int.from_bytes(self._file.read(2 if size == 126 else 8))
        data = self._file.read(size)
        if kind & 0xF == TEXT:
            message = json.loads(data)
            self.said.append(message)
            for channel in message.get("channels", ()):
                self.channels[channel["id"]] = channel
        elif kind & 0xF == BINARY and data[0] == 1:
            number, time_ns = struct.unpack_from("<IQ", data, 1)
            return Seen(self.channels[number]["topic"], time_ns, data[13:])
        return None

    def next_of(self, topic: str) -> Seen:
        while (seen := self.read()) is None or seen.topic != topic:
            pass
        return seen


def main(port: int = 8766, seconds: float = 10.0) -> None:
    viewer = Viewer(port)
    viewer.watch()
    ages_ms: dict[str, list[float]] = defaultdict(list)
    until_s = time.monotonic() + seconds
    while time.monotonic() < until_s:
        if (seen := viewer.read()) is not None:
            ages_ms[seen.topic].append(1e3 * (time.time() - seen.time_ns / 1e9))
    for topic, each in sorted(ages_ms.items()):
        each.sort()
        p50, p99 = each[len(each) // 2], each[len(each) * 99 // 100]
        print(
            f"{topic:24} {len(each) / seconds:7.1f}/s   age p50 {p50:6.1f}  p99 {p99:6.1f}  "
            f"oldest {each[-1]:6.1f} ms"
        )


if __name__ == "__main__":
    main(*(kind(word) for kind, word in zip((int, float), sys.argv[1:], strict=False)))
