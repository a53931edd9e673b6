"""The hands of an operator who makes a user frame by three points with a tool's tip."""

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.kinematics.poses import to_base
from armui.protocol.codes import MoveMode
from tests.accepted import accepted
from tests.control.jogger import bend

PEN = Tool("pen", (0.0, 0.0, 120.0, 0.0, 0.0, 0.0), 10.0)
WORK = (352.0, 15.0, 160.0, 5.0, -10.0, 60.0)
"""Where the work lies: its origin and axes in the base."""
PLACES = ((0.0, 0.0, 0.0), (60.0, 0.0, 0.0), (25.0, 45.0, 0.0))
"""Places of the work: its origin, one on +X, one on the side of +Y."""


def at_frames(app_driver):
    """A cell with a pen; the arm is bent, the tab of the frames is open."""
    bend(app_driver)
    accepted(app_driver.controller.cell.take(with_part(Cell("bench"), PEN)))
    app_driver.click("menu_cell")
    app_driver.click("cell_tab_frames")
    app_driver.run(0.3)
    return app_driver


def touch(driver, place):
    """Lead the tip onto a place of the work, by MOVE P; come to rest."""
    cartesian = driver.controller.cartesian
    here = cartesian.tool_pose(driver.controller.state)
    target = to_base((*place, 0.0, 0.0, 0.0), WORK)
    accepted(cartesian.move((*target[:3], *here[3:]), MoveMode.MOVE_P))
    driver.come_to_rest()


def take(driver, *numbers):
    """Touch places and take each."""
    for number in numbers:
        touch(driver, PLACES[number])
        driver.click(f"frame_take_{number + 1}")


def by_points(app_driver):
    """All three points are taken; the frame that they give is shown."""
    at_frames(app_driver)
    app_driver.click("cell_frame_by_points")
    take(app_driver, 0, 1, 2)
    return app_driver


def made(app_driver):
    """It is taken over, and in force."""
    by_points(app_driver)
    app_driver.click("frame_points_add")
    choose(app_driver, "cell_frame", 1)
    app_driver.run(0.3)
    return app_driver


def choose(driver, name, place):
    """Choose another one in a list."""
    box = driver.find(name)
    box.setCurrentIndex(place)
    box.activated.emit(place)
