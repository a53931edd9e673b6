"""The turntable camera."""

from dataclasses import replace

import numpy as np
import pytest

from armui.viewport.camera import HOME_CAMERA, VIEW_ANGLE_DEG, OrbitCamera, ViewDirection

FRONT = OrbitCamera(focus_m=(0.0, 0.0, 0.0), distance_m=2.0, azimuth_deg=0.0, elevation_deg=0.0)


def test_the_eye_is_where_azimuth_elevation_and_distance_say():
    assert FRONT.eye_m == pytest.approx((2.0, 0.0, 0.0))
    left = OrbitCamera((1.0, 2.0, 3.0), 2.0, azimuth_deg=90.0, elevation_deg=30.0)
    assert left.eye_m == pytest.approx((1.0, 2.0 + 3.0**0.5, 4.0))


def test_a_drag_to_the_right_carries_the_eye_to_the_left():
    assert FRONT.orbit(10.0, 0.0).eye_m[1] < 0.0
    assert FRONT.orbit(0.0, 10.0).eye_m[2] > 0.0


def test_the_eye_never_passes_over_the_pole():
    assert FRONT.orbit(0.0, 1e6).elevation_deg == 89.0
    below = FRONT.turned_to(ViewDirection.BELOW)
    assert below.orbit(0.0, -1e6).elevation_deg == -89.0


@pytest.mark.parametrize("direction", [each for each in ViewDirection if each.value != "below"])
def test_the_hand_never_brings_the_eye_below_the_floor(direction):
    rng = np.random.default_rng(5)
    camera = replace(HOME_CAMERA, focus_m=(0.0, 0.0, 0.1)).turned_to(direction)
    lowest = []
    for _ in range(400):
        dx, dy = rng.uniform(-400.0, 400.0, 2)
        camera = (
            camera.orbit(dx, dy),
            camera.pan(dx, dy - 100.0, 500.0),
            camera.zoom(dy / 100.0),
        )[rng.integers(3)]
        lowest.append(camera.eye_m[2])
        assert camera.elevation_deg >= 0.0
    assert min(lowest) == pytest.approx(0.0, abs=1e-9)  # it has been tried
    assert max(lowest) > 0.5


def test_the_view_from_below_is_turned_about_and_left_by_hand():
    below = HOME_CAMERA.turned_to(ViewDirection.BELOW)
    assert below.eye_m[2] < 0.0
    turned = below.orbit(50.0, 100.0)
    assert turned.elevation_deg == -50.0
    assert turned.focus_m == below.focus_m
    up = turned.orbit(0.0, 200.0)
    assert up.elevation_deg == 30.0
    assert up.orbit(0.0, -1e6).elevation_deg == 0.0


def test_what_is_under_the_pointer_stays_there_when_the_view_moves():
    height_px = 700.0
    moved = FRONT.pan(0.0, height_px, height_px)
    # The whole height of the view at the focus: 2 · 2 m · tan(15°)
    visible_m = 4.0 * np.tan(np.radians(VIEW_ANGLE_DEG / 2.0))
    assert moved.focus_m == pytest.approx((0.0, 0.0, visible_m))
    assert FRONT.pan(70.0, 0.0, height_px).focus_m == pytest.approx((0.0, -visible_m / 10.0, 0.0))


def test_zoom_has_two_ends_and_goes_back():
    assert FRONT.zoom(3.0).distance_m < FRONT.distance_m
    assert FRONT.zoom(3.0).zoom(-3.0).distance_m == pytest.approx(FRONT.distance_m)
    assert FRONT.zoom(1000.0).distance_m == 0.15
    assert FRONT.zoom(-1000.0).distance_m == 8.0


def test_the_first_view_looks_down_on_the_arm():
    assert HOME_CAMERA.eye_m[2] > HOME_CAMERA.focus_m[2] > 0.0
