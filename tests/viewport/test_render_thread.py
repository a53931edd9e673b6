"""Pictures handed from thread to thread, and the thread's end."""

import threading
from dataclasses import replace

import pytest

from armui.arm.refusal import Refusal
from armui.paths import URDF
from armui.viewport.errors import DRAWING_STOPPED, NO_OPENGL
from armui.viewport.render_thread import RenderThread
from armui.viewport.view_state import RobotChoice, ViewState

STATE = ViewState(
    RobotChoice(URDF / "piper.urdf"),
    width_px=300,
    height_px=150,
    pixel_ratio=1.5,
    angles_deg=(0.0,) * 6,
    gripper_mm=0.0,
)


def drawing_threads() -> list[threading.Thread]:
    return [thread for thread in threading.enumerate() if thread.name == "armui-viewport"]


@pytest.fixture(params=[True, False], ids=["threaded", "inline"])
def renderer(request, qapp):
    renderer = RenderThread(threaded=request.param)
    yield renderer
    renderer.stop()
    assert not drawing_threads()


def test_a_state_becomes_a_picture_of_its_size(renderer, qtbot):
    with qtbot.waitSignal(renderer.frame_ready, timeout=20_000) as drawn:
        renderer.start()
        renderer.show(STATE)
    (image,) = drawn.args
    assert (image.width(), image.height(), image.devicePixelRatio()) == (300, 150, 1.5)
    assert len({image.pixel(x, 75) for x in range(300)}) > 10


def test_the_next_picture_waits_until_the_last_was_taken(renderer, qtbot):
    with qtbot.waitSignal(renderer.frame_ready, timeout=20_000):
        renderer.start()
        renderer.show(STATE)
    early = []
    renderer.frame_ready.connect(early.append)
    for angle_deg in range(1, 6):
        renderer.show(replace(STATE, angles_deg=(float(angle_deg),) * 6))
    qtbot.wait_until(lambda: renderer._mailbox.has_item)
    assert not early
    with qtbot.waitSignal(renderer.frame_ready, timeout=20_000):
        renderer.frame_taken()
    # one picture for the five states: the latest
    assert len(early) == 1
    assert not renderer._mailbox.has_item


def test_a_picture_at_rest_is_refined_and_then_left_alone(renderer, qtbot):
    frames = []
    renderer.frame_ready.connect(frames.append)
    renderer.frame_ready.connect(lambda _image: renderer.frame_taken())
    with qtbot.waitSignals([renderer.frame_ready] * 2, timeout=20_000):
        renderer.start()
        renderer.show(STATE)
    rough, fine = frames
    assert rough != fine
    renderer.show(replace(STATE))
    qtbot.wait_until(lambda: not renderer._mailbox.has_item)
    renderer.stop()
    qtbot.wait_until(lambda: not renderer.is_running)
    assert len(frames) == 2


def test_an_unforeseen_error_is_told_and_ends_the_drawing_only(renderer, qtbot, caplog):
    with qtbot.waitSignal(renderer.failed, timeout=20_000) as failed:
        renderer.start()
        renderer.show(replace(STATE, angles_deg=(0.0,)))
    (reason,) = failed.args
    assert reason.code == DRAWING_STOPPED
    assert reason.params["text"].startswith("ValueError: ")
    assert "3D view stopped" in caplog.text


def test_no_opengl_is_told(renderer, qtbot, monkeypatch):
    monkeypatch.setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow")
    monkeypatch.setattr("ctypes.util.find_library", lambda _name: None)
    with qtbot.waitSignal(renderer.failed, timeout=20_000) as failed:
        renderer.start()
        renderer.show(STATE)
    assert failed.args == [Refusal(NO_OPENGL)]


def test_stop_ends_the_thread_whatever_it_waits_for(qapp, qtbot):
    idle = RenderThread(threaded=True)
    idle.start()
    assert len(drawing_threads()) == 1
    idle.stop()
    assert not drawing_threads()
    idle.stop()

    blocked = RenderThread(threaded=True)
    with qtbot.waitSignal(blocked.frame_ready, timeout=20_000):
        blocked.start()
        blocked.show(STATE)
    blocked.stop()  # its picture was never taken
    assert not drawing_threads()


def test_a_renderer_never_started_can_be_stopped(renderer):
    renderer.stop()
    assert not renderer.is_running
