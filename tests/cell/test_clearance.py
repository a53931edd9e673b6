"""Gaps between capsules and planes or boxes, against places tried one by one."""

import numpy as np
import pytest

from armui.cell.clearance import segment_box_supports
from armui.kinematics.poses import pose_to_matrix
from tests.cell.plain_gaps import Capsules, box_gaps, plane_gaps

HALF = np.array((30.0, 50.0, 20.0))


def signed_mm(places, half):
    """The distance of places from a box about the origin; inside, minus the depth."""
    beyond = np.abs(places) - half
    outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=-1)
    return outside + np.minimum(beyond.max(axis=-1), 0.0)


def one(start, end, radius):
    begin, last = (np.array(each, dtype=float).reshape(1, 1, 3) for each in (start, end))
    return Capsules(("hand",), begin, last, np.array([radius]))


@pytest.mark.parametrize("reach_mm", [40.0, 120.0, 400.0])
def test_the_nearest_place_of_a_line_is_found(reach_mm):
    random = np.random.default_rng(int(reach_mm))
    begin = random.uniform(-reach_mm, reach_mm, (4000, 3))
    along = random.uniform(-reach_mm, reach_mm, (4000, 3))
    along[:200, 0] = 0.0
    along[200:400] = 0.0
    found = segment_box_supports(begin, along, HALF)[:, 0]
    shares = np.linspace(0.0, 1.0, 1001)[:, None]
    tried = np.array(
        [signed_mm(a + shares * b, HALF).min() for a, b in zip(begin, along, strict=True)]
    )
    assert (found <= tried + 1e-9).all()
    assert (found >= tried - np.linalg.norm(along, axis=1) / 2000.0 - 1e-9).all()


@pytest.mark.parametrize(
    ("start", "end", "gap"),
    [
        ((50.0, 0.0, 0.0), (90.0, 0.0, 0.0), 15.0),  # in front of a side
        ((33.0, 54.0, -5.0), (33.0, 54.0, 5.0), 0.0),  # beside an edge: 3 and 4 make 5
        ((-100.0, 0.0, 0.0), (100.0, 0.0, 0.0), -25.0),  # through: 20 deep, by Z
        ((0.0, 45.0, 0.0), (0.0, 60.0, 0.0), -10.0),  # its end 5 deep
        ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), -25.0),  # a ball
    ],
)
def test_a_gap_is_told_from_the_surface(start, end, gap):
    gaps = box_gaps(one(start, end, 5.0), np.eye(4)[None], 2.0 * HALF[None])
    assert gaps.shape == (1, 1, 1)
    assert gaps[0, 0, 0] == pytest.approx(gap)


def test_a_box_may_stand_anyhow():
    frame = pose_to_matrix((200.0, -50.0, 120.0, 20.0, -35.0, 70.0))
    inside = np.array(((50.0, 0.0, 0.0, 1.0), (90.0, 0.0, 0.0, 1.0))) @ frame.T
    gaps = box_gaps(one(inside[0, :3], inside[1, :3], 5.0), frame[None], 2.0 * HALF[None])
    assert gaps[0, 0, 0] == pytest.approx(15.0)


def test_planes_have_a_free_side():
    frames = pose_to_matrix(np.array(((0, 0, 10.0, 0, 0, 0), (0, 0, 10.0, 180.0, 0, 0))))
    gaps = plane_gaps(one((0, 0, 30.0), (0, 0, 60.0), 5.0), frames)
    assert gaps[0, 0] == pytest.approx((15.0, -55.0))
