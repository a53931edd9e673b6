"""The panels that move and switch something: lamps, motors, tool, linkage, gripper, load."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog

from armui.ui.dialogs.confirm import ConfirmDialog
from tests.desk import Desk
from tests.gallery_scenes import arm


def lights(desk: Desk) -> None:
    """The lamp of one joint set."""
    desk.connect()
    desk.click("menu_light")
    desk.click("light_joint_3")
    for channel, value in (("red", 255), ("green", 140), ("blue", 26)):
        desk.type_into(f"{channel}_field", str(value))
    desk.click("light_confirm_button")
    desk.step()


def lights_refused(desk: Desk) -> None:
    """A brightness out of range."""
    lights(desk)
    desk.click("all_lamps")
    desk.type_into("lamp_field", "300")


def motors(desk: Desk) -> None:
    """One motor enabled."""
    desk.connect()
    desk.click("menu_motor")
    desk.click("enable_motor_2")
    desk.run(0.4)


def tool(desk: Desk) -> None:
    """A tool is given, the start of an arc captured."""
    arm.reached_out(desk)
    desk.click("menu_cartesian")
    desk.type_into("tool_field_Z", "80")
    desk.click("capture_start")


def tool_refused(desk: Desk) -> None:
    """Out of reach, with the keys switched on."""
    tool(desk)
    desk.click("tool_keys_button")
    desk.type_into("pose_field_X", "900")
    desk.click("move_l_button")


def joint_keys(desk: Desk) -> None:
    """The jog keys of the joints, with the largest step."""
    arm.reached_out(desk)
    desk.click("load_button")
    desk.click("jog_keys_button")
    step_box = desk.find("jog_step")
    step_box.setCurrentIndex(step_box.count() - 1)


def linkage(desk: Desk) -> None:
    """What links two arms."""
    desk.connect()
    desk.click("menu_linkage")


def end_load(desk: Desk) -> None:
    """Half load, and the arm tells of its flange."""
    desk.connect()
    desk.click("menu_end_load")
    desk.click("load_half")
    desk.click("end_feedback_button")
    desk.run_until(lambda: "end_feedback_on" in desk.codes())


def gripper(desk: Desk) -> None:
    """Something gripped."""
    desk.connect()
    desk.click("menu_gripper")
    desk.run(0.3)
    desk.firmware.gripper.object_width = 24.0
    desk.controller.gripper.move(60.0, 1.0)
    desk.run_until(lambda: "gripper_there" in desk.codes())
    desk.type_into("gripper_opening_field", "10")
    desk.click("gripper_send_button")
    desk.run_until(lambda: "gripper_grips" in desk.codes())


def linkage_question(desk: Desk) -> QDialog:
    desk.click("linkage_input")
    desk.click("linkage_confirm_button")
    return desk.dialog(ConfirmDialog)


def hold_zero(desk: Desk) -> QDialog:
    desk.click("zero_motor_2")
    dialog = desk.dialog(ConfirmDialog)
    desk.press(dialog.action_button)
    progress = dialog.action_button.progress
    progress.setCurrentTime(progress.duration() * 2 // 3)
    progress.pause()
    return dialog


def hold_disable(desk: Desk) -> QDialog:
    desk.click("disable_motor_7")
    return desk.dialog(ConfirmDialog)
