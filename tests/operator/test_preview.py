"""An operator looks at a trajectory in 3D before anything moves."""

from typing import TYPE_CHECKING, cast

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QListWidget, QWidget

from armui.control.motion.jog_path import JointJog
from armui.control.run.progress import OVER, Run
from armui.kinematics.arm_kinematics import Kinematics
from armui.protocol.codes import MoveMode
from armui.system.paths import URDF
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording
from armui.ui.picture.picture_work import TrailKeeper
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.viewport.path_picture import NOTHING
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.robot_shape import composed
from tests.accepted import accepted
from tests.control.jogger import hold
from tests.family import PIPER

if TYPE_CHECKING:
    from armui.viewport.view import ArmView

OUT = (20.0, 40.0, -40.0, 10.0, 20.0, 15.0)
BACK = (-15.0, 30.0, -30.0, -10.0, 30.0, -20.0)
BEYOND = (170.0, *OUT[1:])


FOLDED = (-16.0, 81.0, -2.0, 51.0, 31.0, 59.0)
TURNED = (9.0, 93.0, -7.0, -63.0, 70.0, 117.0)
"""Between the two the arm hits itself; at both it is free."""


class Operator:
    """At the editor of a trajectory, the 3D view beside it."""

    def __init__(self, app_driver, *targets):
        self.app_driver = app_driver
        app_driver.ready()
        points = tuple(Waypoint(MoveMode.MOVE_J, target) for target in targets)
        Library(app_driver.library_folder).save(Trajectory("Test", points=points))
        app_driver.click("library_button")
        app_driver.page(LibraryPage).open_trajectory("Test")
        self.editor = app_driver.page(EditorPage)
        app_driver.wait(self.editor.isActiveWindow)

    def check(self):
        QTest.keyClick(self.editor, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)

    @property
    def shown(self):
        return self.app_driver.program.view._state.preview


@pytest.fixture
def at(app_driver):
    return Operator(app_driver, OUT, BACK)


def test_a_check_shows_the_way_and_a_ghost_and_moves_nothing(at):
    app_driver = at.app_driver
    assert not app_driver.find("preview_bar").isVisible()
    before = app_driver.firmware.joints_deg
    at.check()
    assert app_driver.find("preview_bar").isVisible()
    assert at.shown.path.rows == (0, 1)
    assert at.shown.ghost_deg == pytest.approx(before, abs=0.01)
    slider = app_driver.find("preview_slider")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert at.shown.ghost_deg == pytest.approx(BACK, abs=0.5)
    app_driver.run(1.0)
    assert app_driver.firmware.joints_deg == before


def test_a_row_and_its_mark_lead_to_one_another(at):
    at.editor.table.select_row(1)
    at.check()
    at.editor.table.select_row(0)
    assert at.shown.selected_row == 0
    assert at.shown.ghost_deg == pytest.approx(OUT, abs=0.5)
    at.app_driver.program.view.mark_picked.emit(1)
    assert at.editor.table.current_row() == 1
    assert at.shown.selected_row == 1


def test_points_that_cannot_be_reached_are_marked(app_driver):
    at = Operator(app_driver, OUT, BEYOND)
    at.check()
    assert at.shown.path.bad_rows == frozenset({1})


def test_another_point_takes_the_preview_away(at):
    at.check()
    at.editor.table.select_row(0)
    QTest.keyClick(at.editor.table, Qt.Key.Key_Delete)
    assert len(at.shown.path.places_mm) == 0
    assert at.shown.path.rows == (0,)  # the points stay, without a way between them
    assert not at.app_driver.find("preview_bar").isVisible()


def test_a_preview_is_played_and_paused(at):
    at.check()
    app_driver = at.app_driver
    assert app_driver.read("preview_play") == "Play"
    app_driver.click("preview_play")
    assert app_driver.read("preview_play") == "Pause"  # halting is what F9 does to the arm
    app_driver.click("preview_play")
    assert app_driver.read("preview_play") == "Play"
    app_driver.store.change(language="zh")
    app_driver.click("preview_play")
    assert app_driver.read("preview_play") == "暂停"


def test_the_operator_closes_the_preview(at):
    at.check()
    at.app_driver.click("preview_close")
    assert len(at.shown.path.places_mm) == 0
    at.editor.leave()
    assert at.shown == NOTHING


def test_a_finding_in_the_picture_leads_to_its_row(app_driver):
    at = Operator(app_driver, OUT, BEYOND, BACK)
    at.check()
    finding = next(each for each in at.shown.path.findings if each.is_error)
    assert finding.row == 1
    assert "1" in finding.text
    at.editor.table.select_row(0)
    app_driver.program.view.finding_picked.emit(finding)
    assert at.editor.table.current_row() == 1


@pytest.mark.parametrize("of", ["editor", "library"])
def test_a_sign_that_is_pressed_shows_where_the_arm_would_touch(app_driver, of):
    at = Operator(app_driver, FOLDED, TURNED)
    if of == "editor":
        at.check()
        at.editor.table.select_row(0)
    else:
        page = at.editor.above
        at.editor.leave()
        page._table.choose(["Test"])
        app_driver.click(page.findChild(QWidget, "run_send"))
    mark = next(each for each in at.shown.path.findings if each.touching)
    assert at.shown.finding is None
    app_driver.program.view.finding_picked.emit(mark)
    assert at.shown.ghost_deg == pytest.approx(mark.joints_deg)
    assert at.shown.finding == mark
    app_driver.run(0.3)
    assert at.shown.finding == mark, "it stays"
    slider = app_driver.find("preview_slider")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert at.shown.finding is None, "the ghost is elsewhere"


def test_a_trajectory_that_is_not_chosen_leaves_nothing_in_the_picture(app_driver):
    at = Operator(app_driver, FOLDED, TURNED)
    Library(app_driver.library_folder).save(Trajectory("Other"))
    page = at.editor.above
    at.editor.leave()
    app_driver.wait(lambda: page._table.model().rowCount() >= 2)
    page._table.choose(["Test"])
    app_driver.click(page.findChild(QWidget, "run_send"))
    assert at.shown.path.findings
    assert app_driver.find("preview_bar").isVisible()
    page._table.choose(["Other"])
    app_driver.run(0.3)
    assert at.shown == NOTHING
    assert not app_driver.find("preview_bar").isVisible()


def test_a_finding_stands_where_the_arm_would_be(app_driver):
    at = Operator(app_driver, OUT, BEYOND)
    at.check()
    finding = next(each for each in at.shown.path.findings if each.is_error)
    flange = Kinematics(PIPER).matrix(BEYOND)
    assert finding.place_mm == pytest.approx(flange[:3, 3], abs=1.0)
    assert at.shown.path.marks_mm[0] == pytest.approx(Kinematics(PIPER).matrix(OUT)[:3, 3], abs=1.0)


TOOL = (10.0, -20.0, 80.0, 0.0, 0.0, 30.0)


@pytest.mark.parametrize("tool", [(0.0,) * 6, TOOL])
def test_figures_frame_trail_path_and_points_are_of_one_point(app_driver, tool):
    """By its own kinematics of the measured angles, apart from what each of them is made of."""
    app_driver.store.change(tool=tool, picture_trail_s=60)
    at = Operator(app_driver, OUT, BACK)
    view = app_driver.program.view
    view._on_robot_shown(shape_of(load_robot(URDF / "piper" / "piper.urdf")))
    view._is_started = True
    view.setVisible(True)

    def point(angles_deg):
        flange = Kinematics(PIPER).matrix(angles_deg)
        return flange[:3, 3] + flange[:3, :3] @ np.array(tool[:3])

    at.check()
    path = at.shown.path
    assert path.marks_mm[0] == pytest.approx(point(OUT), abs=0.5)
    assert path.marks_mm[1] == pytest.approx(point(BACK), abs=0.5)
    assert path.places_mm[0] == pytest.approx(point((0.0,) * 6), abs=0.5)
    accepted(app_driver.controller.motion.send_joints(OUT))
    app_driver.come_to_rest()
    here = point(app_driver.controller.state.angles_deg())
    assert view._hud.pose[:3] == pytest.approx(here, abs=0.5)
    assert view._hud.point == ("Tool centre point" if any(tool) else "Flange")
    trail = np.frombuffer(view._state.trail.driven, np.float32).reshape(-1, 3)
    assert trail[-1] == pytest.approx(here, abs=1.5)
    rows = composed(view.shape.flange(view.shape.links(view._state.angles_deg)), view._tool)
    assert [1e3 * rows[place] for place in (3, 7, 11)] == pytest.approx(here, abs=0.5)
    title = app_driver.find("view_bar")._trail_menu.title()
    assert title == ("Trail of the tool centre point" if any(tool) else "Trail of the flange")


def test_the_point_under_way_is_lit_and_the_ghost_steps_aside(at):
    app_driver = at.app_driver
    at.check()
    points = at.editor.document.points
    player = app_driver.controller.player
    accepted(player.start(Run("Test", points, (3.0, 3.0))))
    app_driver.run_until(lambda: player.progress.index == 1)
    app_driver.run(0.1)
    assert at.shown.current_row == 1
    assert at.shown.ghost_deg is None
    app_driver.run_until(lambda: player.progress.phase in OVER)
    app_driver.run(0.1)
    assert at.shown.current_row is None
    assert at.shown.ghost_deg is None, "nobody has asked where the trajectory leads next"
    QTest.keyClick(app_driver.find("preview_slider"), Qt.Key.Key_End)
    assert at.shown.ghost_deg == pytest.approx(points[-1].target, abs=0.5)


def test_the_ghost_steps_aside_for_a_recording_too_and_no_point_is_lit(app_driver):
    app_driver.ready()
    samples = np.array([(t_s, *OUT, 0.0) for t_s in np.arange(0.0, 2.0, 0.1)])
    Library(app_driver.library_folder).save(Recording("taught", samples=samples))
    app_driver.click("library_button")
    library = app_driver.page(LibraryPage)
    library.refresh(["taught"])
    view = cast("ArmView", app_driver.program.view)
    app_driver.click(library.findChild(QWidget, "run_send"))
    assert view._state.preview.ghost_deg is not None
    app_driver.click(library.findChild(QWidget, "accept_warnings"))
    app_driver.run_until(lambda: app_driver.controller.replayer.running)
    app_driver.run(0.1)
    shown = view._state.preview
    assert shown.path is not None
    assert shown.ghost_deg is None
    assert shown.current_row not in (None, *shown.path.rows)
    app_driver.run_until(lambda: not app_driver.controller.replayer.running)
    app_driver.run(0.1)
    assert view._state.preview.current_row is None


def test_a_run_of_another_trajectory_lights_nothing(at):
    at.check()
    player = at.app_driver.controller.player
    accepted(player.start(Run("Other", at.editor.document.points, (3.0, 3.0))))
    at.app_driver.run(0.5)
    assert at.shown.current_row is None


def test_path_findings_and_ghost_go_with_the_page_and_come_back_with_it(app_driver):
    at = Operator(app_driver, OUT, BEYOND, BACK)
    at.check()
    app_driver.find("preview_slider").setFocus()
    QTest.keyClick(app_driver.find("preview_slider"), Qt.Key.Key_End)
    shown = at.shown
    assert shown.path.findings
    app_driver.click("menu_motion")
    assert at.shown == NOTHING
    assert not app_driver.find("preview_bar").isVisible()
    app_driver.click("library_button")
    assert at.shown == shown
    assert app_driver.find("preview_bar").isVisible()


def test_points_that_were_not_checked_go_with_the_page_too(at):
    assert at.shown.path.rows == (0, 1)
    at.app_driver.click("menu_teaching")
    assert at.shown == NOTHING
    at.app_driver.click("library_button")
    assert at.shown.path.rows == (0, 1)


def test_the_page_before_takes_the_picture_of_the_one_that_is_left(at):
    at.check()
    editor = at.editor
    at.app_driver.page(EditorPage).above.open()
    assert at.shown == NOTHING
    editor.open()
    assert len(at.shown.path.places_mm) > 0


def test_another_editor_shows_its_own_points_beside_the_preview_of_the_first(at):
    at.check()
    first, path = at.editor, at.shown.path
    library = Library(at.app_driver.library_folder)
    library.save(Trajectory("Other", points=(Waypoint(MoveMode.MOVE_J, OUT),)))
    first.above.open()
    at.app_driver.page(LibraryPage).open_trajectory("Other")
    assert at.shown.path.rows == (0,)
    assert not at.app_driver.find("preview_bar").isVisible()
    first.open()
    assert at.shown.path.places_mm.tolist() == path.places_mm.tolist()
    assert at.app_driver.find("preview_bar").isVisible()


def test_a_page_in_a_window_of_its_own_keeps_its_path_in_the_picture(at):
    at.check()
    at.app_driver.taken_out(EditorPage)
    at.app_driver.click("menu_motion")
    assert len(at.shown.path.places_mm) > 0


def test_what_is_played_in_the_preview_is_not_played_unseen(at):
    at.check()
    at.app_driver.click("preview_play")
    at.app_driver.click("menu_motion")
    at.app_driver.click("library_button")
    assert at.app_driver.read("preview_play") == "Play"


def test_the_path_of_a_run_under_way_stays_when_the_page_is_left(at):
    app_driver = at.app_driver
    at.check()
    player = app_driver.controller.player
    accepted(player.start(Run("Test", at.editor.document.points, (3.0, 3.0))))
    app_driver.run_until(lambda: player.progress.index == 1)
    app_driver.run(0.1)
    app_driver.click("menu_motion")
    assert at.shown.current_row == 1
    assert len(at.shown.path.places_mm) > 0
    app_driver.run_until(lambda: player.progress.phase in OVER)
    app_driver.run(0.1)
    assert at.shown == NOTHING


class SeenView:
    """A picture that is seen, of the project's own arm."""

    def __init__(self):
        self.shape = shape_of(load_robot(URDF / "piper" / "piper.urdf"))
        self.trails = []
        self.seen = True

    def isVisible(self):  # noqa: N802 - Qt's name
        return self.seen

    def set_trail(self, trail):
        self.trails.append(trail)

    @property
    def driven(self):
        return np.frombuffer(self.trails[-1].driven, np.float32).reshape(-1, 3)


def test_setpoints_that_are_streamed_are_a_line_beside_the_driven_one(app_driver):
    app_driver.ready()
    view = SeenView()
    keeper = TrailKeeper(app_driver.controller, cast("ArmView", view), 60.0)
    app_driver.controller.state_changed.connect(keeper.follow)
    accepted(app_driver.controller.motion.send_joints(OUT))
    app_driver.run(0.5)
    app_driver.run_until(lambda: not app_driver.controller.operating_state.moving, seconds=30.0)
    assert view.trails[-1].commanded == b""  # a target is no way
    accepted(app_driver.controller.jogging.start(JointJog(1, 1)))
    hold(app_driver, 0.6)
    app_driver.controller.state_changed.disconnect(keeper.follow)
    app_driver.controller.jogging.stop()
    commanded = np.frombuffer(view.trails[-1].commanded, np.float32).reshape(-1, 3)
    assert len(commanded) >= 3
    away = np.linalg.norm(view.driven[:, None] - commanded[None], axis=2).min(axis=0)
    assert away.max() < 40.0  # ahead of the arm, by no more than a jog may be


def test_the_trail_is_where_the_arm_was_measured(app_driver):
    app_driver.ready()
    view = SeenView()
    keeper = TrailKeeper(app_driver.controller, cast("ArmView", view), 60.0)
    flanges_mm = []

    def follow(state):
        keeper.follow(state)
        if state.angles_deg() is None:
            return  # at the end, when the device is closed
        flange = Kinematics(PIPER).matrix(state.angles_deg())
        flanges_mm.append(flange[:3, 3])

    app_driver.controller.state_changed.connect(follow)
    accepted(app_driver.controller.motion.send_joints(OUT))
    app_driver.run(0.5)
    app_driver.run_until(lambda: not app_driver.controller.operating_state.moving, seconds=30.0)
    app_driver.run(0.2)  # a trail is handed over now and then
    away = np.linalg.norm(view.driven[:, None] - np.array(flanges_mm)[None], axis=2).min(axis=1)
    assert away.max() < 0.5
    assert np.linalg.norm(view.driven[-1] - view.driven[0]) > 100.0
    told = len(view.trails)
    app_driver.run(1.0)
    assert len(view.trails) == told  # an arm at rest costs nothing
    view.seen = False
    accepted(app_driver.controller.motion.send_joints(BACK))
    app_driver.run(1.0)
    assert len(view.trails) == told  # nor does a picture that nobody sees
    app_driver.controller.state_changed.disconnect(follow)


@pytest.mark.parametrize("of", ["editor", "library"])
def test_a_finding_that_is_pressed_shows_where_the_arm_would_touch(app_driver, of):
    at = Operator(app_driver, FOLDED, TURNED)
    if of == "editor":
        page = at.editor
        at.check()
    else:
        page = at.editor.above
        at.editor.leave()
        page._table.choose(["Test"])
        app_driver.click(page.findChild(QWidget, "run_send"))
    found = page.findChild(QListWidget, "findings_list")
    item = next(each for each in map(found.item, range(found.count())) if "hit" in each.text())
    finding = item.data(Qt.ItemDataRole.UserRole)
    place = found.visualItemRect(item).center()
    QTest.mouseClick(found.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert at.shown.ghost_deg == pytest.approx(finding.joints_deg)
    away = np.abs(np.subtract(at.shown.ghost_deg, (FOLDED, TURNED))).max(axis=1)
    assert away.min() > 5.0, "on the way, not at one of the points"
    app_driver.run(0.3)
    assert at.shown.ghost_deg == pytest.approx(finding.joints_deg), "it stays"
    mark = next(each for each in at.shown.path.findings if each.is_error)
    assert mark.text == item.text().partition(": ")[2]
    assert at.shown.finding == mark, "the links that touch stand out"
    assert set(mark.touching) == {0, 6}
    assert mark.place_mm == finding.contact.place_mm
    flange = Kinematics(PIPER).matrix(finding.joints_deg)
    reach_mm = np.linalg.norm(np.subtract(mark.place_mm, flange[:3, 3]))
    assert reach_mm < 160.0, "at the gripper"
