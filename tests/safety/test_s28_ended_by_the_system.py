"""S28: what the system ends ends like what the operator closes: motion ended, bus closed, in 1 s."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import can
import pytest

from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.test_window_process import is_running, shared_memory_of, wait_for_the_end_of

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="sends signals, reads /proc"),
    pytest.mark.timeout(150),
]

PORT = 46202
ABORT = (0x150, bytes([0, 6, 0, 0, 0, 0, 0, 0]))  # byte 1: the trajectory command 6, end it
LONGEST_S = 1.0
ROOT = Path(__file__).resolve().parents[2]


class Outside:
    """An arm, and somebody who listens, on a bus that is no part of the program's process."""

    def __init__(self, tmp_path):
        self.group = f"239.74.163.{os.getpid() % 200 + 20}"
        options = {"interface": "udp_multicast", "channel": self.group, "port": PORT}
        self.arm_bus, self.ear = can.Bus(**options), can.Bus(**options)
        self.firmware = Firmware(Generation.TWO)
        self.node = Node(self.firmware, self.arm_bus)
        own = {name: str(tmp_path) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
        own |= {"XDG_STATE_HOME": str(tmp_path), "XDG_RUNTIME_DIR": str(tmp_path)}
        self.environment = {
            **os.environ,
            **own,
            "QT_QPA_PLATFORM": "offscreen",
            "PYTHONPATH": str(ROOT),
        }
        self.process = None
        self.picture = None

    def begin(self, state):
        """Start the program; it drives the arm, and does what `state` says."""
        script = str(ROOT / "tests" / "safety" / "ended_program.py")
        self.process = subprocess.Popen(
            [sys.executable, script, str(PORT), self.group, state],
            stdout=subprocess.PIPE,
            env=self.environment,
            text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # noqa: PLW1509 - no lock in it
        )
        self.picture = json.loads(self.process.stdout.readline())["picture"]

    def hear_the_end(self, *, by):
        """Whether the end of the motion is heard within a second of a signal."""
        while self.ear.recv(0) is not None:
            pass
        began_s = time.monotonic()
        self.process.send_signal(by)
        while (left_s := began_s + LONGEST_S - time.monotonic()) > 0:
            message = self.ear.recv(left_s)
            if message is not None and (message.arbitration_id, bytes(message.data)) == ABORT:
                return time.monotonic() - began_s
        return None

    def close(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process.stdout.close()
        self.arm_bus.shutdown()
        self.ear.shutdown()


@pytest.fixture
def outside(tmp_path):
    outside = Outside(tmp_path)
    with outside.node:
        yield outside
    outside.close()


@pytest.mark.parametrize(
    ("state", "by"),
    [
        ("run", signal.SIGTERM),
        ("run", signal.SIGHUP),
        ("run", signal.SIGINT),
        ("menu", signal.SIGTERM),
        ("dialog", signal.SIGTERM),
        ("busy", signal.SIGTERM),
        ("stuck", signal.SIGTERM),
    ],
    ids=lambda value: value if isinstance(value, str) else value.name,
)
def test_a_signal_in_mid_motion_ends_it(outside, state, by):
    outside.begin(state)
    began_s = time.monotonic()
    heard_s = outside.hear_the_end(by=by)
    outside.process.send_signal(by)  # once more: nothing of the first one's ending is undone
    code = outside.process.wait(10.0)
    gone_s = time.monotonic() - began_s
    assert heard_s is not None
    assert code == 128 + by
    print(f"{state} {by.name}: motion ended after {heard_s:.3f} s, program after {gone_s:.3f} s")
    at_end = outside.firmware.joints_deg
    assert outside.firmware.joints_deg[0] < 55.0
    wait_for_the_end_of(outside.picture)
    assert shared_memory_of(outside.process.pid) == []
    assert at_end == pytest.approx(outside.firmware.joints_deg, abs=2.0)
    assert max(map(abs, outside.firmware.mechanics.speeds_deg_s)) < 0.1
