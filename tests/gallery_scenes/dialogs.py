"""The dialogs of the window itself: device, settings of the program, palette, questions."""

from __future__ import annotations

import errno
from pathlib import Path

import can
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QLineEdit

from armui.arm.device import Device
from armui.doctor.facts import (
    CanFacts,
    Facts,
    HeardFacts,
    LinkFacts,
    OtherFrames,
    ProgramFacts,
    ScreenFacts,
)
from armui.doctor.judge import judge
from armui.ui.actions.palette import CommandPalette
from armui.ui.actions.shortcut_list import ShortcutList
from armui.ui.actions.window_actions import WindowActions
from armui.ui.dialogs.about_arm import AboutArmDialog
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.connect import AdapterTrouble, ConnectDialog
from armui.ui.dialogs.doctor import DoctorDialog
from armui.ui.dialogs.files import FileDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.dialogs.simulated_faults import FaultsDialog
from tests.app_driver import AppDriver
from tests.gallery_scenes.arm import LOW_DEG

ADAPTERS = (
    Device("socketcan", "can0", None),
    Device("gs_usb", "0", serial="0031002F5246501620303538"),
    Device("slcan", "/dev/ttyACM0", serial="206E3599"),
)


def connect(app_driver: AppDriver) -> QDialog:
    app_driver.window.pages.show("connect")
    dialog = app_driver.dialog(ConnectDialog)
    # the search finds the simulated arm alone; its answer must not come after this
    app_driver.wait(dialog.refresh_button.isEnabled)
    app_driver.controller.devices_found.emit([app_driver.device, *ADAPTERS])
    return dialog


def connect_searching(app_driver: AppDriver) -> QDialog:
    dialog = connect(app_driver)
    app_driver.controller.searching_changed.emit(True)
    return dialog


def connect_failed(app_driver: AppDriver) -> QDialog:
    app_driver.broken = can.CanInitializationError("busy", error_code=errno.EBUSY)
    app_driver.controller.connect_device(ADAPTERS[1])
    app_driver.wait(lambda: app_driver.controller.operating_state.link_problem is not None)
    app_driver.plug_in()
    return connect(app_driver)


def settings(app_driver: AppDriver) -> SettingsDialog:
    app_driver.window.pages.show("settings")
    return app_driver.dialog(SettingsDialog)


def simulated_faults(app_driver: AppDriver) -> QDialog:
    app_driver.window.pages.show("simulated")
    dialog = app_driver.dialog(FaultsDialog)
    dialog.switches["sensor-error"].click()
    return dialog


def settings_refused(app_driver: AppDriver) -> QDialog:
    dialog = settings(app_driver)
    field = dialog.findChild(QLineEdit)
    assert field is not None
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "99")
    QTest.keyClick(field, Qt.Key.Key_Return)
    return dialog


def palette(app_driver: AppDriver) -> QDialog:
    app_driver.click("commands_button")
    dialog = app_driver.dialog(CommandPalette)
    app_driver.wait(lambda: dialog._names.known)
    dialog.search.setText("ydkz")
    return dialog


def palette_zero(app_driver: AppDriver) -> QDialog:
    """A synonym: going home comes first, what sets zeros last."""
    dialog = palette(app_driver)
    assert isinstance(dialog, CommandPalette)
    dialog.search.setText("zero")
    return dialog


def shortcut_list(app_driver: AppDriver) -> QDialog:
    actions = app_driver.window.findChild(WindowActions)
    actions.open_shortcuts()
    return app_driver.dialog(ShortcutList)


def trouble(app_driver: AppDriver) -> QDialog:
    dialog = connect(app_driver)
    box = dialog.findChild(AdapterTrouble)
    box._find_faults = lambda: [each for each in judge(TROUBLE) if each.code == "error_passive"]
    box.examine()
    return dialog


def file(app_driver: AppDriver) -> QDialog:
    dialog = settings(app_driver)
    QTest.mouseClick(dialog.browse_button, Qt.MouseButton.LeftButton)
    chooser = app_driver.dialog(FileDialog)
    chooser.setDirectory(str(Path(__file__).resolve().parents[2] / "urdf"))
    return chooser


def confirm_disable(app_driver: AppDriver) -> QDialog:
    app_driver.click("enable_button")
    return app_driver.dialog(ConfirmDialog)


def hold_below(app_driver: AppDriver) -> QDialog:
    """A target below the floor, sent."""
    for joint, angle_deg in enumerate(LOW_DEG, start=1):
        app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")
    app_driver.click("send_button")
    return app_driver.dialog(ConfirmDialog)


def confirm_close(app_driver: AppDriver) -> QDialog:
    app_driver.window.close()
    return app_driver.dialog(ConfirmDialog)


def about_arm(app_driver: AppDriver) -> QDialog:
    dialog = settings(app_driver)
    QTest.mouseClick(dialog.about_arm_button, Qt.MouseButton.LeftButton)
    return app_driver.dialog(AboutArmDialog)


PROGRAM = ProgramFacts("0.1.0", "3.12.3", True, "/usr/bin/python3", "Linux 6.8 x86_64", ("ubuntu",))
SCREEN = ScreenFacts(True, "6.11.3", "xcb", opengl="Mesa Intel(R) UHD Graphics 620, 4.6")
TROUBLE = Facts(
    PROGRAM,
    ScreenFacts(
        True, "6.11.3", None, "could not load the plugin xcb", ("libxcb-cursor.so.0",),
        "llvmpipe (LLVM 17.0.6, 256 bits), 4.5",
    ),
    CanFacts(
        links=(
            LinkFacts("can0", "can", True, "ERROR-PASSIVE", 500_000, restart_ms=100, tx_errors=128,
                      rx_errors=0, serial="0031002F"),
            LinkFacts("can1", "can", False, serial="206E3599"),
        )
    ),
    (
        HeardFacts("socketcan", "can0", 2.0, 800, shifted_feedback=(0x3A1, 0x3A2),
                   other_hosts=(OtherFrames(0x155, 400, 200.0),)),
    ),
)  # fmt: skip


class Done:
    """An examination that has ended."""

    def end(self) -> None:
        """Nothing is left to be ended."""


def examined(facts: Facts):
    """An examination that finds these facts at once."""

    def examine(_arguments, tell):
        tell(judge(facts))
        return Done()

    return examine


def _doctor(app_driver: AppDriver, examine) -> QDialog:
    dialog = DoctorDialog(app_driver.controller, app_driver.window, examine)
    dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.open()
    return dialog


def doctor_trouble(app_driver: AppDriver) -> QDialog:
    return _doctor(app_driver, examined(TROUBLE))


def doctor_in_order(app_driver: AppDriver) -> QDialog:
    link = LinkFacts("can0", "can", True, "ERROR-ACTIVE", 1_000_000, restart_ms=100)
    return _doctor(app_driver, examined(Facts(PROGRAM, SCREEN, CanFacts(links=(link,)))))


def doctor_under_way(app_driver: AppDriver) -> QDialog:
    return _doctor(app_driver, lambda _arguments, _tell: Done())
