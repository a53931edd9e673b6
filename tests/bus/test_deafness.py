"""An adapter that sends, hears nothing and reports no error is told from an arm that is silent."""

import socket
from contextlib import closing

import can
import pytest

from armui.arm.device import Device
from armui.bus.line_bus import LineBus
from armui.bus.link import BUS_DEAF, BusHealth
from armui.protocol.frame_records import RECORD_BYTES
from armui.protocol.generation import Generation
from armui.sim.arm_choice import HAND, ArmChoice
from armui.sim.faults.schedule import fault
from armui.sim.line_arm import LineArm
from armui.system.record_socket import RecordSocket

CAN0 = Device("socketcan", "can0", None)
NOT_ACKNOWLEDGED = 0x020


class Silence:
    """A bus on which nothing is heard; what is sent is taken, the program's questions, too."""

    def __init__(self, device=CAN0, *, sends=True):
        self.health = BusHealth(device)
        self.now_s, self.sent, self.asked, self.sends = 100.0, 0, 0, sends

    def run(self, seconds):
        for _ in range(round(seconds / 0.01)):
            self.now_s += 0.01
            if self.health.follow_silence(self.now_s, self.sent):
                self.asked += 1
                self.sent += self.sends
        return self.health.problem(self.now_s, blocked=False)


def test_an_adapter_that_sends_and_hears_nothing_is_deaf():
    silence = Silence()
    assert silence.run(1.9) is None
    problem = silence.run(0.2)
    assert (problem.reason, problem.params["device"]) == (BUS_DEAF, CAN0.name)
    assert problem.params["count"] == "3"
    silence.sent += 30  # a stop, pressed again and again
    assert silence.run(10.0) is problem
    assert silence.asked == 3  # it is not asked for ever
    silence.health.on_frame(silence.now_s)
    assert silence.run(0.3) is None
    assert silence.run(5.0) is None
    assert silence.asked == 3  # nor is an arm that was heard: its answers would end its silence
    silence.sent += 9  # a stop
    assert silence.run(0.1).params["count"] == "9"  # of this silence


def test_who_reports_errors_is_not_deaf():
    silence = Silence()
    silence.run(0.6)
    silence.health.on_error_frame(NOT_ACKNOWLEDGED)
    assert silence.run(5.0) is None
    assert silence.asked == 1  # nothing is sent on a bus that nobody acknowledges on
    told = Silence()
    assert told.run(3.0) is not None
    told.health.on_error_frame(NOT_ACKNOWLEDGED)
    assert told.run(1.0) is None


@pytest.mark.parametrize(
    "silence",
    [
        Silence(sends=False),  # one that only listens
        Silence(Device("udp_multicast", "239.74.163.2", None)),
        Silence(Device("socketcan", "vcan0", None)),
    ],
)
def test_nothing_is_said_where_nothing_went_out_or_no_adapter_is(silence):
    assert silence.run(10.0) is None


def test_a_bus_that_is_heard_is_not_asked():
    silence = Silence()
    for _ in range(20):
        silence.run(0.3)
        silence.health.on_frame(silence.now_s)
    assert silence.asked == 0


@pytest.mark.parametrize(
    ("name", "acknowledged"), [("deaf-adapter", True), ("bus-off", False), ("power-off", False)]
)
def test_only_an_arm_that_is_there_acknowledges(name, acknowledged):
    """On the line to the simulated arm, as on a bus of two."""
    (frames, there), (hands, hand_there) = socket.socketpair(), socket.socketpair()
    hand_line = RecordSocket(hand_there, HAND.size)
    bus = LineBus("arm", RecordSocket(frames, RECORD_BYTES))
    line = RecordSocket(there, RECORD_BYTES)
    arm = LineArm(ArmChoice(Generation.TWO), line, hand_line)
    with bus, hands, closing(line), closing(hand_line):
        arm.faults.start(fault(name))
        arm.poll(0.02)
        assert bus.recv(0.0) is None
        bus.send(can.Message(arbitration_id=0x472, data=bytes(8), is_extended_id=False))
        arm.poll(0.02)
        told = bus.recv(0.0)
        assert arm.received == 1
        if acknowledged:
            assert told is None
        else:
            assert (told.is_error_frame, told.arbitration_id) == (True, NOT_ACKNOWLEDGED)
