"""An operator asks what is wrong, and which arm this is, through the settings."""

from __future__ import annotations

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel

from armui.ui.dialogs.about_arm import AboutArmDialog
from armui.ui.dialogs.doctor import DoctorDialog
from armui.ui.dialogs.settings import SettingsDialog
from armui.ui.widgets.message_line import MessageLine

LEFT = Qt.MouseButton.LeftButton


def settings(app_driver) -> SettingsDialog:
    app_driver.window.pages.show("settings")
    return app_driver.dialog(SettingsDialog)


def test_about_the_simulated_arm(app_driver):
    app_driver.connect()
    app_driver.run_until(lambda: not app_driver.controller.state.joints_without_limits())
    QTest.mouseClick(settings(app_driver).about_arm_button, LEFT)
    dialog = app_driver.dialog(AboutArmDialog)
    read = {each.objectName(): each.text() for each in dialog.findChildren(QLabel)}
    assert read["about_firmware"] == "S-V1.8-9"
    assert read["about_device"] == "Simulated arm, gen. 2"
    assert read["about_joint_1"].startswith("-150.0° to 150.0°, at most 171.9°/s")


@pytest.mark.timeout(180)
def test_the_diagnosis_looks_at_this_computer_in_a_process_of_its_own(app_driver, qtbot):
    """The real one: its findings about Python and Qt come back, the connected arm's from here."""
    app_driver.connect()
    QTest.mouseClick(settings(app_driver).diagnosis_button, LEFT)
    dialog = app_driver.dialog(DoctorDialog)
    qtbot.waitUntil(dialog.copy_button.isEnabled, timeout=120_000)
    report = dialog.report()
    assert "Python 3." in report
    assert "an arm of generation 2" in report
    assert "Firmware S-V1.8-9 (" in report
    assert dialog.findChild(MessageLine).text()
    # nothing was sent but what the program itself asks an arm that comes online
    assert "An arm answers." in report
    dialog.close()


def test_closing_the_diagnosis_ends_its_process(app_driver):
    QTest.mouseClick(settings(app_driver).diagnosis_button, LEFT)
    dialog = app_driver.dialog(DoctorDialog)
    examination = dialog._under_way
    assert examination is not None
    dialog.close()
    assert examination.wait(5.0)
