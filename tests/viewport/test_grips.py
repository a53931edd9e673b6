"""Handles: where they are, and how far the pointer carries them. No arm, no picture."""

import math

import numpy as np
import pytest

from armui.system.paths import URDF
from armui.viewport.camera import HOME_CAMERA, OrbitCamera, ViewDirection
from armui.viewport.grips import (
    EDGE_ON,
    GripDrag,
    GripKind,
    grip_at,
    joint_grips,
    sight,
    snapped,
    tool_grips,
)
from armui.viewport.palette import LIGHT
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.projection import Projection
from armui.viewport.robot_shape import composed, pose_rows, rotation

TOOL = pose_rows((250.0, 80.0, 300.0, 0.0, -20.0, 90.0))
ORIGIN = np.array([0.25, 0.08, 0.3])
PERSPECTIVE = Projection(HOME_CAMERA, 800, 600)
FLAT = Projection(OrbitCamera(HOME_CAMERA.focus_m, 1.2, -52.0, 20.0, orthographic=True), 800, 600)


def seen(projection, place):
    """Where a place is on the screen; it is before the eye."""
    pixel = projection.pixel(tuple(place))
    assert pixel is not None
    return pixel


def grips_of(projection, frame=None):
    return {(grip.kind, grip.number): grip for grip in tool_grips(TOOL, frame, projection, LIGHT)}


@pytest.mark.parametrize("projection", [PERSPECTIVE, FLAT])
@pytest.mark.parametrize("frame", [None, TOOL])
@pytest.mark.parametrize("number", [0, 1, 2])
@pytest.mark.parametrize("gone_mm", [-60.0, 35.0, 120.0])
def test_a_pointer_on_the_axis_carries_it_as_far_as_it_went(projection, frame, number, gone_mm):
    grip = grips_of(projection, frame)[GripKind.AXIS, number]
    axis = np.array(grip.axis)
    begin = ORIGIN + 0.03 * axis
    drag = GripDrag(grip, projection, *seen(projection, begin))
    end = begin + gone_mm / 1000.0 * axis
    assert drag.amount(*seen(projection, end)) == pytest.approx(gone_mm, abs=1e-6)


@pytest.mark.parametrize("projection", [PERSPECTIVE, FLAT])
@pytest.mark.parametrize("frame", [None, TOOL])
@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_pointer_round_the_ring_turns_it_and_turns_it_more_than_once(projection, frame, number):
    grip = grips_of(projection, frame)[GripKind.RING, number]
    spoke = np.array(grip.places[0]) - ORIGIN

    def at(degrees):
        rows = np.array(rotation(grip.axis, math.radians(degrees))).reshape(3, 4)[:, :3]
        return seen(projection, ORIGIN + rows @ spoke)

    drag = GripDrag(grip, projection, *at(10.0))
    for degrees in range(20, 500, 10):
        assert drag.amount(*at(degrees)) == pytest.approx(degrees - 10.0, abs=1e-6)
    for degrees in range(490, 0, -10):
        turned = drag.amount(*at(degrees))
    assert turned == pytest.approx(0.0, abs=1e-6)


def test_a_handle_is_taken_at_its_line_and_nowhere_else():
    grips = grips_of(PERSPECTIVE)
    for name, grip in grips.items():
        share = 0.8 if grip.kind is GripKind.AXIS else 0.0
        one, other = np.array(grip.places[0]), np.array(grip.places[1])
        x, y = seen(PERSPECTIVE, one + share * (other - one))
        found = grip_at(grips.values(), PERSPECTIVE, x, y)
        assert found is not None
        if (found.kind, found.number) != name:  # two rings cross: either is at hand
            assert found.kind is GripKind.RING
    assert grip_at(grips.values(), PERSPECTIVE, 5.0, 5.0) is None


def test_handles_are_as_large_on_the_screen_however_far_the_arm_is():
    sizes = []
    for distance_m in (0.6, 1.7, 5.0):
        projection = Projection(OrbitCamera(HOME_CAMERA.focus_m, distance_m), 800, 600)
        grip = grips_of(projection)[GripKind.RING, 2]
        xs = [seen(projection, place)[0] for place in grip.places]
        sizes.append(max(xs) - min(xs))
    assert max(sizes) / min(sizes) < 1.25


def test_what_points_at_the_eye_cannot_be_dragged_along():
    above = Projection(HOME_CAMERA.turned_to(ViewDirection.TOP), 800, 600)
    grips = grips_of(above)
    assert (GripKind.AXIS, 2) not in grips
    assert {(GripKind.AXIS, 0), (GripKind.AXIS, 1), (GripKind.RING, 2)} <= set(grips)
    flat = Projection(OrbitCamera(HOME_CAMERA.focus_m, 1.0, 0.0, 0.0, orthographic=True), 800, 600)
    assert (GripKind.RING, 2) not in grips_of(flat)  # seen from its edge


def test_the_axes_are_those_of_the_frame_that_is_asked_for():
    own = grips_of(PERSPECTIVE, TOOL)[GripKind.AXIS, 0].axis
    assert own == pytest.approx((TOOL[0], TOOL[4], TOOL[8]))
    assert grips_of(PERSPECTIVE)[GripKind.AXIS, 0].axis == (1.0, 0.0, 0.0)
    assert composed(TOOL, pose_rows((0.0,) * 6)) == pytest.approx(TOOL)


def test_a_ring_is_not_torn_off_where_the_pointer_leads_to_no_place_of_its_plane():
    grip = grips_of(PERSPECTIVE)[GripKind.RING, 2]
    drag = GripDrag(grip, PERSPECTIVE, *seen(PERSPECTIVE, grip.places[0]))
    assert drag.amount(400.0, -5000.0) is None  # above the horizon


def test_snapping_goes_to_the_nearest_step():
    assert snapped(303.9, 10.0) == 300.0
    assert snapped(-7.6, 5.0) == -10.0


ARM_DEG = (0.0, 60.0, -70.0, 0.0, 35.0, 15.0)


@pytest.fixture(scope="module")
def shape():
    return shape_of(load_robot(URDF / "piper" / "piper.urdf"))


def looking(direction, *, orthographic):
    camera = OrbitCamera(HOME_CAMERA.focus_m, 1.6, orthographic=orthographic)
    return Projection(camera.turned_to(direction), 800, 600)


def arcs(shape, projection):
    return {grip.number: grip for grip in joint_grips(shape, ARM_DEG, projection, LIGHT)}


def on_the_arc(grip, place, degrees):
    """A place of an arc after the joint has turned on."""
    rows = np.array(rotation(grip.axis, math.radians(degrees))).reshape(3, 4)[:, :3]
    return np.array(grip.origin) + rows @ (np.array(place) - grip.origin)


def depth(grip, projection, place):
    """How far behind the axis a place of an arc is, in radii: −1 nearest to the eye."""
    ahead = sight(projection, grip.origin)
    return np.dot(np.array(place) - grip.origin, ahead) / math.dist(place, grip.origin)


FACING = -0.55
"""What turns no more than 56° away from the eye."""


@pytest.mark.parametrize("orthographic", [True, False])
@pytest.mark.parametrize("direction", ViewDirection)
def test_an_arc_follows_the_pointer_from_wherever_it_is_seen(shape, direction, orthographic):
    projection = looking(direction, orthographic=orthographic)
    grips = arcs(shape, projection)
    assert set(grips) == set(range(1, 7))
    followed = 0
    for grip in grips.values():
        for place in grip.places[::4]:
            drag = GripDrag(grip, projection, *seen(projection, place))
            for degrees in range(-60, 61, 5):
                there = on_the_arc(grip, place, degrees)
                ends = (depth(grip, projection, each) for each in (place, there))
                if is_edge_on(grip, projection) and max(ends) > FACING:
                    continue
                pointer = seen(projection, there)
                amount = drag.amount(*pointer)
                assert amount is not None
                carried = seen(projection, on_the_arc(grip, place, amount))
                assert math.dist(carried, pointer) < 1.0
                followed += 1
    assert followed > 200


@pytest.mark.parametrize("direction", [ViewDirection.FRONT, ViewDirection.SIDE, ViewDirection.TOP])
def test_an_arc_seen_from_its_edge_is_turned_like_a_wheel(shape, direction):
    projection = looking(direction, orthographic=True)
    edges = [grip for grip in arcs(shape, projection).values() if is_edge_on(grip, projection)]
    assert edges
    for grip in edges:
        ahead = np.array(sight(projection, grip.origin))
        along = np.cross(grip.axis, ahead)  # where the far side goes to
        middle = np.array(grip.places[len(grip.places) // 2])
        start = seen(projection, middle)
        step = np.array(seen(projection, middle + 0.01 * along / np.linalg.norm(along))) - start
        step /= np.linalg.norm(step)
        far = all(depth(grip, projection, place) > 0.0 for place in grip.places)
        drag = GripDrag(grip, projection, *start)
        pointers = [start + step * px for px in range(0, 400, 5)]
        amounts = np.array([drag.amount(*pointer) for pointer in pointers], float)
        turned = np.diff(amounts) * (1.0 if far else -1.0)
        # on and on, no place where a pixel is more than two degrees, and beyond half a turn
        assert turned.min() > 4.0
        assert turned.max() < 5 * 2.1
        assert abs(amounts[-1]) > 360.0


def is_edge_on(grip, projection):
    return abs(np.dot(grip.axis, sight(projection, grip.origin))) <= EDGE_ON
