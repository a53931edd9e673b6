"""Files in and out."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QFileDialog, QTableWidget, QWidget

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.control.events import Level
from armui.control.run.progress import RunPhase
from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.dialogs.files import FileDialog
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_exchange import ImportReport
from tests.accepted import accepted
from tests.operator.library.actions import POINT, LibraryDriver


@pytest.mark.parametrize("suffix", files.SUFFIXES)
def test_one_is_exported_to_the_file_that_is_named(driver, tmp_path, suffix):
    driver.choose("two")
    chooser = driver.export(suffix)
    assert chooser.acceptMode() is QFileDialog.AcceptMode.AcceptSave
    chooser.fileSelected.emit(str(tmp_path / f"x{suffix}"))
    chooser.close()
    assert files.load(tmp_path / f"x{suffix}").points == (POINT,) * 3
    assert driver.message() == f"Exported: x{suffix}"


def test_each_format_says_what_it_is_for_in_both_languages(driver):
    menu = driver.child("export").menu()
    assert [action.text() for action in menu.actions()] == [
        ".log — text to read and edit, as the library keeps it",
        ".csv — for spreadsheets",
        ".json — for scripts and other programs",
        ".armui — for another armui: a double click opens it",
    ]
    driver.app_driver.store.change(language="zh")
    driver.app_driver.wait(lambda: menu.actions()[1].text() == ".csv — 用于电子表格")


def test_several_are_exported_into_a_folder_and_write_over_nothing(driver, tmp_path):
    (tmp_path / "one.csv").write_text("mine")
    driver.choose("one", "two")
    chooser = driver.export(".csv")
    chooser.fileSelected.emit(str(tmp_path))
    chooser.close()
    assert (tmp_path / "one.csv").read_text() == "mine"
    assert len(files.load(tmp_path / "one 2.csv").points) == 1
    assert len(files.load(tmp_path / "two.csv").points) == 3


def test_a_file_that_cannot_be_written_is_told(driver, tmp_path):
    driver.choose("one")
    chooser = driver.export(".log")
    chooser.fileSelected.emit(str(tmp_path / "nowhere" / "x.log"))
    chooser.close()
    assert "x.log" in driver.message()
    assert "Not exported" in driver.message()


def test_several_files_are_imported_and_a_broken_one_is_told(driver, tmp_path):
    for suffix in files.SUFFIXES:
        data = files.to_bytes(Trajectory("new", points=(POINT,)), suffix)
        (tmp_path / f"new{suffix}").write_bytes(data)
    (tmp_path / "bad.log").write_text("armui trajectory 1\nname: bad\n\nJ 1 2 3\n")
    driver.click("import")
    chooser = driver.app_driver.dialog(FileDialog)
    assert chooser.fileMode() is QFileDialog.FileMode.ExistingFiles
    chooser.filesSelected.emit([str(path) for path in sorted(tmp_path.glob("*.*"))])
    chooser.close()
    assert {"new", "new 2", "new 3", "new 4"} <= set(driver.names())
    assert "bad" not in driver.names()
    assert "Imported: new, new 2, new 3, new 4" in driver.message()
    assert "bad.log, line 4" in driver.message()


def brought(driver, *paths):
    """The paths are chosen in the window of the button."""
    driver.click("import")
    chooser = driver.app_driver.dialog(FileDialog)
    chooser.filesSelected.emit([str(path) for path in paths])
    chooser.close()


def file_of(folder, file, name="one"):
    path = folder / file
    path.write_bytes(files.to_bytes(Trajectory(name, points=(POINT,) * 7), path.suffix))
    return path


def test_reading_takes_its_time(slow_driver, tmp_path):
    driver = LibraryDriver(slow_driver, "one")
    (tmp_path / "new.log").write_text("armui trajectory 1\nname: new\n\nJ 1 2 -3 4 5 6\n")
    driver.window._exchange.import_files([tmp_path / "new.log"])
    assert driver.message() == "Reading new.log…"
    slow_driver.workers.work()
    assert driver.message() == "Imported: new"
    assert driver.names() == ["new", "one"]


def test_reading_that_fails_altogether_is_told(slow_driver, tmp_path):
    driver = LibraryDriver(slow_driver, "one")
    driver.window._exchange.import_files([tmp_path / "new.log"])
    slow_driver.workers.break_down("out of memory")
    assert "out of memory" in driver.message()
    assert driver.names() == ["one"]


def test_a_name_that_is_taken_is_told(driver, tmp_path):
    brought(driver, file_of(tmp_path, "x.json"), file_of(tmp_path, "y.log", "new"))
    assert driver.message() == (
        "Imported: one 2, new\nTheir names were taken, so they got others: one → one 2"
    )
    assert driver.library.load("one").points == (POINT,)
    assert len(driver.library.load("one 2").points) == 7
    assert {entry.name for entry in driver.window.chosen()} == {"new", "one 2"}


def test_of_many_files_the_report_tells_what_became_of_each(driver, tmp_path):
    paths = [file_of(tmp_path, f"good {number}.csv", f"g{number}") for number in range(7)]
    paths.append(file_of(tmp_path, "taken.log", "two"))
    for number in range(5):
        paths.append(tmp_path / f"bad {number}.log")
        paths[-1].write_text(
            f"armui trajectory 1\nname: b\n\nJ 0 0 0 0 0 0\nJ 1 2 x{number} 4 5 6\n"
        )
    paths.append(tmp_path / "gone.csv")
    paths.append(tmp_path / "table.txt")
    paths[-1].write_text("1;2;3\n4;5;6\n")
    brought(driver, *paths)

    said = driver.message().splitlines()
    assert said[0] == "Imported: g0, g1, g2, g3, g4 … (+3)"
    assert said[1] == "Their names were taken, so they got others: two → two 2"
    assert said[2] == "Not imported. bad 0.log, line 5, column 7: “x0” is not a number."
    assert said[-1] == "Not imported either: 4 more. See the results."
    assert len(said) == 6
    assert driver.child("by_columns").isVisible()
    driver.click("report")
    report = driver.app_driver.dialog(ImportReport)
    assert report.findChild(QWidget, "report_summary").text() == "8 imported, 7 not imported."
    table = report.findChild(QTableWidget, "report_table")
    told = {table.item(row, 0).text(): table.item(row, 1).text() for row in range(15)}
    assert told["bad 4.log"].startswith("✕ bad 4.log, line 5, column 7: “x4”")
    assert told["gone.csv"].startswith("✕ gone.csv: The file cannot be read")
    assert told["table.txt"].endswith("Import it by columns.")
    assert told["good 6.csv"] == "✓ As “g6”"
    assert told["taken.log"] == "✓ As “two 2”: the name “two” was taken"
    report.close()


def test_an_import_is_undone(driver, tmp_path):
    brought(driver, file_of(tmp_path, "x.json"), file_of(tmp_path, "y.log", "new"))
    driver.undo()
    assert driver.names() == ["one", "three", "two"]


def test_of_several_that_are_exported_a_damaged_one_keeps_none_back(driver, tmp_path):
    (driver.app_driver.library_folder / "one.log").write_text("armui trajectory 1\nJ 1 2")
    driver.window.refresh()
    driver.choose("one", "two", "three")
    chooser = driver.export(".csv")
    chooser.fileSelected.emit(str(tmp_path))
    chooser.close()
    assert sorted(path.name for path in tmp_path.glob("*.csv")) == ["three.csv", "two.csv"]
    assert driver.message().startswith(
        "Exported: three.csv, two.csv\nNot exported. one.log, line 2"
    )


# Dropped ------------------------------------------------------------------------------------------


def drop(window, *urls, text=""):
    """What the system does when something is dropped on a window; whether it was taken."""
    data = QMimeData()
    if urls:
        data.setUrls([QUrl(url) for url in urls])
    data.setText(text)
    place = QPoint(200, 200)
    buttons, keys = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    actions = Qt.DropAction.CopyAction | Qt.DropAction.MoveAction
    enter = QDragEnterEvent(place, actions, data, buttons, keys)
    QApplication.sendEvent(window, enter)
    if enter.isAccepted():
        event = QDropEvent(QPointF(place), actions, data, buttons, keys)
        QApplication.sendEvent(window, event)
        assert event.dropAction() is Qt.DropAction.CopyAction  # the files stay where they are
    return enter.isAccepted()


def test_files_dropped_on_the_window_are_imported(driver, tmp_path):
    bad = tmp_path / "bad.log"
    bad.write_text("armui trajectory 1\nname: bad\n\nJ 1\n")
    good = file_of(tmp_path, "good.csv", "new")
    assert drop(driver.window, bad.as_uri(), good.as_uri())
    assert driver.names() == ["new", "one", "three", "two"]
    assert "bad.log, line 4" in driver.message()
    assert good.exists()


def test_what_is_no_file_is_not_taken(driver):
    assert not drop(driver.window, text="some text")
    assert not drop(driver.window, "https://example.org/a.log")
    assert driver.names() == ["one", "three", "two"]


def shown_editors(driver):
    pages = driver.app_driver.window.findChildren(EditorPage)
    return [each for each in pages if each.isVisible()]


def heard_by_the_arm(driver):
    """The identifiers of what was on the bus since the last call."""
    ear = driver.app_driver._ear
    return {message.arbitration_id for message in iter(lambda: ear.recv(0), None)}


def test_a_file_of_the_command_line_is_opened_and_nothing_moves(driver, tmp_path):
    driver.app_driver.ready()
    heard_by_the_arm(driver)
    path = file_of(tmp_path, "x.armui", "carried here")
    for _ in range(2):  # opened again, it is not piled up
        driver.app_driver.window.pages.trajectories.open_file(path)
        (editor,) = shown_editors(driver)
        assert editor.document.points == (POINT,) * 7
        editor.leave()
    assert driver.names().count("carried here") == 1
    assert not [name for name in driver.names() if name.startswith("carried here ")]
    driver.app_driver.run(0.3)
    assert not heard_by_the_arm(driver) & set(range(0x150, 0x160))
    assert driver.app_driver.controller.player.progress.phase is RunPhase.IDLE


def test_a_file_of_the_command_line_of_a_taken_name_is_opened_beside_it(driver, tmp_path):
    driver.app_driver.window.pages.trajectories.open_file(file_of(tmp_path, "x.csv", "two"))
    (editor,) = shown_editors(driver)
    assert len(editor.document.points) == 7
    assert {"two", "two 2"} <= set(driver.names())


def test_the_librarys_own_file_is_opened_itself(driver):
    before = driver.names()
    driver.app_driver.window.pages.trajectories.open_file(driver.library.folder / "two.log")
    (editor,) = shown_editors(driver)
    assert len(editor.document.points) == 3
    assert driver.names() == before


def test_a_file_of_the_command_line_that_is_none_is_told_in_the_library(driver, tmp_path):
    path = tmp_path / "no.armui"
    path.write_text("armui trajectory 1\nname: b\n\nJ 1 2 3\n")
    driver.app_driver.window.pages.trajectories.open_file(path)
    assert shown_editors(driver) == []
    assert "no.armui, line 4" in driver.message()


POSE = Waypoint(MoveMode.MOVE_L, (300.0, 0.0, 250.0, 0.0, 85.0, 0.0))
PEN = Tool("pen", (10.0, -5.0, 100.0, 15.0, -25.0, 40.0))
LONG = Tool("pen", (10.0, -5.0, 130.0, 15.0, -25.0, 40.0))
TABLE = UserFrame("Table", (250.0, -80.0, 40.0, 10.0, -20.0, 35.0))


def test_poses_leave_and_come_as_those_of_the_tool_and_what_differs_is_told(driver, tmp_path):
    cell = driver.app_driver.controller.cell
    bench = with_part(with_part(Cell("bench"), PEN), TABLE)
    accepted(cell.take(bench))
    points = (POSE, replace(POSE, frame="Table"))
    driver.library.save(Trajectory("poses", points=points))
    driver.window.refresh()
    driver.choose("poses")
    chooser = driver.export(".csv")
    chooser.fileSelected.emit(str(tmp_path / "x.csv"))
    chooser.close()
    assert driver.message() == (
        "Exported: x.csv\nPoses in it are those of the tool “pen”, as the editor shows them."
    )
    assert "#tool,pen,10,-5,100,15,-25,40" in (tmp_path / "x.csv").read_text()
    brought(driver, tmp_path / "x.csv")
    assert driver.message().splitlines()[1].startswith("Their names were taken")
    accepted(cell.change(with_part(bench, LONG, instead_of="pen")))
    brought(driver, tmp_path / "x.csv")
    assert driver.message().splitlines()[2] == (
        "x.csv has poses of the tool “pen”, whose figures are others here. The flange goes where "
        "it did there, the tip elsewhere."
    )
    accepted(cell.choose(""))
    brought(driver, tmp_path / "x.csv")
    assert [line.partition(",")[0] for line in driver.message().splitlines()[2:4]] == [
        "x.csv has poses of the tool “pen”",
        "x.csv has points in the user frame “Table”",
    ]
    for name in ("poses 2", "poses 3", "poses 4"):
        assert driver.library.load(name).points == points


# Beyond what the arm can do -----------------------------------------------------------------------


def beyond_file(folder, name, *joint_2_deg):
    path = folder / f"{name}.csv"
    points = tuple(
        replace(POINT, target=(20.0, deg, -40.0, 10.0, 20.0, 15.0)) for deg in joint_2_deg
    )
    path.write_bytes(files.to_bytes(Trajectory(name, points=points), ".csv"))
    return path


def test_what_the_arm_cannot_run_is_imported_in_amber_with_joint_figure_and_remedy(
    driver, tmp_path
):
    brought(driver, beyond_file(tmp_path, "high", 40.0, 220.0))
    assert driver.message() == (
        "Imported: high\nThe arm cannot run “high”. Row 2: Joint 2 would be at 220°, beyond its "
        "limits 0° to 180°. Change the point."
    )
    assert driver.child("message")._level is Level.WARNING
    assert {row[0]: row[4] for row in driver.rows()}["high"] == "✕ errors"


def test_what_it_can_run_is_imported_in_green_and_is_checked(driver, tmp_path):
    brought(driver, beyond_file(tmp_path, "fine", 40.0, 50.0))
    assert driver.message() == "Imported: fine"
    assert driver.child("message")._level is Level.DONE
    assert {row[0]: row[4] for row in driver.rows()}["fine"] == "✓ checked"


def test_of_many_beyond_the_first_are_told_and_the_report_stays(driver, tmp_path):
    brought(
        driver,
        beyond_file(tmp_path, "a", 220.0, 40.0, 221.0),
        beyond_file(tmp_path, "b", 40.0, 222.0, 40.0, 223.0),
    )
    said = driver.message().splitlines()
    assert said[0] == "Imported: a, b"
    assert [line.split(":")[0] for line in said[1:4]] == [
        "The arm cannot run “a”. Row 1",
        "The arm cannot run “a”. Row 3",
        "The arm cannot run “b”. Row 2",
    ]
    assert said[4:] == ["And 1 more. Open it and press Check to see them."]
    assert driver.child("report").isVisible()


def test_a_message_that_came_meanwhile_is_not_taken_away_by_what_was_checked(slow_driver, tmp_path):
    driver = LibraryDriver(slow_driver, "one")
    driver.window._exchange.import_files([beyond_file(tmp_path, "high", 220.0)])
    while driver.message() == "Reading high.csv…":
        future, fn, args, kwargs = slow_driver.workers.waiting.pop(0)
        future.set_result(fn(*args, **kwargs))
    assert driver.message() == "Imported: high"
    driver.choose("one")
    driver.click("delete")
    assert driver.message() == "Deleted: one"
    slow_driver.workers.work()
    assert driver.message() == "Deleted: one"
