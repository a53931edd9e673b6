"""An operator drags a plane or box of the work area: its figures follow, a press applies them."""

import numpy as np
import pytest

from armui.cell.cell import Cell
from armui.cell.work_area import AreaBox
from armui.control.cell.cell_reasons import CELL_WHILE_MOVING
from armui.kinematics.poses import pose_to_matrix
from armui.system.paths import URDF
from armui.ui import words
from armui.viewport.grips import GripKind
from armui.viewport.handles import HandleKind
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from tests.accepted import accepted
from tests.cell.areas import area_of
from tests.picture_hand import Hand

CRATE = AreaBox("crate", (350.0, -100.0, 150.0, 0.0, 0.0, 30.0), (100.0, 100.0, 100.0))


@pytest.fixture(scope="module")
def shape():
    return shape_of(load_robot(URDF / "piper" / "piper.urdf"))


@pytest.fixture
def hand(app_driver, shape):
    found = Hand(app_driver, shape)
    accepted(app_driver.controller.cell.take(Cell("bench", area=area_of(CRATE))))
    app_driver.click("menu_cell")
    app_driver.click("cell_tab_area")
    box = app_driver.find("cell_area_zone")
    box.setCurrentIndex(1)
    box.activated.emit(1)
    return found


def typed(hand):
    return tuple(
        hand.app_driver.find(f"cell_area_{axis}").value
        for axis in ("X", "Y", "Z", "RX", "RY", "RZ")
    )


def zones(hand):
    return hand.app_driver.controller.cell.cell.area.boxes


def along_px(hand, grip, length_px):
    """So far along an axis as it is seen."""
    start, ahead = (np.array(hand.view.projection.pixel(place)) for place in grip.places[:2])
    return tuple((ahead - start) / np.linalg.norm(ahead - start) * length_px)


def test_a_box_is_dragged_along_the_base_and_applied_by_a_press(hand):
    hand.app_driver.heard()
    grip = hand.grip(GripKind.AXIS, 1)
    hand.drag(grip, along_px(hand, grip, 40.0))
    x, y, z, *turn = typed(hand)
    assert (x, z, *turn) == pytest.approx((350.0, 150.0, 0.0, 0.0, 30.0), abs=0.01)
    assert y > -95.0
    assert zones(hand) == (CRATE,)
    hand.app_driver.run(0.1)
    shown = [each for each in hand.view._state.area if each.near and not each.held]
    assert [round(1000 * each.rows[7], 2) for each in shown] == [pytest.approx(y, abs=0.01)]
    hand.app_driver.click("cell_area_apply")
    assert zones(hand)[0].pose == pytest.approx((x, y, z, *turn))
    assert hand.app_driver.heard() == []


def test_along_its_own_axes_and_turned(hand):
    hand.choose(HandleKind.TOOL_FRAME)
    grip = hand.grip(GripKind.AXIS, 0)
    hand.drag(grip, along_px(hand, grip, 40.0))
    moved = np.array(typed(hand)[:3]) - CRATE.pose[:3]
    own_x = pose_to_matrix(CRATE.pose)[:3, 0]
    assert np.linalg.norm(moved) > 5.0
    assert moved / np.linalg.norm(moved) == pytest.approx(own_x, abs=1e-3)
    ring = hand.grip(GripKind.RING, 2)
    hand.drag(ring, (30.0, 12.0))
    assert typed(hand)[5] != pytest.approx(30.0, abs=0.5)
    assert typed(hand)[3:5] == pytest.approx((0.0, 0.0), abs=0.01)


def test_a_drag_that_is_given_up_leaves_the_figures(hand):
    grip = hand.grip(GripKind.AXIS, 2)
    place = hand.place_on(grip)
    hand.press(place)
    hand.move((place[0], place[1] - 40.0))
    assert typed(hand)[2] != pytest.approx(150.0, abs=0.5)
    hand.view.give_up_drag()
    assert typed(hand) == pytest.approx(CRATE.pose)


def test_it_is_not_applied_while_the_arm_moves(hand):
    driver = hand.app_driver
    grip = hand.grip(GripKind.AXIS, 1)
    hand.drag(grip, along_px(hand, grip, 30.0))
    accepted(driver.controller.motion.send_joints((0.0, 40.0, -30.0, 0.0, 10.0, 0.0)))
    driver.run(0.3)
    assert not driver.find("cell_area_apply").isEnabled()
    assert driver.find("cell_area_apply").toolTip() == words.refusal(CELL_WHILE_MOVING())
    assert zones(hand) == (CRATE,)


def test_elsewhere_the_handles_are_those_of_the_arm_again(hand):
    hand.grip(GripKind.AXIS, 1)
    assert hand.view._handles.place.frame is not None
    hand.app_driver.click("menu_motion")
    hand.look()
    assert hand.view._handles.place.frame is None


def test_handles_of_the_area_do_not_stay_for_what_comes_next(hand):
    driver = hand.app_driver
    bar = driver.find("view_bar")
    bar.choose_handles(HandleKind.TOOL_FRAME)
    driver.run(0.2)
    assert hand.view._handles is not None
    driver.click("menu_motion")
    driver.wait(lambda: not driver.find("view_handles_button").isChecked())
    bar.choose_handles(HandleKind.JOINTS)  # chosen here, they stay
    driver.click("menu_cell")
    driver.run(0.3)
    assert driver.find("view_handles_button").isChecked()
