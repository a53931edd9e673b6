"""Parameters of the arm: the literal bytes sent, what the arm then holds, what is told of it."""

import math

import can
import pytest

from armui.arm.parameters import SETTING_NO_CHOICE, Batch, Group, Parameter, all_batches, reading_of
from armui.control.link.link_state import LINK_LOST
from armui.control.operations.started import SETTING_NOT_READ_BACK, SETTING_UNANSWERED
from armui.control.parameters.arm_settings import SETTING_NOT_KEPT
from armui.control.parameters.setting_cell import CellState
from armui.control.parameters.setting_checks import (
    SETTING_CORRUPT,
    SETTING_NOT_TAKEN,
    SETTING_UNKNOWN,
)
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.accepted import accepted
from tests.family import FACTORY_LIMITS
from tests.faulty_arm import HardOfHearing

END = Batch(Group.END_LIMITS)
COLLISION = Batch(Group.COLLISION)
MAX_J2 = Parameter("max_angle_deg", 2)
MIN_J2 = Parameter("min_angle_deg", 2)
SPEED_J2 = Parameter("max_speed_deg_s", 2)
ACCELERATION_J3 = Parameter("max_acceleration_deg_s2", 3)
LINEAR_SPEED = Parameter("max_linear_speed_m_s")
SETTINGS_IDS = range(0x470, 0x47E)


def frame(arbitration_id, payload):
    return Frame(arbitration_id, bytes.fromhex(payload))


@pytest.fixture
def arm(any_rig):
    any_rig.connect()
    any_rig.ear = HardOfHearing(any_rig.firmware)
    return any_rig


@pytest.fixture
def arm2(rig):
    rig.connect()
    rig.ear = HardOfHearing(rig.firmware)
    return rig


def settled(rig):
    rig.run_until(lambda: not rig.controller.settings.busy)


def states(rig, *parameters):
    return [rig.controller.settings.cell(parameter).state for parameter in parameters]


def reason(rig, parameter):
    return rig.controller.settings.cell(parameter).refusal


def settings_heard(rig):
    return [each for each in rig.ear.heard if each.arbitration_id in SETTINGS_IDS]


def saved(rig, changes):
    accepted(rig.controller.settings.save(changes))
    settled(rig)


def test_everything_an_arm_keeps_is_read(any_rig):
    any_rig.connect()
    generation = any_rig.controller.operating_state.generation
    second = generation is Generation.TWO
    batches = list(all_batches(teaching=second, drag_assistance=second))
    assert any_rig.controller.settings.everything() == batches
    assert any_rig.controller.settings.read(batches) is None
    settled(any_rig)
    for batch in batches:
        for parameter in batch.parameters():
            assert states(any_rig, parameter) == [CellState.READ]
            assert reading_of(any_rig.controller.state, parameter) is not None
    assert any_rig.controller.state.collision_levels.value == (1,) * 6


def test_only_what_changed_is_sent_in_generation_2(arm2):
    saved(arm2, {MAX_J2: 170.0})
    # joint 2, 1700 = 06A4 in 0.1°, the other two 7FFF: leave them; then asked what it holds
    assert settings_heard(arm2) == [
        frame(0x474, "02 06A4 7FFF 7FFF 00"),
        frame(0x472, "02 01 00 00 00 00 00 00"),
    ]
    assert arm2.firmware.settings.limits[1].max_deg == 170.0
    assert arm2.firmware.settings.limits[1].min_deg == FACTORY_LIMITS[1].min_deg
    assert states(arm2, MAX_J2, MIN_J2) == [CellState.SAVED, CellState.UNREAD]
    assert reading_of(arm2.controller.state, MAX_J2).value == 170.0
    assert arm2.controller.operating_state.limits[1].max_deg == 170.0


@pytest.mark.parametrize("generation", [Generation.ONE])
def test_generation_1_sends_the_rest_as_it_was_read(any_rig):
    rig = any_rig
    rig.connect()
    rig.ear = HardOfHearing(rig.firmware)
    saved(rig, {MAX_J2: 170.0})
    # 1700 = 06A4; min 0; 3 rad/s = 28.65 rpm, on the bus 29 = 001D
    assert settings_heard(rig)[0] == frame(0x474, "02 06A4 0000 001D 00")
    assert rig.firmware.settings.limits[1].max_deg == 170.0
    assert rig.firmware.settings.limits[1].max_speed_deg_s == pytest.approx(math.degrees(3.0))


def test_speed_and_acceleration_are_in_the_operators_units(arm):
    saved(arm, {SPEED_J2: 120.0, ACCELERATION_J3: 150.0})
    settings = arm.firmware.settings
    if arm.controller.operating_state.generation is Generation.TWO:
        # 120 °/s = 2.094 rad/s -> 209 steps of 0.01; 150 °/s² = 2.618 rad/s² -> 262
        assert settings.limits[1].max_speed_deg_s == pytest.approx(math.degrees(2.09))
        assert settings.accelerations_deg_s2[2] == pytest.approx(math.degrees(2.62))
    else:
        # 6 °/s are 1 rpm
        assert settings.limits[1].max_speed_deg_s == pytest.approx(120.0)
        assert settings.accelerations_deg_s2[2] == pytest.approx(150.0)
    assert states(arm, SPEED_J2, ACCELERATION_J3) == [CellState.SAVED] * 2
    assert arm.codes()[-1] == "settings_saved"
    told = arm.events[-1].params["settings"]
    assert told == "max_speed_deg_s.2 max_acceleration_deg_s2.3"


def test_end_limits_and_collision_levels(arm):
    arm.controller.settings.read([END, COLLISION])
    settled(arm)
    saved(arm, {LINEAR_SPEED: 0.5, Parameter("collision_level", 4): 8})
    assert arm.firmware.settings.end_limits == (0.5, 1.0, 1.0, 1.0)
    assert arm.firmware.settings.collision_levels == (1, 1, 1, 8, 1, 1)
    assert frame(0x47A, "01 01 01 08 01 01 00 00") in arm.ear.heard


def test_levels_not_read_yet_are_not_made_up(arm):
    refusal = arm.controller.settings.save({Parameter("collision_level", 4): 8})
    assert refusal.reason == SETTING_UNKNOWN
    assert settings_heard(arm) == []


def test_a_value_the_arm_answers_and_does_not_take(arm):
    saved(arm, {SPEED_J2: 300.0})  # more than the motors can do
    assert states(arm, SPEED_J2) == [CellState.REFUSED]
    refusal = reason(arm, SPEED_J2)
    assert refusal.reason == SETTING_NOT_TAKEN
    assert refusal.params["held"] == pytest.approx(math.degrees(3.0), abs=3.0)
    assert arm.codes()[-1] == "settings_refused"


def test_an_arm_that_neither_answers_nor_takes_it(arm):
    arm.ear.deaf_to = {0x474}
    saved(arm, {MAX_J2: 170.0})
    assert states(arm, MAX_J2) == [CellState.REFUSED]
    assert reason(arm, MAX_J2).reason == SETTING_UNANSWERED
    assert reading_of(arm.controller.state, MAX_J2).value == FACTORY_LIMITS[1].max_deg


def test_a_lost_answer_is_made_good_by_reading_back(arm):
    arm.ear.mute_on = {0x476}
    saved(arm, {MAX_J2: 170.0})
    assert states(arm, MAX_J2) == [CellState.SAVED]


def test_an_answer_alone_proves_nothing(arm):
    arm.ear.mute_on = {0x473}
    saved(arm, {MAX_J2: 170.0})
    assert states(arm, MAX_J2) == [CellState.REFUSED]
    assert reason(arm, MAX_J2).reason == SETTING_NOT_READ_BACK


def test_an_arm_that_says_nothing_when_asked(arm):
    arm.ear.deaf_to = {0x477}
    arm.controller.settings.read([END])
    settled(arm)
    assert states(arm, LINEAR_SPEED) == [CellState.REFUSED]
    assert reason(arm, LINEAR_SPEED).reason == SETTING_NOT_READ_BACK


def test_a_link_lost_half_way(arm, qtbot):
    arm.ear.deaf_to = {0x474, 0x472}
    arm.controller.settings.save({MAX_J2: 170.0, Parameter("max_angle_deg", 3): -1.0})
    arm.step()
    arm.unplug(can.CanOperationError("gone"))
    qtbot.waitUntil(lambda: "link_lost" in arm.codes())
    assert not arm.controller.settings.busy
    assert reason(arm, MAX_J2).reason == LINK_LOST
    assert arm.controller.settings.save({MAX_J2: 170.0}).reason == LINK_LOST


@pytest.mark.parametrize(
    ("parameter", "value", "code"),
    [
        (MAX_J2, 361.0, "setting_out_of_range"),
        (MAX_J2, math.nan, "setting_not_a_number"),
        (MAX_J2, -1.0, "limits_crossed"),
        (LINEAR_SPEED, 0.0, "setting_out_of_range"),
        (Parameter("collision_level", 1), 9.0, "setting_out_of_range"),
    ],
)
def test_what_cannot_be_is_not_sent(arm, parameter, value, code):
    assert arm.controller.settings.save({parameter: value}).code == code
    assert settings_heard(arm) == []


def test_a_value_that_is_none_of_the_few_is_not_sent(arm2):
    refusal = arm2.controller.settings.save({Parameter("stroke_limit_mm"): 50.0})
    assert refusal.reason == SETTING_NO_CHOICE
    assert settings_heard(arm2) == []


@pytest.mark.parametrize("generation", [Generation.ONE])
def test_an_arm_without_a_teaching_handle_is_neither_asked_nor_told(any_rig):
    any_rig.connect()
    ear = HardOfHearing(any_rig.firmware)
    settings = any_rig.controller.settings
    assert settings.read([Batch(Group.TEACHING)]).reason == SETTING_NOT_KEPT
    assert settings.save({Parameter("stroke_limit_mm"): 70.0}).reason == SETTING_NOT_KEPT
    any_rig.run(0.2)
    assert ear.heard == []


def test_corrupt_limits_are_known_and_can_be_mended(arm):
    arm.firmware.corrupt_limits(2)
    arm.controller.settings.read([Batch(Group.JOINT_LIMITS, 2)])
    settled(arm)
    assert arm.controller.settings.save({MAX_J2: 170.0}).reason == SETTING_CORRUPT
    saved(arm, {MAX_J2: 170.0, MIN_J2: 1.0, SPEED_J2: 90.0})
    assert states(arm, MAX_J2, MIN_J2, SPEED_J2) == [CellState.SAVED] * 3
    assert arm.firmware.settings.limits[1].min_deg == 1.0


def test_the_ends_limits_go_back_to_the_factorys(arm):
    arm.controller.settings.read([END])
    settled(arm)
    saved(arm, {LINEAR_SPEED: 0.5})
    accepted(arm.controller.settings.reset_end_limits())
    settled(arm)
    assert frame(0x477, "00 01 00 00 00 00 00 00") in arm.ear.heard
    assert reading_of(arm.controller.state, LINEAR_SPEED).value == 1.0
    assert states(arm, LINEAR_SPEED) == [CellState.READ]


def test_a_reset_that_is_not_answered(arm):
    arm.ear.deaf_to = {0x477}
    arm.controller.settings.reset_end_limits()
    settled(arm)
    assert states(arm, LINEAR_SPEED) == [CellState.REFUSED]
    assert reason(arm, LINEAR_SPEED).reason == SETTING_UNANSWERED


def test_saving_waits_for_what_is_under_way(arm):
    arm.controller.settings.save({MAX_J2: 170.0})
    refusal = arm.controller.settings.save({MAX_J2: 160.0})
    assert (refusal.code, refusal.params["what"]) == ("busy", "settings")
    settled(arm)
    assert arm.firmware.settings.limits[1].max_deg == 170.0


def test_clearing_an_error_waits_its_turn(arm):
    """0x476 names 0x475 for both: the two must not be taken for one another."""
    arm.controller.settings.save({ACCELERATION_J3: 150.0})
    arm.controller.joint_errors.clear(3)
    settled(arm)
    arm.run_until(lambda: "clear_error_answered" in arm.codes())
    sent = [each for each in arm.ear.heard if each.arbitration_id in {0x475, 0x472}]
    assert [each.arbitration_id for each in sent] == [0x475, 0x472, 0x475]
