"""S2, S21: a disk or network share that does not answer holds no window, and nothing else up."""

import json
import threading
import time
from concurrent.futures import BrokenExecutor, CancelledError

import pytest
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QTableView

from armui.arm.refusal import Refusal
from armui.protocol.generation import Generation
from armui.settings import SettingsStore
from armui.system import helper_process
from armui.system.helper_process import FileThread
from armui.trajectory.library import stored_files
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory
from armui.ui.background import Background
from armui.ui.trajectory.library import library_presence
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.widgets.message_line import MessageLine
from tests.accepted import accepted
from tests.app_driver import AppDriver, AtOnce, Slow
from tests.operator.library.actions import POINT

MOST_S = 60.0


class Share:
    """Holds whoever asks it, until it is back."""

    def __init__(self):
        self.asked, self.back = threading.Event(), threading.Event()

    def ask(self):
        self.asked.set()
        assert self.back.wait(MOST_S)
        return "back"


@pytest.fixture
def share():
    share = Share()
    yield share
    share.back.set()


@pytest.fixture
def files(share):
    files = FileThread()
    yield files
    share.back.set()
    files.shutdown()


def hang(files, share):
    """Have the thread ask the share, and be found to hang."""
    share.asked.clear()
    answer = files.submit(share.ask)
    assert share.asked.wait(MOST_S)
    later = files.submit(str)
    assert files.replace_hung(after_s=0.0)
    return answer, later


def test_others_go_on_and_the_first_is_told_what_became_of_it(files, share):
    answer, later = hang(files, share)
    assert later.result(MOST_S) == ""
    assert files.submit(lambda: 3).result(MOST_S) == 3
    assert files.hanging == 1
    assert not answer.done()
    share.back.set()
    assert answer.result(MOST_S) == "back"
    threads = [each for each in threading.enumerate() if each.name == "armui-files"]
    for each in threads[:-1]:
        each.join(MOST_S)
    assert files.hanging == 0


def test_a_thread_that_works_or_waits_is_left_alone(files, share):
    assert not files.replace_hung(after_s=0.0)
    files.submit(lambda: 3).result(MOST_S)
    answer = files.submit(share.ask)
    assert share.asked.wait(MOST_S)
    assert not files.replace_hung(after_s=MOST_S)
    share.back.set()
    assert answer.result(MOST_S) == "back"


def test_only_so_many_are_left_behind(files, share):
    for _ in range(helper_process._MOST_HANGING):
        last = hang(files, share)[1]
    assert files.hanging == helper_process._MOST_HANGING
    for refused in (last, files.submit(lambda: 3)):
        assert isinstance(refused.exception(MOST_S), TimeoutError)
    share.back.set()
    for each in files._left:
        each.join(MOST_S)
    assert files.submit(lambda: 3).result(MOST_S) == 3


def test_the_end_waits_for_no_thread_that_was_left(files, share):
    hang(files, share)
    began_s = time.monotonic()
    files.shutdown()
    assert time.monotonic() - began_s < 5.0
    assert not files.ended  # so the program is ended by force
    share.back.set()


def test_a_process_that_hangs_is_ended_and_replaced(files):
    begun = threading.Event()

    def ask():
        begun.set()
        return files.call(time.sleep, 1e6)

    answer = files.submit(ask)
    assert begun.wait(MOST_S)
    while not files._worker.calling:
        pass
    assert not files.replace_hung(after_s=0.0, call_s=MOST_S)
    assert files.replace_hung(after_s=MOST_S, call_s=0.0)
    with pytest.raises((BrokenExecutor, CancelledError)):
        answer.result(MOST_S)
    assert files.submit(files.call, divmod, 7, 2).result(MOST_S) == (3, 1)


def test_the_library_is_used_by_one_thread_at_a_time(qapp, qtbot, tmp_path, files, share):
    work = LibraryWork(Library(tmp_path), Background(AtOnce(), files), qapp)
    done: list[str] = []
    refused: list[str] = []
    work.do(share.ask, done.append, refused.append)
    assert share.asked.wait(MOST_S)
    work.do(lambda: "second", done.append, refused.append)
    assert files.replace_hung(after_s=0.0)
    qtbot.waitUntil(lambda: bool(refused))
    assert "timed out" in refused[0]
    share.back.set()
    qtbot.waitUntil(lambda: done == ["back"])
    work.do(lambda: "third", done.append, refused.append)
    qtbot.waitUntil(lambda: done == ["back", "third"])


@pytest.fixture
def driver_of(qapp, request, tmp_path):
    made = []

    def make(files):
        name = request.node.nodeid
        made.append(
            AppDriver(qapp, name, tmp_path / "settings.json", Generation.TWO, None, files=files)
        )
        return made[0]

    yield make
    for each in made:
        each.close()


def test_it_is_said_and_the_window_goes_on(driver_of, files, share):
    app_driver = driver_of(files)
    app_driver.ready()
    files.submit(share.ask)
    assert share.asked.wait(MOST_S)
    app_driver.program._replace_hung(files)
    assert "files_hang" not in app_driver.codes()
    files._worker.since_s -= helper_process.HANGS_S
    app_driver.program._replace_hung(files)
    assert "files_hang" in app_driver.codes()
    app_driver.store.change(theme="dark")
    files.submit(str).result(MOST_S)
    assert json.loads(app_driver.store.path.read_text())["theme"] == "dark"
    assert app_driver.controller.emergency_stop() is None
    share.back.set()


def test_a_folder_of_the_library_on_a_share_that_hangs_holds_nobody(
    driver_of, qtbot, files, share, monkeypatch
):
    app_driver = driver_of(files)
    library = Library(app_driver.library_folder)
    library.create_folder("cell")
    library.save(Trajectory("near", points=(POINT,)))
    library.save(Trajectory("far", points=(POINT,)))
    library.move(["far"], "cell")
    app_driver.ready()
    look = stored_files._files

    def ask(folder):
        if folder.name == "cell":
            share.ask()
        return look(folder)

    monkeypatch.setattr(stored_files, "_files", ask)
    app_driver.click("library_button")
    page = app_driver.page(LibraryPage)
    qtbot.waitUntil(share.asked.is_set)
    files._worker.since_s -= helper_process.HANGS_S
    app_driver.program._replace_hung(files)
    assert "files_hang" in app_driver.codes()
    page.refresh()
    message = page.findChild(MessageLine, "library_message")
    qtbot.waitUntil(lambda: "timed out" in message.text())
    assert files.hanging == 1, "the library is not asked by a second thread"
    accepted(app_driver.controller.motion.jog(1, 5.0))
    app_driver.run(0.3)
    app_driver.heard()
    app_driver.controller.emergency_stop()
    app_driver.step()
    assert 0x150 in [frame.arbitration_id for frame in app_driver.heard()]
    share.back.set()
    table = page.findChild(QTableView, "library_table")
    qtbot.waitUntil(lambda: table.model().rowCount() == 2)


def test_whether_a_folder_has_changed_is_asked_in_the_file_thread(
    driver_of, qtbot, files, share, monkeypatch
):
    app_driver = driver_of(files)
    library = Library(app_driver.library_folder)
    library.create_folder("cell")
    app_driver.ready()
    app_driver.click("library_button")
    page = app_driver.page(LibraryPage)
    qtbot.waitUntil(lambda: page._watch._names == ("cell",))
    look, asked_by = library_presence._changed_ns, set()

    def ask(folder):
        asked_by.add(threading.current_thread().name)
        if folder.name == "cell":
            share.ask()
        return look(folder)

    monkeypatch.setattr(library_presence, "_changed_ns", ask)
    qtbot.waitUntil(share.asked.is_set)
    for _ in range(3):
        page._watch._ask()
    assert files.waiting.count("folder_times") == 1, "it is asked again when it has answered"
    app_driver.controller.emergency_stop()
    app_driver.step()
    assert 0x150 in [frame.arbitration_id for frame in app_driver.heard()]
    assert asked_by == {"armui-files"}
    share.back.set()
    library.save(Trajectory("new", points=(POINT,)))
    table = page.findChild(QTableView, "library_table")
    qtbot.waitUntil(lambda: table.model().rowCount() == 1)


# Settings -----------------------------------------------------------------------------------------


def in_file(path):
    return json.loads(path.read_text("utf-8"))


def test_a_view_button_waits_for_no_disk(driver_of):
    slow = Slow()
    app_driver = driver_of(slow)
    app_driver.ready()
    app_driver.window.findChild(QAction, "view_front").trigger()
    assert app_driver.store.settings.picture_direction == "front"
    assert not app_driver.store.path.exists()
    slow.work()
    assert in_file(app_driver.store.path)["picture_direction"] == "front"


@pytest.fixture
def slow_store(tmp_path):
    """A store whose file is written by a thread that the test moves on."""
    store, slow = SettingsStore(tmp_path / "settings.json"), Slow()
    told: list[Refusal] = []
    store.write_by(slow, told.append)
    return store, slow, told


def test_the_latest_of_many_changes_is_written_once(slow_store, monkeypatch):
    store, slow, told = slow_store
    written = []
    monkeypatch.setattr("armui.settings.write_whole", lambda _path, data: written.append(data))
    for step_deg in (2.0, 3.0, 4.0):
        assert store.change(jog_step_deg=step_deg) is None
    assert store.change(theme="dark") is None
    slow.work()
    assert [(each["jog_step_deg"], each["theme"]) for each in map(json.loads, written)] == [
        (4.0, "dark")
    ]
    assert told == []


def test_what_is_not_written_is_said_and_written_with_the_next_change(slow_store, monkeypatch):
    store, slow, told = slow_store
    with monkeypatch.context() as full:

        def refuse(*_arguments):
            raise OSError(28, "No space left on device")

        full.setattr("armui.settings.write_whole", refuse)
        store.change(theme="dark")
        (future, *_rest) = slow.waiting[0]
        slow.work()
    assert future.result().params["text"] == "No space left on device"
    assert [each.code for each in told] == ["settings_not_saved"]
    store.change(jog_step_deg=2.0)
    slow.work()
    kept = in_file(store.path)
    assert (kept["theme"], kept["jog_step_deg"]) == ("dark", 2.0)


def test_a_write_that_hangs_brings_no_older_choice_back(tmp_path, files, share, monkeypatch):
    store = SettingsStore(tmp_path / "settings.json")
    told: list[Refusal] = []
    store.write_by(files, told.append)
    write = store._write_revised

    def held(unsaved, kept):
        share.ask()
        return write(unsaved, kept)

    monkeypatch.setattr(store, "_write_revised", held)
    store.change(theme="dark", jog_step_deg=2.0)
    assert share.asked.wait(MOST_S)
    assert files.replace_hung(after_s=0.0)
    store.change(jog_step_deg=3.0)
    files.submit(str).result(MOST_S)
    assert [each.code for each in told] == ["settings_not_saved"]
    held_up = files._left[0]
    share.back.set()
    held_up.join(MOST_S)
    kept = in_file(store.path)
    assert (kept["theme"], kept["jog_step_deg"]) == ("dark", 3.0)


def test_they_are_written_before_the_program_ends(tmp_path, files):
    store = SettingsStore(tmp_path / "settings.json")
    store.write_by(files, lambda _problem: None)
    store.change(theme="dark")
    files.shutdown()
    assert in_file(store.path)["theme"] == "dark"
    store.change(jog_step_deg=3.0)  # so late that nobody else would
    assert in_file(store.path)["jog_step_deg"] == 3.0
