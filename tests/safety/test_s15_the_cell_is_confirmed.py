"""No cell takes effect before it is confirmed for this arm, and nothing moves until then."""

import pytest

from armui.cell.cell import Cell
from armui.cell.tools import NO_TOOL, Tool
from armui.control.cell.cell_reasons import CELL_NOT_CONFIRMED, CELL_NOT_READ, CELL_WHILE_MOVING
from armui.control.motion.jog_path import JointJog
from armui.control.operating_state import JOG_UNDER_WAY, RUN_UNDER_WAY
from armui.control.safety.recovery_steps import Action, StepKind
from armui.kinematics.axes import JogFrame
from armui.protocol.codes import MoveMode
from armui.protocol.frame import Frame
from tests.accepted import accepted
from tests.control.jogger import bend
from tests.control.under_way import BACK, OUT, POSE, run_of, run_paused, to

PEN = Tool("pen", (0.0, 0.0, 100.0, 0.0, 0.0, 0.0), 10.0)
BENCH = Cell("bench", (PEN,), "pen")
MOTION = {0x151, *range(0x152, 0x15A), 0x15A, 0x15B, 0x15C, 0x15D, 0x15E, 0x15F}


class Kept:
    """Which cell each adapter was last used with."""

    def __init__(self, **names):
        self.names = names

    def kept(self, _arm_key):
        return self.names.get("any", "")

    def keep(self, _arm_key, name):
        self.names["any"] = name

    def save(self, cell):
        """Nothing is written here."""

    delete = save


@pytest.fixture
def kept(rig):
    """An adapter that was last used with a cell, connected again."""
    bend(rig)
    rig.controller.cell.take_loaded({"bench": BENCH})
    return again(rig, "bench")


def again(rig, name):
    """Connect once more to an adapter that was last used with a cell."""
    rig.controller.disconnect_device()
    rig.controller.cell.store = Kept(any=name)
    rig.controller.connect_device(rig.device)
    rig.run_until(lambda: "limits_read" in rig.codes()[-3:])
    rig.run_until(lambda: None not in rig.controller.operating_state.enabled)
    rig.run(0.4)
    return rig


ASKED = {
    "motion.send": lambda arm: arm.motion.send_joints(BACK),
    "motion.home": lambda arm: arm.begin("motion.home"),
    "motion.step": lambda arm: arm.begin("motion.step", 1, 5.0),
    "tool.move": lambda arm: arm.cartesian.move(POSE, MoveMode.MOVE_P),
    "tool.step": lambda arm: arm.cartesian.step(0, 5.0, JogFrame.BASE),
    "jog.begin": lambda arm: arm.jogging.start(JointJog(1, 1)),
    "run.start": lambda arm: arm.player.start(run_of(to(OUT))),
    "gripper.move": lambda arm: arm.gripper.move(10.0, 1.0),
}


@pytest.mark.parametrize("name", ASKED)
def test_nothing_moves_before_it_is_confirmed(kept, name):
    kept.heard()
    answer = ASKED[name](kept.controller)
    assert (answer.reason, answer.params) == (CELL_NOT_CONFIRMED, {"name": "bench"})
    kept.run(0.3)
    assert [each for each in kept.heard() if each.arbitration_id in MOTION] == []
    accepted(kept.controller.cell.confirm())
    accepted(ASKED[name](kept.controller))


def test_its_tool_counts_once_it_is_confirmed(kept):
    cells = kept.controller.cell
    assert (kept.controller.cartesian.tool, cells.in_force) == (NO_TOOL, None)
    accepted(cells.confirm())
    assert (kept.controller.cartesian.tool, cells.in_force) == (PEN.pose, BENCH)
    assert kept.controller.cartesian.tool_radius_mm == 10.0


def test_the_line_of_the_next_step_asks_and_confirms(kept):
    step = kept.controller.recovery.step
    assert (step.kind, step.params, step.action) == (
        StepKind.CELL_UNCONFIRMED,
        {"name": "bench"},
        Action.CONFIRM_CELL,
    )
    assert kept.controller.recovery.act(step) is None
    kept.run(0.1)
    assert kept.controller.recovery.step.kind is StepKind.READY


def test_stop_halt_and_disable_never_ask_for_it(kept):
    kept.heard()
    kept.controller.halt_and_hold()
    kept.controller.emergency_stop()
    kept.run(0.1)
    assert Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00")) in kept.heard()
    kept.run_until(lambda: kept.firmware.condition.stopped)


def test_it_is_asked_for_at_every_connection(kept):
    accepted(kept.controller.cell.confirm())
    again(kept, "bench")
    assert kept.controller.operating_state.cannot_move.reason == CELL_NOT_CONFIRMED


def test_a_lost_adapter_that_comes_back_asks_again(kept):
    accepted(kept.controller.cell.confirm())
    kept.controller.cell.forget_arm()  # as it is told by a lost link
    kept.run(0.1)
    assert kept.controller.operating_state.cannot_move.reason == CELL_NOT_CONFIRMED
    assert kept.controller.cartesian.tool == NO_TOOL


def test_an_arm_that_was_silent_may_be_another_one(kept):
    accepted(kept.controller.cell.confirm())
    kept.powered = False
    kept.run(1.0)
    kept.powered = True
    kept.run_until(lambda: kept.controller.recovery.step.kind is StepKind.CELL_UNCONFIRMED)
    assert kept.controller.operating_state.cannot_send_motion.reason == CELL_NOT_CONFIRMED
    assert kept.controller.cartesian.tool == NO_TOOL


def test_a_cell_that_could_not_be_read_is_not_taken_for_none(rig):
    bend(rig)
    again(rig, "bench")
    assert rig.controller.operating_state.cannot_move.reason == CELL_NOT_READ
    step = rig.controller.recovery.step
    assert (step.kind, step.action) == (StepKind.CELL_UNREADABLE, Action.LEAVE_CELL)
    assert rig.controller.recovery.act(step) is None
    rig.run(0.1)
    assert rig.controller.operating_state.cannot_move is None


def test_another_choice_is_a_confirmation_too(kept):
    accepted(kept.controller.cell.choose(""))
    assert kept.controller.operating_state.cannot_move is None
    assert kept.controller.cell.store.names == {"any": ""}


def test_an_adapter_without_a_cell_asks_nothing(rig):
    rig.controller.cell.take_loaded({"bench": BENCH})
    bend(rig)
    assert rig.controller.operating_state.cannot_move is None
    assert rig.controller.cell.cell is None


# What a motion was checked with stays while it goes on ------------------------------------------

CHANGES = {
    "take": lambda cells: cells.take(Cell("other")),
    "choose": lambda cells: cells.choose(""),
    "change": lambda cells: cells.change(Cell("bench")),
    "delete": lambda cells: cells.delete(),
}


def in_force(rig):
    bend(rig)
    accepted(rig.controller.cell.take(BENCH))


@pytest.mark.parametrize("change", CHANGES)
def test_nothing_of_it_changes_while_a_run_is_paused(rig, change):
    in_force(rig)
    run_paused(rig)
    answer = CHANGES[change](rig.controller.cell)
    assert answer.reason == RUN_UNDER_WAY
    assert rig.controller.cartesian.tool == PEN.pose


@pytest.mark.parametrize("change", CHANGES)
def test_nothing_of_it_changes_while_a_jog_is_held(rig, change):
    in_force(rig)
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    rig.run(0.2)
    answer = CHANGES[change](rig.controller.cell)
    assert answer.reason == JOG_UNDER_WAY
    assert rig.controller.cartesian.tool == PEN.pose


def test_nothing_of_it_changes_on_the_way_to_a_pose(rig):
    in_force(rig)
    accepted(rig.controller.motion.send_joints(BACK))
    rig.run(0.3)
    assert rig.controller.cell.choose("").reason == CELL_WHILE_MOVING


def test_no_step_starts_from_a_target_told_with_another_tool(rig):
    in_force(rig)
    accepted(rig.controller.cartesian.step(2, 5.0, JogFrame.BASE))
    rig.run_until(lambda: not rig.controller.operating_state.moving)
    rig.run(0.5)
    long = Cell("bench", (Tool("pen", (0.0, 0.0, 102.0, 0.0, 0.0, 0.0)),), "pen")
    accepted(rig.controller.cell.change(long))
    before = rig.controller.cartesian.tool_pose(rig.controller.state)
    accepted(rig.controller.cartesian.step(0, 4.0, JogFrame.BASE))
    rig.run_until(lambda: not rig.controller.operating_state.moving)
    rig.run(0.5)
    after = rig.controller.cartesian.tool_pose(rig.controller.state)
    assert after[0] - before[0] == pytest.approx(4.0, abs=0.1)
    assert after[2] - before[2] == pytest.approx(0.0, abs=0.1)
