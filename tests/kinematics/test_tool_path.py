"""Lines and arcs as geometry: where they go, how long they are, how the hand turns."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from armui.kinematics.poses import Matrix, Pose, pose_to_matrix
from armui.kinematics.tool_path import Arc, ArcError, Line

SHARES = np.linspace(0.0, 1.0, 101)


def turned_deg(one: Matrix, other: Matrix) -> float:
    turn = Rotation.from_matrix(one[:3, :3].T @ other[:3, :3])
    return math.degrees(float(turn.magnitude()))


def test_a_line_is_straight_and_the_hand_turns_evenly() -> None:
    start, end = pose_to_matrix(Pose(0, 0, 0, 0, 0, 0)), pose_to_matrix(Pose(30, 40, 0, 0, 0, 90))
    line = Line(start, end)
    assert line.length_mm == pytest.approx(50.0)
    assert line.angle_deg == pytest.approx(90.0)
    poses = line.poses(SHARES)
    for share, pose in zip(SHARES, poses, strict=True):
        assert pose[:3, 3] == pytest.approx((30 * share, 40 * share, 0))
        assert turned_deg(start, pose) == pytest.approx(90 * share, abs=1e-6)


@pytest.mark.parametrize(
    ("middle", "end", "length"),
    [
        ((0, 10, 0), (-10, 0, 0), math.pi * 10),  # half a circle
        ((0, 10, 0), (0, -10, 0), 1.5 * math.pi * 10),  # over the far side
        ((0, -10, 0), (-10, 0, 0), math.pi * 10),  # the other way round
    ],
)
def test_an_arc_goes_over_its_middle(
    middle: tuple[float, ...], end: tuple[float, ...], length: float
) -> None:
    points: list[tuple[float, ...]] = [(10, 0, 0), middle, end]
    turns: list[tuple[float, ...]] = [(0, 0, 0), (10, 0, 5), (20, 30, 10)]
    start, between, last = (
        pose_to_matrix(Pose(*(point + turn))) for point, turn in zip(points, turns, strict=True)
    )
    arc = Arc(start, between, last)
    assert arc.length_mm == pytest.approx(length)
    poses = arc.poses(SHARES)
    assert np.linalg.norm(poses[:, :3, 3], axis=1) == pytest.approx(np.full(101, 10.0))
    assert poses[0] == pytest.approx(start, abs=1e-9)
    assert poses[-1] == pytest.approx(last, abs=1e-9)
    middle_share = (math.pi / 2) / (length / 10)
    assert arc.poses(np.array([middle_share]))[0] == pytest.approx(between, abs=1e-9)
    strides = [turned_deg(a, b) for a, b in itertools.pairwise(poses)]
    assert sum(strides) == pytest.approx(arc.angle_deg, rel=0.05)


@pytest.mark.parametrize(
    "points",
    [
        [(0, 0, 0), (1, 0, 0), (2, 0, 0)],
        [(0, 0, 0), (0, 0, 0), (2, 0, 0)],
        [(0, 0, 0), (1, 1, 0), (0, 0, 0)],
        [(0, 0, 0), (1, 1, 0), (1, 1, 0)],
    ],
)
def test_no_arc_through_points_on_a_line(points: list[tuple[float, ...]]) -> None:
    with pytest.raises(ArcError):
        Arc(*(pose_to_matrix(Pose(*(*point, 0.0, 0.0, 0.0))) for point in points))
