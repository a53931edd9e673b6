"""S32: inside one zone's margin every other zone counts as before.

An arm that is parked near the table is still told, and stopped, when somebody swings it into
another zone; so is one that comes in again. Another host's and a hand's motions are judged: ours
never come in (see `test_s32_work_area.py`).
"""

from dataclasses import replace

import pytest

from armui.cell.work_area import AreaBox
from armui.protocol.codes import TeachingState
from tests.accepted import accepted
from tests.cell.areas import TABLE, gap_mm, put, wall
from tests.control.jogger import BENT_DEG, bend
from tests.safety.inline_rig import inline_rig
from tests.safety.mesh_oracle import MeshOracle
from tests.safety.watched_arm import watch

PARKED_MM = 2.0
"""So far is the parked arm from the table, within the margin of 10."""
BEFORE_MM = 25.0
SWUNG_DEG = (BENT_DEG[0], BENT_DEG[1] + 22.0, BENT_DEG[2] - 22.0, *BENT_DEG[3:])
"""Where another host swings it: more than 100 mm further out."""


@pytest.fixture
def rig(qapp, request):
    with inline_rig(request.node.nodeid) as rig:
        yield rig


def person(by_mm=BEFORE_MM):
    """A wall so far before the bent arm."""
    place = -gap_mm(BENT_DEG, wall(0.0)) + by_mm
    return replace(wall(place), name="person")


def under():
    """What the shoulder is parked at, which no swing takes away from it."""
    return replace(TABLE, pose=(0.0, 0.0, gap_mm(BENT_DEG, TABLE) - PARKED_MM, 0.0, 0.0, 0.0))


def beside():
    """A box beside the shoulder, which no swing takes away from it either."""
    box = AreaBox("table", (0.0, -200.0, 123.0, 0.0, 0.0, 0.0), (60.0, 60.0, 60.0))
    off = gap_mm(BENT_DEG, box)
    return replace(box, pose=(0.0, -200.0 + off - PARKED_MM, 123.0, 0.0, 0.0, 0.0))


PARKINGS = {"a plane under it": under, "a box beside it": beside}


def guarded(rig, *zones, stops=True):
    """Put zones up that stop others, around a bent arm."""
    bend(rig)
    put(rig.controller, *zones)
    cell = rig.controller.cell.cell
    accepted(rig.controller.cell.change(replace(cell, area=replace(cell.area, stops_others=stops))))
    rig.run(0.2)


def entered(rig):
    """The zones that were told to be entered, or to stand around the arm, in order."""
    told = {"area_entered", "area_around"}
    return [each.params["name"] for each in rig.events if each.code in told]


def reached(rig, target_deg):
    return max(abs(a - b) for a, b in zip(rig.firmware.joints_deg, target_deg, strict=True)) < 0.2


@pytest.mark.parametrize("parking", PARKINGS)
def test_the_parked_arm_stays_as_near_to_its_parking_all_the_way(parking):
    """What the scenes rely on: it is inside that margin when it comes to the other zone."""
    zone = PARKINGS[parking]()
    assert gap_mm(BENT_DEG, zone) == pytest.approx(PARKED_MM, abs=0.2)
    assert gap_mm(SWUNG_DEG, zone) == pytest.approx(PARKED_MM, abs=0.2)


@pytest.mark.each_value(full="both ways of parking with and without a stop")
@pytest.mark.parametrize("stops", [False, True], ids=["told", "stopped"])
@pytest.mark.parametrize("parking", PARKINGS)
def test_another_host_is_told_and_stopped_at_another_zone(rig, other_host, parking, stops):
    guarded(rig, PARKINGS[parking](), person(), stops=stops)
    assert entered(rig) == ["table"]
    seen = MeshOracle(person())
    other_host.move_to(SWUNG_DEG, 20)
    rig.run_until(lambda: "person" in entered(rig), seconds=4.0)
    (came,) = [each for each in rig.events if each.params.get("name") == "person"]
    assert came.code == "area_entered"
    assert seen.nearest(rig.firmware.true_joints_deg).mm > 0.0
    assert gap_mm(rig.firmware.joints_deg, person()) > PARKED_MM  # while the parking is nearer
    rig.run(4.0)
    assert reached(rig, SWUNG_DEG) is not stops


def test_the_deepest_of_two_zones_does_not_hide_the_other(rig, other_host):
    """Parked 20 mm inside the one: the other counts from its own margin on."""
    deep = under()
    deep = replace(deep, pose=(0.0, 0.0, deep.pose[2] + 25.0, 0.0, 0.0, 0.0))
    guarded(rig, deep, person())
    other_host.move_to(SWUNG_DEG, 20)
    rig.run_until(lambda: "person" in entered(rig), seconds=4.0)
    rig.run(4.0)
    assert not reached(rig, SWUNG_DEG)


def test_two_zones_at_once_are_both_told(rig, other_host):
    guarded(rig, person(), replace(person(), name="second person"))
    other_host.move_to(SWUNG_DEG, 20)
    rig.run(4.0)
    assert sorted(entered(rig)) == ["person", "second person"]


def test_a_second_zone_behind_the_first_is_told_as_well(rig, other_host):
    """Nobody is stopped: one after the other is entered."""
    guarded(rig, person(), replace(person(BEFORE_MM + 30.0), name="second person"), stops=False)
    other_host.move_to(SWUNG_DEG, 20)
    rig.run(5.0)
    assert entered(rig) == ["person", "second person"]


def test_what_is_entered_again_is_told_and_stopped_again(rig, other_host):
    guarded(rig, person())
    for time in (1, 2):
        other_host.move_to(SWUNG_DEG, 20)
        rig.run(4.0)
        assert not reached(rig, SWUNG_DEG)
        assert entered(rig) == ["person"] * time
        other_host.move_to(BENT_DEG, 20)
        rig.run(4.0)
        assert reached(rig, BENT_DEG)
    assert rig.codes().count("area_left") == 2


def test_what_is_entered_again_from_a_parking_is_told_again(rig, other_host):
    guarded(rig, under(), person())
    for time in (1, 2):
        other_host.move_to(SWUNG_DEG, 20)
        rig.run(4.0)
        assert not reached(rig, SWUNG_DEG)
        assert entered(rig).count("person") == time
        other_host.move_to(BENT_DEG, 20)
        rig.run(4.0)


def test_a_host_that_goes_on_after_the_halt_is_halted_again(rig, other_host):
    """It was stopped once, and sends it further in from there: the edge is behind it."""
    guarded(rig, person())
    seen = watch(rig)
    for _ in range(3):
        other_host.move_to(SWUNG_DEG, 20)
        rig.run(1.5)
    assert not reached(rig, SWUNG_DEG)
    assert seen.least.mm > -30.0


@pytest.mark.parametrize("parking", [True, False])
def test_a_hand_is_told_at_each_zone(rig, parking):
    guarded(rig, *([under()] if parking else []), person(), stops=False)
    accepted(rig.controller.teaching.command(TeachingState.START_RECORDING))
    rig.run(0.5)
    rig.firmware.hand_guiding.lead_to(SWUNG_DEG)
    rig.run_until(lambda: "person" in entered(rig), seconds=4.0)
    rig.firmware.hand_guiding.lead_to(BENT_DEG)
    rig.run(2.0)
    rig.firmware.hand_guiding.lead_to(SWUNG_DEG)
    rig.run_until(lambda: entered(rig).count("person") == 2, seconds=4.0)


def test_each_zone_is_shown_as_long_as_the_arm_is_in_it(rig, other_host):
    guarded(rig, person(), stops=False)
    other_host.move_to(SWUNG_DEG, 20)
    rig.run_until(lambda: "person" in entered(rig))
    rig.run(3.0)
    assert rig.controller.operating_state.intrusion.name == "person"
    other_host.move_to(BENT_DEG, 20)
    rig.run_until(lambda: rig.controller.operating_state.intrusion is None, seconds=8.0)


def test_an_area_put_around_a_standing_arm_is_not_told_as_entered(rig, other_host):
    guarded(rig, PARKINGS["a plane under it"](), stops=False)
    codes = [each.code for each in rig.events if each.code.startswith("area_")]

    assert codes == ["area_around"]
