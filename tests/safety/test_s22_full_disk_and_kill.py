"""S22: a disk that is really full, a program that is killed: what the windows then say."""

import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from armui.doctor import problem_report
from armui.doctor.problem_report import ReportFile
from armui.session.recording.folder import list_recordings
from armui.session.recording.recorded_session import RecordedSession
from armui.trajectory.library.store import Library
from armui.ui.dialogs.confirm_dialog import LeaveQuestion
from armui.ui.watch.recordings.sessions_page import SessionColumn, SessionsPage
from tests.operator.test_recording import Operator
from tests.operator.test_sessions import Sessions
from tests.posix import of_system

pytestmark = pytest.mark.timeout(120)


@pytest.fixture
def small_disk(tmp_path):
    """A disk of a megabyte, where the system lets one be made."""
    folder = tmp_path / "small"
    folder.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", "size=1m", "tmpfs", str(folder)]
    try:
        done = subprocess.run(command, capture_output=True, check=False)
    except FileNotFoundError:
        pytest.skip("no mount here")
    if done.returncode:
        pytest.skip("nobody may mount a disk here")
    yield folder
    subprocess.run(["umount", "-l", str(folder)], check=True)


def fill_up(folder, *, but=0):
    with (folder / "filler").open("wb") as file:
        while (free := shutil.disk_usage(folder).free) > but:
            file.write(bytes(min(free - but, 4096)))
            file.flush()


@pytest.fixture
def sessions_on(app_driver):
    def make(folder):
        app_driver.store.change(session_folder=str(folder))
        app_driver.ready()
        app_driver.click("sessions_button")
        return Sessions(app_driver, app_driver.page(SessionsPage), folder)

    return make


def test_a_session_on_a_disk_that_becomes_full(sessions_on, small_disk):
    sessions = sessions_on(small_disk)
    driver = sessions.driver
    fill_up(small_disk, but=100_000)
    driver.click(sessions.window.recording.record_button)
    until_s = driver.time_s + 60.0
    while "session_failed" not in driver.codes():
        driver.run(0.5)
        sessions.recorder.poll()
        assert driver.time_s < until_s
    told = next(event for event in driver.events if event.code == "session_failed")
    assert told.params["reason"].code == "session_disk_full"
    assert not sessions.recorder.recording
    sessions.until(lambda: len(sessions.names()) == 1)
    sessions.window._refresh_cards()
    sessions.until(lambda: sessions.column(SessionColumn.STATE) != ["under way"])
    # what was written is there, and is told not to be all
    (state,) = sessions.column(SessionColumn.STATE)
    assert state not in {"complete", "under way"}
    (entry,) = list_recordings(small_disk)
    assert entry.path is not None
    assert RecordedSession(entry.path).frames > 1000
    # what just happened cannot be saved there either, and is not lost: there is room later
    driver.click(sessions.window.ring.save_button)
    sessions.until(lambda: "ring_not_saved" in driver.codes())
    (small_disk / "filler").unlink()
    driver.click(sessions.window.ring.save_button)
    sessions.until(lambda: "ring_saved" in driver.codes())
    sessions.until(lambda: len(sessions.names()) >= 2)
    driver.controller.emergency_stop()
    assert driver.controller.operating_state.link.name == "ONLINE"


def test_a_report_on_a_disk_that_is_full(small_disk):
    fill_up(small_disk, but=100_000)
    noise = random.Random(1).randbytes(300_000)
    path = small_disk / "report.zip"
    refused = problem_report.save(path, [ReportFile("log/armui.log", noise)])
    assert refused.reason == problem_report.REPORT_NOT_SAVED
    # nothing of it is left, and there is room for a smaller one
    assert [each.name for each in small_disk.iterdir()] == ["filler"]
    assert problem_report.save(path, [ReportFile("doctor.txt", b"fine")]) == path


KILLED = """
import os, sys, time
from pathlib import Path
from tests.kills import record
from armui.session.recording.kinds import RecordingFormat
import mmap
record(Path(sys.argv[1]), RecordingFormat.BLF, mmap.mmap(-1, mmap.PAGESIZE))
"""


def test_a_session_of_a_killed_program(sessions_on, tmp_path):
    folder = tmp_path / "sessions"
    folder.mkdir()
    other = subprocess.Popen([sys.executable, "-c", KILLED, str(folder)], cwd=Path.cwd())
    until_s = time.monotonic() + 60.0
    while not any(path.stat().st_size > 20_000 for path in folder.glob("*.blf")):
        assert time.monotonic() < until_s
        of_system("sched_yield")()
    other.kill()
    other.wait()
    sessions = sessions_on(folder)
    sessions.until(lambda: len(sessions.names()) == 1)
    (state,) = sessions.column(SessionColumn.STATE)
    assert state not in {"complete", "empty"}
    assert RecordedSession(folder / "killed.blf").frames > 100


@pytest.fixture
def operator(app_driver, small_disk):
    app_driver.library_folder.parent.mkdir(exist_ok=True)
    app_driver.library_folder.symlink_to(small_disk)
    return Operator(app_driver)


def test_a_trajectory_recording_that_finds_no_room_is_kept_until_it_does(operator, small_disk):
    operator.record()
    fill_up(small_disk)
    operator.click("save_recording")
    assert "No space left on device" in operator.text("record_message")
    assert list(small_disk.glob(".*.unfinished")) == []
    operator.window.leave()
    operator.app_driver.dialog(LeaveQuestion).close()  # it is not saved: it asks
    (small_disk / "filler").unlink()
    operator.click("save_recording")
    assert operator.text("record_message").startswith("Saved as")
    (entry,) = Library(small_disk).entries()
    assert entry.damage is None
    assert entry.count > 100
