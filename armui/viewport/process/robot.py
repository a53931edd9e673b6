"""A six-joint arm described by a URDF file, and the poses of its links.

Pure data and numpy: nothing is drawn here, and nothing is imported that would slow the program's
start. Lengths are metres and angles radians as in URDF; the joint angles given are the arm's own,
in degrees, and the gripper opening in millimetres.

The poses are computed here, although yourdfpy can do it, too: it takes 0.60 ms for the arm's twelve
links, this takes 0.05 ms, and the arm is posed for every picture while Python's lock keeps the bus
thread waiting. A test compares the two.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from armui.viewport.robot_shape import IDENTITY, JointShape, RobotShape

if TYPE_CHECKING:
    from armui.viewport.vectors import Vector


Matrix = NDArray[np.float64]
Rgb = tuple[float, float, float]

ARM_JOINT_COUNT = 6
HINGES = frozenset({"revolute", "continuous"})
_WAYS: Final = np.array(
    [way for way in itertools.product((-1.0, 0.0, 1.0), repeat=3) if any(way)], dtype=np.float64
)
"""The 26 directions in each of which the outermost point of a link is found."""
_WIDE: Final = 10.0
"""More than any gripper joint travels, in m or rad: limited to its range, it gives its end."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles as arrays, independent of the library that read them, whose import takes a second.

    Attributes:
        vertices: (n, 3) metres.
        faces: (m, 3) rows of the vertices.
    """

    vertices: NDArray[np.float64]
    faces: NDArray[np.int_]

    @property
    def triangles(self) -> NDArray[np.float64]:
        """(m, 3, 3) corners of each triangle."""
        corners: NDArray[np.float64] = self.vertices[self.faces]
        return corners

    @property
    def bounds(self) -> NDArray[np.float64]:
        """(2, 3) low and high corner of the box around it."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])

    @property
    def extents(self) -> NDArray[np.float64]:
        """Length, width and height of the box around it."""
        lengths: NDArray[np.float64] = np.ptp(self.vertices, axis=0)
        return lengths


@dataclass(frozen=True)
class RobotPart:
    """One shape of a link.

    Attributes:
        link: name of the link.
        surface: triangles in the frame of the link, metres.
        color: red, green, blue in 0–1, or None when the file names none.
    """

    link: str
    surface: Surface
    color: Rgb | None


@dataclass(frozen=True)
class Mimic:
    """A joint that follows another one: value = multiplier · leader + offset."""

    leader: str
    multiplier: float
    offset: float


@dataclass(frozen=True)
class Joint:
    """One joint; `lower` and `upper` are rad (hinges) or m (sliders), `axis` is a unit vector."""

    name: str
    kind: str
    parent: str
    child: str
    origin: Matrix
    axis: NDArray[np.float64]
    lower: float
    upper: float
    mimic: Mimic | None

    def pose(self, value: float) -> Matrix:
        """Return the 4×4 pose of the child in the parent's frame at a joint value (rad or m)."""
        if self.kind in HINGES:
            return self.origin @ rotation_about(self.axis, value)
        if self.kind == "prismatic":
            shift = np.eye(4)
            shift[:3, 3] = self.axis * value
            return self.origin @ shift
        return self.origin

    def opened(self, travel: float) -> float:
        """Return the value of a joint this far from its closed end (zero), within its limit."""
        if abs(self.lower) > abs(self.upper):
            return -min(travel, -self.lower)
        return min(travel, self.upper)


@dataclass(frozen=True)
class Robot:
    """Links and joints of one arm.

    Attributes:
        root: name of the base link.
        joints: every joint, parents before children.
        arm_joints: names of the six hinges of the arm, base first.
        parts: the shapes of all links.
    """

    root: str
    joints: tuple[Joint, ...]
    arm_joints: tuple[str, ...]
    parts: tuple[RobotPart, ...]

    @cached_property
    def travels(self) -> dict[str, float]:
        """For each joint that opens the gripper its travel for each metre of opening, in m or rad.

        A finger travels half of it. A joint that only leads fingers, as in the maker's newer
        descriptions, travels so far that both fingers together travel all of it.
        """
        drawn = {part.link for part in self.parts}
        led: dict[str, list[float]] = {}
        for joint in self.joints:
            if joint.mimic is not None and joint.kind == "prismatic":
                led.setdefault(joint.mimic.leader, []).append(abs(joint.mimic.multiplier))
        found: dict[str, float] = {}
        for joint in self.joints:
            fingers, slides = led.get(joint.name, []), joint.kind == "prismatic"
            only_leads = len(fingers) > 1 and sum(fingers) > 0.0
            if joint.mimic is not None or joint.name in self.arm_joints:
                continue
            if only_leads and not (slides and joint.child in drawn):
                found[joint.name] = 1.0 / sum(fingers)
            elif slides:
                found[joint.name] = 0.5
        return found

    def link_poses(self, angles_deg: Sequence[float], opening_mm: float) -> dict[str, Matrix]:
        """Return the poses of all links in the root's frame.

        Args:
            angles_deg: six joint angles as on the bus, joint 1 first.
            opening_mm: distance between the fingers.

        Returns:
            4×4 matrices in metres, by link name.
        """
        values = {
            joint.name: joint.opened(opening_mm / 1000.0 * self.travels[joint.name])
            for joint in self.joints
            if joint.name in self.travels
        }
        for name, angle_deg in zip(self.arm_joints, angles_deg, strict=True):
            values[name] = math.radians(angle_deg)
        poses = {self.root: np.eye(4)}
        for joint in self.joints:
            if joint.mimic is None:
                value = values.get(joint.name, 0.0)
            else:
                leader = values.get(joint.mimic.leader, 0.0)
                value = joint.mimic.multiplier * leader + joint.mimic.offset
            poses[joint.child] = poses[joint.parent] @ joint.pose(value)
        return poses

    def joint_numbers(self) -> dict[str, int]:
        """Return by link name the number (1–6) of the last arm joint that moves it.

        The links before joint 1 are not included.
        """
        numbers: dict[str, int] = {}
        for joint in self.joints:
            if joint.name in self.arm_joints:
                numbers[joint.child] = self.arm_joints.index(joint.name) + 1
            elif joint.parent in numbers:
                numbers[joint.child] = numbers[joint.parent]
        return numbers


def rotation_about(axis: NDArray[np.float64], angle_rad: float) -> Matrix:
    """Return the 4×4 rotation about a unit axis (Rodrigues)."""
    x, y, z = axis
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    t = 1.0 - c
    return np.array(
        [
            [t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0.0],
            [t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0.0],
            [t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )


def shape_of(robot: Robot) -> RobotShape:
    """Return the shape of a robot, without its surfaces."""
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
    slides, travel = joint.kind == "prismatic", robot.travels.get(joint.name, 0.0)
    moves = slides or arm or (joint.kind in HINGES and bool(mimic or travel))
    return JointShape(
        places[joint.parent],
        places[joint.child],
        _rows(joint.origin),
        (float(joint.axis[0]), float(joint.axis[1]), float(joint.axis[2])) if moves else None,
        robot.arm_joints.index(joint.name) + 1 if arm else 0,
        joint.opened(_WIDE) if travel else 0.0,
        None
        if mimic is None or mimic.leader not in by_name
        else (by_name[mimic.leader], mimic.multiplier, mimic.offset),
        travel,
        slides,
    )


def _rows(matrix: Matrix) -> tuple[float, ...]:
    if matrix.shape != (4, 4):
        return IDENTITY
    rows: list[float] = matrix[:3].ravel().tolist()
    return tuple(rows)


def _outermost(robot: Robot, link: str) -> tuple[Vector, ...]:
    """Return the outermost points of a link: some 20 are enough to tell how large it looks."""
    clouds = [part.surface.vertices for part in robot.parts if part.link == link]
    if not clouds:
        return ()
    points = np.concatenate(clouds)
    chosen = np.unique((points @ _WAYS.T).argmax(axis=0))
    return tuple((x, y, z) for x, y, z in points[chosen].tolist())
