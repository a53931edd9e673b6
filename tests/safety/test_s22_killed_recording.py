"""S22: a recording of the arm that was not saved outlives the program, and is offered once."""

import json
import math
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QWidget

from armui.trajectory.library.store import Library, LibraryError
from armui.ui.dialogs.confirm_dialog import LeaveQuestion
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.operator.test_recording import Operator

KILLED = """
import os, signal, sys
from pathlib import Path
import numpy as np
from armui.trajectory.library.store import Library
library = Library(Path(sys.argv[1]))
draft = library.begin_recording("swing", "PiPER")
for second in range(3):
    samples = np.zeros((100, 8))
    samples[:, 0] = second + np.arange(100) / 100
    samples[:, 1] = samples[:, 0]
    samples[:, 7] = np.nan
    library.append_recording(draft, samples)
if "alive" in sys.argv:
    print("recording", flush=True)
    sys.stdin.read()
os.kill(os.getpid(), signal.SIGKILL)
"""


def record_and_kill(folder):
    """Let another program record 3 s at 100 samples a second, and be killed."""
    done = subprocess.run([sys.executable, "-c", KILLED, str(folder)], cwd=Path.cwd(), check=False)
    if hasattr(signal, "SIGKILL"):
        assert done.returncode == -signal.SIGKILL


def samples_file(folder):
    (found,) = (folder / ".recordings").glob("*/samples")
    return found


def drafts_in(folder):
    return [path.stat().st_size for path in (folder / ".recordings").glob("*/samples")]


pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="kills in the manner of POSIX")


def test_all_that_was_written_is_found_and_kept(tmp_path):
    record_and_kill(tmp_path)
    library = Library(tmp_path)
    (unsaved,) = library.unsaved_recordings()
    assert (unsaved.name, unsaved.count, unsaved.taught_on) == ("swing", 300, "PiPER")
    assert library.keep_recording(unsaved) == "swing"
    recording = library.load("swing")
    assert np.allclose(recording.joints_deg[:, 0], np.arange(300) / 100)
    assert np.isnan(recording.gripper_mm).all()
    assert (recording.taught_on, recording.duration_s) == ("PiPER", 2.99)
    assert library.unsaved_recordings() == []
    assert list((tmp_path / ".recordings").iterdir()) == []


def test_what_another_running_program_records_is_not_offered(tmp_path):
    other = subprocess.Popen(
        [sys.executable, "-c", KILLED, str(tmp_path), "alive"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        cwd=Path.cwd(),
    )
    assert other.stdout.readline() == b"recording\n"
    assert Library(tmp_path).unsaved_recordings() == []
    other.stdin.close()
    other.wait()
    other.stdout.close()
    assert len(Library(tmp_path).unsaved_recordings()) == 1


@pytest.mark.parametrize(
    ("tail", "count"),
    [(b"\x00" * 37, 300), (bytes(64 * 5), 299), (b"\xff" * 128, 299)],
    ids=["half a sample", "zeros after a power cut", "no figures"],
)
def test_a_damaged_end_is_cut_off(tmp_path, tail, count):
    record_and_kill(tmp_path)
    with samples_file(tmp_path).open("ab") as file:
        file.write(tail)
    library = Library(tmp_path)
    (unsaved,) = library.unsaved_recordings()
    assert len(library.load(library.keep_recording(unsaved)).samples) == count


def test_a_sample_torn_by_a_power_cut_sends_no_joint_to_zero(tmp_path):
    """The disk had written a block up to the middle of a sample; the rest of the file is zeros."""
    folder = tmp_path / ".recordings" / "1-a"
    folder.mkdir(parents=True)
    header = {"name": "torn", "taught_on": "", "begun": "2026-01-01T00:00:00+00:00"}
    rows = [(0.01 * row, 30.0, 40.0, -50.0, 10.0, 20.0, 5.0, math.nan) for row in range(20)]
    whole = np.array(rows, "<f8").tobytes()
    kept = 64 * 15 + 24  # time and two angles of the sixteenth
    data = whole[:kept] + bytes(len(whole) - kept)
    (folder / "samples").write_bytes(json.dumps(header).encode() + b"\n" + data)
    library = Library(tmp_path)
    (unsaved,) = library.unsaved_recordings()
    recording = library.load(library.keep_recording(unsaved))
    assert len(recording.samples) == 15
    assert np.allclose(recording.joints_deg, rows[0][1:7])


@pytest.mark.parametrize("data", [b"", b"\n", b"{}\n" + bytes(640), b"\xff" * 5000, b"[1]\n1234"])
def test_a_file_that_is_none_is_left_alone(tmp_path, data):
    folder = tmp_path / ".recordings" / "1-a"
    folder.mkdir(parents=True)
    (folder / "samples").write_bytes(data)
    assert Library(tmp_path).unsaved_recordings() == []
    assert (folder / "samples").read_bytes() == data


def test_one_that_is_gone_meanwhile_is_refused(tmp_path):
    record_and_kill(tmp_path)
    library = Library(tmp_path)
    (unsaved,) = library.unsaved_recordings()
    library.keep_recording(unsaved)
    with pytest.raises(LibraryError):
        library.keep_recording(unsaved)


# In the window -------------------------------------------------------------------------------


@pytest.fixture
def found(app_driver):
    """The library's page, opened after a program was killed."""
    record_and_kill(app_driver.library_folder)
    app_driver.click("library_button")
    page = app_driver.page(LibraryPage)
    child = lambda name: page.findChild(QWidget, name)  # noqa: E731
    assert "swing" in child("unsaved_recording").text()
    assert "300 samples" in child("unsaved_recording").text()
    return app_driver, child


def test_it_is_offered_and_kept(found):
    app_driver, child = found
    app_driver.click(child("keep_recording"))
    assert not child("keep_recording").isVisible()
    assert child("library_message").text() == "Saved as “swing”."
    (entry,) = Library(app_driver.library_folder).entries()
    assert (entry.name, entry.kind, entry.count) == ("swing", "recording", 300)


def test_it_is_discarded_and_can_be_brought_back(found):
    app_driver, child = found
    app_driver.click(child("discard_recording"))
    assert not child("discard_recording").isVisible()
    library = Library(app_driver.library_folder)
    assert library.entries() == []
    (deleted,) = library.recently_deleted()
    assert library.restore(deleted) == ("swing",)


@pytest.fixture
def operator(app_driver):
    return Operator(app_driver)


def test_it_is_written_as_it_comes(operator):
    folder = operator.app_driver.library_folder
    operator.click("record")
    operator.app_driver.run(1.0)
    operator.window._keeper.write()
    (first,) = drafts_in(folder)
    assert first > 64 * 50
    operator.app_driver.run(1.0)
    operator.app_driver.program.window.keep_work()  # the program is ended by the system
    (second,) = drafts_in(folder)
    assert second > 1.5 * first
    assert operator.window._keeper._timer.isActive()
    assert operator.window._keeper._timer.interval() == 1000


def test_what_is_recorded_to_its_end_is_whole(operator):
    operator.record()
    header, _, samples = (
        samples_file(operator.app_driver.library_folder).read_bytes().partition(b"\n")
    )
    assert b'"name": "Recording"' in header
    assert len(samples) == 64 * operator.app_driver.controller.recorder.count > 64 * 100


@pytest.mark.parametrize("button", ["save_recording", "save_points"])
def test_nothing_is_left_of_one_that_is_saved(operator, button):
    operator.record()
    operator.click(button)
    assert drafts_in(operator.app_driver.library_folder) == []


def test_nor_of_one_that_is_discarded(operator):
    operator.record()
    operator.window.leave()
    operator.app_driver.click(operator.app_driver.dialog(LeaveQuestion).action_button)
    assert drafts_in(operator.app_driver.library_folder) == []


def test_nor_of_one_that_another_takes_the_place_of(operator):
    operator.record()
    operator.record()
    assert len(drafts_in(operator.app_driver.library_folder)) == 1


def test_a_disk_that_refuses_is_said_once_and_recording_goes_on(operator):
    folder = operator.app_driver.library_folder
    folder.mkdir(exist_ok=True)
    (folder / ".recordings").write_bytes(b"in the way")
    operator.click("record")
    operator.app_driver.run(0.5)
    operator.window._keeper.write()
    assert operator.text("record_message").startswith("It is in memory alone until it is saved.")
    assert not operator.window._keeper._timer.isActive()
    operator.app_driver.run(0.5)
    operator.click("record")
    operator.click("save_recording")
    assert operator.text("record_message").startswith("Saved as")
    (entry,) = Library(folder).entries()
    assert entry.length_s is not None
    assert entry.length_s > 0.9
