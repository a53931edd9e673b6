"""The thread that hands frames to the driver: when it sends, retries, and ends."""

import errno
import threading
import time

import can
import pytest

from armui.bus.outbox import Outbox, SendingThread
from tests.bus.test_outbox import STOP, Wire, frames

LIMIT_S = 5.0


class WatchedWire(Wire):
    """Tells when so many frames have been tried."""

    def __init__(self):
        super().__init__()
        self.tried = threading.Semaphore(0)

    def send(self, message, timeout=None):
        try:
            super().send(message, timeout)
        finally:
            self.tried.release()

    def wait_for(self, count):
        for _ in range(count):
            assert self.tried.acquire(timeout=LIMIT_S)


@pytest.fixture
def wire():
    return WatchedWire()


@pytest.fixture
def outbox(wire):
    outbox = Outbox()
    outbox.attach(wire, threaded=True)
    return outbox


@pytest.fixture
def thread(outbox, wire):
    thread = SendingThread(outbox, wire)
    thread.start()
    yield thread
    outbox.detach()
    thread.join(LIMIT_S)


def test_it_sends_what_is_queued(thread, outbox, wire):
    outbox.put(frames(1, 2))
    wire.wait_for(2)
    outbox.put(frames(3))
    wire.wait_for(1)
    assert wire.sent == frames(1, 2, 3)


def test_it_sends_a_stop_whose_caller_need_not_touch_the_driver(thread, outbox, wire):
    who = []
    wire.on_send = lambda: who.append(threading.current_thread())
    assert outbox.put_urgent([STOP])
    assert who == [thread]


def test_a_full_queue_is_tried_again_by_itself_and_left_alone_between(thread, outbox, wire):
    wire.failure = can.CanTimeoutError("full")
    outbox.put(frames(1), keep_s=LIMIT_S)
    wire.wait_for(3)
    began_s = time.monotonic()
    wire.wait_for(4)
    assert time.monotonic() - began_s > 0.01  # four pauses of 5 ms, less what came before
    wire.failure = None
    wire.wait_for(1)
    while wire.sent != frames(1):
        wire.wait_for(1)
    assert thread.is_alive()


def test_it_ends_with_its_bus(thread, outbox):
    outbox.detach()
    thread.end()
    assert not thread.is_alive()
    assert thread.failure is None


def test_it_serves_no_other_bus(thread, outbox, wire):
    other = Wire()
    outbox.attach(other)
    thread.end()
    assert not thread.is_alive()
    outbox.put(frames(1))
    assert (wire.sent, other.sent) == ([], [])


def test_a_bus_that_is_gone_ends_it_and_is_told(thread, outbox, wire):
    wire.failure = can.CanOperationError("gone", error_code=errno.ENODEV)
    outbox.put(frames(1))
    thread.join(LIMIT_S)
    assert not thread.is_alive()
    assert thread.failure is wire.failure


def test_a_driver_that_raises_what_nobody_expected_is_told_as_well(thread, outbox, wire):
    wire.failure = ZeroDivisionError()
    outbox.put(frames(1))
    thread.join(LIMIT_S)
    assert thread.failure is wire.failure


def test_its_end_is_waited_for_a_moment_only(thread, outbox, wire):
    let_go = threading.Event()
    wire.on_send = lambda: let_go.wait(LIMIT_S)
    outbox.put(frames(1))
    while outbox._port.in_driver_since_s is None:
        time.sleep(0.001)
    outbox.detach()
    began_s = time.monotonic()
    thread.end()
    assert 0.15 < time.monotonic() - began_s < 1.0
    assert thread.is_alive()
    let_go.set()


def test_a_driver_that_never_returns_does_not_keep_the_program_from_ending(thread):
    assert thread.daemon
    assert thread.name == "bus sender"
