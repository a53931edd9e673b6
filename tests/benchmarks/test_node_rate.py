"""Whether the simulated arm keeps its 3,000 frames a second in real time, and at what price.

While the arm moves without pause, a thread that does nothing but wake in the same period runs
beside it: what it is late by is the computer's doing, not the arm's.

    python -m pytest tests/benchmarks/test_node_rate.py -s          (10 s each)
    NODE_RATE_SECONDS=60 python -m pytest --timeout=300 tests/benchmarks/test_node_rate.py -s
"""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
from itertools import cycle
from pathlib import Path
from typing import Any, Self

import can
import numpy as np
import pytest

from armui.protocol.generation import Generation
from armui.sim.arm_loop import PERIOD_S
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.posix import of_system
from tests.sim.talk import ENABLE, frame, mode, target

SECONDS = float(os.environ.get("NODE_RATE_SECONDS", "10"))
FRAMES_PER_S = 3040
TOLERANCE = 0.02
MOST_OF_A_CORE = 0.40
VIRTUAL: dict[str, Any] = {"interface": "virtual", "channel": "benchmark-node-rate"}
UDP = {"interface": "udp_multicast", "channel": "239.74.211.7", "port": 43517}
ENDS_DEG = ((60, 90, -60, 40, 30, 60), (-60, 40, -90, -40, -30, -60))
TURN_S = 1.0


class Metronome(threading.Thread):
    """Wakes in the arm's period and does nothing; notes how late it is."""

    def __init__(self) -> None:
        super().__init__(name="metronome")
        self.late_s: list[float] = []
        self._ending = threading.Event()

    def __enter__(self) -> Self:
        self.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ending.set()
        self.join()

    def run(self) -> None:
        due_s = time.monotonic() + PERIOD_S
        while not self._ending.wait(max(due_s - time.monotonic(), 0.0)):
            late_s = time.monotonic() - due_s
            self.late_s.append(late_s)
            due_s += (1 + int(late_s / PERIOD_S)) * PERIOD_S


class MeasuredNode(Node):
    """Notes when each poll began and what its thread has used of the processor."""

    def __init__(self, firmware: Firmware, bus: can.BusABC) -> None:
        super().__init__(firmware, bus)
        self.began_s: list[float] = []
        self.cpu_s: list[float] = []

    def poll(self, dt_s: float) -> None:
        self.began_s.append(time.monotonic())
        super().poll(dt_s)
        self.cpu_s.append(time.thread_time())


def say(options: dict[str, Any], *lines: str) -> None:
    """A host that comes, speaks and goes: nobody has to empty its queue."""
    with can.Bus(**options) as host:
        for line in lines:
            identifier, data = frame(line)
            host.send(can.Message(arbitration_id=identifier, data=data, is_extended_id=False))


def milliseconds(late_s: list[float]) -> str:
    late_ms = 1e3 * np.array(late_s)
    median, most = np.percentile(late_ms, (50, 99))
    return f"median {median:.2f}, 99 % {most:.2f}, worst {late_ms.max():.2f} ms"


def test_in_this_process_on_a_virtual_bus() -> None:
    pause = threading.Event()
    with can.Bus(**VIRTUAL) as bus:
        node = MeasuredNode(Firmware(Generation.TWO), bus)
        with node, Metronome() as metronome:
            say(VIRTUAL, ENABLE)
            began_s, sent = time.monotonic(), node.sent
            per_second, ends = [], cycle(ENDS_DEG)
            while time.monotonic() - began_s < SECONDS:
                say(VIRTUAL, mode(100), *target(*next(ends)))
                before, before_s = node.sent, time.monotonic()
                pause.wait(TURN_S)
                per_second.append((node.sent - before) / (time.monotonic() - before_s))
            took_s, sent = time.monotonic() - began_s, node.sent - sent
    rate = sent / took_s
    share = (node.cpu_s[-1] - node.cpu_s[0]) / (node.began_s[-1] - node.began_s[0])
    gaps_s = list(np.maximum(np.diff(node.began_s) - PERIOD_S, 0.0))
    print(
        f"\nvirtual bus, {took_s:.1f} s: {rate:.0f} frames/s "
        f"(a second: {min(per_second):.0f} to {max(per_second):.0f}), "
        f"{100 * share:.1f} % of a core, {node.lost} lost\n"
        f"  arm's thread behind its clock: worst {1e3 * node.worst_lateness_s:.2f} ms; "
        f"between polls beyond 5 ms: {milliseconds(gaps_s)}\n"
        f"  idle thread of the same period: {milliseconds(metronome.late_s)}"
    )
    assert node.lost == 0
    assert any(node.firmware.joints_deg)
    assert rate == pytest.approx(FRAMES_PER_S, rel=TOLERANCE)
    assert share < MOST_OF_A_CORE


def cpu_s(pid: int) -> float:
    """What a process has used of the processor (Linux)."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / of_system("sysconf")("SC_CLK_TCK")


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_as_a_command_on_udp_multicast() -> None:
    environment = os.environ | {
        "CAN_CONFIG": json.dumps({"port": UDP["port"]}),
        "PYTHONUNBUFFERED": "1",
    }
    command = [sys.executable, "-m", "armui", "sim", "--interface", "udp_multicast"]
    with subprocess.Popen(
        [*command, "--channel", str(UDP["channel"])],
        env=environment,
        text=True,
        stdout=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        process.stdout.readline()
        process.stdout.readline()  # the first second belongs to the start
        used_s, began_s = cpu_s(process.pid), time.monotonic()
        lines, ends = [], cycle(ENDS_DEG)
        say(UDP, ENABLE)
        with Metronome() as metronome:
            for _ in range(int(SECONDS)):
                say(UDP, mode(100), *target(*next(ends)))
                lines.append(process.stdout.readline())
        share = (cpu_s(process.pid) - used_s) / (time.monotonic() - began_s)
        process.send_signal(signal.SIGINT)
        assert process.wait(10) == 0
    sent = [int(found) for line in lines for found in re.findall(r"sent (\d+)/s", line)]
    late_ms = re.findall(r"late ([0-9.]+) ms", lines[-1])[0]
    print(
        f"\nudp_multicast, {SECONDS:.0f} s: {np.mean(sent):.0f} frames/s "
        f"(a second: {min(sent)} to {max(sent)}), {100 * share:.1f} % of a core; "
        f"worst lateness {late_ms} ms\n"
        f"  idle thread of the same period: {milliseconds(metronome.late_s)}"
    )
    assert "enabled 111111" in lines[-1]
    assert np.mean(sent) == pytest.approx(FRAMES_PER_S, rel=TOLERANCE)
    assert share < MOST_OF_A_CORE
