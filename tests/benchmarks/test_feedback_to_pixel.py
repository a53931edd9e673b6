"""How long a measured angle takes from the arm to a changed pixel, stage by stage.

The simulated arm moves in real time; the last of the three frames that tell where its joints are is
the key to what the picture shows later.
"""

import time
from collections import deque
from typing import Any

import can
import numpy as np
import pytest

from armui.arm.device import Device
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.benchmarks import rig
from tests.sim.talk import ENABLE, frame, mode, target

CHANNEL = "benchmark-pixel"
LAST_ANGLES_ID = 0x2A7
PICTURES = 200
ENDS_DEG = ((60, 90, -60, 40, 30, 60), (-60, 40, -90, -40, -30, -60))


def key_of(data):
    """Angles 5 and 6 in 0.001°: a moving arm has each pair once."""
    return int.from_bytes(data[:4], "big", signed=True), int.from_bytes(
        data[4:8], "big", signed=True
    )


class Stamps:
    """When what happened to which angles, by the system's monotonic clock."""

    def __init__(self, program, sent_s):
        self._program, self._sent_s = program, sent_s
        self._key_of_sequence = {}
        self._told_s, self._heard_s, self._updated_s = {}, {}, {}
        self._snapshots_s: deque[Any] = deque(maxlen=100)
        tracker = program.controller._connection._worker._processor._tracker
        snapshot = tracker.snapshot

        def timed_snapshot():
            state = snapshot()
            self._snapshots_s.append(time.monotonic())
            return state

        tracker.snapshot = timed_snapshot
        self.stages_ms: dict[Any, Any] = {
            name: [] for name in ("bus", "update", "tick", "draw", "paint", "all")
        }
        program.controller.state_changed.connect(self._on_state)
        client = program.view._client
        self._frame_used = client.frame_used
        client.frame_used = self._on_painted

    def _on_state(self, state):
        five, six = state.joints_deg[4:6]
        if five is None or six is None:
            return
        key = round(1000 * five.value), round(1000 * six.value)
        sequence = self._program.view._client._sequence
        if key in self._sent_s and sequence not in self._key_of_sequence:
            self._key_of_sequence[sequence] = key
            self._heard_s[sequence] = six.at_s
            self._told_s[sequence] = time.monotonic()
            updated_s = [at_s for at_s in list(self._snapshots_s) if at_s >= six.at_s]
            self._updated_s[sequence] = min(updated_s, default=six.at_s)

    def _on_painted(self, picture):
        self._frame_used(picture)
        now_s, seen = time.monotonic(), picture.frame.drawn
        key = self._key_of_sequence.pop(seen.sequence, None)
        if key is None:
            return
        sent_s, heard_s = self._sent_s[key], self._heard_s[seen.sequence]
        told_s, updated_s = self._told_s[seen.sequence], self._updated_s[seen.sequence]
        ends = {
            "bus": heard_s - sent_s,
            "update": updated_s - heard_s,
            "tick": told_s - updated_s,
            "draw": seen.ended_s - told_s,
            "paint": now_s - seen.ended_s,
            "all": now_s - sent_s,
        }
        for name, seconds in ends.items():
            self.stages_ms[name].append(1e3 * seconds)


@pytest.mark.timeout(600)
def test_feedback_to_pixel(qapp, tmp_path, capsys, benchmark):
    sent_s = {}
    firmware = Firmware(Generation.TWO)
    ends = list(ENDS_DEG)
    with can.Bus(interface="virtual", channel=CHANNEL) as arm_side:
        send = arm_side.send

        def timed_send(message, timeout=None):
            if message.arbitration_id == LAST_ANGLES_ID:
                sent_s[key_of(message.data)] = time.monotonic()
            send(message, timeout)

        arm_side.send = timed_send
        device = Device("virtual", CHANNEL, None, simulated=True, generation=2)
        with (
            Node(firmware, arm_side),
            rig.window(
                qapp,
                tmp_path,
                lambda _device: can.Bus(interface="virtual", channel=CHANNEL),
                device,
            ) as program,
        ):
            firmware.on_frame(frame(ENABLE))
            stamps = Stamps(program, sent_s)
            while len(stamps.stages_ms["all"]) < PICTURES:
                for line in (mode(40), *target(*ends[0])):
                    firmware.on_frame(frame(line))
                ends.reverse()
                rig.run_for(1.5)
    benchmark.extra_info["p95_ms"] = float(np.percentile(stamps.stages_ms["all"], 95))
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nfeedback frame to changed pixel:")
        for name, values_ms in stamps.stages_ms.items():
            print(rig.spread(name, values_ms))
    assert len(stamps.stages_ms["all"]) >= PICTURES
