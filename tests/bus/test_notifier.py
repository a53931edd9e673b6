"""What a listener on the bus thread is told; and that its faults hold up nobody."""

import logging
from contextlib import contextmanager

import can
import pytest

from armui.arm.device import Device
from armui.bus.link import BusState
from armui.bus.worker import BusWorker
from armui.protocol.codec import Codec, InvalidFrame
from armui.protocol.frame import Frame, FrameFlag
from armui.protocol.generation import Generation
from armui.telemetry.listener import Listener
from armui.ways.passes import Pass

# J1 12.000° = 12,000 = 0x00002EE0, J2 −12.000°
JOINTS_12 = can.Message(
    arbitration_id=0x2A5, data=bytes.fromhex("00002EE0FFFFD120"), is_extended_id=False
)
TARGET = Frame(0x155, bytes.fromhex("000003E8000007D0"))
STOP = Frame(0x150, bytes.fromhex("0100000000000000"))


class Ear(Listener):
    """Notes what it is told."""

    def __init__(self):
        self.opened, self.codecs, self.heard, self.sent = [], [], [], []
        self.errors = self.looks = 0
        self.broken = None

    def on_open(self, bitrate):
        self.opened.append(bitrate)

    def on_codec(self, codec):
        self.codecs.append(codec.generation)

    def on_heard(self, batch):
        if self.broken:
            raise self.broken
        self.heard += batch

    def on_sent(self, batch):
        self.sent += batch

    def on_error_frame(self):
        self.errors += 1

    def on_look(self, now_s):
        self.looks += 1


@pytest.fixture
def rig(qtbot, request):
    class Rig:
        def __init__(self):
            self.ear = Ear()
            self.arm = can.Bus(interface="virtual", channel=request.node.nodeid)
            self.reports: list[BusState] = []
            self.wait = qtbot.waitUntil
            device = Device("virtual", request.node.nodeid, 500_000)
            codec = Codec(Generation.TWO)
            self.worker = BusWorker(device, self.open, codec, listeners=[self.ear])
            self.worker.reported.connect(lambda report: self.reports.append(report.state))

        @contextmanager
        def open(self, device):
            with can.Bus(interface="virtual", channel=device.channel) as bus:
                yield bus

    rig = Rig()
    rig.worker.start()
    rig.wait(lambda: BusState.OPEN in rig.reports)
    yield rig
    rig.worker.close(5000)
    rig.arm.shutdown()


def test_it_hears_every_frame_with_its_time(rig):
    for _ in range(50):
        rig.arm.send(JOINTS_12)
    rig.arm.send(can.Message(arbitration_id=0x7FF, data=b"", is_extended_id=False))
    rig.wait(lambda: len(rig.ear.heard) == 51)
    *messages, odd = rig.ear.heard
    assert {message.name for message, _at_s, _frame, _flags in messages} == {"JointFeedback12"}
    assert messages[0][0].signals == {"J1": 12.0, "J2": -12.0}
    times = [at_s for _message, at_s, _frame, _flags in rig.ear.heard]
    assert times == sorted(times)
    assert isinstance(odd[0], InvalidFrame)
    assert [len(frame.data) for _message, _at_s, frame, _flags in rig.ear.heard[-2:]] == [8, 0]
    assert rig.ear.opened == [500_000]
    assert rig.ear.codecs == [Generation.TWO]


def test_it_hears_what_the_program_sends_and_when_it_was_out(rig):
    rig.worker.send([TARGET, TARGET], passed=Pass())
    rig.worker.send_urgent([STOP])
    rig.wait(lambda: len(rig.ear.sent) >= 1 and rig.ear.sent[-1][0].name == "MotionCommand")
    assert rig.ear.sent[-1][0].signals["EmergencyStop"] == 1
    for message, _at_s, _frame, _flags in rig.ear.sent[:-1]:
        assert message.signals == {"J1": 1.0, "J2": 2.0}
    assert rig.ear.heard == []


def test_it_hears_of_another_codec_between_what_was_decoded_by_the_two(rig):
    rig.arm.send(JOINTS_12)
    rig.wait(lambda: len(rig.ear.heard) == 1)
    rig.worker.use_codec(Codec(Generation.ONE))
    rig.arm.send(JOINTS_12)
    rig.wait(lambda: len(rig.ear.heard) == 2)
    assert rig.ear.codecs == [Generation.TWO, Generation.ONE]


def test_error_frames_are_told(rig):
    rig.arm.send(can.Message(is_error_frame=True, arbitration_id=0x20))
    rig.wait(lambda: rig.ear.errors == 1)


def test_one_that_fails_is_told_no_more_and_nothing_else_suffers(rig, caplog):
    rig.ear.broken = ValueError("broken")
    with caplog.at_level(logging.ERROR):
        rig.arm.send(JOINTS_12)
        rig.wait(lambda: rig.worker.state.joints_deg[0] is not None)
        rig.wait(lambda: "it is told no more" in caplog.text)
    rig.ear.broken = None
    rig.arm.send(JOINTS_12)
    rig.wait(lambda: rig.worker.state.frames == 2)
    assert rig.ear.heard == []
    assert rig.reports == [BusState.OPENING, BusState.OPEN]
    rig.worker.send([TARGET], passed=Pass())
    said = rig.arm.recv(2.0)
    assert said is not None
    assert said.arbitration_id == 0x155


def test_another_one_listens_on_while_one_fails(rig):
    other = Ear()
    rig.worker.set_listeners([rig.ear, other])
    rig.wait(lambda: other.codecs == [Generation.TWO])
    rig.ear.broken = ValueError("broken")
    rig.arm.send(JOINTS_12)
    rig.wait(lambda: len(other.heard) == 1)
    rig.arm.send(JOINTS_12)
    rig.wait(lambda: len(other.heard) == 2)
    assert rig.ear.heard == []


def test_one_that_comes_late_is_told_of_the_device_and_one_that_left_nothing(rig):
    late = Ear()
    rig.worker.set_listeners([late])
    rig.wait(lambda: late.opened == [500_000] and late.codecs == [Generation.TWO])
    rig.arm.send(JOINTS_12)
    rig.wait(lambda: len(late.heard) == 1)
    assert rig.ear.heard == []
    looks = rig.ear.looks
    rig.wait(lambda: late.looks > 5)
    assert rig.ear.looks <= looks + 1


def test_what_sort_of_frame_it_was_is_told_with_its_bytes(rig):
    rig.arm.send(can.Message(arbitration_id=0x18FF1234, data=b"ab", is_extended_id=True))
    rig.arm.send(JOINTS_12)
    rig.worker.send([TARGET], passed=Pass())
    rig.wait(lambda: len(rig.ear.heard) == 2 and len(rig.ear.sent) == 1)
    told = [(frame, flags) for _message, _at_s, frame, flags in rig.ear.heard + rig.ear.sent]
    assert told == [
        (Frame(0x18FF1234, b"ab"), FrameFlag.EXTENDED),
        (Frame(0x2A5, bytes(JOINTS_12.data)), 0),
        (TARGET, FrameFlag.TRANSMITTED),
    ]
