"""Reports that are late in arriving are told from those that arrive as they were sent."""

import pytest

from armui.arm.arrivals import Arrivals
from armui.arm.state import ArmState
from armui.arm.tracker import Tracker
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from tests.ui.arm_states import heard_six

PERIOD_S = 1 / 256
"""Sums of powers of two are exact."""
SPEED_DEG_S = 100.0


def arrive(arrivals, count, at_s, spacing_s=PERIOD_S):
    """So many reports, the first at a time; what was answered to each, and the time after."""
    answers = [arrivals.note(at_s + index * spacing_s) for index in range(count)]
    return answers, at_s + count * spacing_s


@pytest.fixture
def settled():
    """Reports that have come evenly for two seconds."""
    arrivals = Arrivals()
    _, now_s = arrive(arrivals, 512, 0.0)
    return arrivals, now_s


def test_the_first_report_tells_nothing_of_what_was_before():
    arrivals = Arrivals()
    assert arrivals.note(1.0) is False
    assert arrivals.note(1.0 + PERIOD_S) is True
    assert arrivals.since_s == 1.0


@pytest.mark.parametrize(("gap_s", "late"), [(0.0596, False), (0.0625, True)])
def test_a_longer_time_than_60_ms_is_a_gap(settled, gap_s, late):
    arrivals, now_s = settled
    at_s = now_s - PERIOD_S + gap_s
    assert arrivals.note(at_s) is not late
    assert arrivals.since_s == (at_s if late else 0.0)
    assert arrivals.gap_s == (pytest.approx(gap_s) if late else 0.0)
    assert arrivals.note(at_s + PERIOD_S) is True


@pytest.mark.parametrize("together", [2, 4, 8])
def test_reports_that_are_read_some_at_a_time_are_in_time(together):
    """An adapter hands them over every 8, 16 or 31 ms."""
    arrivals = Arrivals()
    answers = [arrivals.note(index // together * together * PERIOD_S) for index in range(1024)]
    assert all(answers[1:])
    assert arrivals.since_s == 0.0


def test_one_frame_in_ten_may_be_lost():
    arrivals = Arrivals()
    answers = [arrivals.note(index * PERIOD_S) for index in range(1024) if index % 10]
    assert all(answers[1:])


def test_a_period_of_20_ms_is_as_good():
    arrivals = Arrivals()
    answers, _ = arrive(arrivals, 512, 0.0, 0.02)
    assert all(answers[1:])


def test_reports_that_are_handed_over_faster_than_they_are_sent_were_held_up(settled):
    """Each gap is too short to be one; what was held up comes behind the third."""
    arrivals, now_s = settled
    at_s = now_s - PERIOD_S
    for _ in range(3):
        at_s += 0.05
        assert arrivals.note(at_s) is True
    answers, _ = arrive(arrivals, 36, at_s, 1e-4)
    assert False in answers
    assert arrivals.since_s >= at_s
    # less than a third of a tenth of a second of the arm's time is left unnoticed
    left = len(answers) - 1 - max(place for place, one in enumerate(answers) if not one)
    assert left * PERIOD_S < 0.035


class Listener:
    """A tracker that hears the arm's angles."""

    def __init__(self):
        self.codec = Codec(Generation.TWO)
        self.tracker = Tracker(self.codec)

    def hear(self, at_s, ids=(0x2A5, 0x2A6, 0x2A7)):
        for arbitration_id in ids:
            self.tracker.update(self.codec.decode(Frame(arbitration_id, bytes(8))), at_s)
        return self.tracker.snapshot()


def test_the_arms_state_tells_for_how_long_its_angles_have_come_in_time():
    arm = Listener()
    state = arm.hear(1.0)
    assert (state.in_time_for_s(1.0), state.in_time(1.0)) == (0.0, False)
    state = arm.hear(1.03125)
    assert state.in_time_for_s(1.03125) == 0.03125
    assert state.in_time_for_s(1.03125, since_s=1.015625) == 0.015625
    assert state.in_time_for_s(1.09) == 0.03125, "up to the last that was heard"
    assert (state.in_time_for_s(1.1), state.in_time(1.1)) == (0.0, False), "a gap is open"
    state = arm.hear(1.25)
    assert (state.in_time_for_s(1.25), state.in_time(1.25)) == (0.0, False)
    assert (state.gap.value, state.gap.at_s) == (0.21875, 1.25)
    assert arm.hear(1.28125).in_time_for_s(1.28125, since_s=1.0) == 0.03125


def test_one_pair_that_is_late_makes_them_all_late():
    arm = Listener()
    arm.hear(1.0)
    for step in range(1, 5):
        state = arm.hear(1.0 + step / 32, (0x2A5, 0x2A7))
    assert not state.in_time(1.125)
    state = arm.hear(1.15625)
    assert state.in_time_for_s(1.15625) == 0.0
    assert arm.hear(1.1875).in_time(1.1875)


def test_angles_of_which_one_was_never_heard_are_not_in_time():
    assert Listener().hear(1.0, (0x2A5,)).in_time_for_s(1.0) == 0.0
    assert not ArmState().in_time(0.0)


def test_after_a_jump_in_a_log_what_was_before_does_not_count():
    arm = Listener()
    arm.hear(1.0)
    arm.hear(1.03125)
    arm.tracker.reset_timeouts()
    assert arm.tracker.snapshot().in_time_for_s(1.03125) == 0.0
    arm.hear(500.0)
    state = arm.hear(500.03125)
    assert (state.in_time_for_s(500.03125), state.gap) == (0.03125, None)


def test_a_state_that_was_put_together_by_hand_is_in_time():
    state = ArmState(joints_deg=heard_six((0.0,) * 6, 2.0))
    assert state.in_time_for_s(2.0, since_s=1.5) == 0.5
