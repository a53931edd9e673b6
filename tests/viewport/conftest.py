"""One view and its process for all tests of a module: starting a process takes a second."""

import pytest
from PySide6.QtCore import QCoreApplication, QEvent

from armui.system.paths import URDF
from armui.viewport.palette import LIGHT
from armui.viewport.path_picture import NOTHING
from armui.viewport.view import ArmView
from armui.viewport.view_state import BUILT_IN_ROBOT
from armui.viewport.viewpoint import ViewMode
from armui.viewport.watch import Restarts
from tests.viewport.pinhole import HEIGHT, WIDTH
from tests.waiting import wait_until

RAISED = (30.0, 70.0, -60.0, 20.0, 40.0, 10.0)


@pytest.fixture(scope="module")
def drawn_view(qapp):
    view = ArmView()
    view.resize(WIDTH, HEIGHT)
    view.set_joints(RAISED, 35.0)
    view.show()
    wait_until(lambda: view.is_settled)
    yield view
    view.shutdown()
    view.close()
    view.deleteLater()
    # now, and not while the view of the next module is made
    QCoreApplication.sendPostedEvents(view, QEvent.Type.DeferredDelete)


@pytest.fixture
def view(drawn_view):
    """As it is shown first: whatever is drawn later has a reason of its own."""
    drawn_view._client._link._restarts = Restarts()  # each test loses as many as it likes
    drawn_view.show()
    drawn_view.resize(WIDTH, HEIGHT)
    drawn_view.set_joints(RAISED, 35.0)
    drawn_view.set_theme(LIGHT)
    drawn_view.set_preview(NOTHING)
    drawn_view.highlight_joint(None)
    drawn_view.set_reach(None)
    drawn_view.set_trail(None)
    drawn_view.set_orthographic(wanted=False)
    drawn_view.reset_view()
    if drawn_view._state.robot.path != BUILT_IN_ROBOT.path:
        drawn_view.set_robot(None)
    wait_until(lambda: drawn_view.is_settled)
    assert drawn_view.mode is ViewMode.FIT
    return drawn_view


@pytest.fixture
def scene():
    """The picture's process without a process, with the arm at its zeros."""
    from armui.viewport.process.scene import Scene  # noqa: PLC0415 - most tests need no VTK

    scene = Scene(WIDTH, HEIGHT)
    scene.load(URDF / "piper" / "piper.urdf")
    scene.set_joints((0.0,) * 6, 0.0)
    yield scene
    scene.close()
