"""From places to pixels and back, beside a pinhole camera worked out apart from the program's."""

import numpy as np
import pytest

from armui.viewport.camera import HOME_CAMERA, OrbitCamera, ViewDirection
from armui.viewport.projection import Projection
from tests.viewport.pinhole import HEIGHT, WIDTH, project

PLACES = [(0.0, 0.0, 0.0), (0.3, -0.2, 0.4), (0.1, 0.5, 0.05), (-0.2, 0.1, 0.7)]


def cameras():
    for direction in ViewDirection:
        camera = HOME_CAMERA.turned_to(direction)
        yield camera
        yield OrbitCamera(
            camera.focus_m, 0.9, camera.azimuth_deg, camera.elevation_deg, orthographic=True
        )


@pytest.mark.parametrize("place", PLACES)
def test_a_place_is_seen_where_a_pinhole_camera_shows_it(place):
    pixel = Projection(HOME_CAMERA, WIDTH, HEIGHT).pixel(place)
    assert pixel == pytest.approx(tuple(project(np.array([place]))[0]), abs=1e-9)


@pytest.mark.parametrize("camera", list(cameras()))
@pytest.mark.parametrize("size", [(450, 350), (300, 700)])
def test_the_ray_of_a_pixel_leads_to_what_is_seen_there(camera, size):
    projection = Projection(camera, *size)
    for place in PLACES:
        pixel = projection.pixel(place)
        assert pixel is not None
        ray = projection.ray(*pixel)
        away = np.array(place) - ray.start_m
        along = away @ np.array(ray.direction)
        assert along > 0.0
        assert ray.at(along) == pytest.approx(place, abs=1e-9)


def test_what_is_behind_the_eye_is_not_seen():
    x, y, z = (
        2.0 * eye - focus for eye, focus in zip(HOME_CAMERA.eye_m, HOME_CAMERA.focus_m, strict=True)
    )
    assert Projection(HOME_CAMERA, WIDTH, HEIGHT).pixel((x, y, z)) is None


def test_without_perspective_what_is_farther_looks_as_large():
    flat = OrbitCamera((0.0, 0.0, 0.0), 1.0, 0.0, 0.0, orthographic=True)
    projection = Projection(flat, 400, 300)
    near, far = projection.pixel((0.5, 0.1, 0.0)), projection.pixel((-0.5, 0.1, 0.0))
    assert near == pytest.approx(far)
    assert projection.pixels_a_metre((0.5, 0.0, 0.0)) == projection.pixels_a_metre((-3.0, 0.0, 0.0))


def test_the_view_from_above_has_x_to_the_right_and_y_upwards():
    projection = Projection(HOME_CAMERA.turned_to(ViewDirection.TOP), 400, 300)
    seen = [
        projection.pixel(place) for place in ((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0))
    ]
    (x0, y0), (x1, y1), (x2, y2) = (pixel for pixel in seen if pixel is not None)
    assert x1 > x0
    assert y2 < y0
    assert (y1, x2) == pytest.approx((y0, x0))
