"""A line to another process as python-can's bus: frames, a full line, its end."""

import socket

import can
import pytest

from armui.arm.device import Device
from armui.bus.adapters import SIMULATED_ARM_ENDED, explain
from armui.bus.line_bus import LineBus
from armui.bus.send_errors import obeys_its_timeout, queue_is_full
from armui.protocol.frame import Frame
from armui.protocol.frame_records import RECORD_BYTES, pack, unpack
from armui.system.failures import is_our_own
from armui.system.record_socket import RecordSocket

STOP = Frame(0x150, bytes.fromhex("0100000000000000"))
DEVICE = Device("virtual", "armui-simulated-2", None, simulated=True, generation=2)


@pytest.fixture
def line():
    """The bus, and the other end."""
    ours, theirs = socket.socketpair()
    other = RecordSocket(theirs, RECORD_BYTES)
    with LineBus("x", RecordSocket(ours, RECORD_BYTES)) as bus:
        yield bus, other
    other.close()


def message(frame):
    return can.Message(arbitration_id=frame.arbitration_id, data=frame.data, is_extended_id=False)


def test_frames_of_one_message_are_heard_one_by_one(line):
    bus, other = line
    frames = [Frame(0x2A1 + i, bytes([i] * 8)) for i in range(15)]
    other.send(pack(frames))
    heard = [bus.recv(1.0) for _ in frames]
    assert [Frame(each.arbitration_id, bytes(each.data)) for each in heard] == frames
    assert all(each.is_rx and not each.is_extended_id for each in heard)
    assert bus.recv(0.0) is None


def test_a_frame_is_sent(line):
    bus, other = line
    bus.send(message(STOP), timeout=0.0)
    assert unpack(other.receive(1.0)) == [STOP]


def send_until_it_fails(bus):
    for _ in range(1_000_000):
        bus.send(message(STOP), timeout=0.0)


def test_a_full_line_is_a_full_transmit_queue(line):
    bus, _other = line
    with pytest.raises(TimeoutError) as raised:
        send_until_it_fails(bus)
    assert queue_is_full(raised.value)
    assert obeys_its_timeout(bus)  # a stop is written by the thread of its press


def test_the_end_of_the_line_is_a_lost_device_and_no_error_of_ours(line):
    bus, other = line
    other.close()
    with pytest.raises(ConnectionError) as raised:
        bus.recv(1.0)
    assert explain(DEVICE, raised.value) == SIMULATED_ARM_ENDED()
    assert not is_our_own(raised.value)
    with pytest.raises(ConnectionError) as raised:
        send_until_it_fails(bus)
    assert not queue_is_full(raised.value)


def test_closing_the_bus_closes_the_line(line):
    bus, other = line
    bus.shutdown()
    with pytest.raises(ConnectionError):
        other.receive(1.0)
