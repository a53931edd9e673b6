"""会话记录: what an operator does about recordings of sessions, and reads."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QDesktopServices
from PySide6.QtWidgets import QWidget

from armui.session.recording.recorded_session import RecordedSession
from armui.ui.dialogs.files import FileDialog
from armui.ui.shell import page_opener
from armui.ui.watch.recordings.recording_card import moment_text
from armui.ui.watch.recordings.sessions_page import SessionColumn, SessionsPage
from armui.ui.watch.replay.replay_window import ReplayWindow


@pytest.fixture
def sessions(app_driver, tmp_path):
    """The page, before an arm that is connected."""
    app_driver.store.change(session_folder=str(tmp_path / "sessions"))
    app_driver.connect()
    app_driver.click("sessions_button")
    return Sessions(app_driver, app_driver.page(SessionsPage), tmp_path / "sessions")


class Sessions:
    def __init__(self, driver, window, folder):
        self.driver, self.window, self.folder = driver, window, folder
        self.recorder = driver.controller.sessions

    def until(self, condition):
        def looked():
            self.recorder.poll()
            return condition()

        self.driver.wait(looked)

    def record(self, seconds=1.0):
        """Press «Record», wait, press it again, wait for the list."""
        count = len(self.names())
        self.driver.click(self.window.recording.record_button)
        self.driver.run(seconds)
        self.driver.click(self.window.recording.record_button)
        self.until(lambda: len(self.names()) > count and not self.recorder.busy_names())
        self.until(lambda: "under way" not in self.column(SessionColumn.STATE))

    def column(self, column):
        model = self.window.table.model()
        return [model.index(row, column).data() for row in range(model.rowCount())]

    def names(self):
        return self.column(SessionColumn.NAME)

    def said(self):
        return self.window._message.text()


def test_where_no_file_manager_opens_the_folder_is_named(sessions, monkeypatch):
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda _url: False)
    sessions.driver.click("session_show_folder")
    assert str(sessions.folder) in sessions.said()


@pytest.mark.styled
def test_a_session_is_recorded_and_listed(sessions):
    driver, window = sessions.driver, sessions.window
    assert driver.window.findChild(QWidget, "recording_mark") is None
    height = driver.find("status_bar").height()
    assert window.recording.state_label.text() == "Not logging"

    driver.click(window.recording.record_button)
    mark = driver.find("recording_mark")
    assert mark.isVisible()
    driver.run(3.2)
    sessions.until(lambda: (sessions.recorder.progress() or window).frames > 1000)
    window._refresh_cards()
    assert window.recording.record_button.text().strip() == "Stop log"
    assert window.recording.figures_label.text().startswith("3 s · ")
    mark._show_time()
    assert mark.text().strip() == "3 s"
    assert driver.find("status_bar").height() == height

    driver.click(window.recording.record_button)
    sessions.until(lambda: sessions.column(SessionColumn.STATE) == ["complete"])
    assert not mark.isVisible()
    assert sessions.column(SessionColumn.KIND) == ["recorded"]
    assert "Log written" in sessions.said()
    assert sessions.column(SessionColumn.LENGTH) == ["3 s"]


def test_the_mark_in_the_status_bar_opens_the_window(sessions):
    sessions.recorder.start()
    sessions.window.close()
    sessions.driver.click("recording_mark")
    assert sessions.window.isVisible()


def test_what_just_happened_is_saved_with_one_button(sessions):
    driver, window = sessions.driver, sessions.window
    driver.run(1.0)
    sessions.until(lambda: sessions.recorder.ring().frames > 1000)
    window._refresh_cards()
    assert "of 5 minutes" in window.ring.content_label.text()
    assert window.ring.memory_label.text().endswith("22.0 MB at most")
    driver.click(window.ring.save_button)
    sessions.until(lambda: sessions.column(SessionColumn.STATE) == ["complete"])
    assert sessions.column(SessionColumn.KIND) == ["saved from memory"]
    sessions.until(lambda: "What just happened is saved" in sessions.said())


def test_a_recording_is_renamed_in_the_list(sessions):
    sessions.record()
    sessions.record()
    model = sessions.window.table.model()
    first, second = sessions.names()
    model.setData(model.index(0, SessionColumn.NAME), "夜班", Qt.ItemDataRole.EditRole)
    sessions.until(lambda: sorted(sessions.names()) == sorted(["夜班", second]))
    assert RecordedSession(sessions.folder / "夜班.blf").frames > 0

    row = sessions.names().index(second)
    model.setData(model.index(row, SessionColumn.NAME), "夜班", Qt.ItemDataRole.EditRole)
    assert "already" in sessions.said()
    model.setData(model.index(row, SessionColumn.NAME), "a/b", Qt.ItemDataRole.EditRole)
    assert "cannot be the name" in sessions.said()
    assert sorted(sessions.names()) == sorted(["夜班", second])
    assert first not in sessions.names()


def test_a_recording_is_deleted_into_a_folder_from_which_it_can_come_back(sessions, monkeypatch):
    # S2: what only the replay window needs is not loaded by this press
    monkeypatch.setattr(page_opener, "replay_window", lambda: pytest.fail("it was loaded"))
    sessions.record()
    (name,) = sessions.names()
    sessions.window.table.selectRow(0)
    sessions.driver.click(sessions.window.delete_button)
    sessions.until(lambda: sessions.names() == [])
    assert str(sessions.folder / "deleted") in sessions.said()
    (kept,) = sessions.folder.glob(f"deleted/*/{name}.blf")
    assert RecordedSession(kept).frames > 0


def test_what_is_being_replayed_stays_where_it_is(sessions):
    sessions.record()
    (name,) = sessions.names()
    sessions.window.table.selectRow(0)
    sessions.driver.click(sessions.window.open_button)
    replay = sessions.driver.dialog(ReplayWindow)
    sessions.driver.click(sessions.window.delete_button)
    assert sessions.said().endswith("is open in the replay window. Close that window first.")
    sessions.window._rename(name, "other")
    assert sessions.said().endswith("is open in the replay window. Close that window first.")
    assert (sessions.folder / f"{name}.blf").exists()
    replay.close()
    sessions.driver.click(sessions.window.delete_button)
    sessions.until(lambda: sessions.names() == [])


def test_what_is_being_written_can_be_opened_but_not_moved(sessions):
    window = sessions.window
    wanted: list[Path] = []
    window.open_wanted.connect(wanted.append)
    sessions.recorder.start("now")
    sessions.driver.run(0.5)
    sessions.until(lambda: sessions.recorder.progress().frames > 0)
    window.refresh()
    window.table.clearSelection()
    assert "Choose one log" in window.open_button.toolTip()
    window.table.selectRow(0)
    assert sessions.column(SessionColumn.STATE) == ["under way"]
    assert window.rename_button.toolTip() == window.delete_button.toolTip() == "under way"
    assert sessions.column(SessionColumn.SIZE) == ["—"]
    assert not window.delete_button.isEnabled()
    assert not window.rename_button.isEnabled()
    window._rename("now", "later")
    assert "still being written" in sessions.said()
    sessions.driver.click(window.open_button)
    assert wanted == [sessions.folder / "now.blf"]


def test_what_the_operator_chooses_is_kept(sessions, tmp_path):
    driver, window = sessions.driver, sessions.window
    box = window.recording.format_box
    box.setCurrentIndex(box.findData(".log"))
    box.activated.emit(box.currentIndex())
    window.recording.size_box.setValue(25)
    driver.click(window.ring.at_faults_box)
    driver.click(window.recording.folder_button)
    dialog = driver.dialog(FileDialog)
    dialog.fileSelected.emit(str(tmp_path / "elsewhere"))
    dialog.close()

    settings = driver.store.settings
    assert (settings.session_format, settings.session_rotate_mb) == (".log", 25)
    assert settings.session_save_at_faults
    assert Path(settings.session_folder) == tmp_path / "elsewhere"
    sessions.recorder.start("chosen")
    driver.run(0.5)
    sessions.recorder.stop()
    sessions.until(lambda: "session_ended" in driver.codes())
    assert (tmp_path / "elsewhere" / "chosen.log").stat().st_size > 0


def test_a_folder_that_cannot_be_written_is_told_in_the_window(sessions, tmp_path):
    (tmp_path / "file").write_text("")
    sessions.driver.store.change(session_folder=str(tmp_path / "file" / "below"))
    sessions.driver.click(sessions.window.recording.record_button)
    sessions.until(lambda: not sessions.recorder.recording)
    assert "could not be written" in sessions.said()
    assert not sessions.driver.find("recording_mark").isVisible()


def test_a_hidden_window_looks_at_nothing(sessions):
    assert sessions.window._timer.isActive()
    sessions.window.close()
    assert not sessions.window._timer.isActive()


def test_a_time_no_calendar_has():
    assert moment_text(1e300) == "—"
