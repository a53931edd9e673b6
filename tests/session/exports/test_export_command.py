"""`armui export` as a terminal and a script see it; and the process that the window starts."""

from __future__ import annotations

import argparse
import io
import json
import sys
import threading
from pathlib import Path

import pytest

from armui.export import add_arguments, run
from armui.export.export_command import ProgressBar
from armui.export.process import ExportDone, ExportProcess
from armui.protocol.generation import PiperModel
from armui.session.exports.request import (
    ArmOptions,
    ExportFormat,
    ExportProblem,
    ExportProgress,
    ExportRequest,
    default_target,
)
from tests.session.exports.logs import candump, session


def export(*words: object) -> int:
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    return run(parser.parse_args([str(word) for word in words]))


@pytest.fixture
def log(tmp_path) -> Path:
    return candump(tmp_path / "录制 1.log", session(0.4))


def test_without_options_it_writes_mcap_beside_the_log(log, capsys):
    assert export(log) == 0
    output = capsys.readouterr()
    assert output.out.startswith(f"{log.with_suffix('.mcap')}: ")
    assert output.out.endswith(" messages\n")
    assert "read as generation 2: frames that fit only this generation" in output.err
    assert log.with_suffix(".mcap").read_bytes().startswith(b"\x89MCAP0\r\n")


@pytest.mark.parametrize(
    ("name", "options", "begins"),
    [
        ("a.csv", [], b"\xef\xbb\xbftime [s]"),
        ("a.parquet", [], b"PAR1"),
        ("a.mcap", [], b"\x89MCAP"),
        ("a.dat", ["--to", "csv"], b"\xef\xbb\xbftime [s]"),
        ("a.dat", [], b"\x89MCAP"),
    ],
)
def test_the_format_is_said_or_taken_from_the_name(log, name, options, begins):
    target = log.with_name(name)
    assert export(log, "-o", target, *options) == 0
    assert target.read_bytes().startswith(begins)


def test_a_target_that_is_there_wants_force(log, capsys):
    assert export(log, "--to", "csv") == 0
    before = log.with_suffix(".csv").read_bytes()
    assert export(log, "--to", "csv", "--from", 0.2) == 2
    assert "is there already" in capsys.readouterr().err
    assert log.with_suffix(".csv").read_bytes() == before
    assert export(log, "--to", "csv", "--from", 0.2, "--force") == 0
    assert len(log.with_suffix(".csv").read_bytes()) < len(before)


def test_damage_is_named_and_told_by_the_exit_code(log, capsys):
    log.write_text("nonsense\n" + log.read_text())
    assert export(log, "--generation", "2") == 1
    assert "line 1 cannot be read: 'nonsense'" in capsys.readouterr().err


def test_what_is_no_log(tmp_path, capsys):
    path = tmp_path / "a.log"
    path.write_bytes(b"\x00" * 5000)
    assert export(path) == 2
    assert "no CAN log" in capsys.readouterr().err


def test_ctrl_c_leaves_nothing(log, capsys, monkeypatch):
    def pressed(*_args, **_keywords):
        raise KeyboardInterrupt

    monkeypatch.setattr("armui.session.exports.csv_files.CsvTable.write_span", pressed)
    assert export(log, "--to", "csv") == 130
    assert "nothing was written" in capsys.readouterr().err
    assert list(log.parent.iterdir()) == [log]


@pytest.mark.parametrize(
    "wrong", [["--from", "-1"], ["--to-time", "nan"], ["--firmware", "1.8"], ["--to", "xlsx"]]
)
def test_options_that_make_no_sense(log, wrong, capsys):
    with pytest.raises(SystemExit) as caught:
        export(log, *wrong)
    assert caught.value.code == 2
    assert wrong[1] in capsys.readouterr().err


def test_json_for_scripts(log, capsys):
    assert export(log, "--json") == 0
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert list(lines[0]) == ["unfinished"]
    assert lines[0]["unfinished"].endswith(".unfinished")
    assert {"done", "frames"} == set(lines[1])
    report = lines[-1]["report"]
    assert (report["generation"], report["damage_count"]) == (2, 0)
    assert export(log, "--json") == 2
    last = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert last["problem"] == "exists"


@pytest.mark.parametrize(
    ("log_name", "target_name"),
    [
        ("a.blf", "a.csv"),
        ("a.log.gz", "a.csv"),
        ("a.b.log", "a.b.csv"),
        ("a.csv", "a-export.csv"),
        ("a", "a.csv"),
    ],
)
def test_the_target_is_never_the_log(log_name, target_name):
    target = default_target(Path("/x") / log_name, ExportFormat.CSV)
    assert target == Path("/x") / target_name


# --- the progress bar -------------------------------------------------------------------------


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_the_bar_draws_over_itself_and_leaves_nothing():
    now = [100.0]
    terminal = Terminal()
    bar = ProgressBar(terminal, lambda: now[0])
    bar.show(0.0, "0 frames")
    now[0] += 0.01
    bar.show(0.1, "too soon")
    now[0] += 9.99
    bar.show(0.5, "5 frames")
    bar.clear()
    drawn = terminal.getvalue().split("\r")
    assert drawn[1].startswith("[..............................]   0%  0 frames")
    assert drawn[2].startswith("[###############...............]  50%  5 frames  10 s left")
    assert drawn[3].strip() == ""
    assert "too soon" not in terminal.getvalue()


def test_no_bar_where_there_is_no_terminal():
    stream = io.StringIO()
    bar = ProgressBar(stream)
    bar.show(0.5, "5 frames")
    bar.clear()
    assert stream.getvalue() == ""


# --- the process ------------------------------------------------------------------------------


class Listener:
    """Hears what a process tells."""

    def __init__(self) -> None:
        self.progress: list[ExportProgress] = []
        self.done: list[ExportDone] = []
        self.over = threading.Event()

    def __call__(self, said) -> None:
        if isinstance(said, ExportDone):
            self.done.append(said)
            self.over.set()
        else:
            self.progress.append(said)


def test_a_process_exports_what_was_asked_for(log):
    listener = Listener()
    target = log.with_name("-o 输出.csv")
    wishes = ArmOptions(channel="can0", firmware="S-V1.8-5", model=PiperModel.PIPER_L)
    request = ExportRequest(log, target, ExportFormat.CSV, 0.1, 0.2, wishes)
    process = ExportProcess(request, listener)
    assert listener.over.wait(60)
    assert process.wait()
    (done,) = listener.done
    assert done.report is not None
    assert (done.problem, done.report["items"], done.report["firmware"]) == (None, 21, "S-V1.8-5")
    assert done.report["model"] == "PiPER L"
    assert target.exists()
    assert listener.progress[-1].frames > 0


def test_a_process_tells_why_it_did_not(log):
    listener = Listener()
    target = log.with_suffix(".mcap")
    target.write_text("mine")
    ExportProcess(ExportRequest(log, target, ExportFormat.MCAP), listener)
    assert listener.over.wait(60)
    assert listener.done == [ExportDone(ExportProblem.EXISTS, str(target))]


def test_a_process_that_cannot_run_says_so(log, monkeypatch):
    monkeypatch.setattr(sys, "executable", "/nowhere/python")
    listener = Listener()
    ExportProcess(ExportRequest(log, log.with_suffix(".mcap"), ExportFormat.MCAP), listener)
    assert listener.over.wait(60)
    assert listener.done == [ExportDone(None, "No such file or directory")]


def test_a_cancelled_process_leaves_nothing_and_tells_nothing(tmp_path):
    frames = session(1.0)
    line_count = 40
    log = candump(tmp_path / "a.log", frames)
    log.write_text(log.read_text() * line_count)
    begun = threading.Event()
    told: list[object] = []

    def tell(said) -> None:
        told.append(said)
        begun.set()

    process = ExportProcess(ExportRequest(log, tmp_path / "a.mcap", ExportFormat.MCAP), tell)
    assert begun.wait(60)
    process.end()
    assert process.wait()
    assert not any(isinstance(said, ExportDone) and said.report is None for said in told)
    if not any(isinstance(said, ExportDone) for said in told):
        assert list(tmp_path.iterdir()) == [log]
