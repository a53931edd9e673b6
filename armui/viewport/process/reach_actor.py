"""How far the tool can reach: a shell that shines through."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Final

import numpy as np
import pyvista as pv

from armui.viewport.palette import ScenePalette, rgb
from armui.viewport.process.geometry import actor_of
from armui.viewport.process.robot import ARM_JOINT_COUNT

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

    from armui.viewport.path_picture import Reach
    from armui.viewport.process.robot import Joint, Robot

_STEPS: Final = (1, 46, 46, 1, 15, 1)
"""Angles tried of each joint: joint 1 turns the shell, 4 and 6 add nothing in its plane."""
_BINS: Final = 72
"""Directions in the arm's plane, as seen from its shoulder."""
_TURNS: Final = 48
_OPACITY: Final = 0.13
_LINE_OPACITY: Final = 0.35


class ReachActor:
    """Keeps the shell in a renderer; it is worked out when it is asked for."""

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._actors: list[vtkActor] = []
        self._shown: tuple[Reach | None, Robot, ScenePalette] | None = None

    def show(self, reach: Reach | None, robot: Robot, palette: ScenePalette) -> None:
        """Show the reach of a robot, or nothing."""
        before = self._shown
        wanted = (reach, robot, palette)
        is_same = before is not None and before[1] is robot and before[::2] == wanted[::2]
        if is_same or (reach is None and not self._actors):
            return
        self._shown = wanted
        for actor in self._actors:
            self._renderer.RemoveActor(actor)
        self._actors.clear()
        if reach is None:
            return
        profile, turns = profile_of(robot, reach), _turns(reach)
        surface = _shell(profile, turns)
        rings = surface.extract_feature_edges(
            boundary_edges=True, feature_edges=False, manifold_edges=False
        )
        for shape, opacity in ((surface, _OPACITY), (rings, _LINE_OPACITY)):
            actor = actor_of(shape)
            look = actor.GetProperty()
            look.SetColor(*rgb(palette.accent))
            look.SetOpacity(opacity)
            look.LightingOff()
            actor.PickableOff()
            self._renderer.AddActor(actor)
            self._actors.append(actor)


def profile_of(robot: Robot, reach: Reach) -> NDArray[np.float64]:
    """(n, 3) the outermost places of the tool while joint 1 stands at 0, from bottom to top, m."""
    places = tool_places(robot, reach)
    # in its plane, turned to the front: a place behind the arm is one before it at another angle
    centre = _shoulder(robot)
    out = places[:, 0] - centre[0]
    up = places[:, 2] - centre[2]
    angles = np.arctan2(up, np.maximum(out, 0.0))
    forward = out >= 0.0
    far = np.hypot(out, up)
    bins = np.clip(((angles / np.pi + 0.5) * _BINS).astype(int), 0, _BINS - 1)
    furthest: list[NDArray[np.float64]] = []
    for number in range(_BINS):
        inside = forward & (bins == number)
        if inside.any():
            places_there = places[inside]
            furthest.append(places_there[far[inside].argmax()])
    profile = np.array(furthest)
    profile[:, 1] = 0.0
    return profile


def tool_places(robot: Robot, reach: Reach) -> NDArray[np.float64]:
    """(n, 3) places of the tool over all angles that are tried, metres."""
    grids = [
        np.linspace(low, high, steps) if steps > 1 else np.array([min(max(0.0, low), high)])
        for (low, high), steps in zip(reach.limits_deg, _STEPS, strict=True)
    ]
    angles = np.array(list(itertools.product(*grids)))
    poses = np.broadcast_to(np.eye(4), (len(angles), 4, 4))
    number = 0
    for joint in _chain(robot):
        poses = poses @ joint.origin
        if joint.name in robot.arm_joints:
            poses = poses @ _rotations(joint.axis, np.radians(angles[:, number]))
            number += 1
    places: NDArray[np.float64] = poses[:, :3, :3] @ np.array(reach.tool_m) + poses[:, :3, 3]
    return places


def _chain(robot: Robot) -> list[Joint]:
    """The joints from the root to the last of the arm's."""
    by_child = {joint.child: joint for joint in robot.joints}
    last = next(joint for joint in robot.joints if joint.name == robot.arm_joints[-1])
    chain = [last]
    while chain[0].parent in by_child:
        chain.insert(0, by_child[chain[0].parent])
    return chain


def _shoulder(robot: Robot) -> NDArray[np.float64]:
    """Where joint 2 is at zero, metres."""
    poses = robot.link_poses((0.0,) * ARM_JOINT_COUNT, 0.0)
    joint = next(joint for joint in robot.joints if joint.name == robot.arm_joints[1])
    place: NDArray[np.float64] = (poses[joint.parent] @ joint.origin)[:3, 3]
    return place


def _rotations(axis: NDArray[np.float64], angles_rad: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n, 4, 4) rotations about a unit axis."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    sines, cosines = np.sin(angles_rad)[:, None, None], np.cos(angles_rad)[:, None, None]
    turned = np.zeros((len(angles_rad), 4, 4))
    turned[:, :3, :3] = np.eye(3) + sines * cross + (1.0 - cosines) * (cross @ cross)
    turned[:, 3, 3] = 1.0
    return turned


def _turns(reach: Reach) -> NDArray[np.float64]:
    low, high = reach.limits_deg[0]
    return np.radians(np.linspace(low, min(high, low + 360.0), _TURNS))


def _shell(profile: NDArray[np.float64], turns: NDArray[np.float64]) -> pv.PolyData:
    """The profile turned about the upright axis of joint 1."""
    rows, columns = len(profile), len(turns)
    points = np.empty((rows, columns, 3))
    points[..., 0] = profile[:, :1] * np.cos(turns)
    points[..., 1] = profile[:, :1] * np.sin(turns)
    points[..., 2] = profile[:, 2:]
    index = np.arange(rows * columns).reshape(rows, columns)
    corners = (index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1])
    faces = np.asarray(np.stack(corners, axis=-1).reshape(-1, 4), int)
    surface: pv.PolyData = pv.PolyData.from_regular_faces(points.reshape(-1, 3), faces)
    return surface
