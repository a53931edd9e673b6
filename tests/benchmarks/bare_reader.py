"""Reads the same bus and does nothing else: ``python -m tests.benchmarks.bare_reader``.

Prints, at a line of its input, the frames it has read, those it has lost, and the processor time
it has taken.
"""

from __future__ import annotations

import select
import sys
import time

import can

from armui.bus.receive_queue import ReceiveQueue
from tests.benchmarks.other_arm import BUS


def main() -> None:
    """Read until a line comes in."""
    read = 0
    with can.Bus(**BUS) as bus:
        queue = ReceiveQueue()
        queue.attach(bus)
        print("reading", flush=True)
        began_s = time.process_time()
        while not select.select([sys.stdin], [], [], 0)[0]:
            message = bus.recv(0.05)
            while message is not None:
                read += 1
                message = bus.recv(0)
        queue.poll(time.monotonic() + 1.0)
        print(read, queue.dropped, time.process_time() - began_s, flush=True)


if __name__ == "__main__":
    main()
