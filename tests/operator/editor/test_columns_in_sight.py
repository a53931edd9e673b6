"""At 1280×800 what matters is in sight in the tables of the library and the editor."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QLabel

from armui.protocol.codes import MoveMode
from armui.trajectory.library.store import Library
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import GripperOpening, LightAction, Trajectory, Waypoint
from armui.ui.theme import colors_of
from armui.ui.trajectory.library.library_model import LibraryColumn
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.table_import.columns_table import ColumnsTable
from tests.gallery_scenes.trajectories import columns_asked
from tests.operator.editor.actions import Editor

POSE = (243.125, -120.25, 300.5, -170.123, 140.25, -160.5)
ARC = Waypoint(MoveMode.MOVE_C, POSE, middle=POSE)
BEGIN = replace(ARC, move=MoveMode.MOVE_P, middle=None)


@pytest.mark.styled
@pytest.mark.parametrize("language", ["zh", "en"])
def test_middle_poses_give_way_to_the_figures_of_a_point(app_driver, language):
    app_driver.store.change(language=language)
    app_driver.window.resize(1280, 800)
    editor = Editor(app_driver, BEGIN, ARC, ARC)
    app_driver.run(0.2)
    table = editor.table
    gripper = table.visualRect(table.model().index(1, PointColumn.GRIPPER))
    assert table.viewport().rect().contains(gripper), "in sight without a scroll"
    whole = table.model().index(1, PointColumn.MIDDLE).data(Qt.ItemDataRole.ToolTipRole)
    assert all(f"{value:g}" in whole for value in POSE)
    narrow_px = table.columnWidth(PointColumn.MIDDLE)
    app_driver.window.resize(1920, 1000)
    app_driver.run(0.2)
    assert table.horizontalScrollBar().maximum() == 0
    assert table.columnWidth(PointColumn.MIDDLE) > narrow_px


@pytest.mark.styled
@pytest.mark.parametrize("size", [(1280, 800), (1440, 900)])
def test_no_gripper_is_cut_at_the_edge_of_the_table(app_driver, size):
    app_driver.ready()
    grips = replace(BEGIN, gripper=GripperOpening(35.0))
    table = Editor(app_driver, grips, ARC).table
    app_driver.window.resize(*size)
    app_driver.run(0.2)
    gripper = table.visualRect(table.model().index(0, PointColumn.GRIPPER))
    assert table.viewport().rect().contains(gripper)


@pytest.mark.styled
def test_at_1440_a_usual_arc_is_whole_and_its_note_is_told(app_driver):
    app_driver.ready()
    middle = (320.0, 50.0, 250.0, 0.0, 85.0, 0.0)
    arc = replace(ARC, target=(300.0, 100.0, 250.0, 0.0, 85.0, 0.0), middle=middle)
    grips = replace(arc, gripper=GripperOpening(35.0), light=LightAction(1, 0, 255, 0))
    table = Editor(app_driver, replace(grips, note="round the box")).table
    app_driver.window.resize(1440, 900)
    app_driver.run(0.2)
    for column in (PointColumn.MIDDLE, PointColumn.GRIPPER, PointColumn.LIGHT):
        assert table.columnWidth(column) >= table.sizeHintForColumn(column), column
    assert table.columnWidth(PointColumn.NOTE) >= 60
    assert table.horizontalScrollBar().maximum() == 0


@pytest.mark.styled
def test_a_table_ends_in_its_own_color_below_the_row_numbers(app_driver):
    numbers = Editor(app_driver, BEGIN).table.verticalHeader()
    app_driver.store.change(theme="dark")
    app_driver.run(0.1)
    picture = numbers.grab().toImage()
    below = picture.pixelColor(picture.width() // 2, picture.height() - 5)
    assert below.name() == colors_of(numbers).surface.lower()


@pytest.mark.styled
def test_an_empty_table_does_not_scroll_sideways(app_driver):
    app_driver.window.resize(1024, 720)
    app_driver.click("library_button")
    library = app_driver.page(LibraryPage)._table
    editor = Editor(app_driver, name="empty").table
    app_driver.run(0.2)
    assert not editor.horizontalScrollBar().isVisible()
    Library(app_driver.library_folder).delete(["empty"])
    app_driver.click("library_button")
    app_driver.run(0.2)
    assert library.model().rowCount() == 0
    assert not library.horizontalScrollBar().isVisible()


@pytest.mark.styled
def test_a_change_of_language_cuts_no_cell(app_driver):
    app_driver.store.change(language="en")
    app_driver.window.resize(1920, 1000)
    table = Editor(app_driver, replace(BEGIN, light=LightAction(1, 0, 255, 0))).table
    app_driver.store.change(language="zh")
    QApplication.processEvents()
    column = PointColumn.LIGHT
    assert table.columnWidth(column) >= table.sizeHintForColumn(column)


@pytest.mark.styled
def test_what_is_scrolled_into_sight_is_whole(app_driver):
    app_driver.store.change(language="en")
    app_driver.window.resize(1920, 1000)
    lit = replace(BEGIN, light=LightAction(1, 0, 255, 0))
    table = Editor(app_driver, *[BEGIN] * 60, lit, *[BEGIN] * 60).table
    app_driver.store.change(language="zh")
    QApplication.processEvents()
    column = PointColumn.LIGHT
    before_px = table.columnWidth(column)
    table.scrollTo(table.points.index(60, column))
    assert table.columnWidth(column) >= table.sizeHintForColumn(column) > before_px


@pytest.mark.styled
def test_the_list_of_the_library_does_not_scroll_sideways(app_driver):
    app_driver.window.resize(1280, 800)
    app_driver.click("library_button")
    app_driver.run(0.2)
    table = app_driver.page(LibraryPage)._table
    assert table.horizontalScrollBar().maximum() == 0
    assert table.columnWidth(LibraryColumn.NOTE) >= 110
    kept = Library(app_driver.library_folder)
    kept.save(Trajectory("Pick and place · Packing line", points=(BEGIN,), note="from the tray"))
    app_driver.page(LibraryPage).refresh()
    app_driver.run(0.2)
    assert table.columnWidth(LibraryColumn.NAME) >= table.sizeHintForColumn(LibraryColumn.NAME)
    assert table.horizontalScrollBar().maximum() == 0
    name = "a long name of a trajectory that is whole where there is room"
    kept.save(Trajectory(name, points=(BEGIN,)))
    app_driver.page(LibraryPage).refresh()
    app_driver.window.resize(1920, 1000)
    app_driver.run(0.2)
    assert table.columnWidth(LibraryColumn.NAME) >= table.sizeHintForColumn(LibraryColumn.NAME)


@pytest.mark.styled
def test_a_file_of_time_and_six_joints_is_imported_without_a_scroll(app_driver):
    app_driver.window.resize(1440, 900)
    page = columns_asked(app_driver)
    app_driver.run(0.2)
    assert page.findChild(ColumnsTable).horizontalScrollBar().maximum() == 0
    origin = page.findChild(QLabel, "column_origin_7")
    assert origin.fontMetrics().horizontalAdvance("Guess: check it") <= origin.width(), "is cut"


@pytest.mark.styled
def test_a_width_that_the_operator_has_given_stays_while_one_scrolls(app_driver):
    app_driver.window.resize(1920, 1000)
    table = Editor(app_driver, *[replace(BEGIN, gripper=GripperOpening(30.0))] * 100).table
    app_driver.run(0.2)
    table.setColumnWidth(PointColumn.GRIPPER, 150)
    table.verticalScrollBar().setValue(20)
    assert table.columnWidth(PointColumn.GRIPPER) == 150
