"""The tip of a tool by points: found where it is true, refused where the poses cannot tell."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from armui.arm.refusal import Refusal
from armui.cell.tool_calibration import (
    POINTS_TOO_NEAR,
    POSES_ALIKE,
    POSES_DO_NOT_FIT,
    TOO_FEW_POSES,
    along_axis,
    by_two_points,
    find_tip,
    spread,
    turned_from_deg,
)
from armui.kinematics.poses import matrix_to_pose, pose_to_matrix

POINT = np.array((320.0, 40.0, 60.0))
TILTS = ((0, 0), (25, 0), (-25, 10), (0, 30), (10, -25), (-15, -20))
"""Turns about the base's X and Y of a hand that points down, as an operator may give them."""


def turn(rx_deg, ry_deg, rz_deg):
    return pose_to_matrix((0.0, 0.0, 0.0, rx_deg, ry_deg, rz_deg))[:3, :3]


def flange(tip, rotation, point=POINT):
    """The flange's pose while a tip touches a point."""
    matrix = np.eye(4)
    matrix[:3, :3] = rotation
    matrix[:3, 3] = point - rotation @ np.array(tip)
    return tuple(matrix_to_pose(matrix))


def touching(tip, tilts=TILTS, spin_deg=0.0):
    return [flange(tip, turn(180 + rx, ry, spin_deg * k)) for k, (rx, ry) in enumerate(tilts)]


@given(st.lists(st.floats(-300.0, 300.0), min_size=3, max_size=3), st.floats(-40.0, 40.0))
def test_the_tip_of_exact_poses_is_found(tip, spin_deg):
    fit = find_tip(touching(tip, spin_deg=spin_deg))
    assert fit.tip_mm == pytest.approx(tip, abs=1e-6)
    assert fit.point_mm == pytest.approx(POINT, abs=1e-6)
    assert fit.largest_mm < 1e-6
    assert fit.refusal(1.0) is None


def test_less_than_four_poses_are_too_few():
    answer = find_tip(touching((0, 0, 100))[:3])
    assert (answer.reason, answer.params) == (TOO_FEW_POSES, {"count": 3, "minimum": 4})


@given(
    st.lists(st.floats(-200.0, 200.0), min_size=3, max_size=3),
    st.lists(st.floats(-180.0, 180.0), min_size=3, max_size=3),
    st.lists(st.floats(-170.0, 170.0), min_size=4, max_size=12),
    st.integers(0, 2),
)
def test_turns_about_one_axis_are_refused_each_time(tip, first, angles, axis):
    """Whatever the axis: along it the tip cannot be told."""
    about = [[0.0, 0.0, 0.0] for _ in angles]
    for each, angle in zip(about, angles, strict=True):
        each[axis] = angle
    poses = [flange(tip, turn(*first) @ turn(*each)) for each in about]
    refusal = find_tip(poses).refusal(1.0)
    assert refusal.reason == POSES_ALIKE


@given(
    st.lists(st.floats(-200.0, 200.0), min_size=3, max_size=3),
    st.lists(st.tuples(*(st.floats(-0.02, 0.02) for _ in range(3))), min_size=4, max_size=12),
)
def test_poses_that_hardly_differ_are_refused_each_time(tip, turns):
    poses = [flange(tip, turn(180, 0, 0) @ turn(*each)) for each in turns]
    assert find_tip(poses).refusal(1.0).reason == POSES_ALIKE


def test_turns_about_one_axis_stay_refused_when_the_poses_are_noisy():
    rng = np.random.default_rng(3)
    accepted = 0
    for _ in range(300):
        angles = rng.uniform(-60, 60, 6)
        poses = [flange((0, 0, 120), turn(180, 0, 0) @ turn(0, 0, each)) for each in angles]
        noisy = [noisy_pose(rng, each) for each in poses]
        accepted += find_tip(noisy).refusal(1.0) is None and spread(noisy).is_enough
    assert accepted == 0


def test_a_slipped_pose_is_named_with_its_residual():
    poses = touching((5, -3, 120))
    x, *rest = poses[3]
    poses[3] = (x + 8.0, *rest)
    fit = find_tip(poses)
    refusal = fit.refusal(1.0)
    assert (refusal.reason, refusal.params["pose"]) == (POSES_DO_NOT_FIT, 4)
    assert refusal.params["value"] == fit.residuals_mm[3] == fit.largest_mm
    assert fit.refusal(10.0) is None
    assert find_tip([*poses[:3], *poses[4:]]).refusal(1.0) is None


def test_what_has_turned_least_is_named():
    about_z = [flange((0, 0, 100), turn(180, 0, 0) @ turn(0, 0, each)) for each in (0, 40, 80, 120)]
    assert spread(about_z).axis == "Z"
    assert spread(about_z).turned_deg == pytest.approx(0.0, abs=1e-3)
    about_x = [flange((0, 0, 100), turn(180 + each, 0, 0)) for each in (0, 20, 40, 60)]
    assert spread(about_x).axis == "X"
    enough = spread(touching((0, 0, 100)))
    assert enough.is_enough
    assert turned_from_deg(about_x[0], about_x[1:]) == pytest.approx(20.0)


def noisy_pose(rng, pose, mm=0.05, deg=0.05):
    """A pose as measured: its place by the one figure off, its orientation by the other (1 σ)."""
    matrix = pose_to_matrix(pose)
    axis = rng.normal(size=3)
    angle = math.radians(rng.normal() * deg)
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array(((0, -z, y), (z, 0, -x), (-y, x, 0)))
    turned = np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross
    matrix[:3, :3] = turned @ matrix[:3, :3]
    matrix[:3, 3] += rng.normal(size=3) * mm
    return tuple(matrix_to_pose(matrix))


def one_of_a_thousand(rng, count):
    """A tool, and the poses in which an operator touches the point with it: within 35° of down."""
    tip = rng.uniform((-60, -60, 40), (60, 60, 200))
    about = rng.uniform((145, -35, -60), (215, 35, 60), (count, 3))
    turns = [turn(*each) for each in about]
    return tip, [noisy_pose(rng, flange(tip, each)) for each in turns]


def measured(count, seed=11):
    """Errors and residuals of 1,000 tools by `count` poses each; those refused are left out."""
    rng = np.random.default_rng(seed)
    errors, residuals, refused = [], [], 0
    for _ in range(1000):
        tip, poses = one_of_a_thousand(rng, count)
        fit = find_tip(poses)
        if fit.refusal(1.0) is not None or not fit.spread.is_enough:
            refused += 1
            continue
        errors.append(math.dist(fit.tip_mm, tip))
        residuals.append(fit.rms_mm)
    return np.array(errors), np.array(residuals), refused


def test_the_error_of_a_thousand_tools_beside_the_residual_that_is_shown():
    """As told in the page of the room; `python -m tests.cell.test_tool_calibration` prints it."""
    errors, residuals, refused = measured(4)
    assert len(errors) > 900
    assert np.median(residuals) < 0.15
    # the residual is smaller than the error: it says how well the poses fit
    assert np.median(errors) > np.median(residuals)
    six, _, _ = measured(6)
    assert np.median(six) < np.median(errors)
    assert np.percentile(six, 95) < 1.0
    assert len(errors) + refused == 1000


def test_a_tool_that_points_down_gets_that_as_its_z():
    rotation = turn(170, 20, 35)
    rx, ry, rz = along_axis(flange((0, 0, 100), rotation), 2, -1)
    tool = turn(rx, ry, rz)
    assert rotation @ tool[:, 2] == pytest.approx((0.0, 0.0, -1.0), abs=1e-9)
    straight = along_axis(flange((0, 0, 100), turn(180, 0, 0)), 2, -1)
    assert straight == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)


def test_two_more_points_give_the_orientation():
    tip = (30.0, -10.0, 110.0)
    wanted = turn(20, -30, 15)
    fit = find_tip(touching(tip))
    assert not isinstance(fit, Refusal)
    shank = np.array(tip) - 40.0 * wanted[:, 2]
    side = np.array(tip) + 25.0 * wanted[:, 0] - 10.0 * wanted[:, 2]
    found = by_two_points(fit, flange(shank, turn(175, 5, 0)), flange(side, turn(190, -5, 20)))
    assert not isinstance(found, Refusal)
    assert turn(*found) == pytest.approx(wanted, abs=1e-6)
    near = by_two_points(fit, flange(tip, turn(175, 5, 0)), flange(side, turn(190, -5, 20)))
    assert isinstance(near, Refusal)
    assert near.reason == POINTS_TOO_NEAR
    in_line = by_two_points(fit, flange(shank, turn(175, 5, 0)), flange(shank, turn(190, 0, 9)))
    assert in_line.reason == POINTS_TOO_NEAR


if __name__ == "__main__":
    for count in (4, 6, 8):
        errors, residuals, refused = measured(count)
        figures = [f"{each:.3f}" for each in (*np.percentile(errors, (50, 95)), errors.max())]
        shown = [f"{each:.3f}" for each in np.percentile(residuals, (50, 95))]
        ratio = np.median(errors / residuals)
        print(f"{count} poses: error median, 95 %, largest {figures} mm; RMS shown {shown} mm;")
        print(f"  error by RMS, median {ratio:.1f}; refused {refused}")
