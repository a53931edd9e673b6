"""A request to run something: its states, what ends it in each, and answers that come too late."""

from __future__ import annotations

from typing import Any
from unittest.mock import Mock

import pytest

from armui.arm.refusal import Refusal
from armui.control.link.arm_mark import ArmMark
from armui.control.link.link_state import LINK_LOST
from armui.control.operations.started import ARM_CHANGED
from armui.control.run.preflight import FINDINGS_AGAINST, MOVED_SINCE_CHECK
from armui.control.run.run_request import RequestState, RunRequest
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.points.program import Trajectory
from armui.ui.background import WORK_FAILED
from armui.ui.dialogs.confirm_dialog import ASKED_OTHERWISE

CONTENT = Trajectory("one")
NO_POWER = LINK_LOST()
TO_CHECK = ["READING", "CHECKING"]
TO_RUN = [*TO_CHECK, "CHECKED", "STARTING", "UNDER_WAY"]


class Press:
    """A press on 发送 whose page, check and arm are in the test's hand.

    Attributes:
        states: What was told, in order.
        options: What the widgets show.
    """

    def __init__(self, **more: Any) -> None:
        now = Mock(cannot_run=None, occupied=None, speed_percent=30, model_fit=Mock(wrong=None))
        self.controller = Mock(mark=ArmMark(1), operating_state=now)
        self.checks, self.runner, self.page = Mock(), Mock(), Mock()
        self.runner.start.return_value = None
        self.options = RunOptions()
        self.now_s = 10.0
        self.states: list[str] = []
        self.request = RunRequest(
            self.controller,
            self.checks,
            self.runner,
            read=self.page,
            options=lambda: self.options,
            speed_percent=lambda: 20,
            on_state=self.note,
            clock=lambda: self.now_s,
            **more,
        )

    def note(self, request: RunRequest) -> None:
        """Take down a state."""
        self.states.append(request.state.name)

    def read(self, content: Trajectory | None = CONTENT) -> None:
        """Let the page answer the last reading."""
        self.page.call_args.args[0](content)

    def checked(self, findings: int = 0, errors: int = 0, outdated: Refusal | None = None) -> Mock:
        """Let the last check answer."""
        found, order = ("found",) * (findings + errors), Mock(content=CONTENT)
        preflight = Mock(findings=found, errors=errors, order=order)
        preflight.why_outdated.return_value = outdated
        self.checks.begin.call_args.args[2](preflight)
        return preflight

    def to(self, state: str) -> None:
        """Bring it into one of the states that wait for something."""
        if state != "PRESSED":
            self.request.begin()
        if state in {"CHECKING", "ASKING"}:
            self.read()
        if state == "ASKING":
            self.checked(findings=1)
        assert self.request.state.name == state


@pytest.fixture
def press() -> Press:
    return Press()


def test_nothing_found_it_runs_at_once(press: Press) -> None:
    press.request.begin()
    press.read()
    assert press.checks.begin.call_args.args[:2] == (CONTENT, RunOptions())
    checked = press.checked()
    assert press.states == TO_RUN
    press.runner.start.assert_called_once_with(checked, 20)
    assert press.request.is_over


def test_a_mere_check_runs_nothing_whatever_hinders_a_run() -> None:
    press = Press(runs=False)
    press.controller.operating_state.cannot_run = NO_POWER
    press.request.begin()
    press.read()
    press.checked(findings=3)
    assert press.states == [*TO_CHECK, "CHECKED"]
    assert press.request.is_over
    assert not press.request.must_ask
    press.request.accept()
    press.runner.start.assert_not_called()


def test_findings_ask_and_an_agreement_counts_once(press: Press) -> None:
    press.to("ASKING")
    press.runner.start.assert_not_called()
    press.request.accept()
    press.request.accept()
    assert press.states == [*TO_CHECK, "CHECKED", "ASKING", "STARTING", "UNDER_WAY"]
    press.runner.start.assert_called_once()


@pytest.mark.parametrize(("waited_s", "asked"), [(2.0, False), (2.1, True)])
def test_a_motion_long_after_the_press_asks(press: Press, waited_s: float, asked: bool) -> None:
    """The reading counts as well: a disk may be slow."""
    press.request.begin()
    press.now_s += waited_s - 0.5
    press.read()
    press.now_s += 0.5
    press.checked()
    assert (press.request.state is RequestState.ASKING) is asked


def test_errors_are_shown_and_refused(press: Press) -> None:
    press.to("CHECKING")
    press.checked(findings=4, errors=2)
    assert press.states == [*TO_CHECK, "CHECKED", "REFUSED"]
    assert not press.request.must_ask
    assert press.request.refusal == FINDINGS_AGAINST(count=2)
    press.request.accept()
    press.runner.start.assert_not_called()


def test_what_may_not_run_now_is_not_even_read(press: Press) -> None:
    press.controller.operating_state.cannot_run = NO_POWER
    press.request.begin()
    assert press.states == ["REFUSED"]
    assert press.request.refusal == NO_POWER
    press.page.assert_not_called()


def test_what_cannot_be_read_gives_it_up(press: Press) -> None:
    press.request.begin()
    press.read(None)
    assert press.states == ["READING", "GIVEN_UP"]


def test_another_arm_than_at_the_press_is_not_even_checked(press: Press) -> None:
    press.request.begin()
    press.controller.mark = ArmMark(2)
    press.read()
    assert press.states == ["READING", "REFUSED"]
    assert press.request.refusal == ARM_CHANGED()
    press.checks.begin.assert_not_called()


def test_a_check_that_fails_refuses(press: Press) -> None:
    press.to("CHECKING")
    press.checks.begin.call_args.args[2](WORK_FAILED())
    assert press.states == [*TO_CHECK, "REFUSED"]


def test_a_check_that_says_nothing_of_the_arm_any_more_refuses(press: Press) -> None:
    press.to("CHECKING")
    press.checked(outdated=MOVED_SINCE_CHECK())
    assert press.states == [*TO_CHECK, "CHECKED", "REFUSED"]
    press.runner.start.assert_not_called()


def test_an_arm_that_refuses_to_set_out(press: Press) -> None:
    press.runner.start.return_value = NO_POWER
    press.to("CHECKING")
    press.checked()
    assert press.states == [*TO_RUN[:-1], "REFUSED"]
    assert press.request.refusal == NO_POWER


def test_choices_turned_during_the_check_are_checked_anew(press: Press) -> None:
    press.to("CHECKING")
    press.options = RunOptions(step_by_step=True)
    press.checked(errors=1)  # of what is not asked for any more
    press.read()
    assert press.checks.begin.call_args.args[1] == RunOptions(step_by_step=True)
    press.checked()
    assert press.states == [*TO_CHECK, *TO_RUN]


def test_choices_turned_while_it_asks_are_checked_and_asked_anew(press: Press) -> None:
    press.to("ASKING")
    press.options = RunOptions(cycles=0)
    press.now_s += 60.0
    press.request.accept()
    press.read()
    press.now_s += 1.0
    press.checked()
    assert press.states == [*TO_CHECK, "CHECKED", "ASKING", *TO_RUN]


def test_choices_turned_while_nothing_may_run_refuse(press: Press) -> None:
    press.to("ASKING")
    press.options = RunOptions(cycles=0)
    press.controller.operating_state.cannot_run = NO_POWER
    press.request.accept()
    assert press.states[-2:] == ["ASKING", "REFUSED"]


@pytest.mark.parametrize("state", ["CHECKING", "ASKING"])
def test_a_reason_of_the_page_against_it_refuses(state: str) -> None:
    reasons: list[Refusal | None] = [None]
    press = Press(why_not=lambda content: reasons[-1] if content.name == "one" else None)
    press.to(state)
    reasons.append(ASKED_OTHERWISE())
    if state == "CHECKING":
        press.checked()
    else:
        press.request.accept()
    assert press.states[-2:] == [state, "REFUSED"]
    press.runner.start.assert_not_called()


@pytest.mark.parametrize("state", ["PRESSED", "READING", "CHECKING", "ASKING"])
def test_given_up_in_any_state_nothing_comes_of_it(press: Press, state: str) -> None:
    press.to(state)
    press.request.give_up()
    told = list(press.states)
    assert told[-1] == "GIVEN_UP"
    if press.page.called:
        press.read()
    if press.checks.begin.called:
        press.checked()
    press.request.accept()
    press.request.give_up()
    assert press.states == told
    press.runner.start.assert_not_called()


@pytest.mark.parametrize("at", ["READING", "CHECKING", "CHECKED", "ASKING"])
def test_given_up_by_whoever_is_told_of_a_state(press: Press, at: str) -> None:
    def give_up(request: RunRequest) -> None:
        press.states.append(request.state.name)
        if request.state.name == at:
            request.give_up()

    press.request._on_state = give_up
    press.request.begin()
    press.read()
    if press.checks.begin.called:
        press.checked(findings=at == "ASKING")
    assert press.states[-2:] == [at, "GIVEN_UP"]
    press.runner.start.assert_not_called()


def test_what_sets_out_is_not_given_up_halfway(press: Press) -> None:
    """A stop meanwhile ends the run itself."""
    press.runner.start.side_effect = lambda _checked, _percent: press.request.give_up()
    press.to("CHECKING")
    press.checked()
    assert press.states == TO_RUN


OVER = {RequestState.UNDER_WAY, RequestState.REFUSED, RequestState.GIVEN_UP}


def test_no_state_is_skipped(press: Press) -> None:
    """The one way forward leads through each of them; what is over stays so."""
    follows = {
        RequestState.PRESSED: {RequestState.READING},
        RequestState.READING: {RequestState.CHECKING},
        RequestState.CHECKING: {RequestState.READING, RequestState.CHECKED},
        RequestState.CHECKED: {RequestState.ASKING, RequestState.STARTING},
        RequestState.ASKING: {RequestState.READING, RequestState.STARTING},
        RequestState.STARTING: {RequestState.UNDER_WAY},
    }
    for before in RequestState:
        ends = set() if before in OVER else {RequestState.REFUSED, RequestState.GIVEN_UP}
        for after in set(RequestState) - follows.get(before, set()) - ends:
            press.request.state = before
            with pytest.raises(ValueError, match=f"from {before.name} to {after.name}"):
                press.request._enter(after)
            assert press.request.state is before
