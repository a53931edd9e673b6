"""What a motion counts on hearing, and whether the arm says that it is limp or led by a hand."""

from __future__ import annotations

import pytest

from armui.arm.state import ArmState, Reading
from armui.control.safety.feedback_freshness import (
    FEEDBACK_SILENT,
    any_motor_off,
    in_drag_teaching,
    why_silent,
)
from armui.protocol.codes import ArmStatusCode, ControlMode
from tests.control.heard_arm import DRIVER, status

NOW_S = 100.0
FRESH_S = NOW_S - 0.5
STALE_S = NOW_S - 0.51
HEARD = ArmState(
    status=Reading(status(), FRESH_S),
    joints_deg=(Reading(0.0, FRESH_S),) * 6,
    drivers_slow=(Reading(DRIVER, FRESH_S),) * 6,
)


def changed(six, index, value):
    return (*six[:index], value, *six[index + 1 :])


def test_all_of_it_heard_within_half_a_second_is_no_silence():
    assert why_silent(HEARD, NOW_S) is None
    assert why_silent(HEARD, NOW_S - 0.3) is None


@pytest.mark.parametrize("status_heard", [None, Reading(status(), STALE_S)])
def test_a_silent_status_is_named(status_heard):
    silent = HEARD._replace(status=status_heard)
    assert why_silent(silent, NOW_S).reason == FEEDBACK_SILENT
    assert why_silent(silent, NOW_S).params == {"frames": "0x2A1", "seconds": 0.5}


@pytest.mark.parametrize("angle", [None, Reading(0.0, STALE_S)])
@pytest.mark.parametrize(
    ("index", "frame"),
    [(0, "0x2A5"), (1, "0x2A5"), (2, "0x2A6"), (3, "0x2A6"), (4, "0x2A7"), (5, "0x2A7")],
)
def test_a_silent_angle_is_named_by_its_frame(index, frame, angle):
    silent = HEARD._replace(joints_deg=changed(HEARD.joints_deg, index, angle))
    assert why_silent(silent, NOW_S).params["frames"] == frame


def test_all_that_is_silent_is_named():
    frames = why_silent(ArmState(), NOW_S).params["frames"]
    assert frames == "0x2A1, 0x2A5, 0x2A6, 0x2A7"


OFF = DRIVER._replace(enabled=False)


@pytest.mark.parametrize(
    ("one", "is_limp"),
    [
        (Reading(DRIVER, FRESH_S), False),
        (Reading(OFF, FRESH_S), True),
        (Reading(OFF, STALE_S), None),
        (Reading(DRIVER, STALE_S), None),
        (None, None),
    ],
    ids=["on", "off", "off, long ago", "on, long ago", "never heard"],
)
@pytest.mark.parametrize("index", [0, 5])
def test_one_motor_without_power_makes_it_limp_and_one_not_heard_leaves_it_open(
    index, one, is_limp
):
    state = HEARD._replace(drivers_slow=changed(HEARD.drivers_slow, index, one))
    assert any_motor_off(state, NOW_S) is is_limp


def test_a_motor_without_power_tells_more_than_one_not_heard():
    state = HEARD._replace(drivers_slow=(None, *(Reading(OFF, FRESH_S),) * 5))
    assert any_motor_off(state, NOW_S) is True


@pytest.mark.parametrize(
    ("changes", "led"),
    [
        ({}, False),
        ({"control_mode": ControlMode.STANDBY}, False),
        ({"control_mode": ControlMode.TEACHING}, True),
        ({"control_mode": ControlMode.LINKED_TEACHING_INPUT}, True),
        ({"arm_status": ArmStatusCode.TEACHING_RECORDING}, True),
        ({"arm_status": ArmStatusCode.TEACHING_RUNNING}, False),
    ],
)
def test_when_a_hand_leads_it(changes, led):
    assert in_drag_teaching(HEARD._replace(status=Reading(status(**changes), FRESH_S))) is led


def test_nothing_is_known_of_a_hand_before_the_status_is_heard():
    assert not in_drag_teaching(ArmState())
