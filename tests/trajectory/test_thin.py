"""Recordings thinned, trimmed, and made into points."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.trajectory.samples.recording import Recording
from armui.trajectory.samples.thin import thin, to_points, trim
from tests.family import FACTORY_LIMITS


def recording(joints_deg, step_s=0.01, opening_mm=np.nan):
    joints_deg = np.asarray(joints_deg, dtype=float)
    times_s = np.arange(len(joints_deg)) * step_s
    openings = np.full(len(joints_deg), opening_mm)
    return Recording("r", samples=np.column_stack([times_s, joints_deg, openings]))


def wave(count=2000):
    at = np.linspace(0, 6, count)[:, None]
    return 30 * np.sin(at * np.arange(1, 7))


def off_deg(whole, thinned):
    return max(
        np.abs(np.interp(whole.times_s, thinned.times_s, kept) - angles).max()
        for angles, kept in zip(whole.joints_deg.T, thinned.joints_deg.T, strict=True)
    )


@pytest.mark.parametrize("tolerance_deg", [0.05, 0.5, 5.0])
def test_what_is_left_out_lies_within_the_tolerance_at_its_own_time(tolerance_deg):
    whole = recording(wave())
    thinned = thin(whole, tolerance_deg)
    assert off_deg(whole, thinned) <= tolerance_deg + 1e-9
    assert len(thinned.samples) < len(whole.samples) / 2
    assert (thinned.samples[[0, -1]] == whole.samples[[0, -1]])[:, :7].all()


def test_a_straight_motion_needs_two_samples():
    line = np.linspace(0, 1, 500)[:, None] * np.arange(1, 7)
    assert len(thin(recording(line), 0.01).samples) == 2


def test_a_corner_is_kept():
    corner = np.concatenate([np.linspace(0, 20, 101), np.linspace(20, 0, 101)[1:]])
    thinned = thin(recording(corner[:, None] * np.ones(6)), 0.1)
    assert thinned.joints_deg[:, 0].tolist() == [0.0, 20.0, 0.0]


def test_a_pause_is_kept():
    """The path alone would not need it; the replay's time does."""
    angles = np.concatenate([np.linspace(0, 10, 50), np.full(100, 10.0), np.linspace(10, 20, 50)])
    whole = recording(angles[:, None] * np.ones(6))
    assert off_deg(whole, thin(whole, 0.2)) <= 0.2


def test_the_gripper_alone_is_reason_to_keep_a_sample():
    whole = recording(np.zeros((300, 6)), opening_mm=0.0)
    whole.samples[100:200, 7] = 40.0
    thinned = thin(whole, 1.0)
    assert 40.0 in thinned.gripper_mm
    assert len(thinned.samples) < 10


@given(st.integers(0, 40), st.randoms(use_true_random=False))
def test_any_motion_stays_within_the_tolerance(count, random):
    angles = [[random.uniform(-90, 90) for _ in range(6)] for _ in range(count)]
    whole = recording(np.array(angles).reshape(count, 6))
    thinned = thin(whole, 30.0)
    assert len(thinned.samples) >= min(count, 2)
    if count:
        assert off_deg(whole, thinned) <= 30.0 + 1e-6


def test_a_negative_tolerance_is_none():
    with pytest.raises(ValueError, match="tolerance"):
        thin(recording(wave(10)), -1.0)


def test_a_stretch_is_cut_out_and_counted_from_0():
    cut = trim(recording(wave()), 5.0, 7.5)
    assert (cut.times_s[0], cut.times_s[-1]) == (0.0, pytest.approx(2.5))
    assert cut.joints_deg[0] == pytest.approx(wave()[500])


def test_samples_become_points_with_the_speed_they_had():
    angles = np.zeros((3, 6))
    angles[1:, 1] = 0.5 * FACTORY_LIMITS[1].max_speed_deg_s  # in one second
    trajectory = to_points(recording(angles, step_s=1.0), FACTORY_LIMITS)
    assert [point.speed_percent for point in trajectory.points] == [100, 50, 1]
    assert trajectory.points[1].target[1] == pytest.approx(angles[1, 1], abs=1e-3)
