"""The list of the library in its other states, and the windows that belong to it."""

from __future__ import annotations

import os
import tempfile
from dataclasses import replace
from pathlib import Path

from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QLineEdit, QWidget

from armui.trajectory import files
from armui.trajectory.library.store import Library
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.library.bin_dialog import BinDialog
from armui.ui.trajectory.library.library_exchange import ImportReport
from armui.ui.trajectory.library.library_page import LibraryPage
from tests.app_driver import AppDriver
from tests.gallery_scenes.trajectories import library
from tests.sample_trajectories import SAMPLES

_CHANGED_S = 1_768_478_400.0


def empty(app_driver: AppDriver) -> LibraryPage:
    """Before anything is in the library."""
    app_driver.window.open_library_window()
    return app_driver.page(LibraryPage)


def not_found(app_driver: AppDriver) -> LibraryPage:
    """A search for what is not there."""
    window = library(app_driver)
    search = window.findChild(QLineEdit, "library_search")
    assert search is not None
    search.clear()
    QTest.keyClicks(search, "welding")
    return window


def in_folder(app_driver: AppDriver) -> LibraryPage:
    """Two folders; the list of all trajectories tells which two lie in one."""
    window = library(app_driver)
    window.findChild(QLineEdit, "library_search").clear()
    stored = Library(app_driver.library_folder)
    folders = stored.listing().folders
    if not folders:
        for name in ("Packing line", "Welding cell"):
            stored.create_folder(name)
        stored.move(["Pick and place", "Warm up"], "Packing line")
    window.refresh()
    return window


def deleted(app_driver: AppDriver) -> LibraryPage:
    """Two deletions that can be undone, and a trajectory that was never saved."""
    window = library(app_driver)
    window.findChild(QLineEdit, "library_search").clear()
    stored = Library(app_driver.library_folder)
    trials = () if stored.recently_deleted() else SAMPLES[:2]
    for number, content in enumerate(trials, start=1):
        name = f"Trial {number}"
        stored.save(replace(content, name=name))
        window.refresh([name])
        app_driver.click(window.findChild(QWidget, "library_delete"))
    if "Palletizing" not in stored.drafts():
        stored.save_draft("Palletizing", SAMPLES[0])
        for path in app_driver.library_folder.rglob("*"):
            os.utime(path, (_CHANGED_S, _CHANGED_S))  # the list shows when a draft was changed
    window.refresh()
    return window


def bin_(app_driver: AppDriver) -> QDialog:
    """What can be brought back."""
    app_driver.click(deleted(app_driver).findChild(QWidget, "library_bin"))
    return app_driver.dialog(BinDialog)


def imported(app_driver: AppDriver) -> LibraryPage:
    """Files of which some are broken, one is a table, and one has a name that is taken."""
    window = library(app_driver)
    stored = Library(app_driver.library_folder)
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder) / f"{name}.log" for name in ("pick", "place", "weld", "seam 7")]
        paths[0].write_bytes(files.to_bytes(SAMPLES[0], ".log"))
        for path in paths[1:]:
            path.write_text("armui trajectory 1\nname: x\n\nJ 0 10 -20 0 O 0\n")
        table = Path(folder) / "from the robot.txt"
        table.write_text("1;2;3\n4;5;6\n")
        app_driver.click(window.findChild(QWidget, "library_import"))
        chooser = app_driver.dialog(FileDialog)
        chooser.filesSelected.emit([str(path) for path in (*paths, table)])
        chooser.close()
    new = [entry.name for entry in stored.entries() if entry.name.startswith(f"{SAMPLES[0].name} ")]
    stored.delete(new)
    return window


def report(app_driver: AppDriver) -> QDialog:
    """What became of each of them."""
    app_driver.click(imported(app_driver).findChild(QWidget, "library_report"))
    return app_driver.dialog(ImportReport)
