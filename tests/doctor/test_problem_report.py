"""The report of a problem: what is in it, what is not, and that it replaces nothing."""

import json
import os
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest

from armui import __version__
from armui.doctor.doctor_command import EXIT_NO_REPORT
from armui.doctor.problem_report import (
    REPORT_EXISTS,
    REPORT_NOT_SAVED,
    ReportFile,
    collect,
    doctor_files,
    save,
    without_home,
)
from armui.session.reader import LogFile
from armui.session.recording.candump_text import candump_text
from armui.session.recording.rows import ROW, FrameRows
from armui.session.recording.writer import TimeBase
from tests.doctor.test_command import look

FILES = (ReportFile("doctor.txt", b"fine\n"), ReportFile("log/armui.log", b"a line\n"))


def by_name(files):
    return {each.name: each.data.decode() for each in files}


@pytest.fixture
def logs(tmp_path):
    folder = tmp_path / "logs"
    folder.mkdir()
    return folder


def test_log_settings_and_versions_are_in_it_without_the_users_name(tmp_path, logs):
    home = str(Path.home())
    settings = tmp_path / "settings.json"
    entries = {"language": "en", "urdf_path": f"{home}/arm.urdf", "a_later_one": "unknown"}
    settings.write_text(json.dumps(entries))
    (logs / "armui.log").write_text(f"{home}/x could not be read\n")
    (logs / "armui.log.1").write_text("before\n")
    (logs / "other.log").write_text("nobody's business\n")
    found = by_name(collect(doctor_files("well\n", "{}"), settings, logs))
    names = ["doctor.txt", "doctor.json", "versions.txt", "settings.json"]
    assert sorted(found) == sorted([*names, "log/armui.log", "log/armui.log.1"])
    assert f"armui {__version__}" in found["versions.txt"]
    assert any(line.startswith("numpy ") for line in found["versions.txt"].splitlines())
    # what this version does not know is not passed on: nobody can say what it is
    kept = {"language": "en", "urdf_path": without_home(f"{home}/arm.urdf")}
    assert json.loads(found["settings.json"]) == kept
    assert home not in "".join(found.values()) or len(home) < 2


def test_who_has_no_folder_of_his_own_loses_no_slash(monkeypatch):
    monkeypatch.setattr(Path, "home", lambda: Path("/"))
    assert without_home("/dev/ttyACM0") == "/dev/ttyACM0"
    monkeypatch.setattr(Path, "home", lambda: Path("/home/anna"))
    assert without_home("/home/anna/x and /dev/null") == "~/x and /dev/null"


def test_logs_are_the_newest_and_bounded(tmp_path, logs):
    for number in range(8):
        path = logs / f"armui.log.{number}"
        path.write_bytes(bytes([ord("a") + number]) * 1_000_000)
        at_s = time.time() - 3600 * number
        os.utime(path, (at_s, at_s))
    (logs / "armui-2.log").write_text("of last month\n")
    os.utime(logs / "armui-2.log", (time.time() - 40 * 86_400,) * 2)
    found = by_name(collect((), tmp_path / "none.json", logs))
    kept = [name for name in found if name.startswith("log/")]
    assert kept == [f"log/armui.log.{number}" for number in range(5)]
    assert found["settings.json"] == "{}\n"


@pytest.mark.parametrize("text", ["no JSON", "[]", '"text"', "[" * 100_000])
def test_settings_that_cannot_be_read_are_told(tmp_path, logs, text):
    settings = tmp_path / "settings.json"
    settings.write_text(text)
    assert "could not be read" in by_name(collect((), settings, logs))["settings.json"]


def test_one_zip_and_nothing_is_replaced(tmp_path):
    path = tmp_path / "report.zip"
    assert save(path, FILES) == path
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        assert {name: archive.read(name) for name in archive.namelist()} == {
            each.name: each.data for each in FILES
        }
    before = path.read_bytes()
    assert save(path, ()) == REPORT_EXISTS(path=str(path))
    assert path.read_bytes() == before
    gone = save(tmp_path / "gone" / "report.zip", FILES)
    assert gone.reason == REPORT_NOT_SAVED
    assert [each.name for each in tmp_path.iterdir()] == ["report.zip"]


def test_the_bus_is_a_log_that_can_be_replayed(tmp_path):
    table = np.zeros(1200, ROW)
    table["time_s"] = 5.0 + np.arange(1200) / 1000
    table["id"] = 0x2A5
    table["length"] = 8
    text = candump_text([FrameRows(table)], TimeBase(10.0, 1_700_000_010.0), "can0")
    assert text.splitlines()[0] == b"(1700000005.000000) can0 2A5#0000000000000000 R"
    assert float(table["time_s"][0]) == 5.0  # the ring's own rows are as they were
    log = tmp_path / "bus.log"
    log.write_bytes(text)
    with LogFile(log) as reader:
        assert sum(len(batch) for batch in reader.batches()) == 1200


def test_the_command_keeps_one_and_says_what_is_in_it(capsys, tmp_path):
    path = tmp_path / "mine.zip"
    code, report = look(capsys, "--report", str(path))
    assert code == 1
    with zipfile.ZipFile(path) as archive:
        assert json.loads(archive.read("doctor.json")) == report
    before = path.read_bytes()
    code, _report = look(capsys, "--report", str(path))
    assert code == EXIT_NO_REPORT
    assert path.read_bytes() == before
