"""Damaged, empty and foreign logs, targets that are there, cancelled and killed exports."""

from __future__ import annotations

import gzip
import json
import os
import random
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import pytest

from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.session.exports.export import SessionSource, export_log
from armui.session.exports.request import (
    ArmOptions,
    ExportCancelledError,
    ExportError,
    ExportFormat,
    ExportProblem,
    ExportReport,
    ExportRequest,
)
from armui.session.frames import Damage, FrameBatch
from armui.session.reader import LogFile
from tests.posix import KILL, make_pipe
from tests.session.exports.logs import blf, candump, session
from tests.session.exports.test_mcap import by_mcap

ROOT = Path(__file__).resolve().parents[3]
ALL = pytest.mark.parametrize("kind", list(ExportFormat))
FILES = pytest.mark.parametrize("kind", [each for each in ExportFormat if not each.is_folder])


def export(log: Path, kind: ExportFormat = ExportFormat.MCAP, **more: Any) -> ExportReport:
    return export_log(ExportRequest(log, log.with_suffix(f".{kind}"), kind, **more))


def problem(log: Path, kind: ExportFormat, **more: Any) -> ExportProblem:
    """Why nothing was written; and that nothing is there."""
    before = sorted(log.parent.iterdir())
    with pytest.raises(ExportError) as caught:
        export(log, kind, **more)
    assert sorted(log.parent.iterdir()) == before
    return caught.value.problem


# --- logs -------------------------------------------------------------------------------------


@ALL
def test_everything_but_the_damaged_lines_is_exported(tmp_path, kind):
    log = candump(tmp_path / "a.log", session(1.3))
    whole = export(log, kind)
    lines = log.read_text().splitlines(keepends=True)
    lines.insert(100, "(nonsense) can0 2A5#\n")
    lines.insert(500, "\x00\xff\n")
    damaged = tmp_path / "b.log"
    damaged.write_text("".join(lines), encoding="latin-1")
    report = export(damaged, kind)
    assert report.damage_count == 2
    assert report.damages[0].place == "line 101"
    assert report.items == whole.items


@ALL
def test_a_log_that_breaks_off_is_exported_up_to_there(tmp_path, kind):
    whole = blf(tmp_path / "a.blf", session(2.0))
    everything = export(whole, kind)
    cut = tmp_path / "b.blf"
    data = whole.read_bytes()
    cut.write_bytes(data[: len(data) * 2 // 3])
    report = export(cut, kind)
    assert report.damage_count >= 1
    assert 0 < report.items < everything.items


@ALL
def test_a_log_without_frames(tmp_path, kind):
    log = tmp_path / "a.asc"
    log.write_text("date Sat Nov 21 02:00:00.000 2026\nbase hex  timestamps absolute\n")
    assert problem(log, kind) is ExportProblem.NO_FRAMES


@ALL
def test_a_file_that_is_no_log(tmp_path, kind):
    log = tmp_path / "a.log"
    log.write_bytes(random.Random(3).randbytes(100_000))
    assert problem(log, kind) is ExportProblem.NO_LOG
    assert problem(tmp_path / "missing.log", kind) is ExportProblem.NO_LOG
    (tmp_path / "empty.log").write_bytes(b"")
    assert problem(tmp_path / "empty.log", kind) is ExportProblem.NO_LOG


@ALL
def test_a_log_of_something_else(tmp_path, kind):
    frames = [(1.0 + place, Frame(0x7E8, b"\x01\x02")) for place in range(10)]
    assert problem(candump(tmp_path / "a.log", frames), kind) is ExportProblem.NO_ARM


def test_a_log_without_angles_makes_no_table_but_messages(tmp_path):
    status = Frame(0x2A1, bytes.fromhex("0100010000000000"))
    log = candump(tmp_path / "a.log", [(1.0, status)])
    assert problem(log, ExportFormat.CSV) is ExportProblem.NO_ANGLES
    assert export(log).items == 1


@ALL
def test_a_stretch_in_which_nothing_was(tmp_path, kind):
    log = candump(tmp_path / "a.log", session(0.3))
    assert problem(log, kind, begin_s=100.0) is ExportProblem.NOTHING_THEN


def test_a_channel_that_is_not_there(tmp_path):
    log = candump(tmp_path / "a.log", session(0.1))
    with pytest.raises(ExportError) as caught:
        export(log, wishes=ArmOptions(channel="vcan7"))
    assert (caught.value.problem, caught.value.detail) == (ExportProblem.NO_CHANNEL, "can0")


def test_the_frames_that_were_left_out_are_counted(tmp_path):
    log = candump(tmp_path / "a.log", session(0.2))
    extra = [
        "(1718900000.1) can0 777#01\n",  # in no table
        "(1718900000.1) can0 2A5#0102\n",  # too short
        "(1718900000.1) can0 18FEF100#01\n",  # extended
        "(1718900000.1) can1 2A5#0000000000000000\n",  # another channel
    ]
    log.write_text(log.read_text() + "".join(extra))
    report = export(log)
    assert report.not_understood == 3
    assert (report.other_channels, report.of_other_channels) == (("can1",), 1)
    assert report.channel == "can0"


@ALL
def test_hostile_frames_end_nothing(tmp_path, kind):
    """Every identifier of the protocol with random bytes, and times that leap."""
    draw = random.Random(7)
    names = [*range(0x2A1, 0x2A9), *range(0x251, 0x257), *range(0x261, 0x267), 0x4AF, 0x150, 0x471]
    names += [*range(0x151, 0x160)]
    frames = [
        (draw.choice([1.0, 1e3, 1e9]) + draw.random(), Frame(draw.choice(names), draw.randbytes(8)))
        for _ in range(4000)
    ]
    log = candump(tmp_path / "a.log", frames)
    for generation in Generation:
        if kind is ExportFormat.LEROBOT:  # no second of it makes sense
            assert problem(log, kind, wishes=ArmOptions(generation)) is ExportProblem.NO_EPISODE
            continue
        report = export(log, kind, replace=True, wishes=ArmOptions(generation))
        assert report.frames == 4000
    if kind is ExportFormat.MCAP:
        assert by_mcap(log.with_suffix(".mcap"))["/diagnostics"]


def test_a_packed_log(tmp_path):
    plain = candump(tmp_path / "a.log", session(0.2))
    packed = tmp_path / "b.log.gz"
    packed.write_bytes(gzip.compress(plain.read_bytes()))
    report = export_log(ExportRequest(packed, tmp_path / "b.mcap", ExportFormat.MCAP))
    assert report.items == export(plain).items


# --- targets ----------------------------------------------------------------------------------


@FILES
def test_a_target_that_is_there_is_kept_unless_it_may_be_replaced(tmp_path, kind):
    log = candump(tmp_path / "a.log", session(0.1))
    target = tmp_path / f"a.{kind}"
    target.write_text("mine")
    assert problem(log, kind) is ExportProblem.EXISTS
    assert target.read_text() == "mine"
    export(log, kind, replace=True)
    assert target.read_bytes() != b"mine"
    assert sorted(tmp_path.iterdir()) == sorted([log, target])


def test_a_target_that_comes_meanwhile_is_kept(tmp_path):
    log = candump(tmp_path / "a.log", session(0.1))
    target = tmp_path / "a.mcap"
    request = ExportRequest(log, target, ExportFormat.MCAP)
    with pytest.raises(ExportError) as caught:
        export_log(request, on_progress=lambda _progress: target.write_text("theirs"))
    assert caught.value.problem is ExportProblem.EXISTS
    assert target.read_text() == "theirs"
    assert sorted(tmp_path.iterdir()) == sorted([log, target])


def test_the_log_itself_is_no_target(tmp_path):
    log = candump(tmp_path / "a.log", session(0.1))
    before = log.read_bytes()
    with pytest.raises(ExportError) as caught:
        export_log(ExportRequest(log, tmp_path / "." / "a.log", ExportFormat.CSV, replace=True))
    assert caught.value.problem is ExportProblem.SAME_FILE
    assert log.read_bytes() == before


@ALL
def test_a_folder_that_is_not_there(tmp_path, kind):
    log = candump(tmp_path / "a.log", session(0.1))
    with pytest.raises(ExportError) as caught:
        export_log(ExportRequest(log, tmp_path / "gone" / "a.out", kind))
    assert caught.value.problem is ExportProblem.CANNOT_WRITE
    assert "No such file" in caught.value.detail


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no full disk here")
@ALL
def test_a_full_disk_leaves_nothing(tmp_path, kind, monkeypatch):
    log = candump(tmp_path / "a.log", session(1.2))

    def full(path: Path, mode: str) -> Any:
        path.open(mode).close()
        return Path("/dev/full").open("wb", buffering=0)

    monkeypatch.setattr("armui.system.atomic.open_file", full)
    monkeypatch.setattr("armui.session.exports.csv_files.open_file", full)
    monkeypatch.setattr("armui.session.exports.lerobot.dataset.open_file", full)
    assert problem(log, kind) is ExportProblem.CANNOT_WRITE


def test_parquet_without_its_package(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    log = candump(tmp_path / "a.log", session(0.1))
    assert problem(log, ExportFormat.PARQUET) is ExportProblem.NO_PYARROW


# --- ended before its end ---------------------------------------------------------------------


@ALL
def test_a_cancelled_export_leaves_nothing(tmp_path, kind, monkeypatch):
    log = candump(tmp_path / "a.log", session(0.5))
    monkeypatch.setattr("armui.session.exports.history._ENOUGH", 1)
    monkeypatch.setattr("armui.session.source._BLOCK", 2_000)
    told: list[int] = []
    request = ExportRequest(log, tmp_path / f"a.{kind}", kind)
    with pytest.raises(ExportCancelledError):
        # half of it is written by then
        export_log(request, lambda each: told.append(each.frames), lambda: len(told) < 20)
    assert told[-1] > 500
    assert list(tmp_path.iterdir()) == [log]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_killed_export_leaves_no_half_file_under_the_name(tmp_path):
    """Fed by a pipe, so that it is at work for as long as the test wants."""
    pipe = tmp_path / "live.log"
    make_pipe(pipe)
    target = tmp_path / "live.mcap"
    text = candump(tmp_path / "a.log", session(0.5)).read_text()
    process = subprocess.Popen(
        [sys.executable, "-m", "armui", "export", str(pipe), "--json"],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        with pipe.open("w") as feed:
            feed.write(text * 40)  # more than a pipe holds: it is read
            first = json.loads(process.stdout.readline())
            while "frames" not in json.loads(process.stdout.readline()):
                pass
            process.send_signal(KILL)
            process.wait(timeout=30)
    except BrokenPipeError:  # what was not read yet
        pass
    finally:
        process.kill()
        process.wait(timeout=30)
        process.stdout.close()
    assert Path(first["unfinished"]).exists()
    assert not target.exists()


def test_what_a_killed_export_left_is_removed_later(tmp_path):
    log = candump(tmp_path / "a.log", session(0.1))
    left = tmp_path / ".0123456789abcdef.unfinished"
    left.write_bytes(b"half")
    long_ago = time.time() - 3600
    os.utime(left, (long_ago, long_ago))
    export(log)
    assert not left.exists()


def test_progress_goes_up_to_the_end(tmp_path):
    log = candump(tmp_path / "a.log", session(3.0))
    told: list[float] = []
    request = ExportRequest(log, tmp_path / "a.csv", ExportFormat.CSV)
    export_log(request, on_progress=lambda progress: told.append(progress.done or 0.0))
    assert told == sorted(told)
    assert told[-1] == 1.0


# --- sessions of several files ----------------------------------------------------------------


class Session:
    """An indexed session of two files, with a damaged place."""

    damages = (Damage("block 3", "its bytes are damaged", 700),)
    damage_count = 1

    def __init__(self, *logs: Path) -> None:
        self._logs = logs
        self.closed = False
        times_s = [at_s for each in self.frames_between(0.0, 1e12) for at_s in each.times_s]
        self.start_s, self.end_s = times_s[0], times_s[-1]

    def frames_between(self, t0_s: float, t1_s: float) -> Iterator[FrameBatch]:
        assert t0_s < t1_s
        before = 0
        for path in self._logs:
            with LogFile(path) as log:
                for batch in log.batches():
                    yield replace(batch, first=before + batch.first)
                before += log.frames

    def close(self) -> None:
        self.closed = True


def test_a_session_of_several_files_is_exported_as_one(tmp_path):
    frames = session(1.0)
    whole = export(candump(tmp_path / "whole.log", frames))
    half = len(frames) // 2
    parts = [
        candump(tmp_path / "a.log", frames[:half]),
        candump(tmp_path / "a.002.log", frames[half:]),
    ]
    recorded = Session(*parts)
    told: list[float] = []
    report = export_log(
        ExportRequest(parts[0], tmp_path / "a.mcap", ExportFormat.MCAP),
        lambda progress: told.append(progress.done or 0.0),
        open_recording=lambda _path: SessionSource(cast(Any, recorded)),
    )
    assert (report.items, report.frames) == (whole.items, whole.frames)
    assert (report.damages, report.damage_count) == (Session.damages, 1)
    assert told[-1] == 1.0
    assert recorded.closed
    assert (tmp_path / "a.mcap").stat().st_size > 1000
