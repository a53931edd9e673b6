"""Commands that are answered: how one is sent, answered, read back and given up."""

from __future__ import annotations

import pytest

from armui.control.link.link_state import LINK_LOST
from armui.control.operating_state import BUSY
from armui.control.operations.started import SETTING_NOT_READ_BACK, SETTING_UNANSWERED, Started
from tests.control.transaction_line import (
    BEGIN_S,
    INDEX,
    LOWER_INDEX,
    NO,
    OTHER_INDEX,
    STEP_S,
    frame,
    question,
)

# One order ----------------------------------------------------------------------------------------


def test_an_order_is_sent_at_once_and_done_when_it_is_answered(program):
    program.line.submit(program.order("a", 1, 2))
    assert program.sent == [(0.0, (frame(1), frame(2)), 0.5)]
    assert program.line._task is not None
    assert program.done == []
    program.answer()
    assert program.done == [("a", None)]
    assert program.line._task is None


@pytest.mark.parametrize(
    ("index", "name"),
    [
        (OTHER_INDEX, "SettingResponse"),
        (LOWER_INDEX, "SettingResponse"),
        (INDEX, "JointLimits"),
        (INDEX, "Version"),
    ],
)
def test_another_answer_is_not_its_own(program, index, name):
    program.line.submit(program.order("a", 1))
    program.answer(index, name)
    assert program.line._task is not None
    assert program.done == []


def test_an_answer_that_nobody_waits_for_changes_nothing(program):
    program.answer()
    assert program.done == []


def test_an_answer_may_speak_against_it_and_is_kept(program):
    started = Started("a")
    program.line.submit(program.order("a", 1, against=lambda _answer: NO, started=started))
    program.wait(STEP_S)
    program.answer()
    assert program.done == [("a", BUSY)]
    assert (started.answer.at_s, started.answer.params) == (program.now_s, {"index": "0x79"})


def test_an_order_without_an_answer_is_done_when_it_is_sent(program):
    program.line.submit(program.order("a", 1, index=None))
    assert program.frames == [(frame(1),)]
    assert program.done == [("a", None)]


def test_unanswered_it_is_sent_twice_and_given_up(program):
    program.line.submit(program.order("a", 1))
    program.wait(0.484375)
    assert len(program.sent) == 1
    program.wait(STEP_S)
    assert program.sent == [(0.0, (frame(1),), 0.5), (0.5, (frame(1),), 0.5)]
    program.wait(0.484375)
    assert program.done == []
    program.wait(STEP_S)
    assert program.done == [("a", SETTING_UNANSWERED)]
    assert len(program.sent) == 2


@pytest.mark.parametrize(("attempts", "times"), [(1, [0.0]), (2, [0.0, 0.5]), (9, [0.0, 0.5])])
def test_it_is_never_sent_later_than_a_second_after_the_press(program, attempts, times):
    program.line.submit(program.order("a", 1, attempts=attempts))
    program.wait(5.0)
    assert [at_s for at_s, _, _ in program.sent] == times
    assert program.done == [("a", SETTING_UNANSWERED)]


def test_a_repeat_may_wait_no_longer_than_until_then(program):
    """Sent again 0.625 s after the press it has 0.375 s left."""
    program.line.submit(program.order("a", 1))
    program.now_s += 0.625
    program.line.follow_arm()
    assert program.sent[1] == (0.625, (frame(1),), 0.375)


def test_an_answer_to_the_repeat_will_do(program):
    program.line.submit(program.order("a", 1))
    program.wait(0.75)
    program.answer()
    assert program.done == [("a", None)]


def test_what_cannot_be_sent_is_over(program):
    program.connection.works = False
    program.line.submit(program.order("a", 1))
    assert program.done == [("a", LINK_LOST)]
    assert program.line._task is None


def test_without_an_answer_to_await_it_is_over_all_the_same(program):
    program.connection.works = False
    program.line.submit(program.order("a", 1, index=None))
    assert program.done == [("a", LINK_LOST)]


# Read back ----------------------------------------------------------------------------------------


def test_what_was_answered_is_read_back(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.wait(0.25)
    program.answer()
    assert program.done == []
    assert program.sent[1] == (0.25, (question(1),), 0.5)
    program.wait(0.25)
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("a", None)]


def test_the_value_read_decides(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a", against=NO)))
    program.answer()
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("a", BUSY)]


def test_a_value_of_before_the_question_is_none(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.heard("a")
    program.wait(0.25)
    program.answer()
    program.wait(0.25)
    assert program.done == []


def test_an_order_without_an_answer_is_read_back_at_once(program):
    program.line.submit(program.order("a", 1, index=None, read_back=program.reading("a")))
    assert program.frames == [(frame(1),), (question(1),)]
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("a", None)]


def test_it_is_asked_for_twice(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a"), attempts=1))
    program.answer()
    program.wait(0.484375)
    assert len(program.sent) == 2
    program.wait(STEP_S)
    assert program.sent[1:] == [(0.0, (question(1),), 0.5), (0.5, (question(1),), 0.5)]
    program.wait(0.5)
    assert program.done == [("a", SETTING_NOT_READ_BACK)]


def test_an_answer_to_the_first_question_that_is_seen_after_the_second_will_do(program):
    program.line.submit(program.question("a"))
    program.wait(0.5)
    assert len(program.sent) == 2
    program.heard_s["a"] = BEGIN_S + 0.484375
    program.wait(STEP_S)
    assert program.done == [("a", None)]


def test_an_answer_to_a_setting_is_none_to_a_question(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.answer()
    program.answer()
    assert len(program.sent) == 2
    assert program.done == []


@pytest.mark.parametrize(
    ("against", "proves", "code"),
    [
        (None, True, None),
        (None, False, SETTING_UNANSWERED),
        (NO, True, SETTING_UNANSWERED),
        (NO, False, SETTING_UNANSWERED),
    ],
)
def test_unanswered_the_arm_is_asked_what_it_holds(program, against, proves, code):
    reading = program.reading("a", against=against, proves=proves)
    program.line.submit(program.order("a", 1, read_back=reading))
    program.wait(1.0)
    assert program.frames == [(frame(1),), (frame(1),), (question(1),)]
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("a", code)]


def test_answered_a_value_that_proves_nothing_speaks_for_it_all_the_same(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a", proves=False)))
    program.answer()
    program.heard("a")
    program.wait(STEP_S)
    assert program.done == [("a", None)]


def test_unanswered_and_not_read_the_missing_answer_is_told(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.wait(3.0)
    assert program.frames == [(frame(1),)] * 2 + [(question(1),)] * 2
    assert program.done == [("a", SETTING_UNANSWERED)]
