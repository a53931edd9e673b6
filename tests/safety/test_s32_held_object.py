"""S32: what the hand holds stays out of the work area as the arm does, until it is let go of."""

from dataclasses import replace

import numpy as np
import pytest

from armui.cell.area_check import AREA_IN_THE_WAY
from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.work_area import AreaBox
from armui.control.cell.cell_reasons import (
    CELL_HOLDING_NOT_CONFIRMED,
    CELL_WHILE_MOVING,
    HELD_IN_HAND,
)
from armui.control.operating_state import JOG_UNDER_WAY, RUN_UNDER_WAY
from armui.control.parameters.arm_model import arm_model
from armui.control.safety.recovery_steps import StepKind
from armui.kinematics.forward import flange_transforms
from armui.kinematics.poses import pose_to_matrix
from armui.trajectory.planning.check import AREA_TOO_NEAR, CheckRequest, check
from armui.ways.rules import TOO_LOW
from tests.accepted import accepted
from tests.cell.areas import area_of, wall
from tests.control.jogger import BENT_DEG, bend, hold
from tests.control.under_way import run_paused
from tests.family import PIPER
from tests.safety.test_s15_the_cell_is_confirmed import again
from tests.safety.test_s32_work_area import LOSSES, OUTWARDS, wall_before
from tests.trajectory.arms import joint, run

BAR = HeldObject("bar", (0.0, 0.0, 180.0, 0.0, 0.0, 0.0), (60.0, 60.0, 240.0))
"""It reaches 300 mm beyond the flange, 160 mm further than the gripper."""
HULL_MM = 11.1
"""How much wider than the bar what stands for it against boxes may be."""


def corners(joints_deg, held=BAR):
    """The corners of what is held, in the base."""
    flange = flange_transforms(PIPER, np.array(joints_deg)) @ pose_to_matrix(held.pose)
    x, y, z = (size / 2.0 for size in held.size_mm)
    places = [(a * x, b * y, c * z, 1.0) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
    return [(flange @ np.array(place))[:3] for place in places]


def furthest_mm(joints_deg):
    return max(corner[0] for corner in corners(joints_deg))


def lowest_mm(joints_deg):
    return min(corner[2] for corner in corners(joints_deg))


def table_below(joints_deg, by_mm):
    """A table in front of the arm, so far below what is held."""
    middle = (600.0, 0.0, lowest_mm(joints_deg) - by_mm - 50.0, 0.0, 0.0, 0.0)
    return AreaBox("table", middle, (800.0, 1200.0, 100.0))


def holding(rig, *zones, held="bar"):
    """Put a cell in force whose hand holds a bar."""
    cell = Cell("bench", area=area_of(*zones), held_objects=(BAR,), held=held)
    accepted(rig.controller.cell.take(cell))


def drive(rig, gap_mm, seconds=6.0):
    """Go on with a jog until it ends; return the least gap on its way."""
    nearest = gap_mm(rig.firmware.joints_deg)
    for _ in range(round(seconds / 0.02)):
        hold(rig, 0.02)
        nearest = min(nearest, gap_mm(rig.firmware.joints_deg))
        if not rig.controller.jogging.active:
            break
    for _ in range(10):
        hold(rig, 0.02)
        nearest = min(nearest, gap_mm(rig.firmware.joints_deg))
    return nearest


@pytest.mark.parametrize("name", ["tool", "joint"])
def test_a_jog_at_full_speed_ends_before_the_object_is_at_a_plane(rig, name):
    bend(rig)
    furthest, lowest = furthest_mm(BENT_DEG) + 40.0, lowest_mm(BENT_DEG) - 40.0
    outwards = name == "tool"
    holding(rig, wall(furthest) if outwards else table_below(BENT_DEG, 40.0))
    accepted(rig.controller.jogging.start(OUTWARDS[name]))
    gap_mm = (
        (lambda at: furthest - furthest_mm(at)) if outwards else (lambda at: lowest_mm(at) - lowest)
    )
    assert 9.0 <= drive(rig, gap_mm) < 13.0 + (0.0 if outwards else HULL_MM)
    (ended,) = [each for each in rig.events if each.code == "jog_ended"]
    assert ended.params["reason"].reason == AREA_IN_THE_WAY
    assert ended.params["reason"].params["part"] == "held object"


@pytest.mark.parametrize("loss", LOSSES, ids=lambda loss: loss.__name__)
def test_whatever_is_lost_before_a_plane_the_object_stays_out(rig, loss):
    bend(rig)
    place = furthest_mm(BENT_DEG) + 25.0
    holding(rig, wall(place))
    accepted(rig.controller.jogging.start(OUTWARDS["tool"]))
    while furthest_mm(rig.firmware.joints_deg) < place - 13.0:
        hold(rig, 0.01)
    loss(rig)
    furthest = 0.0
    for _ in range(50):
        rig.time_s += 0.02
        rig.node.poll(0.02)
        furthest = max(furthest, furthest_mm(rig.firmware.joints_deg))
    assert furthest <= place - 9.0


def test_single_motions_runs_and_the_floor_count_it(rig):
    bend(rig)
    holding(rig, table_below(BENT_DEG, 25.0))
    controller = rig.controller
    across = (BENT_DEG[0], BENT_DEG[1] + 10.0, *BENT_DEG[2:])
    rig.heard()
    assert controller.motion.send_joints(across).reason == AREA_IN_THE_WAY
    assert rig.heard() == []
    outcome = check(
        CheckRequest(
            run(joint(*across)), arm_model(controller), BENT_DEG, area=controller.area_guard.check()
        )
    )
    parts = {each.params.get("part") for each in outcome.errors if each.kind == AREA_TOO_NEAR}
    assert parts == {"held object"}
    lowest = lowest_mm(BENT_DEG)
    assert controller.jog_floor.height_mm(BENT_DEG) == pytest.approx(lowest, abs=1e-6)
    controller.jog_floor.lowest_mm = round(lowest) + 50
    assert controller.motion.jog(2, 5.0).reason in {TOO_LOW, AREA_IN_THE_WAY}
    accepted(controller.cell.hold(""))
    assert controller.jog_floor.height_mm(BENT_DEG) > lowest + 50.0
    controller.jog_floor.lowest_mm = None
    accepted(controller.motion.send_joints(across))


def test_another_host_that_brings_it_in_is_told_and_stopped(rig, other_host):
    bend(rig)
    holding(rig, table_below(BENT_DEG, 20.0))
    cell = rig.controller.cell.cell
    accepted(rig.controller.cell.change(replace(cell, area=replace(cell.area, stops_others=True))))
    beyond = (BENT_DEG[0], BENT_DEG[1] + 30.0, *BENT_DEG[2:])
    other_host.move_to(beyond, 30)
    rig.run_until(lambda: "area_entered" in rig.codes())
    (entered,) = [each for each in rig.events if each.code == "area_entered"]
    assert (entered.params["part"], entered.params["name"]) == ("held object", "table")
    rig.run(4.0)
    assert abs(rig.firmware.joints_deg[1] - beyond[1]) > 0.5


def test_it_is_asked_for_with_the_cell_and_counts_before(rig):
    bend(rig)
    holding(rig, wall_before(BENT_DEG, 20.0))
    again(rig, "bench")
    now = rig.controller.operating_state
    assert now.cannot_move.reason == CELL_HOLDING_NOT_CONFIRMED
    assert now.cannot_move.params == {"name": "bench", "held": "bar"}
    assert rig.controller.recovery.step.kind.name == "CELL_HOLDING"
    assert now.intrusion.part == "held object"
    accepted(rig.controller.cell.hold(""))
    rig.run(0.1)
    assert rig.controller.recovery.step.kind.name == "CELL_UNCONFIRMED"
    assert rig.controller.operating_state.intrusion is None


def test_an_arm_that_was_silent_is_asked_what_it_holds(rig):
    bend(rig)
    holding(rig)
    rig.powered = False
    rig.run(1.0)
    rig.powered = True
    rig.run_until(lambda: rig.controller.recovery.step.kind is StepKind.CELL_HOLDING)
    assert rig.controller.cell.cell.held == "bar"
    assert rig.controller.recovery.act(rig.controller.recovery.step) is None
    assert rig.controller.cell.in_force.held == "bar"


LEFT = {
    "take": lambda cells: cells.take(Cell("other")),
    "choose": lambda cells: cells.choose(""),
    "change": lambda cells: cells.change(replace(cells.cell, held="")),
    "delete": lambda cells: cells.delete(),
}


@pytest.mark.parametrize("way", LEFT)
def test_no_exchange_of_the_cell_loses_it(rig, way):
    bend(rig)
    holding(rig)
    refusal = LEFT[way](rig.controller.cell)
    assert (refusal.reason, refusal.params) == (HELD_IN_HAND, {"name": "bar"})
    assert rig.controller.cell.cell.held == "bar"
    accepted(rig.controller.cell.hold(""))
    accepted(LEFT[way](rig.controller.cell))


def test_another_cell_is_chosen_for_another_arm_and_the_first_keeps_it(rig):
    bend(rig)
    holding(rig)
    again(rig, "bench")
    accepted(rig.controller.cell.choose(""))
    assert rig.controller.cell.cells["bench"].held == "bar"


def test_nothing_of_it_changes_while_the_arm_moves(rig):
    bend(rig)
    holding(rig)
    accepted(rig.controller.jogging.start(OUTWARDS["tool"]))
    rig.run(0.2)
    assert rig.controller.cell.hold("").reason == JOG_UNDER_WAY
    rig.controller.jogging.stop()
    rig.run(1.0)
    accepted(rig.controller.motion.send_joints((0.0, *BENT_DEG[1:])))
    rig.run(0.3)
    assert rig.controller.cell.hold("").reason == CELL_WHILE_MOVING
    assert rig.controller.cell.cell.held == "bar"


def test_nothing_of_it_changes_while_a_run_is_paused(rig):
    bend(rig)
    holding(rig)
    run_paused(rig)
    assert rig.controller.cell.hold("").reason == RUN_UNDER_WAY


def test_a_gripper_that_opens_is_told_once_and_nothing_is_let_go(rig):
    bend(rig)
    accepted(rig.controller.gripper.move(20.0, 1.0))
    rig.run(3.0)
    holding(rig)
    rig.run(0.2)
    assert "held_opened" not in rig.codes()
    accepted(rig.controller.gripper.move(45.0, 1.0))
    rig.run(3.0)
    (told,) = [each for each in rig.events if each.code == "held_opened"]
    assert told.params["name"] == "bar"
    assert 25 < told.params["value"] <= 45
    assert rig.controller.cell.cell.held == "bar"
