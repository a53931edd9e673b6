"""The arm beside the table: its measured pose is taken over, and it goes to a point."""

import math

import pytest
from PySide6.QtCore import Qt

from armui.trajectory.points.program import GripperOpening
from tests.operator.editor.actions import BACK, CTRL, OUT, Editor, to


def test_the_current_pose_without_an_arm_is_refused(editor):
    editor.act("insert_measured")
    assert len(editor.points) == 3
    assert "No arm is connected" in editor.message()


def test_the_current_pose_is_the_measured_one(app_driver):
    editor = Editor(app_driver, to(OUT))
    app_driver.ready()
    app_driver.controller.motion.send_joints(BACK)
    app_driver.run_until(lambda: math.dist(app_driver.firmware.joints_deg, BACK) < 1e-3)
    app_driver.run(0.2)
    editor.choose(0)
    editor.act("insert_measured")
    assert editor.points[1].target == pytest.approx(BACK, abs=1e-3)
    editor.choose(0)
    editor.act("replace_by_measured")
    assert editor.points[0].target == pytest.approx(BACK, abs=1e-3)


def test_the_arm_goes_to_the_point(app_driver):
    editor = Editor(app_driver, to(OUT), to(BACK))
    app_driver.ready()
    editor.choose(1)
    editor.keys(Qt.Key.Key_G, CTRL)
    app_driver.run_until(lambda: math.dist(app_driver.firmware.joints_deg, BACK) < 0.01)


def test_the_arm_goes_to_a_pose(app_driver):
    editor = Editor(app_driver, to(OUT), to(BACK))
    app_driver.ready()
    editor.choose(0)
    editor.keys(Qt.Key.Key_K, CTRL | Qt.KeyboardModifier.ShiftModifier)
    editor.act("go_to")
    app_driver.run_until(lambda: math.dist(app_driver.firmware.joints_deg, OUT) < 0.05)


def test_a_motor_that_is_off_is_told(app_driver):
    editor = Editor(app_driver, to(OUT))
    app_driver.connect()
    editor.act("go_to")
    assert "enable" in editor.message().lower()


def gripper_frames(app_driver):
    return [frame.data.hex() for frame in app_driver.heard() if frame.arbitration_id == 0x159]


def test_the_gripper_is_opened_and_closed_beside_the_jog_and_inserted_as_measured(app_driver):
    editor = Editor(app_driver, to(OUT))
    app_driver.ready()
    editor.click("editor_jog")
    editor.click("box_gripper")
    app_driver.run_until(editor.child("box_gripper_open").isEnabled)  # the stroke was read: 70 mm
    app_driver.heard()
    app_driver.click(editor.child("box_gripper_open"))
    app_driver.run(0.1)
    assert gripper_frames(app_driver) == ["0001117003e80100"]
    app_driver.run(2.0)
    assert editor.child("box_gripper_measured").text() == "70.000 mm"
    app_driver.click(editor.child("box_insert"))
    assert editor.points[-1].gripper is None
    app_driver.click(editor.child("box_gripper_inserted"))
    app_driver.click(editor.child("box_insert"))
    assert [each.gripper for each in editor.points if each.gripper] == [GripperOpening(70.0, 1.0)]
    app_driver.click(editor.child("box_gripper_close"))
    app_driver.run(2.0)
    assert gripper_frames(app_driver) == ["0000000003e80100"]


def test_without_a_gripper_nothing_is_inserted(app_driver):
    editor = Editor(app_driver, to(OUT))
    app_driver.ready()
    editor.click("editor_jog")
    editor.click("box_gripper")
    app_driver.click(editor.child("box_gripper_inserted"))
    app_driver.node.link.mute_on.add(0x2A8)
    app_driver.run(1.0)
    app_driver.click(editor.child("box_insert"))
    assert len(editor.points) == 1
    assert "No gripper is heard" in editor.message()
    assert not editor.child("box_gripper_open").isEnabled()
