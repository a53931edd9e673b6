"""S24: what becomes of the picture's process changes nothing for window, bus and stop."""

import os
import signal
import sys

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton

from armui.protocol.generation import Generation
from tests.desk import Desk
from tests.waiting import wait_until

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals")

TARGET_DEG = (60.0, 90.0, -60.0, 40.0, 30.0, 60.0)
STOP = [(0x150, "0100000000000000")]


@pytest.fixture
def drawing(qapp, request, tmp_path):
    """The whole window before an enabled arm, with the picture on the screen."""
    settings = tmp_path / "settings.json"
    desk = Desk(qapp, request.node.nodeid, settings, Generation.TWO, draws=True)
    desk.ready()
    wait_until(lambda: desk.program.view.is_settled)
    yield desk
    desk.close()


def kill(client):
    os.kill(client.pid, signal.SIGKILL)


def freeze(client):
    os.kill(client.pid, signal.SIGSTOP)


@pytest.mark.parametrize("harm", [kill, freeze])
def test_the_arm_is_driven_and_stopped_as_ever_and_the_picture_comes_back(drawing, harm):
    view, controller = drawing.program.view, drawing.controller
    pid = view._client.pid
    lost = []
    view._client.lost.connect(lost.append)

    # it moves
    assert controller.motion.move_joints(TARGET_DEG) is None
    drawing.run(0.2)
    harm(view._client)
    before = drawing.controller.state.angles_deg()
    drawing.run(0.2)
    assert drawing.controller.state.angles_deg()[0] > before[0] + 1.0
    # and is stopped: the frame is on the bus when the press returns
    drawing.heard()
    stop = drawing.window.findChild(QPushButton, "stop_button")
    QTest.mousePress(stop, Qt.MouseButton.LeftButton)
    first = drawing.heard()[:1]
    assert [(frame.arbitration_id, frame.data.hex()) for frame in first] == STOP
    QTest.mouseRelease(stop, Qt.MouseButton.LeftButton)
    drawing.run_until(lambda: "stop_confirmed" in drawing.codes())

    wait_until(lambda: lost)
    assert lost[0].comes_back
    wait_until(lambda: view.is_settled)
    assert view._client.pid != pid
    assert view._notice() == ""
    shown = view._state.angles_deg
    assert shown == pytest.approx(controller.state.angles_deg(), abs=0.01)


def test_nothing_waits_for_a_picture_that_does_not_come(drawing):
    """Jogs, a run, the camera, the size and the preview go on with a process that stands still."""
    view, controller = drawing.program.view, drawing.controller
    freeze(view._client)
    assert controller.jogging.start_joint(1, 1) is None
    drawing.run(0.3)
    assert controller.jogging.active
    controller.jogging.stop()
    drawing.run_until(lambda: not controller.situation.moving)
    view.reset_view()
    drawing.window.resize(1100, 760)
    drawing.run(0.1)
    assert controller.state.angles_deg()[0] > 1.0
    drawing.emergency = drawing.heard()
    controller.emergency_stop()
    assert STOP[0][0] in {frame.arbitration_id for frame in drawing.heard()}
    drawing.program.shutdown()
    assert view._client.pid is None
