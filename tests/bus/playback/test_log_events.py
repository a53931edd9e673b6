"""A log of another program tells the same of the arm as the event log did while it was live."""

from __future__ import annotations

import math
from datetime import UTC, datetime

import pytest

from armui.arm.device import RecordedArm
from armui.arm.other_hosts import OtherTraffic
from armui.arm.state import ArmState
from armui.control.event_log.log_events import entry_of, log_events
from armui.control.event_log.log_status import status_changes
from armui.control.event_log.observer import EventObserver
from armui.control.event_log.status_listener import StatusListener
from armui.control.event_log.writer import EventWriter
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.session.session import MarkKind, SessionMark
from armui.sim.faults.schedule import Fault
from armui.telemetry.events import Asker, EventKind, EventLog, Level
from armui.ui.watch.replay.log_time import wall_time
from armui.ui.watch.replay.time_line import mark_text
from armui.ui.words import event_log as words
from tests.bus.playback.logs import EACH_FAULT, log_with
from tests.session.indexed import open_indexed
from tests.session.recordings import START_S, frames, greeting, write

TWO = Generation.TWO
HOT = {"code": "joint", "joint": 3, "what": "MotorOvertemperature"}
LOST = "12 frames are missing in the log: the disk is too slow"
GENERATIONS = pytest.mark.parametrize("generation", [Generation.ONE, Generation.TWO])


def wall(at_s):
    return datetime.fromtimestamp(at_s, UTC)


def noted_live(session, generation, size=7):
    """What the listener of a program that is connected notes, and everything it took in."""
    codec, listener = Codec(generation), StatusListener()
    listener.on_open(None)
    listener.know_generation(generation)
    listener.on_codec(codec)
    known, batch = [], []
    for heard in session.frames_between(-math.inf, math.inf):
        for row in heard:
            batch.append((codec.decode(row.frame), row.time_s, row.frame, 0))
            if len(batch) == size:
                listener.on_heard(batch)
                known += listener.take_changes()
                batch = []
    listener.on_heard(batch)
    return known + listener.take_changes()


def live_log(session, generation):
    """The event log of a program that hears the frames as they come."""
    log = EventLog()
    writer = EventWriter(log, wall)
    observer = EventObserver()
    for heard in noted_live(session, generation):
        for change in observer.observe([heard], ArmState(), OtherTraffic(), heard.at_s):
            writer.write(change)
    return log


def told(entries):
    return [
        (each.at_s, each.ended_s, each.level, each.kind, each.who, words.entry_text(each),
         each.count, each.unheard)
        for each in entries
    ]  # fmt: skip


@pytest.mark.each_value(full="each fault in both generations")
@GENERATIONS
@pytest.mark.parametrize("fault", ["", *EACH_FAULT])
def test_every_change_is_noted_as_it_is_live(tmp_path, fault, generation):
    session = log_with(tmp_path, fault, generation, seconds=2.4)

    assert status_changes(session, session.channels[0], Codec(generation)) == noted_live(
        session, generation
    )
    session.close()


@pytest.mark.each_value(full="each fault in both generations")
@GENERATIONS
@pytest.mark.parametrize("fault", EACH_FAULT)
def test_faults_and_changes_of_status_come_in_the_same_order_as_live(tmp_path, fault, generation):
    session = log_with(tmp_path, fault, generation, seconds=2.4)
    expected = told(each for each in live_log(session, generation).entries())

    log = log_events(session, session.channels[0], RecordedArm(int(generation)), wall).log
    found = [each for each in log.entries() if each.who is Asker.ARM]

    assert len(expected) >= 3
    assert told(found) == expected
    assert [each.at_s for each in log.entries()] == sorted(each.at_s for each in log.entries())
    session.close()


def silent_log(tmp_path):
    """Nothing is heard from 1.5 s to 2.3 s."""
    path = tmp_path / "silent.blf"
    heard = frames(6.0, faults=(Fault("overcurrent", 2, 1.1, 1.4),), asked=greeting(TWO))
    write(path, (each for each in heard if not 1.5 <= each[0] - START_S < 2.3))
    return open_indexed(path)


def test_a_silence_and_its_end_are_told_as_live(tmp_path):
    session = silent_log(tmp_path)
    log = log_events(session, session.channels[0], RecordedArm(2), wall).log

    (offline,) = (each for each in log.entries() if each.code == "offline")
    assert offline.at_s == pytest.approx(START_S + 1.5, abs=0.02)
    assert offline.ended_s == pytest.approx(START_S + 2.3, abs=0.02)
    before, after = (each for each in log.entries() if each.code == "joint_fault")
    assert before.unheard
    assert before.ended_s == pytest.approx(offline.at_s, abs=0.001)
    assert after.goes_on
    noted = status_changes(session, session.channels[0], Codec(TWO))
    assert noted == noted_live(session, TWO)
    assert {each.name for each in noted} >= {"gap", "rate"}
    session.close()


def test_the_host_s_commands_stand_between(tmp_path):
    session = log_with(tmp_path, "")
    log = log_events(session, session.channels[0], RecordedArm(2), wall).log

    by_host = [each for each in log.entries() if each.who is Asker.OTHER_HOST]
    assert [words.entry_text(each) for each in by_host] == ["Motors: enable sent"]
    assert by_host[0].kind is EventKind.COMMAND
    assert by_host[0].at_s == pytest.approx(session.start_s + 0.9, abs=0.11)
    session.close()


@pytest.mark.parametrize(
    ("entry", "text"),
    [
        ({"code": "status", "status": 7}, "Arm: Arm status: Collision"),
        ({"code": "stopped", "status": 1}, "Arm: Arm status: Emergency stop"),
        ({"code": "beyond_limit", "joint": 2}, "Arm: J2 beyond its angle limit"),
        ({"code": "no_communication", "joint": 2}, "Arm: J2 Joint communication: Abnormal"),
        (HOT, "Arm: J3 Motor temperature: Too hot"),
        ({"code": "stop_sent"}, "Other host: Emergency stop sent"),
        ({"code": "target", "message": "MitControl1"}, "Other host: MIT commands begin"),
        ({"code": "something newer"}, "Program: Unknown event: something newer"),
        ({"kind": "lost", "count": 12}, f"Program: {LOST}"),
        ({"number": "many"}, "Program: Unknown event: ?"),
    ],
)  # fmt: skip
def test_marks_are_put_into_the_words_of_the_events(entry, text):
    assert mark_text(SessionMark(12.5, MarkKind.FAULT, entry)) == text


def test_a_fault_that_nobody_knows_is_as_grave_as_its_mark():
    unknown = entry_of(SessionMark(12.5, MarkKind.FAULT, {"code": "newer"}), wall_time)
    assert (unknown.level, unknown.at_s) == (Level.FAULT, 12.5)
