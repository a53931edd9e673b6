"""How far each joint may swing where the arm stands: as limits, zones and its body let it."""

import pytest

from armui.cell.area_check import AREA_IN_THE_WAY
from armui.ways.rules import rules_of
from armui.ways.swings import LEAST_DEG, SWING_LIMITED, swings
from armui.ways.way import straight_way
from tests.cell.areas import check_of, wall
from tests.trajectory.arms import ARM

FREE = (0.0, 70.0, -60.0, 0.0, 20.0, 0.0)


def of(place, amplitude=20.0, *zones):
    area = check_of(*zones) if zones else None
    return {each.joint: each for each in swings(place, amplitude, rules_of(ARM, area), {})}


def reach(swing):
    return swing.below_deg, swing.above_deg


@pytest.mark.parametrize("amplitude", [10.0, 30.0])
def test_where_there_is_room_all_swing_as_far_as_asked(amplitude):
    found = of(FREE, amplitude)
    assert {reach(each) for each in found.values()} == {(amplitude, amplitude)}
    assert all(each.possible and each.shortened is None for each in found.values())


def test_a_limit_shortens_a_swing_on_its_side():
    found = of((0.0, 70.0, -60.0, 92.0, 20.0, 0.0))
    assert reach(found[4]) == (20.0, 7.5)
    assert found[4].shortened.reason == SWING_LIMITED
    assert found[4].shortened.params["maximum"] == 100.0
    assert reach(found[1]) == (20.0, 20.0)


def test_at_zero_joints_2_and_3_swing_to_one_side_alone():
    found = of((0.0,) * 6)
    assert reach(found[2])[0] == 0.0
    assert reach(found[3])[1] == 0.0
    assert found[2].possible == (found[2].above_deg >= LEAST_DEG)


def test_a_zone_shortens_the_swings_that_would_reach_it_and_none_of_them_does():
    zone = wall(430.0)
    found = of(FREE, 20.0, zone)
    assert found[2].shortened.reason == AREA_IN_THE_WAY
    assert reach(found[6]) == (20.0, 20.0)
    check = check_of(zone)
    for joint, swing in found.items():
        for turn in (-swing.below_deg, swing.above_deg):
            there = [angle + turn * (place == joint - 1) for place, angle in enumerate(FREE)]
            way = straight_way(FREE, there)
            assert min(gap for pose in way.joints_deg for gap in check.gaps(pose[None])[0]) > 0.0


def test_less_than_ten_degrees_in_all_is_none():
    found = of((0.0, 70.0, -60.0, 0.0, 20.0, 0.0), 10.0)[1]
    assert found.possible
    assert not type(found)(1, 4.0, 5.9).possible
