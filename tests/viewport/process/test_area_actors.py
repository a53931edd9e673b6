"""The work area and what is held in the picture: where they stand, in metres."""

import pytest

from armui.viewport.area_picture import AreaShape
from armui.viewport.process.area_actors import _surface
from armui.viewport.robot_shape import pose_rows

PLACE = pose_rows((500.0, -200.0, 100.0, 0.0, 0.0, 90.0))


def test_a_box_stands_where_its_figures_say():
    bounds = _surface(AreaShape(PLACE, (100.0, 200.0, 60.0))).bounds
    assert tuple(bounds) == pytest.approx((0.4, 0.6, -0.25, -0.15, 0.07, 0.13))


def test_a_rod_is_as_long_and_thick_as_its_figures_say():
    rod = AreaShape(PLACE, (20.0, 30.0, 160.0), held=True, is_rod=True)
    assert tuple(_surface(rod).bounds) == pytest.approx(
        (0.485, 0.515, -0.215, -0.185, 0.02, 0.18), abs=1e-3
    )
