"""What the window's process takes after much traffic, beside what it took after little.

Frames come as fast as they are taken in, through the bus thread's own reading, decoding, keeping
and recording; the program's clock goes by the frames, 8,100 to the second, so that what is kept for
so many minutes is kept for as many. A minute's worth is 60 × 8,100. The samples of the curves and
the ring of the recorder fill by design, and are stated apart: the rest should not grow.

    python -m pytest tests/benchmarks/test_memory.py -s       (1/2 and 2 minutes' worth)
    TRAFFIC_MINUTES=30 python -m pytest tests/benchmarks/test_memory.py -s       (5 and 30)
"""

import itertools
import os
import sys
import time
from functools import partial
from pathlib import Path
from typing import NamedTuple

import pytest
from can.interfaces.virtual import VirtualBus

from armui.arm.device import Device
from tests.benchmarks import rig
from tests.benchmarks.other_arm import moving_frames
from tests.waiting import wait_until

CHANNEL = "benchmark-memory"
FRAMES_A_SECOND = 8100
MINUTES = float(os.environ.get("TRAFFIC_MINUTES", "2"))
EARLY_MINUTES = min(5.0, MINUTES / 4.0)
BURST = 40
"""So many frames are waiting when the reader looks: 5 ms' worth."""


class FullBus(VirtualBus):
    """A bus where the next frames are waiting already, and have come when they are read."""

    def __init__(self):
        super().__init__(CHANNEL)
        self._messages = itertools.cycle(moving_frames())
        self._left = 0
        self._began_s = time.monotonic()
        self.read = 0

    def recv(self, timeout=None):
        """The next frame; none waits after a burst, as on a bus that is read in time."""
        if not self._left:
            self._left = BURST
            if timeout == 0:
                return None
        self._left -= 1
        self.read += 1
        return next(self._messages)

    def clock(self):
        """Monotonic time by the frames that have come."""
        return self._began_s + self.read / FRAMES_A_SECOND

    def has_read(self, minutes):
        """Whether so many minutes' worth has come."""
        return self.read >= minutes * 60 * FRAMES_A_SECOND


class MemoryUse(NamedTuple):
    """Memory in MB.

    Attributes:
        whole: All that the process takes.
        arrays: Of it what the arrays have taken that fill by design (`armui.telemetry.series`).
        samples, ring: What is reserved for the curves' samples and for the recorder's ring.
    """

    whole: float
    arrays: float
    samples: float
    ring: float

    @property
    def rest(self):
        """What remains without those arrays."""
        return self.whole - self.arrays


def taken_by(controller):
    """What this process takes now."""
    return MemoryUse(
        rig.memory_mb("self"),
        shared_arrays_mb(),
        controller.telemetry.bytes_kept / 2**20,
        controller.sessions.ring().bytes_kept / 2**20,
    )


def shared_arrays_mb():
    """What this process has touched of its large arrays; the system lists them under this name."""
    taken, counts = 0.0, False
    for line in Path("/proc/self/smaps").read_text().splitlines():
        word, *rest = line.split()
        if not word.endswith(":"):
            counts = rest[-2:] == ["/dev/zero", "(deleted)"]
        elif counts and word == "Pss:":
            taken += int(rest[0]) / 1024.0
    return taken


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.timeout(3600)
def test_memory(qapp, tmp_path, capsys, benchmark):
    device = Device("virtual", CHANNEL, None, simulated=True, generation=2)
    with FullBus() as bus:
        began_s = time.perf_counter()
        with rig.window(qapp, tmp_path, lambda _device: bus, device, clock=bus.clock) as program:
            taken = []
            for minutes in (0.0, EARLY_MINUTES, MINUTES):
                wait_until(partial(bus.has_read, minutes), 3_000_000)
                taken.append(taken_by(program.controller))
            picture_mb = rig.memory_mb(program.view._client.pid)
        took_s = time.perf_counter() - began_s
    grown_mb = taken[2].rest - taken[1].rest
    benchmark.extra_info["grown_mb"] = grown_mb
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        worth = f"0 / {EARLY_MINUTES:g} / {MINUTES:g} minutes' worth"
        print(f"\nafter {worth} of {FRAMES_A_SECOND:,} frames/s, read in {took_s:.0f} s, MB:")
        for name, figures in (
            ("window's process, and the tests", [each.whole for each in taken]),
            ("of it samples and ring", [each.arrays for each in taken]),
            ("reserved for the curves' samples", [each.samples for each in taken]),
            ("reserved for the recorder's ring", [each.ring for each in taken]),
            ("all but samples and ring", [each.rest for each in taken]),
        ):
            print(f"  {name:34} " + " / ".join(f"{figure:.0f}" for figure in figures))
        print(
            f"  the rest has grown by {grown_mb:.1f}; the picture's process takes {picture_mb:.0f}"
        )
    assert bus.has_read(MINUTES)
