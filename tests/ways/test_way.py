"""What the ramps of the joints do to a way, against the simulated arm's planner."""

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.protocol.generation import PiperModel
from armui.sim.mechanics.powered_joints import JointMotion
from armui.ways.way import Way, joint_way, rest_of, straight_way, with_ramps
from tests.cell.sampled_ways import HIGH, LOW

DATA = model_data(PiperModel.PIPER)
SPEEDS = tuple(each.max_speed_deg_s for each in DATA.limits)
ACCELERATIONS = DATA.accelerations_deg_s2
LOOK_S = 0.01


def ramped(way):
    return with_ramps(way, SPEEDS, ACCELERATIONS)


def driven(begin, end, share):
    """The poses that the simulated arm passes at a share of its speed."""
    motion = JointMotion(begin)
    motion.move_to(end, [share * each for each in SPEEDS], ACCELERATIONS)
    poses = [motion.positions_deg]
    while motion.moving:
        motion.step(LOOK_S)
        poses.append(motion.positions_deg)
    return np.array(poses)


def beyond_deg(way, poses):
    """By how much the poses are beyond what a way allows for, each where it is so least."""
    places = np.linspace(0.0, len(way.joints_deg) - 1.0, 4000)
    index = np.minimum(places.astype(int), len(way.joints_deg) - 2)
    shares = (places - index)[:, None]

    def between(values):
        return values[index] + shares * (values[index + 1] - values[index])

    off = np.abs(poses[:, None] - between(way.joints_deg)) - between(way.spreads_deg)
    return off.max(axis=2).min(axis=1).max()


@pytest.mark.each_value(full="each length of a way at each share of the speed")
@pytest.mark.parametrize("share", [1.0, 0.5, 0.1])
@pytest.mark.parametrize("most_deg", [5.0, 40.0, 300.0])
def test_the_arm_is_nowhere_beyond_it(share, most_deg):
    random = np.random.default_rng(7)
    for _ in range(12):
        begin = random.uniform(LOW, HIGH)
        turns = random.uniform(-1.0, 1.0, 6) * most_deg * (random.random(6) < 0.7)
        end = np.clip(begin + turns, LOW, HIGH)
        way = ramped(joint_way(tuple(begin), tuple(end)))
        tolerance = 0.02 + 0.004 * np.abs(end - begin).max()
        assert beyond_deg(way, driven(begin, end, share)) < tolerance
        assert beyond_deg(way, np.linspace(begin, end, 50)) < tolerance


def test_it_is_needed():
    begin, end = (0.0,) * 6, (90.0, 30.0, 0.0, 0.0, 10.0, 0.0)
    assert beyond_deg(straight_way(begin, end), driven(begin, end, 1.0)) > 1.0


def test_what_is_no_motion_of_the_joints_by_themselves_stays_as_it_is():
    line = Way(np.array(((0.0,) * 6, (10.0, 1.0, 0, 0, 0, 0), (90.0, 30.0, 0, 0, 0, 0))))
    single = joint_way((0.0,) * 6, (90.0, 0, 0, 0, 0, 0))
    nowhere = joint_way((5.0,) * 6, (5.0,) * 6)
    unknown = joint_way((0.0,) * 6, (np.nan,) * 6)
    for way in (line, single, nowhere, unknown):
        assert ramped(way) is way


def test_the_ends_are_those_of_the_way():
    way = ramped(joint_way((1.0, 2, 3, 4, 5, 6), (70.0, 20, -3, 4, 50, 6)))
    assert way.begin_deg == (1, 2, 3, 4, 5, 6)
    assert way.end_deg == (70, 20, -3, 4, 50, 6)
    assert not way.spreads_deg[[0, -1]].any()


def test_what_is_left_of_it_has_ramps_too():
    way = joint_way((0.0,) * 6, (90.0, 30.0, 0, 0, 0, 0))
    left = ramped(rest_of(way, (45.0, 20.0, 0, 0, 0, 0)))
    assert left.spreads_deg.max() > 0.2
