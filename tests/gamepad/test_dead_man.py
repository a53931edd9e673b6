"""The dead-man button: a table of what a hand does and what comes of it."""

import math

import pytest

from armui.gamepad.dead_man import UNATTENDED_S, DeadMan, HoldPhase, Loss
from armui.gamepad.device_state import DeviceState
from armui.gamepad.layout import DEFAULTS, JogMode
from tests.gamepad.pads import MOUSE, PAD

UP, OFF, READY, MOVING, SPENT = HoldPhase
LB = ("left_shoulder",)
LEFT = {"left_x": -1.0}


class Hand:
    """A device in a hand, looked at every 10 ms."""

    def __init__(self, info=PAD, mode=JogMode.JOINT, one_axis=True):
        self.man = DeadMan()
        self.info, self.mode, self.one_axis = info, mode, one_axis
        self.now_s = 0.0

    def look(self, axes=(), buttons=(), seconds=0.01, silent=False):
        self.now_s += seconds
        state = DeviceState(self.info, dict(axes), frozenset(buttons), silent)
        return self.man.update(
            state, DEFAULTS[self.info.kind], self.mode, self.now_s, one_axis=self.one_axis
        )


@pytest.mark.parametrize(
    ("steps", "phases"),
    [
        ([((), ()), ((), LB), (LEFT, LB), ((), LB), ((), ())], [UP, READY, MOVING, READY, UP]),
        # no dead man: an axis alone moves nothing
        ([((), ()), (LEFT, ()), ({"left_y": 1.0}, ())], [UP, UP, UP]),
        # pushed when the button goes down: every axis must come back first
        (
            [(LEFT, ()), (LEFT, LB), (LEFT, LB), ((), LB), (LEFT, LB)],
            [UP, OFF, OFF, READY, MOVING],
        ),
        # another axis still pushed is no centre
        (
            [(LEFT, ()), (LEFT, LB), ({"left_y": 0.5}, LB), ({"left_y": 0.1}, LB)],
            [UP, OFF, OFF, READY],
        ),
        # let go while it moves
        ([((), ()), ((), LB), (LEFT, LB), (LEFT, ()), (LEFT, LB)], [UP, READY, MOVING, UP, OFF]),
        # held since before anybody looked: a button that is stuck, or a fresh connection
        ([((), LB), (LEFT, LB), ((), ()), ((), LB)], [SPENT, SPENT, UP, READY]),
        # a worn stick that does not come back quite to its centre
        ([({"left_x": 0.1}, ()), ({"left_x": 0.1}, LB), (LEFT, LB)], [UP, READY, MOVING]),
        # the cross is an axis as well
        ([((), ()), ((), LB), ((), (*LB, "dpad_up"))], [UP, READY, MOVING]),
        ([((), ()), ((), (*LB, "dpad_up")), ((), LB)], [UP, OFF, READY]),
        # other buttons are none of its business
        ([((), ()), ((), ("a", "right_shoulder")), (LEFT, ("a",))], [UP, UP, UP]),
        # an axis that is no number
        ([((), ()), ((), LB), ({"left_x": math.nan}, LB), ((), LB)], [UP, READY, OFF, READY]),
    ],
)
def test_what_a_hand_does(steps, phases):
    hand = Hand()
    holds = [hand.look(axes, buttons) for axes, buttons in steps]
    assert [hold.phase for hold in holds] == phases
    for hold in holds:
        assert any(hold.rates) == (hold.phase is MOVING)


def test_what_was_taken_away_needs_a_new_press():
    hand = Hand()
    hand.look()
    hand.look((), LB)
    assert hand.look(LEFT, LB).phase is MOVING
    hand.man.spend()
    assert hand.look(LEFT, LB).phase is SPENT
    assert hand.look((), LB).phase is SPENT
    assert hand.look(LEFT, LB).phase is SPENT
    assert hand.look((), ()).phase is UP
    assert hand.look((), LB).phase is READY


def test_nothing_is_taken_from_a_button_that_is_up():
    hand = Hand()
    hand.look()
    hand.man.spend()
    assert hand.look((), LB).phase is READY


def test_a_release_between_two_looks_counts():
    hand = Hand()
    hand.look()
    hand.look((), LB)
    hand.look(LEFT, LB)
    hand.man.release()
    assert hand.look(LEFT, LB).phase is OFF


def test_rates_by_curve_and_trigger():
    hand = Hand()
    hand.look()
    hand.look((), LB)
    slow = hand.look(LEFT, LB).rates
    fast = hand.look(LEFT | {"right_trigger": 1.0}, LB).rates
    assert slow == pytest.approx((0.2, 0, 0, 0, 0, 0))
    assert fast == pytest.approx((1.0, 0, 0, 0, 0, 0))


def test_one_axis_at_a_time_until_all_are_at_rest():
    hand = Hand()
    hand.look()
    hand.look((), LB)
    assert hand.look({"left_x": -0.4, "left_y": -0.3}, LB).rates[1:] == (0.0,) * 5
    # another pushed further does not take over: the arm does not turn aside by a slip
    assert hand.look({"left_x": -0.4, "left_y": -1.0}, LB).rates[1:] == (0.0,) * 5
    # the first back at rest, the other not: nothing moves before both are
    assert hand.look({"left_y": -1.0}, LB).phase is OFF
    assert hand.look({"left_x": -1.0, "left_y": -1.0}, LB).phase is OFF
    assert hand.look((), LB).phase is READY
    rates = hand.look({"left_y": -1.0}, LB).rates
    assert rates[1] > 0
    assert rates[0] == 0.0


def test_all_axes_at_once_where_the_operator_wants_it():
    hand = Hand(MOUSE, JogMode.BASE, one_axis=False)
    hand.look()
    hand.look((), ("1",))
    rates = hand.look({"x": 1.0, "y": -0.55, "rz": 1.0}, ("1",)).rates
    assert [math.copysign(1, rate) if rate else 0 for rate in rates] == [1, -1, 0, 0, 0, 1]
    assert rates[0] == pytest.approx(1.0)
    assert 0.2 < -rates[1] < 0.3


def test_ten_seconds_without_any_movement_end_it():
    hand = Hand()
    hand.look()
    hand.look((), LB)
    hand.look(LEFT, LB)
    for _ in range(99):
        assert hand.look(LEFT, LB, seconds=0.1).phase is MOVING
    hold = hand.look(LEFT, LB, seconds=0.11)
    assert UNATTENDED_S == 10.0
    assert (hold.phase, hold.lost) == (SPENT, Loss.UNATTENDED)
    assert hand.look(LEFT, LB).lost is None  # told once


@pytest.mark.parametrize(
    ("axes", "goes_on"),
    [
        (
            lambda n: {"left_x": -1.0 + 0.00003 * (n % 2)},
            False,
        ),  # the last digit never stands still
        (lambda n: {"left_x": -0.98 + 0.02 * (n % 2)}, False),
        (lambda n: {"left_x": -0.95 + 0.05 * (n % 2)}, True),
        (lambda n: {"left_x": -1.0, "right_trigger": 0.1 * (n % 2)}, True),
        (lambda n: {"left_x": -1.0 + 0.001 * n}, True),  # slowly, but on and on
    ],
)
def test_what_is_a_sign_of_a_hand(axes, goes_on):
    hand = Hand()
    hand.look()
    hand.look((), LB)
    phases = [hand.look(axes(n), LB, seconds=0.1).phase for n in range(150)]
    assert (phases[-1] is MOVING) == goes_on


def test_a_held_button_without_an_axis_ends_as_well():
    hand = Hand()
    hand.look()
    hand.look((), LB)
    assert hand.look((), LB, seconds=9.9).phase is READY
    assert hand.look((), LB, seconds=0.2).lost is Loss.UNATTENDED


def test_a_device_that_should_speak_and_does_not():
    hand = Hand(MOUSE, JogMode.BASE)
    hand.look()
    hand.look((), ("1",))
    assert hand.look({"x": 1.0}, ("1",)).phase is MOVING
    hold = hand.look({"x": 1.0}, ("1",), silent=True)
    assert (hold.phase, hold.lost) == (SPENT, Loss.SILENT)
    assert hand.look({"x": 1.0}, ("1",)).phase is SPENT
