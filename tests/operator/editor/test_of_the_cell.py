"""Points that name things of the cell: user frames, which keep their places, and what is held."""

import math
from dataclasses import replace

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QListWidget, QMenu

from armui.cell.cell import Cell, with_part, without_part
from armui.cell.held_objects import HeldObject
from armui.cell.user_frames import UserFrame
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import GripperOpening, Waypoint
from tests.accepted import accepted
from tests.family import PIPER
from tests.operator.editor.actions import BACK, CTRL, OUT, SHIFT, Editor, to
from tests.trajectory.frame_oracle import apart, carried, within

TABLE = UserFrame("Table", (250.0, -80.0, 40.0, 10.0, -20.0, 35.0))
MOVED = UserFrame("Table", (270.0, -70.0, 55.0, 6.0, -16.0, 39.0))
BENCH = with_part(Cell("bench"), TABLE)
PLACE = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
OVER = (300.0, 60.0, 230.0, 0.0, 85.0, 0.0)
ARC = Waypoint(MoveMode.MOVE_C, within(TABLE.pose, OVER), within(TABLE.pose, PLACE), frame="Table")
MODEL = Kinematics(PIPER)


@pytest.fixture
def editor(app_driver):
    """Joint angles, a line of the base and an arc in the frame."""
    app_driver.ready()
    accepted(app_driver.controller.cell.take(BENCH))
    return Editor(app_driver, to(OUT), Waypoint(MoveMode.MOVE_L, PLACE), ARC)


def choose_frame(editor, name):
    """Choose the frame of the selected rows in its menu."""
    editor.keys(Qt.Key.Key_F, CTRL | SHIFT)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    (action,) = [each for each in menu.actions() if each.text() == name]
    checked = [each.text() for each in menu.actions() if each.isChecked()]
    menu.setActiveAction(action)
    QTest.keyClick(menu, Qt.Key.Key_Return)
    return checked


def base_place(editor, row, frame=TABLE):
    """Where a point is in the base, by the oracle."""
    point = editor.points[row]
    return carried(frame.pose, point.target) if point.frame else point.target


def test_the_frame_is_named_in_the_row_and_its_coordinates_shown(editor):
    assert [editor.text(row, PointColumn.MOVE) for row in range(3)] == [
        *("MOVE J", "MOVE L", "MOVE C · Table")
    ]
    x = within(TABLE.pose, OVER)[0]
    assert float(editor.text(2, PointColumn.VALUE_1)) == pytest.approx(x, abs=0.001)
    index = editor.table.model().index(2, PointColumn.MOVE)
    tip = index.data(Qt.ItemDataRole.ToolTipRole)
    assert tip == "Its place counts from the user frame “Table” of the cell."


def test_another_frame_keeps_the_place_and_can_be_undone(editor):
    before = editor.points
    editor.choose(1)
    assert choose_frame(editor, "Table") == ["Base"]
    assert editor.points[1].frame == "Table"
    assert apart(base_place(editor, 1), PLACE) == pytest.approx((0.0, 0.0), abs=1e-5)
    assert editor.points[1].target[0] != pytest.approx(PLACE[0], abs=1.0)
    editor.click("editor_undo")
    assert editor.points == before
    editor.choose(0)
    editor.choose(2, SHIFT)
    choose_frame(editor, "Base")
    assert [point.frame for point in editor.points] == ["", "", ""]
    assert editor.points[0] is before[0]
    assert apart(editor.points[2].target, OVER) == pytest.approx((0.0, 0.0), abs=1e-5)
    assert apart(editor.points[2].middle, PLACE) == pytest.approx((0.0, 0.0), abs=1e-5)


def test_another_motion_keeps_frame_and_place(editor):
    combo = editor.edit(2, PointColumn.MOVE)
    assert combo.text() == "MOVE C"
    combo.setCurrentText("MOVE L")
    combo.activated.emit(combo.currentIndex())
    assert (editor.points[2].move, editor.points[2].frame) == (MoveMode.MOVE_L, "Table")
    assert apart(base_place(editor, 2), OVER) == pytest.approx((0.0, 0.0), abs=1e-5)


def test_joint_angles_have_no_frame_and_a_pose_takes_the_chosen_one(editor):
    editor.choose(0)
    editor.choose(2, CTRL)
    editor.act("convert")
    assert [(each.move, each.frame) for each in editor.points] == [
        (MoveMode.MOVE_P, "Table"),
        (MoveMode.MOVE_L, ""),
        (MoveMode.MOVE_J, ""),
    ]
    assert apart(base_place(editor, 0), MODEL.forward(OUT)) == pytest.approx((0, 0), abs=1e-5)
    assert apart(MODEL.forward(editor.points[2].target), OVER)[0] < 1e-3


def test_the_current_pose_is_inserted_in_the_chosen_frame(editor):
    driver = editor.app_driver
    accepted(driver.controller.motion.send_joints(BACK))
    driver.run_until(lambda: math.dist(driver.firmware.joints_deg, BACK) < 1e-3)
    driver.run(0.2)
    editor.choose(1)
    editor.act("insert_measured")
    assert (editor.points[2].move, editor.points[2].frame) == (MoveMode.MOVE_L, "Table")
    assert apart(base_place(editor, 2), MODEL.forward(BACK))[0] < 0.002
    editor.choose(1)
    editor.act("replace_by_measured")  # it stays in the frame it is in
    assert editor.points[1].frame == ""
    assert apart(editor.points[1].target, MODEL.forward(BACK))[0] < 0.002


def test_the_arm_goes_to_a_point_where_its_frame_is(editor):
    driver = editor.app_driver
    accepted(driver.controller.cell.change(with_part(BENCH, MOVED, instead_of="Table")))
    editor.choose(2)
    editor.act("go_to")
    goal = carried(MOVED.pose, ARC.target)
    driver.run_until(lambda: apart(MODEL.forward(driver.firmware.joints_deg), goal)[0] < 0.01)


def test_rows_copied_and_duplicated_stay_in_their_frame(editor):
    editor.choose(2)
    editor.keys(Qt.Key.Key_D, CTRL)
    editor.choose(2)
    editor.keys(Qt.Key.Key_C, CTRL)
    editor.keys(Qt.Key.Key_V, CTRL)
    assert editor.points[2:] == (ARC, ARC, ARC)


def shown(editor):
    return editor.app_driver.program.view._state.preview


def test_the_picture_shows_the_points_where_the_frame_is(editor):
    editor.choose(2)
    assert shown(editor).path.marks_mm[2] == pytest.approx(OVER[:3], abs=1e-3)
    assert apart(MODEL.forward(shown(editor).ghost_deg), OVER)[0] < 0.01
    control = editor.app_driver.controller.cell
    accepted(control.change(with_part(BENCH, MOVED, instead_of="Table")))
    goal = carried(MOVED.pose, ARC.target)
    assert shown(editor).path.marks_mm[2] == pytest.approx(goal[:3], abs=1e-3)
    assert apart(MODEL.forward(shown(editor).ghost_deg), goal)[0] < 0.01


def test_a_frame_that_moves_takes_the_check_away(editor):
    editor.click("editor_check")
    assert len(shown(editor).path.places_mm)
    accepted(editor.app_driver.controller.cell.change(with_part(BENCH, MOVED, instead_of="Table")))
    assert not len(shown(editor).path.places_mm)


def test_a_frame_that_the_cell_has_not_is_kept_marked_and_said(editor):
    accepted(editor.app_driver.controller.cell.change(without_part(BENCH, UserFrame, "Table")))
    assert editor.text(2, PointColumn.MOVE) == "? MOVE C · Table"
    assert editor.points[2] == ARC
    assert shown(editor).path.rows == (0, 1)
    editor.app_driver.heard()
    editor.click("run_send")
    assert "check has found errors (1)" in editor.message()
    found = editor.child("findings_list", QListWidget)
    assert "user frame “Table”, which the cell does not have" in found.item(0).text()
    for name in ("go_to", "convert"):
        editor.choose(2)
        editor.act(name)
        assert "The cell has no user frame “Table”" in editor.message()
    editor.app_driver.run(0.3)
    sent = {each.arbitration_id for each in editor.app_driver.heard()}
    assert sent.isdisjoint(range(0x151, 0x160))
    assert editor.app_driver.controller.motion.speed_percent == 30, "nothing began"


def test_points_of_a_frame_that_is_gone_are_given_another_with_their_figures(editor):
    shelf = UserFrame("Shelf", (200.0, 50.0, 100.0, 0.0, 0.0, 90.0))
    cell = with_part(without_part(BENCH, UserFrame, "Table"), shelf)
    accepted(editor.app_driver.controller.cell.change(replace(cell, frame="")))
    editor.choose(1)
    editor.choose(2, SHIFT)
    assert choose_frame(editor, "Shelf") == []
    line, arc = editor.points[1:]
    assert (arc.target, arc.middle, arc.frame) == (ARC.target, ARC.middle, "Shelf")
    assert apart(carried(shelf.pose, line.target), PLACE) == pytest.approx((0.0, 0.0), abs=1e-5)
    assert editor.message() == (
        "“Table” is not known: the figures stayed, and count from “Shelf” now. The points are "
        "elsewhere then: check them, or undo."
    )
    assert editor.text(2, PointColumn.MOVE) == "MOVE C · Shelf"
    editor.click("editor_undo")
    assert editor.points[2] == ARC
    editor.choose(1)
    choose_frame(editor, "Shelf")
    assert editor.message() == "The points stay where they are; their figures are in “Shelf” now."


def test_the_run_ends_where_the_frame_is(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.cell.take(BENCH))
    x, y, *rest = MODEL.forward(OUT)
    taught = within(TABLE.pose, (x + 30.0, y - 40.0, *rest))
    editor = Editor(app_driver, to(OUT), Waypoint(MoveMode.MOVE_L, taught, frame="Table"))
    for frame in (TABLE, MOVED):
        accepted(app_driver.controller.cell.change(with_part(BENCH, frame, instead_of="Table")))
        editor.click("run_send")
        accept = editor.child("accept_warnings")
        if accept.isVisible():
            app_driver.click(accept)
        app_driver.run_until(lambda: app_driver.controller.player.running)
        app_driver.run_until(lambda: not app_driver.controller.player.running, seconds=60.0)
        end = MODEL.forward(app_driver.firmware.joints_deg)
        assert apart(end, carried(frame.pose, taught))[0] < 0.01


CUBE = HeldObject("Cube", (0.0, 0.0, 150.0, 0.0, 0.0, 0.0))


def test_what_the_hand_holds_is_chosen_beside_the_gripper(editor):
    control = editor.app_driver.controller.cell
    accepted(control.change(replace(BENCH, held_objects=(CUBE,))))
    field = editor.edit(0, PointColumn.GRIPPER)
    assert [field.holds.itemText(place) for place in range(field.holds.count())] == [
        *("Holds as before", "Holds nothing", "Cube")
    ]
    field.kind.setCurrentIndex(1)
    field.place.setText("20")
    field.holds.setCurrentIndex(2)
    editor.enter(field)
    assert (editor.points[0].gripper, editor.points[0].holds) == (GripperOpening(20.0), "Cube")
    assert editor.text(0, PointColumn.GRIPPER) == "20 mm, 1 N·m, holds Cube"
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    field = editor.edit(0, PointColumn.GRIPPER)
    assert (field.place.text(), field.holds.currentText()) == ("20", "Cube")
    field.kind.setCurrentIndex(0)
    field.holds.setCurrentIndex(1)
    editor.enter(field)
    assert (editor.points[0].gripper, editor.points[0].holds) == (None, "")
    assert editor.text(0, PointColumn.GRIPPER) == "holds nothing"
    editor.click("editor_undo")
    editor.click("editor_undo")
    assert editor.points[0].holds is None


def test_what_the_cell_has_not_stays_chosen_and_is_said_by_the_check(editor):
    editor.window.document.edit((to(OUT, holds="Box"),), "")
    field = editor.edit(0, PointColumn.GRIPPER)
    assert field.text() == "holds=Box"
    editor.enter(field)
    assert editor.points[0].holds == "Box"
    editor.click("editor_check")
    found = editor.child("findings_list", QListWidget)
    assert "holds “Box”, which the cell does not have" in found.item(0).text()
