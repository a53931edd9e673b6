"""An operator who imports tables of an unknown dialect, and says what each of their columns is."""

import math

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.operator_library.tables import ANGLES, DEGREES, RADIANS, TITLED, is_open


def test_a_table_with_titles_needs_one_click(operator):
    operator.open(line=TITLED)
    assert "Import it by columns" in operator.told()
    joints = [f"J{joint} °" for joint in range(1, 7)]
    assert operator.columns() == ["Time ms", *joints, "-"]
    assert "line.csv: 8 columns" in operator.child("source").text()
    assert operator.child("name").text() == "line"
    assert operator.child("move").currentText() == "Recording"
    assert not operator.child("speed").isEnabled()
    assert operator.library.entries() == []
    operator.take()
    assert not is_open()
    kept = operator.library.load("line")
    assert isinstance(kept, Recording)
    assert kept.times_s == pytest.approx([0.0, 0.02])
    assert kept.joints_deg[1] == pytest.approx([11, 21, -31, 41, 51, 61])
    assert operator.told() == "Imported: line"
    assert [entry.name for entry in operator.list.chosen()] == ["line"]
    assert not operator.enable_or_explain.isVisible()


def test_what_is_missing_is_said_until_nothing_is(operator):
    operator.open(line=DEGREES)
    assert operator.columns() == ["Time ms", *["-"] * 7]
    button = operator.child("import")
    for joint in range(1, 7):
        assert not button.isEnabled()
        missing = ", ".join(f"J{left}" for left in range(joint, 7))
        assert operator.message() == f"Still missing: {missing}. Say which columns hold them."
        assert button.toolTip() == operator.message()
        operator.call(joint + 1, f"J{joint}")
    assert operator.message() == ""
    assert button.isEnabled()
    operator.take()
    assert operator.library.load("line").joints_deg[0] == pytest.approx([10, 20, -30, 40, 50, 60])


def test_what_is_said_twice_is_told(operator):
    operator.open(line=TITLED)
    operator.call(8, "J1")
    assert operator.message() == "Columns 2 and 8 are both J1. Leave one of them out."
    assert not operator.child("import").isEnabled()
    operator.call(8, "Ignored")
    assert operator.child("import").isEnabled()


def test_waits_and_radians_as_the_maker_records_them(operator):
    operator.open(taught=RADIANS)
    joints = [f"J{joint} rad" for joint in range(1, 7)]
    assert operator.columns() == ["Wait s", *joints, "Gripper m"]
    origin = operator.page.findChild(QWidget, "column_origin_2")
    assert origin.text() == "Guessed: check it"
    operator.take()
    kept = operator.library.load("taught")
    assert kept.times_s == pytest.approx([0.0, 0.01])
    assert kept.joints_deg[1, 1] == pytest.approx(math.degrees(0.6))
    assert kept.gripper_mm == pytest.approx([50.0, 50.0])


def test_another_unit_of_one_joint_is_that_of_all(operator):
    operator.open(taught=RADIANS)
    operator.choose(operator.box("unit", 4), "°")
    joints = [f"J{joint} °" for joint in range(1, 7)]
    assert operator.columns() == ["Wait s", *joints, "Gripper m"]
    assert operator.page.findChild(QWidget, "column_origin_2").text() == ""
    operator.take()
    assert operator.library.load("taught").joints_deg[1, 1] == pytest.approx(0.6)


def test_a_joint_called_later_is_in_the_unit_of_the_others(operator):
    operator.open(taught=RADIANS)
    operator.call(5, "Ignored")
    operator.call(5, "J4")
    assert operator.columns()[4] == "J4 rad"


def test_angles_without_time_become_points_at_a_speed(operator):
    operator.open(points=ANGLES)
    assert operator.child("move").currentText() == "Points, MOVE J"
    speed = operator.child("speed")
    assert speed.isEnabled()
    speed.setFocus()
    speed.selectAll()
    QTest.keyClicks(speed, "45")
    name = operator.child("name")
    name.selectAll()
    QTest.keyClicks(name, "Stack")
    operator.take()
    kept = operator.library.load("Stack")
    assert isinstance(kept, Trajectory)
    assert kept.points == (
        Waypoint(MoveMode.MOVE_J, (10, 40, -40, 10, 20, 15), speed_percent=45),
        Waypoint(MoveMode.MOVE_J, (20, 40, -40, 10, 20, 15), speed_percent=45),
    )


def test_poses_become_points_of_the_chosen_motion(operator):
    operator.open(poses="x_m,y_m,z_m,rx,ry,rz\n0.3,0,0.25,0,85,0\n0.3,0.1,0.25,0,85,0\n")
    assert operator.child("move").currentText() == "Points, MOVE P"
    operator.choose(operator.child("move"), "Points, MOVE J")
    assert operator.message().startswith("Still missing: J1, J2")
    operator.choose(operator.child("move"), "Points, MOVE L")
    operator.take()
    first, second = operator.library.load("poses").points
    assert (first.move, first.target) == (MoveMode.MOVE_L, (300, 0, 250, 0, 85, 0))
    assert second.target[1] == 100


def test_a_row_that_does_not_fit_is_named_and_nothing_is_kept(operator):
    operator.open(line=TITLED + "1040,12,x,-32,42,52,62,31\n")
    operator.take()
    assert operator.message() == "Not imported. Line 4, column 3: “x” is not a number."
    assert is_open()
    assert operator.library.entries() == []
    operator.call(3, "Ignored")
    assert operator.message() == "Still missing: J2. Say which columns hold them."


def test_a_wrong_unit_shows_in_the_limits_it_breaks(operator):
    operator.open(line=TITLED)
    operator.choose(operator.box("unit", 2), "rad")
    operator.take()
    assert operator.message().startswith("Not imported. Line 2: J1: 572.958° is out of range.")
    assert operator.library.entries() == []


def test_a_name_that_is_taken_or_none_is_refused(operator):
    operator.library.save(Trajectory("line"))
    operator.open(line=TITLED)
    operator.take()
    assert "There is a “line” already" in operator.message()
    assert operator.library.load("line").points == ()
    operator.child("name").setFocus()
    operator.child("name").selectAll()
    QTest.keyClick(operator.child("name"), Qt.Key.Key_Delete)
    assert operator.message() == "A trajectory needs a name. Enter one."
    assert not operator.child("import").isEnabled()


def test_cancel_changes_nothing_and_the_offer_stays(operator):
    operator.open(line=TITLED)
    operator.app_driver.click(operator.child("cancel"))
    assert not is_open()
    assert operator.library.entries() == []
    operator.app_driver.click(operator.enable_or_explain)
    operator.take()
    assert [entry.name for entry in operator.library.entries()] == ["line"]


def test_several_are_offered_one_after_the_other(operator):
    operator.open(first=TITLED, second=RADIANS)
    operator.take()
    assert operator.told() == "Imported: first\nNot imported yet: second.csv"
    operator.app_driver.click(operator.enable_or_explain)
    assert operator.child("name").text() == "second"
    operator.take()
    assert operator.told() == "Imported: second"
    assert {entry.name for entry in operator.library.entries()} == {"first", "second"}


def test_degrees_that_look_like_the_makers_radians_are_offered(operator):
    operator.open(bare="0,10,40,-40,10,20,15\n0.1,20,40,-40,10,20,15\n")
    assert "is out of range" in operator.told()
    assert operator.columns()[1] == "J1 °"


def test_what_holds_no_table_is_told_and_not_offered(operator):
    operator.bring(prose="Dear operator,\nsee you tomorrow.\n")
    assert "prose.csv: No rows of numbers are found here." in operator.told()
    assert not operator.enable_or_explain.isVisible()


def test_a_broken_file_of_ours_is_told_and_not_offered(operator):
    text = files.to_bytes(Trajectory("mine"), ".log").decode() + "J 1 2 3\nJ 1 2 3\n"
    operator.bring(mine=text)
    assert "6 belong" in operator.told()
    assert not operator.enable_or_explain.isVisible()


def test_a_file_that_is_gone_by_then_is_told(operator):
    operator.bring(line=TITLED)
    (operator.folder / "line.csv").unlink()
    operator.app_driver.click(operator.enable_or_explain)
    assert "line.csv: The file cannot be read" in operator.told()
    assert not operator.enable_or_explain.isVisible()
    assert not is_open()
