"""How the stop passes an outbox, and what wakes the thread that sends."""

import threading
import time

import pytest

from armui.bus.outbox import Outbox, SendingThread
from armui.protocol.frame import Frame
from tests.bus.driver import FULL, GONE, LIMIT_S, Driver, InDriver, quickest_s, took_s
from tests.bus.test_outbox import STOP, frames


@pytest.fixture
def threaded(driver, time_s):
    """An outbox of whose driver it is not known that it returns in time."""
    box = Outbox(clock=lambda: time_s[0])
    box.attach(driver, threaded=True)
    return box


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
