"""The dialogs of the window itself: device, settings of the program, help, joint status."""

from __future__ import annotations

import errno
from pathlib import Path

import can
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QLineEdit

from armui.arm.device import Device
from armui.ui.dialogs.confirm import ConfirmDialog
from armui.ui.dialogs.connect import ConnectDialog
from armui.ui.dialogs.files import FileDialog
from armui.ui.dialogs.help import HelpDialog
from armui.ui.dialogs.joint_status import JointStatusDialog
from armui.ui.dialogs.settings import SettingsDialog
from tests.desk import Desk
from tests.faulty_arm import FaultyDrivers

ADAPTERS = (
    Device("socketcan", "can0", None),
    Device("gs_usb", "0", serial="0031002F5246501620303538"),
    Device("slcan", "/dev/ttyACM0", serial="206E3599"),
)


def connect(desk: Desk) -> QDialog:
    desk.window.open_connect_dialog()
    dialog = desk.dialog(ConnectDialog)
    # the search finds the simulated arm alone; its answer must not come after this
    desk.wait(dialog.refresh_button.isEnabled)
    desk.controller.devices_found.emit([desk.device, *ADAPTERS])
    return dialog


def connect_searching(desk: Desk) -> QDialog:
    dialog = connect(desk)
    desk.controller.searching_changed.emit(True)
    return dialog


def connect_failed(desk: Desk) -> QDialog:
    desk.broken = can.CanInitializationError("busy", error_code=errno.EBUSY)
    desk.controller.connect_device(ADAPTERS[1])
    desk.wait(lambda: desk.controller.situation.link_problem is not None)
    desk.plug_in()
    return connect(desk)


def settings(desk: Desk) -> QDialog:
    desk.window.open_settings_dialog()
    return desk.dialog(SettingsDialog)


def settings_refused(desk: Desk) -> QDialog:
    dialog = settings(desk)
    field = dialog.findChild(QLineEdit)
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "99")
    QTest.keyClick(field, Qt.Key.Key_Return)
    return dialog


def help_window(desk: Desk) -> QDialog:
    desk.window.open_help_dialog()
    return desk.dialog(HelpDialog)


def joint_status(desk: Desk) -> QDialog:
    desk.window.open_joint_status_dialog()
    return desk.dialog(JointStatusDialog)


def joint_status_faults(desk: Desk) -> QDialog:
    drivers = FaultyDrivers(desk.firmware)
    drivers.bits = {2: 0x04, 4: 0x11, 5: 0x80}
    desk.firmware.set_communication_fault(6, present=True)
    desk.run(0.2)
    # gone with the next step of the arm's time, which stands still until then
    desk.firmware.set_communication_fault(6, present=False)
    drivers.mend()
    return joint_status(desk)


def file(desk: Desk) -> QDialog:
    dialog = settings(desk)
    QTest.mouseClick(dialog.browse_button, Qt.MouseButton.LeftButton)
    chooser = desk.dialog(FileDialog)
    chooser.setDirectory(str(Path(__file__).resolve().parents[2] / "urdf"))
    return chooser


def confirm_disable(desk: Desk) -> QDialog:
    desk.click("enable_button")
    return desk.dialog(ConfirmDialog)


def confirm_resume(desk: Desk) -> QDialog:
    desk.click("stop_button")
    return desk.dialog(ConfirmDialog)


def confirm_close(desk: Desk) -> QDialog:
    desk.window.close()
    return desk.dialog(ConfirmDialog)
