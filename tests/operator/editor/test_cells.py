"""Cells: what is entered is checked where it is entered, and can be taken back."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QLineEdit, QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import GripperOpening, LightAction
from armui.ui import words
from tests.operator.editor.actions import BACK, OUT, UP, to

pytestmark = pytest.mark.styled


def test_an_angle_is_typed_undone_and_done_again(editor):
    editor.type_into(1, PointColumn.VALUE_2, "45,5")
    assert editor.text(1, PointColumn.VALUE_2) == "45.500"
    assert editor.window.title == "Test *"
    editor.click("editor_undo")
    assert editor.points[1].target == BACK
    assert editor.window.title == "Test"
    editor.click("editor_redo")
    assert editor.points[1].target[1] == 45.5


def test_what_cannot_be_is_said_at_the_cell_and_stays_open(editor):
    field = editor.type_into(0, PointColumn.SPEED, "250")
    problem = editor.table.findChild(QWidget, "cell_problem")
    assert problem.isVisible()
    assert field.isVisible()
    assert problem.text()
    below = editor.table.visualRect(editor.table.model().index(0, PointColumn.SPEED)).bottom()
    assert 0 <= problem.y() - below <= 6
    field.selectAll()
    QTest.keyClicks(field, "25")
    editor.enter(field)
    assert not problem.isVisible()
    assert editor.points[0].speed_percent == 25


def test_an_angle_is_held_against_the_limits_of_its_joint(editor):
    """What the check would refuse is not taken; what a file has stays as it came."""
    model = editor.window.model
    cell = model.index(0, PointColumn.VALUE_1)
    beyond = words.refusal(model.why_not(cell, "999"))
    assert beyond.startswith("Joint 1: 999° is beyond its limits of -150° to 150°.")
    assert model.why_not(cell, "151") is not None
    assert model.why_not(cell, "-150°") is None
    assert cell.data(Qt.ItemDataRole.ToolTipRole) == "J1: -150 – 150 °"
    document = editor.window.document
    document.edit((to((200.0, *OUT[1:])), *document.points[1:]), "")
    assert model.why_not(cell, "200") is None
    assert model.why_not(model.index(0, PointColumn.VALUE_2), "41") is None


def test_escape_leaves_a_cell_as_it_was(editor):
    field = editor.edit(0, PointColumn.DWELL)
    QTest.keyClicks(field, "3")
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert editor.points[0].dwell_s == 0.0
    assert editor.window.isVisible()


def test_the_gripper_has_an_editor_of_its_own(editor):
    box = editor.edit(0, PointColumn.GRIPPER)
    kind = editor.table.findChild(QComboBox, "gripper_kind")
    assert box is not None
    kind.setCurrentIndex(1)
    place = editor.table.findChild(QLineEdit, "gripper_place")
    place.selectAll()
    QTest.keyClicks(place, "35")
    editor.enter(place.parentWidget())
    assert editor.points[0].gripper == GripperOpening(35.0, 1.0)
    assert editor.text(0, PointColumn.GRIPPER) == "35 mm, 1 N·m"


def test_a_figure_typed_into_a_cell_of_the_gripper_is_an_opening(editor):
    editor.edit(0, PointColumn.GRIPPER)
    for digit in "35":
        QTest.keyClicks(focused(), digit)
    QTest.keyClick(focused(), Qt.Key.Key_Tab)
    QTest.keyClick(focused(), Qt.Key.Key_Tab)
    QTest.keyClick(focused(), Qt.Key.Key_Tab)
    assert editor.points[0].gripper == GripperOpening(35.0, 1.0)


def focused():
    """The widget that has the focus."""
    widget = QApplication.focusWidget()
    assert widget is not None
    return widget


def test_tab_leads_through_the_fields_of_a_cell_before_it_leaves(editor):
    editor.edit(0, PointColumn.GRIPPER)
    QTest.keyClick(focused(), Qt.Key.Key_Down)
    for figure in ("35", "2"):
        QTest.keyClick(focused(), Qt.Key.Key_Tab)
        focused().selectAll()
        QTest.keyClicks(focused(), figure)
    QTest.keyClick(focused(), Qt.Key.Key_Backtab)
    assert focused().objectName() == "gripper_place"
    for _ in range(3):
        QTest.keyClick(focused(), Qt.Key.Key_Tab)
    assert editor.points[0].gripper == GripperOpening(35.0, 2.0)


def test_so_have_the_lamps(editor):
    editor.edit(1, PointColumn.LIGHT)
    joint = editor.table.findChild(QComboBox, "light_joint")
    joint.setCurrentIndex(3)
    color = editor.table.findChild(QLineEdit, "light_color")
    color.selectAll()
    QTest.keyClicks(color, "255, 128, 0")
    editor.enter(color.parentWidget())
    assert editor.points[1].light == LightAction(3, 255, 128, 0)
    assert editor.text(1, PointColumn.LIGHT) == "J3 all"
    index = editor.table.model().index(1, PointColumn.LIGHT)
    assert index.data(Qt.ItemDataRole.DecorationRole) == QColor(255, 128, 0)


def test_another_kind_of_motion_keeps_the_place(editor):
    box = editor.edit(2, PointColumn.MOVE)
    assert isinstance(box, QComboBox)
    box.setCurrentText("MOVE L")
    box.activated.emit(box.currentIndex())
    model = editor.app_driver.controller.cartesian.kinematics()
    assert editor.points[2].move is MoveMode.MOVE_L
    assert editor.points[2].target == pytest.approx(tuple(model.forward(UP)))
    assert editor.text(2, PointColumn.VALUE_1) == f"{model.forward(UP).x_mm:.3f}"


def test_only_an_arc_has_a_middle(editor):
    index = editor.table.model().index(0, PointColumn.MIDDLE)
    assert not index.flags() & Qt.ItemFlag.ItemIsEditable


def test_what_is_typed_stays_while_a_run_comes_to_the_row(editor):
    field = editor.edit(1, PointColumn.NOTE)
    field.selectAll()
    QTest.keyClicks(field, "tray")
    editor.table.points.show_current(1)
    editor.table.points.show_faults({1: True})
    assert field.text() == "tray"
    editor.enter(field)
    assert editor.points[1].note == "tray"
