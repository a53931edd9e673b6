"""What the panels of the settings show, and what the arm heard of it."""

from PySide6.QtWidgets import QApplication

from armui.protocol.frame import Frame
from armui.ui.dialogs.confirm import ConfirmDialog
from tests.faulty_arm import HardOfHearing

SETTINGS_IDS = {0x474, 0x475, 0x477, 0x479, 0x47A}


def frame(arbitration_id, payload):
    return Frame(arbitration_id, bytes.fromhex(payload))


def at(desk, panel):
    desk.connect_by_hand()
    desk.ear = HardOfHearing(desk.firmware)
    desk.click(f"menu_{panel}")
    settled(desk)
    desk.ear.heard.clear()
    return desk


def settled(desk):
    desk.run_until(lambda: not desk.controller.settings.busy)


def sent(desk):
    """What the arm heard but for questions."""
    return [each for each in desk.ear.heard if each.arbitration_id in SETTINGS_IDS]


def generation(desk):
    return desk.controller.situation.generation


def note(desk, name):
    return desk.read(f"{name}_note")


def questions():
    return [
        each
        for each in QApplication.topLevelWidgets()
        if isinstance(each, ConfirmDialog) and each.isVisible()
    ]


def notes(desk):
    """Every word below a value of 关节设置."""
    names = ("max_angle_deg", "min_angle_deg", "max_speed_deg_s", "max_acceleration_deg_s2")
    return {note(desk, f"{name}_{joint}") for name in names for joint in range(1, 7)}
