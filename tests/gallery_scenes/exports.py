"""The window 导出 in use."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog

from armui.export.process import ExportDone
from armui.session.exports.request import ExportProgress
from armui.ui.watch.export_dialog import ExportDialog
from tests.app_driver import AppDriver

LOG = Path("/home/operator/录制/2026-01-15 碰撞.blf")
REPORT = {
    "items": 1_805_304, "frames": 5_412_268, "generation": 2, "why_generation": "",
    "model": "PiPER", "why_model": "", "pose_fits": "PiPER L",
    "firmware": "S-V1.8-5", "offset": 0, "channel": "can0", "other_channels": ["can1"],
    "of_other_channels": 41_020, "not_understood": 12, "questions": 0, "without_stamp": 0,
    "damages": [["byte 48213", "the file breaks off", 5_412_268, False]], "damage_count": 1,
    "notes": [],
}  # fmt: skip


class _Idle:
    """An export that a scene answers."""

    def end(self) -> None:
        """Nothing is under way."""


def _dialog(app_driver: AppDriver, *answers: ExportProgress | ExportDone) -> ExportDialog:
    def begin(_request, tell):
        for answer in answers:
            tell(answer)
        return _Idle()

    dialog = ExportDialog(app_driver.controller, app_driver.window, begin)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.show_log(LOG)
    dialog.open()
    return dialog


def export(app_driver: AppDriver) -> QDialog:
    dialog = _dialog(app_driver)
    dialog.form.begin_field.show_value(12.5)
    dialog.form.end_field.show_value(60.0)
    return dialog


def export_under_way(app_driver: AppDriver) -> QDialog:
    dialog = _dialog(app_driver, ExportProgress(0.42, 2_273_280))
    QTest.mouseClick(dialog.export_button, Qt.MouseButton.LeftButton)
    app_driver.wait(lambda: dialog.progress.value() == 420)
    return dialog


def export_done(app_driver: AppDriver) -> QDialog:
    dialog = _dialog(app_driver, ExportDone(report=REPORT))
    QTest.mouseClick(dialog.export_button, Qt.MouseButton.LeftButton)
    app_driver.wait(dialog.export_button.isEnabled)
    return dialog
