"""The library, the editor, a recording, the import by columns, and the preview."""

from __future__ import annotations

import tempfile
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QDialog, QWidget

from armui.trajectory.columns import Quantity
from armui.trajectory.library import Library
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.columns_dialog import ColumnsDialog
from armui.ui.trajectory.editor_window import EditorWindow
from armui.ui.trajectory.library_window import LibraryWindow
from armui.ui.trajectory.recording_window import RecordingWindow
from tests.desk import Desk
from tests.shelf import SHELF


def library(desk: Desk) -> QDialog:
    """Four trajectories, one of them checked; the simulated arm never runs them."""
    library = Library(desk.library_folder)
    if not library.entries():
        for content in SHELF:
            library.save(content)
        library.mark("Warm up", check="ok", length_s=84.0)
    desk.window.open_library_window()
    window = desk.dialog(LibraryWindow)
    window.refresh(["Pick and place"])
    return window


def editor(desk: Desk) -> QDialog:
    library(desk).open_trajectory("Pick and place")
    return desk.dialog(EditorWindow)


def editor_find(desk: Desk) -> QDialog:
    window = editor(desk)
    QTest.keyClick(window, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    return window


def failed_check(desk: Desk) -> QDialog:
    library(desk).open_trajectory("Out of reach")
    window = desk.dialog(EditorWindow)
    desk.click(window.findChild(QWidget, "editor_check"))
    return window


def recording(desk: Desk) -> QDialog:
    library(desk).open_trajectory("By hand")
    return desk.dialog(RecordingWindow)


def columns(desk: Desk) -> QDialog:
    """A table that names most of its columns, one of them twice."""
    rows = "".join(
        f"{20 * step},{step},{0.3 + step / 100:.3f},{-0.7 - step / 90:.3f},0.1,0.4,-0.2,{step},41\n"
        for step in range(30)
    )
    window = library(desk)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "welding seam.csv"
        path.write_text(f"time_ms,j1,j2,j3,j4,j5,j6,counter,temperature\n{rows}")
        desk.click(window.findChild(QWidget, "library_import"))
        chooser = desk.dialog(FileDialog)
        chooser.filesSelected.emit([str(path)])
        chooser.close()
        desk.click(window.findChild(QWidget, "library_by_columns"))
    dialog = desk.dialog(ColumnsDialog)
    box = dialog.findChild(QComboBox, "column_quantity_8")
    box.setCurrentIndex(box.findData(Quantity.J1))
    box.activated.emit(box.currentIndex())
    return dialog


def columns_offered(desk: Desk) -> QDialog:
    columns(desk).reject()
    return desk.dialog(LibraryWindow)


def preview(desk: Desk) -> None:
    """The path of a trajectory in the 3D picture."""
    desk.connect()
    window = editor(desk)
    desk.wait(window.isActiveWindow)
    QTest.keyClick(window, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
    window.table.select_row(4)
