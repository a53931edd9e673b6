"""What today's firmware adds: drag assistance, the gripper by angle, mounting, the way from MIT."""

from __future__ import annotations

from PySide6.QtWidgets import QAbstractButton, QDialog

from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.panels.parameters.levels_panel import DragAssistanceDialog
from tests.app_driver import AppDriver
from tests.company import OtherHost
from tests.gallery_scenes.arm import reached_out
from tests.gallery_scenes.scene import settled
from tests.named_version import name_version
from tests.sim.talk import target

TODAY = "S-V1.8-9"


def gripper_angle(app_driver: AppDriver) -> None:
    """The gripper was told an angle and tells one."""
    app_driver.connect()
    name_version(app_driver.controller, TODAY)
    app_driver.click("menu_gripper")
    app_driver.run(0.3)
    app_driver.click("gripper_by_angle")
    app_driver.type_into("gripper_angle_field", "35")
    app_driver.click("gripper_send_button")
    app_driver.run_until(lambda: "gripper_there" in app_driver.codes())


def mounting(app_driver: AppDriver) -> None:
    """An arm on a wall was told so."""
    app_driver.connect()
    name_version(app_driver.controller, TODAY)
    app_driver.click("menu_end_load")
    app_driver.click("mounting_on_the_left_side")
    app_driver.click("mounting_confirm_button")
    app_driver.dialog(ConfirmDialog).accept()
    app_driver.run(0.3)


def mounting_question(app_driver: AppDriver) -> QDialog:
    app_driver.click("mounting_upside_down")
    app_driver.click("mounting_confirm_button")
    return app_driver.dialog(ConfirmDialog)


def drag_assistance(app_driver: AppDriver) -> QDialog:
    app_driver.click("menu_teaching")
    app_driver.click("drag_assistance_button")
    dialog = app_driver.dialog(DragAssistanceDialog)
    settled(app_driver)
    if not dialog.panel.has_unsaved_changes():
        app_driver.click(dialog.findChild(QAbstractButton, "drag_assistance_edit_button"))
        app_driver.click(dialog.findChild(QAbstractButton, "drag_assistance_2_level_8"))
    return dialog


def high_follow(app_driver: AppDriver) -> None:
    """Another program streams joint targets without a plan, and has stopped."""
    reached_out(app_driver)
    name_version(app_driver.controller, TODAY)
    host = OtherHost(app_driver)
    host.say("151#010132AD00000000", *target(20.0, 60.0, -60.0, 0.0, 30.0, 0.0))
    app_driver.run(2.0)
    host.close()


def take_back(app_driver: AppDriver) -> QDialog:
    app_driver.click("recovery_button")
    return app_driver.dialog(ConfirmDialog)
