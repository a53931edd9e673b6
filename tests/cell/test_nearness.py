"""Supports of planes and boxes, and capsules moved by joints: what a way is judged by."""

import numpy as np
import pytest

from armui.arm.models import model_data
from armui.cell.enclosure import body_of
from armui.cell.moved_capsules import MovedCapsules
from armui.cell.nearness import Obstacles
from armui.cell.work_area import AreaBox, AreaPlane
from armui.kinematics.forward import link_frames
from armui.kinematics.poses import pose_to_matrix
from armui.protocol.generation import PiperModel
from tests.cell.plain_gaps import enclose

PLANE = AreaPlane("plane", (10.0, 20.0, 30.0, 25.0, -70.0, 40.0))
BOX = AreaBox("box", (50.0, -30.0, 90.0, 30.0, 50.0, -20.0), (60.0, 100.0, 40.0))


def signed_mm(places):
    """(2, c) the distances of places from the plane and from the box; inside, minus the depth."""
    plane = pose_to_matrix(PLANE.pose)
    box = pose_to_matrix(BOX.pose)
    beyond = np.abs((places - box[:3, 3]) @ box[:3, :3]) - np.array(BOX.size_mm) / 2.0
    outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
    return np.stack(
        ((places - plane[:3, 3]) @ plane[:3, 2], outside + np.minimum(beyond.max(axis=1), 0.0))
    )


@pytest.mark.parametrize("reach_mm", [40.0, 150.0, 600.0])
def test_a_support_is_never_above_the_distance_and_as_high_at_the_line(reach_mm):
    random = np.random.default_rng(int(reach_mm))
    obstacles = Obstacles((PLANE,), (BOX,))
    ends = np.array(BOX.pose[:3]) + random.uniform(-reach_mm, reach_mm, (2000, 2, 3))
    which = random.integers(0, 2, 2000)
    found = obstacles.supports(ends, which)
    places = random.uniform(-400.0, 400.0, (2000, 3))
    heights = np.einsum("mi,mi->m", found[:, 1:4], places) - found[:, 4]
    assert (heights <= signed_mm(places)[which, np.arange(2000)] + 1e-9).all()
    at_ends = np.einsum("mi,mei->me", found[:, 1:4], ends) - found[:, 4:]
    assert at_ends.min(axis=1) == pytest.approx(found[:, 0], abs=1e-9)
    shares = np.linspace(0.0, 1.0, 201)[:, None]
    for line, each, zone in zip(ends[:200], found, which, strict=False):
        tried = signed_mm(line[0] + shares * (line[1] - line[0]))[zone].min()
        assert tried - np.linalg.norm(line[1] - line[0]) / 400.0 <= each[0] <= tried + 1e-9


def test_what_faces_a_place_supports_the_obstacle():
    random = np.random.default_rng(2)
    obstacles = Obstacles((PLANE,), (BOX,))
    places = np.vstack((random.uniform(-300.0, 300.0, (300, 3)), [BOX.pose[:3]]))
    directions, heights = obstacles.facing(places)
    others = random.uniform(-300.0, 300.0, (500, 3))
    found = directions @ others.T - heights[..., None]
    assert (found <= signed_mm(others)[:, None] + 1e-9).all()
    here = np.einsum("zci,ci->zc", directions, places) - heights
    outside = signed_mm(places) > 0.0
    assert here[outside] == pytest.approx(signed_mm(places)[outside])
    # from inside nothing is known
    assert here[1, -1] < -1e6
    assert obstacles.distances(places) == pytest.approx(signed_mm(places))


@pytest.mark.parametrize("model", PiperModel)
def test_capsules_are_where_the_links_are(model):
    poses = np.random.default_rng(3).uniform(-150.0, 150.0, (20, 6))
    body = body_of(model, model_data(model).geometry, 70.0)
    moved = MovedCapsules(body.geometry, body.capsules)
    placed, expected = moved.all_ends(moved.frames(poses)), enclose(body, poses)
    assert placed[:, :, 0] == pytest.approx(expected.starts)
    assert placed[:, :, 1] == pytest.approx(expected.ends)


@pytest.mark.each_value(full="each model on each base")
@pytest.mark.parametrize("model", PiperModel)
@pytest.mark.parametrize("base", [0, 2, 3])
def test_seen_from_a_link_capsules_are_moved_by_what_is_between(model, base):
    random = np.random.default_rng(4)
    poses = random.uniform(-150.0, 150.0, (30, 6))
    body = body_of(model, model_data(model).geometry, 70.0)
    capsules = [each for each in body.capsules if each.link > base]
    moved = MovedCapsules(body.geometry, capsules, [base] * len(capsules))
    which = np.arange(len(capsules))
    for pose in poses:
        frames = moved.frames(pose[None])
        ends = moved.ends(frames, np.zeros_like(which), which)
        world = link_frames(body.geometry, pose[None])[0]
        for each, found in zip(capsules, ends, strict=True):
            local = np.array((each.start_mm, each.end_mm)) @ world[each.link, :3, :3].T
            placed = local + world[each.link, :3, 3] - world[base, :3, 3]
            assert found == pytest.approx(placed @ world[base, :3, :3])
        # a small turn of each joint moves each end by what is told, and no more than its reach
        directions = random.normal(size=(len(which), 3))
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        rises = moved.rises(frames, np.zeros_like(which), which, ends, directions)
        for joint in range(6):
            turned = pose + 1e-4 * np.eye(6)[joint]
            there = moved.ends(moved.frames(turned[None]), np.zeros_like(which), which)
            speeds = (there - ends) / np.radians(1e-4)
            along = np.einsum("mei,mi->me", speeds, directions)
            assert along == pytest.approx(rises[:, :, joint], abs=0.01)
            assert (np.linalg.norm(speeds, axis=2) <= moved.reaches_mm[:, :, joint] + 0.01).all()
            assert not speeds[~moved.moves[:, joint]].any()
