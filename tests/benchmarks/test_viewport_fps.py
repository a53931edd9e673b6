"""Frames per second of the 3D picture at 900×700 while every joint moves in each frame.

Compared in the same run: the arm as the program draws it, with the eightfold multisampling that
pyvista would use by itself, and with the meshes' points moved instead of the actors' matrices. And
the whole way to the screen: drawn in the picture's process, handed over, painted by the widget.
A benchmark states; it fails only where no picture comes at all.
"""

import statistics
import time
from typing import Any

import pytest
import pyvista as pv

from armui.system.paths import URDF
from armui.viewport.process.scene import Scene
from armui.viewport.process.urdf_file import load_robot
from armui.viewport.view import ArmView
from tests.waiting import wait_until

WIDTH, HEIGHT = 900, 700
ROUNDS, FRAMES_A_ROUND, SHOWN_FRAMES = 5, 12, 60


def moving(frame):
    """Joint angles of a frame: nothing stands still."""
    swing = frame % 40 - 20
    return (2.0 * swing, 80.0 + swing, -80.0 + swing, swing, 40.0 + swing, 3.0 * swing)


class Ours:
    """As the program draws while the arm moves."""

    def __init__(self):
        self.scene = Scene(WIDTH, HEIGHT)
        self.scene.load(URDF / "piper" / "piper.urdf")

    def draw(self, frame):
        self.scene.set_joints(moving(frame), 30.0)
        self.scene.render(smooth=False)


class Smooth(Ours):
    """As it draws at rest."""

    def draw(self, frame):
        self.scene.set_joints(moving(frame), 30.0)
        self.scene.render(smooth=True)


class Multisampled(Ours):
    """With pyvista's own setting."""

    def __init__(self):
        super().__init__()
        self.scene._canvas._window.SetMultiSamples(8)


class MovedMeshes(Ours):
    """With the points of the meshes moved instead of the actors."""

    def __init__(self):
        super().__init__()
        self.robot = load_robot(URDF / "piper" / "piper.urdf")
        self.scene.set_joints((0.0,) * 6, 0.0)
        self.parts = []
        for part, actor in zip(self.robot.parts, self.scene._robot.actors, strict=True):
            actor.SetUserMatrix(None)
            mapper = actor.GetMapper()
            self.parts.append((part.link, mapper, pv.PolyData(mapper.GetInput())))

    def draw(self, frame):
        poses = self.robot.link_poses(moving(frame), 30.0)
        for link, mapper, mesh in self.parts:
            mapper.SetInputData(mesh.transform(poses[link], inplace=False))
        self.scene.render(smooth=False)


def milliseconds_a_frame(ways):
    """Median time of a frame of each way; rounds take turns, so a busy moment hits them all."""
    times: dict[Any, Any] = {name: [] for name in ways}
    for round_number in range(ROUNDS + 1):
        for name, way in ways.items():
            for frame in range(FRAMES_A_ROUND):
                began = time.perf_counter()
                way.draw(frame)
                if round_number > 0:  # the first round warms up
                    times[name].append(time.perf_counter() - began)
    return {name: statistics.median(measured) * 1000.0 for name, measured in times.items()}


def test_drawing(capsys):
    ways = {
        "actor matrices, no multisampling (ours, moving)": Ours(),
        "the same with smooth edges (ours, at rest)": Smooth(),
        "the same with 8 samples (pyvista's default)": Multisampled(),
        "meshes moved instead of matrices": MovedMeshes(),
    }
    try:
        result = milliseconds_a_frame(ways)
    finally:
        for way in ways.values():
            way.scene.close()
    with capsys.disabled():
        print(f"\n3D picture at {WIDTH}×{HEIGHT}, all joints moving:")
        for name, milliseconds in result.items():
            print(f"  {name:50} {milliseconds:6.1f} ms  {1000.0 / milliseconds:6.1f} frames/s")
    assert min(result.values()) > 0.0


@pytest.mark.usefixtures("qapp")
@pytest.mark.timeout(600)
def test_on_the_screen(qtbot, capsys):
    view = ArmView()
    qtbot.addWidget(view)
    view.resize(WIDTH, HEIGHT)
    view.set_joints(moving(0), 30.0)
    view.show()
    wait_until(lambda: view.is_settled)
    shown = []

    def on_frame(_picture):
        shown.append(time.perf_counter())
        view.set_joints(moving(len(shown)), 30.0)

    view._client.frame_ready.connect(on_frame)
    view.set_joints(moving(1), 30.0)
    wait_until(lambda: len(shown) > SHOWN_FRAMES)
    view.shutdown()
    fps = SHOWN_FRAMES / (shown[-1] - shown[-1 - SHOWN_FRAMES])
    with capsys.disabled():
        print(f"\n3D view, drawn, handed over and painted at {WIDTH}×{HEIGHT}: {fps:.1f} frames/s")
    assert fps > 0.0
