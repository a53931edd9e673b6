"""The list of the library in its other states, and the windows that belong to it."""

from __future__ import annotations

import os
import tempfile
from dataclasses import replace
from pathlib import Path

from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QWidget

from armui.trajectory import files
from armui.trajectory.library import Library
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.bin_dialog import BinDialog
from armui.ui.trajectory.import_report import ImportReport
from armui.ui.trajectory.library_window import LibraryWindow
from tests.desk import Desk
from tests.gallery_scenes.trajectories import library
from tests.shelf import SHELF

_CHANGED_S = 1_768_478_400.0


def empty(desk: Desk) -> QDialog:
    """Before anything is in the library."""
    desk.window.open_library_window()
    return desk.dialog(LibraryWindow)


def not_found(desk: Desk) -> QDialog:
    """A search for what is not there."""
    window = library(desk)
    search = window.findChild(QWidget, "library_search")
    search.clear()
    QTest.keyClicks(search, "welding")
    return window


def deleted(desk: Desk) -> QDialog:
    """Two deletions that can be undone, and a trajectory that was never saved."""
    window = library(desk)
    window.findChild(QWidget, "library_search").clear()
    shelf = Library(desk.library_folder)
    trials = () if shelf.recently_deleted() else SHELF[:2]
    for number, content in enumerate(trials, start=1):
        name = f"Trial {number}"
        shelf.save(replace(content, name=name))
        window.refresh([name])
        desk.click(window.findChild(QWidget, "library_delete"))
    if "Palletizing" not in shelf.drafts():
        shelf.save_draft("Palletizing", SHELF[0])
        for path in desk.library_folder.rglob("*"):
            os.utime(path, (_CHANGED_S, _CHANGED_S))  # the list shows when a draft was changed
    window.refresh()
    return window


def bin_(desk: Desk) -> QDialog:
    """What can be brought back."""
    desk.click(deleted(desk).findChild(QWidget, "library_bin"))
    return desk.dialog(BinDialog)


def imported(desk: Desk) -> QDialog:
    """Files of which some are broken, one is a table, and one has a name that is taken."""
    window = library(desk)
    shelf = Library(desk.library_folder)
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{name}.log" for name in ("pick", "place", "weld", "seam 7")]
        paths[0].write_bytes(files.to_bytes(SHELF[0], ".log"))
        for path in paths[1:]:
            path.write_text("armui trajectory 1\nname: x\n\nJ 0 10 -20 0 O 0\n")
        table = Path(folder) / "from the robot.txt"
        table.write_text("1;2;3\n4;5;6\n")
        desk.click(window.findChild(QWidget, "library_import"))
        chooser = desk.dialog(FileDialog)
        chooser.filesSelected.emit([str(path) for path in (*paths, table)])
        chooser.close()
    new = [entry.name for entry in shelf.entries() if entry.name.startswith(f"{SHELF[0].name} ")]
    shelf.delete(new)
    return window


def report(desk: Desk) -> QDialog:
    """What became of each of them."""
    desk.click(imported(desk).findChild(QWidget, "library_report"))
    return desk.dialog(ImportReport)
