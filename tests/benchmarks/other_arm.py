"""A bus with an arm on it, from another process: ``python -m tests.benchmarks.other_arm RATE``.

Sends the frames of a moving simulated arm over udp_multicast, so many a second, evenly spread, and
answers nothing. What it sends was worked out before it begins: it takes little of the processor. On
a line of its input it ends and prints how many frames it has sent.
"""

from __future__ import annotations

import itertools
import select
import sys
import time
from typing import Any

import can

from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from tests.sim.talk import ENABLE, frame, mode, target

BUS: dict[str, Any] = {"interface": "udp_multicast", "channel": "239.74.211.9", "port": 43519}
PERIOD_S = 0.005
ENDS_DEG = ((60, 90, -60, 40, 30, 60), (-60, 40, -90, -40, -30, -60))


def moving_frames(seconds: float = 6.0) -> list[can.Message]:
    """What an arm sends that goes to and fro with all its joints."""
    firmware = Firmware(Generation.TWO)
    firmware.on_frame(frame(ENABLE))
    ends, sent = itertools.cycle(ENDS_DEG), []
    for step in range(round(seconds / PERIOD_S)):
        if step % 300 == 0:
            for line in (mode(60), *target(*next(ends))):
                firmware.on_frame(frame(line))
        sent += [
            can.Message(arbitration_id=each.arbitration_id, data=each.data, is_extended_id=False)
            for each in firmware.step(PERIOD_S)
        ]
    return sent


def main() -> None:
    """Send until a line comes in."""
    per_s = float(sys.argv[1])
    messages = itertools.cycle(moving_frames())
    sent = 0
    with can.Bus(**BUS) as bus:
        print("sending", flush=True)
        began_s = time.monotonic()
        while not select.select([sys.stdin], [], [], PERIOD_S)[0]:
            due = int((time.monotonic() - began_s) * per_s)
            for message in itertools.islice(messages, due - sent):
                bus.send(message)
            sent = max(sent, due)
    print(sent, flush=True)


if __name__ == "__main__":
    main()
