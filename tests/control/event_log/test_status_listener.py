"""What the bus thread notes: every change, however short, and nothing else."""

import pytest

from armui.control.event_log.status_listener import (
    GAP,
    RATE,
    STATUS,
    InvalidFrames,
    StatusChange,
    StatusListener,
)
from armui.protocol.codec import Codec
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.sim.firmware import Firmware

CODEC = Codec(Generation.TWO)
NORMAL = Frame(0x2A1, bytes.fromhex("01 00 01 00 00 00 00 00"))
COLLISION = Frame(0x2A1, bytes.fromhex("01 07 01 00 00 00 00 00"))


def slow(joint, flags):
    return Frame(0x260 + joint, bytes.fromhex("00F0 0020 20") + bytes([flags]) + bytes(2))


def tap_of(generation=Generation.TWO, codec=CODEC):
    listener = StatusListener()
    listener.on_open(1_000_000)
    listener.on_codec(codec)
    listener.know_generation(generation)
    return listener


def hear(listener, *frames, codec=CODEC, now_s=0.0):
    listener.on_heard([(codec.decode(frame), at_s, frame, 0) for frame, at_s in frames])
    listener.on_look(now_s)
    return [
        (each.name, each.at_s) for each in listener.take_changes() if isinstance(each, StatusChange)
    ]


def test_a_fault_of_one_frame_is_noted_with_its_time():
    listener = tap_of()
    frames = [(NORMAL, 1.0), (NORMAL, 1.005), (COLLISION, 1.01), (NORMAL, 1.015), (NORMAL, 1.02)]
    assert hear(listener, *frames) == [(STATUS, 1.0), (STATUS, 1.01), (STATUS, 1.015)]


def test_a_voltage_that_changes_is_no_event():
    listener = tap_of()
    frames = [
        (Frame(0x261, bytes([0, volts, 0, 32, 32, 0x40, 0, 0])), 1.0 + volts / 1000)
        for volts in range(200, 240)
    ]
    assert len(hear(listener, *frames)) == 1


def test_bits_of_unknown_meaning_are_not_told_before_the_generation_is_known():
    listener = tap_of(generation=None)
    assert hear(listener, (slow(1, 0x44), 1.0), (NORMAL, 1.0)) == [(STATUS, 1.0)]
    listener.know_generation(Generation.TWO)
    assert hear(listener, (slow(1, 0x44), 1.1), (NORMAL, 1.1)) == [
        ("DriverSlow1", 1.1),
        (STATUS, 1.1),
    ]


def test_a_codec_of_the_other_generation_tells_nothing_of_a_driver():
    listener = tap_of(generation=Generation.ONE)
    assert hear(listener, (slow(1, 0x50), 1.0)) == []


def test_silence_makes_everything_new():
    listener = tap_of()
    hear(listener, (NORMAL, 1.0), (slow(2, 0x40), 1.0))
    assert hear(listener, (NORMAL, 1.4)) == []
    assert hear(listener, (NORMAL, 2.0), (slow(2, 0x40), 2.0)) == [
        (GAP, 1.4),
        (STATUS, 2.0),
        ("DriverSlow2", 2.0),
    ]


def test_a_device_that_is_opened_again_is_new():
    listener = tap_of()
    hear(listener, (NORMAL, 1.0))
    listener.on_open(None)
    assert hear(listener, (NORMAL, 9.0)) == [(STATUS, 9.0)]


@pytest.mark.parametrize("missing", [0, 4])
def test_the_rate_is_measured_over_two_seconds(missing):
    listener = tap_of()
    frames = [(NORMAL, n * 0.005) for n in range(801) if not missing or n % missing]
    listener.on_heard([(CODEC.decode(frame), at_s, frame, 0) for frame, at_s in frames])
    rates = [each.values["hz"] for each in listener.take_changes() if each.name == RATE]
    assert rates == pytest.approx([150.0 if missing else 200.0] * len(rates), rel=0.01)
    assert rates


def test_frames_that_are_not_understood_are_counted_by_sort():
    listener = tap_of()
    garbage = [(Frame(0x4F0, b""), 1.0), (Frame(0x2A1, b"\1"), 1.1), (Frame(0x4F1, b""), 1.2)]
    listener.on_heard([(CODEC.decode(frame), at_s, frame, 0) for frame, at_s in garbage])
    assert listener.take_changes() == []
    listener.on_look(1.3)
    assert listener.take_changes() == [
        InvalidFrames("UNKNOWN_ID", 0x4F1, 2, 1.0, 1.2),
        InvalidFrames("WRONG_LENGTH", 0x2A1, 1, 1.1, 1.1),
    ]
    listener.on_look(1.4)
    assert listener.take_changes() == []


def test_an_odd_value_is_noted_and_heard():
    listener = tap_of()
    odd = Frame(0x2A1, bytes.fromhex("01 77 01 00 00 00 00 00"))
    listener.on_heard([(CODEC.decode(odd), 1.0, odd, 0)])
    listener.on_look(1.0)
    status, invalid = listener.take_changes()
    assert status.values["Status"] == 0x77
    assert invalid.sort == "VALUE_OUTSIDE_TABLE"


def test_nobody_who_takes_it_away_is_no_flood():
    listener = tap_of()
    for n in range(20_000):
        frame = COLLISION if n % 2 else NORMAL
        listener.on_heard([(CODEC.decode(frame), n * 0.005, frame, 0)])
    assert len(listener.take_changes()) <= 5_000


def what_an_arm_says():
    """Two seconds of an arm, with a collision that begins and ends, as decoded frames."""
    arm = Firmware(Generation.TWO)
    heard, at_s = [], 100.0
    for step in range(400):
        if step == 100:
            arm.set_communication_fault(4, present=True)
        if step == 250:
            arm.set_communication_fault(4, present=False)
        at_s += 0.005
        heard += [(CODEC.decode(frame), at_s, frame, 0) for frame in arm.step(0.005)]
    return heard


@pytest.mark.parametrize("size", [1, 7, 100_000])
def test_a_log_gives_the_same_events_however_it_is_cut(size):
    """Live, frames come as they come; a replay hands on what it has read."""
    heard = what_an_arm_says()
    live, listener = [], tap_of()
    for each in heard:
        listener.on_heard([each])
        live += listener.take_changes()
    again, listener = [], tap_of()
    for first in range(0, len(heard), size):
        listener.on_heard(heard[first : first + size])
        again += listener.take_changes()
    assert again == live
    broken = [
        each for each in live if each.name == STATUS and each.values.get("J4CommunicationFault")
    ]
    assert broken
