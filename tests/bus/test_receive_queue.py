"""The system's queue in front of the program: its length, and what it has lost."""

import socket
import sys
from typing import cast

import can
import pytest

from armui.bus.receive_queue import ReceiveQueue

linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells")


class SocketBus:
    """As much of a bus as the queue looks at."""

    def __init__(self, fileno: int) -> None:
        self._fileno = fileno

    def fileno(self):
        return self._fileno


def bus_of(receiving: socket.socket) -> can.BusABC:
    return cast("can.BusABC", SocketBus(receiving.fileno()))


@pytest.fixture
def sockets():
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiving,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sending,
    ):
        receiving.bind(("127.0.0.1", 0))
        sending.connect(receiving.getsockname())
        yield receiving, sending


def overfill(receiving, sending):
    """Send until something must have been lost."""
    for _ in range(4 * receiving.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) // 8192):
        sending.send(bytes(8192))


def received(receiving):
    """How many are in the queue; it is empty afterwards."""
    receiving.setblocking(False)
    count = 0
    while True:
        try:
            receiving.recv(8192)
        except BlockingIOError:
            return count
        count += 1


@linux
def test_it_is_made_longer(sockets):
    before = sockets[0].getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF)
    queue = ReceiveQueue()
    queue.attach(bus_of(sockets[0]))
    assert sockets[0].getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) > before
    queue.detach()


@linux
def test_each_frame_lost_is_counted(sockets):
    queue = ReceiveQueue()
    queue.attach(bus_of(sockets[0]))
    queue.poll(0.0)
    assert queue.dropped == 0
    sent = 4 * sockets[0].getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) // 8192
    overfill(*sockets)
    queue.poll(0.4)  # too early
    assert queue.dropped == 0
    queue.poll(0.5)
    assert queue.dropped == sent - received(sockets[0]) > 0
    queue.detach()
    assert queue.dropped > 0


@linux
def test_what_was_lost_before_it_was_opened_does_not_count(sockets):
    overfill(*sockets)
    queue = ReceiveQueue()
    queue.attach(bus_of(sockets[0]))
    queue.poll(0.0)
    assert queue.dropped == 0
    queue.detach()


@linux
def test_the_bus_goes_on_when_the_queue_lets_go(sockets):
    receiving, sending = sockets
    queue = ReceiveQueue()
    queue.attach(bus_of(receiving))
    queue.detach()
    sending.send(b"frame")
    assert receiving.recv(10) == b"frame"


def test_an_overflow_told_by_the_adapter_counts():
    queue = ReceiveQueue()
    for identifier, data in (
        (0x004, bytes([0, 0x01, 0, 0, 0, 0, 0, 0])),  # controller: receive buffer overflow
        (0x004, bytes([0, 0x02, 0, 0, 0, 0, 0, 0])),  # controller: transmit buffer overflow
        (0x008, bytes([0, 0x01, 0, 0, 0, 0, 0, 0])),  # another class
        (0x004, b""),
    ):
        queue.note_error(can.Message(arbitration_id=identifier, data=data, is_error_frame=True))
    assert queue.dropped == 1


def test_a_bus_without_a_socket_tells_nothing():
    queue = ReceiveQueue()
    with can.Bus(interface="virtual", channel="receive-queue") as bus:
        queue.attach(bus)
        queue.poll(0.0)
    assert queue.dropped == 0
