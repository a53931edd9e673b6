"""What an outbox tells of itself, how it gives frames to the driver, and what it drops."""

import threading
from collections import deque

import pytest

from armui.bus.outbox import Outbox
from armui.bus.press import Press
from armui.protocol.frame import Frame
from tests.bus.driver import FULL, Driver, InDriver
from tests.bus.test_outbox import STOP, frames

# What it tells ------------------------------------------------------------------------------------


def test_it_is_empty_when_nothing_waits_and_nothing_is_in_the_driver(outbox, driver):
    assert Outbox().empty
    assert outbox.empty
    outbox.put(frames(1))
    assert not outbox.empty
    with InDriver(outbox, driver):
        outbox.put_urgent([STOP])
        outbox.void(0)
        assert not outbox.empty
    outbox.send_waiting()
    assert outbox.empty


def test_a_stop_that_waits_is_not_empty(outbox, driver):
    driver.failure = FULL
    outbox.put_urgent([STOP])
    assert not outbox.empty
    driver.failure = None
    outbox.send_waiting()
    assert outbox.empty


def test_a_frame_in_the_driver_is_not_empty_though_the_queue_is(outbox, driver):
    outbox.put(frames(1))
    with InDriver(outbox, driver):
        outbox.put_urgent([])
        assert outbox.dropped == 1
        assert not outbox.empty
    assert outbox.empty


def test_it_tells_whose_frames_are_not_out_yet(outbox):
    outbox.put(frames(1, 2), command=2)
    outbox.put(frames(3))
    assert [outbox.holds(command) for command in (1, 2, 3)] == [False, True, False]
    outbox.send_waiting()
    assert not outbox.holds(2)


def test_what_the_driver_has_taken_is_counted_and_kept_with_its_time(driver, time_s):
    sent: deque[tuple[Frame, float]] = deque()
    outbox = Outbox(clock=lambda: time_s[0], sent=sent)
    outbox.attach(driver)
    outbox.put(frames(1, 2))
    outbox.send_waiting()
    driver.failure = FULL
    outbox.put(frames(3))
    outbox.send_waiting()
    assert outbox.frames_out == 2
    assert list(sent) == [(frame, 0.25) for frame in frames(1, 2)]


def test_it_is_blocked_after_half_a_second_in_the_driver(outbox, driver, time_s):
    outbox.put(frames(1))
    with InDriver(outbox, driver):
        time_s[0] += 0.49
        assert not outbox.blocked
        time_s[0] += 0.01
        assert outbox.blocked
        time_s[0] += 0.25
        assert outbox.blocked
    assert not outbox.blocked


def test_it_is_blocked_after_failures_over_almost_half_a_second(outbox, driver, time_s):
    driver.failure = FULL
    outbox.put(frames(1), keep_s=9.0)
    assert not outbox.blocked
    outbox.send_waiting()
    assert not outbox.blocked
    time_s[0] += 0.375
    outbox.send_waiting()
    assert not outbox.blocked
    time_s[0] += 0.375  # only what was tried counts
    assert not outbox.blocked
    outbox.send_waiting()
    assert outbox.blocked
    driver.failure = None
    outbox.send_waiting()
    assert not outbox.blocked
    assert driver.sent == frames(1)


def test_a_failure_long_ago_is_forgotten_with_the_next_success(outbox, driver, time_s):
    driver.failure = FULL
    outbox.put(frames(1))
    outbox.send_waiting()
    driver.failure = None
    outbox.put(frames(2))
    outbox.send_waiting()
    time_s[0] += 5.0
    driver.failure = FULL
    outbox.put(frames(3))
    outbox.send_waiting()
    assert not outbox.blocked


@pytest.mark.parametrize("again", ["attach", "detach"])
def test_another_bus_is_not_blocked_by_what_was(outbox, driver, time_s, again):
    driver.failure = FULL
    outbox.put(frames(1), keep_s=9.0)
    outbox.send_waiting()
    time_s[0] += 0.5
    outbox.send_waiting()
    assert outbox.blocked
    outbox.attach(Driver()) if again == "attach" else outbox.detach()
    assert not outbox.blocked


# How it gives frames to the driver ----------------------------------------------------------------


def test_the_driver_gets_plain_frames_and_a_short_time(outbox, driver):
    outbox.put(frames(1))
    assert outbox.send_waiting()
    assert driver.timeouts == [0.05]
    assert driver.extended == [False]
    assert outbox.put_urgent([STOP])
    assert driver.timeouts == [0.05, 0.0]
    assert driver.senders == [threading.current_thread()] * 2


def test_what_a_full_driver_holds_is_flushed_only_when_it_is_blocked(outbox, driver, time_s):
    driver.failure = FULL
    outbox.put(frames(1), keep_s=9.0)
    assert not outbox.send_waiting()
    assert driver.flushed == 0
    time_s[0] += 0.5
    assert not outbox.send_waiting()
    assert driver.flushed == 1


def test_without_a_bus_there_is_nothing_to_send():
    outbox = Outbox()
    assert outbox.send_waiting()
    assert not outbox.put(frames(1))
    assert outbox.dropped == 0


# What it drops ------------------------------------------------------------------------------------


def test_nothing_put_in_is_nothing_that_waits(outbox, driver):
    assert outbox.put([])
    assert outbox.empty
    assert outbox.send_waiting()


@pytest.mark.parametrize(("after_s", "sent"), [(0.5, True), (0.5625, False)])
def test_a_batch_begins_within_half_a_second_or_not_at_all(outbox, driver, time_s, after_s, sent):
    outbox.put(frames(1, 2))
    time_s[0] += after_s
    outbox.send_waiting()
    assert driver.sent == (frames(1, 2) if sent else [])
    assert outbox.dropped == (0 if sent else 2)


@pytest.mark.parametrize(("after_s", "sent"), [(1.0, True), (1.0625, False)])
def test_what_is_sent_again_is_not_the_first_to_begin_after_a_second(
    outbox, driver, time_s, after_s, sent
):
    press = Press(time_s[0] + 1.0)
    outbox.put(frames(1), press=press)
    time_s[0] += after_s - 0.25
    outbox.put(frames(2, 3), press=press)
    time_s[0] += 0.25
    outbox.send_waiting()
    assert driver.sent == (frames(2, 3) if sent else [])
    assert press.begun is sent
    assert press.is_over(time_s[0]) is not sent


def test_once_one_has_left_it_may_be_sent_again_later(outbox, driver, time_s):
    press = Press(time_s[0] + 1.0)
    for _ in range(3):
        outbox.put(frames(1), press=press)
        outbox.send_waiting()
        time_s[0] += 0.75
    assert len(driver.sent) == 3
    assert not press.is_over(time_s[0])


def test_the_next_call_drops_what_is_too_old(outbox, time_s):
    outbox.put(frames(1, 2), keep_s=0.25)
    outbox.put(frames(3), keep_s=9.0)
    time_s[0] += 0.5
    outbox.put(frames(4))
    assert outbox.dropped == 2


def test_outdated_commands_are_counted_as_dropped(outbox):
    outbox.put(frames(1, 2), command=1)
    outbox.put(frames(3), command=2)
    outbox.void(2)
    assert outbox.dropped == 2
    outbox.void(1)
    assert outbox.dropped == 2


def test_what_has_begun_is_outdated_too(outbox, driver):
    def void_after_the_first():
        driver.on_send = lambda: None
        outbox.void(2)

    driver.on_send = void_after_the_first
    outbox.put(frames(1, 2), command=1)
    outbox.put(frames(3), command=2)
    assert outbox.send_waiting()
    assert driver.sent == frames(1, 3)


def test_what_has_begun_goes_on_after_its_time_whatever_waits_behind(outbox, driver, time_s):
    def be_slow():
        driver.on_send = lambda: None
        time_s[0] += 0.125

    driver.on_send = be_slow
    outbox.put(frames(1, 2), keep_s=0.0625)
    outbox.put(frames(3), keep_s=9.0)
    outbox.send_waiting()
    assert driver.sent == frames(1, 2, 3)


@pytest.mark.parametrize(("hung_s", "sent"), [(0.25, [1, 2, 3]), (0.5, [1, 3])])
def test_the_rest_of_a_batch_whose_frame_hung_is_dropped(outbox, driver, time_s, hung_s, sent):
    def hang():
        driver.on_send = lambda: None
        time_s[0] += hung_s

    driver.on_send = hang
    outbox.put(frames(1, 2))
    outbox.put(frames(3), keep_s=9.0)
    outbox.send_waiting()
    assert driver.sent == frames(*sent)
    assert outbox.dropped == 3 - len(sent)


def test_the_time_a_frame_waited_for_a_full_queue_counts_as_well(outbox, driver, time_s):
    driver.failure = FULL
    outbox.put(frames(1, 2), keep_s=9.0)
    outbox.send_waiting()
    time_s[0] += 0.5
    driver.failure = None
    outbox.send_waiting()
    assert driver.sent == frames(1)
    assert outbox.dropped == 1


def test_a_bus_left_while_a_frame_hung_takes_nothing_from_the_next(outbox, driver):
    other = Driver()
    outbox.put(frames(1))
    with InDriver(outbox, driver):
        outbox.attach(other)
        outbox.put(frames(2))
    outbox.send_waiting()
    assert (driver.sent, other.sent) == (frames(1), frames(2))


def test_a_failure_of_a_bus_that_was_left_does_not_block_the_next(outbox, driver, time_s):
    outbox.put(frames(1))
    with InDriver(outbox, driver):
        driver.failure = FULL
        outbox.attach(Driver())
        time_s[0] += 3.0
    assert not outbox.blocked
