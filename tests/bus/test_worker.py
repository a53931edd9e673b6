"""The bus thread against python-can's virtual bus, and against buses that break."""

import errno
from contextlib import contextmanager
from typing import Any

import can
import pytest

from armui.arm.device import Device
from armui.bus.adapters import BUS_BUSY, BUS_GONE
from armui.bus.link import BusState
from armui.bus.worker import BusWorker
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.ways.passes import Pass

JOINTS_12 = can.Message(
    arbitration_id=0x2A5, data=bytes.fromhex("00002EE0FFFFD120"), is_extended_id=False
)


class Rig:
    """A worker on a virtual bus, with the other end in the test's hand."""

    def __init__(self, channel, qtbot):
        self.qtbot = qtbot
        self.channel = channel
        self.reports: list[Any] = []
        self.failures = []
        self.lost = False
        self.bus = None
        self.worker = BusWorker(Device("virtual", channel, None), self.open, Codec(Generation.TWO))
        self.worker.reported.connect(self.reports.append)
        self.arm = can.Bus(interface="virtual", channel=channel)

    @contextmanager
    def open(self, device):
        if self.failures:
            raise self.failures.pop(0)
        with can.Bus(interface="virtual", channel=device.channel) as bus:
            self.bus = bus
            yield bus

    def unplug(self, error):
        def broken(*_args, **_kwargs):
            raise error

        self.bus.recv = broken

    def start(self):
        self.worker.start()
        self.wait_for(BusState.OPEN)

    def wait_for(self, state):
        self.qtbot.waitUntil(lambda: state in [report.state for report in self.reports])

    def close(self):
        self.worker.close(5000)
        self.arm.shutdown()


@pytest.fixture
def rig(qtbot, request):
    rig = Rig(request.node.nodeid, qtbot)
    yield rig
    rig.close()


def test_what_the_arm_says_is_in_the_picture(rig):
    rig.start()
    rig.arm.send(JOINTS_12)
    rig.qtbot.waitUntil(lambda: rig.worker.state.joints_deg[0] is not None)
    assert [heard.value for heard in rig.worker.state.joints_deg[:2]] == [12.0, -12.0]


def test_frames_reach_the_arm_in_order(rig):
    rig.start()
    assert rig.worker.send([Frame(0x475, bytes([n])) for n in range(5)])
    assert [rig.arm.recv(5).data[0] for _ in range(5)] == [0, 1, 2, 3, 4]


def test_answers_are_delivered_one_by_one(rig):
    answers: list[Any] = []
    rig.worker.answered.connect(answers.append)
    rig.start()
    for _ in range(3):
        rig.arm.send(can.Message(arbitration_id=0x476, data=[0x71, *[0] * 7], is_extended_id=False))
    rig.qtbot.waitUntil(lambda: len(answers) == 3)
    assert answers[0].signals["Index"] == 0x71


def test_frames_that_are_no_classic_11_bit_data_frames_are_counted(rig):
    rig.start()
    rig.arm.send(can.Message(arbitration_id=0x2A5, is_extended_id=True, data=bytes(8)))
    rig.arm.send(can.Message(arbitration_id=0x2A5, is_extended_id=False, is_remote_frame=True))
    rig.arm.send(can.Message(arbitration_id=0x123, is_extended_id=False, data=bytes(8)))
    rig.qtbot.waitUntil(lambda: rig.worker.state.invalid_frames.get("UNKNOWN_ID") == 3)
    assert rig.worker.state.joints_deg[0] is None


def test_a_device_that_cannot_be_opened_is_reported_and_the_thread_ends(rig):
    rig.failures = [OSError(errno.EBUSY, "busy")]
    rig.worker.start()
    rig.wait_for(BusState.FAILED)
    assert rig.reports[-1].problem.reason == BUS_BUSY
    assert rig.worker.wait(5000)
    assert not rig.worker.send([Frame(0x475, b"")])


def test_an_unplugged_device_is_noticed_and_reopened_when_it_is_back(rig):
    rig.start()
    rig.failures = [OSError(errno.ENODEV, "gone")]
    rig.unplug(can.CanOperationError("unplugged", error_code=errno.ENODEV))
    rig.wait_for(BusState.LOST)
    assert rig.reports[-1].problem.reason == BUS_GONE
    assert not rig.worker.send([Frame(0x475, b"never")])
    rig.qtbot.waitUntil(lambda: rig.reports[-1].state is BusState.OPEN)
    states = [report.state for report in rig.reports]
    assert states == [BusState.OPENING, BusState.OPEN, BusState.LOST, BusState.LOST, BusState.OPEN]
    rig.arm.send(JOINTS_12)
    rig.qtbot.waitUntil(lambda: rig.worker.state.joints_deg[0] is not None)
    assert rig.arm.recv(0) is None


def test_another_generation_can_be_spoken_from_the_next_frame_on(rig):
    rig.start()
    status = can.Message(
        arbitration_id=0x2A1,
        data=bytes.fromhex("010001000 01E0000".replace(" ", "")),
        is_extended_id=False,
    )
    rig.arm.send(status)
    rig.qtbot.waitUntil(lambda: rig.worker.state.status is not None)
    assert rig.worker.state.status.value.speed_percent is None
    rig.worker.use_codec(Codec(Generation.ONE))
    rig.qtbot.waitUntil(lambda: rig.worker.state.status is None)
    rig.arm.send(status)
    rig.qtbot.waitUntil(lambda: rig.worker.state.status is not None)
    assert rig.worker.state.status.value.speed_percent == 30


def test_what_an_adapter_echoes_of_the_programs_own_was_said_by_nobody(rig):
    rig.start()
    rig.bus.receive_own_messages = True
    targets = [Frame(target_id, bytes(8)) for target_id in (0x155, 0x156, 0x157)]
    assert rig.worker.send(targets, passed=Pass())
    assert [rig.arm.recv(1.0).arbitration_id for _ in targets] == [0x155, 0x156, 0x157]
    rig.arm.send(JOINTS_12)
    rig.qtbot.waitUntil(lambda: rig.worker.state.last_feedback_s is not None)
    assert rig.worker.state.foreign_targets_s is None
    assert rig.worker.state.frames == 1
