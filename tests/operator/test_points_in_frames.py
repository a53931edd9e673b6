"""An operator teaches two points in a user frame, moves the frame by figures, and runs them."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QTableView, QWidget

from armui.cell.cell import Cell, with_part
from armui.cell.user_frames import UserFrame
from armui.control.run.progress import RunPhase
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.trajectory.points.cells import PointColumn
from armui.trajectory.points.program import Waypoint
from armui.ui.trajectory.library.library_model import LibraryColumn
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.accepted import accepted
from tests.family import PIPER
from tests.operator.editor.actions import Editor
from tests.trajectory.frame_oracle import apart, carried, within

HERE = (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)
THERE = (-10.0, 75.0, -65.0, 10.0, 25.0, -20.0)
TABLE = (250.0, -80.0, 40.0, 0.0, 0.0, 20.0)
MOVED = (235.0, -70.0, 50.0, 3.0, -2.0, 24.0)
MODEL = Kinematics(PIPER)


@pytest.fixture
def driver(app_driver):
    """The arm ready, a cell with the table's frame, which is chosen."""
    app_driver.ready()
    cell = with_part(Cell("bench"), UserFrame("Table", TABLE))
    accepted(app_driver.controller.cell.take(cell))
    return app_driver


def stands_at(driver):
    return MODEL.forward(driver.firmware.joints_deg)


def drive(driver, joints_deg):
    accepted(driver.controller.motion.send_joints(joints_deg))
    driver.come_to_rest()


def run(driver, editor):
    """Press 发送, agree to what is far, and note where the arm was at the end of each point."""
    editor.click("run_send")
    accept = editor.child("accept_warnings", QWidget)
    if accept.isVisible():
        driver.click(accept)
    player = driver.controller.player
    driver.run_until(lambda: player.running)
    driver.run_until(lambda: player.progress.index == 1, seconds=60.0)
    first = stands_at(driver)
    driver.run_until(lambda: not player.running, seconds=60.0)
    assert player.progress.phase is RunPhase.DONE
    return first, stands_at(driver)


def test_two_points_go_with_the_frame_that_is_moved_by_figures(driver):
    """Measured: 0.0006 mm and 0.0005° at either."""
    drive(driver, HERE)
    editor = Editor(driver, Waypoint(MoveMode.MOVE_P, (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)))
    editor.choose(0)
    for joints_deg in (HERE, THERE):
        drive(driver, joints_deg)
        editor.act("insert_measured")
    editor.choose(0)
    editor.act("delete")
    taught = editor.points
    assert [(each.move, each.frame) for each in taught] == [(MoveMode.MOVE_P, "Table")] * 2
    for point, joints_deg in zip(taught, (HERE, THERE), strict=True):
        assert apart(carried(TABLE, point.target), MODEL.forward(joints_deg))[0] < 0.01
    run(driver, editor)
    driver.click("menu_cell")
    driver.click("cell_tab_frames")
    for axis, value in zip(("X", "Y", "Z", "RX", "RY", "RZ"), MOVED, strict=True):
        driver.type_into(f"cell_frame_{axis}", f"{value}")
    driver.click("cell_frame_apply")
    assert driver.controller.cell.cell.chosen_frame.pose == MOVED
    driver.click("library_button")
    ends = run(driver, editor)
    assert editor.points == taught
    for end, point in zip(ends, taught, strict=True):
        off_mm, off_deg = apart(end, carried(MOVED, point.target))
        assert off_mm < 0.01
        assert off_deg < 0.01


FAR = UserFrame("Far", (4200.0, -3900.0, 700.0, 0.0, 0.0, 35.0))


def test_a_frame_far_away_takes_points_and_runs(app_driver):
    """The figures are beyond 5 m; the arm comes to where the oracle says, within 0.01 mm."""
    app_driver.ready()
    accepted(app_driver.controller.cell.take(with_part(Cell("bench"), FAR)))
    place = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
    told = within(FAR.pose, place)
    assert max(map(abs, told[:3])) > 5000.0
    editor = Editor(
        app_driver, Waypoint(MoveMode.MOVE_P, within(FAR.pose, place), None, 100, frame="Far")
    )
    editor.type_into(0, PointColumn.VALUE_1, f"{told[0] - 12.0:.3f}")
    goal = carried(FAR.pose, (round(told[0] - 12.0, 3), *told[1:]))
    editor.click("editor_save")
    app_driver.wait(lambda: editor.window.document.saved)
    assert editor.library.load("Test").points == editor.points
    editor.click("run_send")
    accept = editor.child("accept_warnings", QWidget)
    if accept.isVisible():
        app_driver.click(accept)
    app_driver.run_until(lambda: app_driver.controller.player.running)
    app_driver.run_until(lambda: not app_driver.controller.player.running, seconds=60.0)
    app_driver.run(0.3)
    off_mm, off_deg = apart(stands_at(app_driver), goal)
    assert off_mm < 0.01
    assert off_deg < 0.01


def test_the_range_of_a_figure_is_that_of_its_frame(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.cell.take(with_part(Cell("bench"), FAR)))
    pose = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
    base, framed = Waypoint(MoveMode.MOVE_P, pose), Waypoint(MoveMode.MOVE_P, pose, frame="Far")
    editor = Editor(app_driver, base, framed)
    model = editor.table.model()
    for row, text, code in (
        *((0, "2000", None), (0, "2000.1", "point_out_of_range")),
        *((1, "11999", None), (1, "12001", "point_out_of_range")),
    ):
        refusal = model.why_not(model.index(row, PointColumn.VALUE_1), text)
        assert (refusal and refusal.code) == code, (row, text)
    editor.type_into(1, PointColumn.VALUE_1, "9000")
    editor.choose(1)
    editor.keys(Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    editor.keys(Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    assert editor.points[2] == editor.points[1]


def marks(driver, names):
    """The check marks in the library's list, by name."""
    driver.click("library_button")
    page = driver.page(LibraryPage)
    page.refresh()
    driver.run(0.1)
    table = page.findChild(QTableView, "library_table")
    model = table.model()
    shown = {
        model.index(row, 0).data(): model.index(row, LibraryColumn.CHECK).data()
        for row in range(model.rowCount())
    }
    return [shown[name] for name in names]


def test_a_moved_frame_takes_away_the_marks_of_its_own_trajectories_alone(driver):
    """Those of joints, of the base and of another frame stay; moved back it holds again."""
    cell = with_part(driver.controller.cell.cell, FAR)
    accepted(driver.controller.cell.change(replace(cell, frame="")))
    place = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
    points = {
        "joints": Waypoint(MoveMode.MOVE_J, HERE),
        "base": Waypoint(MoveMode.MOVE_P, place),
        "far": Waypoint(MoveMode.MOVE_P, within(FAR.pose, place), frame="Far"),
        "table": Waypoint(MoveMode.MOVE_P, within(TABLE, place), frame="Table"),
    }
    for name, point in points.items():
        editor = Editor(driver, point, name=name)
        editor.click("editor_check")
        driver.run(0.1)
    before = marks(driver, points)
    assert all(mark != "—" for mark in before)
    moved = with_part(cell, UserFrame("Table", MOVED), instead_of="Table")
    accepted(driver.controller.cell.change(replace(moved, frame="")))
    driver.run(0.2)
    assert marks(driver, points) == [*before[:3], "—"]
    assert marks(driver, points) == [*before[:3], "—"]
    accepted(driver.controller.cell.change(replace(cell, frame="")))
    driver.run(0.2)
    assert marks(driver, points) == before
