"""S1, S2, S15, S22, S23: whatever a frame holds, it costs nothing but itself.

Every value of every byte of every message, of both generations, and of every length.
"""

from __future__ import annotations

import logging
from collections.abc import Iterator

import can
import pytest

from armui.arm.limits import JOINTS
from armui.arm.tracker import Tracker
from armui.bus.frame_processor import FrameProcessor
from armui.control.event_log.status_listener import StatusListener
from armui.control.link.link_state import LinkState
from armui.protocol.codec import Codec, InvalidFrame
from armui.protocol.firmware_version import FirmwareVersion
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware
from armui.sim.node import Node
from armui.telemetry.bus_statistics import BusStatistics
from armui.telemetry.store import Telemetry
from tests.bus.playback.logs import Player
from tests.session.indexed import open_indexed
from tests.session.recordings import START_S, write

ONE = Codec(Generation.ONE)
TWO = Codec(Generation.TWO)
BEFORE_1_8_8 = Codec(Generation.TWO, firmware=FirmwareVersion(1, 8, 5))
EACH_CODEC = pytest.mark.parametrize(
    "codec", [ONE, TWO, BEFORE_1_8_8], ids=["generation 1", "generation 2", "until 1.8-7"]
)
EACH_GENERATION = pytest.mark.parametrize("generation", Generation)

LIMITS, ACCELERATION = 0x473, 0x47C
NAMES_A_JOINT = (0x471, 0x472, LIMITS, 0x474, 0x475, ACCELERATION)
"""Messages whose first byte names a joint; 0x121, the lamps, has it in its second."""


def ordinary(layout) -> bytes:
    """A payload that the tables allow: 0 where it may be, else the smallest value."""
    raw = {}
    for name, signal in layout.signals.items():
        low = round(signal.to_steps(signal.minimum))
        raw[name] = 0 if 0 in signal.legal_raw else low
    if layout.selector is None:
        return layout.pack(raw)
    variant = next(iter(layout.variants.values()))
    raw[layout.selector.name] = next(iter(layout.variants))
    return variant.pack({name: raw[name] for name in variant.signals})


def every_byte_of(codec: Codec) -> Iterator[Frame]:
    """Each value of each byte of each message beside ordinary ones, and every length."""
    for arbitration_id, layout in codec.layouts.items():
        for base in {ordinary(layout), bytes(layout.length), b"\xff" * layout.length}:
            for place in range(layout.length):
                for value in range(256):
                    yield Frame(arbitration_id, base[:place] + bytes((value,)) + base[place + 1 :])
        for length in range(9):
            yield Frame(arbitration_id, b"\xff" * length)


class Ear:
    """A frame processor with everybody who listens in the program."""

    def __init__(self, codec: Codec) -> None:
        self.now_s = 1000.0
        clock = lambda: self.now_s  # noqa: E731
        self.listeners = (Telemetry(clock), BusStatistics(clock), StatusListener())
        for listener in self.listeners:
            listener.know_generation(codec.generation)
        self.processor = FrameProcessor(codec, self.listeners, lambda answer: None)
        self.processor.notifier.open(codec, 1_000_000)
        self.processor.samples.wanted = True

    def hear(self, frame: Frame, flags: int = 0) -> None:
        self.now_s += 0.0005
        self.processor.process(frame, self.now_s, flags)

    def look(self) -> None:
        self.processor.notifier.flush(self.processor.codec, self.now_s)
        self.processor.publish()


@EACH_GENERATION
def test_every_value_of_every_byte_is_taken_in_live(generation, caplog):
    codec = Codec(generation)
    ear = Ear(codec)
    count = 0
    for frame in every_byte_of(codec):
        ear.hear(frame)
        count += 1
        if count % 256 == 0:
            ear.look()
    ear.look()

    assert ear.processor.state.frames == count > 100_000
    assert ear.processor.notifier._active == list(ear.listeners)  # nobody has failed
    assert [record for record in caplog.records if record.levelno >= logging.ERROR] == []


@EACH_CODEC
def test_no_message_names_a_joint_that_is_none(codec):
    """0x471, 0x475: 7 means all."""
    for frame in every_byte_of(codec):
        said = codec.decode(frame)
        message = said.message if isinstance(said, InvalidFrame) else said
        if message is not None and "Joint" in message.signals:
            most = 7 if message.name in {"MotorEnable", "JointSetting"} else 6
            assert 1 <= message.signals["Joint"] <= most


@EACH_GENERATION
def test_every_value_of_every_byte_is_taken_in_by_the_simulated_arm(generation):
    arm = Firmware(generation)
    told = None
    for count, frame in enumerate(every_byte_of(Codec(generation))):
        if frame.arbitration_id != told:  # what it obeyed may have made it silent, or a leader
            arm, told = Firmware(generation), frame.arbitration_id
        arm.on_frame(frame)
        if count % 512 == 0:
            arm.step(0.005)


@pytest.mark.each_value(full="each joint in both generations")
@EACH_GENERATION
@pytest.mark.parametrize("joint", [0, 7, 8, 127, 128, 250, 255])
def test_limits_of_no_joint_change_none(generation, joint):
    """Joint 0 was joint 6: 0 to 245.7°, 1,408°/s²."""
    tracker = Tracker(Codec(generation))
    codec = Codec(generation)
    for each in JOINTS:
        tracker.update(
            codec.decode(codec.encode("LimitFeedback", Joint=each, MinAngle=-90, MaxAngle=90)), 1.0
        )
        tracker.update(codec.decode(codec.encode("AccelerationFeedback", Joint=each)), 1.0)
    before = tracker.snapshot()

    tracker.update(codec.decode(Frame(LIMITS, bytes((joint, 9, 0x99, 0, 0, 1, 2, 0)))), 2.0)
    tracker.update(codec.decode(Frame(ACCELERATION, bytes((joint, 9, 0x99, 0, 0, 0, 0, 0)))), 2.0)

    after = tracker.snapshot()
    assert (after.limits, after.accelerations_deg_s2) == (
        before.limits,
        before.accelerations_deg_s2,
    )
    assert after.invalid_frames == {"VALUE_OUTSIDE_TABLE": 2}
    assert after.frames == before.frames + 2


def test_a_live_arm_is_heard_on_and_stops(rig):
    """With the real bus thread: the connection stays, the next frames count, the stop is told."""
    rig.ready()
    limits = rig.controller.operating_state.limits
    with can.Bus(interface="virtual", channel=rig.channel) as stranger:
        for arbitration_id in NAMES_A_JOINT:
            for joint in (0, 7, 8, 100, 255):
                if arbitration_id in {0x471, 0x475} and joint == 7:
                    continue  # that is all of them
                data = bytes((joint,)) + b"\x01" * 7
                message = can.Message(
                    arbitration_id=arbitration_id, data=data, is_extended_id=False
                )
                stranger.send(message)
            rig.step()
            assert rig.controller.operating_state.link is LinkState.ONLINE
    assert rig.controller.operating_state.limits == limits

    rig.heard()
    rig.controller.emergency_stop()
    rig.run(0.2)

    assert rig.heard()[0] == Frame(0x150, bytes((1, 0, 0, 0, 0, 0, 0, 0)))
    assert rig.firmware.condition.stopped
    assert "link_lost" not in rig.codes()


def test_a_frame_that_nobody_expected_costs_itself_alone(rig, monkeypatch, caplog):
    """The last line: should taking in a frame ever fail, it is counted, told once, and gone."""
    rig.ready()
    update = Tracker.update

    def fails(self, heard, at_s):
        if getattr(heard, "name", "") == "EndPose1":
            raise ZeroDivisionError("nobody expected this")
        update(self, heard, at_s)

    monkeypatch.setattr(Tracker, "update", fails)
    before = rig.controller.state.invalid_frames
    rig.run(0.4)

    state = rig.controller.state
    assert rig.controller.operating_state.link is LinkState.ONLINE
    assert sum(state.invalid_frames.values()) - sum(before.values()) >= 10
    told = [each for each in caplog.records if each.exc_info]
    assert len(told) == 1
    assert "0x2A2" in told[0].getMessage()
    rig.controller.emergency_stop()
    rig.run(0.2)
    assert rig.firmware.condition.stopped


@pytest.mark.timeout(180)
@EACH_GENERATION
def test_every_value_of_every_byte_is_replayed(tmp_path, generation, caplog):
    """One such frame stopped the replay there for good."""
    codec = Codec(generation)
    told = list(every_byte_of(codec))
    path = tmp_path / "strange.blf"
    write(path, ((START_S + place * 1e-3, frame) for place, frame in enumerate(told)))
    session = open_indexed(path)
    for speed in (1.0, 20.0):
        player = Player(session, generation)
        player.go_to(session.start_s - 1.0)
        player.play_to(session.end_s + 1.0, speed)
        assert player.player.played == len(told), speed
        assert player.player.processor.notifier._active, speed
        assert player.player.step() is None, speed
        for share in (0.3, 0.7, 1.0):
            player.go_to(session.start_s + share * (session.end_s - session.start_s))
    session.close()
    assert [record for record in caplog.records if record.levelno >= logging.ERROR] == []


def test_the_simulated_arm_lives_on_when_a_frame_breaks_it(monkeypatch, caplog):
    arm = Firmware(Generation.TWO)
    with can.Bus(interface="virtual", channel="breaks") as bus:
        node = Node(arm, bus)
        failures = iter([ZeroDivisionError("nobody expected this")])
        poll = node.poll
        polled = []

        def fails_once(dt_s):
            for failure in failures:
                raise failure
            poll(dt_s)
            polled.append(dt_s)
            if len(polled) == 3:
                node._ending.set()

        monkeypatch.setattr(node, "poll", fails_once)
        node.start()
        assert node._thread is not None
        node._thread.join(5.0)
        node.stop()

    assert len(polled) >= 3
    assert [each.levelname for each in caplog.records if each.exc_info] == ["ERROR"]
