"""Commands and questions: which goes first, which arm they are meant for, what ends them."""

from __future__ import annotations

import pytest

from armui.control.link.link_state import LINK_LOST, OFFLINE, LinkState
from armui.control.operating_state import BUSY
from armui.control.operations.started import (
    ARM_CHANGED,
    ENDED_BY_STOP,
    ORDER_TOO_LATE,
    SETTING_NOT_READ_BACK,
    SETTING_UNANSWERED,
)
from armui.control.requests.transactions import Transaction
from tests.control.transaction_line import BEGIN_S, INDEX, NO, OTHER_INDEX, STEP_S, frame, question
from tests.moments import now

# Questions ----------------------------------------------------------------------------------------


def test_a_question_is_asked_and_read(program):
    program.line.submit(program.question("a", 3))
    assert program.sent == [(0.0, (question(3),), 0.5)]
    program.wait(0.25)
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("a", None)]


def test_an_unanswered_question_is_asked_twice(program):
    program.line.submit(program.question("a"))
    program.wait(1.5)
    assert [at_s for at_s, _, _ in program.sent] == [0.0, 0.5]
    assert program.done == [("a", SETTING_NOT_READ_BACK)]


def test_a_question_waits_as_long_as_it_must(program):
    program.line.submit(program.question("a", 1), program.question("b", 2))
    program.wait(1.0)
    assert program.done == [("a", SETTING_NOT_READ_BACK)]
    assert program.frames[-1] == (question(2),)
    program.heard("b")
    program.wait(STEP_S)
    assert program.done[-1] == ("b", None)


def test_what_failed_while_it_was_put_is_put_again(program, monkeypatch):
    def fail(*_):
        raise RuntimeError("planted")

    with monkeypatch.context() as patched:
        patched.setattr(program.connection, "send", fail)
        with pytest.raises(RuntimeError, match="planted"):
            program.line.submit(program.question("a", 3))
    program.line.submit(program.order("b", 4))
    with monkeypatch.context() as patched:
        patched.setattr(program.line, "_why_another_arm", fail)
        with pytest.raises(RuntimeError, match="planted"):
            program.wait(1.0)
    program.wait(3.0)
    assert sorted(name for name, _ in program.done) == ["a", "b"]


def test_a_question_may_be_put_to_an_arm_that_is_not_heard(program):
    program.connection.arm = None
    program.line.submit(program.question("a"))
    assert program.frames == [(question(1),)]


def test_a_question_put_before_the_arm_fell_silent_goes_on(program):
    program.line.submit(program.question("a"))
    program.connection.arm = None
    program.wait(0.5)
    assert len(program.sent) == 2


def test_a_question_is_not_put_to_another_arm(program):
    program.line.submit(program.question("a"))
    program.connection.arm = 2
    program.wait(0.5)
    assert program.done == [("a", ARM_CHANGED)]
    assert len(program.sent) == 1


# Another arm, another moment ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arm", "link", "code"),
    [
        (None, LinkState.OFFLINE, OFFLINE),
        (2, LinkState.ONLINE, ARM_CHANGED),
    ],
)
def test_what_was_meant_for_one_arm_is_not_said_to_another(program, arm, link, code):
    program.line.submit(program.order("a", 1))
    program.connection.arm, program.connection.link = arm, link
    program.wait(0.5)
    assert program.done == [("a", code)]
    assert len(program.sent) == 1


def test_what_was_asked_for_without_an_arm_is_said_to_any(program):
    program.connection.arm = None
    program.line.submit(program.order("a", 1))
    program.connection.arm = 2
    program.wait(0.5)
    assert len(program.sent) == 2


def test_what_was_checked_is_checked_again_before_each_frame(program):
    reasons = [None, NO]
    program.line.submit(program.order("a", 1, recheck=lambda: reasons.pop(0)))
    program.wait(0.5)
    assert len(program.sent) == 1
    assert program.done == [("a", BUSY)]


def test_it_is_checked_by_the_newest_operating_state(program):
    looks = []
    program.line.submit(program.order("a", 1, recheck=lambda: looks.append(program.looks)))
    program.wait(0.5)
    assert looks == [1, 2]


def test_what_is_not_right_at_once_is_not_sent(program):
    program.line.submit(program.order("a", 1, recheck=lambda: NO), program.order("b", 2))
    assert program.done == [("a", BUSY)]
    assert program.frames == [(frame(2),)]


# Several ------------------------------------------------------------------------------------------


def test_the_steps_of_an_action_follow_one_another(program):
    program.line.submit(program.order("a", 1), program.order("b", 2), program.order("c", 3))
    assert program.frames == [(frame(1),)]
    program.answer()
    program.answer()
    assert program.frames == [(frame(1),), (frame(2),), (frame(3),)]
    program.answer()
    assert program.done == [("a", None), ("b", None), ("c", None)]


def test_a_further_step_has_its_second_from_its_own_beginning(program):
    program.line.submit(program.order("a", 1), program.order("b", 2))
    program.wait(0.75)
    program.answer()
    program.wait(0.5)
    assert [(at_s, frames) for at_s, frames, _ in program.sent[2:]] == [
        (0.75, (frame(2),)),
        (1.25, (frame(2),)),
    ]


def test_a_further_step_may_begin_later_than_a_second_after_the_press(program):
    reading = program.reading("a")
    program.line.submit(program.order("a", 1, read_back=reading), program.order("b", 2))
    program.wait(0.75)
    program.answer()
    program.wait(0.75)
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("a", None)]
    assert program.frames[-1] == (frame(2),)


def test_a_new_action_comes_before_the_further_steps_of_an_older(program):
    program.line.submit(program.order("a", 1), program.order("b", 2))
    program.line.submit(program.order("c", 3))
    program.answer()
    assert program.frames[-1] == (frame(3),)
    program.answer()
    assert program.frames[-1] == (frame(2),)
    program.answer()
    assert [name for name, _ in program.done] == ["a", "c", "b"]


@pytest.mark.parametrize(("after_s", "begins"), [(0.984375, True), (1.0, False), (1.5, False)])
def test_an_action_begins_within_a_second_or_not_at_all(program, after_s, begins):
    program.line.submit(program.order("a", 1, index=OTHER_INDEX))
    program.line.submit(program.order("b", 2))
    program.now_s = BEGIN_S + after_s
    program.answer(OTHER_INDEX)
    assert ((frame(2),) in program.frames) is begins
    assert (("b", ORDER_TOO_LATE) in program.done) is not begins


def test_what_is_too_late_is_told_while_another_is_under_way(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.line.submit(program.order("b", 2))
    program.wait(0.984375)
    assert program.done == []
    program.wait(STEP_S)
    assert program.done == [("b", ORDER_TOO_LATE)]


def test_a_command_that_waited_may_be_sent_no_later_than_a_second_after_its_press(program):
    program.line.submit(program.order("a", 1))
    program.line.submit(program.order("b", 2))
    program.wait(0.75)
    program.answer()
    assert program.sent[-1] == (0.75, (frame(2),), 0.25)
    program.wait(0.75)
    assert program.frames.count((frame(2),)) == 1
    assert program.done[-1] == ("b", SETTING_UNANSWERED)


def test_a_command_never_waits_for_a_question(program):
    program.line.submit(program.question("a", 1))
    program.line.submit(program.question("b", 2))
    program.wait(0.25)
    program.line.submit(program.order("c", 3))
    assert program.frames == [(question(1),), (frame(3),)]
    program.wait(0.25)
    program.answer()
    # what was set aside is asked for again, before the questions behind it
    assert program.frames[2:] == [(question(1),)]
    program.heard("a")
    program.wait(STEP_S)
    assert program.frames[3:] == [(question(2),)]
    assert [name for name, _ in program.done] == ["c", "a"]


def test_a_command_does_not_wait_for_a_value_that_is_read_back_either(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.answer()
    program.line.submit(program.order("b", 2))
    assert program.frames == [(frame(1),), (question(1),), (frame(2),)]
    program.answer()
    assert program.frames[3:] == [(question(1),)]
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("b", None), ("a", None)]


def test_a_value_set_aside_is_read_however_late(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.answer()
    program.wait(0.5)
    program.line.submit(program.order("b", 2))
    program.wait(1.0)
    assert program.done == [("b", SETTING_UNANSWERED)]
    assert program.frames[-1] == (question(1),)
    program.heard("a")
    program.wait(STEP_S)
    assert program.done[-1] == ("a", None)


def test_a_question_does_not_set_another_aside(program):
    program.line.submit(program.question("a", 1))
    program.line.submit(program.question("b", 2))
    assert program.frames == [(question(1),)]


def test_a_command_waits_for_the_answer_to_another(program):
    program.line.submit(program.order("a", 1))
    program.line.submit(program.order("b", 2))
    assert program.frames == [(frame(1),)]


def test_commands_come_before_questions(program):
    program.line.submit(program.order("a", 1), program.question("q"), program.order("b", 2))
    program.answer()
    assert program.frames == [(frame(1),), (frame(2),)]
    program.answer()
    assert program.frames[-1] == (question(1),)


# Ends ---------------------------------------------------------------------------------------------


def test_a_stop_ends_those_that_say_so(program):
    program.line.submit(program.order("a", 1, ends_with_stop=True), program.order("b", 2))
    program.line.submit(program.order("c", 3, ends_with_stop=True))
    program.line.halt()
    assert program.done == [("c", ENDED_BY_STOP), ("a", ENDED_BY_STOP)]
    assert program.frames == [(frame(1),), (frame(2),)]
    program.line.halt()
    assert len(program.done) == 2
    program.answer()
    assert program.done[-1] == ("b", None)


def test_a_question_that_a_stop_ends_is_not_asked_afterwards(program):
    program.line.submit(
        program.order("a", 1),
        program.order("q", read_back=program.reading("q"), ends_with_stop=True),
    )
    program.line.halt()
    program.answer()
    program.wait(2.0)
    assert program.frames == [(frame(1),)]
    assert program.done == [("q", ENDED_BY_STOP), ("a", None)]


def test_a_stop_with_nothing_under_way(program):
    program.line.halt()
    program.line.follow_arm()
    assert program.done == []


def test_over_a_lost_link_nothing_survives(program):
    program.line.submit(program.order("a", 1), program.order("b", 2), program.question("c"))
    program.line.forget_arm()
    assert program.done == [
        ("a", LINK_LOST),
        ("b", LINK_LOST),
        ("c", LINK_LOST),
    ]
    assert program.line._task is None
    program.answer()
    program.wait(2.0)
    assert len(program.done) == 3
    assert program.frames == [(frame(1),)]
    program.line.submit(program.order("d", 4))
    program.answer()
    assert program.frames == [(frame(1),), (frame(4),)]
    assert program.line._task is None


def test_what_is_being_set_that_a_motion_counts_on(program):
    """It is counted once when it is first sent: not when it waits, is sent again or read back."""
    assert (now(program.line.altering), now(program.line.alterations)) == (None, 0)
    setting = program.order("b", 2, alters="limits", read_back=program.reading("b"))
    program.line.submit(program.order("a", 1), setting)
    assert (now(program.line.altering), now(program.line.alterations)) == ("limits", 0)
    program.answer()
    assert (now(program.line.altering), now(program.line.alterations)) == ("limits", 1)
    program.wait(0.5)
    program.answer()
    assert program.frames[1:] == [(frame(2),), (frame(2),), (question(1),)]
    program.heard("b")
    program.wait(STEP_S)
    assert (program.line.altering, program.line.alterations) == (None, 1)


def test_what_ends_may_begin_another(program):
    program.line.submit(
        Transaction((frame(1),), lambda _refusal: program.line.submit(program.order("b", 2)), INDEX)
    )
    program.answer()
    assert program.frames == [(frame(1),), (frame(2),)]
    assert program.line._task is not None
