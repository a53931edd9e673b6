"""A backlog read after a stall is no news; after a sleep of the PC nothing of before goes on."""

from contextlib import contextmanager

import can
import pytest
from can.interfaces.virtual import VirtualBus

from armui.arm.device import Device
from armui.bus.worker import BusWorker
from armui.control.link.link_state import LinkState
from armui.control.motion.jog_path import JointJog
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from tests.accepted import accepted

ANGLES = can.Message(arbitration_id=0x2A5, data=bytes(8), is_extended_id=False)
SLEEP_S = 7200.0


class StalledBus(VirtualBus):
    """A bus with a backlog: the reader was held up by its driver before it came to look."""

    def __init__(self, frames):
        super().__init__("stalled")
        self.frames = frames
        self.stall = lambda: None

    def recv(self, timeout=None):
        self.stall()
        return self.frames.pop(0) if self.frames else None

    def send(self, msg, timeout=None):
        """Takes three seconds the first time."""


@pytest.fixture
def clock():
    return [1000.0]


def test_frames_of_a_backlog_are_not_dated_now(qapp, clock):
    bus = StalledBus([])

    @contextmanager
    def opener(_device):
        yield bus

    worker = BusWorker(
        Device("slcan", "tty", None), opener, Codec(Generation.TWO), lambda: clock[0]
    )
    worker._outbox.attach(bus)
    worker._received.emptied()
    clock[0] += 3.0
    bus.frames = [ANGLES] * 3
    worker._receive_burst(bus)
    worker._processor.publish()
    assert worker.state.last_feedback_s == 1000.0
    bus.frames = [ANGLES]
    worker._receive_burst(bus)
    worker._processor.publish()
    assert worker.state.last_feedback_s == 1003.0
    assert worker.state.silences == 1
    bus.frames, bus.stall = [ANGLES] * 3, lambda: clock.append(clock.pop() + 0.2)
    worker._receive_burst(bus)  # held up while it waits: that is no time of theirs either
    worker._processor.publish()
    assert worker.state.last_feedback_s == 1003.0
    bus.shutdown()


def test_after_a_sleep_nothing_of_before_goes_on(any_rig):
    rig = any_rig
    rig.ready()
    accepted(rig.controller.jogging.start(JointJog(1, 1)))
    rig.run_until(lambda: rig.controller.operating_state.jogging)
    rig._settle()
    rig.time_s += SLEEP_S  # both clocks go on; nobody looks, nobody says a word
    rig.step()
    assert not rig.controller.jogging.active
    rig.step()
    rig.run_until(lambda: rig.codes().count("limits_read") == 2)
    assert rig.controller.operating_state.link is LinkState.ONLINE
    rig.heard()
    rig.run(1.0)
    moving = {0x151, 0x155, 0x156, 0x157}
    assert not moving & {frame.arbitration_id for frame in rig.heard()}
