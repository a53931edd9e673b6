"""An operator makes a user frame by three points, and moves, types and reads in it."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from scipy.spatial.transform import Rotation

from armui.cell.user_frames import UserFrame
from armui.control.motion.jog_path import JointJog
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import AXES
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Waypoint
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, hold
from tests.family import PIPER
from tests.operator.editor.actions import Editor
from tests.operator.frame_actions import (
    PEN,
    PLACES,
    WORK,
    at_frames,
    by_points,
    choose,
    made,
    take,
    touch,
)


def tip_mm(driver):
    """Where the simulated arm's tip is in the base, by scipy."""
    flange = Kinematics(PIPER).forward(driver.firmware.joints_deg)
    turn = Rotation.from_euler("xyz", flange[3:], degrees=True)
    return np.array(flange[:3]) + turn.apply(PEN.pose[:3])


def in_work_mm(place_mm):
    """The same in the work."""
    return work().inv().apply(np.array(place_mm) - np.array(WORK[:3]))


def work():
    return Rotation.from_euler("xyz", WORK[3:], degrees=True)


def shown(driver, what="pose_measured"):
    return [float(driver.read(f"{what}_{axis}").rstrip(" m°")) for axis in AXES]


# Three points -------------------------------------------------------------------------------------


def test_each_sentence_leads_to_the_next_and_the_last_press_takes_it(app_driver):
    at_frames(app_driver)
    assert "Press By three points" in app_driver.read("cell_frame_next")
    app_driver.click("cell_frame_by_points")
    assert "what becomes the origin" in app_driver.read("frame_points_next")
    take(app_driver, 0)
    assert "what becomes the X axis" in app_driver.read("frame_points_next")
    touch(app_driver, PLACES[1])
    live = app_driver.read("frame_points_live")
    assert live == "60.0 mm from the origin; at least 20 mm are needed."
    app_driver.click("frame_take_2")
    assert "the side where +Y is to be" in app_driver.read("frame_points_next")
    live = app_driver.read("frame_points_live")  # the tip still stands on the X axis
    assert live == "0.0 mm and 0.0° off the X axis; at least 10° are needed."
    assert not app_driver.find("frame_points_add").isEnabled()
    take(app_driver, 2)
    assert "is Z as you want it?" in app_driver.read("frame_points_next")
    # the Z of RX 5°, RY −10°, RZ 60° is −0.011, −0.194, 0.981
    assert "Z points along X -0.01  Y -0.19  Z 0.98" in app_driver.read("frame_points_result")
    (mark,) = app_driver.window._view._frames
    assert (mark.name, mark.lit) == ("New frame", True)
    assert [1000.0 * mark.rows[place] for place in (3, 7, 11)] == pytest.approx(WORK[:3], abs=0.05)
    assert app_driver.controller.cell.cell.frames == ()
    app_driver.click("frame_points_add")
    (frame,) = app_driver.controller.cell.cell.frames
    assert (frame.name, app_driver.controller.cartesian.frame) == ("Frame 1", None)
    assert frame.pose == pytest.approx(WORK, abs=0.05)
    assert "“Frame 1” is added, and nothing else has changed" in app_driver.read(
        "frame_points_next"
    )
    choose(app_driver, "cell_frame", 1)
    assert app_driver.controller.cartesian.frame == frame
    assert "“Frame 1” is in force" in app_driver.read("frame_points_next")
    (mark,) = app_driver.window._view._frames
    assert (mark.name, mark.lit) == ("Frame 1", True)


def test_what_is_found_is_no_longer_in_the_picture_once_the_tab_is_left(app_driver):
    by_points(app_driver)
    app_driver.click("menu_motion")
    assert app_driver.window._view._frames == ()
    app_driver.click("menu_cell")
    assert [each.name for each in app_driver.window._view._frames] == ["New frame"]
    app_driver.click("frame_points_restart")
    assert app_driver.window._view._frames == ()


def test_points_in_line_are_refused_with_figures_and_one_is_taken_again(app_driver):
    at_frames(app_driver)
    app_driver.click("cell_frame_by_points")
    take(app_driver, 0, 1)
    touch(app_driver, (100.0, 8.0, 0.0))
    app_driver.click("frame_take_3")
    said = app_driver.read("frame_points_next")
    assert "4.6° off the X axis, at least 10° are needed" in said
    assert said == app_driver.find("frame_points_add").toolTip()
    take(app_driver, 2)
    assert "is Z as you want it?" in app_driver.read("frame_points_next")
    touch(app_driver, (3.0, 4.0, 0.0))
    app_driver.click("frame_take_2")
    assert "The point for +X is 5 mm from the origin" in app_driver.read("frame_points_next")


def test_a_point_on_x_too_near_is_told_before_the_next_is_asked_for(app_driver):
    at_frames(app_driver)
    app_driver.click("cell_frame_by_points")
    take(app_driver, 0)
    app_driver.click("frame_take_2")  # the tip still stands on the origin
    said = app_driver.read("frame_points_next")
    assert said.startswith("The point for +X is 0 mm from the origin; at least 20 mm")
    live = app_driver.read("frame_points_live")
    assert live == "0.0 mm from the origin; at least 20 mm are needed."
    take(app_driver, 1)
    assert "the side where +Y is to be" in app_driver.read("frame_points_next")


def test_a_point_is_not_taken_while_the_arm_moves(app_driver):
    at_frames(app_driver)
    app_driver.click("cell_frame_by_points")
    accepted(app_driver.controller.jogging.start(JointJog(1, 1)))
    app_driver.run(0.3)
    assert not app_driver.find("frame_take_1").isEnabled()
    assert "not at rest" in app_driver.find("frame_take_1").toolTip()
    app_driver.controller.jogging.stop()
    app_driver.run_until(app_driver.find("frame_take_1").isEnabled)


def test_points_of_another_tool_are_forgotten(app_driver):
    by_points(app_driver)
    app_driver.click("cell_tab_tools")
    choose(app_driver, "cell_tool", 0)
    app_driver.click("cell_tab_frames")
    assert "what becomes the origin" in app_driver.read("frame_points_next")
    assert app_driver.read("frame_place_1") == "—"


def test_the_chosen_frame_is_taught_anew(app_driver):
    made(app_driver)
    app_driver.click("frame_points_restart")
    take(app_driver, 0)
    for number, place in ((2, (0.0, 60.0, 0.0)), (3, (-45.0, 25.0, 0.0))):
        touch(app_driver, place)
        app_driver.click(f"frame_take_{number}")
    assert "Points of trajectories that belong to it move" in (
        app_driver.find("frame_points_apply").toolTip()
    )
    app_driver.click("frame_points_apply")
    (frame,) = app_driver.controller.cell.cell.frames
    turned = work() * Rotation.from_euler("z", 90.0, degrees=True)
    found = Rotation.from_euler("xyz", frame.pose[3:], degrees=True)
    assert (found.inv() * turned).magnitude() < np.radians(0.1)


# Typed --------------------------------------------------------------------------------------------


def test_a_frame_is_typed_renamed_taken_from_the_tool_and_deleted(app_driver):
    at_frames(app_driver)
    for axis, figure in zip(AXES, ("300", "0", "50", "0", "0", "90"), strict=True):
        app_driver.type_into(f"cell_frame_{axis}", figure)
    app_driver.type_into("cell_frame_name", "jig")
    assert "Press Add" in app_driver.read("cell_frame_next")
    app_driver.click("cell_frame_add")
    cells = app_driver.controller.cell
    assert cells.cell.frames == (UserFrame("jig", (300.0, 0.0, 50.0, 0.0, 0.0, 90.0)),)
    said = app_driver.read("cell_frame_next")
    assert "“jig” is added, and nothing else has changed. Choose it under" in said
    assert cells.cell.frame == ""
    choose(app_driver, "cell_frame", 1)
    assert cells.cell.frame == "jig"
    app_driver.type_into("cell_frame_name", "table")
    app_driver.click("cell_frame_apply")
    assert (cells.cell.frame, cells.cell.frames[0].name) == ("table", "table")
    app_driver.click("cell_frame_here")
    app_driver.click("cell_frame_apply")
    assert cells.cell.frames[0].pose[:3] == pytest.approx(tip_mm(app_driver), abs=0.01)
    app_driver.type_into("cell_frame_X", "5001")
    app_driver.click("cell_frame_apply")
    assert "“table”, x_mm: 5001 is not possible" in app_driver.read("cell_message")
    app_driver.click("cell_frame_delete")
    assert (cells.cell.frames, cells.cell.frame) == ((), "")


# In force -----------------------------------------------------------------------------------------


@pytest.fixture
def moved(app_driver):
    """A frame by three points is in force, and 末端控制 is open."""
    made(app_driver)
    app_driver.click("menu_cartesian")
    app_driver.run(0.3)
    return app_driver


def test_what_is_measured_is_shown_in_the_frame_and_names_it(moved):
    assert moved.find("shown_frame_box").currentText() == "in “Frame 1”"
    assert shown(moved)[:3] == pytest.approx(PLACES[2], abs=0.1)
    assert shown(moved, "pose_field") == pytest.approx(shown(moved), abs=0.002)
    hud = moved.window._view._hud
    assert hud.point == "Tool centre point in “Frame 1”"
    assert hud.pose == pytest.approx(shown(moved), abs=0.002)
    view = moved.window._view
    assert view.quantities_at(QPoint(40, 52)) == []  # curves are always in the base
    choose(moved, "shown_frame_box", 0)
    assert shown(moved)[:3] == pytest.approx(tip_mm(moved), abs=0.01)
    assert hud.point != moved.window._view._hud.point == "Tool centre point"
    assert view.quantities_at(QPoint(40, 52)) == ["arm.tool_x"]


@pytest.mark.parametrize("button", ["move_p_button", "move_l_button"])
def test_a_typed_target_lands_where_the_frame_has_it(moved, button):
    for axis, figure in zip("XYZ", ("40", "10", "30"), strict=True):
        moved.type_into(f"pose_field_{axis}", figure)
    moved.click(button)
    assert "(base) to X" in moved.read("notice_label")
    moved.come_to_rest()
    expected = np.array(WORK[:3]) + work().apply((40.0, 10.0, 30.0))
    assert tip_mm(moved) == pytest.approx(expected, abs=0.1)
    assert shown(moved)[:3] == pytest.approx((40.0, 10.0, 30.0), abs=0.01)


def test_a_step_and_a_held_jog_go_along_the_frame(moved):
    before = in_work_mm(tip_mm(moved))
    moved.click("frame_user")
    choose(moved, "tool_step", moved.find("tool_step").findData(5.0))
    moved.click("pose_plus_Z")
    moved.come_to_rest()
    after = in_work_mm(tip_mm(moved))
    assert after - before == pytest.approx((0.0, 0.0, 5.0), abs=0.05)
    choose(moved, "tool_step", moved.find("tool_step").count() - 1)
    QTest.mousePress(moved.find("pose_minus_X"), Qt.MouseButton.LeftButton)
    hold(moved, 0.6)
    QTest.mouseRelease(moved.find("pose_minus_X"), Qt.MouseButton.LeftButton)
    moved.come_to_rest()
    gone = in_work_mm(tip_mm(moved)) - after
    assert gone[0] < -5.0
    assert gone[1:] == pytest.approx((0.0, 0.0), abs=0.1)


def test_the_base_and_the_tool_stay_where_they_were(moved):
    before = tip_mm(moved)
    moved.click("frame_base")
    choose(moved, "tool_step", moved.find("tool_step").findData(5.0))
    moved.click("pose_plus_X")
    moved.come_to_rest()
    assert tip_mm(moved) - before == pytest.approx((5.0, 0.0, 0.0), abs=0.05)


def test_a_target_typed_in_another_frame_is_cleared_and_never_another_place(moved):
    moved.type_into("pose_field_X", "33")
    choose(moved, "shown_frame_box", 0)
    assert float(moved.read("pose_field_X")) == pytest.approx(tip_mm(moved)[0], abs=0.01)
    moved.type_into("pose_field_X", "400")
    choose(moved, "shown_frame_box", 1)
    assert float(moved.read("pose_field_X")) == pytest.approx(PLACES[2][0], abs=0.1)
    moved.type_into("pose_field_X", "33")
    moved.controller.cell.forget_arm()
    flange = Kinematics(PIPER).forward(moved.firmware.joints_deg)  # the tool is not in force
    assert float(moved.read("pose_field_X")) == pytest.approx(flange[0], abs=0.01)
    assert moved.find("shown_frame_box").currentText() == "in the base frame"


def test_captured_poses_of_an_arc_stay_the_same_places(moved):
    moved.click("capture_start")
    x, y, z = (round(each) + 0.0 for each in PLACES[2])
    assert moved.read("captured_start") == f"{x:.0f} {y:.0f} {z:.0f} mm"
    choose(moved, "shown_frame_box", 0)
    x, y, z = tip_mm(moved)
    assert moved.read("captured_start") == f"{x:.0f} {y:.0f} {z:.0f} mm"
    moved.click("arc_start_button")
    moved.come_to_rest()
    assert tip_mm(moved) == pytest.approx((x, y, z), abs=0.05)


def test_without_a_frame_its_button_says_what_to_do(app_driver):
    app_driver.ready()
    app_driver.click("menu_cartesian")
    button = app_driver.find("frame_user")
    assert not button.isEnabled()
    assert "Choose one under Cell" in button.toolTip()
    assert app_driver.find("shown_frame_box").currentText() == "in the base frame"
    app_driver.click(Editor(app_driver, Waypoint(MoveMode.MOVE_J, BENT_DEG)).child("editor_jog"))
    insert = app_driver.find("box_insert").geometry()
    assert app_driver.read("box_frame") == ""
    app_driver.click("box_tool")
    assert app_driver.read("box_frame") == "in the base", "it moves by other axes than it shows"
    assert app_driver.find("box_insert").geometry() == insert


def test_the_jog_box_of_the_editor_names_the_frame_and_goes_along_it(moved):
    moved.click(Editor(moved, Waypoint(MoveMode.MOVE_J, BENT_DEG)).child("editor_jog"))
    assert moved.read("box_frame") == ""
    gripper = moved.find("box_gripper").geometry()
    moved.click("box_user")
    assert moved.read("box_frame") == "figures in “Frame 1”"
    measured = [float(moved.read(f"box_measured_{number}").rstrip(" m°")) for number in (1, 2, 3)]
    assert measured == pytest.approx(PLACES[2], abs=0.1)
    before = in_work_mm(tip_mm(moved))
    choose(moved, "box_step_mm", moved.find("box_step_mm").findData(5.0))
    moved.click("box_plus_2")
    moved.come_to_rest()
    gone = in_work_mm(tip_mm(moved)) - before
    assert gone == pytest.approx((0.0, 5.0, 0.0), abs=0.05)
    moved.controller.cell.forget_arm()
    moved.click("box_plus_2")
    moved.run(0.3)
    assert in_work_mm(tip_mm(moved)) - before == pytest.approx(gone, abs=0.01)
    assert not moved.find("box_user").isEnabled()
    assert moved.find("box_gripper").geometry() == gripper
