"""How the arm follows a 50 Hz sine of all joints: as a stream, and as bare MOVE J frames.

In simulated time, so that the computer's pace counts for nothing; the targets come up to 8 ms late,
as on a busy computer. Three ways: `stream.target` of a client; bare frames as of a policy's script
without armui, 0x151 and 0x155-0x157, MOVE J at 100 %; and the program's own jog of one joint, held,
against an even motion. The lag is the shift with which the arm's way fits what was asked best, the
error what is left then; a step of 20 ms reverses if it goes the other way than the one before,
which the sine itself does at its turns.

    python -m pytest tests/benchmarks/test_stream_path.py -s
"""

import itertools
import math
import random
import sys

import numpy as np
import pytest

from armui.control.motion.jog_path import JointJog
from tests.accepted import accepted
from tests.company import OtherHost
from tests.interface.conftest import Desk, RawClient, until_settled, with_lease

MID = (0.0, 60.0, -60.0, 0.0, 0.0, 0.0)
STEP_S = 0.005
EVERY_S = 0.02
LATEST_S = 0.008
SECONDS = 8.0
AMPLITUDE_DEG = 20.0
BEGINS_S = 1.0
"""Until then it is not judged: the stream takes it up from a rest."""
SHIFTS_S = np.arange(0.0, 0.4, 0.001)
STILL_DEG = 0.005

pytestmark = pytest.mark.skipif(
    sys.platform != "linux", reason="the interface is not offered there"
)


def sine(period_s):
    """Six angles by the time in seconds."""

    def at(t_s):
        angle = AMPLITUDE_DEG * math.sin(2.0 * math.pi * t_s / period_s)
        return tuple(each + angle * (1 if joint % 2 else -1) for joint, each in enumerate(MID))

    return at


def target_times():
    """When each target is sent: every 20 ms, and up to 8 ms late."""
    chance = random.Random(5)
    return [k * EVERY_S + chance.uniform(0.0, LATEST_S) for k in range(round(SECONDS / EVERY_S))]


def driven(rig, path, say):
    """Have each target said at its time; the arm's six angles every 5 ms."""
    began_s, way = rig.time_s, []
    due = list(target_times())
    while rig.time_s - began_s < SECONDS:
        while due and due[0] <= rig.time_s - began_s + 1e-9:
            say(path(due.pop(0)))
        rig.step(STEP_S)
        way.append((rig.time_s - began_s, *rig.firmware.joints_deg))
    return np.array(way)


def judged(way, path):
    """Lag in s, error in ° (root of the mean square, most), share of steps that reverse."""
    way = way[way[:, 0] >= BEGINS_S]
    times_s, angles_deg = way[:, 0], way[:, 1:]

    def errors_deg(shift_s):
        return angles_deg - np.array([path(t_s - shift_s) for t_s in times_s])

    lag_s = min(SHIFTS_S, key=lambda shift_s: float(np.mean(errors_deg(shift_s) ** 2)))
    left_deg = errors_deg(lag_s)
    steps = np.diff(angles_deg[:: round(EVERY_S / STEP_S)], axis=0)
    moving = (np.abs(steps[:-1]) > STILL_DEG) & (np.abs(steps[1:]) > STILL_DEG)
    reversed_ = moving & (steps[:-1] * steps[1:] < 0.0)
    speeds = np.diff(angles_deg, axis=0) / STEP_S
    rough = np.sqrt(np.mean(np.diff(speeds, axis=0) ** 2)) / STEP_S
    rms = float(np.sqrt(np.mean(left_deg**2)))
    return 1e3 * lag_s, rms, float(np.abs(left_deg).max()), float(reversed_.mean()), float(rough)


def asked(path):
    """The sine itself, as a way that is driven."""
    times_s = np.arange(0.0, SECONDS, STEP_S)
    return np.array([(t_s, *path(t_s)) for t_s in times_s])


def placed(rig):
    rig.ready()
    rig.controller.motion.set_speed_percent(100)
    accepted(rig.controller.motion.send_joints(MID))
    rig.run_until(lambda: rig.firmware.joints_deg == pytest.approx(MID, abs=0.05))
    rig.run(1.0)


def streamed(rig, path, tmp_path):
    """As targets of a client's stream."""
    desk = Desk(rig, tmp_path / "r" / "api.sock")
    desk.switch(on=True)
    until_settled(desk)
    client = with_lease(RawClient(rig, desk.view.path), desk)

    def say(target):
        number = client.begin("stream.target", lease=client.lease, joints_deg=list(target))
        while number not in client.answers:
            client.read()
            rig.step(0.0)

    try:
        return driven(rig, path, say)
    finally:
        client.close()
        desk.end()


def bare(rig, path, _tmp_path):
    """As frames of another host."""
    host = OtherHost(rig)
    way = driven(rig, path, lambda target: host.move_to(target, 100))
    host.close()
    return way


@pytest.mark.parametrize("period_s", [4.0, 2.2], ids=["31 °/s", "57 °/s"])
@pytest.mark.parametrize("how", [streamed, bare])
def test_a_sine(rig, tmp_path, capsys, benchmark, how, period_s):
    path = sine(period_s)
    placed(rig)
    found = judged(how(rig, path, tmp_path), path)
    names = ("lag_ms", "rms_deg", "most_deg", "reversed", "rough_deg_s2")
    benchmark.extra_info.update(zip(names, found, strict=True))
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n  20° in {period_s} s, {how.__name__:9} " + figures(found))
        print("  the sine itself        " + figures(judged(asked(path), path)))


def figures(found):
    lag_ms, rms, most, reversed_, rough = found
    return (
        f"lag {lag_ms:4.0f} ms, error {rms:.2f}° (most {most:.2f}), "
        f"{100 * reversed_:4.1f} % of the steps reverse, acceleration {rough:6.0f}°/s²"
    )


def test_a_jog(rig, capsys, benchmark):
    placed(rig)
    jogging = rig.controller.jogging
    accepted(jogging.start(JointJog(1, 1)))
    speed = jogging.present_pace().speeds_deg_s[0]
    begun, way = [], []
    for _ in itertools.repeat(None, round(3.0 / STEP_S)):
        rig.step(STEP_S)
        hold = jogging._hold
        if hold.stream is not None:
            begun.append(rig.time_s)
        if begun:
            way.append((rig.time_s - begun[0], *rig.firmware.joints_deg))
    found = judged(np.array(way), lambda t_s: (speed * t_s, *MID[1:]))
    benchmark.pedantic(lambda: None, rounds=1)
    with capsys.disabled():
        print(f"\n  joint 1 jogged at {speed:.1f} °/s: " + figures(found))
