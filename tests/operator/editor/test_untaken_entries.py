"""What stands in an open cell is checked and run; what cannot be taken is told, not dropped."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLineEdit

from armui.trajectory.points.cells import PointColumn
from tests.operator.editor.actions import OUT, Editor, to


def typed(editor, text, *, enter=False):
    field = editor.edit(0, PointColumn.VALUE_1)
    assert isinstance(field, QLineEdit)
    field.selectAll()
    QTest.keyClicks(field, text)
    if enter:
        editor.enter(field)
    return field


def press(editor, name):
    editor.click(name)
    editor.app_driver.run(0.2)


def test_a_check_takes_what_is_being_typed(app_driver):
    app_driver.ready()
    editor = Editor(app_driver, to(OUT))
    typed(editor, "25")
    press(editor, "editor_check")
    assert editor.points[0].target[0] == 25.0


def test_an_entry_that_cannot_be_taken_is_told_by_check_and_run_and_nothing_is_sent(app_driver):
    app_driver.ready()
    editor = Editor(app_driver, to(OUT))
    before = editor.points[0].target
    for button in ("editor_check", "run_send"):
        for entered in (False, True):
            typed(editor, "999", enter=entered)
            app_driver.heard()
            press(editor, button)
            assert "row 1 was not taken: Joint 1: 999° is beyond its limits" in editor.message()
            assert not app_driver.controller.player.running
            assert app_driver.heard() == []
            assert editor.points[0].target == before
            for field in editor.table.viewport().findChildren(QLineEdit):
                QTest.keyClick(field, Qt.Key.Key_Escape)  # it is open as long as it is not taken
    press(editor, "editor_check")
    press(editor, "editor_check")
    assert "not taken" not in editor.message()


def test_an_entry_that_was_given_up_holds_back_nothing_and_one_that_was_left_does(app_driver):
    app_driver.ready()
    editor = Editor(app_driver, to(OUT), to(OUT))
    problem = editor.child("cell_problem")
    field = typed(editor, "999", enter=True)
    assert problem.isVisible()
    QTest.keyClick(field, Qt.Key.Key_Escape)
    assert not problem.isVisible()
    press(editor, "editor_check")
    assert "not taken" not in editor.message()
    typed(editor, "999")
    place = editor.cell(1, PointColumn.VALUE_1)
    QTest.mouseClick(editor.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    other = editor.edit(1, PointColumn.VALUE_1)
    QTest.keyClick(other, Qt.Key.Key_Escape)
    press(editor, "editor_check")
    assert "row 1 was not taken" in editor.message()
