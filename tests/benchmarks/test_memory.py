"""What the window's process takes after much traffic, beside what it took after little.

Frames come as fast as they are taken in; a minute's worth is 60 × 8,100.

    python -m pytest tests/benchmarks/test_memory.py -s       (1/2 and 2 minutes' worth)
    TRAFFIC_MINUTES=30 python -m pytest tests/benchmarks/test_memory.py -s       (5 and 30)
"""

import itertools
import os
import sys
import threading
from functools import partial

import can
import pytest
from can.interfaces.virtual import VirtualBus

from armui.arm.device import Device
from tests.benchmarks import rig
from tests.benchmarks.other_arm import moving_frames
from tests.waiting import wait_until

CHANNEL = "benchmark-memory"
FRAMES_A_MINUTE = 60 * 8100
MINUTES = float(os.environ.get("TRAFFIC_MINUTES", "2"))
EARLY_MINUTES = min(5.0, MINUTES / 4.0)
MOST_WAITING = 500


class Feeder(threading.Thread):
    """Sends frames as fast as they are read."""

    def __init__(self, bus, queue):
        super().__init__(name="feeder")
        self._bus, self._queue = bus, queue
        self.sent = 0
        self.ending = threading.Event()

    def run(self):
        for message in itertools.cycle(moving_frames()):
            while self._queue.qsize() > MOST_WAITING and not self.ending.wait(0.002):
                pass
            if self.ending.is_set():
                return
            self._bus.send(message)
            self.sent += 1


def _has_sent(feeder: Feeder, frames: float) -> bool:
    return feeder.sent >= frames


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.timeout(3600)
def test_memory(qapp, tmp_path, capsys, benchmark):
    pid = os.getpid()
    device = Device("virtual", CHANNEL, None, simulated=True, generation=2)
    with (
        can.Bus(interface="virtual", channel=CHANNEL) as arm_side,
        VirtualBus(CHANNEL) as host_side,
    ):
        feeder = Feeder(arm_side, host_side.queue)
        feeder.start()
        with rig.window(qapp, tmp_path, lambda _device: host_side, device) as program:
            mb = []
            for minutes in (EARLY_MINUTES, MINUTES):
                frames = minutes * FRAMES_A_MINUTE
                wait_until(partial(_has_sent, feeder, frames), 3_000_000)
                mb.append(rig.memory_mb(pid))
            picture_mb = rig.memory_mb(program.view._client.pid)
            feeder.ending.set()
            feeder.join()
    benchmark.extra_info["grown_mb"] = mb[1] - mb[0]
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\nafter {EARLY_MINUTES:g} / {MINUTES:g} minutes' worth of 8,100 frames/s:")
        print(f"  window's process, and the tests: {mb[0]:.0f} / {mb[1]:.0f} MB")
        print(f"  picture's process: {picture_mb:.0f} MB")
    assert feeder.sent > 0
