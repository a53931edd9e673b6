"""The library, the editor, a recording, the import by columns, and the preview."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QWidget

from armui.arm.model_check import ModelFit
from armui.cell.cell import Cell, with_part
from armui.cell.held_objects import HeldObject
from armui.cell.user_frames import UserFrame
from armui.control.parameters.arm_model import arm_model
from armui.protocol.codes import MoveMode
from armui.protocol.generation import PiperModel
from armui.trajectory.columns import ColumnQuantity
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import GripperOpening, Trajectory, Waypoint
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.trajectory.recording.recording_page import RecordingPage
from armui.ui.trajectory.table_import.columns_page import ColumnsPage
from armui.ui.widgets.page import Page
from tests.app_driver import AppDriver
from tests.sample_trajectories import SAMPLES

_OVER_DEG = (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)
_SUNK_DEG = (-20.9, 142.0, -2.7, -26.1, 65.7, 103.0)
"""The wrist lies against the base."""


def library(app_driver: AppDriver) -> LibraryPage:
    """Four trajectories, one of them checked; the simulated arm never runs them."""
    library = Library(app_driver.library_folder)
    if not library.entries():
        for content in SAMPLES:
            library.save(content)
        arm = arm_model(app_driver.controller).fingerprint
        library.mark("Warm up", check="ok", arm=arm)
    app_driver.window.open_library_window()
    window = app_driver.page(LibraryPage)
    window.refresh(["Pick and place"])
    return window


def editor(app_driver: AppDriver) -> EditorPage:
    library(app_driver).open_trajectory("Pick and place")
    return app_driver.page(EditorPage)


def editor_find(app_driver: AppDriver) -> Page:
    window = editor(app_driver)
    QTest.keyClick(window, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    return window


def editor_of_the_cell(app_driver: AppDriver) -> EditorPage:
    """Points in a user frame, one in a frame that is not there, and one that holds something."""
    app_driver.ready()
    table = UserFrame("工作台 Table", (150.0, -120.0, 40.0, 0.0, 0.0, 20.0))
    cube = HeldObject("Cube", (0.0, 0.0, 150.0, 0.0, 0.0, 0.0))
    cell = replace(with_part(Cell("bench"), table), held_objects=(cube,))
    app_driver.controller.cell.take(cell)
    corners = ((90.0, 140.0), (130.0, 140.0), (130.0, 80.0), (90.0, 80.0))
    line = Waypoint(MoveMode.MOVE_L, (0.0,) * 6, frame=table.name)
    rows = [replace(line, target=(x, y, 210.0, -170.0, 40.0, -160.0)) for x, y in corners]
    rows[1] = replace(rows[1], gripper=GripperOpening(35.0), holds="Cube")
    lost = replace(line, target=(10.0, 20.0, 150.0, 180.0, 0.0, 0.0), frame="Tray")
    library(app_driver)
    kept = Library(app_driver.library_folder)
    kept.save(Trajectory("Pallet", points=(Waypoint(MoveMode.MOVE_J, _OVER_DEG), *rows, lost)))
    library(app_driver).open_trajectory("Pallet")
    page = app_driver.page(EditorPage)
    page.table.select_row(1)
    return page


def failed_check(app_driver: AppDriver) -> Page:
    library(app_driver).open_trajectory("Out of reach")
    window = app_driver.page(EditorPage)
    app_driver.click(window.findChild(QWidget, "editor_check"))
    return window


def recording(app_driver: AppDriver) -> Page:
    library(app_driver).open_trajectory("By hand")
    return app_driver.page(RecordingPage)


def _by_columns(app_driver: AppDriver, table: str) -> ColumnsPage:
    window = library(app_driver)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "welding seam.csv"
        path.write_text(table)
        app_driver.click(window.findChild(QWidget, "library_import"))
        chooser = app_driver.dialog(FileDialog)
        chooser.filesSelected.emit([str(path)])
        chooser.close()
    return app_driver.page(ColumnsPage)


def columns(app_driver: AppDriver) -> Page:
    """A table that names most of its columns, one of them twice."""
    rows = "".join(
        f"{20 * step},{step},{0.3 + step / 100:.3f},{-0.7 - step / 90:.3f},0.1,0.4,-0.2,{step},41\n"
        for step in range(30)
    )
    page = _by_columns(app_driver, f"time_ms,j1,j2,j3,j4,j5,j6,counter,temperature\n{rows}")
    box = page.findChild(QComboBox, "column_quantity_8")
    box.setCurrentIndex(box.findData(ColumnQuantity.J1))
    box.activated.emit(box.currentIndex())
    return page


def columns_asked(app_driver: AppDriver) -> Page:
    """Small angles whose unit no title names: radians or degrees?"""
    rows = "".join(
        f"{20 * step},{step / 50:.3f},{0.3 + step / 100:.3f},{-0.7 - step / 90:.3f},0.1,0.4,-0.2\n"
        for step in range(30)
    )
    return _by_columns(app_driver, f"time[ms],Achse1,Achse2,Achse3,Achse4,Achse5,Achse6\n{rows}")


def columns_with_units(app_driver: AppDriver) -> Page:
    """Titles that name units in brackets, each its own, and one column that is nothing known."""
    titles = "t[ms],Achse1[deg],Achse2[deg],Achse3[rad],Achse4（°）,Achse5 {rad},Achse6<deg>,state"
    rows = "".join(
        f"{20 * step},{step},{20 + step / 2},{-1.047 - step / 90:.3f},5,0.3,{step / 3:.2f},1\n"
        for step in range(30)
    )
    return _by_columns(app_driver, f"{titles}\n{rows}")


def older_zeros(app_driver: AppDriver) -> EditorPage:
    """Points of an arm of older firmware; this one counts from other zeros."""
    app_driver.ready()
    app_driver.run(1.0)
    library(app_driver)
    kept = Library(app_driver.library_folder)
    older = ModelFit(older_zeros=True).kind
    kept.save(replace(SAMPLES[0], name="Feeder, old cell", taught_on=older))
    library(app_driver).open_trajectory("Feeder, old cell")
    return app_driver.page(EditorPage)


def other_arm(app_driver: AppDriver) -> LibraryPage:
    """What a check says of a trajectory that was taught on another model."""
    app_driver.ready()
    app_driver.run(1.0)
    page = library(app_driver)
    other = ModelFit(PiperModel.PIPER_X).kind
    kept = Library(app_driver.library_folder)
    kept.save(replace(SAMPLES[0], name="Second cell", taught_on=other))
    page.refresh(["Second cell"])
    app_driver.click(page.findChild(QWidget, "run_send"))
    app_driver.run(0.5)
    return page


def sunk(app_driver: AppDriver) -> LibraryPage:
    """The arm touches itself where it stands: the trajectory is not to blame."""
    app_driver.lie(_SUNK_DEG)
    app_driver.ready()
    page = library(app_driver)
    app_driver.click(page.findChild(QWidget, "run_send"))
    app_driver.run(0.5)
    return page


def columns_offered(app_driver: AppDriver) -> Page:
    columns(app_driver).leave()
    return app_driver.page(LibraryPage)


def preview(app_driver: AppDriver) -> None:
    """The path of a trajectory in the 3D picture."""
    app_driver.connect()
    window = editor(app_driver)
    app_driver.wait(window.isActiveWindow)
    QTest.keyClick(window, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
    window.table.select_row(4)
