"""An operator drags in the picture: targets and points change, and nothing moves."""

import math
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from armui.cell.cell import Cell, with_part
from armui.cell.tools import Tool
from armui.cell.user_frames import UserFrame
from armui.protocol.codes import MoveMode
from armui.system.paths import URDF
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.viewport.camera import ViewDirection
from armui.viewport.client import PictureClient
from armui.viewport.grips import GripKind
from armui.viewport.handles import HandleKind
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from tests.accepted import accepted
from tests.picture_hand import Hand
from tests.trajectory.frame_oracle import apart, carried, turn, within

OUT = (20.0, 60.0, -70.0, 10.0, 35.0, 15.0)
BACK = (-15.0, 50.0, -60.0, -10.0, 30.0, -20.0)
MOTION_FRAMES = {*range(0x150, 0x160)} - {0x15A, 0x15F}


@pytest.fixture(scope="module")
def shape():
    return shape_of(load_robot(URDF / "piper" / "piper.urdf"))


@pytest.fixture
def hand(app_driver, shape):
    return Hand(app_driver, shape)


@pytest.fixture
def no_motion(app_driver):
    """Nothing that moves the arm is sent while a test drags."""

    def sent():
        return [frame for frame in app_driver.heard() if frame.arbitration_id in MOTION_FRAMES]

    return sent


def fill_fields(app_driver, angles_deg):
    for joint, angle_deg in enumerate(angles_deg, start=1):
        app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")


@pytest.mark.each_value(full="each axis there and back")
@pytest.mark.parametrize("number", [0, 1, 2])
@pytest.mark.parametrize("by_px", [(40.0, -25.0), (-30.0, 20.0)])
def test_the_ghost_s_tool_goes_along_the_axis_with_the_pointer(hand, no_motion, number, by_px):
    app_driver = hand.app_driver
    fill_fields(app_driver, OUT)
    grip = hand.grip(GripKind.AXIS, number)
    # along the axis as it is seen, so that the pointer stays on it
    start, ahead = (hand.view.projection.pixel(place) for place in grip.places[:2])
    along = np.array(ahead) - start
    along /= np.linalg.norm(along)
    length = float(np.dot(along, by_px))
    before = hand.tool_px(OUT)
    no_motion()
    hand.drag(grip, tuple(along * length))
    after = hand.tool_px(hand.ghost)
    # the press was at one place of the axis, the tool is at another: nearer to the eye or farther
    # a pixel is another length, so a stretch is compared that both went through
    origin = np.array(grip.origin)
    pressed = hand.view.projection.ray(*hand_place(hand, grip))
    ended = hand.view.projection.ray(*(np.array(hand_place(hand, grip)) + along * length))
    gone = passing(ended, origin, grip.axis) - passing(pressed, origin, grip.axis)
    expected = hand.view.projection.pixel(tuple(origin + gone * np.array(grip.axis)))
    assert math.dist(after, expected) < 1.0
    assert math.dist(after, before) > 10.0
    assert hand.fields() == pytest.approx(hand.ghost, abs=5e-4)
    assert no_motion() == []


def hand_place(hand, grip):
    return hand.place_on(grip)


def passing(ray, origin, axis):
    """Metres along a line to where a ray passes it; solved apart from the program."""
    matrix = np.column_stack((np.array(axis), -np.array(ray.direction)))
    (along, _), *_ = np.linalg.lstsq(matrix, np.array(ray.start_m) - origin, rcond=None)
    return along


def test_a_drag_and_send_move_the_arm_to_where_the_ghost_stands(hand, no_motion):
    app_driver = hand.app_driver
    fill_fields(app_driver, OUT)
    hand.drag(hand.grip(GripKind.AXIS, 2), (0.0, -30.0))
    ghost = hand.ghost
    app_driver.run(1.0)
    assert app_driver.controller.state.angles_deg() == pytest.approx((0.0,) * 6, abs=0.1)
    assert no_motion() == []
    app_driver.click("send_button")
    app_driver.run(0.5)
    assert no_motion() != []
    app_driver.run_until(lambda: not app_driver.controller.operating_state.moving, seconds=30.0)
    assert app_driver.controller.state.angles_deg() == pytest.approx(ghost, abs=0.1)
    hand.look()
    assert hand.ghost is None  # it would be one with the arm


@pytest.mark.each_value(full="each joint from each direction")
@pytest.mark.parametrize("direction", [None, ViewDirection.FRONT, ViewDirection.SIDE])
@pytest.mark.parametrize("number", range(1, 7))
def test_an_arc_turns_its_joint_and_no_other(hand, number, direction):
    fill_fields(hand.app_driver, OUT)
    if direction is not None:
        hand.view.look_from(direction)  # some are seen from their edge
    hand.choose(HandleKind.JOINTS)
    grip = hand.grip(GripKind.JOINT, number)
    at = hand.place_on(grip)
    middle = hand.view.projection.pixel(grip.origin)
    away = np.array(at) - middle
    turned = np.array([-away[1], away[0]]) / np.linalg.norm(away) * 12.0
    hand.drag(grip, tuple(turned))
    changed = [joint for joint in range(6) if abs(hand.ghost[joint] - OUT[joint]) > 1e-6]
    assert changed == [number - 1]
    # the place that was taken hold of has gone with the pointer
    links = hand.view.shape.links(hand.ghost)
    _, axis = hand.view.shape.joint_frame(number, links)
    assert axis == pytest.approx(grip.axis, abs=1e-6)


def test_ctrl_snaps_to_whole_coordinates_and_shift_to_fine_ones(hand):
    app_driver = hand.app_driver
    fill_fields(app_driver, OUT)
    kinematics = app_driver.controller.cartesian.kinematics()
    grip = hand.grip(GripKind.AXIS, 0)
    hand.drag(grip, (23.0, 9.0), Qt.KeyboardModifier.ControlModifier)
    x = kinematics.forward(hand.ghost).x_mm
    assert x / 10.0 == pytest.approx(round(x / 10.0), abs=0.005)
    hand.choose(HandleKind.JOINTS)
    hand.drag(hand.grip(GripKind.JOINT, 1), (14.0, 3.0), Qt.KeyboardModifier.ShiftModifier)
    assert hand.ghost[0] == pytest.approx(round(hand.ghost[0]))


def test_what_cannot_be_reached_is_refused_with_the_reason(hand, no_motion):
    app_driver = hand.app_driver
    fill_fields(app_driver, OUT)
    grip = hand.grip(GripKind.AXIS, 0)
    x, y = hand.place_on(grip)
    start, ahead = (hand.view.projection.pixel(place) for place in grip.places[:2])
    along = (np.array(ahead) - start) / math.dist(ahead, start)
    hand.press((x, y))
    hand.move((x + along[0] * 5.0, y + along[1] * 5.0))
    near = hand.ghost
    hand.move((x + along[0] * 900.0, y + along[1] * 900.0))
    note = app_driver.find("picture_note")
    assert note.isVisible()
    assert "reach" in note.text()
    assert hand.ghost == near  # where it could be
    hand.move((x + along[0] * 6.0, y + along[1] * 6.0))
    assert not note.isVisible()
    hand.release((x + along[0] * 6.0, y + along[1] * 6.0))
    assert no_motion() == []


def test_a_joint_stops_at_its_limit_and_says_so(hand):
    fill_fields(hand.app_driver, (148.0, *OUT[1:]))
    hand.choose(HandleKind.JOINTS)
    hand.look()
    grip = hand.grip(GripKind.JOINT, 1)
    before = hand.fields()
    kinds = []
    for sign in (1.0, -1.0):
        at = np.array(hand.place_on(grip))
        away = at - hand.view.projection.pixel(grip.origin)
        side = sign * np.array([-away[1], away[0]]) * 1.5
        hand.press(tuple(at))
        hand.move(tuple(at + side))
        kinds.append(hand.app_driver.find("picture_note").isVisible())
        QTest.keyClick(hand.view, Qt.Key.Key_Escape)
        hand.release(tuple(at + side))
    assert sorted(kinds) == [False, True]
    assert hand.fields() == before  # Escape gives it up


def test_the_camera_is_turned_beside_the_handles_and_rests_while_one_is_held(hand):
    fill_fields(hand.app_driver, OUT)
    grip = hand.grip(GripKind.AXIS, 1)
    at = hand.place_on(grip)
    camera = hand.view.camera
    hand.press(at)
    hand.move((at[0] + 10.0, at[1]))
    assert hand.view.camera == camera
    hand.release(at)
    empty = (5.0, float(hand.view.height() - 5))
    hand.press(empty)
    hand.move((empty[0] + 30.0, empty[1]))
    hand.release(empty)
    assert hand.view.camera.azimuth_deg != camera.azimuth_deg


def test_what_was_not_dragged_goes_on_to_follow_the_arm(hand):
    """Sending takes no joint back that moved meanwhile, and Escape leaves no target behind."""
    app_driver = hand.app_driver
    accepted(app_driver.controller.motion.send_joints(OUT))
    app_driver.come_to_rest()
    panel = app_driver.window.findChild(object, "operation_area").currentWidget()
    assert panel.given() == (False,) * 6
    hand.choose(HandleKind.JOINTS)
    grip = hand.grip(GripKind.JOINT, 1)
    at = hand.place_on(grip)
    hand.press(at)
    hand.move((at[0] + 15.0, at[1]))
    assert panel.given() == (True, *(False,) * 5)
    QTest.keyClick(hand.view, Qt.Key.Key_Escape)
    hand.release(at)
    assert panel.given() == (False,) * 6
    hand.drag(hand.grip(GripKind.JOINT, 1), (15.0, 0.0))
    assert panel.given() == (True, *(False,) * 5)


def test_in_tool_control_the_pose_fields_go_along(hand, no_motion):
    app_driver = hand.app_driver
    app_driver.click("menu_cartesian")
    app_driver.run(0.2)
    no_motion()
    field = app_driver.find("pose_field_Z")
    before = field.value
    grip = hand.grip(GripKind.AXIS, 2)
    hand.drag(grip, (0.0, -30.0))
    assert field.value > before + 5.0
    pose = app_driver.controller.cartesian.kinematics().forward(hand.ghost)
    assert field.value == pytest.approx(pose.z_mm, abs=0.01)
    assert no_motion() == []


class AtEditor(Hand):
    """At the editor of a trajectory, with the picture beside it."""

    def __init__(self, app_driver, shape, points):
        super().__init__(app_driver, shape)
        Library(app_driver.library_folder).save(Trajectory("Test", points=points))
        app_driver.click("library_button")
        app_driver.page(LibraryPage).open_trajectory("Test")
        self.editor = app_driver.page(EditorPage)
        app_driver.wait(self.editor.isActiveWindow)


@pytest.fixture
def at_editor(app_driver, shape):
    pose = Waypoint(MoveMode.MOVE_L, (300.0, 0.0, 250.0, 0.0, 85.0, 0.0), speed_percent=20)
    return AtEditor(app_driver, shape, (Waypoint(MoveMode.MOVE_J, OUT, note="begin"), pose))


def test_the_chosen_row_has_its_ghost_and_the_points_their_numbers(at_editor):
    assert at_editor.ghost == pytest.approx(OUT)
    path = at_editor.view._state.preview.path
    assert path.rows == (0, 1)
    at_editor.editor.table.select_row(1)
    model = at_editor.app_driver.controller.cartesian.kinematics()
    assert model.forward(at_editor.ghost)[:3] == pytest.approx((300.0, 0.0, 250.0), abs=0.01)
    assert at_editor.view._state.preview.path is path  # nothing is built anew for another row
    at_editor.view.mark_picked.emit(0)
    assert at_editor.editor.table.current_row() == 0


@pytest.mark.parametrize("row", [0, 1])
def test_a_drag_changes_the_chosen_point_in_one_step_of_undo(at_editor, no_motion, row):
    editor = at_editor.editor
    editor.table.select_row(row)
    before = editor.document.points
    steps = editor.document.stack.count()
    no_motion()
    at_editor.drag(at_editor.grip(GripKind.AXIS, 2), (0.0, -25.0))
    points = editor.document.points
    assert editor.document.stack.count() == steps + 1
    assert points[1 - row] is before[1 - row]
    model = at_editor.app_driver.controller.cartesian.kinematics()
    changed = points[row]
    assert (changed.move, changed.note) == (before[row].move, before[row].note)
    ghost = model.forward(at_editor.ghost)
    flange = model.forward(changed.target) if changed.is_joint else changed.target
    assert flange[:3] == pytest.approx(ghost[:3], abs=0.02)
    old = model.forward(before[row].target) if changed.is_joint else before[row].target
    assert flange[2] > old[2] + 3.0
    assert flange[:2] == pytest.approx(old[:2], abs=0.05)
    assert editor.table.current_row() == row
    editor.document.stack.undo()
    assert editor.document.points == before
    assert no_motion() == []


def test_a_point_in_a_user_frame_is_dragged_there(app_driver, shape):
    frame = UserFrame("Table", (250.0, -80.0, 40.0, 10.0, -20.0, 35.0))
    place = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
    there = Waypoint(MoveMode.MOVE_L, within(frame.pose, place), frame="Table")
    at = AtEditor(app_driver, shape, (Waypoint(MoveMode.MOVE_J, OUT), there))
    accepted(app_driver.controller.cell.take(with_part(Cell("bench"), frame)))
    at.editor.table.select_row(1)
    at.drag(at.grip(GripKind.AXIS, 2), (0.0, -25.0))
    changed = at.editor.document.points[1]
    assert (changed.move, changed.frame) == (MoveMode.MOVE_L, "Table")
    flange = carried(frame.pose, changed.target)
    ghost = app_driver.controller.cartesian.kinematics().forward(at.ghost)
    assert apart(flange, ghost)[0] < 0.002
    assert changed.target[2] > there.target[2] + 3.0
    assert changed.target[:2] == pytest.approx(there.target[:2], abs=0.05)


LEANS = UserFrame("Leans", (250.0, -80.0, 40.0, 10.0, -20.0, 35.0))
PEN = Tool("pen", (10.0, -5.0, 100.0, 15.0, -25.0, 40.0))
STOOD = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)


def differing(before, after):
    return [place for place in range(6) if abs(after[place] - before[place]) > 0.02]


@pytest.mark.parametrize("number", [0, 1, 2])
def test_the_handles_of_a_point_go_along_the_frame_of_its_figures(app_driver, shape, number):
    """Of the tool's pose in that frame one coordinate changes, by steps of 10 mm with Ctrl."""
    there = Waypoint(MoveMode.MOVE_L, within(LEANS.pose, STOOD), frame="Leans")
    at = AtEditor(app_driver, shape, (there,))
    bench = with_part(with_part(Cell("bench"), PEN), LEANS)
    accepted(app_driver.controller.cell.take(replace(bench, frame="")))
    before = carried(there.target, PEN.pose)
    grip = at.grip(GripKind.AXIS, number)
    assert grip.axis == pytest.approx(turn(LEANS.pose).as_matrix()[:, number], abs=1e-6)
    start, ahead = (np.array(at.view.projection.pixel(place)) for place in grip.places[:2])
    by_px = tuple(30.0 * (ahead - start) / np.linalg.norm(ahead - start))
    at.drag(grip, by_px, Qt.KeyboardModifier.ControlModifier)
    after = carried(at.editor.document.points[0].target, PEN.pose)
    assert differing(before, after) == [number]
    assert after[number] == pytest.approx(round(after[number], -1), abs=0.02)


def test_the_handles_of_a_typed_target_go_along_the_frame_in_force(hand, no_motion):
    app_driver = hand.app_driver
    accepted(app_driver.controller.cell.take(with_part(Cell("bench"), LEANS)))
    app_driver.click("menu_cartesian")
    app_driver.run(0.2)
    for axis, value in zip(
        ("X", "Y", "Z", "RX", "RY", "RZ"), within(LEANS.pose, STOOD), strict=True
    ):
        app_driver.type_into(f"pose_field_{axis}", f"{value:.3f}")
    no_motion()
    fields = [app_driver.find(f"pose_field_{axis}") for axis in ("X", "Y", "Z", "RX", "RY", "RZ")]
    before = [field.value for field in fields]
    grip = hand.grip(GripKind.AXIS, 1)
    assert grip.axis == pytest.approx(turn(LEANS.pose).as_matrix()[:, 1], abs=1e-6)
    hand.drag(grip, (25.0, 0.0))
    assert differing(before, [field.value for field in fields]) == [1]
    hand.choose(HandleKind.TOOL_FRAME)
    assert hand.grip(GripKind.AXIS, 1).axis != pytest.approx(grip.axis, abs=0.01)
    assert no_motion() == []


def test_a_frame_that_changes_during_a_drag_ends_it(app_driver, shape):
    there = Waypoint(MoveMode.MOVE_L, within(LEANS.pose, STOOD), frame="Leans")
    at = AtEditor(app_driver, shape, (there,))
    bench = with_part(Cell("bench"), LEANS)
    accepted(app_driver.controller.cell.take(bench))
    x, y = at.place_on(at.grip(GripKind.AXIS, 2))
    at.press((x, y))
    at.move((x, y - 15.0))
    other = replace(LEANS, pose=(250.0, -80.0, 60.0, 10.0, -20.0, 35.0))
    accepted(app_driver.controller.cell.change(with_part(bench, other, instead_of="Leans")))
    at.move((x, y - 25.0))
    at.release((x, y - 25.0))
    assert at.editor.document.points == (there,)


def test_a_point_is_dragged_to_round_figures_of_the_tool(app_driver, shape):
    pen = Tool("pen", (10.0, -5.0, 100.0, 15.0, -25.0, 40.0))
    place = (300.0, 0.0, 250.0, 0.0, 85.0, 0.0)
    at = AtEditor(app_driver, shape, (Waypoint(MoveMode.MOVE_L, place),))
    accepted(app_driver.controller.cell.take(with_part(Cell("bench"), pen)))
    at.drag(at.grip(GripKind.AXIS, 2), (0.0, -25.0))
    changed = at.editor.document.points[0].target
    ghost = app_driver.controller.cartesian.kinematics().forward(at.ghost)
    assert apart(changed, ghost)[0] < 0.002
    assert changed[2] > place[2] + 3.0
    model = at.editor.table.model()
    exact = [model.index(0, column).data(Qt.ItemDataRole.EditRole) for column in range(1, 7)]
    assert [float(text) for text in exact] == pytest.approx(carried(changed, pen.pose), abs=1e-6)
    assert all(len(text.partition(".")[2]) <= 3 for text in exact)


def test_the_ghost_goes_with_the_slider_until_a_row_is_chosen(at_editor):
    QTest.keyClick(at_editor.editor, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
    at_editor.look()
    assert at_editor.ghost == pytest.approx(OUT)  # of the row that is chosen
    slider = at_editor.app_driver.find("preview_slider")
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_End)
    QTest.keyClick(slider, Qt.Key.Key_Home)
    for _ in range(3):
        at_editor.look()
        assert at_editor.ghost == pytest.approx((0.0,) * 6, abs=0.5)
    QTest.keyClick(slider, Qt.Key.Key_PageUp)
    on_the_way = at_editor.ghost
    at_editor.look()
    assert at_editor.ghost == on_the_way
    at_editor.editor.table.select_row(1)
    at_editor.look()
    assert at_editor.ghost[1] == pytest.approx(86.145, abs=0.01)
    at_editor.editor.table.select_row(0)
    at_editor.look()
    assert at_editor.ghost == pytest.approx(OUT, abs=0.5)
    QTest.keyClick(slider, Qt.Key.Key_Home)
    at_editor.drag(at_editor.grip(GripKind.AXIS, 2), (0.0, -20.0))  # what is dragged is seen
    assert at_editor.editor.document.points[0].target != OUT
    assert at_editor.ghost == pytest.approx(at_editor.editor.document.points[0].target, abs=0.01)


def test_a_drag_that_is_given_up_changes_nothing(at_editor):
    editor = at_editor.editor
    grip = at_editor.grip(GripKind.RING, 2)
    at = at_editor.place_on(grip)
    steps = editor.document.stack.count()
    at_editor.press(at)
    at_editor.move((at[0] + 15.0, at[1] + 5.0))
    assert at_editor.ghost != pytest.approx(OUT)
    QTest.keyClick(at_editor.view, Qt.Key.Key_Escape)
    at_editor.release(at)
    assert editor.document.stack.count() == steps
    assert at_editor.ghost == pytest.approx(OUT)


def test_the_range_of_a_joint_is_shown_while_its_cell_is_edited(at_editor):
    model = at_editor.editor.model
    at_editor.editor.table.setCurrentIndex(model.index(0, 3))
    number, limits_deg = at_editor.view._range
    assert limits_deg[0] < OUT[number - 1] < limits_deg[1]
    at_editor.editor.table.setCurrentIndex(model.index(1, 3))  # a pose has no joints
    assert at_editor.view._range is None


def test_nothing_is_taken_hold_of_in_a_picture_that_is_late(hand, monkeypatch):
    """S24: what looks old is not aimed at."""
    fill_fields(hand.app_driver, OUT)
    at = hand.place_on(hand.grip(GripKind.AXIS, 1))
    monkeypatch.setattr(PictureClient, "is_stale", True)
    hand.press(at)
    hand.move((at[0] + 20.0, at[1]))
    hand.release(at)
    assert hand.fields() == pytest.approx(OUT)


def test_without_handles_a_press_only_turns_the_camera(hand):
    fill_fields(hand.app_driver, OUT)
    at = hand.place_on(hand.grip(GripKind.AXIS, 1))
    hand.choose(None)
    fields = hand.fields()
    hand.press(at)
    hand.move((at[0] + 20.0, at[1]))
    hand.release(at)
    assert hand.fields() == fields
    assert hand.ghost == pytest.approx(OUT)  # what was typed is seen without handles, too
