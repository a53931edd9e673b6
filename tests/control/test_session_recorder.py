"""What the operator can do about recordings of sessions, at a simulated arm."""

from __future__ import annotations

import errno
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import can
import pytest
from can.interfaces.virtual import VirtualBus

from armui.cell.cell import Cell
from armui.cell.cell_in_force import CellInForce
from armui.cell.held_objects import HeldObject
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.cell.work_area import Area, AreaBox, AreaPlane
from armui.control.sessions.choices import SessionChoices
from armui.control.sessions.session_recorder import (
    SESSION_NAME_BAD,
    SESSION_NONE,
    SESSION_RECORDED,
    SESSION_RING_EMPTY,
)
from armui.protocol.frame import Frame, FrameFlag
from armui.session.log_model import told_cell
from armui.session.recording import writer
from armui.session.recording.folder import RecordingEntry, list_recordings
from armui.session.recording.kinds import (
    SESSION_DISK_FULL,
    SESSION_FOLDER_GONE,
    SESSION_READ_ONLY,
    RecordingFormat,
)
from armui.session.recording.lane import MOST_WAITING
from armui.session.recording.recorded_session import RecordedSession
from armui.session.session import MarkKind
from armui.sim.faults.schedule import fault
from armui.telemetry.event_json import from_record
from tests.accepted import accepted


@pytest.fixture
def sessions(rig, tmp_path):
    rig.controller.sessions.choose(SessionChoices(tmp_path / "sessions"))
    return rig.controller.sessions


@pytest.fixture
def wait_for(qtbot, rig):
    """Lets the writing threads work until something is so."""

    def wait(condition):
        def looked():
            rig.controller.sessions.poll()
            return condition()

        qtbot.waitUntil(looked, timeout=10_000)

    return wait


def lines_of(folder: Path) -> list[dict[str, Any]]:
    (path,) = folder.glob("*.armui.jsonl")
    return [json.loads(line) for line in path.read_text("utf-8").splitlines()]


def opened(entry: RecordingEntry) -> RecordedSession:
    assert entry.path is not None
    return RecordedSession(entry.path)


def record(rig, sessions, wait_for, act=lambda: None) -> RecordedSession:
    assert sessions.start() is None
    act()
    rig.run(1.0)
    assert sessions.stop() is None
    wait_for(lambda: "session_ended" in rig.codes())
    (entry,) = list_recordings(sessions.choices.folder)
    return opened(entry)


def test_every_frame_of_the_bus_is_recorded_and_what_is_ours_is_marked(rig, sessions, wait_for):
    rig.ready()
    ear = VirtualBus(rig.channel)
    said: list[can.Message] = []

    def act():
        while ear.recv(0) is not None:
            pass
        rig.controller.emergency_stop()

    try:
        session = record(rig, sessions, wait_for, act)
        while (message := ear.recv(0)) is not None:
            said.append(message)
    finally:
        ear.shutdown()

    frames = [each for batch in session.frames_between(0, 1e12) for each in batch]
    assert session.start_s >= session.facts["unix_s"]
    on_bus = [(message.arbitration_id, bytes(message.data)) for message in said]
    recorded = [(each.frame.arbitration_id, each.frame.data) for each in frames]
    assert sorted(recorded[-len(on_bus) :]) == sorted(on_bus)
    ours = {each.frame.arbitration_id for each in frames if each.flags & FrameFlag.TRANSMITTED}
    assert ours == {0x150, 0x160, 0x170}
    assert all(each.flags in {0, FrameFlag.TRANSMITTED} for each in frames)


def test_a_recording_tells_arm_program_settings_and_what_happened(rig, sessions, wait_for):
    rig.ready()
    session = record(rig, sessions, wait_for, rig.controller.emergency_stop)

    kinds = [line["kind"] for line in session.lines]
    assert kinds[0] == "session"
    assert kinds[-1] == "end"
    assert session.facts["program"].startswith("armui ")
    arm = next(line for line in session.lines if line["kind"] == "arm")
    assert (arm["generation"], arm["firmware"]) == (2, rig.controller.state.firmware)
    settings = next(line for line in session.lines if line["kind"] == "settings")
    named = {(row["name"], row.get("joint")) for row in settings["values"]}
    assert ("max_angle_deg", 6) in named
    stops = [mark for mark in session.marks if mark.kind is MarkKind.STOP]
    assert stops[0].entry["code"] == "stop_sent"
    assert session.start_s <= stops[0].at_s <= session.end_s


def test_a_recording_keeps_the_cell_that_held(rig, sessions, wait_for):
    rig.ready()
    cube = HeldObject("cube", size_mm=(30.0, 40.0, 50.0))
    tray = UserFrame("tray", (300.0, 100.0, 20.0, 0.0, 0.0, 30.0))
    crate = AreaBox("crate", (900.0, 0.0, 50.0, 0.0, 0.0, 0.0))
    area = Area((AreaPlane("wall", (-900.0, 0.0, 0.0, 0.0, 90.0, 0.0), on=False),), (crate,))
    cell = Cell("bench", area=area, held_objects=(cube,), held="cube", frames=(tray,), frame="tray")
    accepted(rig.controller.cell.take(cell))
    session = record(rig, sessions, wait_for)
    assert told_cell(session.lines) == CellInForce(
        "bench", held=cube, area=Area((), (crate,)), frame=tray
    )


def test_a_recording_keeps_the_tool_that_held(rig, sessions, wait_for):
    rig.ready()
    pen = Tool("pen", (0.0, 0.0, 120.0, 0.0, 0.0, 0.0), 15.0)
    accepted(rig.controller.cell.take(Cell("bench", (pen,), "pen")))
    session = record(rig, sessions, wait_for)
    (line,) = [each for each in session.lines if each["kind"] == "cell"]
    assert (line["cell"], line["tool"]["name"], line["tool"]["z_mm"]) == ("bench", "pen", 120.0)
    assert told_cell(session.lines).tool.pose == pen.pose


def test_what_just_happened_is_saved_from_memory(rig, sessions, wait_for):
    rig.connect()
    rig.run(2.0)
    wait_for(lambda: sessions.ring().span_s > 1.5)
    held = sessions.ring()

    assert sessions.save_ring() is None
    wait_for(lambda: "ring_saved" in rig.codes())

    (entry,) = list_recordings(sessions.choices.folder)
    assert (entry.ended, entry.reason) == (True, "ring")
    session = opened(entry)
    assert session.frames >= held.frames
    assert "connected" in [mark.entry["code"] for mark in session.marks]


def test_a_stop_saves_the_ring_if_the_operator_wishes_and_not_otherwise(rig, sessions, wait_for):
    rig.ready()
    rig.controller.emergency_stop()
    rig.run(8.0)
    sessions.poll()
    assert not sessions.saving

    sessions.choose(replace(sessions.choices, save_at_faults=True))
    rig.controller.motors.resume()
    rig.run(1.0)
    rig.controller.emergency_stop()
    rig.run(4.0)
    sessions.poll()
    assert not sessions.saving
    assert "ring_saved" not in rig.codes()
    rig.run(2.0)  # what follows a stop belongs to it
    wait_for(lambda: "ring_saved" in rig.codes())
    (entry,) = list_recordings(sessions.choices.folder)
    assert entry.reason == "stop"


def test_a_fault_of_the_arm_is_marked_with_its_end_and_saves_the_ring(rig, sessions, wait_for):
    sessions.choose(replace(sessions.choices, save_at_faults=True))
    rig.ready()
    rig.node.faults.start(fault("overcurrent", 2))
    rig.run(3.0)
    sessions.poll()
    rig.run(4.0)
    wait_for(lambda: "ring_saved" in rig.codes())

    (entry,) = list_recordings(sessions.choices.folder)
    assert (entry.reason, bool(entry.faults)) == ("fault", True)
    session = opened(entry)
    faults = [mark for mark in session.marks if mark.kind is MarkKind.FAULT]
    assert session.start_s <= faults[0].at_s <= session.end_s
    for mark in session.marks:
        assert from_record(mark.entry).code == mark.entry["code"]


def test_a_lost_device_does_not_end_a_recording(rig, sessions, wait_for):
    rig.connect()

    def act():
        rig.run(0.5)
        rig.unplug(OSError(errno.ENODEV, "No such device"))
        wait_for(lambda: "link_lost" in rig.codes())
        rig.plug_in()
        wait_for(lambda: "reconnected" in rig.codes())

    session = record(rig, sessions, wait_for, act)

    codes = [mark.entry["code"] for mark in session.marks]
    assert codes.index("link_lost") < codes.index("reconnected")
    lost, back = (session.marks[codes.index(code)].at_s for code in ("link_lost", "reconnected"))
    assert session.start_s < lost <= back < session.end_s


def test_a_recording_under_way_can_be_begun_only_once(rig, sessions, wait_for):
    rig.connect()
    assert sessions.stop().reason is SESSION_NONE
    assert sessions.save_ring().reason is SESSION_RING_EMPTY or sessions.saving
    assert sessions.start("first") is None
    assert sessions.start("second").reason is SESSION_RECORDED
    assert sessions.stop() is None
    wait_for(lambda: "session_ended" in rig.codes())


@pytest.mark.parametrize("name", ["", "a/b", ".hidden", "x.002", "a\\b", "?", " a"])
def test_a_name_that_is_none_is_refused(rig, sessions, name):
    assert sessions.start(name).reason is SESSION_NAME_BAD
    assert not sessions.recording


@pytest.mark.parametrize(
    ("error", "code"),
    [
        (OSError(errno.ENOSPC, "No space left on device"), SESSION_DISK_FULL),
        (OSError(errno.EIO, "Input/output error"), SESSION_FOLDER_GONE),
        (OSError(errno.EROFS, "Read-only file system"), SESSION_READ_ONLY),
    ],
)
def test_a_disk_that_fails_ends_it_with_a_clear_word(
    rig, sessions, wait_for, monkeypatch, error, code
):
    rig.connect()
    assert sessions.start() is None
    rig.run(0.5)
    wait_for(lambda: sessions.progress().frames > 0)

    def fail(_file, _data):
        raise error

    monkeypatch.setattr(writer.DiskFile, "_write", fail)
    rig.run(0.5)
    wait_for(lambda: "session_failed" in rig.codes())
    monkeypatch.undo()

    told = next(event for event in rig.events if event.code == "session_failed")
    assert told.params["reason"].reason == code
    assert not sessions.recording
    (entry,) = list_recordings(sessions.choices.folder)
    assert opened(entry).frames > 0


def test_frames_that_are_missing_are_told_and_counted(rig, sessions, wait_for):
    rig.connect()
    assert sessions.start() is None
    too_many = [(None, rig.time_s, Frame(0x2A1, bytes(8)), 0)] * (MOST_WAITING + 1)
    sessions._lane.on_heard(too_many)
    rig.run(0.2)
    wait_for(lambda: "session_frames_lost" in rig.codes())
    told = next(event for event in rig.events if event.code == "session_frames_lost")
    assert told.params["count"] == sessions.progress().lost == MOST_WAITING + 1
    sessions.stop()
    wait_for(lambda: "session_ended" in rig.codes())
    assert lines_of(sessions.choices.folder)[-1]["dropped"] == MOST_WAITING + 1


def test_a_folder_that_cannot_be_made_is_told(rig, sessions, wait_for, tmp_path):
    (tmp_path / "file").write_text("")
    sessions.choose(SessionChoices(tmp_path / "file" / "below", RecordingFormat.CANDUMP))
    rig.connect()
    assert sessions.start() is None
    wait_for(lambda: "session_failed" in rig.codes())
    assert not sessions.recording
    rig.run(0.5)
    wait_for(lambda: sessions.ring().frames > 0)
    assert sessions.save_ring() is None
    wait_for(lambda: "ring_not_saved" in rig.codes())


def test_the_end_of_the_program_ends_the_recording_well(rig, sessions, tmp_path):
    rig.connect()
    assert sessions.start() is None
    rig.run(0.5)
    assert rig.controller.shutdown()
    (entry,) = list_recordings(sessions.choices.folder)
    assert (entry.ended, entry.failure) == (True, "")
    assert lines_of(sessions.choices.folder)[-1]["reason"] == "program ended"
    assert opened(entry).frames > 100
