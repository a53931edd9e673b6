"""What the panels of the settings show, and what the arm heard of it."""

from PySide6.QtWidgets import QApplication, QPushButton

from armui.protocol.frame import Frame
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from tests.faulty_arm import HardOfHearing

SETTINGS_IDS = {0x474, 0x475, 0x477, 0x479, 0x47A}


def frame(arbitration_id, payload):
    return Frame(arbitration_id, bytes.fromhex(payload))


def at(app_driver, panel):
    app_driver.connect()
    app_driver.ear = HardOfHearing(app_driver.firmware)
    app_driver.click(f"menu_{panel}")
    settled(app_driver)
    app_driver.ear.heard.clear()
    return app_driver


def settled(app_driver):
    app_driver.run_until(lambda: not app_driver.controller.settings.busy)


def sent(app_driver):
    """What the arm heard but for questions."""
    return [each for each in app_driver.ear.heard if each.arbitration_id in SETTINGS_IDS]


def generation(app_driver):
    return app_driver.controller.operating_state.generation


def note(app_driver, name):
    return app_driver.read(f"{name}_note")


def lit(app_driver):
    """The buttons of the window that are highlighted: one is what is recommended."""
    app_driver.run(0.1)
    return [
        each.objectName()
        for each in app_driver.window.findChildren(QPushButton)
        if each.isVisible() and each.isEnabled() and each.property("primary")
    ]


def questions():
    return [
        each
        for each in QApplication.topLevelWidgets()
        if isinstance(each, ConfirmDialog) and each.isVisible()
    ]


def notes(app_driver):
    """Every word below a value of 关节设置."""
    names = ("max_angle_deg", "min_angle_deg", "max_speed_deg_s", "max_acceleration_deg_s2")
    return {note(app_driver, f"{name}_{joint}") for name in names for joint in range(1, 7)}
