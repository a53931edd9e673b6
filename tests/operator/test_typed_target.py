"""An operator types a target and sees it in the picture before anything is sent."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.arm.refusal import Refusal
from armui.control.events import Event
from armui.system.paths import URDF
from armui.ui import words
from armui.viewport.palette import LIGHT
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.strokes import joint_range
from tests.accepted import accepted
from tests.cell.areas import gap_mm, put, wall
from tests.picture_hand import Hand

OUT = (20.0, 60.0, -70.0, 10.0, 35.0, 15.0)
POSE = {"X": 300.0, "Y": 40.0, "Z": 250.0, "RX": 0.0, "RY": 85.0, "RZ": 0.0}
MOTION_FRAMES = {*range(0x150, 0x160)} - {0x15A, 0x15F}
INTO_ITSELF = (-12.0, 83.0, -3.0, 32.0, 40.0, 70.0)
BELOW = (10.0, 125.0, -60.0, 15.0, 40.0, 20.0)
PREVIEW = "Preview of the target: it has not been sent"


@pytest.fixture(scope="module")
def shape():
    return shape_of(load_robot(URDF / "piper" / "piper.urdf"))


@pytest.fixture
def at(app_driver, shape):
    """Before the picture, without handles."""
    return Hand(app_driver, shape, kind=None)


@pytest.fixture
def no_motion(at):
    """Nothing that moves the arm was sent while targets were typed."""
    at.app_driver.heard()
    yield
    sent = [each for each in at.app_driver.heard() if each.arbitration_id in MOTION_FRAMES]
    assert sent == []


def type_joints(at, angles_deg=OUT):
    for joint, angle_deg in enumerate(angles_deg, start=1):
        at.app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")
    at.look()


def type_pose(at, **changed):
    at.app_driver.click("menu_cartesian")
    at.app_driver.run(0.2)
    for axis, value in {**POSE, **changed}.items():
        at.app_driver.type_into(f"pose_field_{axis}", f"{value}")
    at.look()


def note(at):
    line = at.app_driver.find("picture_note")
    return line.text() if line.isVisible() else ""


def nothing_is_previewed(at):
    at.look()
    return not at.ghost and note(at) == ""


def let_arrive(at):
    controller = at.app_driver.controller
    at.app_driver.run_until(lambda: not controller.operating_state.moving, seconds=30.0)
    at.look()


@pytest.mark.usefixtures("no_motion")
def test_a_typed_joint_target_has_a_ghost_and_a_needle_and_the_arm_stays(at):
    assert nothing_is_previewed(at)
    type_joints(at)
    assert at.ghost == pytest.approx(OUT)
    assert note(at) == PREVIEW
    at.app_driver.run(0.5)
    assert at.app_driver.firmware.joints_deg == pytest.approx((0.0,) * 6, abs=0.1)
    assert at.view._state.angles_deg == pytest.approx((0.0,) * 6, abs=0.1)  # as measured
    slider = at.app_driver.find("target_slider_2")
    assert slider.requested == pytest.approx(60.0)
    assert slider.measured == pytest.approx(0.0, abs=0.1)


@pytest.mark.usefixtures("no_motion")
def test_a_target_in_which_the_arm_would_touch_itself_is_told_before_it_is_sent(at):
    type_joints(at, INTO_ITSELF)
    assert at.ghost == pytest.approx(INTO_ITSELF)
    assert "would hit itself" in note(at)
    at.app_driver.click("send_button")
    assert "would hit itself" in at.app_driver.read("motion_message")
    at.look()
    assert "would hit itself" not in note(at)


@pytest.mark.usefixtures("no_motion")
def test_a_target_below_the_floor_is_told_before_it_is_sent(at):
    type_joints(at, BELOW)
    assert at.ghost == pytest.approx(BELOW)
    assert "come some 10" in note(at)
    type_joints(at)
    assert note(at) == PREVIEW


def test_what_was_sent_is_no_preview_any_more(at):
    type_joints(at)
    at.app_driver.click("send_button")
    assert nothing_is_previewed(at)
    at.app_driver.run(0.5)
    at.look()
    assert not at.ghost
    let_arrive(at)
    assert not at.ghost
    assert at.app_driver.controller.state.angles_deg() == pytest.approx(OUT, abs=0.1)


@pytest.mark.usefixtures("no_motion")
def test_the_ghost_goes_with_the_panel_and_with_the_figure(at):
    type_joints(at)
    at.app_driver.click("menu_light")
    assert nothing_is_previewed(at)
    at.app_driver.click("menu_motion")
    at.look()
    assert at.ghost == pytest.approx(OUT)
    at.app_driver.type_into("target_field_1", "-33")
    at.look()
    assert at.ghost == pytest.approx((-33.0, *OUT[1:]))
    at.app_driver.click("load_button")  # where the arm is: a ghost would be one with it
    assert nothing_is_previewed(at)


def finding(at):
    at.look()
    return at.view._state.preview.finding


@pytest.mark.parametrize("motion", ["typed", "step", "pose"])
def test_a_refused_motion_shows_where_the_arm_would_touch_until_the_next_press(at, motion):
    driver, told = at.app_driver, list[Event]()
    controller = driver.controller
    controller.noticed.connect(told.append)
    type_joints(at)
    driver.click("send_button")
    driver.run(0.5)
    let_arrive(at)
    stands_deg = controller.state.angles_deg()
    wall_mm = 1000.0 - gap_mm(stands_deg, wall(1000.0)) + 40.0
    put(controller, wall(wall_mm))
    if motion == "typed":
        type_joints(at, (20.0, 100.0, *OUT[2:]))
        driver.click("send_button")
    elif motion == "step":
        controller.motion.jog(2, 40.0)
    else:
        driver.click("menu_cartesian")
        driver.run(0.2)
        x = controller.cartesian.tool_pose(controller.state)[0]
        driver.type_into("pose_field_X", f"{x + 80.0:.1f}")
        driver.click("move_p_button")
    driver.run(0.3)
    (refused,) = (each for each in told if each.code == "refused")
    reason, mark = refused.params["reason"], finding(at)
    assert isinstance(reason, Refusal)
    contact = reason.contact
    assert mark is not None
    assert contact is not None
    assert at.ghost == pytest.approx(contact.joints_deg)
    assert (mark.place_mm, mark.touching) == (contact.place_mm, contact.links)
    assert mark.text == words.refusal(reason)
    assert mark in at.view._state.preview.path.findings, "with its sign"
    left_mm = gap_mm(contact.joints_deg, wall(wall_mm))
    assert 5.0 < left_mm < 15.0, "about the margin of 10 mm"
    assert contact.place_mm[0] == pytest.approx(wall_mm - left_mm / 2.0, abs=0.5)
    assert "would touch" in note(at)
    driver.run(1.0)
    assert finding(at) == mark, "it stays"
    assert controller.state.angles_deg() == pytest.approx(stands_deg, abs=0.1)
    driver.click("menu_motion")
    driver.click("home_button")
    assert finding(at) is None
    assert at.view._state.preview.path is None


def test_the_touching_ghost_goes_with_the_typed_target(at):
    type_joints(at)
    put(at.app_driver.controller, wall(300.0))
    at.app_driver.click("send_button")
    at.app_driver.run(0.3)
    assert finding(at) is not None
    at.app_driver.type_into("target_field_1", "21")
    assert finding(at) is None
    assert at.ghost == pytest.approx((21.0, *OUT[1:]))
    assert "from “wall” of the work area" in note(at), "of the new target"


@pytest.mark.usefixtures("no_motion")
def test_a_joint_beyond_its_limits_has_no_ghost_and_says_why(at):
    type_joints(at)
    at.app_driver.type_into("target_field_1", "170")
    at.look()
    assert not at.ghost
    assert "Joint 1" in note(at)
    assert "150" in note(at)
    at.app_driver.click("send_button")
    at.look()
    assert note(at) == "", "the panel says it beside the button"
    at.app_driver.type_into("target_field_1", "160")
    at.app_driver.click("send_button")  # at once, before the picture has looked
    at.look()
    assert note(at) == ""
    at.app_driver.type_into("target_field_1", "20")
    at.look()
    assert at.ghost == pytest.approx(OUT)
    assert note(at) == PREVIEW


@pytest.mark.usefixtures("no_motion")
def test_half_a_figure_has_no_ghost(at):
    type_joints(at)
    field = at.app_driver.find("target_field_3")
    field.setFocus()
    field.selectAll()
    QTest.keyClick(field, Qt.Key.Key_Minus)
    assert nothing_is_previewed(at)


@pytest.mark.usefixtures("no_motion")
def test_a_typed_pose_has_a_ghost_that_stands_there(at):
    type_pose(at)
    stands = at.app_driver.controller.cartesian.kinematics().forward(at.ghost)
    assert tuple(stands) == pytest.approx(tuple(POSE.values()), abs=0.01)
    assert note(at) == PREVIEW
    at.app_driver.run(0.5)
    assert at.app_driver.firmware.joints_deg == pytest.approx((0.0,) * 6, abs=0.1)


@pytest.mark.usefixtures("no_motion")
def test_a_pose_out_of_reach_has_no_ghost_and_says_so(at):
    type_pose(at, X=900.0)
    assert not at.ghost
    assert "reach" in note(at)
    send = at.app_driver.find("move_p_button")
    assert not send.property("primary")
    at.app_driver.type_into("pose_field_X", "300")
    at.look()
    assert send.property("primary")
    assert at.ghost is not None
    assert note(at) == PREVIEW


def test_a_pose_that_was_sent_is_no_preview_and_a_new_one_is_again(at):
    type_pose(at)
    at.app_driver.click("move_p_button")
    assert nothing_is_previewed(at)
    at.app_driver.run(0.3)
    at.app_driver.type_into("pose_field_Z", "280")  # while the arm is on its way
    at.look()
    assert at.ghost is not None
    let_arrive(at)
    assert at.app_driver.find("pose_field_Z").value == pytest.approx(280.0)
    assert at.ghost is not None


def test_an_arm_that_moves_by_itself_has_no_ghost(at):
    accepted(at.app_driver.controller.motion.send_joints(OUT))
    for _ in range(5):
        at.app_driver.run(0.3)
        assert nothing_is_previewed(at)


def test_the_range_of_a_joint_has_a_needle_for_the_target_and_one_for_the_measured_angle(shape):
    def needles(**measured):
        strokes = joint_range(shape, OUT, 2, (0.0, 180.0), LIGHT, **measured)
        place, _ = shape.joint_frame(2, shape.links(OUT))
        found = [each for each in strokes if each.places[0] == place and not each.filled]
        return {each.color: (each.label, each.places[1]) for each in found}

    plain, both = needles(), needles(measured_deg=10.0)
    assert list(plain) == [LIGHT.text]
    assert set(both) == {LIGHT.text, LIGHT.commanded}
    assert both[LIGHT.commanded] == ("60.000°", plain[LIGHT.text][1])
    assert both[LIGHT.text][1] != plain[LIGHT.text][1]
