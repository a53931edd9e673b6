"""S32: «from here on it holds X», as a point says it, counts in the check and once it is there."""

from dataclasses import replace

import pytest

from armui.control.parameters.arm_model import arm_model, start_deg
from armui.control.run.preflight import CHANGED_SINCE_CHECK, CheckBasis, Preflight, carried_by
from armui.control.run.progress import RunPhase
from armui.control.run.runner import Runner
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.check import AREA_TOO_NEAR, HELD_UNKNOWN, CheckRequest, check
from armui.trajectory.points.program import Trajectory
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, bend
from tests.safety.test_s32_held_object import holding, table_below
from tests.trajectory.arms import joint

ACROSS = (BENT_DEG[0], BENT_DEG[1] + 10.0, *BENT_DEG[2:])
HERE, LOW = joint(*BENT_DEG), joint(*ACROSS)
OPTIONS = RunOptions()


def checked(rig, *points, cycles=1):
    """What 检查 finds from where the arm stands."""
    content = Trajectory("t", points=points)
    order = CheckRequest(
        *(content, arm_model(rig.controller), start_deg(rig.controller)),
        cycles=cycles,
        area=rig.controller.area_guard.check(),
        carried=carried_by(rig.controller, content),
    )
    return Preflight(order, check(order), CheckBasis.of(rig.controller, OPTIONS, content))


def too_near(rig, *points, cycles=1):
    """The rows, and the cycles, at which what is held comes too near."""
    found = checked(rig, *points, cycles=cycles).outcome.errors
    assert {each.kind for each in found} <= {AREA_TOO_NEAR}
    assert {each.params["part"] for each in found} <= {"held object"}
    return sorted((each.row, each.cycle) for each in found)


@pytest.fixture
def table(rig):
    """A table that the bar would come too near to, and the gripper would not."""
    bend(rig)
    holding(rig, table_below(BENT_DEG, 25.0), held="")
    return rig


def holds(point, name):
    return replace(point, holds=name)


def test_what_is_held_counts_from_its_point_on(table):
    assert too_near(table, HERE, LOW) == []
    assert too_near(table, holds(HERE, "bar"), LOW) == [(1, 1)]
    assert too_near(table, holds(HERE, "bar"), holds(HERE, ""), LOW) == []


def test_where_it_changes_both_count(table):
    assert too_near(table, HERE, holds(LOW, "bar")) == [(1, 1)]
    assert too_near(table, HERE, holds(LOW, ""), LOW) == []
    accepted(table.controller.cell.hold("bar"))
    assert too_near(table, HERE, holds(LOW, "")) == [(1, 1)]
    assert too_near(table, holds(HERE, ""), LOW) == []


def test_further_cycles_begin_with_what_the_last_one_ends_with(table):
    points = (LOW, HERE, holds(HERE, "bar"))
    assert too_near(table, *points) == []
    assert [row for row, _ in too_near(table, *points, cycles=2)] == [0]
    assert [row for row, _ in too_near(table, *points, cycles=0)] == [0]


def test_what_the_cell_has_not_is_said_before_anything_moves(table):
    found = checked(table, HERE, holds(LOW, "cube")).findings
    assert [(each.kind, each.row, each.params) for each in found] == [
        (HELD_UNKNOWN, 1, {"name": "cube"})
    ]
    accepted(table.controller.cell.choose(""))
    assert [each.code for each in checked(table, holds(HERE, "bar")).outcome.errors] == [
        "held_unknown"
    ]
    assert checked(table, holds(HERE, "")).errors == 0


def test_a_run_says_what_the_hand_holds_as_it_arrives(table):
    aside = joint(BENT_DEG[0] + 15.0, *BENT_DEG[1:])
    found = checked(table, holds(aside, "bar"), holds(HERE, ""))
    assert found.errors == 0
    assert Runner(table.controller).start(found, 30) is None
    cell = table.controller.cell
    assert cell.cell.held == ""
    table.run_until(lambda: table.controller.player.progress.index == 1)
    assert cell.cell.held == "bar"
    assert cell.held_shape is not None
    table.run_until(lambda: not table.controller.player.running)
    assert table.controller.player.progress.phase is RunPhase.DONE
    assert cell.cell.held == ""
    assert [code for code in table.codes() if code.startswith("held")] == [
        *("held_now", "held_nothing")
    ]


def test_a_run_that_is_cut_off_leaves_what_it_has_said(table):
    aside = joint(BENT_DEG[0] + 15.0, *BENT_DEG[1:])
    assert Runner(table.controller).start(checked(table, holds(aside, "bar"), HERE), 30) is None
    table.run_until(lambda: table.controller.player.progress.index == 1)
    table.controller.emergency_stop()
    table.run(0.3)
    assert table.controller.cell.cell.held == "bar"


def test_another_object_in_the_hand_outdates_a_check(table):
    found = checked(table, HERE)
    accepted(table.controller.cell.hold("bar"))
    assert found.why_outdated(table.controller, OPTIONS).reason == CHANGED_SINCE_CHECK
