"""What the arm keeps: the panels of its settings, their questions, the backup."""

from __future__ import annotations

import tempfile
from pathlib import Path

from PySide6.QtWidgets import QDialog

from armui.ui.dialogs.backup import BackupDialog
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.files import FileDialog
from tests.app_driver import AppDriver
from tests.family import FACTORY_ACCELERATION_DEG_S2, FACTORY_LIMITS
from tests.gallery_scenes.scene import settled


def _open(app_driver: AppDriver, panel: str) -> None:
    app_driver.click(f"menu_{panel}")
    settled(app_driver)


def joint_settings(app_driver: AppDriver) -> None:
    """Two limits are being edited, one of them out of range."""
    app_driver.connect()
    _open(app_driver, "joint_settings")
    app_driver.click("joint_settings_edit_button")
    app_driver.type_into("max_angle_deg_2", "170")
    app_driver.type_into("max_angle_deg_1", "400")


def joint_settings_refused(app_driver: AppDriver) -> None:
    """What the arm did not take on."""
    joint_settings(app_driver)
    app_driver.type_into("max_angle_deg_1", "150")
    app_driver.type_into("max_speed_deg_s_3", "300")  # more than the motors can do
    app_driver.click("joint_settings_save_button")
    app_driver.confirm()  # beyond the factory's value
    settled(app_driver)


def joint_settings_beyond(app_driver: AppDriver) -> None:
    """A limit beyond the factory's: named, and not saved unasked."""
    joint_settings(app_driver)
    app_driver.type_into("max_angle_deg_1", "200")


def joint_settings_corrupt(app_driver: AppDriver) -> None:
    """Limits that read back as 0xFFFF."""
    app_driver.connect()
    _open(app_driver, "joint_settings")
    app_driver.firmware.corrupt_limits(2)
    app_driver.click("joint_settings_read_button")
    settled(app_driver)
    app_driver.firmware.settings.limits[1] = FACTORY_LIMITS[1]
    app_driver.firmware.settings.accelerations_deg_s2[1] = FACTORY_ACCELERATION_DEG_S2


def end_limits(app_driver: AppDriver) -> None:
    """A limit of the tool saved."""
    app_driver.connect()
    _open(app_driver, "end_limits")
    app_driver.click("end_limits_edit_button")
    app_driver.type_into("max_linear_speed_m_s", "0.5")
    app_driver.click("end_limits_save_button")
    settled(app_driver)


def levels(app_driver: AppDriver) -> None:
    """Two collision levels chosen and not saved."""
    app_driver.connect()
    _open(app_driver, "collision")
    app_driver.click("collision_edit_button")
    app_driver.click("collision_level_2_level_0")
    app_driver.click("collision_level_4_level_8")


def backup(app_driver: AppDriver) -> QDialog:
    """A file that differs from the arm in a few places, beside it."""
    settings = app_driver.firmware.settings
    settings.end_limits, settings.collision_levels = (1.0,) * 4, (1,) * 6
    app_driver.window.pages.show("backup")
    dialog = app_driver.dialog(BackupDialog)
    settled(app_driver)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "piper-S-V1.8-5.json"
        app_driver.click(dialog.save_button)
        app_driver.dialog(FileDialog).fileSelected.emit(str(path))
        settings.end_limits, settings.collision_levels = (0.25, 1.0, 0.8, 1.0), (1, 1, 5, 1, 1, 1)
        app_driver.click(dialog.read_button)
        settled(app_driver)
        dialog.open_file(path)
    dialog.only_differences.setChecked(True)
    return dialog


def confirm_unsaved(app_driver: AppDriver) -> QDialog:
    app_driver.click("menu_motion")
    return app_driver.dialog(ConfirmDialog)
