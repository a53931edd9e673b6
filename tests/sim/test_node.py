"""The arm on a python-can bus: by hand, and in real time."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator

import can
import pytest

from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.arm_loop import PERIOD_S
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from tests.moments import now
from tests.sim.talk import ENABLE, FRAMES_A_SECOND, STOP, frame, mode, target

OpenBus = Callable[[], can.BusABC]


@pytest.fixture
def open_bus(request: pytest.FixtureRequest) -> Iterator[OpenBus]:
    """Opens buses on a channel of the test's own; closes them afterwards."""
    buses: list[can.BusABC] = []

    def opened() -> can.BusABC:
        buses.append(can.Bus(interface="virtual", channel=request.node.nodeid))
        return buses[-1]

    yield opened
    for bus in buses:
        bus.shutdown()


def say(bus: can.BusABC, *lines: str) -> None:
    for line in lines:
        identifier, data = frame(line)
        bus.send(can.Message(arbitration_id=identifier, data=data, is_extended_id=False))


def listen(bus: can.BusABC) -> list[Frame]:
    """What is waiting on the bus."""
    frames: list[Frame] = []
    while (message := bus.recv(timeout=0.0)) is not None:
        frames.append(Frame(message.arbitration_id, bytes(message.data)))
    return frames


def test_a_poll_hears_answers_and_tells(open_bus: OpenBus) -> None:
    host, arm = open_bus(), Firmware(Generation.TWO)
    node = Node(arm, open_bus())
    say(host, ENABLE)
    node.poll(0.005)
    assert list(node.heard) == [frame(ENABLE)]
    assert arm.enabled == (True,) * 6
    frames = listen(host)
    # the answer first, then 8 + 6 frames of feedback and the first slow driver
    assert frames[0] == frame("476#7100000000000000")
    assert [each.arbitration_id for each in frames[1:]] == [
        *range(0x2A1, 0x2A9),
        *range(0x251, 0x257),
        0x261,
    ]
    assert (node.sent, node.received, node.lost) == (16, 1, 0)


def test_a_second_on_the_bus_is_standard_data_frames(open_bus: OpenBus) -> None:
    host = open_bus()
    Node(Firmware(Generation.TWO), open_bus()).poll(1.0)
    messages = []
    while (message := host.recv(timeout=0.0)) is not None:
        messages.append(message)
    assert len(messages) == FRAMES_A_SECOND
    assert not any(
        each.is_extended_id or each.is_remote_frame or each.is_error_frame or each.is_fd
        for each in messages
    )
    assert {each.dlc for each in messages} == {8}


def test_a_whole_motion_by_hand(open_bus: OpenBus) -> None:
    host, arm = open_bus(), Firmware(Generation.ONE)
    node = Node(arm, open_bus())
    say(host, ENABLE, mode(100), *target(10.0, 20.0, -30.0, 0, 0, 0))
    for _ in range(400):
        node.poll(0.005)
    assert now(arm.joints_deg) == (10.0, 20.0, -30.0, 0, 0, 0)
    # J1 10.000° = 10000 = 0x2710, J2 20.000° = 0x4E20
    assert frame("2A5#0000271000004E20") in listen(host)


def test_frames_that_no_arm_reads_are_not_heard(open_bus: OpenBus) -> None:
    host = open_bus()
    node = Node(Firmware(Generation.TWO), open_bus())
    stop = bytes.fromhex("0100000000000000")
    for message in (
        can.Message(arbitration_id=0x150, data=stop, is_extended_id=True),
        can.Message(arbitration_id=0x150, is_remote_frame=True, dlc=8, is_extended_id=False),
        can.Message(is_error_frame=True),
        can.Message(arbitration_id=0x150, data=stop, is_fd=True, is_extended_id=False),
    ):
        host.send(message)
    node.poll(0.005)
    assert not node.heard
    assert not node.firmware.condition.stopped


def test_an_echo_of_the_own_feedback_is_not_heard(open_bus: OpenBus) -> None:
    host = open_bus()
    node = Node(Firmware(Generation.TWO), open_bus())
    node.poll(0.025)
    for identifier, data in listen(host):
        host.send(can.Message(arbitration_id=identifier, data=data, is_extended_id=False))
    say(host, STOP)
    node.poll(0.0)
    assert list(node.heard) == [frame(STOP)]


def test_heard_keeps_the_newest(open_bus: OpenBus) -> None:
    host = open_bus()
    node = Node(Firmware(Generation.TWO), open_bus(), remember=2)
    say(host, ENABLE, mode(1), mode(2))
    node.poll(0.0)
    assert list(node.heard) == [frame(mode(1)), frame(mode(2))]
    assert node.received == 3


def test_a_flood_does_not_keep_the_arm_from_sending(open_bus: OpenBus) -> None:
    host = open_bus()
    node = Node(Firmware(Generation.TWO), open_bus())
    say(host, *[mode(1)] * 2500)
    received = []
    for _ in range(3):
        node.poll(0.005)
        received.append(node.received)
    assert received == [1000, 2000, 2500]
    assert node.sent == 3 * 14 + 3


class BrokenBus:
    """A bus that takes some frames and then fails, as an unplugged adapter does."""

    def __init__(self, takes: int, fails: Callable[[], Exception]) -> None:
        self.takes = takes
        self.fails = fails

    def send(self, message: can.Message) -> None:
        if not self.takes:
            raise self.fails()
        self.takes -= 1

    def recv(self, timeout: float) -> None:
        if not self.takes:
            raise self.fails()


@pytest.mark.parametrize(
    "fails",
    [lambda: can.CanOperationError("bus off"), lambda: OSError(19, "No such device")],
    ids=["bus off", "unplugged"],
)
def test_a_bus_that_fails_is_counted_and_survived(fails: Callable[[], Exception]) -> None:
    bus = BrokenBus(10, fails)
    node = Node(Firmware(Generation.TWO), bus)  # type: ignore[arg-type]  # only what a node uses
    node.poll(0.005)
    assert (node.sent, node.lost, node.receive_errors) == (10, 5, 0)
    node.poll(0.005)
    assert (node.sent, node.lost, node.receive_errors) == (10, 20, 1)
    bus.takes = 100
    node.poll(0.005)
    assert node.sent == 25
    assert node.firmware.time_s == pytest.approx(0.015)


def test_the_thread_lives_in_real_time_and_ends(open_bus: OpenBus) -> None:
    host, before = open_bus(), set(threading.enumerate())
    node = Node(Firmware(Generation.TWO), open_bus())
    with node:
        say(host, ENABLE)
        answers = 0
        # the bus itself is the clock: 100 periods of feedback, each waited for
        for _ in range(100 * 15):
            message = host.recv(timeout=2.0)
            assert message is not None
            answers += message.arbitration_id == 0x476
        assert len(set(threading.enumerate()) - before) == 1
    assert answers == 1
    assert set(threading.enumerate()) <= before
    assert node.firmware.time_s >= 99 * PERIOD_S
    assert node.worst_lateness_s < 1.0
    listen(host)
    assert host.recv(timeout=0.0) is None


def test_start_twice_is_refused_and_stop_twice_harmless(open_bus: OpenBus) -> None:
    node = Node(Firmware(Generation.TWO), open_bus())
    node.start()
    try:
        with pytest.raises(RuntimeError, match="stop it first"):
            node.start()
    finally:
        node.stop()
    node.stop()
    node.start()
    node.stop()
    assert not any(thread.name == "simulated-arm" for thread in threading.enumerate())
