"""The list: what it tells of each trajectory, and what is done to them."""

from dataclasses import replace
from typing import Any

import pytest
from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QListWidget, QWidget

from armui.cell.cell import Cell
from armui.cell.work_area import Area, AreaBox
from armui.control.run.progress import Run
from armui.protocol.codes import MoveMode
from armui.protocol.generation import PiperModel
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_model import LibraryColumn
from armui.viewport.path_picture import NOTHING
from tests.accepted import accepted
from tests.app_driver import Slow
from tests.operator.library.actions import POINT, LibraryDriver


def test_the_list_tells_of_each(driver):
    name, points, length, modified, check, note = driver.rows()[1]
    assert (name, points, length, check, note) == ("three", "2", "—", "—", "")
    assert modified.startswith("20")


def test_what_needs_a_choice_says_so(driver):
    assert not driver.child("delete").isEnabled()
    assert "Choose a trajectory" in driver.child("delete").toolTip()
    driver.choose("one", "two")
    assert driver.child("delete").isEnabled()
    assert not driver.child("rename").isEnabled()
    assert "Several rows are chosen" in driver.app_driver.find("run_send").toolTip()


def test_a_new_one_is_created_and_opened(driver):
    driver.create()
    editor = driver.app_driver.page(EditorPage)
    assert editor.title == "Trajectory"
    QTest.keyClick(editor.table, Qt.Key.Key_Return, Qt.KeyboardModifier.ControlModifier)
    driver.app_driver.click(editor.findChild(QWidget, "editor_insert_measured"))
    assert "No arm is connected" in editor.findChild(QWidget, "editor_message").text()
    assert "Trajectory" in driver.names()


def test_a_double_click_opens_the_second_level(driver):
    index = driver.table.model().index(2, 1)
    place = driver.table.visualRect(index).center()
    QTest.mouseClick(driver.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    QTest.mouseDClick(driver.table.viewport(), Qt.MouseButton.LeftButton, pos=place)
    editor = driver.app_driver.page(EditorPage)
    assert editor.document.name == "two"
    assert len(editor.document.points) == 3


def test_several_are_deleted_and_brought_back(driver):
    driver.choose("one", "three")
    driver.click("delete")
    assert driver.names() == ["two"]
    assert driver.message() == "Deleted: one, three"
    driver.click("undo")
    assert driver.names() == ["one", "three", "two"]
    assert driver.library.load("three").points == (POINT, POINT)
    assert not driver.child("undo").isVisible()


def test_one_that_is_open_is_not_deleted(driver):
    driver.window.open_trajectory("one")
    driver.choose("one")
    driver.click("delete")
    assert "one" in driver.names()
    assert "“one” is open" in driver.message()


def test_a_copy_gets_a_name_of_its_own(driver):
    driver.choose("two")
    driver.click("duplicate")
    assert driver.names() == ["one", "three", "two", "two 2"]
    assert driver.library.load("two 2").points == driver.library.load("two").points


def test_another_name_is_typed_into_the_list(driver):
    driver.choose("two")
    driver.rename("zwei/2")
    assert driver.names() == ["one", "three", "zwei/2"]
    assert len(driver.library.load("zwei/2").points) == 3


def test_a_name_that_is_taken_is_refused(driver):
    driver.choose("two")
    driver.rename("one")
    assert driver.names() == ["one", "three", "two"]
    assert "one" in driver.message()


def test_only_what_is_searched_for_is_listed(driver):
    QTest.keyClicks(driver.child("search"), "T")
    assert driver.names() == ["three", "two"]


def test_a_damaged_file_is_listed_and_stays_as_it_is(driver):
    path = driver.app_driver.library_folder / "one.log"
    path.write_text("armui trajectory 1\nJ 1 2")
    driver.window.refresh()
    assert driver.rows()[0][4] == "✕ damaged"
    driver.window.open_trajectory("one")
    assert "one.log, line 2" in driver.message()
    assert path.read_text() == "armui trajectory 1\nJ 1 2"


# What a check leaves in the list

BENT = (0.0, 40.0, -40.0, 0.0, 85.0, 0.0)
"""Joint 5 turns to 85° in a PiPER H, to 70° in a PiPER."""


def check_in_editor(driver, name):
    driver.window.open_trajectory(name)
    editor = driver.app_driver.page(EditorPage)
    driver.app_driver.click(editor.findChild(QWidget, "editor_check"))
    editor.leave()


def marks(driver):
    return {row[0]: row[4] for row in driver.rows()}


def test_what_a_check_found_stays_listed_whenever_the_disk_answers(driver, monkeypatch):
    away = Waypoint(MoveMode.MOVE_P, (900.0, 0.0, 200.0, 0.0, 85.0, 0.0))
    driver.library.save(Trajectory("away", points=(POINT, away)))
    driver.app_driver.ready()
    driver.app_driver.click("library_button")
    driver.window.refresh()
    driver.choose("away")
    disk: Any = Slow()
    monkeypatch.setattr(driver.window._work._background, "_files", disk)
    driver.app_driver.click(driver.window.findChild(QWidget, "run_send"))
    for _ in range(6):
        disk.work()
        QCoreApplication.processEvents()
    assert "Correct what is listed" in driver.message()
    findings = driver.window.findChild(QListWidget, "findings_list")
    assert findings.isVisible()
    assert findings.item(0).text().startswith("✕ Error · Row 2")
    assert marks(driver)["away"] == "✕ errors"
    assert not driver.window.findChild(QWidget, "run_send").property("primary")
    driver.choose("one")
    assert driver.window.findChild(QWidget, "run_send").property("primary")
    assert not findings.isVisible()


def test_a_mark_is_for_the_arm_it_was_made_for(driver):
    driver.library.save(Trajectory("bent", points=(Waypoint(MoveMode.MOVE_J, BENT),)))
    driver.app_driver.connect()
    driver.app_driver.click("library_button")
    check_in_editor(driver, "bent")
    driver.window.refresh()
    assert marks(driver)["bent"] == "✕ errors"
    driver.app_driver.connect(PiperModel.PIPER_H)
    assert marks(driver)["bent"] == "—"
    driver.app_driver.connect(PiperModel.PIPER)
    assert marks(driver)["bent"] == "✕ errors"  # it still holds for that one


def test_a_mark_is_for_the_work_area_and_the_lowest_height_it_was_made_with(driver):
    driver.library.save(Trajectory("far", points=(POINT,)))
    driver.app_driver.ready()
    controller = driver.app_driver.controller
    driver.app_driver.click("library_button")
    check_in_editor(driver, "far")
    driver.window.refresh()
    assert marks(driver)["far"] == "✓ checked"
    crate = AreaBox("crate", (900.0, 0.0, 100.0, 0.0, 0.0, 0.0), (50.0, 50.0, 50.0))
    accepted(controller.cell.take(Cell("bench", area=Area(boxes=(crate,)))))
    driver.app_driver.run_until(lambda: marks(driver)["far"] == "—")
    off = replace(crate, on=False)
    accepted(controller.cell.change(Cell("bench", area=Area(boxes=(off,)))))
    driver.app_driver.run_until(lambda: marks(driver)["far"] == "✓ checked")
    controller.jog_floor.lowest_mm = 20.0
    driver.app_driver.step()
    driver.window._show_marks()
    assert marks(driver)["far"] == "—"


def test_what_a_check_found_is_read_by_a_click_on_its_mark(driver):
    """Nothing is sent, and it is checked no second time while it is listed."""
    away = Waypoint(MoveMode.MOVE_P, (900.0, 0.0, 200.0, 0.0, 85.0, 0.0))
    driver.library.save(Trajectory("away", points=(POINT, away)))
    driver.app_driver.ready()
    driver.app_driver.click("library_button")
    check_in_editor(driver, "away")
    driver.window.refresh()
    driver.app_driver.run_until(lambda: marks(driver)["away"] == "✕ errors")
    row = driver.names().index("away")
    cell = driver.table.visualRect(driver.table.model().index(row, LibraryColumn.CHECK)).center()
    driver.app_driver.heard()
    QTest.mouseClick(driver.table.viewport(), Qt.MouseButton.LeftButton, pos=cell)
    found = driver.window.findChild(QListWidget, "findings_list")
    driver.app_driver.run_until(lambda: found.isVisible() and found.count() > 0)
    assert found.item(0).text().startswith("✕ Error")
    assert not driver.app_driver.controller.player.running
    assert driver.app_driver.heard() == []


def test_where_the_arm_stands_is_no_mark_of_a_trajectory(driver):
    driver.library.save(Trajectory("far", points=(POINT,)))
    driver.app_driver.ready()  # 40° and more away
    driver.app_driver.click("library_button")
    check_in_editor(driver, "far")
    driver.window.refresh()
    assert marks(driver)["far"] == "✓ checked"


def test_a_check_that_waits_and_its_path_belong_to_the_chosen_row(driver):
    """Send waits for the warning of the way there; another row has neither mark nor path."""
    driver.library.save(Trajectory("far", points=(POINT,)))
    driver.app_driver.ready()
    driver.app_driver.click("library_button")
    driver.window.refresh()
    driver.app_driver.run_until(lambda: "far" in driver.names())
    driver.choose("far")
    driver.app_driver.click(driver.window.findChild(QWidget, "run_send"))
    driver.app_driver.run_until(lambda: marks(driver)["far"] == "! warnings")
    assert driver.app_driver.program.view._state.preview.path.rows == (0,)
    assert driver.app_driver.find("preview_bar").isVisible()
    driver.choose("one")
    assert marks(driver)["far"] == "✓ checked"
    assert driver.app_driver.program.view._state.preview == NOTHING
    assert not driver.app_driver.find("preview_bar").isVisible()


@pytest.mark.styled
@pytest.mark.parametrize("language", ["en", "zh"])
def test_with_the_drawer_open_whole_rows_are_seen(app_driver, language):
    app_driver.store.change(language=language)
    driver = LibraryDriver(app_driver, "one", "three", "two")
    app_driver.click("events_button")
    app_driver.run(0.2)
    table = driver.table
    assert app_driver.find("drawer").isVisible()
    assert table.viewport().height() >= 3 * table.rowHeight(0)


def test_a_run_is_continued_beside_its_own_trajectory_alone(driver):
    for name in ("near", "other"):
        driver.library.save(Trajectory(name, points=(POINT, POINT)))
    driver.app_driver.ready()
    driver.app_driver.click("library_button")
    driver.window.refresh()
    driver.app_driver.run_until(lambda: {"near", "other"} <= {*driver.names()})
    driver.choose("near")
    driver.app_driver.click(driver.window.findChild(QWidget, "run_send"))
    accept = driver.window.findChild(QWidget, "accept_warnings")
    driver.app_driver.run_until(accept.isVisible)
    driver.app_driver.click(accept)
    driver.app_driver.run_until(lambda: driver.app_driver.controller.player.running)
    driver.app_driver.run(0.3)
    driver.app_driver.click("run_stop")
    resume = driver.window.findChild(QWidget, "run_resume")
    driver.app_driver.run_until(resume.isVisible)
    driver.choose("other")
    assert not resume.isVisible()
    driver.choose("near")
    assert resume.isVisible()


def test_one_that_runs_keeps_its_name_and_is_not_deleted(driver):
    app_driver = driver.app_driver
    app_driver.ready()
    driver.choose("one")
    driver.child("rename").click()  # begun before the run, ended in it
    player = app_driver.controller.player
    accepted(player.start(Run("one", (POINT,), (3.0,))))
    driver.type_name("first")
    assert "“one” is running" in driver.message()
    driver.undo()
    driver.key(Qt.Key.Key_Delete)
    driver.key(Qt.Key.Key_F2)
    assert driver.names() == ["one", "three", "two"]
    for name in ("delete", "rename"):
        assert not driver.child(name).isEnabled()
        assert "“one” is running" in driver.child(name).toolTip()
        assert "“one” is running" in driver.window.act_of(f"library.{name}").reason()
    assert driver.child("duplicate").isEnabled()
    accepted(player.pause())
    driver.choose("two", "one")
    assert "“one” is running" in driver.child("delete").toolTip()
    driver.choose("two")
    assert driver.child("delete").isEnabled()
    driver.choose("one")
    player.stop()
    app_driver.run_until(driver.child("delete").isEnabled)
    driver.key(Qt.Key.Key_Delete)
    assert driver.names() == ["three", "two"]


def test_why_one_was_not_run_is_not_said_of_another(driver):
    beyond = Waypoint(MoveMode.MOVE_J, (0.0, 60.0, -60.0, 0.0, 0.0, 170.0))
    driver.library.save(Trajectory("beyond", points=(beyond,)))
    driver.app_driver.ready()
    driver.window.refresh()
    driver.choose("beyond")
    driver.app_driver.click("run_send")
    driver.app_driver.run(0.5)
    assert driver.message().startswith("Not run")
    driver.choose("three")
    assert driver.message() == ""
