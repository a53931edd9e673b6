"""An operator looks at a trajectory in 3D before anything moves."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.viewport.path_picture import NOTHING

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
BACK = (-15.0, 30.0, -30.0, -10.0, 30.0, -20.0)
BEYOND = (170.0, *OUT[1:])


class Operator:
    """At the editor of a trajectory, the 3D view beside it."""

    def __init__(self, app_driver, *targets):
        self.app_driver = app_driver
        app_driver.ready()
        points = tuple(Waypoint(MoveMode.MOVE_J, target) for target in targets)
        Library(app_driver.library_folder).save(Trajectory("Test", points=points))
        app_driver.click("library_button")
        app_driver.page(LibraryPage).open_trajectory("Test")
        self.editor = app_driver.page(EditorPage)
        app_driver.wait(self.editor.isActiveWindow)

    def check(self):
        QTest.keyClick(self.editor, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)

    @property
    def shown(self):
        return self.app_driver.program.view._state.preview


@pytest.fixture
def at(app_driver):
    return Operator(app_driver, OUT, BACK)


def test_a_check_shows_the_way_and_a_ghost_and_moves_nothing(at):
    app_driver = at.app_driver
    assert not app_driver.find("preview_bar").isVisible()
    before = app_driver.firmware.joints_deg
    at.check()
    assert app_driver.find("preview_bar").isVisible()
    assert at.shown.path.rows == (0, 1)
    assert at.shown.ghost_deg == pytest.approx(before, abs=0.01)
    slider = app_driver.find("preview_slider")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert at.shown.ghost_deg == pytest.approx(BACK, abs=0.5)
    app_driver.run(1.0)
    assert app_driver.firmware.joints_deg == before


def test_a_row_and_its_mark_lead_to_one_another(at):
    at.editor.table.select_row(1)
    at.check()
    at.editor.table.select_row(0)
    assert at.shown.selected_row == 0
    assert at.shown.ghost_deg == pytest.approx(OUT, abs=0.5)
    at.app_driver.program.view.mark_picked.emit(1)
    assert at.editor.table.current_row() == 1
    assert at.shown.selected_row == 1


def test_points_that_cannot_be_reached_are_marked(app_driver):
    at = Operator(app_driver, OUT, BEYOND)
    at.check()
    assert at.shown.path.bad_rows == frozenset({1})


def test_another_point_takes_the_preview_away(at):
    at.check()
    at.editor.table.select_row(0)
    QTest.keyClick(at.editor.table, Qt.Key.Key_Delete)
    assert at.shown == NOTHING
    assert not at.app_driver.find("preview_bar").isVisible()


def test_the_operator_closes_the_preview(at):
    at.check()
    at.app_driver.click("preview_close")
    assert at.shown == NOTHING
