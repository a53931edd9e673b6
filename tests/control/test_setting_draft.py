"""What was entered beside what the arm holds: pure, no Qt and no arm."""

from dataclasses import replace

import pytest

from armui.arm.limits import JointLimits
from armui.arm.parameters import Parameter
from armui.arm.refusal import Refusal
from armui.arm.state import ArmState, Heard
from armui.control.setting_cell import Cell, CellState
from armui.control.setting_draft import Look, SettingDraft

MAX_J1 = Parameter("max_angle_deg", 1)
MIN_J1 = Parameter("min_angle_deg", 1)
SPEED_J1 = Parameter("max_speed_deg_s", 1)
READ = Cell(CellState.READ)


def arm(limits):
    return replace(ArmState(), limits=(Heard(limits, 1.0), *(None,) * 5))


HELD = arm(JointLimits(-150.0, 150.0, 171.887))


@pytest.fixture
def draft():
    draft = SettingDraft([MAX_J1, MIN_J1, SPEED_J1])
    draft.begin()
    return draft


def test_what_is_shown_already_is_no_change(draft):
    draft.enter(HELD, SPEED_J1, "171.9", 171.9)
    assert not draft.changed
    draft.enter(HELD, SPEED_J1, "172", 172.0)
    assert draft.changes() == {SPEED_J1: 172.0}
    draft.enter(HELD, SPEED_J1, "171,9", 171.9)
    assert not draft.changed


def test_a_field_left_empty_is_no_change_where_nothing_is_known(draft):
    draft.enter(ArmState(), SPEED_J1, " ", None)
    assert not draft.changed
    draft.enter(HELD, SPEED_J1, " ", None)
    assert draft.first_wrong(HELD).code == "setting_not_a_number"


def test_two_ends_are_judged_together(draft):
    draft.enter(HELD, MIN_J1, "160", 160.0)
    assert draft.why_wrong(HELD, MIN_J1).code == "limits_crossed"
    draft.enter(HELD, MAX_J1, "170", 170.0)
    assert draft.first_wrong(HELD) is None


@pytest.mark.parametrize(
    ("cell", "entered", "state", "look"),
    [
        (Cell(), None, ArmState(), Look.NOT_READ),
        (Cell(CellState.READING), None, ArmState(), Look.READING),
        (READ, None, HELD, Look.READ),
        (READ, None, arm(JointLimits(-0.1, -0.1, 37549.0)), Look.CORRUPT),
        (READ, 140.0, HELD, Look.CHANGED),
        (READ, 400.0, HELD, Look.WRONG),
        (Cell(CellState.SAVING), 140.0, HELD, Look.SAVING),
        (Cell(CellState.SAVED), None, HELD, Look.SAVED),
        (Cell(CellState.REFUSED, Refusal("link_lost")), 140.0, HELD, Look.NOT_SAVED),
        (Cell(CellState.REFUSED, Refusal("link_lost")), None, HELD, Look.NOT_READ),
    ],
)
def test_every_state_has_its_look(draft, cell, entered, state, look):
    if entered is not None:
        draft.enter(state, MAX_J1, str(entered), entered)
    assert draft.look(state, MAX_J1, cell) is look


def test_giving_up_forgets_everything(draft):
    draft.enter(HELD, MAX_J1, "140", 140.0)
    draft.end()
    assert (draft.changed, draft.editing, draft.entry(MAX_J1)) == (False, False, None)
