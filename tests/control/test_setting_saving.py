"""A saving followed to its end: pure, no Qt and no arm."""

import pytest

from armui.arm.limits import JointLimits
from armui.arm.parameters import SETTING_OUT_OF_RANGE, Parameter
from armui.arm.state import ArmState, Reading
from armui.control.operating_state import BUSY
from armui.control.operations.started import SETTING_UNANSWERED
from armui.control.parameters.setting_cell import CellState, SettingCellState
from armui.control.parameters.setting_draft import SettingDraft
from armui.control.parameters.setting_saving import SettingSaving

MAX_J1 = Parameter("max_angle_deg", 1)
SPEED_J1 = Parameter("max_speed_deg_s", 1)
HELD = ArmState()._replace(limits=(Reading(JointLimits(-150.0, 150.0, 171.887), 1.0), *(None,) * 5))
SILENT = SETTING_UNANSWERED()


class Settings:
    """Takes what it is given, and says of it what a test wants said."""

    def __init__(self):
        self.saved = []
        self.answer = None
        self.cells = {}

    def save(self, changes):
        self.saved.append(dict(changes))
        return self.answer

    def cell(self, parameter):
        return self.cells.get(parameter, SettingCellState(CellState.SAVING))


@pytest.fixture
def settings():
    return Settings()


@pytest.fixture
def draft():
    draft = SettingDraft([MAX_J1, SPEED_J1])
    draft.begin_editing()
    draft.enter(HELD, MAX_J1, "140", 140.0)
    draft.enter(HELD, SPEED_J1, "90", 90.0)
    return draft


@pytest.fixture
def saving(settings, draft):
    return SettingSaving(settings, draft)


def test_it_has_ended_when_nothing_is_under_way_and_says_so_once(saving, settings, draft):
    assert saving.begin(HELD) is None
    assert settings.saved == [{MAX_J1: 140.0, SPEED_J1: 90.0}]
    settings.cells[MAX_J1] = SettingCellState(CellState.SAVED)
    assert not saving.ended()
    assert saving.running
    settings.cells[SPEED_J1] = SettingCellState(CellState.SAVED)
    assert saving.ended()
    assert not saving.ended()
    assert not draft.changed
    assert not draft.editing
    assert saving.asked == {MAX_J1: 140.0, SPEED_J1: 90.0}


def test_what_was_not_taken_stays_in_the_draft(saving, settings, draft):
    saving.begin(HELD)
    settings.cells = {
        MAX_J1: SettingCellState(CellState.SAVED),
        SPEED_J1: SettingCellState(CellState.REFUSED, SILENT),
    }
    assert saving.ended()
    assert draft.changes() == {SPEED_J1: 90.0}
    assert draft.editing


def test_what_the_controller_refuses_is_not_under_way(saving, settings):
    settings.answer = BUSY(what="settings")
    assert saving.begin(HELD) is settings.answer
    assert not saving.running
    assert saving.asked == {}


def test_what_is_wrong_is_not_sent(saving, settings, draft):
    draft.enter(HELD, MAX_J1, "400", 400.0)
    assert saving.begin(HELD).reason == SETTING_OUT_OF_RANGE
    assert settings.saved == []
    assert not saving.running


def test_nothing_entered_is_nothing_to_send(settings):
    saving = SettingSaving(settings, SettingDraft([MAX_J1]))
    assert saving.begin(HELD) is None
    assert settings.saved == []
    assert not saving.running
