"""The bus over UDP multicast: what comes back of ours is ours, what others say is theirs."""

import socket
import time

import can
import pytest
from can.interfaces.udp_multicast import UdpMulticastBus

from armui.arm.device import Device
from armui.bus.adapters import open_bus
from armui.bus.multicast import MulticastBus
from armui.bus.send_errors import obeys_its_timeout
from armui.bus.worker import is_own_echo
from armui.system.clock import steady_s

GROUP = "239.74.163.7"


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("", 0))
        port: int = free.getsockname()[1]
    return port


@pytest.fixture
def buses():
    port = free_port()
    device = Device("udp_multicast", GROUP, None, options=(("port", port),))
    with open_bus(device) as ours, can.Bus(GROUP, "udp_multicast", port=port) as other:
        yield ours, other


def frame(data: int) -> can.Message:
    return can.Message(arbitration_id=0x151, data=[data], is_extended_id=False)


def refuse(*_arguments) -> None:
    raise can.CanOperationError("no buffer")


def heard(bus: can.BusABC) -> tuple[int, bool]:
    message = bus.recv(5.0)
    assert message is not None
    return message.data[0], is_own_echo(message, "udp_multicast")


def test_frames_of_ours_come_back_as_ours_and_those_of_another_as_theirs(buses):
    ours, other = buses
    ours.send(frame(1))
    assert heard(ours) == (1, True)
    other.send(frame(1))
    assert heard(ours) == (1, False)
    ours.send(frame(2))
    ours.send(frame(2))
    other.send(frame(3))
    assert [heard(ours) for _ in range(3)] == [(2, True), (2, True), (3, False)]
    assert [heard(other)[0] for _ in range(5)] == [1, 1, 2, 2, 3]


def test_what_the_system_did_not_take_is_not_expected_back(buses, monkeypatch):
    ours, other = buses
    with monkeypatch.context() as patched:
        patched.setattr(ours._multicast, "send", refuse)
        with pytest.raises(can.CanOperationError):
            ours.send(frame(4))
    other.send(frame(4))
    assert heard(ours) == (4, False)


def test_a_frame_that_was_lost_excuses_none_of_another_host_later(buses, monkeypatch):
    ours, _other = buses
    monkeypatch.setattr("armui.bus.multicast.steady_s", lambda: steady_s() - 3.0)
    ours.send(frame(5))
    monkeypatch.undo()
    assert heard(ours) == (5, False)


@pytest.mark.parametrize("by_s", [3600.0, -3600.0], ids=["forward", "back"])
def test_a_clock_that_is_set_makes_no_other_host_of_us(buses, monkeypatch, by_s):
    """Between sending a frame and its coming back, by an hour."""
    ours, _other = buses
    day = time.time
    monkeypatch.setattr("armui.bus.multicast.time.time", lambda: day() - by_s)
    ours.send(frame(6))
    monkeypatch.undo()
    assert heard(ours) == (6, True)


def test_its_send_returns_in_time(buses):
    assert obeys_its_timeout(buses[0])


def test_the_port_stands_behind_the_group_and_keeps_arms_apart():
    ports = free_port(), free_port()
    first, second = (Device("udp_multicast", f"{GROUP}:{port}", None) for port in ports)
    with (
        open_bus(first) as ours,
        open_bus(second) as elsewhere,
        can.Bus(GROUP, "udp_multicast", port=ports[0]) as other,
    ):
        other.send(frame(1))
        assert heard(ours) == (1, False)
        assert elsewhere.recv(0.2) is None


@pytest.mark.parametrize(
    ("channel", "group", "port"),
    [
        (":45001", UdpMulticastBus.DEFAULT_GROUP_IPv6, 45001),
        ("[ff15::7]:45002", "ff15::7", 45002),
        ("239.1.2.3:45003", "239.1.2.3", 45003),
        ("239.1.2.3", "239.1.2.3", None),
        (UdpMulticastBus.DEFAULT_GROUP_IPv6, UdpMulticastBus.DEFAULT_GROUP_IPv6, None),
        ("ff15::7", "ff15::7", None),
    ],
)
def test_group_and_port(channel, group, port, monkeypatch):
    told = []
    take = lambda _self, *words, **more: told.append((*words, more))  # noqa: E731
    monkeypatch.setattr(UdpMulticastBus, "__init__", take)
    monkeypatch.setattr(MulticastBus, "__del__", lambda _self: None)
    MulticastBus(channel)
    assert told == [(group, {} if port is None else {"port": port})]
