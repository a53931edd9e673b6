"""Unsaved work whose trajectory was never saved, or whose file somebody has removed."""

from PySide6.QtWidgets import QWidget

from armui.trajectory.points.program import Trajectory
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ui.trajectory.editor.editor_page import EditorPage
from tests.operator.library.actions import POINT, LibraryDriver


def lost(app_driver):
    """A library whose trajectory `one` has only unsaved changes left."""
    driver = LibraryDriver(app_driver, "one", "three")
    three = driver.library.load("three")
    assert isinstance(three, Trajectory)
    driver.library.save_draft("one", three)
    (app_driver.library_folder / "one.log").unlink()
    driver.window.refresh()
    return driver


def test_it_is_listed_as_what_it_is(app_driver):
    driver = lost(app_driver)
    name, points, _length, _modified, check, _note = driver.rows()[0]
    assert (name, points, check) == ("one *", "2", "! not saved")
    tip = driver.table.model().index(0, 0).data(3)  # Qt.ToolTipRole
    assert "Open it to save it, or delete it" in tip


def test_it_is_opened_and_saved(app_driver):
    driver = lost(app_driver)
    driver.window.open_trajectory("one")
    editor = app_driver.page(EditorPage)
    assert editor.document.points == (POINT, POINT)
    assert editor.title == "one *"
    app_driver.click(editor.findChild(QWidget, "editor_save"))
    assert driver.names() == ["one", "three"]
    assert driver.library.load("one").points == (POINT, POINT)
    assert driver.library.drafts() == []


def test_it_is_opened_and_discarded(app_driver):
    driver = lost(app_driver)
    driver.window.open_trajectory("one")
    app_driver.page(EditorPage).close()
    app_driver.click(app_driver.dialog(ConfirmDialog).action_button)
    assert driver.names() == ["three"]
    assert driver.library.drafts() == []


def test_it_is_deleted_and_brought_back(app_driver):
    driver = lost(app_driver)
    driver.choose("one *")
    driver.click("delete")
    assert driver.names() == ["three"]
    driver.undo()
    assert driver.names() == ["one *", "three"]


def test_what_needs_a_saved_one_says_so(app_driver):
    driver = lost(app_driver)
    driver.choose("one *")
    for name in ("duplicate", "export"):
        assert not driver.child(name).isEnabled()
        assert driver.child(name).toolTip() == "Not saved yet. Open it and save it first"


def test_it_gets_another_name(app_driver):
    driver = lost(app_driver)
    driver.choose("one *")
    driver.rename("uno")
    assert driver.names() == ["three", "uno *"]
    assert len(driver.library.draft("uno").points) == 2


def test_a_damaged_one_is_told(app_driver):
    driver = lost(app_driver)
    (app_driver.library_folder / "one.draft").write_text("armui trajectory 1\nname: one\n\nJ 1\n")
    driver.window.refresh()
    assert driver.rows()[0][4] == "✕ damaged"
    driver.window.open_trajectory("one")
    assert "one.draft, line 4" in driver.message()


def test_beside_send_it_says_that_unsaved_changes_do_not_run(app_driver):
    driver = LibraryDriver(app_driver, "one", "three")
    three = driver.library.load("three")
    assert isinstance(three, Trajectory)
    driver.library.save_draft("one", three)
    driver.window.refresh()
    effective = driver.window.findChild(QWidget, "run_effective")
    driver.choose("one *")
    assert "without its unsaved changes" in effective.text()
    driver.choose("three")
    assert "unsaved" not in effective.text()


def test_one_of_which_no_point_is_saved_is_not_called_empty(app_driver):
    driver = LibraryDriver(app_driver)
    driver.library.save(Trajectory("new"))
    driver.library.save_draft("new", Trajectory("new", points=(POINT,)))
    driver.window.refresh()
    driver.choose("new *")
    assert driver.rows()[0][:2] == ["new *", "none saved"]
    assert "No point of “new” is saved" in app_driver.find("run_send").toolTip()
