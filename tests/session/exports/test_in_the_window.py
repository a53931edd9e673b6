"""The window 导出 with its real process, beside an arm that is connected."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.ui.watch.export_dialog import ExportDialog
from tests.safety.file_watch import watched
from tests.session.exports.logs import candump, session
from tests.session.exports.test_mcap import by_mcap
from tests.ui.dialog_reading import message
from tests.waiting import wait_until

pytestmark = pytest.mark.timeout(240)  # processes take long to begin on a busy computer
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def log(tmp_path) -> Path:
    return candump(tmp_path / "录制.log", session(0.5))


def test_an_export_touches_no_file_in_the_gui_thread(app_driver, log, monkeypatch):
    app_driver.ready()
    with watched(monkeypatch) as seen:
        app_driver.window.pages.open_export(log)
        dialog = app_driver.dialog(ExportDialog)
        QTest.mouseClick(dialog.export_button, LEFT)
        wait_until(dialog.export_button.isEnabled)
    assert message(dialog).startswith(f"Saved: {log.with_suffix('.mcap')} (")
    assert len(by_mcap(log.with_suffix(".mcap"))["/joint_states"]) == 100
    assert seen == []


def test_a_stop_during_an_export_stops_the_arm(app_driver, log):
    app_driver.ready()
    app_driver.window.pages.open_export(log)
    dialog = app_driver.dialog(ExportDialog)
    QTest.mouseClick(dialog.export_button, LEFT)
    app_driver.click(dialog.stop_button)
    app_driver.run_until(lambda: app_driver.firmware.condition.stopped)
    wait_until(dialog.export_button.isEnabled)


def test_the_dialog_is_kept_with_what_was_entered(app_driver, log):
    app_driver.window.pages.open_export(log)
    dialog = app_driver.dialog(ExportDialog)
    dialog.form.begin_field.show_value(1.0)
    dialog.close()
    app_driver.window.pages.open_export()
    assert app_driver.dialog(ExportDialog) is dialog
    assert dialog.form.request().begin_s == 1.0
    assert dialog.form.request().log == log
