"""Edits of many rows are worked out in the background, one at a time, and only for those rows."""

from functools import partial

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLineEdit

from armui.cell.cell import Cell
from armui.cell.user_frames import UserFrame
from armui.protocol.codes import MoveMode
from tests.accepted import accepted
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


# The rows and the place of an edit are those of its press ---------------------------------------

FIRST, COUNT = 20, 550
"""The rows that are selected when an edit is asked for: so many are worked out elsewhere."""


def replace_all(editor):
    editor.keys(Qt.Key.Key_F, CTRL)
    editor.child("find_field").setCurrentText("J2")
    editor.child("find_text", QLineEdit).setText("40")
    editor.child("replace_text", QLineEdit).setText("41")
    editor.click("replace_all")


def paste(editor):
    text = "\n".join(["1\t2\t-3\t4\t5\t6"] * 300)
    QGuiApplication.clipboard().setText(text)
    editor.act("paste")


def to_poses(editor):
    editor.act("convert")
    work(editor)
    editor.table.select_rows(FIRST, COUNT)


def into_a_frame(editor):
    frame = UserFrame("stand", (100.0, 0.0, 0.0, 0.0, 0.0, 90.0))
    accepted(editor.app_driver.controller.cell.take(Cell("bench", frames=(frame,))))
    to_poses(editor)
    editor.window._do(partial(editor.window._edits.set_frame, "stand"))


LONG = {
    "convert": lambda editor: editor.act("convert"),
    "cut": lambda editor: editor.act("cut"),
    "copy": lambda editor: editor.act("copy"),
    "paste": paste,
    "frame": into_a_frame,
    "replace all": replace_all,
}

MEANWHILE = {
    "another row is clicked": lambda editor: editor.choose(3),
    "nothing is selected any more": lambda editor: editor.table.clearSelection(),
    "more rows are selected": lambda editor: editor.table.selectAll(),
    "it is scrolled to the end": lambda editor: editor.table.select_row(MANY - 1),
}


@pytest.mark.parametrize("name", LONG)
def test_an_edit_is_of_the_rows_that_were_selected_when_it_was_asked_for(editor, name):
    outcomes = []
    for meanwhile in (lambda _editor: None, *MEANWHILE.values()):
        QGuiApplication.clipboard().clear()
        begun = editor.window.document.stack.index()
        editor.table.setFocus()
        editor.table.select_rows(FIRST, COUNT)
        LONG[name](editor)
        assert editor.window._long_edits.busy
        meanwhile(editor)
        work(editor)
        assert not editor.window._long_edits.busy
        outcomes.append((editor.points, QGuiApplication.clipboard().text()))
        editor.window.document.stack.setIndex(begun)
        if editor.app_driver.controller.cell.cell is not None:
            accepted(editor.app_driver.controller.cell.delete())
    assert [each == outcomes[0] for each in outcomes] == [True] * len(outcomes)
    changed = outcomes[0][0] != editor.points
    assert changed != (name == "copy")


def test_a_cut_takes_its_rows_and_no_other(editor):
    before = editor.points
    editor.table.select_rows(FIRST, COUNT)
    editor.act("cut")
    editor.choose(3)
    work(editor)
    assert editor.points == (*before[:FIRST], *before[FIRST + COUNT :])
    assert QGuiApplication.clipboard().text().count("\n") == COUNT - 1
    assert editor.table.rows() == [FIRST]


def test_what_is_pasted_comes_below_the_rows_it_was_pasted_at(editor):
    before = editor.points
    editor.table.select_rows(FIRST, 5)
    paste(editor)
    editor.choose(3)
    work(editor)
    place = FIRST + 5
    assert editor.points[:place] == before[:place]
    assert editor.points[place + 300 :] == before[place:]
    assert editor.points[place].target == (1.0, 2.0, -3.0, 4.0, 5.0, 6.0)


def test_a_cut_whose_rows_have_changed_meanwhile_takes_none(editor):
    editor.table.select_rows(FIRST, COUNT)
    editor.act("cut")
    editor.window.document.edit(editor.points[1:], "Shortened")
    work(editor)
    assert len(editor.points) == MANY - 1
    assert editor.message().startswith("The points were changed while the program worked on them.")
