"""What was entered beside what the arm holds: pure, no Qt and no arm."""

import pytest

from armui.arm.limits import JointLimits
from armui.arm.parameters import SETTING_NOT_A_NUMBER, Parameter
from armui.arm.state import ArmState, Reading
from armui.control.link.link_state import LINK_LOST
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_checks import LIMITS_CROSSED
from armui.control.parameters.setting_draft import CellStatus, SettingDraft

MAX_J1 = Parameter("max_angle_deg", 1)
MIN_J1 = Parameter("min_angle_deg", 1)
SPEED_J1 = Parameter("max_speed_deg_s", 1)
READ = SettingCellState(CellState.READ)


def arm(limits):
    return ArmState()._replace(limits=(Reading(limits, 1.0), *(None,) * 5))


HELD = arm(JointLimits(-150.0, 150.0, 171.887))


@pytest.fixture
def draft():
    draft = SettingDraft([MAX_J1, MIN_J1, SPEED_J1])
    draft.begin_editing()
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
    assert draft.first_wrong(HELD).reason == SETTING_NOT_A_NUMBER


def test_two_ends_are_judged_together(draft):
    draft.enter(HELD, MIN_J1, "160", 160.0)
    assert draft.why_wrong(HELD, MIN_J1).reason == LIMITS_CROSSED
    draft.enter(HELD, MAX_J1, "170", 170.0)
    assert draft.first_wrong(HELD) is None


@pytest.mark.parametrize(
    ("cell", "entered", "state", "status"),
    [
        (SettingCellState(), None, ArmState(), CellStatus.NOT_READ),
        (SettingCellState(CellState.READING), None, ArmState(), CellStatus.READING),
        (READ, None, HELD, CellStatus.READ),
        (READ, None, arm(JointLimits(-0.1, -0.1, 37549.0)), CellStatus.CORRUPT),
        (READ, 140.0, HELD, CellStatus.CHANGED),
        (READ, 400.0, HELD, CellStatus.WRONG),
        (SettingCellState(CellState.SAVING), 140.0, HELD, CellStatus.SAVING),
        (SettingCellState(CellState.SAVED), None, HELD, CellStatus.SAVED),
        (
            SettingCellState(CellState.REFUSED, LINK_LOST()),
            140.0,
            HELD,
            CellStatus.NOT_SAVED,
        ),
        (
            SettingCellState(CellState.REFUSED, LINK_LOST()),
            None,
            HELD,
            CellStatus.NOT_READ,
        ),
    ],
)
def test_every_state_has_its_status(draft, cell, entered, state, status):
    if entered is not None:
        draft.enter(state, MAX_J1, str(entered), entered)
    assert draft.status(state, MAX_J1, cell) is status


def test_giving_up_forgets_everything(draft):
    draft.enter(HELD, MAX_J1, "140", 140.0)
    draft.end_editing()
    assert (draft.changed, draft.editing, draft.entry(MAX_J1)) == (False, False, None)
