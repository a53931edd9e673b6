"""The 3D picture: views, a path with its numbers and findings, the tool's way, handles."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.control.run.progress import Run
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.viewport.camera import ViewDirection
from armui.viewport.grips import GripKind
from armui.viewport.handles import Dragged, HandleKind
from tests.accepted import accepted
from tests.app_driver import AppDriver
from tests.gallery_scenes import arm
from tests.gallery_scenes.trajectories import library


def side(app_driver: AppDriver) -> None:
    """From the side without perspective, as a drawing has it."""
    arm.reached_out(app_driver)
    app_driver.store.change(picture_orthographic=True)
    app_driver.program.view.look_from(ViewDirection.SIDE)


def following(app_driver: AppDriver) -> None:
    """The tool in the middle of the picture."""
    arm.reached_out(app_driver)
    app_driver.program.view.follow_tool(wanted=True)


def joint_range(app_driver: AppDriver) -> None:
    """The row of joint 1 is edited."""
    arm.reached_out(app_driver)
    window = app_driver.window
    window.activateWindow()
    app_driver.wait(window.isActiveWindow)
    app_driver.find("target_field_1").setFocus()


def reach(app_driver: AppDriver) -> None:
    """How far the tool can reach."""
    arm.reached_out(app_driver)
    app_driver.find("view_bar").view_actions["reach"].trigger()


def _checked(app_driver: AppDriver, name: str) -> EditorPage:
    library(app_driver).open_trajectory(name)
    window = app_driver.page(EditorPage)
    app_driver.wait(window.isActiveWindow)
    QTest.keyClick(window, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
    return window


def findings(app_driver: AppDriver) -> None:
    """A check has failed: what it found stands where it would happen."""
    app_driver.connect()
    _checked(app_driver, "Out of reach")


def trail(app_driver: AppDriver) -> None:
    """A run: the point under way is lit, and the tool's way stands beside the planned one."""
    app_driver.store.change(picture_trail_s=60)
    view = app_driver.program.view
    app_driver.wait(lambda: view.shape is not None)  # before that nobody knows where the tool is
    app_driver.connect()
    app_driver.click("menu_motion")
    app_driver.enable_by_hand()
    window = _checked(app_driver, "Pick and place")
    points = window.document.points
    player = app_driver.controller.player
    accepted(player.start(Run("Pick and place", points, (3.0,) * len(points))))
    app_driver.run_until(lambda: player.progress.index == len(points) - 2)
    app_driver.run(0.5)


def refused(app_driver: AppDriver) -> None:
    """A typed target is refused: the ghost stands where the gripper would hit the base."""
    arm.reached_out(app_driver)
    for joint, angle_deg in enumerate((-12.0, 83.0, -3.0, 32.0, 40.0, 70.0), start=1):
        app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")
    app_driver.click("send_button")
    app_driver.run(0.5)


def dragging(app_driver: AppDriver) -> None:
    """A target is dragged with the handles at the tool; the arm stays where it is."""
    arm.reached_out(app_driver)
    bar = app_driver.find("view_bar")
    for joint, angle_deg in enumerate((10.0, 80.0, -80.0, 10.0, 50.0, -30.0), start=1):
        app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")
    bar.choose_handles(HandleKind.TOOL)


def typed(app_driver: AppDriver) -> None:
    """A target is typed and not sent: its ghost, and two needles in the range of joint 1."""
    arm.reached_out(app_driver)
    for joint, angle_deg in enumerate((40.0, 80.0, -80.0, 10.0, 50.0, -30.0), start=1):
        app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")
    window = app_driver.window
    window.activateWindow()
    app_driver.wait(window.isActiveWindow)
    app_driver.find("target_field_1").setFocus()


def typed_out_of_reach(app_driver: AppDriver) -> None:
    """A pose is typed that the arm cannot reach."""
    arm.reached_out(app_driver)
    app_driver.click("menu_cartesian")
    app_driver.run(0.2)
    app_driver.type_into("pose_field_X", "900")


def below(app_driver: AppDriver) -> None:
    """From below the floor."""
    arm.reached_out(app_driver)
    app_driver.program.view.look_from(ViewDirection.BELOW)


def dragging_joints(app_driver: AppDriver) -> None:
    """The chosen point of an editor, with an arc at each joint."""
    app_driver.connect()
    library(app_driver).open_trajectory("Pick and place")
    app_driver.page(EditorPage).select_row(1)
    app_driver.find("view_bar").choose_handles(HandleKind.JOINTS)


def out_of_reach(app_driver: AppDriver) -> None:
    """A drag beyond the arm's reach says why the ghost stays."""
    dragging(app_driver)
    view = app_driver.program.view
    app_driver.wait(lambda: view.shape is not None)
    grips = view._grips(view.projection)
    grip = next(each for each in grips if each.kind is GripKind.AXIS and each.number == 0)
    view.handle_taken.emit()
    view.handle_moved.emit(Dragged(grip, 900.0), False, False)
