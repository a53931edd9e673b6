"""Where the tool has been, collected place by place."""

import numpy as np
import pytest

from armui.viewport.tool_trail import ToolTrail


def line(packed):
    return np.frombuffer(packed, np.float32).reshape(-1, 3)


def drive(trail, count, start_s=0.0, step_mm=2.0, first=0, commanded=None):
    for step in range(first, first + count):
        place = (step * step_mm, 0.0, 0.0)
        trail.add(start_s + step * 0.1, place, None if commanded is None else commanded(step))


def test_places_stand_in_the_order_they_were_driven():
    trail = ToolTrail(10.0)
    drive(trail, 5)
    assert line(trail.trail.driven)[:, 0].tolist() == [0.0, 2.0, 4.0, 6.0, 8.0]
    assert trail.trail.commanded == b""


def test_one_place_is_no_trail_and_zero_seconds_are_none():
    trail = ToolTrail(10.0)
    drive(trail, 1)
    assert trail.trail is None
    off = ToolTrail(0.0)
    drive(off, 5)
    assert off.trail is None


def test_only_the_last_seconds_of_motion_are_kept():
    trail = ToolTrail(1.0)
    drive(trail, 50)
    assert line(trail.trail.driven)[:, 0].tolist() == [step * 2.0 for step in range(39, 50)]
    assert trail.set_length(0.5)
    assert len(line(trail.trail.driven)) == 6


def test_rest_takes_nothing_from_the_trail():
    trail = ToolTrail(1.0)
    drive(trail, 5)
    before = trail.trail
    for second in range(1, 600):
        assert not trail.add(0.5 + second * 0.2, (8.1, 0.0, 0.0), None)
    assert trail.trail == before
    drive(trail, 3, start_s=200.0, first=5)
    assert len(line(trail.trail.driven)) == 8


def test_an_arm_that_was_out_of_sight_begins_a_new_trail():
    trail = ToolTrail(10.0)
    drive(trail, 5)
    trail.add(9.0, (300.0, 0.0, 0.0), None)
    assert trail.trail is None


def test_setpoints_that_follow_one_another_are_a_line_and_a_target_is_none():
    trail = ToolTrail(10.0)
    drive(trail, 5, commanded=lambda step: (step * 2.0 + 1.0, 0.0, 5.0))
    assert line(trail.trail.commanded)[:, 2].tolist() == [5.0] * 5
    trail.add(0.6, (10.0, 0.0, 0.0), (400.0, 0.0, 5.0))
    assert len(line(trail.trail.commanded)) == 1


def test_however_long_it_goes_on_it_stays_small():
    trail = ToolTrail(600.0)
    drive(trail, 5000)
    assert len(trail.trail.driven) + len(trail.trail.commanded) < 30_000
    assert line(trail.trail.driven)[-1, 0] == pytest.approx(4999 * 2.0)
