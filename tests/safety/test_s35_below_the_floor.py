"""S35: where no lowest height is chosen, a single motion below the floor is asked about first."""

import math

import pytest
from PySide6.QtWidgets import QApplication

from armui.arm.limits import JOINT_OUT_OF_LIMITS
from armui.cell.cell import Cell
from armui.cell.placement import Placement
from armui.control.operations.started import Ending, Started
from armui.control.safety.gate import LEADS_BELOW
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Waypoint
from armui.ui.dialogs.confirm_dialog import ConfirmDialog
from armui.ways.rules import TOO_LOW
from tests.accepted import accepted
from tests.control.jogger import bend
from tests.operator.editor.actions import Editor

AHEAD_DEG = (0.0, 80.0, -60.0, 0.0, 20.0, 0.0)
LOW_DEG = (10.0, 125.0, -60.0, 15.0, 40.0, 20.0)
LOWER_DEG = (10.0, 128.0, -60.0, 15.0, 40.0, 20.0)
DIPS_DEG = (-86.0, 105.0, -32.0, 0.0, 70.0, 0.0)
BEYOND_DEG = (170.0, *LOW_DEG[1:])
LOW_POSE = {"X": 420.0, "Y": 0.0, "Z": -60.0, "RX": 180.0, "RY": 20.0, "RZ": 180.0}


def type_joints(driver):
    for joint, angle_deg in enumerate(LOW_DEG, start=1):
        driver.type_into(f"target_field_{joint}", f"{angle_deg}")


def type_pose(driver):
    driver.click("menu_cartesian")
    driver.run(0.2)
    for axis, value in LOW_POSE.items():
        driver.type_into(f"pose_field_{axis}", f"{value}")


def press_send(driver):
    type_joints(driver)
    driver.click("send_button")


def press_move_p(driver):
    type_pose(driver)
    driver.click("move_p_button")


def press_move_l(driver):
    type_pose(driver)
    driver.click("move_l_button")


def press_park(driver):
    type_joints(driver)
    driver.find("set_own_home_button").menu().actions()[1].trigger()
    driver.click("load_button")
    driver.click("own_home_button")


def press_go_to(driver):
    editor = Editor(driver, Waypoint(MoveMode.MOVE_J, LOW_DEG))
    driver.heard()
    editor.choose(0)
    editor.act("go_to")


ACTS = {
    "Send": press_send,
    "MOVE P": press_move_p,
    "MOVE L": press_move_l,
    "park position": press_park,
    "editor": press_go_to,
}


@pytest.fixture
def ahead(app_driver):
    app_driver.ready()
    accepted(app_driver.controller.motion.send_joints(AHEAD_DEG))
    app_driver.come_to_rest()
    app_driver.heard()
    return app_driver


def height_mm(driver):
    return driver.controller.jog_floor.height_mm(driver.firmware.joints_deg)


def moved_deg(driver, from_deg=AHEAD_DEG):
    return math.dist(driver.firmware.joints_deg, from_deg)


def questions():
    shown = QApplication.topLevelWidgets()
    return [each for each in shown if isinstance(each, ConfirmDialog) and each.isVisible()]


@pytest.mark.parametrize("press", ACTS.values(), ids=ACTS)
def test_one_press_goes_nowhere_and_a_held_one_there(ahead, press):
    press(ahead)
    ahead.run(1.0)
    assert moved_deg(ahead) < 0.1
    text = ahead.dialog(ConfirmDialog).text()
    assert "below the floor" in text
    assert "lowest height chosen under Settings" in text
    ahead.hold(0.5)
    ahead.run(1.0)
    assert moved_deg(ahead) < 0.1
    ahead.hold()
    ahead.run(0.5)
    ahead.come_to_rest()
    assert height_mm(ahead) < -20.0


@pytest.mark.parametrize("press", ACTS.values(), ids=ACTS)
def test_who_says_no_has_sent_nothing(ahead, press):
    press(ahead)
    ahead.click(ahead.dialog(ConfirmDialog).cancel_button)
    ahead.run(1.0)
    assert moved_deg(ahead) < 0.1


@pytest.mark.parametrize(
    ("press", "field"),
    [("Send", "target_field_1"), ("MOVE P", "pose_field_Y"), ("MOVE L", "pose_field_Y")],
)
def test_what_was_typed_since_is_not_what_was_asked_about(ahead, press, field):
    """The ghost shows the new target by then: what is held may not go to the old one."""
    ACTS[press](ahead)
    ahead.type_into(field, "80")
    (question,) = questions()
    ahead.hold_button(question.action_button)
    ahead.run(1.0)
    assert questions() == []
    assert moved_deg(ahead) < 0.1


def test_another_row_is_not_the_one_that_was_asked_about(ahead):
    low = Waypoint(MoveMode.MOVE_J, LOW_DEG)
    editor = Editor(ahead, low, Waypoint(MoveMode.MOVE_J, (60.0, *LOW_DEG[1:])))
    editor.choose(0)
    editor.act("go_to")
    editor.choose(1)
    ahead.hold()
    ahead.run(1.0)
    assert moved_deg(ahead) < 0.1


def test_a_lowest_height_answers_it(ahead):
    ahead.controller.jog_floor.lowest_mm = -300
    press_send(ahead)
    assert questions() == []
    ahead.run(0.5)
    ahead.come_to_rest()
    assert height_mm(ahead) < -50.0
    ahead.controller.jog_floor.lowest_mm = 0
    refusal = ahead.controller.motion.send_joints(LOWER_DEG)
    assert refusal.reason is TOO_LOW


def test_the_lowest_place_of_the_way_is_told(ahead):
    """The way dips below the floor, and ends over it."""
    steps = [
        [a + k / 200 * (b - a) for a, b in zip(AHEAD_DEG, DIPS_DEG, strict=True)]
        for k in range(201)
    ]
    heights = [ahead.controller.jog_floor.height_mm(each) for each in steps]
    assert min(heights) < -5.0 < 5.0 < heights[-1]
    refusal = ahead.controller.motion.send_joints(DIPS_DEG)
    assert refusal.reason is LEADS_BELOW
    assert refusal.params["value"] == pytest.approx(-min(heights), abs=2.5)


def test_what_is_agreed_to_goes_no_lower(ahead):
    motion = ahead.controller.motion
    refusal = motion.send_joints(LOW_DEG)
    assert refusal.reason is LEADS_BELOW
    depth_mm = refusal.params["value"]
    lower = motion.send_joints(LOWER_DEG, -depth_mm)
    assert lower.reason is LEADS_BELOW
    assert lower.params["value"] > depth_mm
    accepted(motion.send_joints(LOW_DEG, -depth_mm))
    ahead.come_to_rest()
    assert -depth_mm - 1.0 <= height_mm(ahead) < -50.0


def test_an_arm_below_may_come_up_and_goes_no_deeper_unasked(ahead):
    motion = ahead.controller.motion
    accepted(motion.send_joints(LOW_DEG, -500.0))
    ahead.come_to_rest()
    assert motion.send_joints(LOWER_DEG).reason is LEADS_BELOW
    accepted(motion.send_joints(AHEAD_DEG))
    ahead.come_to_rest()
    assert moved_deg(ahead) < 0.1


def test_fifty_small_ones_lead_no_deeper_unasked(ahead):
    motion = ahead.controller.motion
    accepted(motion.send_joints(LOW_DEG, -500.0))
    ahead.come_to_rest()
    depth_mm = height_mm(ahead)
    for _ in range(50):
        target_deg = list(ahead.firmware.joints_deg)
        target_deg[1] += 0.1
        motion.send_joints(target_deg)
        ahead.run(0.2)
    assert height_mm(ahead) > depth_mm - 0.1


def test_what_is_refused_anyway_is_not_asked(ahead):
    refusal = ahead.controller.motion.send_joints(BEYOND_DEG)
    assert refusal.reason is JOINT_OUT_OF_LIMITS


def test_the_floor_is_that_of_the_room_where_the_cell_says_how_the_arm_stands(ahead):
    raised = Cell("raised", placement=Placement((0.0, 0.0, 400.0, 0.0, 0.0, 0.0)))
    accepted(ahead.controller.cell.take(raised))
    press_send(ahead)
    assert questions() == []
    ahead.run(0.5)
    ahead.come_to_rest()
    assert moved_deg(ahead, LOW_DEG) < 0.1


def test_what_a_motion_was_checked_with_stays_until_it_rests(ahead):
    """A lowest height and a tool that the settings get meanwhile, here or from another program."""
    controller = ahead.controller
    started = accepted(controller.motion.send_joints((60.0, *AHEAD_DEG[1:])))
    rules = controller.gate.rules()
    ahead.store.change(jog_floor_mm=450, tool=(0.0, 0.0, 90.0, 0.0, 0.0, 0.0))
    ahead.run(0.3)
    assert controller.operating_state.moving
    assert controller.gate.rules() is rules
    ahead.come_to_rest()
    ahead.run(0.2)
    assert started.ending is Ending.DONE
    assert controller.jog_floor.lowest_mm == 450
    assert controller.cartesian.tool == (0.0, 0.0, 90.0, 0.0, 0.0, 0.0)
    assert controller.motion.send_joints(LOW_DEG).reason is TOO_LOW


def test_what_waits_for_the_rest_of_a_motion_counts_once_the_device_is_closed(ahead):
    controller = ahead.controller
    accepted(controller.motion.send_joints((60.0, *AHEAD_DEG[1:])))
    ahead.store.change(jog_floor_mm=450, tool=(0.0, 0.0, 90.0, 0.0, 0.0, 0.0))
    ahead.run(0.3)
    controller.disconnect_device()
    assert controller.jog_floor.lowest_mm == 450
    assert controller.cartesian.tool == (0.0, 0.0, 90.0, 0.0, 0.0, 0.0)


DIPPING = [
    ((0.0, 110.0, -70.0, -33.0, 18.0, 2.0), (0.0, 178.0, -62.0, -43.0, 55.0, 72.0)),
    ((-19.0, 150.0, -142.0, -71.0, 23.0, -61.0), (-19.0, 128.0, -4.0, -25.0, -44.0, -72.0)),
    ((115.0, 97.0, -2.0, 67.0, 35.0, -50.0), (0.0,) * 6),
]
"""Ways whose ramps lead lower than the even turn; the last begins below the floor."""


@pytest.mark.parametrize(("begin", "end"), DIPPING)
def test_what_is_asked_is_enough_for_the_same_way(rig, begin, end):
    rig.lie(begin)
    rig.ready()
    asked = rig.controller.motion.send_joints(end)
    if not isinstance(asked, Started):
        assert asked.reason is LEADS_BELOW
        accepted(rig.controller.motion.send_joints(end, -float(asked.params["value"])))


def test_in_a_silence_a_motion_keeps_what_it_was_checked_with(rig):
    bend(rig)
    control = rig.controller
    control.motion.set_speed_percent(20)
    accepted(control.motion.send_joints((120.0, *rig.firmware.joints_deg[1:])))
    rig.run(0.5)
    control.jog_floor.lowest_mm = 450
    control.cell.use_own_tool((0.0, 0.0, 90.0, 0.0, 0.0, 0.0))
    rules = control.gate.rules()
    rig.node.link.off = True
    rig.run(1.0)
    rig.node.link.off = False
    rig.run(0.2)
    assert control.operating_state.moving
    assert control.gate.rules() is rules
    rig.run_until(lambda: not control.operating_state.moving, seconds=30.0)
    rig.run(0.5)
    assert control.jog_floor.lowest_mm == 450
