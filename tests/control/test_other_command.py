"""What another host does to the arm: its modes, its rate, when it is over."""

from __future__ import annotations

import pytest

from armui.arm.other_hosts import OtherHosts
from armui.arm.state import ArmState, Reading
from armui.control.safety.other_command import (
    LEADER_ARM,
    NOBODY_ELSE,
    OTHER_HOST,
    OTHER_HOST_STREAMS,
    OTHER_MODE,
    OtherCommand,
    OtherMode,
)
from armui.protocol.codes import ArmStatusCode, ControlMode
from tests.control.heard_arm import status

NOW_S = 0.25
HERE = (0,)


class Company:
    """Another host and an arm, heard by an `OtherCommand`."""

    def __init__(self) -> None:
        self.hosts = OtherHosts()
        self.other = OtherCommand()

    def say(self, arbitration_id: int, data: str, at_s: float = NOW_S) -> None:
        """The other host sends a frame."""
        self.hosts.note(arbitration_id, bytes.fromhex(data), at_s)

    def look(
        self, now_s: float, status_s: float | None = None, *, at_rest=True, offsets=HERE, **changes
    ):
        """Hear the arm's status, made at a time, and judge; the mode it is in."""
        heard = Reading(status(**changes), now_s if status_s is None else status_s)
        state = ArmState(last_feedback_s=now_s, status=heard)
        self.other.observe(self.hosts.traffic(), offsets, state, now_s, at_rest=at_rest)
        return self.other.mode


@pytest.fixture
def company():
    return Company()


WORDS = {
    "01 04 00 AD 00 00 00 00": OtherMode.MIT,
    "01 06 00 AD 00 00 00 00": OtherMode.MIT,
    "01 05 32 00 00 00 00 00": OtherMode.CPV,
    "01 01 00 AD 00 00 00 00": OtherMode.HIGH_FOLLOW,
    "01 01 32 00 00 00 00 00": None,
    "01 00 32 00 00 00 00 00": None,
    "01 02 32 AD 00 00 00 00": None,
    "01 00 32 AD 00 00 00 00": None,
    "01 01 32 AE 00 00 00 00": None,
}
"""Mode words of firmware-versions and protocol-generations, and what they put the arm in."""


@pytest.mark.parametrize("word", WORDS)
def test_a_mode_word_counts_before_the_arm_has_shown_it(company, word):
    company.say(0x151, word)
    assert company.look(NOW_S + 0.1) is WORDS[word]


@pytest.mark.parametrize(
    ("shown", "mode"),
    [(4, OtherMode.MIT), (5, OtherMode.CPV), (6, OtherMode.MIT), (1, None), (0, None)],
)
def test_what_the_arm_shows_counts_without_a_word(company, shown, mode):
    assert company.look(NOW_S, move_mode=shown) is mode


def test_what_it_sent_is_told_while_it_pauses_and_the_arm_has_not_come_to_rest(company):
    company.say(0x471, "07 01 00 00 00 00 00 00")
    company.look(NOW_S + 0.1, at_rest=False)
    assert company.other.frames == "0x471"
    company.look(NOW_S + 5.0, at_rest=False)
    assert company.other.commands
    assert (company.other.frames, company.other.rate_hz) == ("0x471", 0)
    company.say(0x151, "01 01 32 00 00 00 00 00", NOW_S + 6.0)
    company.look(NOW_S + 6.1, at_rest=False)
    assert company.other.frames == "0x151"


def test_an_old_status_shows_nothing(company):
    assert company.look(NOW_S, NOW_S - 0.6, move_mode=4) is None
    assert company.look(NOW_S, NOW_S - 0.4, move_mode=4) is OtherMode.MIT


@pytest.mark.parametrize(("status_s", "mode"), [(0.29, OtherMode.MIT), (0.3, None)])
def test_three_tenths_later_the_arm_has_shown_what_it_took(company, status_s, mode):
    company.say(0x151, "01 04 00 AD 00 00 00 00")
    assert company.look(NOW_S + 0.4, NOW_S + status_s, move_mode=1) is mode


@pytest.mark.parametrize(
    ("changes", "mode"),
    [
        ({}, OtherMode.HIGH_FOLLOW),
        ({"arm_status": ArmStatusCode.NO_SOLUTION}, OtherMode.HIGH_FOLLOW),
        ({"move_mode": 0}, None),
        ({"move_mode": 2}, None),
        ({"control_mode": ControlMode.STANDBY}, None),
        ({"control_mode": ControlMode.TEACHING}, None),
        ({"arm_status": ArmStatusCode.EMERGENCY_STOP}, None),
    ],
)
def test_high_follow_lasts_until_the_arm_is_seen_to_have_left_it(company, changes, mode):
    company.say(0x151, "01 01 00 AD 00 00 00 00")
    assert company.look(NOW_S + 1.0) is OtherMode.HIGH_FOLLOW
    assert company.look(NOW_S + 2.0, **changes) is mode
    assert company.look(NOW_S + 3.0) is mode


def test_a_stop_ends_a_mode_that_the_arm_goes_on_showing(company):
    company.say(0x151, "01 04 00 AD 00 00 00 00")
    assert company.look(NOW_S + 1.0, move_mode=4) is OtherMode.MIT
    company.look(NOW_S + 2.0, move_mode=4, arm_status=ArmStatusCode.EMERGENCY_STOP)
    assert company.look(NOW_S + 3.0, move_mode=4) is None


@pytest.mark.parametrize("code", set(ArmStatusCode) - {ArmStatusCode.EMERGENCY_STOP})
def test_no_other_fault_ends_it(company, code):
    company.look(NOW_S, move_mode=4, arm_status=code)
    assert company.look(NOW_S + 1.0, move_mode=4) is OtherMode.MIT


@pytest.mark.parametrize(
    "frame",
    [
        (0x151, "01 04 00 AD 00 00 00 00"),
        (0x15C, "7F FF 7F F0 00 7F F7 F7"),
        (0x183, "77 70 6F 00 00 6F E8"),
    ],
)
def test_after_the_stop_a_new_word_or_setpoint_brings_it_back(company, frame):
    company.look(NOW_S, move_mode=4, arm_status=ArmStatusCode.EMERGENCY_STOP)
    assert company.look(NOW_S + 1.0, move_mode=4) is None
    company.say(*frame, at_s=NOW_S + 1.5)
    assert company.look(NOW_S + 2.0, move_mode=4) is OtherMode.MIT


# The way back ------------------------------------------------------------------------------------


@pytest.mark.parametrize("shown", [4, 5, 6])
def test_what_the_arm_is_told_to_leave_counts_again_if_it_stays(company, shown):
    company.say(0x151, "01 06 00 AD 00 00 00 00")
    assert company.look(NOW_S + 1.0, move_mode=shown) is not None
    company.other.leave_mode(NOW_S + 1.0)
    assert not company.other.drives
    assert company.look(NOW_S + 1.4, move_mode=shown) is None
    assert company.look(NOW_S + 1.5, move_mode=shown) is not None
    assert company.other.drives


def test_high_follow_is_left_for_good(company):
    company.say(0x151, "01 01 00 AD 00 00 00 00")
    assert company.look(NOW_S + 1.0) is OtherMode.HIGH_FOLLOW
    company.other.leave_mode(NOW_S + 1.0)
    assert company.look(NOW_S + 1.1) is None
    assert company.look(NOW_S + 9.0) is None
    company.say(0x151, "01 01 00 AD 00 00 00 00", NOW_S + 9.5)
    assert company.look(NOW_S + 10.0) is OtherMode.HIGH_FOLLOW


def test_a_setpoint_that_comes_after_it_brings_the_mode_back_at_once(company):
    company.look(NOW_S, move_mode=6)
    company.other.leave_mode(NOW_S + 0.1)
    company.say(0x15B, "7F FF 7F F0 00 7F F7 FF", NOW_S + 0.2)
    assert company.look(NOW_S + 0.3, move_mode=6) is OtherMode.MIT


def test_a_word_that_keeps_the_kind_of_motion_leaves_high_follow_in_force(company):
    """0x151 byte 1 = 0xFF: speed or mounting only."""
    company.say(0x151, "01 01 00 AD 00 00 00 00")
    assert company.look(NOW_S + 1.0) is OtherMode.HIGH_FOLLOW
    company.say(0x151, "01 FF 20 00 00 00 00 00", NOW_S + 1.1)
    assert company.look(NOW_S + 1.2) is OtherMode.HIGH_FOLLOW
    assert company.look(NOW_S + 2.0) is OtherMode.HIGH_FOLLOW
    assert company.look(NOW_S + 3.0, move_mode=0) is None


def test_a_word_that_keeps_the_kind_of_motion_begins_no_mode(company):
    company.say(0x151, "01 FF 20 AD 00 00 00 00")
    assert company.look(NOW_S + 0.1) is None


def test_an_answer_of_the_arm_is_no_other_host(company):
    """0x181 with 'a': the arm answers a question about CPV with the same identifier."""
    company.say(0x181, "61 6B 70 00 00 00 96")
    company.look(NOW_S + 0.1)
    assert not company.other.commands
    company.say(0x181, "77 70 6F 00 00 6F E8", NOW_S + 0.2)
    company.look(NOW_S + 0.3)
    assert company.other.commands


@pytest.mark.parametrize("word", ["", "01 04", "01 04 00"])
def test_a_word_too_short_to_be_one_says_nothing(company, word):
    company.say(0x151, word)
    assert company.look(NOW_S + 0.1) is None


def test_a_new_connection_starts_without_a_mode(company):
    company.look(NOW_S, move_mode=4)
    company.other.reconnected()
    assert company.other.mode is None
    assert company.look(NOW_S + 0.1, move_mode=4) is OtherMode.MIT


def test_over_a_new_connection_a_stop_of_before_ends_no_mode(company):
    company.look(NOW_S, move_mode=4, arm_status=ArmStatusCode.EMERGENCY_STOP)
    company.other.reconnected()
    assert company.look(NOW_S + 0.1, move_mode=4) is OtherMode.MIT


@pytest.mark.parametrize(
    ("period_s", "rate"),
    [(0.005, 200), (0.0047, 210), (0.1, 10), (0.3, 3), (1 / 20.6, 20), (1 / 19.4, 19)],
)
def test_its_rate_is_told_in_two_digits(company, period_s, rate):
    for k in range(6):
        company.say(0x155, "00" * 8, NOW_S + k * period_s)
    company.look(NOW_S + 5 * period_s)
    assert company.other.rate_hz == rate


def test_its_frames_are_named_while_they_are_of_late(company):
    company.say(0x155, "00" * 8, NOW_S)
    company.say(0x151, "01 01 32 00 00 00 00 00", NOW_S + 1.5)
    company.look(NOW_S + 1.9)
    assert company.other.frames == "0x151, 0x155"
    for later_s in (2.0, 2.5):
        company.look(NOW_S + later_s)
        assert company.other.frames == "0x151"


@pytest.mark.parametrize(
    ("after_s", "at_rest", "commands"),
    [(1.9, True, True), (2.0, True, False), (2.1, False, True), (60.0, False, True)],
)
def test_it_is_over_two_seconds_later_and_at_rest(company, after_s, at_rest, commands):
    company.say(0x155, "00" * 8)
    company.look(NOW_S)
    company.look(NOW_S + after_s, at_rest=at_rest)
    assert company.other.commands is commands
    assert (company.other.why_not() is not None) is commands


@pytest.mark.parametrize(
    ("after_s", "code"),
    [
        (0.49, OTHER_HOST_STREAMS),
        (0.5, None),
        (0.75, None),
        (2.1, NOBODY_ELSE),
    ],
)
def test_when_it_may_be_taken_over(company, after_s, code):
    company.say(0x155, "00" * 8)
    company.look(NOW_S)
    company.look(NOW_S + after_s)
    assert company.other.may_be_taken_over is (code is None)
    refusal = company.other.take_over()
    assert (None if refusal is None else refusal.reason) == code
    if code is None:
        assert company.other.why_not() is None


@pytest.mark.parametrize(
    ("mode", "reason"),
    [
        ("01 04 00 AD 00 00 00 00", OTHER_MODE),
        ("01 01 32 00 00 00 00 00", OTHER_HOST),
    ],
)
def test_the_reason_names_the_mode_before_the_host(company, mode, reason):
    company.say(0x151, mode)
    company.look(NOW_S + 0.1)
    assert company.other.why_not().reason == reason


def test_nobody_is_there_at_first(company):
    other = OtherCommand()
    assert not other.commands
    assert not other.is_leader
    assert other.why_not() is None
    assert not other.may_be_taken_over
    company.look(NOW_S)
    assert company.other.rate_hz == 0
    assert company.other.why_not() is None


def test_a_leader_arm_is_named_as_one(company):
    company.look(NOW_S)
    for k in range(10):
        for each in (0x151, 0x155, 0x156, 0x157, 0x159):
            company.say(each, "01 01 32 00 00 00 00 00", NOW_S + 0.005 * k)
        company.look(NOW_S + 0.005 * k)
    assert company.other.is_leader
    assert company.other.why_not().reason == LEADER_ARM
    company.say(0x150, "01 00 00 00 00 00 00 00", NOW_S + 0.05)
    company.look(NOW_S + 0.05)
    assert not company.other.is_leader
    assert company.other.why_not().reason == OTHER_HOST


def test_frames_that_are_read_late_are_named(company):
    company.say(0x151, "01 01 32 00 00 00 00 00")
    company.look(NOW_S + 2.5, at_rest=False)
    assert company.other.commands
    assert company.other.frames == "0x151"


def test_frames_for_another_arm_count_until_our_own_offset_is_known(company):
    company.say(0x155, "00" * 8, NOW_S)
    company.say(0x165, "00" * 8, NOW_S + 1.0)
    company.look(NOW_S + 1.0, offsets=(0x00, 0x10, 0x20))
    assert company.other.frames == "0x155, 0x165"
    company.look(NOW_S + 1.5)
    assert company.other.frames == "0x155"
    company.look(NOW_S + 1.5, offsets=(0x00, 0x10))
    assert company.other.frames == "0x155, 0x165"
    company.look(NOW_S + 1.5)
    assert company.other.last_s == NOW_S + 1.0  # what was heard was heard
    company.look(NOW_S + 2.9)
    assert company.other.commands
    company.look(NOW_S + 3.0)
    assert not company.other.commands
    company.look(NOW_S + 3.0, offsets=(0x20,))
    assert not company.other.commands


def test_each_motion_frame_of_it_is_new_once(company):
    def new(at_s):
        return company.other.observe(company.hosts.traffic(), HERE, ArmState(), at_s, at_rest=True)

    assert not new(NOW_S)
    company.say(0x155, "00" * 8, NOW_S)
    assert new(NOW_S)
    assert not new(NOW_S + 0.1)
    assert company.other.since_s == NOW_S
    company.say(0x155, "00" * 8, NOW_S + 0.2)
    assert new(NOW_S + 0.2)
    assert company.other.since_s == NOW_S
    assert company.other.last_s == NOW_S + 0.2


@pytest.mark.parametrize(
    ("identifier", "counts"),
    [(0x158, False), (0x159, True), (0x15A, False), (0x169, True), (0x155, False)],
)
def test_whether_it_has_moved_the_gripper(company, identifier, counts):
    company.say(identifier, "00" * 8, NOW_S + 0.1)
    company.look(NOW_S + 0.2, offsets=(0x00, 0x10))
    assert company.other.has_commanded_gripper(NOW_S) is counts
    assert not company.other.has_commanded_gripper(NOW_S + 0.1)
