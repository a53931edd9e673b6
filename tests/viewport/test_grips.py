"""Handles: where they are, and how far the pointer carries them. No arm, no picture."""

import math

import numpy as np
import pytest

from armui.viewport.camera import HOME_CAMERA, OrbitCamera, ViewDirection
from armui.viewport.grips import GripDrag, GripKind, grip_at, snapped, tool_grips
from armui.viewport.palette import LIGHT
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
