"""S16, S32: a fast replay cuts its corners, and that way counts, not only the recorded one.

The simulated arm follows targets that come fifty times a second; where the recorded joints change
their speeds at once it is ahead of some of them and behind others for a while.
"""

from itertools import pairwise

import numpy as np
import pytest

from armui.arm.refusal import Refusal
from armui.cell.area_check import AREA_IN_THE_WAY
from armui.cell.cell import Cell
from armui.cell.work_area import AreaBox
from armui.control.operations.started import refusal_of
from armui.control.run.replay import Replay
from armui.trajectory.samples.recording import Recording
from tests.accepted import accepted
from tests.cell.areas import area_of, check_of
from tests.safety.arm_oracle import tip_of
from tests.safety.inline_rig import inline_rig

LOW = (-25.0, 95.0, -60.0, 0.0, 30.0, 0.0)
OVER = (-25.0, 60.0, -60.0, 0.0, 30.0, 0.0)
BEYOND = (25.0, 60.0, -60.0, 0.0, 30.0, 0.0)
MARGIN_MM = 10.0
TREMBLE_DEG = 0.05


@pytest.fixture
def rig(qapp, request):
    with inline_rig(request.node.nodeid) as rig:
        rig.ready()
        yield rig


def recording(speed_deg_s):
    """Up, and at once across: each joint at the same speed, without a ramp."""
    samples = [np.array(LOW)] * 10
    for before, after in ((LOW, OVER), (OVER, BEYOND)):
        turn = np.subtract(after, before)
        steps = round(np.abs(turn).max() / speed_deg_s / 0.02)
        samples += [before + turn * step / steps for step in range(1, steps + 1)]
    samples += [np.array(BEYOND)] * 30
    times = np.arange(len(samples))[:, None] * 0.02
    openings = np.full((len(times), 1), np.nan)
    return Recording("corner", samples=np.hstack((times, samples, openings)))


def finely(poses):
    """Eight places from each pose to the next."""
    shares = np.arange(8)[:, None] / 8.0
    steps = [a + shares * (b - a) for a, b in pairwise(poses)]
    return np.vstack((*steps, poses[-1:]))


def driven(rig):
    """The angles of the arm while it follows the recorded ones."""
    found: list[tuple[float, ...]] = []
    for _ in range(4000):
        rig.step(0.01)
        replayer = rig.controller.replayer
        if not replayer.running:
            return np.array(found)
        if replayer._command is not None and replayer._watch is None:
            found.append(rig.firmware.joints_deg)
    raise AssertionError("the replay does not end")


@pytest.mark.parametrize("speed_deg_s", [60.0, 120.0])
def test_the_arm_stays_within_the_way_that_was_checked(rig, speed_deg_s):
    replay = Replay(recording(speed_deg_s))
    accepted(rig.controller.replayer.start(replay))
    angles = driven(rig)
    way = replay.way(LOW)
    assert way.beside_deg is not None
    off = np.abs(angles[:, None] - finely(way.joints_deg)[None])
    cut = off.max(axis=2).min(axis=1).max()
    assert cut > 1.0, "no corner is cut: this shows nothing"
    assert (off - finely(way.beside_deg)).max(axis=2).min(axis=1).max() <= TREMBLE_DEG


def corner_box(gap_mm):
    """A box in the inside of the corner, so far from the recorded way."""
    way = recording(120.0).joints_deg
    inner = tip_of((5.0, 95.0, *LOW[2:]))
    for size in np.arange(10.0, 400.0, 2.0):
        box = AreaBox("post", (*inner, 0.0, 0.0, 0.0), (float(size),) * 3)
        if check_of(box).gaps(way).min() <= gap_mm:
            return box
    raise AssertionError("no box is that near")


def test_a_corner_that_is_cut_into_a_zone_is_refused_and_driven_slowly(rig):
    accepted(rig.controller.motion.send_joints(LOW))
    rig.run(6.0)
    box = corner_box(MARGIN_MM + 8.0)
    accepted(rig.controller.cell.take(Cell("bench", area=area_of(box, margin_mm=MARGIN_MM))))
    answer = rig.controller.replayer.start(Replay(recording(120.0)))
    assert isinstance(answer, Refusal)
    assert answer.reason == AREA_IN_THE_WAY
    accepted(rig.controller.replayer.start(Replay(recording(120.0), speed_percent=20)))
    raised = rig.controller.motion.set_speed_percent(21)
    assert refusal_of(raised).reason == AREA_IN_THE_WAY
    angles = driven(rig)
    assert check_of(box).gaps(angles).min() >= MARGIN_MM - 1.0
