"""S3: a driver that hangs or times out in ``send`` holds neither the window nor the stop.

The times are those of the computer's clock, because they are what is promised. The limit asserted
is ten times the promised 50 ms where nothing but the load of a slow machine lies between; a driver
holds a thread for as long as the test likes, so the old faults took forever here.
"""

import threading
import time
from contextlib import contextmanager
from typing import Any, cast

import can
import pytest
from can.interfaces.virtual import VirtualBus

from armui.arm.device import Device
from armui.bus.link import BusState
from armui.bus.outbox import Outbox
from armui.bus.worker import BusWorker
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation

STOP = Frame(0x150, bytes.fromhex("0100000000000000"))
LONG_S = 0.5
GIVE_UP_S = 20


def frames(*numbers):
    return [Frame(0x475, bytes([number])) for number in numbers]


class StuckBus(VirtualBus):
    """A bus whose driver holds whoever sends until it is let go."""

    def __init__(self, channel):
        super().__init__(channel)
        self.stuck = threading.Event()
        self.let_go = threading.Event()
        self.hang = True

    def send(self, msg, timeout=None):
        if self.hang:
            self.stuck.set()
            self.let_go.wait(GIVE_UP_S)
        super().send(msg, timeout)


class TimingOutBus(VirtualBus):
    """A bus on which nobody acknowledges: each frame is refused, after the driver's own time."""

    def __init__(self, channel):
        super().__init__(channel)
        self.tried = threading.Event()
        self.seen = []
        self.refuse = True
        self.held = threading.Event()

    def send(self, msg, timeout=None):
        self.seen.append(bytes(msg.data))
        self.tried.set()
        if self.refuse:
            self.held.wait(1.0)
            raise can.CanTimeoutError("nobody acknowledges")
        super().send(msg, timeout)


class Rig:
    """A bus worker on a bus of this kind, and the arm's end of the wire."""

    def __init__(self, kind, channel, qtbot, **options):
        self.arm = can.Bus(interface="virtual", channel=channel)
        self.reports: list[Any] = []
        self.bus = None
        self._kind = kind
        self.worker = BusWorker(
            Device("virtual", channel, None), self.open, Codec(Generation.TWO), **options
        )
        self.worker.reported.connect(self.reports.append)
        self.worker.start()
        qtbot.waitUntil(lambda: BusState.OPEN in [each.state for each in self.reports])

    @contextmanager
    def open(self, device):
        with self._kind(device.channel) as bus:
            self.bus = bus
            yield bus

    def received(self):
        """What has come to the arm by now."""
        heard = []
        while (message := self.arm.recv(0)) is not None:
            heard.append(Frame(message.arbitration_id, bytes(message.data)))
        return heard

    def close(self):
        self.bus.hang = self.bus.refuse = False
        for event in ("let_go", "held"):
            if hasattr(self.bus, event):
                getattr(self.bus, event).set()
        self.worker.close(5000)
        self.arm.shutdown()


@pytest.fixture
def stuck(qtbot, request):
    rig = Rig(StuckBus, request.node.nodeid, qtbot)
    yield rig
    rig.close()


@pytest.fixture
def timing_out(qtbot, request):
    rig = Rig(TimingOutBus, request.node.nodeid, qtbot)
    yield rig
    rig.close()


def took_s(act):
    began_s = time.monotonic()
    act()
    return time.monotonic() - began_s


def test_the_first_stop_returns_though_its_own_frame_hangs(stuck):
    assert took_s(lambda: stuck.worker.send_urgent([STOP])) < LONG_S
    assert stuck.bus.stuck.wait(GIVE_UP_S)
    stuck.bus.hang = False
    stuck.bus.let_go.set()
    assert stuck.arm.recv(GIVE_UP_S).arbitration_id == 0x150


def test_nothing_is_waited_for_while_a_frame_hangs_and_the_stop_is_next(stuck, qtbot):
    worker = stuck.worker
    worker.send(frames(1, 2))
    assert stuck.bus.stuck.wait(GIVE_UP_S)
    assert took_s(lambda: worker.send(frames(3))) < LONG_S
    for _ in range(3):
        assert took_s(lambda: worker.send_urgent([STOP])) < LONG_S
    assert took_s(lambda: worker.send(frames(4))) < LONG_S
    assert took_s(lambda: worker.void(7)) < LONG_S
    stuck.bus.hang = False
    stuck.bus.let_go.set()
    qtbot.waitUntil(lambda: worker.idle)
    # the frame in the driver could not be recalled; the stop was asked for three times, and is one
    assert stuck.received() == [*frames(1), STOP, *frames(4)]


def test_receiving_goes_on_while_a_frame_hangs(stuck, qtbot):
    stuck.worker.send(frames(1))
    assert stuck.bus.stuck.wait(GIVE_UP_S)
    stuck.arm.send(
        can.Message(
            arbitration_id=0x2A5, data=bytes.fromhex("00002EE0FFFFD120"), is_extended_id=False
        )
    )
    qtbot.waitUntil(lambda: stuck.worker.state.joints_deg[0] is not None)


def test_a_driver_that_times_out_holds_no_press(timing_out, qtbot):
    worker = timing_out.worker
    worker.send(frames(1, 2, 3))
    assert timing_out.bus.tried.wait(GIVE_UP_S)
    three = [Frame(each, STOP.data) for each in (0x150, 0x160, 0x170)]
    assert took_s(lambda: worker.send_urgent(three)) < LONG_S
    assert took_s(lambda: worker.send_urgent(three)) < LONG_S
    timing_out.bus.refuse = False
    timing_out.bus.held.set()
    qtbot.waitUntil(lambda: worker.idle)
    assert timing_out.received() == three


def test_a_device_that_closes_does_not_wait_for_a_frame_that_hangs(stuck):
    stuck.worker.send(frames(1))
    assert stuck.bus.stuck.wait(GIVE_UP_S)
    assert took_s(lambda: stuck.worker.close(100)) < 5


def test_a_free_driver_has_the_stop_when_the_call_returns(qtbot, request):
    rig = Rig(VirtualBus, request.node.nodeid, qtbot)
    try:
        assert rig.worker.send_urgent([STOP])
        assert rig.received() == [STOP]
    finally:
        rig.close()


class Wire:
    """Stands for a bus: keeps what is sent; the test decides what happens during a send."""

    def __init__(self):
        self.sent = []
        self.during = lambda: None

    def send(self, message, timeout=None):
        self.during()
        self.sent.append(Frame(message.arbitration_id, bytes(message.data)))


def test_no_interleaving_of_a_stop_and_a_send_loses_either(monkeypatch):
    """The queue is emptied by a stop between taking a frame and noting that it is out."""
    wire, outbox = cast("Any", Wire()), Outbox()
    outbox.attach(wire)

    def stop_meanwhile():
        wire.during = lambda: None
        presser = threading.Thread(target=outbox.put_urgent, args=([STOP],))
        presser.start()
        presser.join(GIVE_UP_S)

    wire.during = stop_meanwhile
    outbox.put(frames(1, 2))
    assert outbox.send_waiting()
    assert wire.sent == [*frames(1), STOP]
    assert outbox.empty


def test_many_stops_among_many_frames_lose_none():
    wire, outbox = cast("Any", Wire()), Outbox()
    outbox.attach(wire)
    ending = threading.Event()

    def send():
        while not ending.is_set() or not outbox.empty:
            outbox.send_waiting()

    sender = threading.Thread(target=send)
    sender.start()
    stops = [Frame(0x150, bytes([1, number % 256, number // 256])) for number in range(2000)]
    for stop in stops:
        outbox.put(frames(1, 2, 3))
        outbox.put_urgent([stop])
    ending.set()
    sender.join(GIVE_UP_S)
    assert [frame for frame in wire.sent if frame.arbitration_id == 0x150] == stops
