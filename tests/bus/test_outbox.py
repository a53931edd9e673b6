"""The order in which frames reach the bus, above all that the stop passes everything."""

import errno
import threading
from typing import Any

import can
import pytest

from armui.bus.outbox import Outbox
from armui.protocol.frame import Frame

STOP = Frame(0x150, bytes.fromhex("0100000000000000"))


def frames(*numbers):
    return [Frame(0x475, bytes([number])) for number in numbers]


class Wire:
    """Stands for a bus: keeps what is sent, or fails as told."""

    def __init__(self):
        self.sent = []
        self.failure = None
        self.on_send = lambda: None

    def send(self, message, timeout=None):
        self.on_send()
        if self.failure is not None:
            raise self.failure
        self.sent.append(Frame(message.arbitration_id, bytes(message.data)))


@pytest.fixture
def wire():
    return Wire()


@pytest.fixture
def time_s():
    return [100.0]


@pytest.fixture
def outbox(wire, time_s):
    box = Outbox(clock=lambda: time_s[0])
    box.attach(wire)
    return box


def test_frames_go_out_in_order(outbox, wire):
    outbox.put(frames(1, 2))
    outbox.put(frames(3))
    outbox.send_waiting()
    assert wire.sent == frames(1, 2, 3)


def test_the_stop_is_on_the_bus_at_once_and_what_waited_never_goes_out(outbox, wire):
    outbox.put(frames(1, 2, 3))
    assert outbox.put_urgent([STOP])
    assert wire.sent == [STOP]
    outbox.send_waiting()
    assert wire.sent == [STOP]
    assert outbox.dropped == 3


def test_the_stop_cuts_into_a_row_of_frames_being_sent(outbox, wire):
    def press_stop_after_the_first():
        if len(wire.sent) == 1:
            wire.on_send = lambda: None
            presser = threading.Thread(target=outbox.put_urgent, args=([STOP],))
            presser.start()
            pressers.append(presser)

    pressers: list[Any] = []
    wire.on_send = press_stop_after_the_first
    outbox.put(frames(1, 2))
    outbox.send_waiting()
    for presser in pressers:
        presser.join()
    outbox.put(frames(3))
    outbox.send_waiting()
    # frame 2 was already being written when the stop was pressed; nothing may follow but new frames
    assert STOP in wire.sent
    assert wire.sent[0] == frames(1)[0]
    assert wire.sent[-1] == frames(3)[0]


def test_a_stop_that_meets_a_full_queue_goes_out_before_everything_else(outbox, wire):
    wire.failure = can.CanOperationError("full", error_code=errno.ENOBUFS)
    assert not outbox.put_urgent([STOP])
    outbox.put(frames(1))
    outbox.send_waiting()
    assert wire.sent == []
    wire.failure = None
    outbox.send_waiting()
    assert wire.sent == [STOP, *frames(1)]


def test_a_stop_does_not_wait_for_a_driver_that_hangs(outbox, wire):
    hanging, let_go = threading.Event(), threading.Event()

    def hang():
        wire.on_send = lambda: None
        hanging.set()
        let_go.wait(10)

    wire.on_send = hang
    outbox.put(frames(1, 2))
    sender = threading.Thread(target=outbox.send_waiting)
    sender.start()
    assert hanging.wait(10)
    assert not outbox.put_urgent([STOP])  # returns although frame 1 hangs in the driver
    let_go.set()
    sender.join()
    assert wire.sent == [frames(1)[0], STOP]


def test_a_full_queue_leaves_frames_for_later_but_not_for_too_late(outbox, wire, time_s):
    wire.failure = can.CanTimeoutError("nobody acknowledges")
    outbox.put(frames(1))
    outbox.send_waiting()
    time_s[0] += 0.51
    wire.failure = None
    outbox.put(frames(2))
    outbox.send_waiting()
    assert wire.sent == frames(2)


def test_a_bus_that_is_gone_is_reported(outbox, wire):
    wire.failure = can.CanOperationError("gone", error_code=errno.ENODEV)
    outbox.put(frames(1))
    with pytest.raises(can.CanOperationError):
        outbox.send_waiting()


def test_nothing_is_queued_without_a_bus_and_nothing_survives_one(outbox, wire):
    outbox.put(frames(1))
    outbox.detach()
    assert not outbox.put(frames(2))
    assert not outbox.put_urgent([STOP])
    outbox.attach(wire)
    outbox.send_waiting()
    assert wire.sent == []


def test_what_waited_for_another_bus_is_dropped(outbox, wire):
    outbox.put(frames(1))
    other = Wire()
    outbox.attach(other)
    outbox.send_waiting()
    assert (wire.sent, other.sent, outbox.dropped) == ([], [], 1)


def test_a_batch_goes_out_whole_or_not_at_all(outbox, wire, time_s):
    wire.failure = can.CanTimeoutError("full")
    outbox.put(frames(1, 2))
    outbox.send_waiting()
    time_s[0] += 0.51
    wire.failure = None
    outbox.send_waiting()
    assert wire.sent == []  # none of it had begun


def test_what_has_begun_goes_on_after_its_time(outbox, wire, time_s):
    def be_slow():
        time_s[0] += 0.1

    wire.on_send = be_slow
    outbox.put(frames(1, 2, 3), keep_s=0.05)
    outbox.send_waiting()
    assert wire.sent == frames(1, 2, 3)


def test_what_has_begun_does_not_go_on_after_half_a_second_in_which_nothing_went_out(
    outbox, wire, time_s
):
    def fill_up():
        if len(wire.sent) == 1:
            wire.failure = can.CanTimeoutError("full")

    wire.on_send = fill_up
    outbox.put(frames(1, 2))
    outbox.send_waiting()
    assert not outbox.blocked
    time_s[0] += 0.51
    outbox.send_waiting()
    assert outbox.blocked
    wire.failure, wire.on_send = None, lambda: None
    outbox.send_waiting()
    assert wire.sent == frames(1)


def test_a_frame_that_hung_takes_the_rest_of_its_batch_with_it(outbox, wire, time_s):
    def hang():
        wire.on_send = lambda: None
        time_s[0] += 3

    wire.on_send = hang
    outbox.put(frames(1, 2))
    outbox.send_waiting()
    assert wire.sent == frames(1)


def test_outdated_commands_are_dropped_and_nothing_else(outbox, wire):
    outbox.put(frames(1), command=1)
    outbox.put(frames(2))
    outbox.put(frames(3), command=2)
    outbox.void(2)
    outbox.send_waiting()
    assert wire.sent == frames(2, 3)


def test_on_a_bus_only_listened_to_nothing_goes_out_but_the_stop(wire):
    outbox = Outbox(listen_only=True)
    outbox.attach(wire)
    assert not outbox.put(frames(1))
    outbox.send_waiting()
    assert wire.sent == []
    assert outbox.put_urgent([STOP])
    assert wire.sent == [STOP]


def test_a_stop_asked_for_again_while_it_waits_is_one(outbox, wire):
    wire.failure = can.CanTimeoutError("full")
    for _ in range(5):
        assert not outbox.put_urgent([STOP])
    wire.failure = None
    outbox.send_waiting()
    assert wire.sent == [STOP]
