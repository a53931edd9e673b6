"""An operator at 末端控制 of the main window: bytes at the arm, where the tool then is, words."""

import errno
import math

import can
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.link.link_state import LinkState
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.axes import AXES
from armui.kinematics.poses import Pose, pose_to_matrix, tool_pose
from armui.protocol.frame import Frame
from tests.control.jogger import BENT_DEG, bend, hold, rest_s
from tests.family import PIPER
from tests.generations import ONE_IS_ENOUGH

BENT_POSE = Kinematics(PIPER).forward(BENT_DEG)


def flange(app_driver) -> Pose:
    return Kinematics(PIPER).forward(app_driver.firmware.joints_deg)


def fields(app_driver):
    return [app_driver.read(f"pose_field_{name}") for name in AXES]


def apart_mm(app_driver, pose):
    return math.dist(flange(app_driver)[:3], pose[:3])


@pytest.fixture
def bent(any_driver):
    """At a comfortable pose, enabled, at 100 %, the panel open."""
    any_driver.window.activateWindow()
    bend(any_driver)
    any_driver.click("menu_cartesian")
    any_driver.step()
    any_driver.heard()
    return any_driver


def arm_hears(app_driver):
    """The frames of the last order: the pose in 0.001 mm and 0.001°, then 0x151."""
    frames = []
    while (message := app_driver._ear.recv(0)) is not None:
        if message.arbitration_id in {0x151, 0x152, 0x153, 0x154, 0x158}:
            frames.append(Frame(message.arbitration_id, bytes(message.data)))
    return frames


@ONE_IS_ENOUGH
def test_the_measured_pose_is_shown_and_fills_the_fields(bent):
    for name, value in zip(AXES, BENT_POSE, strict=True):
        assert float(bent.read(f"pose_field_{name}")) == pytest.approx(value, abs=0.002)
        assert float(bent.read(f"pose_measured_{name}").rstrip(" m°")) == pytest.approx(
            value, abs=0.002
        )
    assert bent.read("point_label") == "Flange (no tool set)"
    assert arm_hears(bent) == []


@pytest.mark.parametrize(("button", "mode"), [("move_p_button", "00"), ("move_l_button", "02")])
def test_a_pose_is_sent_and_reached(bent, button, mode):
    bent.type_into("pose_field_X", "300")
    bent.type_into("pose_field_Y", "20")
    arm_hears(bent)
    bent.click(button)
    bent.step()
    frames = arm_hears(bent)
    # 300 mm = 300,000 steps = 0x000493E0; 20 mm = 0x00004E20
    assert frames[0] == Frame(0x152, bytes.fromhex("00 04 93 E0 00 00 4E 20"))
    assert [frame.arbitration_id for frame in frames] == [0x152, 0x153, 0x154, 0x151]
    assert frames[-1].data[:3] == bytes.fromhex(f"01 {mode} 64")
    assert "Sent MOVE" in bent.read("notice_label")
    bent.come_to_rest()
    target = (300.0, 20.0, *flange(bent)[2:])
    assert apart_mm(bent, target) < 0.01
    assert flange(bent)[3:] == pytest.approx(BENT_POSE[3:], abs=0.01)
    assert bent.read("pose_measured_X") == "300.000 mm"


@ONE_IS_ENOUGH
def test_out_of_reach_is_refused_and_says_by_how_much(bent):
    bent.type_into("pose_field_X", "900")
    bent.click("move_p_button")
    bent.run(0.1)
    assert arm_hears(bent) == []
    assert "mm out of the arm's reach" in bent.read("pose_message")
    missing = float(bent.read("pose_message").split(" mm")[0].split()[-1])
    wrist = pose_to_matrix(Pose(900.0, *BENT_POSE[1:]))
    centre = wrist[:3, 3] - 91.0 * wrist[:3, 2] - (0.0, 0.0, 123.0)
    reach = 285.03 + math.hypot(250.75, 21.98)
    assert missing == pytest.approx(math.hypot(*centre) - reach, abs=0.1)
    assert "Not sent" in bent.read("notice_label")


@ONE_IS_ENOUGH
def test_a_typed_target_is_marked_until_the_arm_is_there(bent):
    def marked():
        return [name for name in AXES if bent.find(f"pose_field_{name}").property("typed")]

    assert marked() == []
    bent.type_into("pose_field_Y", "520")
    bent.click("move_p_button")
    bent.run(0.2)
    assert bent.read("pose_field_Y").startswith("520")
    assert marked() == ["Y"]
    bent.type_into("pose_field_Y", "20")
    bent.click("move_p_button")
    bent.come_to_rest()
    assert marked() == []
    bent.type_into("pose_field_X", "900")
    bent.click("load_pose_button")
    assert marked() == []


@ONE_IS_ENOUGH
def test_beyond_a_limit_names_the_joint_and_the_limit(bent):
    bent.type_into("pose_field_X", "-200")
    bent.type_into("pose_field_Y", "-20")
    bent.click("move_p_button")
    bent.run(0.1)
    assert arm_hears(bent) == []
    assert "beyond its limits of" in bent.read("pose_message")


@ONE_IS_ENOUGH
def test_a_line_is_looked_at_over_its_whole_length(bent):
    bent.type_into("pose_field_Y", "-250")
    bent.type_into("pose_field_X", "-120")
    bent.click("move_l_button")
    bent.run(0.1)
    assert arm_hears(bent) == []
    assert "of the way" in bent.read("pose_message") or "limits" in bent.read("pose_message")


@ONE_IS_ENOUGH
def test_what_is_no_figure_is_marked_and_not_sent(bent):
    bent.type_into("pose_field_RX", "abc")
    bent.click("move_p_button")
    assert arm_hears(bent) == []
    assert "RX: “abc”" in bent.read("pose_message")
    bent.click("load_pose_button")
    assert bent.read("pose_message") == ""


@ONE_IS_ENOUGH
def test_a_step_along_the_base_and_one_along_the_tool(bent):
    bent.find("tool_step").setCurrentIndex(3)
    bent.click("pose_plus_Z")
    bent.come_to_rest()
    assert flange(bent)[2] == pytest.approx(BENT_POSE[2] + 10.0, abs=0.01)
    assert apart_mm(bent, (*BENT_POSE[:2], BENT_POSE[2] + 10.0)) < 0.01
    start = pose_to_matrix(flange(bent))
    bent.click("frame_tool")
    bent.click("pose_minus_Z")
    bent.come_to_rest()
    assert apart_mm(bent, start[:3, 3] - 10.0 * start[:3, 2]) < 0.01


@ONE_IS_ENOUGH
def test_two_steps_at_once_add_up(bent):
    bent.find("tool_step").setCurrentIndex(3)
    bent.click("pose_plus_Y")
    bent.click("pose_plus_Y")
    bent.come_to_rest()
    assert flange(bent)[1] == pytest.approx(BENT_POSE[1] + 20.0, abs=0.02)


def test_holding_moves_straight_and_letting_go_stops(bent):
    box = bent.find("tool_step")
    box.setCurrentIndex(box.count() - 1)
    button = bent.find("pose_minus_Z")
    button.setFocus()
    bent.press(button)
    for _ in range(5):
        hold(bent, 0.1)
        x, y, z, *_ = flange(bent)
        assert (x, y) == pytest.approx(BENT_POSE[:2], abs=0.1)  # on the way as well
    assert z < BENT_POSE[2] - 10.0
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    assert rest_s(bent) <= 0.1


@ONE_IS_ENOUGH
def test_keys_jog_the_tool(bent):
    box = bent.find("tool_step")
    box.setCurrentIndex(box.count() - 1)
    bent.click("tool_keys_button")
    pad = bent.find("tool_key_pad")
    QTest.keyPress(pad, Qt.Key.Key_Space)
    QTest.keyPress(pad, Qt.Key.Key_PageUp)
    hold(bent, 0.3)
    assert flange(bent)[2] > BENT_POSE[2] + 3.0
    QTest.keyRelease(pad, Qt.Key.Key_Space)
    assert rest_s(bent) <= 0.1


@ONE_IS_ENOUGH
def test_with_a_tool_the_panel_speaks_of_its_tip_and_the_arm_of_its_flange(bent):
    bent.type_into("tool_field_Z", "80")
    assert bent.read("point_label") == "Tool centre point"
    assert bent.store.settings.tool == (0.0, 0.0, 80.0, 0.0, 0.0, 0.0)
    tip = tool_pose(BENT_POSE, (0, 0, 80, 0, 0, 0))
    assert [float(text) for text in fields(bent)] == pytest.approx(list(tip), abs=0.002)
    bent.type_into("pose_field_Z", f"{tip[2] - 15:.3f}")
    bent.click("move_l_button")
    bent.come_to_rest()
    assert flange(bent)[2] == pytest.approx(BENT_POSE[2] - 15, abs=0.01)
    assert flange(bent)[:2] == pytest.approx(BENT_POSE[:2], abs=0.01)


@ONE_IS_ENOUGH
def test_a_tool_that_cannot_be_is_refused(bent):
    bent.type_into("tool_field_X", "700")
    assert "Tool centre point: 700" in bent.read("pose_message")
    assert bent.store.settings.tool == (0.0,) * 6
    assert bent.find("tool_field_X").property("attention")


def capture(app_driver, point, angles_deg):
    app_driver.controller.motion.send_joints(angles_deg)
    app_driver.come_to_rest()
    app_driver.run_until(lambda: app_driver.find(f"capture_{point}").isEnabled())
    app_driver.click(f"capture_{point}")


def test_an_arc_through_three_captured_poses(bent):
    start, along = bent.find("arc_start_button"), bent.find("move_c_button")
    assert "Not captured yet: start" in start.toolTip()
    capture(bent, "start", BENT_DEG)
    capture(bent, "middle", (25.0, *BENT_DEG[1:]))
    assert (start.isEnabled(), along.isEnabled()) == (True, False)
    assert "Not captured yet: end" in along.toolTip()
    capture(bent, "end", (40.0, *BENT_DEG[1:]))
    arm_hears(bent)
    bent.click("move_c_button")
    bent.step()
    assert arm_hears(bent) == []
    assert "away from the start of the arc" in bent.read("pose_message")
    bent.click("arc_start_button")
    bent.come_to_rest()
    arm_hears(bent)
    bent.click("move_c_button")
    bent.step()
    frames = arm_hears(bent)
    points = [frame.data[0] for frame in frames if frame.arbitration_id == 0x158]
    assert points == [1, 2, 3]
    assert frames[-1].data[:3] == bytes.fromhex("01 03 64")
    bent.come_to_rest()
    assert bent.firmware.joints_deg == pytest.approx((40.0, *BENT_DEG[1:]), abs=0.02)


@ONE_IS_ENOUGH
def test_three_poses_in_one_place_are_no_arc(bent):
    for point in ("start", "middle", "end"):
        bent.click(f"capture_{point}")
    bent.click("move_c_button")
    assert "that is no arc" in bent.read("pose_message")
    assert arm_hears(bent) == []


def test_what_the_arm_itself_refuses_is_shown(bent):
    bent.firmware.settings.limits[0] = bent.firmware.settings.limits[0].__class__(-5.0, 15.0, 170.0)
    bent.type_into("pose_field_X", "150")
    bent.type_into("pose_field_Y", "200")
    bent.click("move_p_button")
    bent.run(0.3)
    assert "The arm itself refuses" in bent.read("pose_message")


@ONE_IS_ENOUGH
def test_an_arm_in_emergency_stop_gets_no_pose(bent):
    bent.controller.emergency_stop()
    bent.run_until(lambda: "stop_confirmed" in bent.codes())
    bent.step()
    for name in ("move_p_button", "move_l_button", "move_c_button", "pose_plus_X"):
        assert not bent.find(name).isEnabled()
        assert "emergency stop" in bent.find(name).toolTip()
    assert bent.read("pose_message") == ""  # the line above the panels says it


@ONE_IS_ENOUGH
def test_a_link_lost_half_way_ends_a_jog_and_is_said(bent):
    box = bent.find("tool_step")
    box.setCurrentIndex(box.count() - 1)
    button = bent.find("pose_plus_Z")
    button.setFocus()
    bent.press(button)
    hold(bent, 0.2)
    bent.unplug(can.CanOperationError("gone", error_code=errno.ENODEV))
    assert rest_s(bent) <= 0.1
    bent.wait(lambda: "link_lost" in bent.codes())
    assert not bent.controller.jogging.active
    assert "gone" in bent.read("recovery_text")
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    before = bent.firmware.joints_deg
    bent.plug_in()
    bent.wait(lambda: "reconnected" in bent.codes())
    bent.run_until(lambda: bent.controller.operating_state.cannot_move is None)
    bent.run(0.3)
    assert bent.firmware.joints_deg == before


@ONE_IS_ENOUGH
def test_the_fields_go_along_with_a_step_until_something_is_typed(bent):
    bent.find("tool_step").setCurrentIndex(3)
    bent.click("pose_plus_Z")
    bent.come_to_rest()
    assert float(bent.read("pose_field_Z")) == pytest.approx(BENT_POSE[2] + 10.0, abs=0.01)
    bent.type_into("pose_field_Z", "250")
    bent.run(0.2)
    assert bent.read("pose_field_Z") == "250.000"


@ONE_IS_ENOUGH
@pytest.mark.parametrize("way", ["load", "escape"])
def test_a_target_that_nobody_typed_goes_along_with_a_motion_from_elsewhere(bent, way):
    if way == "load":
        bent.type_into("pose_field_X", "300")
        bent.click("load_pose_button")
    else:
        field = bent.find("pose_field_X")
        field.setFocus()
        QTest.keyClick(field, Qt.Key.Key_5)
        QTest.keyClick(field, Qt.Key.Key_Escape)
    before = bent.read("pose_field_X")
    bent.controller.motion.send_joints((-20.0, *BENT_DEG[1:]))
    bent.come_to_rest()
    bent.run(0.2)
    assert bent.read("pose_field_X") != before
    assert f"{bent.read('pose_field_X')} mm" == bent.read("pose_measured_X")
    assert not bent.find("move_p_button").property("primary")
    bent.type_into("pose_field_X", "230")
    assert bent.find("move_p_button").property("primary")


@ONE_IS_ENOUGH
def test_a_pose_that_is_no_longer_heard_is_not_captured(bent):
    bent.powered = False
    bent.run_until(lambda: bent.controller.operating_state.link is LinkState.OFFLINE)
    for name in ("capture_start", "load_pose_button"):
        assert not bent.find(name).isEnabled()
        assert "nothing is heard from the arm" in bent.find(name).toolTip()
    bent.click("menu_motion")
    assert not bent.find("load_button").isEnabled()
    bent.powered = True
    bent.run_until(lambda: bent.find("load_button").isEnabled())


@ONE_IS_ENOUGH
def test_a_pose_of_an_arm_that_says_the_rest_is_not_captured(bent):
    bent.node.link.lose_to_bus(0x2A3, 1000)
    bent.run(1.0)
    bent.click("capture_start")
    assert "The pose is not heard any more" in bent.find("capture_start").toolTip()
    assert bent.read("captured_start") == "—"


@ONE_IS_ENOUGH
def test_a_pose_that_swings_by_is_not_captured(bent):
    bent.controller.motion.send_joints((25.0, *BENT_DEG[1:]))
    bent.run(0.4)
    bent.click("capture_start")
    assert "not at rest" in bent.find("capture_start").toolTip()
    assert bent.read("captured_start") == "—"
    bent.come_to_rest()
    bent.run_until(lambda: bent.find("capture_start").isEnabled())
    bent.click("capture_start")
    assert bent.read("captured_start") != "—"
