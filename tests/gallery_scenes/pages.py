"""The pages beside the 3D picture, on one screen."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from armui.ui.guide.guide_page import GuidePage
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.ui.watch.joint_status_page import JointStatusPage
from tests.app_driver import AppDriver
from tests.faulty_arm import FaultyDrivers
from tests.gallery_scenes import library, sessions, trajectories
from tests.gallery_scenes.scene import Scene

_SIZES = ((1280, 800), (1440, 900))
_WIDE = (*_SIZES, (1920, 1080))
_NARROW = ((1024, 720), (1440, 900))


def _online(play: Callable[[AppDriver], object]) -> Callable[[AppDriver], None]:
    """The same with an arm, its motors off."""

    def play_online(app_driver: AppDriver) -> None:
        app_driver.connect()
        play(app_driver)

    return play_online


def _jogging(app_driver: AppDriver) -> None:
    """Making points with the arm: jog controls and the table at once."""
    app_driver.ready()
    page = trajectories.editor(app_driver)
    app_driver.click(page.findChild(QWidget, "editor_jog"))


def _jogging_tool(app_driver: AppDriver) -> None:
    """The same along the axes of the tool."""
    _jogging(app_driver)
    app_driver.click(app_driver.find("box_tool"))


def _first_point(app_driver: AppDriver) -> None:
    """A trajectory that was made a moment ago."""
    app_driver.ready()
    app_driver.click(trajectories.library(app_driver).findChild(QWidget, "library_create"))
    QTest.keyClick(app_driver.find("library_name"), Qt.Key.Key_Return)


def _run(app_driver: AppDriver) -> None:
    """Under way, and watched from a panel."""
    app_driver.ready()
    page = trajectories.editor(app_driver)
    app_driver.click(page.findChild(QWidget, "run_send"))
    accept = page.findChild(QWidget, "accept_warnings")
    if accept.isVisible():
        app_driver.click(accept)
    app_driver.run_until(lambda: app_driver.controller.player.progress.index == 1)


def _run_paused(app_driver: AppDriver) -> None:
    """Paused, and 继续 held half of its second."""
    _run(app_driver)
    app_driver.click("run_pause")
    app_driver.run(1.0)
    button = app_driver.find("run_continue")
    button.progress.setCurrentTime(button.progress.duration() // 2)


def _run_from_a_panel(app_driver: AppDriver) -> None:
    """The same, and then the gripper's panel."""
    _run(app_driver)
    app_driver.click("menu_gripper")


def _drawer(name: str) -> Callable[[AppDriver], None]:
    """The drawer open at one of its pages, below a panel."""

    def play(app_driver: AppDriver) -> None:
        app_driver.ready()
        app_driver.click(f"{name}_button")
        app_driver.run(1.0)

    return play


def _tab(name: str) -> Callable[[AppDriver], None]:
    """The same with a page that has a tab there only."""

    def play(app_driver: AppDriver) -> None:
        app_driver.ready()
        app_driver.click("events_button")
        app_driver.click(f"drawer_{name}")
        app_driver.run(1.0)

    return play


def _guide(app_driver: AppDriver) -> None:
    """F1 at a panel: the panel stays in reach."""
    app_driver.ready()
    app_driver.window.window_actions.open_guide()
    page = app_driver.page(GuidePage)
    app_driver.wait(lambda: page.shown != "")
    app_driver.run(1.0)


def _joint_status_faults(app_driver: AppDriver) -> None:
    """Faults of drivers, and a joint that the arm could not reach for a moment."""
    app_driver.ready()
    app_driver.click("joint_status_button")
    drivers = FaultyDrivers(app_driver.firmware)
    drivers.bits = {2: 0x04, 4: 0x11, 5: 0x80}
    app_driver.firmware.set_communication_fault(6, present=True)
    app_driver.run(0.2)
    # gone with the next step of the arm's time, which stands still until then
    app_driver.firmware.set_communication_fault(6, present=False)
    drivers.mend()


def joint_status_taken_out(app_driver: AppDriver) -> QWidget:
    """The joints in a window of their own, where there is room for two lines a row."""
    app_driver.click("joint_status_button")
    return app_driver.taken_out(JointStatusPage).window()


def guide_taken_out(app_driver: AppDriver) -> QWidget:
    """The guide in a window of its own."""
    app_driver.window.window_actions.open_guide()
    page = app_driver.taken_out(GuidePage)
    app_driver.wait(lambda: page.shown != "")
    return page.window()


def _all_at_once(app_driver: AppDriver) -> None:
    """A page, a run and the drawer."""
    _run(app_driver)
    app_driver.click("events_button")


def _drawer_after_end_load(app_driver: AppDriver) -> None:
    """The tallest panel has been seen: the drawer keeps its height, in a low window, too."""
    app_driver.ready()
    app_driver.click("events_button")
    app_driver.click("menu_end_load")
    app_driver.click("menu_motion")
    app_driver.run(1.0)


def _put_back(app_driver: AppDriver) -> None:
    """The empty library, taken out and put back: its hint is still there."""
    library.empty(app_driver)
    window = app_driver.taken_out(LibraryPage).window()
    app_driver.click(window.findChild(QWidget, "page_put_back"))


def _stopped_below_a_page(app_driver: AppDriver) -> None:
    """An emergency stop while a page is seen: red in every theme."""
    app_driver.ready()
    trajectories.library(app_driver)
    app_driver.controller.emergency_stop()
    app_driver.run(2.0)


def taken_out(app_driver: AppDriver) -> QWidget:
    """The editor in a window of its own, with both stops."""
    trajectories.editor(app_driver)
    return app_driver.taken_out(EditorPage).window()


SCENES = (
    Scene("drawer-curves", _drawer("plots"), sizes=_SIZES, fine=True),
    Scene("drawer-events", _drawer("events"), sizes=_SIZES),
    Scene("drawer-bus", _drawer("bus"), sizes=_SIZES),
    Scene("drawer-joint-status", _drawer("joint_status"), sizes=_WIDE),
    Scene("drawer-joint-status-faults", _joint_status_faults, sizes=_WIDE),
    Scene("drawer-sessions", _online(sessions.listed), sizes=_WIDE),
    Scene("drawer-sessions-recording", _online(sessions.recording), sizes=_SIZES),
    Scene("drawer-guide", _guide, sizes=_WIDE),
    Scene("drawer-after-end-load", _drawer_after_end_load, sizes=((1024, 720), (1440, 900))),
    Scene("library-put-back", _put_back, sizes=((1024, 720),)),
    Scene("library-stopped", _stopped_below_a_page, sizes=((1024, 720),)),
    Scene("running-drawer", _all_at_once, sizes=_SIZES, fine=True),
    Scene("editor-jogging", _jogging, sizes=(*_SIZES, (1024, 720)), fine=True),
    Scene("editor-jogging-tool", _jogging_tool, sizes=_SIZES),
    Scene("editor-empty", _first_point, sizes=_SIZES),
    Scene("running", _run, sizes=_SIZES),
    Scene("running-paused", _run_paused, sizes=_SIZES),
    Scene("running-panel", _run_from_a_panel, sizes=_SIZES),
    Scene("library-empty", library.empty, sizes=_SIZES),
    Scene("library", _online(trajectories.library), sizes=_SIZES, fine=True),
    Scene("library-folders", _online(library.in_folder), sizes=_SIZES),
    Scene("library-not-found", _online(library.not_found), sizes=_SIZES),
    Scene("library-deleted", _online(library.deleted), sizes=_SIZES),
    Scene("library-imported", _online(library.imported), sizes=_SIZES),
    Scene("editor", _online(trajectories.editor), sizes=_SIZES),
    Scene("editor-find", _online(trajectories.editor_find), sizes=_SIZES),
    Scene("editor-check-failed", _online(trajectories.failed_check), sizes=_SIZES, fine=True),
    Scene("editor-of-the-cell", trajectories.editor_of_the_cell, sizes=_SIZES),
    Scene("recording", _online(trajectories.recording), sizes=_SIZES),
    Scene("columns-offered", _online(trajectories.columns_offered), sizes=_SIZES),
    Scene("columns", _online(trajectories.columns), sizes=_SIZES),
    Scene("columns-units", _online(trajectories.columns_with_units), sizes=_SIZES),
    Scene("editor-older-zeros", trajectories.older_zeros, sizes=_NARROW),
    Scene("library-other-arm", trajectories.other_arm, sizes=_NARROW),
    Scene("library-sunk", trajectories.sunk, sizes=_NARROW),
    Scene("columns-asked", _online(trajectories.columns_asked), sizes=_SIZES),
)
