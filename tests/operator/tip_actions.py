"""The hands of an operator who finds the tip of a tool by points."""

from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.poses import flange_pose, matrix_to_pose, pose_to_matrix
from armui.protocol.codes import MoveMode
from tests.accepted import accepted
from tests.control.jogger import BENT_DEG, bend
from tests.family import PIPER

TRUE = (12.0, -8.0, 130.0, 0.0, 0.0, 0.0)
TURNS = ((0, 0, 0), (20, 0, 0), (0, 20, 0), (-18, -12, 10), (10, -20, -15))
"""Turns about the tool's own axes, of each touch."""


def search(app_driver):
    """A cell is made and the search for the tip is open; the tool is really there, not known."""
    bend(app_driver)
    app_driver.click("menu_cell")
    app_driver.type_into("cell_name", "bench")
    app_driver.click("cell_tool_by_points")
    app_driver.run(0.3)
    return app_driver


def touch(driver, number, slip_mm=0.0):
    """Lead the true tip onto the fixed point, turned anew each time, by MOVE P; come to rest."""
    first = pose_to_matrix(Kinematics(PIPER).forward(BENT_DEG)) @ pose_to_matrix(TRUE)
    turned = first @ pose_to_matrix((slip_mm, 0.0, 0.0, *TURNS[number]))
    go(driver, flange_pose(matrix_to_pose(turned), TRUE))


def go(driver, flange):
    accepted(driver.controller.cartesian.move(flange, MoveMode.MOVE_P))
    driver.come_to_rest()


def take(driver, *numbers):
    for number in numbers:
        touch(driver, number)
        driver.click("tip_take")
