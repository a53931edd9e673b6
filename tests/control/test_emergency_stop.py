"""The stop, followed until the arm says so; and watched afterwards."""

from __future__ import annotations

import functools

import pytest

from armui.arm.state import ArmState, Reading
from armui.control.operating_state import StopState
from armui.control.safety.emergency_stop import (
    EmergencyStop,
    StopWatch,
    is_stopped,
    status_is_fresh,
)
from armui.protocol.codes import ArmStatusCode
from armui.protocol.frame import Frame
from tests.control.heard_arm import status

BEGIN_S = 0.25
STEP_S = 0.015625
STOP = (Frame(0x150, bytes.fromhex("01 00 00 00 00 00 00 00")),)
OTHER = (Frame(0x160, bytes.fromhex("01 00 00 00 00 00 00 00")),)
STOPPED, RUNNING = ArmStatusCode.EMERGENCY_STOP, ArmStatusCode.NORMAL


@functools.cache
def told(arm_status, at_s):
    """An arm whose last word was this."""
    return ArmState(status=Reading(status(arm_status=arm_status), at_s))


class Arm:
    """An arm as heard, the emergency_stop and what it has sent."""

    def __init__(self) -> None:
        self.sent: list[tuple[float, tuple[Frame, ...]]] = []
        self.on_the_bus = True
        self.now_s = BEGIN_S
        self.emergency_stop = EmergencyStop(self._send)

    def _send(self, frames) -> bool:
        self.sent.append((self.now_s, tuple(frames)))
        return self.on_the_bus

    def wait(self, seconds, arm_status=RUNNING, *, online=True):
        """Advance every 1/64 s; whether it was confirmed meanwhile."""
        confirmed = False
        end_s = self.now_s + seconds
        while self.now_s < end_s:
            self.now_s += STEP_S
            state = told(arm_status, self.now_s) if online else ArmState()
            confirmed |= self.emergency_stop.follow_arm(state, self.now_s, online=online)
        return confirmed


@pytest.fixture
def arm():
    return Arm()


def test_nothing_is_asked_for_at_first(arm):
    assert not arm.emergency_stop.requested
    assert not arm.emergency_stop.lapsed
    assert not arm.emergency_stop.unconfirmed(BEGIN_S + 100.0)
    assert not arm.wait(1.0, STOPPED)
    assert arm.sent == []


@pytest.mark.parametrize("on_the_bus", [True, False])
def test_it_is_sent_at_once(arm, on_the_bus):
    arm.on_the_bus = on_the_bus
    assert arm.emergency_stop.request(STOP, arm.now_s) is on_the_bus
    assert arm.sent == [(BEGIN_S, STOP)]
    assert arm.emergency_stop.requested


def test_and_again_every_tenth_of_a_second_until_it_is_confirmed(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    assert not arm.wait(0.5)
    times = [at_s - BEGIN_S for at_s, _ in arm.sent]
    assert times == [0.0, 7 / 64, 14 / 64, 21 / 64, 28 / 64]
    assert {frames for _, frames in arm.sent} == {STOP}
    assert arm.wait(STEP_S, STOPPED)
    assert not arm.emergency_stop.requested
    assert not arm.wait(1.0, STOPPED)
    assert len(arm.sent) == 5


def test_a_repeat_of_exactly_a_tenth_of_a_second():
    arm = Arm()
    arm.emergency_stop.request(STOP, 0.0)
    arm.emergency_stop.follow_arm(ArmState(), 0.1, online=True)
    assert len(arm.sent) == 2


@pytest.mark.parametrize("earlier_s", [0.0, STEP_S])
def test_a_word_of_before_the_stop_confirms_nothing(arm, earlier_s):
    before = told(STOPPED, arm.now_s - earlier_s)
    arm.emergency_stop.request(STOP, arm.now_s)
    assert not arm.emergency_stop.follow_arm(before, arm.now_s + STEP_S, online=True)
    assert arm.emergency_stop.requested
    assert arm.emergency_stop.follow_arm(
        told(STOPPED, arm.now_s + STEP_S), arm.now_s + STEP_S, online=True
    )


def test_asked_for_again_it_is_still_due_since_the_first_time(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(0.25)
    assert not arm.emergency_stop.unconfirmed(arm.now_s)
    arm.wait(0.25)
    assert not arm.emergency_stop.unconfirmed(arm.now_s)
    assert arm.emergency_stop.unconfirmed(arm.now_s + STEP_S)
    arm.emergency_stop.request(OTHER, arm.now_s)
    assert arm.sent[-1] == (arm.now_s, OTHER)
    assert arm.emergency_stop.unconfirmed(arm.now_s + STEP_S)
    arm.wait(0.25)
    assert arm.sent[-1][1] == OTHER
    # the arm's word may be of the first
    assert arm.emergency_stop.follow_arm(told(STOPPED, BEGIN_S + 0.5), arm.now_s, online=True)


def test_confirmed_it_is_not_overdue(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(0.1, STOPPED)
    assert not arm.emergency_stop.unconfirmed(arm.now_s + 100.0)


# An arm that is away ------------------------------------------------------------------------------


def test_an_arm_heard_all_the_time_is_stopped_however_long_it_takes(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(30.0)
    assert not arm.emergency_stop.lapsed
    count = len(arm.sent)
    arm.wait(0.125)
    assert len(arm.sent) > count


@pytest.mark.parametrize(("away_s", "lapsed"), [(9.0, False), (9.96875, False), (10.5, True)])
def test_an_arm_that_comes_back_within_ten_seconds_is_stopped_by_itself(arm, away_s, lapsed):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(away_s, online=False)
    assert arm.emergency_stop.lapsed is lapsed
    count = len(arm.sent)
    arm.wait(0.25)
    assert arm.emergency_stop.lapsed is lapsed
    assert arm.emergency_stop.requested
    assert (len(arm.sent) == count) is lapsed


def test_ten_seconds_and_no_longer(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(10.0, online=False)
    assert not arm.emergency_stop.lapsed
    arm.wait(STEP_S, online=False)
    assert arm.emergency_stop.lapsed


@pytest.mark.parametrize(("away_s", "lapsed"), [(0.984375, False), (1.125, True)])
def test_after_ten_seconds_a_second_away_is_enough(arm, away_s, lapsed):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(20.0)
    arm.wait(away_s, online=False)
    arm.wait(1.0)
    assert arm.emergency_stop.lapsed is lapsed


def test_asked_for_again_what_has_lapsed_is_sent_again(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(11.0, online=False)
    assert arm.emergency_stop.lapsed
    arm.emergency_stop.request(STOP, arm.now_s)
    assert not arm.emergency_stop.lapsed
    assert not arm.emergency_stop.unconfirmed(arm.now_s + 0.5)
    count = len(arm.sent)
    arm.wait(9.0, online=False)
    assert not arm.emergency_stop.lapsed
    assert len(arm.sent) > count
    arm.wait(2.0, online=False)
    assert arm.emergency_stop.lapsed


def test_asked_for_again_before_it_lapses_it_has_ten_seconds_more(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(9.0, online=False)
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(9.0, online=False)
    assert not arm.emergency_stop.lapsed
    arm.wait(1.5, online=False)
    assert arm.emergency_stop.lapsed


def test_what_has_lapsed_is_confirmed_by_an_arm_that_says_so(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(11.0, online=False)
    assert arm.wait(STEP_S, STOPPED)
    assert not arm.emergency_stop.lapsed
    assert not arm.emergency_stop.requested


def test_withdrawn_it_is_sent_no_more(arm):
    arm.emergency_stop.request(STOP, arm.now_s)
    arm.wait(11.0, online=False)
    arm.emergency_stop.reset()
    assert not arm.emergency_stop.requested
    assert not arm.emergency_stop.lapsed
    count = len(arm.sent)
    arm.wait(1.0)
    assert len(arm.sent) == count
    arm.emergency_stop.request(STOP, arm.now_s)
    assert not arm.emergency_stop.lapsed
    assert not arm.emergency_stop.unconfirmed(arm.now_s + 0.5)


# Where it stands ----------------------------------------------------------------------------------

FRESH, OLD = BEGIN_S - 0.5, BEGIN_S - 0.51


@pytest.mark.parametrize(
    ("state", "online", "resuming", "stands"),
    [
        (told(STOPPED, FRESH), True, False, StopState.STOPPED),
        (told(STOPPED, FRESH), True, True, StopState.RESUMING),
        (told(RUNNING, FRESH), True, True, StopState.RESUMING),
        (told(RUNNING, FRESH), True, False, StopState.RUNNING),
        (told(STOPPED, OLD), True, False, StopState.RUNNING),
        (told(STOPPED, FRESH), False, False, StopState.RUNNING),
        (ArmState(), True, False, StopState.RUNNING),
    ],
)
def test_resume_is_offered_only_while_stopped_is_heard(arm, state, online, resuming, stands):
    assert arm.emergency_stop.state(state, BEGIN_S, online=online, resuming=resuming) is stands
    arm.emergency_stop.request(STOP, arm.now_s)
    requested = arm.emergency_stop.state(state, BEGIN_S, online=online, resuming=resuming)
    assert requested is StopState.REQUESTED


@pytest.mark.parametrize("code", ArmStatusCode)
def test_only_one_code_says_stopped(code):
    assert is_stopped(told(int(code), 0.0)) is (code is STOPPED)


def test_an_arm_not_heard_has_no_word():
    assert not is_stopped(ArmState())
    assert not status_is_fresh(ArmState(), 0.0)


# What becomes of it -------------------------------------------------------------------------------


@pytest.fixture
def watch():
    watch = StopWatch()
    watch.confirmed()
    return watch


def undone(watch, state, *, resuming=False):
    return watch.undone(state, BEGIN_S, resuming=resuming)


def test_a_stop_that_was_not_ours_cannot_be_undone():
    assert not StopWatch().holds
    assert not undone(StopWatch(), told(RUNNING, FRESH))


def test_a_stop_that_another_host_undoes_is_told_once(watch):
    assert not undone(watch, told(STOPPED, FRESH))
    assert watch.holds
    assert undone(watch, told(RUNNING, FRESH))
    assert not watch.holds
    assert not undone(watch, told(RUNNING, FRESH))


@pytest.mark.parametrize("state", [told(RUNNING, OLD), ArmState()])
def test_an_arm_that_is_not_heard_has_undone_nothing(watch, state):
    assert not undone(watch, state)
    assert watch.holds
    assert undone(watch, told(RUNNING, FRESH))


def test_our_own_resume_is_no_fault(watch):
    assert not undone(watch, told(RUNNING, FRESH), resuming=True)
    assert not undone(watch, told(RUNNING, FRESH))


def test_over_a_new_connection_it_is_forgotten(watch):
    watch.reset()
    assert not watch.holds
    assert not undone(watch, told(RUNNING, FRESH))
