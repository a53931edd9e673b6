"""What the arm keeps: the panels of its settings, their questions, the backup."""

from __future__ import annotations

import tempfile
from pathlib import Path

from PySide6.QtWidgets import QDialog

from armui.arm.limits import FACTORY_ACCELERATION_DEG_S2, FACTORY_LIMITS
from armui.ui.dialogs.backup import BackupDialog
from armui.ui.dialogs.confirm import ConfirmDialog
from armui.ui.dialogs.files import FileDialog
from tests.desk import Desk
from tests.gallery_scenes.scene import settled


def _open(desk: Desk, panel: str) -> None:
    desk.click(f"menu_{panel}")
    settled(desk)


def joint_settings(desk: Desk) -> None:
    """Two limits are being edited, one of them out of range."""
    desk.connect()
    _open(desk, "joint_settings")
    desk.click("joint_settings_edit_button")
    desk.type_into("max_angle_deg_2", "170")
    desk.type_into("max_angle_deg_1", "400")


def joint_settings_refused(desk: Desk) -> None:
    """What the arm did not take on."""
    joint_settings(desk)
    desk.type_into("max_angle_deg_1", "150")
    desk.type_into("max_speed_deg_s_3", "300")  # more than the motors can do
    desk.click("joint_settings_save_button")
    settled(desk)


def joint_settings_corrupt(desk: Desk) -> None:
    """Limits that read back as 0xFFFF."""
    desk.connect()
    _open(desk, "joint_settings")
    desk.firmware.corrupt_limits(2)
    desk.click("joint_settings_read_button")
    settled(desk)
    desk.firmware.settings.limits[1] = FACTORY_LIMITS[1]
    desk.firmware.settings.accelerations_deg_s2[1] = FACTORY_ACCELERATION_DEG_S2


def end_limits(desk: Desk) -> None:
    """A limit of the tool saved."""
    desk.connect()
    _open(desk, "end_limits")
    desk.click("end_limits_edit_button")
    desk.type_into("max_linear_speed_m_s", "0.5")
    desk.click("end_limits_save_button")
    settled(desk)


def levels(desk: Desk) -> None:
    """Two collision levels chosen and not saved."""
    desk.connect()
    _open(desk, "collision")
    desk.click("collision_edit_button")
    desk.click("collision_level_2_level_0")
    desk.click("collision_level_4_level_8")


def backup(desk: Desk) -> QDialog:
    """A file that differs from the arm in a few places, beside it."""
    settings = desk.firmware.settings
    settings.end_limits, settings.collision_levels = (1.0,) * 4, (1,) * 6
    desk.window.open_backup_dialog()
    dialog = desk.dialog(BackupDialog)
    settled(desk)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "piper-S-V1.8-5.json"
        desk.click(dialog.save_button)
        desk.dialog(FileDialog).fileSelected.emit(str(path))
        settings.end_limits, settings.collision_levels = (0.25, 1.0, 0.8, 1.0), (1, 1, 5, 1, 1, 1)
        desk.click(dialog.read_button)
        settled(desk)
        dialog.open_file(path)
    dialog.only_differences.setChecked(True)
    return dialog


def confirm_unsaved(desk: Desk) -> QDialog:
    desk.click("menu_motion")
    return desk.dialog(ConfirmDialog)
