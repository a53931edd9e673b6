"""An operator finds a tool's tip by points: guided, refused with figures, applied by a press."""

import numpy as np
import pytest

from armui.cell.tools import NO_TOOL
from armui.control.motion.jog_path import JointJog
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import flange_pose, matrix_to_pose, pose_to_matrix
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG
from tests.family import PIPER
from tests.operator import tip_actions
from tests.operator.tip_actions import TRUE, go, take, touch


@pytest.fixture
def search(app_driver):
    return tip_actions.search(app_driver)


def test_each_sentence_leads_to_the_next_and_the_last_press_applies(search):
    assert "Fix a sharp point" in search.read("tip_next")
    take(search, 0)
    assert "Pose 1 of at least 4 is taken. Tilt the tool by 15° or more" in search.read("tip_next")
    take(search, 1)
    assert "turn about Y, Z by 15° or more" in search.read("tip_next")
    take(search, 2, 3)
    assert "Compare what was found" in search.read("tip_next")
    assert search.controller.cartesian.tool == NO_TOOL
    assert "Before: X 0.00  Y 0.00  Z 0.00 mm" in search.read("tip_result").replace(
        "\N{NO-BREAK SPACE}", " "
    )
    search.click("tip_apply")
    found = search.controller.cartesian.tool
    assert np.linalg.norm(np.array(found[:3]) - TRUE[:3]) < 0.5
    assert found[3:] == (0.0, 0.0, 0.0)
    assert search.controller.cell.cell.tool == "Tool 1"
    assert "how well the poses fit" in search.read("tip_note")
    assert "The tip found is in force" in search.read("tip_next")


def test_a_pose_is_not_taken_while_the_arm_moves_or_is_not_heard(search):
    search.click("tip_take")
    accepted(search.controller.jogging.start(JointJog(1, 1)))
    search.run(0.3)
    for name in ("tip_take", "tip_again_1"):
        assert not search.find(name).isEnabled()
        assert "not at rest" in search.find(name).toolTip()
    assert search.controller.cell.capture().code == "capture_moving"
    search.controller.jogging.stop()
    search.run_until(search.find("tip_take").isEnabled)
    search.powered = False
    search.run(0.6)
    assert search.controller.cell.capture().code in {"capture_stale", "offline"}
    search.run(1.0)
    assert not search.find("tip_take").isEnabled()


def test_turns_about_one_axis_are_refused_with_the_condition(search):
    first = pose_to_matrix(Kinematics(PIPER).forward(BENT_DEG)) @ pose_to_matrix(TRUE)
    for angle in (0, 15, 30, 45):
        turned = matrix_to_pose(first @ pose_to_matrix((0, 0, 0, 0, 0, angle)))
        go(search, flange_pose(turned, TRUE))
        search.click("tip_take")
    assert "The flange's Z axis has pointed" in search.read("tip_next")
    assert "turn about X, Y by 15°" in search.read("tip_next")
    assert not search.find("tip_apply").isEnabled()
    assert "condition is" in search.find("tip_apply").toolTip()


def test_a_slipped_pose_is_named_left_out_or_taken_again(search):
    take(search, 0, 1, 2, 3)
    touch(search, 4, slip_mm=12.0)
    search.click("tip_take")
    assert "pose 5 is" in search.read("tip_next")
    assert not search.find("tip_apply").isEnabled()
    search.click("tip_use_5")
    assert search.read("tip_residual_5") == "—"
    assert "Compare what was found" in search.read("tip_next")
    search.click("tip_use_5")
    touch(search, 4)
    search.click("tip_again_5")
    assert "Compare what was found" in search.read("tip_next")
    assert float(search.read("tip_residual_5").split()[0]) < 0.5


def test_the_limit_of_the_residual_is_the_operators(search):
    take(search, 0, 1, 2, 3)
    touch(search, 4, slip_mm=4.0)
    search.click("tip_take")
    assert not search.find("tip_apply").isEnabled()
    search.type_into("tip_limit", "5")
    assert search.find("tip_apply").isEnabled()


def test_a_tool_that_points_along_an_axis_gets_its_orientation(search):
    take(search, 0, 1, 2, 3)
    box = search.find("tip_orientation")
    box.setCurrentIndex(6)
    box.activated.emit(6)
    assert "points along that axis" in search.read("tip_next")
    assert not search.find("tip_apply").isEnabled()
    flange = pose_to_matrix(search.controller.state.end_pose())
    search.click("tip_turn_1")
    search.click("tip_apply")
    tool = pose_to_matrix(search.controller.cartesian.tool)
    assert (flange @ tool)[:3, 2] == pytest.approx((0.0, 0.0, -1.0), abs=1e-4)


def test_the_poses_stay_while_another_panel_is_used_and_go_with_a_press(search):
    take(search, 0, 1)
    search.click("menu_motion")
    search.click("menu_cell")
    assert "Pose 2 of at least 4" in search.read("tip_next")
    search.click("tip_restart")
    assert "Fix a sharp point" in search.read("tip_next")
