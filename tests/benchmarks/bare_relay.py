"""The least that can be between a client's line and a frame: a Unix socket, and python-can.

``python -m tests.benchmarks.bare_relay SOCKET`` takes one client; each line it sends a frame and
answers with the time (Unix) at which that was on the bus. A line without a frame is answered alone.
"""

import socket
import sys
import time

import can

from tests.benchmarks.other_arm import BUS

FRAME = can.Message(arbitration_id=0x7F0, data=bytes(8), is_extended_id=False)


def main() -> None:
    """Relay until the client closes."""
    with socket.socket(socket.AF_UNIX) as listening, can.Bus(**BUS | {"port": 43520}) as bus:
        listening.bind(sys.argv[1])
        listening.listen(1)
        print("ready", flush=True)
        connection, _ = listening.accept()
        with connection, connection.makefile("rwb") as lines:
            for line in lines:
                if line.strip() == b"frame":
                    bus.send(FRAME)
                lines.write(f"{time.time()}\n".encode())
                lines.flush()


if __name__ == "__main__":
    main()
