"""What an outbox tells of itself, what it drops, and how long it lets anybody wait."""

import errno
import threading
import time

import can
import pytest

from armui.bus.outbox import Outbox
from armui.bus.sending import SendingThread
from armui.protocol.frame import Frame
from tests.bus.test_outbox import STOP, Wire, frames

LIMIT_S = 5.0
FULL = can.CanTimeoutError("full")
GONE = can.CanOperationError("gone", error_code=errno.ENODEV)


class Driver(Wire):
    """Keeps what it is given, and how; the test decides what happens meanwhile."""

    def __init__(self):
        super().__init__()
        self.timeouts = []
        self.extended = []
        self.senders = []
        self.flushed = 0

    def send(self, message, timeout=None):
        self.timeouts.append(timeout)
        self.extended.append(message.is_extended_id)
        self.senders.append(threading.current_thread())
        super().send(message, timeout)

    def flush_tx_buffer(self):
        self.flushed += 1


@pytest.fixture
def driver():
    return Driver()


@pytest.fixture
def time_s():
    return [0.25]


@pytest.fixture
def outbox(driver, time_s):
    box = Outbox(clock=lambda: time_s[0])
    box.attach(driver)
    return box


@pytest.fixture
def threaded(driver, time_s):
    """An outbox of whose driver it is not known that it returns in time."""
    box = Outbox(clock=lambda: time_s[0])
    box.attach(driver, threaded=True)
    return box


def took_s(act):
    began_s = time.monotonic()
    act()
    return time.monotonic() - began_s


def quickest_s(act):
    """Of several times, so that a busy computer's other work tells nothing."""
    return min(took_s(act) for _ in range(10))


class InDriver:
    """A frame that hangs in the driver, sent by a thread of its own."""

    def __init__(self, outbox, driver):
        self.hangs, self.let_go = threading.Event(), threading.Event()

        def hang():
            driver.on_send = lambda: None
            self.hangs.set()
            self.let_go.wait(LIMIT_S)

        driver.on_send = hang
        self.thread = threading.Thread(target=outbox.send_waiting)

    def __enter__(self):
        self.thread.start()
        assert self.hangs.wait(LIMIT_S)
        return self

    def __exit__(self, *_args):
        self.let_go.set()
        self.thread.join(LIMIT_S)


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


# The stop -----------------------------------------------------------------------------------------


def test_a_stop_drops_what_waits_even_without_a_bus(outbox):
    outbox.put(frames(1, 2))
    outbox.detach()
    assert outbox.dropped == 2
    assert not outbox.put_urgent([STOP])
    assert outbox.empty


def test_several_frames_of_a_stop_go_out_in_order_and_each_once(outbox, driver):
    three = [Frame(each, STOP.data) for each in (0x150, 0x160, 0x170)]
    assert outbox.put_urgent(three)
    assert driver.sent == three
    driver.failure = FULL
    assert not outbox.put_urgent(three)
    assert not outbox.put_urgent([*three, *frames(1)])
    driver.failure = None
    outbox.send_waiting()
    assert driver.sent == [*three, *three, *frames(1)]


def test_a_stop_waits_for_its_own_frames_only(outbox, driver):
    driver.failure = FULL
    assert not outbox.put_urgent([STOP])
    driver.failure = None
    assert outbox.put_urgent([])
    assert driver.sent == [STOP]


def test_another_bus_is_not_stopped_by_a_stop_of_before(outbox, driver):
    driver.failure = FULL
    outbox.put_urgent([STOP])
    other = Driver()
    outbox.attach(other)
    outbox.send_waiting()
    assert other.sent == []
    other.failure = FULL
    outbox.put_urgent([STOP])
    outbox.detach()
    assert outbox.empty


@pytest.mark.parametrize("failure", [GONE, ZeroDivisionError()])
def test_a_driver_that_fails_fails_no_stop_and_is_not_left_locked(outbox, driver, failure):
    driver.failure = failure
    assert not outbox.put_urgent([STOP])
    with pytest.raises(type(failure)):
        outbox.send_waiting()
    driver.failure = None
    outbox.send_waiting()
    assert driver.sent == [STOP]


def test_a_stop_does_not_send_what_is_ordinary(outbox, driver):
    def put_meanwhile():
        driver.on_send = lambda: None
        outbox.put(frames(1))

    driver.on_send = put_meanwhile
    assert outbox.put_urgent([STOP])
    assert driver.sent == [STOP]
    assert not outbox.empty


def test_a_stop_is_left_to_the_sending_thread_where_the_driver_may_block(threaded, driver):
    assert 0.015 < quickest_s(lambda: threaded.put_urgent([STOP])) < 0.1
    assert driver.sent == []
    threaded.send_waiting()
    assert driver.sent == [STOP]


def test_its_caller_waits_until_the_sending_thread_has_sent_it(threaded, driver):
    thread = threading.Thread(
        target=lambda: threaded.wait_for_work(driver) and threaded.send_waiting()
    )
    thread.start()
    assert threaded.put_urgent([STOP])
    assert driver.senders == [thread]
    thread.join(LIMIT_S)


def test_its_caller_goes_on_as_soon_as_it_is_sent(driver):
    outbox = Outbox()
    outbox.attach(driver, threaded=True)
    thread = SendingThread(outbox, driver)
    thread.start()
    assert quickest_s(lambda: outbox.put_urgent([STOP])) < 0.015
    outbox.detach()
    thread.join(LIMIT_S)


@pytest.mark.parametrize("why", ["in the driver", "failing"])
def test_it_waits_for_no_driver_that_is_known_to_be_held_up(threaded, driver, time_s, why):
    threaded.put(frames(1), keep_s=9.0)
    if why == "failing":
        driver.failure = FULL
        threaded.send_waiting()
        time_s[0] += 0.25
        assert quickest_s(lambda: threaded.put_urgent([STOP])) < 0.015
        return
    with InDriver(threaded, driver):
        assert took_s(lambda: threaded.put_urgent([STOP])) > 0.015
        time_s[0] += 0.25
        assert quickest_s(lambda: threaded.put_urgent([STOP])) < 0.015


def test_a_bus_that_is_left_meanwhile_lets_the_caller_go(threaded, driver):
    stopped = []
    with InDriver(threaded, driver) if threaded.put(frames(1)) else None:
        presser = threading.Thread(target=lambda: stopped.append(threaded.put_urgent([STOP])))
        presser.start()
        threaded.detach()
        presser.join(LIMIT_S)
    assert stopped == [False]


# The sending thread -------------------------------------------------------------------------------


def waits(outbox, driver):
    """A thread that waits for work, and what it was told."""
    told = []
    thread = threading.Thread(target=lambda: told.append(outbox.wait_for_work(driver)))
    thread.start()
    time.sleep(0.02)
    assert thread.is_alive()
    return thread, told


@pytest.mark.parametrize(
    ("does", "works"),
    [
        (lambda outbox: outbox.put(frames(1)), True),
        (lambda outbox: outbox.put_urgent([STOP]), True),
        (lambda outbox: outbox.detach(), False),
        (lambda outbox: outbox.attach(Driver()), False),
    ],
    ids=["frames", "a stop", "detached", "another bus"],
)
def test_what_wakes_the_sending_thread(threaded, driver, does, works):
    thread, told = waits(threaded, driver)
    does(threaded)
    thread.join(LIMIT_S)
    assert told == [works]


def test_work_that_is_there_is_not_waited_for(threaded, driver):
    threaded.put(frames(1))
    assert threaded.wait_for_work(driver)
    assert not threaded.wait_for_work(Driver())
