"""S2: while a device is open the GUI thread touches no file, whatever the operator does."""

import os
from concurrent.futures import Executor

import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtWidgets import QDialog, QTableView, QWidget

from armui.helper_process import FileThread, HelperProcess
from armui.preload import preload
from armui.protocol.generation import Generation
from armui.trajectory.files import to_bytes
from armui.trajectory.library import Library
from armui.trajectory.preflight import warm_up
from armui.trajectory.program import Trajectory
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.bin_dialog import BinDialog
from armui.ui.trajectory.editor_window import EditorWindow
from armui.ui.trajectory.library_window import LibraryWindow
from armui.ui.trajectory.recording_window import RecordingWindow
from tests.desk import Desk
from tests.operator_library.hands import POINT, Shelf
from tests.safety.file_watch import watched

MOST_S = 200.0

EXCEPTIONS: tuple[tuple[str, str], ...] = ()
"""What the GUI thread may do to files: a part of the frame that does it, and why it may."""


pytestmark = pytest.mark.timeout(240)  # processes take long to begin on a busy computer


class Lent(Executor):
    """Lends an executor to several programs: the end of one does not end it."""

    def __init__(self, executor):
        self.submit = executor.submit


class LentFiles(FileThread):
    """Lends a file thread."""

    def shutdown(self, *_args, **_kwargs):
        """Goes on."""


@pytest.fixture(scope="module")
def workers():
    """The real thread and processes, ready to work."""
    preload()
    process, files = HelperProcess(), LentFiles()
    process.submit(warm_up).result(MOST_S)
    files.submit(files.call, warm_up).result(MOST_S)
    yield process, files
    process.shutdown()
    FileThread.shutdown(files)


@pytest.fixture
def live_desk(qapp, request, tmp_path, workers):
    """A desk with the real thread and processes behind it, and loaded as the program is."""
    process, files = workers
    settings = tmp_path / "settings.json"
    name = request.node.nodeid
    desk = Desk(qapp, name, settings, Generation.TWO, Lent(process), files=files)
    yield desk
    desk.close()


def forbidden(seen):
    return [
        (event, subject, frames[:3], frames[-1:])
        for event, subject, frames in seen
        if not any(part in frame for part, _reason in EXCEPTIONS for frame in frames)
    ]


def idle(desk):
    """Wait until every action on the library asked for by now is done, and shown."""
    done = desk.program._files.submit(lambda: None)
    desk.wait(done.done)
    QCoreApplication.processEvents()


def test_the_watch_sees_what_it_must(tmp_path, monkeypatch):
    with watched(monkeypatch) as seen:
        (tmp_path / "a").write_text("a", "ascii")
        (tmp_path / "a").rename(tmp_path / "b")
        assert (tmp_path / "b").is_file()
        with os.scandir(tmp_path) as items:
            assert [item.name for item in items] == ["b"]
        (tmp_path / "b").unlink()
    (tmp_path / "c").touch()
    events = {event for event, _subject, _frames in seen}
    assert events == {"open", "os.rename", "os.stat", "os.scandir", "os.remove"}
    assert not any(subject.endswith("c") for _event, subject, _frames in seen)


def test_the_library(live_desk, monkeypatch, tmp_path):
    desk = live_desk
    desk.ready()
    for name in ("one", "two"):
        Library(desk.library_folder).save(Trajectory(name, points=(POINT,) * 3))
    outside = tmp_path / "outside.log"
    outside.write_bytes(to_bytes(Trajectory("outside", points=(POINT,) * 2000), ".log"))
    with watched(monkeypatch) as seen:
        shelf = Shelf.__new__(Shelf)
        shelf.desk = desk
        desk.click("library_button")
        shelf.window = window = desk.dialog(LibraryWindow)
        desk.wait(lambda: shelf.names() == ["one", "two"])
        window._deeds.duplicate("one")
        desk.wait(lambda: "one 2" in shelf.names())
        window._deeds.rename("one 2", "three")
        desk.wait(lambda: "three" in shelf.names())
        window._deeds.delete(["three"])
        desk.wait(lambda: "three" not in shelf.names())
        window._bin_button.click()
        bin_dialog = desk.dialog(BinDialog)
        table = bin_dialog.findChild(QTableView)
        desk.wait(lambda: table is None or table.model().rowCount() > 0)
        bin_dialog.close()
        window._deeds.undo()
        desk.wait(lambda: "three" in shelf.names())
        window._exchange.import_files([outside])
        desk.wait(lambda: "outside" in shelf.names())
        window._exchange._write(["one", "two"], lambda name: tmp_path / f"{name}.csv")
        idle(desk)
        shelf.choose("one")
        window._strip.check()
        desk.wait(
            lambda: (
                shelf.rows()[shelf.names().index("one")][4] != "–" and not window._strip._checking
            )
        )
        window._strip._on_send()
        desk.wait(lambda: not window._strip._checking)
        idle(desk)
    assert (tmp_path / "two.csv").exists()
    assert forbidden(seen) == []


def test_the_editor(live_desk, monkeypatch):
    desk = live_desk
    desk.ready()
    Library(desk.library_folder).save(Trajectory("one", points=(POINT,) * 3))
    desk.click("library_button")
    window = desk.dialog(LibraryWindow)
    with watched(monkeypatch) as seen:
        window.open_trajectory("one")
        desk.wait(lambda: "one" in window._editors)
        editor = desk.dialog(EditorWindow)
        desk.click(editor.findChild(QWidget, "editor_insert_measured"))
        editor._drafts._write_behind()
        idle(desk)
        editor._strip.check()
        desk.wait(lambda: not editor._strip._checking)
        editor.save()
        desk.wait(lambda: editor.document.saved)
        editor.document.set_note("mine", "note")
        editor.keep_draft()
        editor._leave()
        idle(desk)
    assert forbidden(seen) == []
    assert len(Library(desk.library_folder).load("one").points) == 4


def test_a_recording(live_desk, monkeypatch):
    desk = live_desk
    desk.ready()
    desk.click("library_button")
    window = desk.dialog(LibraryWindow)
    with watched(monkeypatch) as seen:
        window.open_recorder()
        recorder = desk.dialog(RecordingWindow)
        recorder._on_record()
        desk.run(1.0)
        recorder._on_record()
        desk.wait(lambda: recorder._result is not None)
        recorder.preview()
        desk.wait(lambda: "3D" in recorder.findChild(QWidget, "record_message").text())
        recorder.save_samples()
        desk.wait(lambda: not recorder._unsaved)
        recorder.save_points()
        idle(desk)
        recorder.close()
        idle(desk)
    assert forbidden(seen) == []


@pytest.mark.parametrize("name", ["settings", "backup", "joint_status", "help", "connect"])
def test_the_dialogs(desk, monkeypatch, name):
    preload()
    desk.ready()
    opening = {"settings": "open_settings_dialog", "help": "open_help_dialog"}
    with watched(monkeypatch) as seen:
        getattr(desk.window, opening.get(name, f"open_{name}_dialog"))()
        desk.run(0.2)
        dialog = desk.dialog(QDialog)
        dialog.close()
        desk.run(0.1)
    assert forbidden(seen) == []


def test_the_file_choosers(live_desk, monkeypatch):
    desk = live_desk
    desk.ready()
    Library(desk.library_folder).save(Trajectory("one", points=(POINT,)))
    desk.click("library_button")
    window = desk.dialog(LibraryWindow)
    with watched(monkeypatch) as seen:
        window._exchange.choose_imports()
        desk.run(0.1)
        desk.dialog(FileDialog).close()
        window._exchange.export(["one"], ".csv")
        desk.run(0.1)
        desk.dialog(FileDialog).close()
    assert forbidden(seen) == []


def test_the_panels_and_commands(desk, monkeypatch):
    preload()
    desk.ready()
    with watched(monkeypatch) as seen:
        for place in range(desk.window._panels.count()):
            desk.window._show_panel(place)
            desk.run(0.06)
        assert desk.controller.motion.send_joints((5.0, 30.0, -30.0, 0.0, 0.0, 0.0)) is None
        desk.run(0.5)
        desk.controller.emergency_stop()
        desk.run(0.5)
    assert forbidden(seen) == []
