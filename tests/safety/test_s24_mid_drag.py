"""S24, S1: whatever happens in mid-drag, the drag has ended, whole, and the arm is not moved."""

import sys
from dataclasses import replace

import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton, QWidget

from armui.control.link.link_state import LinkState
from armui.protocol.codes import MoveMode
from armui.protocol.generation import Generation
from armui.system.paths import URDF
from armui.trajectory.library.store import Library
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_page import LibraryPage
from armui.viewport.client import PictureClient
from armui.viewport.grips import GripKind
from armui.viewport.handles import HandleKind
from armui.viewport.messages import PICTURE_PROCESS_ENDED, PICTURE_PROCESS_HUNG
from armui.viewport.process.robot import shape_of
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.process_link import Lost
from tests.app_driver import AppDriver
from tests.picture_hand import Hand
from tests.posix import kill, stand_still
from tests.waiting import wait_until

OUT = (20.0, 60.0, -70.0, 10.0, 35.0, 15.0)
OTHER = (-15.0, 50.0, -60.0, -10.0, 30.0, -20.0)
MOTION_FRAMES = {*range(0x150, 0x160)}
STOP = (0x150, "0100000000000000")
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture(scope="module")
def shape():
    return shape_of(load_robot(URDF / "piper" / "piper.urdf"))


def moved(app_driver):
    """Frames that move the arm, since they were asked for last."""
    return [each for each in app_driver.heard() if each.arbitration_id in MOTION_FRAMES]


def press_stop(app_driver):
    """Press the button; the first frame on the bus as the press returns."""
    app_driver.heard()
    stop = app_driver.window.findChild(QPushButton, "stop_button")
    QTest.mousePress(stop, LEFT)
    frames = app_driver.heard()
    QTest.mouseRelease(stop, LEFT)
    return (frames[0].arbitration_id, frames[0].data.hex()) if frames else None


def has_ended(hand):
    """Nothing is held any more, by whomever."""
    drag = hand.app_driver.window._picture._drag
    return (
        not hand.view._handles.is_held
        and not hand.view._viewpoint._is_held
        and not hand.view._viewpoint.is_carried
        and not hand.view._drag.is_pressed
        and (drag is None or drag._held is None)
        and QWidget.mouseGrabber() is None
    )


# What happens ---------------------------------------------------------------------------------


def picture_lost(hand):
    lost = Lost(PICTURE_PROCESS_ENDED(text="SIGKILL"), True)
    hand.view._client.lost.emit(lost)


def picture_given_up(hand):
    lost = Lost(PICTURE_PROCESS_HUNG(), False)
    hand.view._client.lost.emit(lost)


def picture_hidden(hand):
    hand.view.hide()
    hand.view.show()


def window_minimised(hand):
    hand.app_driver.window.hide()
    hand.app_driver.window.show()


def button_came_up_elsewhere(hand):
    """As after a screen lock, a native dialog, or a remote desktop that is gone."""
    at = QPointF(5.0, 5.0)
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        at,
        hand.view.mapToGlobal(at),
        Qt.MouseButton.NoButton,
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(hand.view, event)


def arm_silent(hand):
    hand.app_driver.powered = False
    hand.app_driver.run(1.0)


def adapter_gone(hand):
    hand.app_driver.unplug(OSError(19, "No such device"))
    hand.app_driver.run(0.3)
    hand.look()


def disconnected(hand):
    hand.app_driver.controller.disconnect_device()
    hand.app_driver.run(0.2)


def other_limits(hand):
    state = hand.app_driver.controller.operating_state
    limits = tuple(each._replace(max_deg=each.max_deg - 5.0) for each in state.limits)
    _assume(hand, replace(state, limits=limits))


def other_geometry(hand):
    state = hand.app_driver.controller.operating_state
    fit = state.model_fit
    other = fit._replace(chosen=next(each for each in type(fit.chosen) if each != fit.chosen))
    _assume(hand, replace(state, model_fit=other))


def _assume(hand, state):
    """The next look finds this."""
    controller = hand.app_driver.controller
    shown = type(controller).operating_state
    type(controller).operating_state = property(lambda _: state)
    try:
        hand.look()
    finally:
        type(controller).operating_state = shown


def other_tool(hand):
    hand.app_driver.controller.cartesian.tool = (0.0, 0.0, 80.0, 0.0, 0.0, 0.0)
    hand.look()


def other_handles(hand):
    hand.choose(HandleKind.TOOL_FRAME)


def no_handles(hand):
    hand.choose(None)


def other_panel(hand):
    hand.app_driver.click("menu_gripper")
    hand.look()


def escape(hand):
    QTest.keyClick(hand.view, Qt.Key.Key_Escape)


EVERYWHERE = [
    picture_lost,
    picture_given_up,
    picture_hidden,
    window_minimised,
    button_came_up_elsewhere,
    arm_silent,
    adapter_gone,
    disconnected,
    other_limits,
    other_geometry,
    other_tool,
    other_handles,
    no_handles,
    escape,
]


def grip_of(hand, kind):
    if kind is HandleKind.JOINTS:
        return hand.grip(GripKind.JOINT, 1)
    return hand.grip(GripKind.AXIS, 2)


@pytest.fixture
def hand(app_driver, shape, qtbot):
    """At the fields of 运动控制; an exception in a slot fails the test."""
    hand = Hand(app_driver, shape)
    for joint, angle_deg in enumerate(OUT, start=1):
        app_driver.type_into(f"target_field_{joint}", f"{angle_deg}")
    return hand


@pytest.mark.each_value(full="each event with both handles")
@pytest.mark.parametrize("kind", [HandleKind.TOOL, HandleKind.JOINTS])
@pytest.mark.parametrize("what", [*EVERYWHERE, other_panel], ids=lambda what: what.__name__)
def test_a_handle_held_as_it_happens_is_let_go_and_all_stands_as_before(hand, what, kind):
    app_driver = hand.app_driver
    hand.choose(kind)
    panel = app_driver.window.findChild(object, "operation_area").currentWidget()
    before = panel.targets()
    x, y = hand.place_on(grip_of(hand, kind))
    moved(app_driver)
    hand.press((x, y))
    hand.move((x + 12.0, y - 12.0))
    assert panel.targets() != before
    what(hand)
    hand.look()
    assert has_ended(hand)
    assert panel.targets() == pytest.approx(before, abs=1e-6)
    hand.move((x + 40.0, y - 40.0))  # the hand goes on, and lets go at last
    hand.release((x + 40.0, y - 40.0))
    assert has_ended(hand)
    assert panel.targets() == pytest.approx(before, abs=1e-6)
    assert moved(app_driver) == []
    if app_driver.controller.operating_state.link is LinkState.ONLINE:
        assert press_stop(app_driver) == STOP


@pytest.mark.each_value(full="each event with both buttons")
@pytest.mark.parametrize(
    "what",
    [picture_lost, picture_given_up, picture_hidden, window_minimised, button_came_up_elsewhere],
    ids=lambda what: what.__name__,
)
@pytest.mark.parametrize("button", [LEFT, Qt.MouseButton.MiddleButton])
def test_a_camera_drag_ends_as_it_happens(hand, what, button):
    hand.choose(None)
    QTest.mousePress(hand.view, button, pos=hand.view.rect().center())
    assert not has_ended(hand)
    what(hand)
    assert has_ended(hand)
    camera = hand.view.camera
    button_came_up_elsewhere(hand)
    assert hand.view.camera == camera


def test_the_right_button_holds_nothing(hand):
    QTest.mousePress(hand.view, Qt.MouseButton.RightButton, pos=hand.view.rect().center())
    assert has_ended(hand)


def test_another_button_beside_the_one_that_holds_changes_nothing(hand):
    x, y = hand.place_on(grip_of(hand, HandleKind.TOOL))
    hand.press((x, y))
    QTest.mousePress(hand.view, Qt.MouseButton.MiddleButton, pos=hand.view.rect().center())
    assert hand.view._handles.is_held
    QTest.mouseRelease(hand.view, Qt.MouseButton.MiddleButton, pos=hand.view.rect().center())
    hand.move((x, y - 15.0))
    hand.release((x, y - 15.0))
    assert has_ended(hand)


def test_a_second_press_after_a_release_that_was_lost_begins_anew(hand):
    before = hand.fields()
    x, y = hand.place_on(grip_of(hand, HandleKind.TOOL))
    hand.press((x, y))
    hand.move((x, y - 15.0))
    hand.press((5.0, 5.0))
    hand.release((5.0, 5.0))
    assert has_ended(hand)
    assert hand.fields() == pytest.approx(before)


# At a point of a trajectory ---------------------------------------------------------------------


class AtEditor(Hand):
    def __init__(self, app_driver, shape):
        super().__init__(app_driver, shape)
        points = [Waypoint(MoveMode.MOVE_J, each) for each in (OUT, OTHER, OUT)]
        Library(app_driver.library_folder).save(Trajectory("Test", points=tuple(points)))
        app_driver.click("library_button")
        app_driver.page(LibraryPage).open_trajectory("Test")
        self.editor = app_driver.page(EditorPage)
        app_driver.wait(self.editor.isActiveWindow)
        self.editor.table.select_row(1)


@pytest.fixture
def at_editor(app_driver, shape):
    return AtEditor(app_driver, shape)


def another_row(hand):
    hand.editor.table.select_row(2)
    hand.look()


def row_deleted(hand):
    hand.editor.table.select_row(1)
    QTest.keyClick(hand.editor.table, Qt.Key.Key_Delete)


def everything_deleted(hand):
    hand.editor.table.selectAll()
    QTest.keyClick(hand.editor.table, Qt.Key.Key_Delete)


def page_taken_out(hand):
    hand.app_driver.taken_out(EditorPage)


def page_taken_out_and_put_back(hand):
    page = hand.app_driver.taken_out(EditorPage)
    page.window().close()


def library_closed(hand):
    hand.app_driver.click("library_button")
    hand.look()


@pytest.mark.parametrize(
    "what",
    [
        *(each for each in EVERYWHERE if each is not disconnected),
        another_row,
        row_deleted,
        everything_deleted,
        page_taken_out,
        page_taken_out_and_put_back,
        library_closed,
    ],
    ids=lambda what: what.__name__,
)
def test_a_point_held_as_it_happens_changes_by_nothing_but_that(at_editor, what):
    hand, app_driver = at_editor, at_editor.app_driver
    document = hand.editor.document
    x, y = hand.place_on(grip_of(hand, HandleKind.TOOL))
    moved(app_driver)
    hand.press((x, y))
    hand.move((x + 4.0, y - 15.0))
    what(hand)
    hand.look()
    points, steps = document.points, document.stack.count()
    goes_on = what in (page_taken_out, page_taken_out_and_put_back)
    assert goes_on or has_ended(hand)
    hand.move((x + 10.0, y - 25.0))
    if goes_on:
        QTest.keyClick(hand.view, Qt.Key.Key_Escape)
    hand.release((x + 10.0, y - 25.0))
    assert has_ended(hand)
    assert document.points == points
    assert document.stack.count() == steps
    while document.stack.canUndo():
        document.stack.undo()
    assert [each.target for each in document.points] == [OUT, OTHER, OUT]
    assert moved(app_driver) == []


# With a picture's process that is really lost --------------------------------------------------


@pytest.fixture
def drawing(qapp, request, tmp_path):
    pictures = PictureClient()
    app_driver = AppDriver(
        qapp,
        request.node.nodeid,
        tmp_path / "settings.json",
        Generation.TWO,
        draws=True,
        pictures=pictures,
    )
    app_driver.ready()
    wait_until(lambda: app_driver.program.view.is_settled)
    yield app_driver
    app_driver.close()
    pictures.stop()


class Drawn(Hand):
    """At a picture that a process draws."""

    def __init__(self, app_driver):
        self.app_driver = app_driver
        self.view = app_driver.program.view
        self.bar = app_driver.find("view_bar")


@pytest.mark.each_value(full="each handle, killed and standing still")
@pytest.mark.skipif(sys.platform == "win32", reason="signals")
@pytest.mark.timeout(300)
@pytest.mark.parametrize("harm", [kill, stand_still])
@pytest.mark.parametrize("kind", [HandleKind.TOOL, HandleKind.JOINTS, None])
def test_the_picture_s_process_lost_in_mid_drag(drawing, kind, harm):
    hand, view = Drawn(drawing), drawing.program.view
    for joint, angle_deg in enumerate(OUT, start=1):
        drawing.type_into(f"target_field_{joint}", f"{angle_deg}")
    hand.choose(kind)
    losses: list[object] = []
    view._client.lost.connect(losses.append)
    before = hand.fields()
    at = (40.0, view.height() - 40.0) if kind is None else hand.place_on(grip_of(hand, kind))
    wait_until(lambda: not view.is_late)
    moved(drawing)
    hand.press(at)
    hand.move((at[0] + 12.0, at[1] - 12.0))
    assert not has_ended(hand)
    harm(view._client.pid)
    wait_until(lambda: losses)
    assert has_ended(hand)
    camera = view.camera
    assert hand.fields() == pytest.approx(before, abs=1e-6)
    assert press_stop(drawing) == STOP
    hand.move((at[0] + 30.0, at[1] - 30.0))
    hand.release((at[0] + 30.0, at[1] - 30.0))
    drawing.run(0.3)
    wait_until(lambda: view._lost is None)
    # the stop has let the arm sink: a camera that fits it may have stepped back
    assert (view.camera.azimuth_deg, view.camera.elevation_deg) == (
        camera.azimuth_deg,
        camera.elevation_deg,
    )
    assert has_ended(hand)
    assert [each for each in moved(drawing) if each.arbitration_id != 0x150] == []
