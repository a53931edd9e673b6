"""An operator who imports tables of an unknown dialect, and says what each of their columns is."""

import math
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.protocol.codes import MoveMode
from armui.trajectory import files
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from tests.accepted import accepted
from tests.operator.library.tables import ANGLES, DEGREES, RADIANS, TITLED, is_open
from tests.trajectory.frame_oracle import apart, carried

CANDUMP = "".join(
    f"(1700000000.{place:06d}) can0 2A5#0000{place:04X}00000000\n" for place in range(40)
)
CAN_TABLE = "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n" + "".join(
    f"{place * 1000},000002A5,false,Rx,0,8,00,00,00,{place:02X},00,00,00,00,\n"
    for place in range(40)
)


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


def test_a_table_goes_to_the_folder_that_is_listed(operator):
    operator.list.findChild(QWidget, "library_folder_menu").menu().actions()[0].trigger()
    name = operator.list.findChild(QWidget, "library_name")
    QTest.keyClicks(name, "cell")
    QTest.keyClick(name, Qt.Key.Key_Return)
    assert operator.list.findChild(QWidget, "library_folder").currentText() == "cell"
    operator.open(line=TITLED)
    operator.take()
    assert [(entry.name, entry.folder) for entry in operator.library.entries()] == [
        ("line", "cell")
    ]
    assert operator.list.findChild(QWidget, "library_folder").currentText() == "cell"


@pytest.mark.parametrize(("name", "log"), [("a.log", CANDUMP), ("b.csv", CAN_TABLE)])
def test_a_can_log_is_no_table_and_belongs_to_the_replay(operator, name, log):
    operator.bring(**{name: log})
    assert "This is a CAN log" in operator.told()
    assert "“Replay another log…”" in operator.told()
    assert not is_open()
    assert not operator.enable_or_explain.isVisible()
    assert operator.library.entries() == []


def test_what_is_missing_is_said_until_nothing_is(operator):
    operator.open(line=DEGREES)
    assert operator.columns() == ["Time ms", *["-"] * 7]
    button = operator.child("import")
    for joint in range(1, 7):
        assert not button.isEnabled()
        missing = ", ".join(f"J{left}" for left in range(joint, 7))
        said = f"Still missing: {missing}. Say which columns hold them."
        assert operator.message() == f"{said} What is needed depends on “Import as”."
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
    assert origin.text() == "Guess: check it"
    asked = "Columns 2, 3, 4, 5, 6, 7 may be radians or degrees: choose which."
    assert operator.message() == asked
    assert not operator.child("import").isEnabled()
    assert operator.child("import").toolTip() == asked
    operator.app_driver.click(operator.child("radians"))
    assert operator.message() == ""
    assert not operator.child("radians").isVisible()
    assert origin.text() == ""
    assert operator.columns() == ["Wait s", *joints, "Gripper m"]
    operator.take()
    kept = operator.library.load("taught")
    assert kept.times_s == pytest.approx([0.0, 0.01])
    assert kept.joints_deg[1, 1] == pytest.approx(math.degrees(0.6))
    assert kept.gripper_mm == pytest.approx([50.0, 50.0])


def test_small_angles_may_be_degrees(operator):
    operator.open(taught=RADIANS)
    operator.app_driver.click(operator.child("degrees"))
    joints = [f"J{joint} °" for joint in range(1, 7)]
    assert operator.columns() == ["Wait s", *joints, "Gripper m"]
    operator.take()
    assert operator.library.load("taught").joints_deg[1, 1] == pytest.approx(0.6)


def test_the_unit_of_one_column_is_its_own(operator):
    operator.open(taught=RADIANS)
    operator.choose(operator.box("unit", 4), "°")
    joints = [f"J{joint} {'°' if joint == 3 else 'rad'}" for joint in range(1, 7)]
    assert operator.columns() == ["Wait s", *joints, "Gripper m"]
    assert operator.message() == "Columns 2, 3, 5, 6, 7 may be radians or degrees: choose which."
    operator.app_driver.click(operator.child("radians"))
    assert operator.columns() == ["Wait s", *joints, "Gripper m"]
    assert operator.message() == (
        "The angles are in different units: J1 rad, J2 rad, J3 °, J4 rad, J5 rad, J6 rad. "
        "Check that this is meant."
    )
    operator.take()
    kept = operator.library.load("taught").joints_deg[1]
    assert kept[:3] == pytest.approx([math.degrees(0.1), math.degrees(0.6), -0.5])


@pytest.mark.parametrize(
    "brackets", ["[rad]", "(rad)", "{rad}", "<rad>", "（弧度）", "【弧度】", " rad"]
)
def test_the_unit_of_a_heading_wins_whatever_its_brackets(operator, brackets):
    titles = ",".join(f"Achse{joint}{brackets}" for joint in range(1, 7))
    operator.open(line=f"time[ms],{titles}\n0,0,0.5,-1.047,0,0,0\n20,0,0.5,-1.047,0,0,3\n")
    assert operator.columns() == ["Time ms", *[f"J{joint} rad" for joint in range(1, 7)]]
    assert operator.page.findChild(QWidget, "column_origin_4").text() == ""
    assert operator.message() == ""
    operator.take()
    assert operator.library.load("line").joints_deg[0, 2] == pytest.approx(-60.0, abs=0.02)


def test_the_unit_of_a_heading_wins_over_the_columns_beside_it_too(operator):
    operator.open(line="Achse1[deg],Achse2[deg],Weg[rad]\n10,20,-1.047\n20,20,-1.047\n")
    assert operator.columns() == ["J1 °", "J2 °", "-"]
    operator.call(3, "J3")
    assert operator.columns()[2] == "J3 rad"
    assert operator.page.findChild(QWidget, "column_origin_3").text() == ""


def test_one_large_angle_tells_that_all_are_degrees(operator):
    operator.open(points="0.5 40 -1 0.1 0.2 0.3\n0.6 41 -1 0.1 0.2 0.3\n")
    assert operator.columns() == [f"J{joint} °" for joint in range(1, 7)]
    assert operator.message() == ""
    origins = [operator.page.findChild(QWidget, f"column_origin_{n}").text() for n in (1, 6)]
    assert origins == ["Guess: check it"] * 2


def test_what_is_called_by_hand_has_a_unit_that_is_marked_as_guessed(operator):
    operator.open(line=DEGREES.replace("_deg", ""))
    operator.call(2, "J1")
    assert operator.columns()[1] == "J1 °"
    assert operator.page.findChild(QWidget, "column_origin_2").text() == "Guess: check it"
    operator.choose(operator.box("unit", 2), "rad")
    assert operator.page.findChild(QWidget, "column_origin_2").text() == ""


TOOL = "tool_x(mm),tool_y(mm),tool_z(mm),roll[rad],pitch[rad],yaw[rad]\n"


def test_the_pose_of_a_tool_becomes_points(operator):
    operator.open(poses=TOOL + "300,0,250,0,1.4835,0\n300,100,250,0,1.4835,0\n")
    units = ["X mm", "Y mm", "Z mm", "RX rad", "RY rad", "RZ rad"]
    assert operator.columns() == units
    assert operator.child("move").currentText() == "Points, MOVE P"
    operator.choose(operator.child("move"), "Points, MOVE J")
    assert operator.message().endswith(
        "Or choose “Points, MOVE P” under “Import as”: the columns suffice for that."
    )
    operator.choose(operator.child("move"), "Points, MOVE P")
    operator.take()
    assert is_open() is False, operator.message()
    first, _ = operator.library.load("poses").points
    assert first.target == pytest.approx((300, 0, 250, 0, 85, 0), abs=0.01)


def test_half_a_pose_is_asked_for_as_a_pose(operator):
    text = TOOL.replace("pitch[rad],yaw[rad]", "u[rad],v[rad]")
    operator.open(poses=text + "300,0,250,0,1.4835,0\n300,100,250,0,1.4835,0\n")
    assert operator.child("move").currentText() == "Points, MOVE P"
    assert operator.message().startswith("Still missing: RY, RZ.")


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
    assert operator.message().startswith("Still missing: J2. Say which columns hold them.")


def test_a_wrong_unit_shows_in_the_limits_it_breaks(operator):
    operator.open(line=TITLED)
    operator.choose(operator.box("unit", 2), "rad")
    operator.take()
    assert operator.message().startswith("Not imported. Line 2: J1: 573° is out of range.")
    assert operator.library.entries() == []


def test_what_the_arm_cannot_run_is_told_once_it_is_imported(operator):
    operator.open(line=ANGLES + "20 220 -40 10 20 15\n")
    operator.take()
    assert operator.told() == (
        "Imported: line\nThe arm cannot run “line”. Row 3: Joint 2 would be at 220°, beyond its "
        "limits 0° to 180°. Change the point."
    )


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
    assert operator.told().startswith("Not imported yet. line.csv, line 1: ")
    assert operator.library.entries() == []
    operator.app_driver.click(operator.enable_or_explain)
    operator.take()
    assert [entry.name for entry in operator.library.entries()] == ["line"]


def test_several_are_offered_one_after_the_other(operator):
    operator.open(first=TITLED, second=TITLED.replace("_deg", "(deg)"))
    operator.take()
    assert operator.child("name").text() == "second"
    operator.app_driver.click(operator.child("cancel"))
    assert operator.told() == (
        "Imported: first\nNot imported yet: second.csv. Press “Import by columns…”."
    )
    operator.app_driver.click(operator.enable_or_explain)
    operator.take()
    assert operator.told() == "Imported: second"
    assert {entry.name for entry in operator.library.entries()} == {"first", "second"}


def test_what_is_to_be_done_with_many_files_is_in_sight(operator):
    """The same is said once of all tables, and no message puts its buttons out of sight."""
    operator.app_driver.window.resize(1280, 800)
    beyond = Waypoint(MoveMode.MOVE_J, (0.0, 20.0, -30.0, 0.0, 200.0, 0.0))
    tables = {f"a_table_of_a_rather_long_name_{number}": DEGREES for number in range(5)}
    others = {
        f"good_{name}": files.to_bytes(Trajectory(f"good {name}", points=(beyond,)), ".csv")
        for name in "abcd"
    }
    operator.bring(**tables, **others)
    operator.app_driver.wait(lambda: "And 1 more" in operator.told())
    assert operator.told().count("Not imported") == 1
    assert "_4.csv. Press “Import by columns…”." in operator.told()
    button = operator.enable_or_explain
    whole = button.rect()
    operator.app_driver.wait(lambda: button.visibleRegion().boundingRect() == whole)


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
    operator.open(line=TITLED)
    operator.app_driver.click(operator.child("cancel"))
    (operator.folder / "line.csv").unlink()
    operator.app_driver.click(operator.enable_or_explain)
    assert "line.csv: The file cannot be read" in operator.told()
    assert not operator.enable_or_explain.isVisible()
    assert not is_open()


PEN = Tool("pen", (10.0, -5.0, 100.0, 15.0, -25.0, 40.0))
TABLE = UserFrame("Table", (250.0, -80.0, 40.0, 10.0, -20.0, 35.0))
POSES = "x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg\n300,0,250,0,85,0\n300,100,250,0,85,0\n"
TOLD = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)


def test_poses_are_of_the_tool_and_frame_in_force_unless_said_otherwise(operator):
    cell = operator.app_driver.controller.cell
    accepted(cell.take(with_part(with_part(Cell("bench"), PEN), TABLE)))
    operator.open(poses=POSES)
    assert operator.child("of").currentText() == "the tool “pen”"
    assert operator.child("in").currentText() == "in “Table”"
    operator.take()
    first, _ = operator.library.load("poses").points
    assert first.frame == "Table"
    off_mm, off_deg = apart(carried(first.target, PEN.pose), TOLD)
    assert off_mm < 1e-5
    assert off_deg < 1e-5


def test_poses_of_the_flange_in_the_base_stay_so_whatever_changes(operator):
    cell = operator.app_driver.controller.cell
    accepted(cell.take(with_part(with_part(Cell("bench"), PEN), TABLE)))
    operator.open(poses=POSES)
    operator.choose(operator.child("of"), "the flange")
    operator.choose(operator.child("in"), "in the base frame")
    operator.app_driver.store.change(language="zh")
    operator.app_driver.store.change(language="en")
    accepted(cell.change(replace(cell.cell, tool="")))
    accepted(cell.change(replace(cell.cell, tool="pen")))
    assert operator.child("of").currentText() == "the flange"
    operator.take()
    first, _ = operator.library.load("poses").points
    assert (first.target, first.frame) == (TOLD, "")


def test_joint_angles_and_a_bare_arm_ask_for_no_tool(operator):
    operator.open(poses=POSES)
    assert not operator.child("of").isVisible()
    operator.take()
    assert operator.library.load("poses").points[0].target == TOLD
    accepted(operator.app_driver.controller.cell.take(with_part(Cell("bench"), PEN)))
    operator.open(line=TITLED)
    assert not operator.child("of").isVisible()


def radians(titles, *more):
    row = "0.1,0.6,-0.7,0.2,0.3,-0.1"
    return f"{titles}\n" + "".join(f"{0.02 * k},{row}{''.join(more)}\n" for k in (1, 2, 4))


def test_titles_of_another_host_need_one_click_and_no_answer(operator):
    titles = ",".join(f"/joint_states/joint{joint}/position" for joint in range(1, 7))
    operator.open(run=radians(f"__time,{titles},/joint_states/gripper/position", ",0.05"))
    joints = [f"J{joint} rad" for joint in range(1, 7)]
    assert operator.columns() == ["Time s", *joints, "Gripper m"]
    assert operator.message() == ""
    assert not any(operator.child(unit).isVisible() for unit in ("radians", "degrees"))
    operator.take()
    kept = operator.library.load("run")
    assert kept.joints_deg[0, 1] == pytest.approx(math.degrees(0.6))
    assert kept.gripper_mm[0] == 50.0


def test_normalised_figures_are_not_taken_for_degrees_unless_somebody_says_so(operator):
    titles = ",".join(f"target_joint{joint}.pos" for joint in range(1, 7))
    rows = "".join(f"{k},{k},1.2,-88.1,96.0,0.2,10.1,{k}\n" for k in range(3))
    operator.open(run=f"timestamp,step,{titles}\n{rows}")
    assert operator.columns()[:3] == ["Time s", "-", "J1 °"]
    assert operator.message().startswith(
        "Column 5 holds 96°; J3 turns from -170° to 0°. "
        "Columns 3, 4, 5, 6, 7, 8 may be normalised figures"
    )
    assert not operator.child("import").isEnabled()
    assert not operator.child("radians").isVisible()
    operator.app_driver.click(operator.child("degrees"))
    assert operator.message() == ""
    operator.take()
    assert operator.library.load("run").joints_deg[0, 1] == -88.1


def test_what_no_joint_can_come_to_is_named_and_beyond_100_not_called_normalised(operator):
    operator.open(run="j1,j2,j3,j4,j5,j6\n" + "10,250,-60,-140,20,30\n10,60,-60,-20,20,30\n" * 2)
    assert operator.message().startswith(
        "Column 2 holds 250°; J2 turns from 0° to 180°. Columns 1, 2, 3, 4, 5, 6 may be another"
    )
    assert "normalised" not in operator.message()
    assert operator.child("degrees").isVisible()


def test_integers_are_read_in_the_unit_that_fits_or_asked_for(operator):
    titles = "t," + ",".join(f"joint_{joint}" for joint in range(1, 7))
    operator.open(run=f"{titles},gripper\n" + "1,12000,60000,-70000,0,0,500,50000\n" * 2)
    assert operator.columns() == ["Time s", *[f"J{n} 0.001°" for n in range(1, 7)], "Gripper µm"]
    assert operator.message() == ""
    operator.app_driver.click(operator.child("cancel"))
    operator.open(tenths=f"{titles}\n" + "1,120,600,-700,0,0,5\n2,120,600,-700,0,0,5\n")
    asked = "Columns 2, 3, 4, 5, 6, 7 may be in 0.1°, mrad, 0.001°: choose which."
    assert operator.message() == asked
    operator.app_driver.click(operator.child("milliradians"))
    operator.take()
    kept = operator.library.load("tenths").joints_deg[0]
    assert kept[:3] == pytest.approx([math.degrees(each) for each in (0.12, 0.6, -0.7)])


def test_way_points_of_another_host_are_imported_at_once(operator):
    place = "".join(f"  - {angle}\n" for angle in (0.1, 0.6, -0.7, 0.2, 0.3, -0.1))
    names = "".join(f"- joint{joint}\n" for joint in range(1, 7))
    operator.bring(taught=f"joint_names:\n{names}waypoints:\n- positions:\n{place}  hold_time: 2\n")
    assert not is_open()
    assert operator.told().startswith("Imported: taught")
    (point,) = operator.library.load("taught").points
    assert (point.move, point.dwell_s) == (MoveMode.MOVE_J, 2.0)


def test_commands_of_another_host_are_refused_with_what_to_do(operator):
    operator.bring(moves='[{"type": "Home"}, {"joints": [0.1, 0.6, -0.7, 0.2, 0.3, -0.1]}]')
    assert not is_open()
    assert "commands that only another program knows: Home. Write each place" in operator.told()
    assert not operator.enable_or_explain.isVisible()
