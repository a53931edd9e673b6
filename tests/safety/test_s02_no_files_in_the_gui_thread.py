"""S2: while a device is open the GUI thread touches no file, whatever the operator does."""

import os
from concurrent.futures import Executor

import pytest
from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QAction, QDesktopServices
from PySide6.QtWidgets import QAbstractButton, QApplication, QDialog, QMenu, QTableView, QWidget
from shiboken6 import isValid

from armui.app import load_pages
from armui.control.event_log.keeper import EventKeeper
from armui.protocol.generation import Generation
from armui.system.helper_process import FileThread, HelperProcess
from armui.trajectory.files import to_bytes
from armui.trajectory.library.store import Library
from armui.trajectory.planning.check import warm_up
from armui.trajectory.points.program import Trajectory
from armui.ui.actions.palette import CommandPalette
from armui.ui.actions.window_actions import WindowActions
from armui.ui.dialogs.about import AboutDialog
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.files import FileDialog
from armui.ui.dialogs.problem_report import ProblemReportDialog
from armui.ui.guide.guide_page import GuidePage
from armui.ui.main_window import MainWindow
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.bin_dialog import BinDialog
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.recording.recording_page import RecordingPage
from armui.ui.watch.bus.bus_page import BusPage
from armui.ui.watch.events.event_page import EventPage
from armui.ui.watch.plot_layout import SETS
from armui.ui.watch.plots_area import PlotPage
from armui.ui.watch.recordings.sessions_page import SessionsPage
from tests.accepted import accepted
from tests.app_driver import AppDriver
from tests.operator.library.actions import POINT, LibraryDriver
from tests.operator.replay_actions import Replay
from tests.safety.file_watch import watched
from tests.session.recordings import START_S, frames, greeting, write
from tests.ui.dialog_reading import message

MOST_S = 200.0

EXCEPTIONS: tuple[tuple[str, str], ...] = (
    ("dialogs/files.py", "where a file chooser begins: Qt's looks at that folder anyway"),
    ("read_devices", "modules of devices, imported when they are switched on"),
)
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
    list(load_pages())
    process, files = HelperProcess(), LentFiles()
    process.submit(warm_up).result(MOST_S)
    files.submit(files.call, warm_up).result(MOST_S)
    yield process, files
    process.shutdown()
    FileThread.shutdown(files)


@pytest.fixture
def live_driver(qapp, request, tmp_path, workers):
    """A program with the real thread and processes behind it, and loaded as the program is."""
    process, files = workers
    settings = tmp_path / "settings.json"
    name = request.node.nodeid
    app_driver = AppDriver(qapp, name, settings, Generation.TWO, Lent(process), files=files)
    yield app_driver
    app_driver.window.keep_work()  # its timer could outlive the thread, which ends with the module
    app_driver.close()
    QApplication.clipboard().clear()  # Python's own data in it would outlive Python


def forbidden(seen):
    return [
        (event, subject, frames[:3], frames[-1:])
        for event, subject, frames in seen
        if not any(part in frame for part, _reason in EXCEPTIONS for frame in frames)
    ]


def idle(app_driver):
    """Wait until every action on the library asked for by now is done, and shown."""
    done = app_driver.program._files.submit(lambda: None)
    app_driver.wait(done.done)
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


def test_the_library(live_driver, monkeypatch, tmp_path):
    app_driver = live_driver
    app_driver.ready()
    for name in ("one", "two"):
        Library(app_driver.library_folder).save(Trajectory(name, points=(POINT,) * 3))
    outside = tmp_path / "outside.log"
    outside.write_bytes(to_bytes(Trajectory("outside", points=(POINT,) * 2000), ".log"))
    with watched(monkeypatch) as seen:
        driver = LibraryDriver.__new__(LibraryDriver)
        driver.app_driver = app_driver
        app_driver.click("library_button")
        driver.window = window = app_driver.page(LibraryPage)
        app_driver.wait(lambda: driver.names() == ["one", "two"])
        window._actions.duplicate("one")
        app_driver.wait(lambda: "one 2" in driver.names())
        window._actions.rename("one 2", "three")
        app_driver.wait(lambda: "three" in driver.names())
        window._actions.delete(["three"])
        app_driver.wait(lambda: "three" not in driver.names())
        window._deleted.button.click()
        bin_dialog = app_driver.dialog(BinDialog)
        table = bin_dialog.findChild(QTableView)
        app_driver.wait(lambda: table is None or table.model().rowCount() > 0)
        bin_dialog.close()
        window._actions.undo()
        app_driver.wait(lambda: "three" in driver.names())
        window._exchange.import_files([outside])
        app_driver.wait(lambda: "outside" in driver.names())
        window._exchange._write(["one", "two"], lambda name: tmp_path / f"{name}.csv")
        idle(app_driver)
        driver.choose("one")
        window._run_bar.check()
        app_driver.wait(
            lambda: (
                driver.rows()[driver.names().index("one")][4] != "–"
                and not window._run_bar.is_checking
            )
        )
        window._run_bar.send()
        app_driver.wait(lambda: not window._run_bar.is_checking)
        idle(app_driver)
    assert (tmp_path / "two.csv").exists()
    assert forbidden(seen) == []


def test_the_editor(live_driver, monkeypatch):
    app_driver = live_driver
    app_driver.ready()
    Library(app_driver.library_folder).save(Trajectory("one", points=(POINT,) * 3))
    app_driver.click("library_button")
    window = app_driver.page(LibraryPage)
    with watched(monkeypatch) as seen:
        window.open_trajectory("one")
        app_driver.wait(lambda: "one" in window.editors)
        editor = app_driver.page(EditorPage)
        app_driver.click(editor.findChild(QWidget, "editor_insert_measured"))
        editor._drafts._write_behind()
        idle(app_driver)
        editor._run_bar.check()
        app_driver.wait(lambda: not editor._run_bar.is_checking)
        editor.save()
        app_driver.wait(lambda: editor.document.saved)
        editor.document.set_note("mine", "note")
        editor.keep_draft()
        editor._leave()
        idle(app_driver)
    assert forbidden(seen) == []
    assert len(Library(app_driver.library_folder).load("one").points) == 4


def test_a_recording(live_driver, monkeypatch):
    app_driver = live_driver
    app_driver.ready()
    app_driver.click("library_button")
    window = app_driver.page(LibraryPage)
    with watched(monkeypatch) as seen:
        window.open_recorder()
        recorder = app_driver.page(RecordingPage)
        recorder._on_record()
        app_driver.run(1.0)
        recorder._on_record()
        app_driver.wait(lambda: recorder._result is not None)
        recorder.preview()
        app_driver.wait(lambda: "3D" in recorder.findChild(QWidget, "record_message").text())
        recorder.save_samples()
        app_driver.wait(lambda: not recorder._unsaved)
        recorder.save_points()
        idle(app_driver)
        recorder.close()
        idle(app_driver)
    assert forbidden(seen) == []


def test_the_curves(live_driver, monkeypatch, tmp_path):
    app_driver = live_driver
    app_driver.ready()
    with watched(monkeypatch) as seen:
        app_driver.click("plots_button")
        window = app_driver.page(PlotPage)
        app_driver.wait(lambda: window.board.built and window._known)
        app_driver.run(1.0)
        window.board.show_plots(SETS["hot"])
        app_driver.wait(lambda: window.board.built)
        window.board.draw(window.board.now_s())
        window.export.save("csv")
        app_driver.dialog(FileDialog).close()
        for kind in ("csv", "png", "svg"):
            window.export.write(kind, tmp_path / f"plots.{kind}")
        idle(app_driver)
        window.close()
        idle(app_driver)
    assert {path.suffix for path in tmp_path.glob("plots.*")} == {".csv", ".png", ".svg", ".json"}
    assert forbidden(seen) == []


def test_the_events(live_driver, monkeypatch, tmp_path):
    app_driver = live_driver
    app_driver.ready()
    keeper = EventKeeper(
        app_driver.controller.event_collector, tmp_path / "logs", app_driver.program._files
    )
    with watched(monkeypatch) as seen:
        app_driver.click("events_button")
        window = app_driver.page(EventPage)
        app_driver.run(0.5)
        keeper.keep()
        window.bar.search.setText("enable")
        app_driver.wait(lambda: not window.model.searching)
        window.export.save("csv", window.model.entries())
        app_driver.dialog(FileDialog).close()
        for kind in ("csv", "json", "txt"):
            window.export.write(kind, window.model.entries(), tmp_path / f"events.{kind}")
        window.export.copy(window.model.entries())
        app_driver.controller.emergency_stop()
        app_driver.run(0.5)
        idle(app_driver)
        keeper.keep()
        keeper.close()
        idle(app_driver)
    assert {path.suffix for path in tmp_path.glob("events.*")} == {".csv", ".json", ".txt"}
    assert (tmp_path / "logs" / "events.jsonl").stat().st_size > 1000
    assert forbidden(seen) == []


def test_a_replay(live_driver, monkeypatch, tmp_path):
    app_driver = live_driver
    app_driver.ready()
    log = tmp_path / "yesterday.blf"
    write(log, frames(2.0, asked=greeting(Generation.TWO)))
    with watched(monkeypatch) as seen:
        replay = Replay(app_driver, monkeypatch, lambda: Lent(live_driver.workers))
        replay.open(log)
        for since_s in (1.5, 0.5):
            replay.replay.go_to(START_S + since_s)
            replay.arrive()
        replay.replay.play(on=True)
        app_driver.run(0.2)
        replay.click("replay_step")
        replay.click("replay_other")
        app_driver.dialog(FileDialog).close()
        replay.window.close()
        idle(app_driver)
    assert forbidden(seen) == []


@pytest.mark.parametrize("name", ["settings", "backup", "connect"])
def test_the_dialogs(live_driver, monkeypatch, name):
    app_driver = live_driver
    app_driver.ready()
    with watched(monkeypatch) as seen:
        app_driver.window.pages.show(name)
        app_driver.run(0.2)
        dialog = app_driver.dialog(QDialog)
        dialog.close()
        app_driver.run(0.1)
    assert forbidden(seen) == []


@pytest.mark.parametrize("name", ["joint_status", "guide", "sessions"])
def test_the_pages_of_the_drawer(live_driver, monkeypatch, name):
    """The guide, its pictures too, is read by another thread."""
    app_driver = live_driver
    app_driver.ready()
    with watched(monkeypatch) as seen:
        app_driver.click("events_button")
        app_driver.click(f"drawer_{name}")
        app_driver.run(0.2)
        page = app_driver.find("drawer").current
        if isinstance(page, GuidePage):
            app_driver.wait(lambda: page.shown != "")
            page.show_section("motion")
            picture = "pictures/motion-en.png"
            app_driver.wait(lambda: page.browser.picture_width(picture) > 0)
        app_driver.click("drawer_take_out")
        app_driver.run(0.2)
        page.leave()
        app_driver.run(0.1)
    assert forbidden(seen) == []


@pytest.mark.parametrize("name", ["palette", "shortcuts"])
def test_what_opens_by_a_key_in_every_window(live_driver, monkeypatch, name):
    """Names are read by another thread."""
    app_driver = live_driver
    app_driver.ready()
    with watched(monkeypatch) as seen:
        getattr(app_driver.window.findChild(WindowActions), f"open_{name}")()
        dialog = app_driver.dialog(QDialog)
        if isinstance(dialog, CommandPalette):
            app_driver.wait(lambda: dialog._names.known)
            dialog.search.setText("ydkz")
        app_driver.run(0.2)
        dialog.close()
        app_driver.run(0.1)
    assert forbidden(seen) == []


@pytest.mark.parametrize("name", ["report", "about"])
def test_what_tells_of_the_program(live_driver, monkeypatch, tmp_path, name):
    """Logs, settings and licences are read, and the report is written, by the file thread."""
    app_driver = live_driver
    app_driver.ready()
    path = tmp_path / "report.zip"
    with watched(monkeypatch) as seen:
        app_driver.window.pages.show(name)
        dialog = app_driver.dialog(ProblemReportDialog if name == "report" else AboutDialog)
        if isinstance(dialog, ProblemReportDialog):
            dialog._under_way.end()  # what it says is no matter, and takes a busy computer long
            dialog._answered.emit(dialog._number, [])
        app_driver.wait(lambda: dialog.list.count() > 3)
        if isinstance(dialog, ProblemReportDialog):
            app_driver.wait(lambda: app_driver.controller.sessions.ring().frames > 0)
            dialog._refresh()
            dialog.bus_box.click()
            app_driver.wait(lambda: len(dialog.files()) > 4 and dialog.save_button.isEnabled())
            dialog._on_chosen(path)
            app_driver.wait(lambda: "report.zip" in message(dialog) and dialog._saving is None)
        else:
            app_driver.wait(lambda: dialog.text.toPlainText() != "")
        dialog.close()
        app_driver.run(0.1)
    assert forbidden(seen) == []
    assert path.is_file() is (name == "report")


def test_session_recordings(live_driver, monkeypatch, tmp_path):
    app_driver = live_driver
    sessions = app_driver.controller.sessions
    app_driver.store.change(session_folder=str(tmp_path / "sessions"))
    app_driver.ready()
    with watched(monkeypatch) as seen:
        app_driver.click("sessions_button")
        window = app_driver.page(SessionsPage)
        window.recording.record_button.click()
        app_driver.run(1.0)
        app_driver.wait(lambda: (sessions.progress() or window) and sessions.progress().frames > 0)
        window._refresh_cards()
        window.recording.record_button.click()
        app_driver.wait(lambda: "session_ended" in app_driver.codes())
        window.ring.save_button.click()
        app_driver.wait(lambda: "ring_saved" in app_driver.codes())
        app_driver.wait(lambda: window.table.model().rowCount() == 2)
        window.table.selectRow(0)
        window._rename(window.chosen()[0].name, "renamed")
        app_driver.wait(lambda: window.table.model().index(0, 0).data() == "renamed")
        window.delete_button.click()
        app_driver.wait(lambda: window.table.model().rowCount() == 1)
        idle(app_driver)
    assert forbidden(seen) == []


def test_the_file_choosers(live_driver, monkeypatch):
    app_driver = live_driver
    app_driver.ready()
    Library(app_driver.library_folder).save(Trajectory("one", points=(POINT,)))
    app_driver.click("library_button")
    window = app_driver.page(LibraryPage)
    with watched(monkeypatch) as seen:
        window._exchange.choose_imports()
        app_driver.run(0.1)
        app_driver.dialog(FileDialog).close()
        window._exchange.export(["one"], ".csv")
        app_driver.run(0.1)
        app_driver.dialog(FileDialog).close()
    assert forbidden(seen) == []


def test_the_panels_and_commands(app_driver, monkeypatch):
    list(load_pages())
    app_driver.ready()
    with watched(monkeypatch) as seen:
        for place in range(app_driver.window._panels.count()):
            app_driver.window._show_panel(place)
            app_driver.run(0.06)
        accepted(app_driver.controller.motion.send_joints((5.0, 30.0, -30.0, 0.0, 0.0, 0.0)))
        app_driver.run(0.5)
        app_driver.controller.emergency_stop()
        app_driver.run(0.5)
    assert forbidden(seen) == []


def test_the_bus_monitor(app_driver, monkeypatch):
    list(load_pages())
    app_driver.ready()
    with watched(monkeypatch) as seen:
        app_driver.click("bus_button")
        window = app_driver.page(BusPage)
        app_driver.run(0.3)
        window.refresh()
        window.tree.expandAll()
        window.filter_bar.in_order.click()
        app_driver.hold_button(window.send_box.unlock)
        window.send_box.take(0x155, bytes(8))
        app_driver.hold_button(window.send_box.hold)
        app_driver.run(0.3)
        window.refresh()
        window.grab()
        window.close()
    assert forbidden(seen) == []


LEFT_ALONE = frozenset({"emergency_stop_button"})
"""Buttons whose press ends what the others are pressed for."""
MOST_PRESSED = 2_000


def key_of(pressed):
    """What tells buttons apart, whoever makes them anew."""
    kinds, at = [], pressed
    while at is not None:
        kinds.append(type(at).__name__)
        at = at.parent()
    return pressed.objectName(), pressed.text(), *kinds


def next_to_press(main, done):
    """The next button or entry of a menu that nobody has pressed, those of open windows first."""
    for window in [*open_windows(main), main]:
        if isinstance(window, FileDialog | ConfirmDialog | QMenu):
            continue
        for each in (*window.findChildren(QAbstractButton), *window.findChildren(QAction)):
            if getattr(each, "menu", bool)() or (isinstance(each, QAction) and each.isSeparator()):
                continue  # what is in a menu is found by itself
            if isinstance(each, QAction) and not isinstance(each.parent(), QWidget):
                continue  # a library's own, which nobody is shown
            possible = each.isEnabled() and each.isVisible()
            if possible and each.objectName() not in LEFT_ALONE and key_of(each) not in done:
                return each
    return None


def open_windows(main):
    shown = [each for each in QApplication.topLevelWidgets() if isValid(each) and each.isVisible()]
    return [each for each in shown if each is not main and each.isWindow()]


def press_everything(app_driver, done):
    """Press all there is, and all in what that opens; a question is answered by closing it."""
    while (each := next_to_press(app_driver.window, done)) is not None:
        done.add(key_of(each))
        assert len(done) < MOST_PRESSED
        each.trigger() if isinstance(each, QAction) else each.click()
        app_driver.run(0.02)
        for opened in open_windows(app_driver.window):
            if isValid(opened) and isinstance(opened, FileDialog | ConfirmDialog | QMenu):
                opened.close()
    for opened in open_windows(app_driver.window):
        if isValid(opened):
            opened.close()


def test_everything_that_can_be_pressed(live_driver, monkeypatch, tmp_path):
    """Every panel, and the window's own buttons and menus, while an arm is open."""
    app_driver = live_driver
    app_driver.store.change(session_folder=str(tmp_path / "sessions"))
    app_driver.ready()
    monkeypatch.setattr(MainWindow, "close", lambda _window: False)
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda _url: True)
    done: set[tuple[str, ...]] = set()
    with watched(monkeypatch) as seen:
        for place in range(app_driver.window._panels.count()):
            app_driver.window._show_panel(place)
            app_driver.run(0.06)
            press_everything(app_driver, done)
        idle(app_driver)
        app_driver.controller.emergency_stop()
        app_driver.run(0.2)
    assert len(done) > 150
    assert forbidden(seen) == []
