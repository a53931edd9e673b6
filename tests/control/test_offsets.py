"""Which identifiers the arm uses (0x470): what is sent, what is heard, and what is in use then."""

from __future__ import annotations

from typing import Any

import pytest

from armui.arm.state import ArmState, Reading
from armui.control.link.offsets import OffsetFollower, RequestedOffset
from armui.protocol.addressing import OFFSETS, Addressing
from armui.protocol.codes import ArmStatusCode, ControlMode
from tests.control.heard_arm import status

BEGIN_S = 0.25
STEP_S = 0.015625
PLAIN = Addressing()
COMMANDS_MOVE = Addressing(0x00, 0x10)
FEEDBACK_MOVES = Addressing(0x10, 0x10)


class Arm:
    """An arm as heard under its feedback offset, and who follows its offsets."""

    def __init__(self) -> None:
        self.follower = OffsetFollower()
        self.now_s = BEGIN_S
        self.heard_under: set[int] = {0x00}
        self.status: dict[str, Any] = {"control_mode": ControlMode.STANDBY}
        self._heard_s: dict[int, float] = {}
        self.moved: list[float] = []

    def look(self, *, came: bool = False) -> bool:
        """Advance once; whether other identifiers are in use from now on."""
        for offset in self.heard_under:
            self._heard_s[offset] = self.now_s
        own_s = self._heard_s.get(self.follower.addressing.feedback_offset)
        state = ArmState(
            status=None if own_s is None else Reading(status(**self.status), own_s),
            status_heard_s=tuple(self._heard_s.get(each) for each in OFFSETS),
        )
        moved = self.follower.follow_arm(state, self.now_s, came=came)
        if moved:
            self.moved.append(self.now_s)
        return moved

    def wait(self, seconds: float) -> None:
        """Advance every 1/64 s."""
        end_s = self.now_s + seconds
        while self.now_s < end_s:
            self.now_s += STEP_S
            self.look()

    def request(self, addressing: Addressing, *, ends_input: bool = False) -> None:
        """Send offsets to the arm."""
        more = {"ends_input": True} if ends_input else {}
        self.follower.request(addressing, self.now_s, **more)

    def answer(self) -> None:
        """The arm says that it keeps them."""
        self.follower.answered(self.now_s)

    @property
    def addressing(self) -> Addressing:
        """What is in use."""
        return self.follower.addressing

    @property
    def certain(self) -> bool:
        """Whether commands reach the arm."""
        return self.follower.certain


@pytest.fixture
def arm():
    arm = Arm()
    arm.look(came=True)
    arm.wait(1.0)
    return arm


def test_an_arm_as_delivered(arm):
    assert OffsetFollower().certain
    assert arm.addressing == PLAIN
    assert arm.certain
    assert arm.follower.requested is None
    assert arm.moved == []


# The commands move --------------------------------------------------------------------------------


def test_commands_that_move_are_uncertain_until_the_arm_has_answered_in_standby(arm):
    arm.request(COMMANDS_MOVE)
    assert arm.follower.requested == RequestedOffset(COMMANDS_MOVE, arm.now_s)
    assert not arm.certain
    arm.wait(2.0)
    assert not arm.certain
    arm.answer()
    arm.wait(0.046875)
    assert not arm.certain  # the status may be of before
    arm.wait(STEP_S)
    assert arm.addressing == COMMANDS_MOVE
    assert arm.certain
    assert arm.follower.requested is None
    assert len(arm.moved) == 1


def test_a_status_of_exactly_a_twentieth_of_a_second_later_was_made_after_it():
    follower = OffsetFollower()
    follower.request(COMMANDS_MOVE, 0.0)
    follower.answered(0.0)
    heard = Reading(status(control_mode=ControlMode.STANDBY), 0.05)
    state = ArmState(status=heard, status_heard_s=(0.05, None, None))
    assert follower.follow_arm(state, 0.05, came=False)


@pytest.mark.parametrize(
    "changes",
    [
        {"control_mode": ControlMode.CAN_CONTROL},
        {"control_mode": ControlMode.STANDBY, "arm_status": ArmStatusCode.EMERGENCY_STOP},
    ],
    ids=["CAN control", "stopped"],
)
def test_outside_standby_the_arm_takes_no_offset(arm, changes):
    arm.status = changes
    arm.request(COMMANDS_MOVE)
    arm.answer()
    arm.wait(1.0)
    assert not arm.certain
    assert arm.addressing == PLAIN
    arm.status = {"control_mode": ControlMode.STANDBY}
    arm.wait(STEP_S)
    assert arm.addressing == COMMANDS_MOVE


def test_another_fault_than_a_stop_does_not_keep_it_from_taking_it(arm):
    arm.status = {"control_mode": ControlMode.STANDBY, "arm_status": ArmStatusCode.NO_SOLUTION}
    arm.request(COMMANDS_MOVE)
    arm.answer()
    arm.wait(0.1)
    assert arm.addressing == COMMANDS_MOVE


def test_switched_on_again_it_uses_what_it_keeps(arm):
    arm.status = {"control_mode": ControlMode.CAN_CONTROL}
    arm.request(COMMANDS_MOVE)
    arm.answer()
    arm.wait(1.0)
    assert arm.look(came=True)
    assert arm.addressing == COMMANDS_MOVE
    assert arm.certain


def test_switched_on_again_without_having_answered_nothing_is_known(arm):
    arm.request(COMMANDS_MOVE)
    arm.wait(1.0)
    assert not arm.look(came=True)
    assert arm.addressing == PLAIN
    assert not arm.certain


def test_a_teaching_input_that_gives_feedback_has_heard(arm):
    arm.request(COMMANDS_MOVE, ends_input=True)
    arm.wait(1.0)
    assert arm.addressing == PLAIN
    assert arm.look(came=True)
    assert arm.addressing == COMMANDS_MOVE
    assert arm.certain


def test_its_feedback_of_before_proves_nothing(arm):
    arm.heard_under = set()
    arm.wait(STEP_S)
    arm.request(COMMANDS_MOVE, ends_input=True)
    assert not arm.look(came=True)
    assert arm.addressing == PLAIN


def test_the_answer_is_of_what_was_sent_last(arm):
    arm.answer()
    assert arm.follower.requested is None
    arm.request(COMMANDS_MOVE)
    arm.answer()
    arm.request(Addressing(0x00, 0x20))
    arm.wait(1.0)
    assert arm.addressing == PLAIN
    arm.answer()
    arm.wait(0.1)
    assert arm.addressing == Addressing(0x00, 0x20)


def test_without_a_status_nothing_is_taken():
    follower = OffsetFollower()
    follower.request(COMMANDS_MOVE, BEGIN_S)
    follower.answered(BEGIN_S)
    state = ArmState(status_heard_s=(BEGIN_S + 1.0, None, None))
    assert not follower.follow_arm(state, BEGIN_S + 1.0, came=False)


def test_what_is_in_use_already_needs_no_proof(arm):
    arm.request(PLAIN)
    assert arm.follower.requested is None
    assert arm.certain


def test_what_was_in_use_needs_proof_after_another_was_sent(arm):
    arm.request(COMMANDS_MOVE)
    arm.request(PLAIN)
    assert not arm.certain
    arm.answer()
    arm.wait(0.1)
    assert arm.certain
    assert arm.addressing == PLAIN
    assert arm.moved == []


def test_an_offset_that_is_not_known_needs_proof_though_it_is_in_use(arm):
    arm.heard_under = {0x10}
    arm.wait(1.0)
    assert arm.addressing == Addressing(0x10, 0x00)
    assert not arm.certain
    arm.request(Addressing(0x10, 0x00))
    assert arm.follower.requested is not None
    arm.answer()
    arm.wait(0.1)
    assert arm.certain


# The feedback moves -------------------------------------------------------------------------------


def test_while_the_old_feedback_is_heard_old_commands_reach_the_arm(arm):
    arm.request(FEEDBACK_MOVES)
    assert arm.certain
    arm.answer()
    arm.wait(1.0)
    assert arm.certain
    assert arm.addressing == PLAIN


def test_new_feedback_proves_what_was_sent_without_an_answer(arm):
    arm.request(FEEDBACK_MOVES)
    arm.heard_under = {0x10}
    arm.wait(0.46875)
    assert arm.addressing == PLAIN
    arm.wait(0.0625)
    assert arm.addressing == FEEDBACK_MOVES
    assert arm.certain
    assert arm.follower.requested is None
    assert len(arm.moved) == 1


@pytest.mark.parametrize("offset", [0x10, 0x20])
def test_feedback_nobody_asked_for_tells_nothing_of_the_commands(arm, offset):
    arm.heard_under = {offset}
    arm.wait(1.0)
    assert arm.addressing == Addressing(offset, 0x00)
    assert not arm.certain
    assert len(arm.moved) == 1


def test_feedback_other_than_asked_for_is_followed_and_proves_nothing(arm):
    arm.request(FEEDBACK_MOVES)
    arm.heard_under = {0x20}
    arm.wait(1.0)
    assert arm.addressing == Addressing(0x20, 0x00)
    assert not arm.certain
    assert arm.follower.requested is None


def test_two_arms_are_never_mixed(arm):
    arm.heard_under = {0x00, 0x10, 0x20}
    arm.wait(2.0)
    assert arm.addressing == PLAIN
    assert arm.moved == []


def test_of_two_others_the_one_asked_for_is_taken(arm):
    arm.request(Addressing(0x20, 0x00))
    arm.heard_under = {0x10, 0x20}
    arm.wait(1.0)
    assert arm.addressing == Addressing(0x20, 0x00)
    assert arm.certain


def test_other_feedback_of_long_ago_is_none(arm):
    arm.heard_under = {0x00, 0x10}
    arm.wait(0.5)
    arm.heard_under = {0x00}
    arm.wait(1.0)
    arm.heard_under = set()
    arm.wait(2.0)
    assert arm.addressing == PLAIN
    assert arm.moved == []


def test_of_two_others_nobody_asked_for_the_first_is_taken(arm):
    arm.heard_under = {0x10, 0x20}
    arm.wait(1.0)
    assert arm.addressing == Addressing(0x10, 0x00)


def test_a_look_that_comes_late_sees_it_as_well(arm):
    arm.heard_under = {0x10}
    arm.now_s += 0.7
    assert arm.look()


def test_feedback_that_is_to_move_back_has_not_moved_while_it_is_heard(arm):
    arm.request(FEEDBACK_MOVES)
    arm.heard_under = {0x10}
    arm.wait(1.0)
    arm.request(PLAIN)
    assert arm.certain
    arm.answer()
    arm.wait(1.0)
    assert arm.addressing == FEEDBACK_MOVES
    arm.heard_under = {0x00}
    arm.wait(1.0)
    assert arm.addressing == PLAIN
    assert arm.certain


def test_an_arm_that_falls_silent_keeps_its_identifiers(arm):
    arm.heard_under = set()
    arm.wait(5.0)
    assert arm.addressing == PLAIN
    assert arm.certain


def test_each_offset_may_be_left_again(arm):
    for offset in (0x10, 0x20, 0x00, 0x20, 0x10):
        arm.heard_under = {offset}
        arm.wait(1.0)
        assert arm.addressing.feedback_offset == offset


@pytest.mark.parametrize("anew", ["listen anew", "came", "first look", "moved"])
def test_the_known_feedback_has_half_a_second_to_be_heard(anew):
    arm = Arm()
    arm.heard_under = {0x10}
    offset, expected = 0x00, 0x10
    if anew == "listen anew":
        arm.look()
        arm.now_s += 10.0
        arm.follower.listen_anew(arm.now_s)
    elif anew == "came":
        arm.look()
        arm.now_s += 10.0
        arm.look(came=True)
    elif anew == "moved":
        arm.wait(1.0)
        arm.now_s = arm.moved[0]
        arm.heard_under = {0x20}
        arm._heard_s.clear()
        offset, expected = 0x10, 0x20
    else:
        arm.look()
    arm.wait(0.484375)
    assert arm.addressing.feedback_offset == offset
    arm.wait(STEP_S)
    assert arm.addressing.feedback_offset == expected


# Another arm, for all that is known ---------------------------------------------------------------


def test_an_arm_that_came_may_be_another_than_was_set(arm):
    arm.request(COMMANDS_MOVE)
    arm.answer()
    arm.wait(0.1)
    assert arm.certain
    arm.look(came=True)
    assert arm.addressing == COMMANDS_MOVE
    assert not arm.certain


def test_of_an_arm_without_offset_nothing_needs_to_be_proven(arm):
    assert not arm.look(came=True)
    assert arm.certain
