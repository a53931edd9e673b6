"""S16: whatever way the arm is driven was checked, the way back to a recording's start, too."""

import numpy as np
import pytest

from armui.protocol.codes import MoveMode
from armui.trajectory.planning.check import CheckRequest, check
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.trajectory.arms import ARM

# from the one straight to the other the hand dips 45 mm below the floor
OUT = (0.0, 98.0, -35.0, 0.0, 64.0, 0.0)
BACK = (0.0, 130.0, -74.0, 0.0, -49.0, 0.0)
OVER = (0.0, 30.0, -60.0, 0.0, 0.0, 0.0)


def recording(*corners, seconds=60.0):
    times = np.arange(0.0, seconds, 0.05)
    at = np.linspace(0.0, seconds, len(corners))
    samples = np.full((len(times), 8), np.nan)
    samples[:, 0] = times
    for joint, angles in enumerate(zip(*corners, strict=True), start=1):
        samples[:, joint] = np.interp(times, at, angles)
    return Recording("r", samples=samples)


def codes(content, start, **options):
    return {one.code for one in check(CheckRequest(content, ARM, start, **options)).findings}


def test_a_recording_once_is_fine():
    assert "below_floor" not in codes(recording(BACK, OVER, OUT), BACK)


def test_the_way_back_for_another_lap_is_checked():
    assert "below_floor" in codes(recording(BACK, OVER, OUT), BACK, cycles=2)


def test_the_same_points_as_a_trajectory_give_the_same_finding():
    points = tuple(
        Waypoint(MoveMode.MOVE_J, corner, speed_percent=15) for corner in (BACK, OVER, OUT)
    )
    assert "below_floor" not in codes(Trajectory("t", points=points), BACK)
    assert "below_floor" in codes(Trajectory("t", points=points), BACK, cycles=2)


def test_the_approach_is_checked():
    assert "below_floor" in codes(recording(BACK, OVER), OUT)


@pytest.mark.parametrize("again", [False, True])
def test_a_long_way_back_by_itself_is_no_finding(again):
    turned = (40.0, *OVER[1:])
    assert codes(recording(OVER, turned), OVER, cycles=2 if again else 1) == set()
