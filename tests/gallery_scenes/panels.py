"""The panels that move and switch something: lamps, motors, tool, linkage, gripper, load."""

from __future__ import annotations

from PySide6.QtWidgets import QDialog, QWidget

from armui.cell.cell import Cell
from armui.cell.held_objects import HeldObject
from armui.cell.work_area import Area, AreaBox, AreaPlane
from armui.sim.faults.schedule import fault
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.dialogs.inspection import InspectionDialog
from armui.ui.dialogs.reference_check import ReferenceDialog
from armui.ui.panels.light_panel import ColorDialog
from armui.ui.widgets.hold_button import HoldButton
from armui.viewport.handles import HandleKind
from tests.accepted import accepted
from tests.app_driver import AppDriver
from tests.gallery_scenes import arm, trajectories
from tests.operator import frame_actions
from tests.operator import tip_actions as actions


def lights(app_driver: AppDriver) -> None:
    """The lamp of one joint set."""
    app_driver.connect()
    app_driver.click("menu_light")
    app_driver.click("light_joint_3")
    for channel, value in (("red", 255), ("green", 140), ("blue", 26)):
        app_driver.type_into(f"{channel}_field", str(value))
    app_driver.click("light_confirm_button")
    app_driver.step()


def lights_refused(app_driver: AppDriver) -> None:
    """A brightness out of range."""
    lights(app_driver)
    app_driver.click("all_lamps")
    app_driver.type_into("lamp_field", "300")


def pick_color(app_driver: AppDriver) -> QDialog:
    """The colour of the lamps in the picker."""
    app_driver.click("pick_color_button")
    return app_driver.dialog(ColorDialog)


def motors(app_driver: AppDriver) -> None:
    """One motor enabled."""
    app_driver.connect()
    app_driver.click("menu_motor")
    app_driver.click("enable_motor_2")
    app_driver.run(0.4)


def tool(app_driver: AppDriver) -> None:
    """A tool is given, the start of an arc captured."""
    arm.reached_out(app_driver)
    app_driver.click("menu_cartesian")
    app_driver.type_into("tool_field_Z", "80")
    app_driver.click("capture_start")


def tool_refused(app_driver: AppDriver) -> None:
    """Out of reach, with the keys switched on."""
    tool(app_driver)
    app_driver.click("tool_keys_button")
    app_driver.type_into("pose_field_X", "900")
    app_driver.click("move_l_button")


def joint_keys(app_driver: AppDriver) -> None:
    """The jog keys of the joints, with the largest step."""
    arm.reached_out(app_driver)
    app_driver.click("load_button")
    app_driver.click("jog_keys_button")
    step_box = app_driver.find("jog_step")
    step_box.setCurrentIndex(step_box.count() - 1)


def linkage(app_driver: AppDriver) -> None:
    """What links two arms."""
    app_driver.connect()
    app_driver.click("menu_linkage")


def end_load(app_driver: AppDriver) -> None:
    """Half load, and the arm tells of its flange."""
    app_driver.connect()
    app_driver.click("menu_end_load")
    app_driver.click("load_half")
    app_driver.click("end_feedback_button")
    app_driver.run_until(lambda: "end_feedback_on" in app_driver.codes())


def gripper(app_driver: AppDriver) -> None:
    """Something gripped."""
    app_driver.connect()
    app_driver.click("menu_gripper")
    app_driver.run(0.3)
    app_driver.firmware.gripper.object_width = 24.0
    app_driver.controller.gripper.move(60.0, 1.0)
    app_driver.run_until(lambda: "gripper_there" in app_driver.codes())
    app_driver.type_into("gripper_opening_field", "10")
    app_driver.click("gripper_send_button")
    app_driver.run_until(lambda: "gripper_grips" in app_driver.codes())


def linkage_question(app_driver: AppDriver) -> QDialog:
    app_driver.click("linkage_input")
    app_driver.click("linkage_confirm_button")
    return app_driver.dialog(ConfirmDialog)


def hold_zero(app_driver: AppDriver) -> QDialog:
    app_driver.click("zero_motor_2")
    dialog = app_driver.dialog(ConfirmDialog)
    app_driver.press(dialog.action_button)
    assert isinstance(dialog.action_button, HoldButton)
    progress = dialog.action_button.progress
    progress.setCurrentTime(progress.duration() * 2 // 3)
    progress.pause()
    return dialog


def hold_disable(app_driver: AppDriver) -> QDialog:
    app_driver.click("disable_motor_7")
    return app_driver.dialog(ConfirmDialog)


def cell(app_driver: AppDriver) -> None:
    """A cell with a tool, whose next figures are typed."""
    app_driver.ready()
    app_driver.click("menu_cell")
    app_driver.type_into("cell_name", "bench 2")
    for name, text in (("name", "pen"), ("Z", "120"), ("radius", "15")):
        app_driver.type_into(f"cell_tool_{name}", text)
    app_driver.click("cell_tool_add")
    box = app_driver.find("cell_tool")
    box.setCurrentIndex(1)
    box.activated.emit(1)
    app_driver.type_into("cell_tool_X", "12.5")
    app_driver.step()


def cell_frame(app_driver: AppDriver) -> None:
    """A frame by three points is found and looked at; another one is there already."""
    frame_actions.made(app_driver)
    app_driver.click("frame_points_restart")
    frame_actions.take(app_driver, 1, 2, 0)
    app_driver.step()


def cell_frame_typed(app_driver: AppDriver) -> None:
    """A frame is in force; the figures of a further one are typed."""
    frame_actions.made(app_driver)
    app_driver.click("cell_frame_typed")
    app_driver.type_into("cell_frame_name", "jig 2")
    app_driver.type_into("cell_frame_Z", "20")
    app_driver.step()


def in_frame(app_driver: AppDriver) -> None:
    """Targets are typed and jogs go in a user frame."""
    frame_actions.made(app_driver)
    app_driver.click("menu_cartesian")
    app_driver.click("frame_user")
    app_driver.type_into("pose_field_Z", "30")
    app_driver.click("capture_start")
    app_driver.run(0.3)


def editor_in_frame(app_driver: AppDriver) -> None:
    """Points are made by jogs in a user frame."""
    frame_actions.made(app_driver)
    app_driver.click(trajectories.editor(app_driver).findChild(QWidget, "editor_jog"))
    app_driver.click("box_user")
    app_driver.step()


def cell_held(app_driver: AppDriver) -> None:
    """A box in the hand, which may touch the table; a work area around."""
    app_driver.ready()
    table = AreaPlane("table", (0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    crate = AreaBox("crate", (350.0, -250.0, 100.0, 0.0, 0.0, 20.0), (200.0, 150.0, 200.0))
    pose = (0.0, 0.0, 150.0, 0.0, 0.0, 0.0)
    part = HeldObject("part", pose, (60.0, 120.0, 50.0), mass_kg=0.6, may_touch=("table",))
    rod = HeldObject("rod", pose, (20.0, 20.0, 160.0), is_rod=True, mass_kg=0.2)
    area = Area((table,), (crate,))
    cell = Cell("bench 2", area=area, held_objects=(part, rod), held="part")
    accepted(app_driver.controller.cell.take(cell))
    app_driver.click("menu_cell")
    app_driver.click("cell_tab_held")
    box = app_driver.find("cell_held_object")
    box.setCurrentIndex(1)
    box.activated.emit(1)
    app_driver.step()


def cell_area(app_driver: AppDriver) -> None:
    """A box of the work area is dragged: handles at it, and where it would be."""
    cell_held(app_driver)
    app_driver.click("cell_tab_area")
    box = app_driver.find("cell_area_zone")
    box.setCurrentIndex(2)
    box.activated.emit(2)
    app_driver.find("view_bar").choose_handles(HandleKind.TOOL_FRAME)
    app_driver.type_into("cell_area_X", "300")
    app_driver.run(0.2)


def cell_base(app_driver: AppDriver) -> None:
    """The base hangs upside down over a table; the arm was not told so."""
    cell_held(app_driver)
    app_driver.click("cell_tab_base")
    app_driver.type_into("cell_base_Z", "900")
    app_driver.type_into("cell_base_RX", "180")
    app_driver.click("cell_base_apply")
    app_driver.run(0.2)


def cell_tip(app_driver: AppDriver) -> None:
    """The tip of a tool is found by five poses, one of them left out; the jog buttons above."""
    actions.search(app_driver)
    actions.take(app_driver, 0, 1, 2, 3, 4)
    app_driver.click("tip_use_5")
    app_driver.click("cell_jog_button")
    app_driver.step()


def cell_gripper(app_driver: AppDriver) -> None:
    """The gripper's table is measured, its figures typed and not applied yet."""
    app_driver.ready()
    app_driver.click("menu_cell")
    app_driver.type_into("cell_name", "bench 2")
    app_driver.click("cell_tab_gripper")
    app_driver.type_into("cell_gripper_measured_1", "5")
    app_driver.step()


def reference_lost(app_driver: AppDriver) -> None:
    """Joint 5 has lost its reference."""
    app_driver.ready()
    app_driver.run(1.5)
    app_driver.firmware.lost_reference.begin(4)
    app_driver.run(2.0)


def reference_begin(app_driver: AppDriver) -> ReferenceDialog:
    """The reference check, before its first step."""
    app_driver.click("recovery_button")
    return app_driver.dialog(ReferenceDialog)


def reference_mark(app_driver: AppDriver) -> QDialog:
    """The joint in doubt is to be led to its mark by hand."""
    dialog = reference_begin(app_driver)
    if dialog.begin_button.isVisible():
        app_driver.click(dialog.begin_button)
        app_driver.click(dialog.look_button)
    return dialog


def inspection_stiff(app_driver: AppDriver) -> None:
    """An arm with a stiff joint and a hot one, where there is room to swing, but for a wall."""
    app_driver.lie((0.0, 70.0, -60.0, 94.0, 20.0, 0.0))
    app_driver.ready()
    app_driver.run(1.0)
    for name, joint in (("stiff-joint", 3), ("hot-joint", 5)):
        app_driver.node.faults.start(fault(name, joint))


def inspection_room(app_driver: AppDriver) -> InspectionDialog:
    """The joint inspection, before it begins."""
    app_driver.window.pages.show("inspection")
    app_driver.run(0.5)
    return app_driver.dialog(InspectionDialog)


def inspection_report(app_driver: AppDriver) -> InspectionDialog:
    """What it has found."""
    dialog = inspection_room(app_driver)
    inspection = app_driver.controller.inspection
    if inspection.report is None:
        dialog.amplitude.setValue(10)
        app_driver.run(0.5)
        accepted(inspection.start(10.0))
        app_driver.run_until(lambda: inspection.report is not None, seconds=200.0)
        app_driver.run(0.1)
    return dialog
