"""Full disks, vanished folders, slow disks, clocks that jump: said; what is written is whole."""

from __future__ import annotations

import errno
import json
import os
import shutil
import sys
import threading
from pathlib import Path

import can
import pytest

from armui.session.recording import sidecar
from armui.session.recording import writer as writing
from armui.session.recording.kinds import (
    SESSION_FOLDER_GONE,
    SESSION_READ_ONLY,
    RecordingFormat,
    why_not_written,
)
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.rows import rows_of
from armui.session.recording.session_recording import SessionRecording, write_at_once
from armui.session.recording.writer import RecordingWriter
from tests.session.recording.made import BASE, all_of, plan, still_clock, taken, writer

FRAMES = taken(6000)


def lines(folder: Path):
    (path,) = folder.glob(f"*{sidecar.SUFFIX}")
    return [json.loads(line) for line in path.read_text("utf-8").splitlines()]


class FullDisk:
    """Has room for so many bytes; a write that does not fit is made as far as it does."""

    def __init__(self, monkeypatch, room):
        self.room = room
        self._write = os.write
        monkeypatch.setattr(f"{writing.__name__}.os.write", self.write)

    def write(self, handle, data):
        if not self.room:
            raise OSError(errno.ENOSPC, "No space left on device")
        part = bytes(data[: self.room])
        self.room -= len(part)
        return self._write(handle, part)


def until_full(made):
    """Write until the disk is full; returns how many frames were written before."""
    for begin in range(0, len(FRAMES), 200):
        try:
            made.write(rows_of(FRAMES[begin : begin + 200]))
        except OSError:
            return begin
    raise AssertionError("the disk was never full")


def test_what_cannot_be_begun_leaves_nothing_behind(tmp_path, monkeypatch):
    """However much room there is for the beginning of sidecar and index."""
    whole = tmp_path / "complete"
    writer(whole).finish({})
    begun_bytes = next(whole.glob(f"*{sidecar.SUFFIX}")).read_bytes().index(b"\n") + 1
    for room in (0, 1, begun_bytes, begun_bytes + 1):
        with monkeypatch.context() as patched:
            FullDisk(patched, room)
            with pytest.raises(OSError, match="No space left"):
                writer(tmp_path / "full")
        assert list((tmp_path / "full").iterdir()) == []


@pytest.mark.parametrize("kind", RecordingFormat)
@pytest.mark.parametrize("room", [20_000, 33_333, 47_001])
def test_on_a_full_disk_what_was_written_can_be_read(tmp_path, monkeypatch, kind, room):
    made = writer(tmp_path, kind)
    with monkeypatch.context() as patched:
        FullDisk(patched, room)
        written = until_full(made)
    made.finish({"failure": "No space left on device"})

    session = RecordedSession(made.path)
    assert written <= session.frames <= written + 200
    assert list(session.damages) == []
    assert [each.frame for each in all_of(session)] == [f for _, _, f, _ in FRAMES][
        : session.frames
    ]
    assert sum(1 for _ in can.LogReader(made.path)) == session.frames
    assert lines(tmp_path)[-1]["failure"] == "No space left on device"


@pytest.mark.skipif(sys.platform == "win32", reason="open files cannot be removed there")
def test_a_folder_that_disappears_is_noticed_though_writing_succeeds(tmp_path):
    folder = tmp_path / "stick"
    made = writer(folder)
    made.write(rows_of(FRAMES[:100]))
    shutil.rmtree(folder)
    with pytest.raises(FileNotFoundError) as caught:
        made.write(rows_of(FRAMES[100:200]))
    assert why_not_written(caught.value, folder).reason is SESSION_FOLDER_GONE
    made.finish({})


@pytest.mark.parametrize("number", [errno.EACCES, errno.EROFS])
def test_a_folder_that_cannot_be_written_leaves_nothing_behind(tmp_path, monkeypatch, number):
    def refuse(*_args):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(f"{writing.__name__}.os.open", refuse)
    recording = SessionRecording(plan(tmp_path), still_clock)
    assert recording.wait(5.0)
    assert recording.failure is not None
    assert why_not_written(recording.failure, tmp_path).reason is SESSION_READ_ONLY
    recording.put(rows_of(FRAMES[:10]))
    assert list(tmp_path.iterdir()) == []
    assert (recording.frames, recording.path) == (0, None)


def test_a_disk_that_hangs_holds_up_nobody_and_what_is_lost_is_said(tmp_path, monkeypatch):
    let_go, reached = threading.Event(), threading.Event()
    write = RecordingWriter.write

    def slow(self, rows, noted=()):
        if len(rows):
            reached.set()
            assert let_go.wait(20.0)
        write(self, rows, noted)

    monkeypatch.setattr(RecordingWriter, "write", slow)
    recording = SessionRecording(plan(tmp_path), still_clock, most_waiting=1000)
    recording.put(rows_of(FRAMES[:500]))
    assert reached.wait(20.0)
    for begin in range(500, 3000, 500):
        recording.put(rows_of(FRAMES[begin : begin + 500]))  # returns at once
    assert recording.lost == 2000
    let_go.set()
    recording.end({"reason": "test"})
    assert recording.wait(20.0)
    assert recording.frames == 1000
    told = [line for line in lines(tmp_path) if line["kind"] == "lost"]
    assert sum(line["count"] for line in told) == 2000
    assert lines(tmp_path)[-1]["lost"] == 2000


def test_a_clock_that_is_set_while_recording_moves_no_frame_and_is_noted(tmp_path):
    wall = [BASE.unix_s]
    made = RecordingWriter(plan(tmp_path), still_clock, lambda: wall[0])
    made.write(rows_of(FRAMES[:1000]))
    wall[0] -= 3600.0
    made.write(rows_of(FRAMES[1000:2000]))
    wall[0] += 3600.2
    made.write(rows_of(FRAMES[2000:3000]))
    made.finish({})

    jumps = [line["jump_s"] for line in lines(tmp_path) if line["kind"] == "clock"]
    assert jumps == [-3600.0, 3600.2]
    times_s = [each.time_s for each in all_of(RecordedSession(made.path))]
    wanted = [at_s + BASE.shift_s for _, at_s, _, _ in FRAMES[:3000]]
    assert times_s == pytest.approx(wanted, abs=2e-6)


def test_what_is_in_memory_is_written_as_a_recording_of_its_own(tmp_path):
    parts = [rows_of(FRAMES[:3500]), rows_of(FRAMES[3500:])]
    told = [{"kind": "event", "time_s": BASE.unix_s + 1.0, "mark": "fault", "entry": {"code": "x"}}]
    path = write_at_once(plan(tmp_path), parts, told, {"reason": "fault"}, still_clock)

    session = RecordedSession(path)
    assert [each.frame for each in all_of(session)] == [f for _, _, f, _ in FRAMES]
    assert [mark.entry for mark in session.marks] == [{"code": "x"}]
    assert session.lines[-1]["kind"] == "end"


def test_an_event_that_is_written_again_is_one_mark(tmp_path):
    made = writer(tmp_path)
    entry = {"number": 7, "code": "fault", "ended_s": None}
    line = {"kind": "event", "time_s": 5.0, "mark": "fault", "entry": entry}
    made.write(rows_of(FRAMES[:10]), [line])
    made.write(rows_of([]), [line | {"entry": entry | {"ended_s": 9.0}}])
    made.finish({})
    (mark,) = RecordedSession(made.path).marks
    assert mark.entry["ended_s"] == 9.0 + BASE.shift_s


def test_a_line_that_is_no_json_is_told_as_text(tmp_path):
    made = writer(tmp_path)
    made.write(rows_of(FRAMES[:10]), [{"kind": "odd", "value": float("nan"), "who": Path("x")}])
    made.finish({})
    assert lines(tmp_path)[2] == {"kind": "odd", "value": "nan", "who": "x"}


def test_a_disk_that_is_busy_for_long_holds_up_nothing_that_is_written(tmp_path, monkeypatch):
    asked, goes_on = threading.Event(), threading.Event()

    def busy(_handle):
        asked.set()
        goes_on.wait(10)

    monkeypatch.setattr(writing, "_TO_DISK_S", 0.0)
    monkeypatch.setattr(f"{writing.__name__}.os.fsync", busy)
    made = writer(tmp_path)
    for begin in range(0, 3000, 500):
        made.write(rows_of(FRAMES[begin : begin + 500]))
    assert asked.wait(10)
    assert RecordedSession(made.path).frames == 3000
    goes_on.set()
    made.finish({})
    assert RecordedSession(made.path).frames == 3000


def test_a_disk_that_fails_to_keep_what_was_written_ends_it(tmp_path, monkeypatch):
    failed = threading.Event()

    def fail(_handle):
        failed.set()
        raise OSError(errno.EIO, "Input/output error")

    monkeypatch.setattr(writing, "_TO_DISK_S", 0.0)
    monkeypatch.setattr(f"{writing.__name__}.os.fsync", fail)
    made = writer(tmp_path)

    def write():
        for begin in range(0, 2000, 500):
            made.write(rows_of(FRAMES[begin : begin + 500]))
            assert failed.wait(10)
            for each in threading.enumerate():
                if each.name == "armui-to-disk":
                    each.join(10)

    with pytest.raises(OSError, match="Input/output error"):
        write()
    made.finish({"failure": "Input/output error"})
    assert RecordedSession(made.path).frames >= 500
