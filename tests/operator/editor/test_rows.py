"""Rows: inserted, moved, copied, dragged, converted; ten thousand of them without a stall."""

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QDropEvent, QGuiApplication
from PySide6.QtWidgets import QApplication, QMenu

from armui.trajectory import files
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import Trajectory
from tests.operator.editor.actions import ALT, BACK, CTRL, OUT, SHIFT, UP, Editor, notes, to
from tests.operator.plots.actions import ask_for_menu, trigger

pytestmark = pytest.mark.styled


def test_rows_are_inserted_duplicated_moved_and_deleted(editor):
    editor.choose(1)
    editor.keys(Qt.Key.Key_Return, CTRL)
    assert [point.target for point in editor.points] == [OUT, BACK, BACK, UP]
    assert notes(editor) == ["out", "back", "", "up"]
    editor.act("insert_before")
    assert len(editor.points) == 5
    assert editor.child("editor_undo").toolTip() == "Undo “Insert” (Ctrl+Z)"
    editor.click("editor_undo")
    assert editor.child("editor_redo").toolTip() == "Redo “Insert” (Ctrl+Y)"
    editor.keys(Qt.Key.Key_Up, ALT)
    assert notes(editor) == ["out", "", "back", "up"]
    editor.keys(Qt.Key.Key_Delete)
    assert notes(editor) == ["out", "back", "up"]
    editor.keys(Qt.Key.Key_D, CTRL)
    assert notes(editor) == ["out", "back", "back", "up"]
    for _ in range(4):
        editor.click("editor_undo")
    assert notes(editor) == ["out", "back", "up"]
    assert not editor.child("editor_undo").isEnabled()
    assert editor.child("editor_undo").toolTip() == "There is nothing to undo."


def test_what_needs_a_row_says_why_it_is_off_in_an_empty_table(app_driver):
    editor = Editor(app_driver)
    for name in ("duplicate", "delete", "move_up", "move_down"):
        button = editor.child(f"editor_{name}")
        assert not button.isEnabled(), name
        assert "has no points" in button.toolTip(), name
    editor.click("editor_insert_after")
    assert editor.child("editor_delete").isEnabled()


def test_the_right_button_on_a_rows_number_acts_on_that_row(editor):
    editor.choose(0)
    numbers = editor.table.verticalHeader()
    at = QPoint(4, editor.cell(1, PointColumn.SPEED).y())
    ask_for_menu(numbers.viewport(), at)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    trigger(menu, "Delete")
    assert notes(editor) == ["out", "up"]


def test_several_rows_are_cut_and_pasted_elsewhere(editor):
    editor.choose(0)
    editor.choose(1, SHIFT)
    editor.keys(Qt.Key.Key_X, CTRL)
    assert notes(editor) == ["up"]
    editor.keys(Qt.Key.Key_V, CTRL)
    assert notes(editor) == ["up", "out", "back"]


def test_rows_of_a_spreadsheet_are_pasted(editor):
    QGuiApplication.clipboard().setText("J1\tJ2\tJ3\tJ4\tJ5\tJ6\n1\t2\t-3\t4\t5\t6\n")
    editor.choose(2)
    editor.act("paste")
    assert editor.points[3].target == (1.0, 2.0, -3.0, 4.0, 5.0, 6.0)


def test_nonsense_is_not_pasted_and_says_where_it_is(editor):
    QGuiApplication.clipboard().setText("1\t2\t-3\t4\t5\t6\n1\t2\tx\t4\t5\t6")
    editor.act("paste")
    assert len(editor.points) == 3
    assert "Line 2, column 3" in editor.message()


def test_angles_beyond_the_limits_are_pasted_only_as_a_table_has_them(editor):
    clipboard = QGuiApplication.clipboard()
    row = "170\t2\t-3\t4\t5\t6"
    file = files.to_bytes(Trajectory("File", points=(to((170.0, *OUT[1:])),)), ".csv").decode()
    for text, line in ((f"1\t2\t-3\t4\t5\t6\n{row}", "Line 2"), (file, "")):
        clipboard.setText(text)
        editor.act("paste")
        assert len(editor.points) == 3
        assert "Joint 1: 170° is beyond its limits" in editor.message()
        assert line in editor.message()
    editor.window.document.edit((*editor.points, to((170.0, *OUT[1:]))), "came with a file")
    editor.choose(3)
    editor.keys(Qt.Key.Key_C, CTRL)
    editor.keys(Qt.Key.Key_V, CTRL)
    assert editor.points[3:] == (editor.points[3],) * 2


def test_a_row_is_dragged_to_the_end(editor):
    model, viewport = editor.table.model(), editor.table.viewport()
    editor.choose(0)
    data = model.mimeData(editor.table.selectedIndexes())
    below = QPointF(editor.cell(2, 1)) + QPointF(0, 60)
    drop = QDropEvent(
        below,
        Qt.DropAction.MoveAction,
        data,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
        QEvent.Type.Drop,
    )
    model.dropMimeData(drop.mimeData(), drop.dropAction(), -1, -1, editor.table.rootIndex())
    assert notes(editor) == ["back", "up", "out"]
    assert editor.table.rows() == [2]
    assert viewport.rect().contains(editor.cell(2, 1))
    editor.click("editor_undo")
    assert notes(editor) == ["out", "back", "up"]


def test_joint_angles_become_a_pose_and_back(editor):
    editor.choose(0)
    editor.choose(2, CTRL)
    editor.keys(Qt.Key.Key_K, CTRL | Qt.KeyboardModifier.ShiftModifier)
    assert [point.move.name for point in editor.points] == ["MOVE_P", "MOVE_J", "MOVE_P"]
    editor.choose(0)
    editor.keys(Qt.Key.Key_K, CTRL | Qt.KeyboardModifier.ShiftModifier)
    assert editor.points[0].target == pytest.approx(OUT, abs=1e-6)


def test_ten_thousand_points_are_edited_without_a_stall(app_driver):
    editor = Editor(app_driver, *(to(OUT, note=str(row)) for row in range(10_000)))
    editor.table.select_row(5000)
    editor.choose(5000)
    editor.keys(Qt.Key.Key_Delete)
    editor.keys(Qt.Key.Key_D, CTRL)
    assert len(editor.points) == 10_000
    assert editor.points[5000].note == "5001"
