"""Edits of many rows are worked out in the background, one at a time, and only for those rows."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLineEdit

from armui.protocol.codes import MoveMode
from tests.operator.editor.actions import CTRL, OUT, Editor, to

MANY = 600


@pytest.fixture
def editor(slow_driver):
    """Before 600 rows; what another process is to work out waits until it is told to."""
    slow_driver.connect()
    return Editor(slow_driver, *(to((0.05 * row, *OUT[1:])) for row in range(MANY)))


def select_all(editor):
    editor.table.setFocus()
    editor.table.selectAll()


def work(editor):
    editor.app_driver.workers.work()
    editor.app_driver.step()


def test_many_rows_are_converted_when_the_work_is_done(editor):
    select_all(editor)
    editor.act("convert")
    assert editor.points[0].is_joint
    assert editor.message() == "Working on 600 rows…"
    work(editor)
    assert {point.move for point in editor.points} == {MoveMode.MOVE_P}
    assert editor.message() == ""
    editor.window._actions["undo"].trigger()
    assert editor.points[0].is_joint


def test_meanwhile_no_other_edit_begins(editor):
    select_all(editor)
    editor.act("convert")
    editor.keys(Qt.Key.Key_Delete)
    assert len(editor.points) == MANY
    assert editor.message().startswith("The program is still working on many rows.")
    work(editor)
    assert not editor.points[0].is_joint


def test_points_that_were_changed_meanwhile_stay_as_they_are(editor):
    select_all(editor)
    editor.act("convert")
    editor.window.document.edit(editor.points[:10], "Shortened")
    work(editor)
    assert len(editor.points) == 10
    assert all(point.is_joint for point in editor.points)
    assert editor.message().startswith("The points were changed while the program worked on them.")


def test_work_that_fails_is_said_and_changes_nothing(editor):
    select_all(editor)
    editor.act("convert")
    editor.app_driver.workers.break_down("no memory")
    editor.app_driver.step()
    assert "no memory" in editor.message()
    assert editor.points[0].is_joint
    editor.keys(Qt.Key.Key_Delete)
    assert len(editor.points) == 0


def test_copied_cut_and_pasted(editor):
    before = editor.points
    select_all(editor)
    editor.act("copy")
    work(editor)
    assert QGuiApplication.clipboard().text().count("\n") == MANY - 1
    editor.act("cut")
    work(editor)
    assert len(editor.points) == 0
    editor.act("paste")
    work(editor)
    assert [point.target for point in editor.points] == [point.target for point in before]


def test_replaced_everywhere(editor):
    select_all(editor)
    editor.keys(Qt.Key.Key_F, CTRL)
    editor.child("find_field").setCurrentText("J2")
    editor.child("find_text", QLineEdit).setText("40")
    editor.child("replace_text", QLineEdit).setText("41")
    editor.click("replace_all")
    assert editor.points[0].target[1] == 40.0
    work(editor)
    assert {point.target[1] for point in editor.points} == {41.0}
    assert "600 replaced" in editor.child("find_result").text()


def test_a_page_that_was_left_takes_nothing(editor):
    select_all(editor)
    editor.act("convert")
    editor.window.leave()
    work(editor)
    assert editor.points[0].is_joint


def test_few_rows_are_converted_at_once(editor):
    editor.choose(3)
    editor.act("convert")
    assert not editor.points[3].is_joint
