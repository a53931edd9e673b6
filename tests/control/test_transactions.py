"""Commands that are answered: their order, their time limits, what is checked before each frame."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from armui.arm.refusal import Refusal
from armui.control.operating_state import LinkState
from armui.control.requests.transactions import ReadBack, Transaction, TransactionQueue
from armui.protocol.codes import SettingIndex
from armui.protocol.frame import Frame

BEGIN_S = 0.25
STEP_S = 0.015625
INDEX = SettingIndex.END_LIMIT_SETTING
LOWER_INDEX = int(INDEX) - 1
OTHER_INDEX = int(INDEX) + 1
NO = Refusal("no")


def frame(number):
    return Frame(0x475, bytes([number]))


def question(number):
    return Frame(0x472, bytes([number]))


class Signal:
    """Stands for the connection's signal."""

    def connect(self, slot) -> None:
        self.emit = slot


class Connection:
    """Stands for the way to the arm."""

    def __init__(self, program) -> None:
        self._program = program
        self.answered = Signal()
        self.arm: int | None = 1
        self.link = LinkState.ONLINE
        self.works = True

    def send(self, frames, keep_s=None) -> bool:
        self._program.sent.append((self._program.now_s - BEGIN_S, tuple(frames), keep_s))
        return self.works


class Program:
    """The line of orders and all it needs, with what came of them.

    Attributes:
        sent: When, what, and how long it may wait.
        done: Name and outcome of each order, in the order in which they ended.
        read_s: When the value that is read back was heard last, by order.
    """

    def __init__(self) -> None:
        self.now_s = BEGIN_S
        self.sent: list = []
        self.done: list = []
        self.heard_s: dict[str, float] = {}
        self.connection = Connection(self)
        self.line = TransactionQueue(
            SimpleNamespace(
                connection=self.connection, clock=lambda: self.now_s, state=lambda: self.heard_s
            )
        )

    def order(self, name, *numbers, **fields) -> Transaction:
        """A command of some frames, or a question without any."""
        fields.setdefault("index", INDEX)
        return Transaction(
            tuple(frame(each) for each in numbers),
            lambda refusal: self.done.append((name, refusal and refusal.code)),
            **fields,
        )

    def reading(self, name, number=None, against=None, *, proves=True) -> ReadBack:
        """How an order is checked: by a question, and what speaks against what was read."""
        return ReadBack(
            (question(number or 1),),
            lambda state, since_s: state.get(name, -1.0) >= since_s,
            lambda _state: against,
            **({} if proves else {"proves": False}),
        )

    def question(self, name, number=None, against=None) -> Transaction:
        """Something that is only to be read."""
        return self.order(name, read_back=self.reading(name, number, against))

    def heard(self, name) -> None:
        """The value that an order reads is heard now."""
        self.heard_s[name] = self.now_s

    def answer(self, index=INDEX, name="SettingResponse") -> None:
        """The arm answers."""
        message = SimpleNamespace(name=name, signals={"Index": int(index)})
        self.connection.answered.emit(message)

    def wait(self, seconds) -> None:
        """Advance every 1/64 s."""
        end_s = self.now_s + seconds
        while self.now_s < end_s:
            self.now_s += STEP_S
            self.line.advance()

    @property
    def frames(self) -> list:
        """What was sent, each call's frames."""
        return [frames for _, frames, _ in self.sent]


@pytest.fixture
def program():
    return Program()


# One order ----------------------------------------------------------------------------------------


def test_an_order_is_sent_at_once_and_done_when_it_is_answered(program):
    program.line.submit(program.order("a", 1, 2))
    assert program.sent == [(0.0, (frame(1), frame(2)), 0.5)]
    assert program.line.busy
    assert program.done == []
    program.answer()
    assert program.done == [("a", None)]
    assert not program.line.busy


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
    assert program.line.busy
    assert program.done == []


def test_an_answer_that_nobody_waits_for_changes_nothing(program):
    program.answer()
    assert program.done == []


def test_an_answer_may_speak_against_it(program):
    program.line.submit(program.order("a", 1, against=lambda _answer: NO))
    program.answer()
    assert program.done == [("a", "no")]


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
    assert program.done == [("a", "setting_unanswered")]
    assert len(program.sent) == 2


@pytest.mark.parametrize(("attempts", "times"), [(1, [0.0]), (2, [0.0, 0.5]), (9, [0.0, 0.5])])
def test_it_is_never_sent_later_than_a_second_after_the_press(program, attempts, times):
    program.line.submit(program.order("a", 1, attempts=attempts))
    program.wait(5.0)
    assert [at_s for at_s, _, _ in program.sent] == times
    assert program.done == [("a", "setting_unanswered")]


def test_a_repeat_may_wait_no_longer_than_until_then(program):
    """Sent again 0.625 s after the press it has 0.375 s left."""
    program.line.submit(program.order("a", 1))
    program.now_s += 0.625
    program.line.advance()
    assert program.sent[1] == (0.625, (frame(1),), 0.375)


def test_an_answer_to_the_repeat_will_do(program):
    program.line.submit(program.order("a", 1))
    program.wait(0.75)
    program.answer()
    assert program.done == [("a", None)]


def test_what_cannot_be_sent_is_over(program):
    program.connection.works = False
    program.line.submit(program.order("a", 1))
    assert program.done == [("a", "link_lost")]
    assert not program.line.busy


def test_without_an_answer_to_await_it_is_over_all_the_same(program):
    program.connection.works = False
    program.line.submit(program.order("a", 1, index=None))
    assert program.done == [("a", "link_lost")]


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
    assert program.done == [("a", "no")]


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
    assert program.done == [("a", "setting_not_read_back")]


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
        (None, False, "setting_unanswered"),
        (NO, True, "setting_unanswered"),
        (NO, False, "setting_unanswered"),
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
    assert program.done == [("a", "setting_unanswered")]


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
    assert program.done == [("a", "setting_not_read_back")]


def test_a_question_waits_as_long_as_it_must(program):
    program.line.submit(program.question("a", 1), program.question("b", 2))
    program.wait(1.0)
    assert program.done == [("a", "setting_not_read_back")]
    assert program.frames[-1] == (question(2),)
    program.heard("b")
    program.wait(STEP_S)
    assert program.done[-1] == ("b", None)


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
    assert program.done == [("a", "arm_changed")]
    assert len(program.sent) == 1


# Another arm, another moment ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arm", "link", "code"),
    [(None, LinkState.OFFLINE, "offline"), (2, LinkState.ONLINE, "arm_changed")],
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
    assert program.done == [("a", "no")]


def test_what_is_not_right_at_once_is_not_sent(program):
    program.line.submit(program.order("a", 1, recheck=lambda: NO), program.order("b", 2))
    assert program.done == [("a", "no")]
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
    assert (("b", "order_too_late") in program.done) is not begins


def test_what_is_too_late_is_told_while_another_is_under_way(program):
    program.line.submit(program.order("a", 1, read_back=program.reading("a")))
    program.line.submit(program.order("b", 2))
    program.wait(0.984375)
    assert program.done == []
    program.wait(STEP_S)
    assert program.done == [("b", "order_too_late")]


def test_a_command_that_waited_may_be_sent_no_later_than_a_second_after_its_press(program):
    program.line.submit(program.order("a", 1))
    program.line.submit(program.order("b", 2))
    program.wait(0.75)
    program.answer()
    assert program.sent[-1] == (0.75, (frame(2),), 0.25)
    program.wait(0.75)
    assert program.frames.count((frame(2),)) == 1
    assert program.done[-1] == ("b", "setting_unanswered")


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
    assert program.done == [("c", "ended_by_stop"), ("a", "ended_by_stop")]
    assert program.frames == [(frame(1),), (frame(2),)]
    program.line.halt()
    assert len(program.done) == 2
    program.answer()
    assert program.done[-1] == ("b", None)


def test_a_stop_with_nothing_under_way(program):
    program.line.halt()
    program.line.advance()
    assert program.done == []


def test_over_a_lost_link_nothing_survives(program):
    program.line.submit(program.order("a", 1), program.order("b", 2), program.question("c"))
    program.line.forget()
    assert program.done == [("a", "link_lost"), ("b", "link_lost"), ("c", "link_lost")]
    assert not program.line.busy
    program.answer()
    program.wait(2.0)
    assert len(program.done) == 3
    assert program.frames == [(frame(1),)]


def test_what_is_being_set_that_a_motion_counts_on(program):
    assert program.line.altering is None
    program.line.submit(program.order("a", 1), program.order("b", 2, alters="limits"))
    assert program.line.altering == "limits"
    program.answer()
    assert program.line.altering == "limits"
    program.answer()
    assert program.line.altering is None


def test_what_ends_may_begin_another(program):
    program.line.submit(
        Transaction((frame(1),), lambda _refusal: program.line.submit(program.order("b", 2)), INDEX)
    )
    program.answer()
    assert program.frames == [(frame(1),), (frame(2),)]
    assert program.line.busy
