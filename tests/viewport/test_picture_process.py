"""The picture's process crashes, hangs, starves and is killed; the picture comes back."""

import os
import signal
import sys
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QTimer

from armui.arm.models import robot_description
from armui.protocol.generation import PiperModel
from armui.viewport.camera import ViewDirection
from armui.viewport.camera_input import press_key
from armui.viewport.client import PictureClient
from armui.viewport.messages import (
    DRAWING_STOPPED,
    NO_OPENGL,
    PICTURE_PROCESS_ENDED,
    PICTURE_PROCESS_HUNG,
    PicturePhase,
)
from armui.viewport.path_picture import PathPicture, Preview, Reach, Trail
from armui.viewport.process.urdf_file import MESH_MISSING
from armui.viewport.process_link import URDF_ENDS_VIEW, URDF_HANGS_VIEW
from armui.viewport.view import ArmView
from armui.viewport.watch import LIMITS, Limits
from tests.posix import CONTINUE, KILL, STOP, kill, of_system, stand_still
from tests.viewport.bad_meshes import write_glb_beyond_its_vertices
from tests.viewport.conftest import RAISED
from tests.viewport.foreign import mesh, write_arm
from tests.waiting import LIMIT_MS, wait_until

pytestmark = [
    pytest.mark.skipif(sys.platform == "win32", reason="signals"),
    pytest.mark.timeout(300),  # each loses a process and waits for the next
]

BALL = '<visual><geometry><sphere radius="0.06"/></geometry></visual>'
SWING = tuple((angle, 70.0, -60.0, 20.0, 40.0, 10.0) for angle in range(-60, 60))


@pytest.fixture(autouse=True)
def no_thread_outlives_the_test():
    """The view is the module's: its threads change with each process, and end with the view."""


@pytest.fixture
def losses(view):
    """Every loss of the process."""
    lost: list[Any] = []
    view._client.lost.connect(lost.append)
    yield lost
    view._client.lost.disconnect(lost.append)


@pytest.fixture
def moving(view):
    """The arm moves, as it is reported 30 times a second."""
    angles = iter(SWING * 1000)
    tick = QTimer(interval=33)
    tick.timeout.connect(lambda: view.set_joints(next(angles), 35.0))
    tick.start()
    yield tick
    tick.stop()


def image_of(view):
    return view._picture.image.copy()


def dress(view, tmp_path):
    """Another robot, a path with a ghost, and a camera of the operator's own."""
    view.set_robot(write_arm(tmp_path, visual=BALL))
    places = np.array([[300.0, -300.0, 400.0], [300.0, 300.0, 400.0]])
    path = PathPicture(places, np.array([10.0, 200.0]), places, (0, 1))
    view.set_preview(Preview(path, 1, (10.0, 20.0, -30.0, 0.0, 0.0, 0.0)))
    for key in (Qt.Key.Key_Left, Qt.Key.Key_Plus, Qt.Key.Key_Up):
        view._look_through(press_key(key, view.camera))
    wait_until(lambda: view.is_settled)


def test_a_killed_process_comes_back_with_everything_as_it_was(view, losses, tmp_path):
    dress(view, tmp_path)
    before, camera, pid = image_of(view), view.camera, view._client.pid
    # nothing is asked of it at rest: its end is noticed all the same
    kill(pid)
    wait_until(lambda: losses)
    assert losses[0].comes_back
    assert losses[0].refusal == PICTURE_PROCESS_ENDED(text="SIGKILL")
    assert "SIGKILL" in view._notice()
    assert not view._again_button.isVisible()
    wait_until(lambda: view._lost is None and view.is_settled)
    assert view._client.pid != pid
    assert view.camera == camera
    assert image_of(view) == before
    assert view._notice() == ""


def test_the_model_comes_back_though_its_file_is_gone(view, losses, tmp_path):
    dress(view, tmp_path)
    before = image_of(view)
    (tmp_path / "arm.urdf").unlink()
    kill(view._client.pid)
    wait_until(lambda: losses)
    wait_until(lambda: view._lost is None and view.is_settled)
    assert image_of(view) == before


def test_a_question_is_not_asked_again_of_the_next_process(view, losses, qtbot):
    with qtbot.waitSignal(view._client.joint_picked, timeout=LIMIT_MS):
        qtbot.mouseDClick(view, Qt.MouseButton.LeftButton, pos=QPoint(440, 10))
    answers: list[Any] = []
    view._client.joint_picked.connect(answers.append)
    kill(view._client.pid)
    wait_until(lambda: losses)
    wait_until(lambda: view._lost is None)
    view.set_joints((0.0,) * 6, 0.0)
    wait_until(lambda: view.is_settled)
    assert not answers
    view._client.joint_picked.disconnect(answers.append)


def test_a_process_that_stands_still_looks_old_at_once_and_is_replaced(view, losses, moving):
    pid = view._client.pid
    stand_still(pid)
    wait_until(lambda: view._client.is_stale)
    assert not losses
    assert view._notice() == "Picture delayed"
    wait_until(lambda: losses)
    assert losses[0].comes_back
    assert losses[0].refusal == PICTURE_PROCESS_HUNG()
    wait_until(lambda: view._lost is None)
    assert view._client.pid != pid
    moving.stop()
    wait_until(lambda: view.is_settled)
    assert view._notice() == ""


def darkest(view):
    """Lightness of the darkest pixel of the arm, beside figures and words."""
    shown = view.grab().toImage()
    places = [(x, y) for x in range(180, 300) for y in range(230, 340)]
    return min(shown.pixelColor(x, y).lightness() for x, y in places)


def test_an_old_picture_is_faded(view):
    fresh = darkest(view)
    view._client._is_stale = True
    old = darkest(view)
    view._client._is_stale = False
    assert fresh < 150 < old


def test_a_starved_process_is_waited_for(view, losses, moving):
    pid = view._client.pid
    turns = iter([STOP, CONTINUE] * 10_000)
    starving = QTimer(interval=45)

    def turn():
        signal_number = next(turns)
        # so long that its picture looks old, however fast the computer is
        starving.setInterval(280 if signal_number == STOP else 40)
        os.kill(pid, signal_number)

    starving.timeout.connect(turn)
    starving.start()
    wait_until(lambda: view._client.is_stale)
    shown = view._picture.frame.drawn.sequence
    wait_until(lambda: view._picture.frame.drawn.sequence > shown + 5)
    starving.stop()
    os.kill(pid, CONTINUE)
    moving.stop()
    wait_until(lambda: view.is_settled)
    assert view._client.pid == pid
    assert not losses
    assert not view._client.is_stale


def test_after_three_times_in_a_minute_a_button_is_offered(view, losses, qtbot):
    good = view._state
    view._show(replace(good, angles_deg=(0.0,)))
    wait_until(lambda: len(losses) == 3)
    assert [lost.comes_back for lost in losses] == [True, True, False]
    assert {lost.refusal.reason for lost in losses} == {DRAWING_STOPPED}
    assert "ValueError" in view._notice()
    assert view._again_button.isVisible()
    assert view._client.pid is None
    view._show(good)
    qtbot.mouseClick(view._again_button, Qt.MouseButton.LeftButton)
    assert not view._again_button.isVisible()
    wait_until(lambda: view.is_settled)
    assert view._notice() == ""


def test_a_file_that_crashes_the_process_is_put_aside(view, losses, qtbot, tmp_path):
    before = image_of(view)
    write_glb_beyond_its_vertices(tmp_path / "bad.glb")
    bad = write_arm(tmp_path, visual=mesh("bad.glb"))
    with qtbot.waitSignal(view.load_failed, timeout=LIMIT_MS) as failed:
        view.set_robot(bad)
    assert failed.args == [URDF_ENDS_VIEW(path=str(bad), text="SIGSEGV")]
    wait_until(lambda: view.is_settled)
    assert image_of(view) == before
    assert not losses


def test_a_file_that_never_ends_is_put_aside(qtbot, tmp_path, monkeypatch):
    monkeypatch.setitem(LIMITS, PicturePhase.LOADING, Limits(silent_s=30.0, stuck_s=0.3))
    client = PictureClient("tests.viewport.processes:endless_loading")
    view = ArmView(tmp_path / "endless.urdf", client=client)
    qtbot.addWidget(view)
    with qtbot.waitSignal(view.load_failed, timeout=LIMIT_MS) as failed:
        view.show()
    expected = {"path": str(tmp_path / "endless.urdf")}
    assert failed.args == [URDF_HANGS_VIEW(**expected)]
    wait_until(lambda: view.is_settled)  # the program's own arm
    assert view._notice() == ""
    client.stop()


@pytest.mark.skipif(sys.platform != "linux", reason="limits of another process")
def test_a_process_without_memory_comes_back(view, losses):
    import resource  # noqa: PLC0415 - not on Windows

    of_system("prlimit", resource)(
        view._client.pid, of_system("RLIMIT_AS", resource), (1 << 20, 1 << 20)
    )
    view.resize(1900, 1400)
    wait_until(lambda: losses)
    assert losses[0].comes_back
    wait_until(lambda: view._lost is None and view.is_settled)
    assert view._picture.frame.size_px == (1900, 1400)


def test_without_shared_memory_the_view_says_so(view, losses, monkeypatch):
    def full(_size_bytes):
        raise OSError(28, "no room")

    monkeypatch.setattr("armui.viewport.frame_memory._check_room", full)
    view.resize(1900, 1500)
    wait_until(lambda: losses)
    assert "no room" in losses[0].refusal.params["text"]
    monkeypatch.undo()
    wait_until(lambda: view._lost is None and view.is_settled)


def test_without_opengl_the_widget_says_so(qtbot):
    client = PictureClient("tests.viewport.processes:without_opengl")
    view = ArmView(client=client)
    qtbot.addWidget(view)
    loading_text = view._notice()
    with qtbot.waitSignal(client.lost, timeout=LIMIT_MS) as lost:
        view.show()
    assert (lost.args[0].refusal, lost.args[0].comes_back) == (NO_OPENGL(), False)
    assert "OpenGL" in view._notice() != loading_text
    assert view._again_button.isVisible()
    view.shutdown()


def test_shutdown_ends_the_process_whatever_it_is_doing(qtbot):
    view = ArmView()
    qtbot.addWidget(view)
    view.show()
    wait_until(lambda: view._client.pid is not None)  # still loading
    pid = view._client.pid
    assert pid is not None
    view.shutdown()
    with pytest.raises(ProcessLookupError):
        os.kill(pid, 0)
    assert not view._client.is_running
    view.set_joints((0.0,) * 6, 0.0)
    view.show()
    view.shutdown()


# As it was ----------------------------------------------------------------------------------------


def in_perspective(view):
    """As the operator put it: turned, moved and nearer."""
    view._look_through(view.camera.orbit(70.0, 25.0).pan(20.0, -30.0, 400.0).zoom(2.0))


def without_perspective(view):
    in_perspective(view)
    view.set_orthographic(wanted=True)


def following(view):
    view.look_from(ViewDirection.SIDE)
    view.follow_tool(wanted=True)


def fitting(view):
    view.look_from(ViewDirection.FRONT)
    view._look_through(view.camera.orbit(-25.0, 15.0))


LIMITS_DEG = ((-150.0, 150.0), (0.0, 180.0), (-170.0, 0.0), *((-90.0, 90.0),) * 3)


def dressed(view, tmp_path):
    """Everything that can be in the picture at once, of an arm that has a volume to reach."""
    dress(view, tmp_path)
    view.set_robot(robot_description(PiperModel.PIPER_L))
    driven = np.array([[300.0, 0.0, 300.0], [300.0, 100.0, 400.0], [200.0, 90.0, 300.0]])
    view.set_trail(Trail(driven.astype(np.float32).tobytes()))
    view.set_reach(Reach(LIMITS_DEG))
    view.highlight_joint(3)


def test_a_reach_that_cannot_be_worked_out_leaves_the_picture(view, losses, tmp_path):
    """All axes in one plane: there is no volume."""
    view.set_robot(write_arm(tmp_path, visual=BALL))
    wait_until(lambda: view.is_settled)
    before = image_of(view)
    view.set_reach(Reach(LIMITS_DEG))
    view.highlight_joint(3)
    wait_until(lambda: view.is_settled)
    view.highlight_joint(None)
    wait_until(lambda: view.is_settled)
    view.set_reach(None)
    wait_until(lambda: view.is_settled)
    assert image_of(view) == before
    assert not losses


LOOKS = (in_perspective, without_perspective, following, fitting)
HARMS = (KILL, STOP, signal.SIGSEGV, KILL)


@pytest.mark.parametrize(("look", "harm"), list(zip(LOOKS, HARMS, strict=True)))
def test_the_picture_comes_back_with_every_camera_and_all_that_is_in_it(
    view, losses, tmp_path, look, harm
):
    dressed(view, tmp_path)
    look(view)
    view.set_joints(SWING[3], 20.0)
    wait_until(lambda: view.is_settled)
    before, state, mode = image_of(view), view._state, view.mode
    os.kill(view._client.pid, harm)
    if harm is STOP:  # a process that is asked nothing may stand still
        view.highlight_joint(None)
        view.highlight_joint(3)
    wait_until(lambda: losses)
    wait_until(lambda: view._lost is None and view.is_settled)
    assert (view.mode, view.camera) == (mode, state.camera)
    assert view._state == state
    assert image_of(view) == before


@pytest.mark.parametrize("look", [in_perspective, following, fitting])
def test_the_camera_goes_on_as_with_a_picture_while_the_arm_moves_without_one(view, losses, look):
    """Lost in mid-motion; the same motion with a picture leads to the same view of the arm."""
    cameras = []
    for harm in (None, KILL):
        view.set_joints(SWING[0], 35.0)
        view.reset_view()
        look(view)
        wait_until(lambda: view.is_settled)
        for number, angles_deg in enumerate(SWING[:60:3]):
            view.set_joints(angles_deg, 35.0)
            if number == 5 and harm is not None:
                os.kill(view._client.pid, harm)
                wait_until(lambda: losses)
            view._on_glance()
        wait_until(lambda: view._lost is None and view.is_settled and not view._rest.isActive())
        cameras.append((view.mode, view.camera))
    assert cameras[0] == cameras[1]


def test_a_description_that_was_refused_is_not_tried_again_by_the_next_process(
    view, losses, qtbot, tmp_path
):
    """The arm that was in the picture is in it again, and not an empty floor."""
    dress(view, tmp_path)
    refused: list[Any] = []
    view.load_failed.connect(refused.append)
    bad = write_arm(tmp_path, visual=mesh("none.stl"), name="bad.urdf")
    with qtbot.waitSignal(view.load_failed, timeout=LIMIT_MS):
        view.set_robot(bad)
    wait_until(lambda: view.is_settled)
    before = image_of(view)
    kill(view._client.pid)
    wait_until(lambda: losses)
    wait_until(lambda: view._lost is None and view.is_settled)
    assert image_of(view) == before
    assert len(refused) == 1
    view.load_failed.disconnect(refused.append)


def test_a_description_refused_at_the_start_leaves_the_program_s_own_arm(view, qtbot, tmp_path):
    bad = ArmView(write_arm(tmp_path, visual=mesh("none.stl")))
    bad.resize(view.size())
    bad.set_joints(RAISED, 35.0)
    qtbot.addWidget(bad)
    with qtbot.waitSignal(bad.load_failed, timeout=LIMIT_MS) as failed:
        bad.show()
    assert failed.args[0].reason == MESH_MISSING
    wait_until(lambda: bad.is_settled)
    assert image_of(bad) == image_of(view)
    bad.shutdown()
