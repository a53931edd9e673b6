"""The reasons against a command, against a motion by its motors, and by the arm's own word."""

from __future__ import annotations

import pytest

from armui.arm.state import ArmState, Reading, Six
from armui.control.link.link_state import OFFLINE as OFFLINE_REASON
from armui.control.operating_state import BUSY, Busy, StopState
from armui.control.safety import interlocks
from armui.control.safety.interlocks import (
    ARM_FAULT,
    ENABLED_UNKNOWN,
    JOINTS_UNKNOWN,
    NOT_ENABLED,
    OTHER_CONTROL,
    STOP_REQUESTED,
    STOPPED,
)
from armui.protocol.codes import ArmStatusCode, ControlMode
from tests.control.heard_arm import status

OFFLINE = OFFLINE_REASON()


@pytest.mark.parametrize(
    ("unreachable", "stop", "busy", "code"),
    [
        (None, StopState.RUNNING, None, None),
        (None, StopState.RESUMING, None, None),
        (None, StopState.RUNNING, Busy.ZEROING, BUSY),
        (None, StopState.STOPPED, Busy.ZEROING, STOPPED),
        (None, StopState.REQUESTED, Busy.ZEROING, STOP_REQUESTED),
        (OFFLINE, StopState.REQUESTED, Busy.ZEROING, OFFLINE_REASON),
    ],
)
def test_the_first_reason_against_any_command(unreachable, stop, busy, code):
    refusal = interlocks.why_no_command(unreachable, stop, busy)
    assert (None if refusal is None else refusal.reason) == code


@pytest.mark.parametrize("busy", Busy)
def test_what_the_program_waits_for_is_named(busy):
    assert interlocks.why_no_command(None, StopState.RUNNING, busy).params == {"what": busy.value}


ON = (True,) * 6


def six(values) -> Six[bool | None]:
    """One value for each motor."""
    one, two, three, four, five, six = values
    return one, two, three, four, five, six


def test_motors_that_are_all_on_are_no_reason():
    assert interlocks.why_not_enabled(ON) is None


@pytest.mark.parametrize("joint", range(1, 7))
def test_a_motor_that_is_off_is_named_before_one_that_is_not_heard(joint):
    unknown: list[bool | None] = [None] * 6
    unknown[joint - 1] = False
    assert interlocks.why_not_enabled(six(unknown)) == NOT_ENABLED(joints=str(joint))


def test_all_motors_that_are_off_are_named():
    off = interlocks.why_not_enabled((False, True, False, True, True, False))
    assert off.params == {"joints": "1, 3, 6"}


@pytest.mark.parametrize("index", range(6))
def test_a_motor_that_is_not_heard_is_a_reason(index):
    one = tuple(None if each == index else True for each in range(6))
    assert interlocks.why_not_enabled(six(one)) == ENABLED_UNKNOWN()


READY = ArmState(status=Reading(status(), 0.0), joints_deg=(Reading(0.0, 0.0),) * 6)
MOVABLE_MODES = {ControlMode.STANDBY, ControlMode.CAN_CONTROL}
MOVABLE = {
    ArmStatusCode.NORMAL,
    ArmStatusCode.NO_SOLUTION,
    ArmStatusCode.SINGULARITY,
    ArmStatusCode.TARGET_BEYOND_LIMIT,
}


@pytest.mark.parametrize("mode", ControlMode)
def test_who_controls_the_arm(mode):
    refusal = interlocks.why_not_ready(
        READY._replace(status=Reading(status(control_mode=mode), 0.0))
    )
    expected = None if mode in MOVABLE_MODES else OTHER_CONTROL(mode=mode)
    assert refusal == expected


@pytest.mark.parametrize("code", ArmStatusCode)
def test_a_fault_of_the_arm(code):
    refusal = interlocks.why_not_ready(READY._replace(status=Reading(status(arm_status=code), 0.0)))
    assert refusal == (None if code in MOVABLE else ARM_FAULT(status=code))


@pytest.mark.parametrize(
    "changes", [{"status": None}, {"joints_deg": (*READY.joints_deg[:5], None)}]
)
def test_an_arm_that_has_not_been_heard_in_full(changes):
    assert interlocks.why_not_ready(READY._replace(**changes)) == JOINTS_UNKNOWN()
