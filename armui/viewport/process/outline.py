"""What the window is told of a robot: joints, and the outermost points of each link. No VTK."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.viewport.robot_shape import IDENTITY, JointShape, RobotShape

if TYPE_CHECKING:
    from armui.viewport.camera import Vector
    from armui.viewport.process.robot import Joint, Matrix, Robot

_WAYS: Final = np.array(
    [way for way in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(way)], dtype=np.float64
)
"""The 26 directions in which the outermost point of a link is looked for."""


def shape_of(robot: Robot) -> RobotShape:
    """The robot without its surfaces."""
    names = [robot.root, *(joint.child for joint in robot.joints)]
    places = {name: place for place, name in enumerate(names)}
    by_name = {joint.name: place for place, joint in enumerate(robot.joints)}
    joints = tuple(_joint(robot, joint, places, by_name) for joint in robot.joints)
    return RobotShape(joints, tuple(_outermost(robot, name) for name in names))


def _joint(
    robot: Robot, joint: Joint, places: dict[str, int], by_name: dict[str, int]
) -> JointShape:
    mimic = joint.mimic
    arm = joint.name in robot.arm_joints
    slides = joint.kind == "prismatic"
    moves = slides or arm or (mimic is not None and joint.kind in {"revolute", "continuous"})
    return JointShape(
        places[joint.parent],
        places[joint.child],
        _rows(joint.origin),
        (float(joint.axis[0]), float(joint.axis[1]), float(joint.axis[2])) if moves else None,
        robot.arm_joints.index(joint.name) + 1 if arm else 0,
        joint.opened(_WIDE_M) if slides else 0.0,
        None
        if mimic is None or mimic.leader not in by_name
        else (by_name[mimic.leader], mimic.multiplier, mimic.offset),
    )


_WIDE_M: Final = 1.0
"""No gripper opens so far: a finger stands at its end."""


def _rows(matrix: Matrix) -> tuple[float, ...]:
    if matrix.shape != (4, 4):
        return IDENTITY
    rows: list[float] = matrix[:3].ravel().tolist()
    return tuple(rows)


def _outermost(robot: Robot, link: str) -> tuple[Vector, ...]:
    """Of all shapes of a link, the points that reach furthest; some 20 tell how large it looks."""
    clouds = [part.surface.vertices for part in robot.parts if part.link == link]
    if not clouds:
        return ()
    points = np.concatenate(clouds)
    chosen = np.unique((points @ _WAYS.T).argmax(axis=0))
    return tuple((x, y, z) for x, y, z in points[chosen].tolist())
