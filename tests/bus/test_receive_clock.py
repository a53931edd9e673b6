"""When a frame was received: by the system's stamp where there is one, else never too young."""

import pytest

from armui.bus.receive_clock import ReceiveClock

DAY_S = 1_800_000_000.0


class Clocks:
    """The program's clock and the time of day, in the test's hand."""

    def __init__(self, *, stamped):
        self.now_s, self.day_s = 1000.0, DAY_S
        self.received = ReceiveClock(
            lambda: self.now_s, stamped=stamped, time_of_day=lambda: self.day_s
        )
        self.received.emptied()

    def go_on(self, seconds):
        self.now_s += seconds
        self.day_s += seconds

    def read(self, stamp_s=0.0):
        """When a frame read now was received."""
        return self.received.at_s(stamp_s, self.now_s)


@pytest.fixture
def stamped():
    return Clocks(stamped=True)


@pytest.fixture
def bare():
    return Clocks(stamped=False)


def test_the_systems_stamp_dates_a_backlog(stamped):
    stamped.go_on(3.0)
    stamped.received.begin()
    assert stamped.read(DAY_S + 0.25) == pytest.approx(1000.25)
    assert stamped.read(DAY_S + 3.0) == pytest.approx(1003.0)


def test_no_frame_came_before_the_queue_was_empty(stamped):
    stamped.go_on(3.0)
    stamped.received.begin()
    assert stamped.read(DAY_S - 3600.0) == 1000.0  # the time of day was set forward by an hour


def test_a_time_of_day_set_back_tells_nothing(stamped):
    stamped.go_on(3.0)
    stamped.day_s -= 3600.0
    stamped.received.begin()
    assert stamped.read(DAY_S + 2.9) == 1000.0
    stamped.received.emptied()
    stamped.go_on(0.004)
    stamped.received.begin()
    assert stamped.read(DAY_S + 7200.0) == stamped.now_s


def test_no_frame_is_dated_in_the_future(stamped):
    stamped.go_on(0.01)
    assert stamped.read(DAY_S + 0.5) == stamped.now_s


def test_without_a_stamp_a_backlog_is_as_old_as_it_can_be(bare):
    bare.go_on(3.0)
    bare.received.begin()
    assert bare.read() == 1000.0
    bare.go_on(0.01)
    bare.received.begin()  # the next burst of the same backlog
    assert bare.read() == 1000.0
    bare.received.emptied()
    bare.go_on(0.005)
    bare.received.begin()
    assert bare.read() == bare.now_s


def test_a_frame_that_was_waited_for_came_just_now(bare):
    bare.received.begin()
    bare.go_on(3.0)  # in the driver, until it came
    assert bare.read() == 1003.0


def test_a_short_pause_makes_no_backlog(bare):
    bare.go_on(0.04)
    bare.received.begin()
    assert bare.read() == bare.now_s


def test_no_frame_is_dated_before_one_that_was_read_earlier(bare, stamped):
    """A queue that is not empty for long is a backlog only after its first frames were read."""
    bare.go_on(0.04)
    bare.received.begin()
    first_s = bare.read()
    bare.go_on(0.02)
    bare.received.begin()
    assert bare.read() == first_s == 1000.04
    stamped.go_on(0.04)
    assert stamped.read(DAY_S + 0.03) == pytest.approx(1000.03)
    stamped.day_s += 0.02  # the time of day is set forward
    assert stamped.read(DAY_S + 0.035) == pytest.approx(1000.03)
