"""What the controller's tick costs, without a window: an arm at rest, moving, and jogged.

Processor time of the GUI thread, so that others on the computer do not count. Beside it in the same
run: decoding the frames that an arm says between two ticks. Stated as well: how often the authority
looks at the arm and how often the operating state is
assessed, a tick.

    python -m pytest tests/benchmarks/test_tick.py -s
"""

import time

import numpy as np
import pytest

from armui.control import assessment, assessment_inputs
from armui.control.authority import Authority
from armui.control.motion.jog_path import JointJog
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.arm_rig import ArmRig

TICKS = 300
ENDS_DEG = ((30, 60, -40, 20, 15, 30), (-30, 30, -60, -20, -15, -30))


class Counted:
    """Calls of a function, counted."""

    def __init__(self, function):
        self._function = function
        self.calls = 0

    def __call__(self, *args, **kwargs):
        self.calls += 1
        return self._function(*args, **kwargs)


def timed_ticks(rig, act):
    """The processor time of each tick in µs; ``act`` is called before each."""
    spent_us = []
    tick = rig.controller.tick

    def timed():
        began_ns = time.thread_time_ns()
        tick()
        spent_us.append((time.thread_time_ns() - began_ns) / 1e3)

    rig.controller.tick = timed
    for number in range(TICKS):
        act(number)
        rig.step()
    rig.controller.tick = tick
    return spent_us


def decoding_us():
    """The same for the frames of a tick, decoded and nothing more."""
    from armui.sim.firmware import Firmware  # noqa: PLC0415 - only here

    firmware, codec = Firmware(Generation.TWO), Codec(Generation.TWO)
    frames = [Frame(each.arbitration_id, bytes(each.data)) for each in firmware.step(0.033)]
    spent_us = []
    for _ in range(TICKS):
        began_ns = time.thread_time_ns()
        for frame in frames:
            codec.decode(frame)
        spent_us.append((time.thread_time_ns() - began_ns) / 1e3)
    return spent_us, len(frames)


def to_and_fro(controller):
    def act(number):
        if number % 50 == 0:
            controller.motion.send_joints(ENDS_DEG[number // 50 % 2])

    return act


def held_jog(controller):
    def act(number):
        if not controller.jogging.active:
            controller.jogging.start(JointJog(1, 1 if number % 100 < 50 else -1))

    return act


@pytest.mark.timeout(300)
def test_tick(qapp, monkeypatch, capsys, benchmark):
    observed = Counted(Authority.observe)
    assessed = Counted(assessment.assess)

    def observe(authority, seen):
        observed(authority, seen)

    monkeypatch.setattr(Authority, "observe", observe)
    monkeypatch.setattr(assessment_inputs, "assess", assessed)
    rig = ArmRig("benchmark-tick")
    lines = []
    try:
        rig.ready()
        for name, act in (
            ("at rest", lambda _number: None),
            ("moving", to_and_fro(rig.controller)),
            ("jogged", held_jog(rig.controller)),
        ):
            observed.calls = assessed.calls = 0
            spent = timed_ticks(rig, act)
            counts = observed.calls / TICKS, assessed.calls / TICKS
            p50, p99 = np.percentile(spent, (50, 99))
            lines.append(
                f"  {name:10} median {p50:5.0f}, 99 % {p99:5.0f} µs; "
                f"observed {counts[0]:.1f}, assessed {counts[1]:.1f} times a tick"
            )
    finally:
        rig.close()
    spent, frames = decoding_us()
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print("\nthe controller's tick, processor time:")
        print("\n".join(lines))
        print(f"  beside it: {frames} frames decoded, median {np.median(spent):.0f} µs")
    assert len(lines) == 3
