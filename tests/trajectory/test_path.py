"""A planned path asked where it is, and drawn with fewer samples."""

import numpy as np
import pytest

from armui.trajectory.planning.planned_path import PlannedPath


def path(rows):
    count = len(rows)
    return PlannedPath(
        times_s=np.linspace(0.0, 1.0, count),
        joints_deg=np.outer(np.arange(count), np.ones(6)),
        places_mm=np.zeros((count, 3)),
        speeds_mm_s=np.zeros(count),
        rows=np.array(rows),
        cycles=np.ones(count, dtype=np.int64),
    )


def test_the_end_of_each_row():
    assert path([0, 0, 1, 3, 3, 3]).ends() == {0: 1, 1: 2, 3: 5}


@pytest.mark.parametrize("most", [10, 100, 10_000])
def test_an_outline_keeps_the_end_of_every_row(most):
    rows = np.repeat(np.arange(40), 25)
    outline = path(rows).outline(most)
    assert set(range(24, 1000, 25)) <= set(outline.tolist())
    assert outline[0] == 0
    assert len(outline) <= min(1000, most + most // 2 + 41)
    assert (np.diff(outline) > 0).all()


def test_a_short_path_is_drawn_whole():
    assert path([0] * 30).outline(1000).tolist() == list(range(30))
