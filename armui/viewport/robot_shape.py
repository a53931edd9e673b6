"""The robot's shape for the window: its joints and the outermost points of its links. Pure.

The picture's process reads the file and its meshes and sends this shape. It is plain data and
arithmetic: the window computes with it before numpy is loaded.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.viewport.vectors import Vector, unit, without_part_along

Rows = tuple[float, ...]
"""The upper three rows of a 4×4 transform, twelve figures; lengths in metres."""

IDENTITY: Final[Rows] = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)
_SHORT_M: Final = 0.02
_SQUARE: Final = 0.5


@dataclass(frozen=True, slots=True)
class JointShape:
    """One joint of a robot.

    Attributes:
        parent, child: The links it connects, as indices in `RobotShape.points`.
        origin: The joint's transform in its parent.
        axis: The axis of a moving joint, a unit vector in the joint's frame; ``None`` if it is
            fixed.
        number: 1–6 for a joint of the arm, 0 for any other.
        furthest: The value of a joint that opens the gripper at its end, m or rad; 0 for others.
        leader: The joint it follows, as an index in `RobotShape.joints`, with a factor and an
            offset.
        travel: The travel of a joint that opens the gripper for each metre of opening.
        slides: True if it moves along its axis, false if it turns about it.
    """

    parent: int
    child: int
    origin: Rows
    axis: Vector | None = None
    number: int = 0
    furthest: float = 0.0
    leader: tuple[int, float, float] | None = None
    travel: float = 0.0
    slides: bool = False


@dataclass(frozen=True, slots=True)
class RobotShape:
    """A robot without its surfaces.

    Attributes:
        joints: Parents before children.
        points: For each link, the root first, its outermost points in its own frame, metres.
    """

    joints: tuple[JointShape, ...]
    points: tuple[tuple[Vector, ...], ...]

    def links(self, angles_deg: Sequence[float], opening_mm: float = 0.0) -> list[Rows]:
        """Return the transforms of all links in the base frame.

        Args:
            angles_deg: Six joint angles as on the bus.
            opening_mm: Distance between the fingers.
        """
        poses: list[Rows] = [IDENTITY] * len(self.points)
        values: list[float] = []
        for joint in self.joints:
            value = _value(joint, values, angles_deg, opening_mm)
            values.append(value)
            pose = composed(poses[joint.parent], joint.origin)
            if joint.axis is not None and value != 0.0:
                pose = composed(pose, _motion(joint, value))
            poses[joint.child] = pose
        return poses

    def outline(self, links: Sequence[Rows]) -> list[list[Vector]]:
        """Return the outermost points of each link that has any, in the base frame."""
        return [
            [moved(rows, point) for point in points]
            for rows, points in zip(links, self.points, strict=True)
            if points
        ]

    def flange(self, links: Sequence[Rows]) -> Rows:
        """Return the transform of the link that joint 6 moves."""
        return links[next(joint.child for joint in self.joints if joint.number == 6)]

    def joint_frame(self, number: int, links: Sequence[Rows]) -> tuple[Vector, Vector]:
        """Return the place of a joint in the base frame, and its axis, a unit vector."""
        joint = next(joint for joint in self.joints if joint.number == number)
        rows = composed(links[joint.parent], joint.origin)
        axis = joint.axis or (0.0, 0.0, 1.0)
        return (rows[3], rows[7], rows[11]), turned(rows, axis)

    def joint_pointer(self, number: int, links: Sequence[Rows]) -> Vector:
        """Return a unit vector square to a joint's axis, along the links that the joint moves."""
        place, axis = self.joint_frame(number, links)
        following = next((each for each in self.joints if each.number == number + 1), None)
        if following is not None:
            rows = composed(links[following.parent], following.origin)
            ahead = (rows[3] - place[0], rows[7] - place[1], rows[11] - place[2])
            square = without_part_along(ahead, axis)
            if math.dist(square, (0.0, 0.0, 0.0)) > _SHORT_M:
                return unit(square)
        joint = next(joint for joint in self.joints if joint.number == number)
        rows = links[joint.child]
        for candidate in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)):
            square = without_part_along(turned(rows, candidate), axis)
            if math.dist(square, (0.0, 0.0, 0.0)) > _SQUARE:
                return unit(square)
        return unit(without_part_along(turned(rows, (0.0, 0.0, 1.0)), axis))


def _value(
    joint: JointShape, before: Sequence[float], angles_deg: Sequence[float], opening_mm: float
) -> float:
    if joint.leader is not None:
        place, factor, offset = joint.leader
        leader = before[place] if place < len(before) else 0.0
        return factor * leader + offset
    if joint.number:
        return math.radians(angles_deg[joint.number - 1])
    travel = min(opening_mm / 1000.0 * joint.travel, abs(joint.furthest))
    return math.copysign(travel, joint.furthest)


def _motion(joint: JointShape, value: float) -> Rows:
    x, y, z = joint.axis or (0.0, 0.0, 1.0)
    if joint.slides:
        return (1.0, 0.0, 0.0, x * value, 0.0, 1.0, 0.0, y * value, 0.0, 0.0, 1.0, z * value)
    return rotation((x, y, z), value)


def rotation(axis: Vector, angle_rad: float) -> Rows:
    """Return the rotation about a unit axis through the origin."""
    x, y, z = axis
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    t = 1.0 - c
    return (
        *(t * x * x + c, t * x * y - s * z, t * x * z + s * y, 0.0),
        *(t * x * y + s * z, t * y * y + c, t * y * z - s * x, 0.0),
        *(t * x * z - s * y, t * y * z + s * x, t * z * z + c, 0.0),
    )


def composed(one: Rows, other: Rows) -> Rows:
    """Return the product of two transforms: the other first, then the one."""
    a, b, c, x, d, e, f, y, g, h, i, z = one
    A, B, C, X, D, E, F, Y, G, H, I, Z = other  # noqa: N806, E741 - the same places
    return (
        *(a * A + b * D + c * G, a * B + b * E + c * H, a * C + b * F + c * I),
        a * X + b * Y + c * Z + x,
        *(d * A + e * D + f * G, d * B + e * E + f * H, d * C + e * F + f * I),
        d * X + e * Y + f * Z + y,
        *(g * A + h * D + i * G, g * B + h * E + i * H, g * C + h * F + i * I),
        g * X + h * Y + i * Z + z,
    )


def moved(rows: Rows, point: Vector) -> Vector:
    """Return a point of a frame in the parent frame."""
    x, y, z = point
    return (
        rows[0] * x + rows[1] * y + rows[2] * z + rows[3],
        rows[4] * x + rows[5] * y + rows[6] * z + rows[7],
        rows[8] * x + rows[9] * y + rows[10] * z + rows[11],
    )


def turned(rows: Rows, vector: Vector) -> Vector:
    """Return a direction of a frame in the parent frame."""
    x, y, z = vector
    return (
        rows[0] * x + rows[1] * y + rows[2] * z,
        rows[4] * x + rows[5] * y + rows[6] * z,
        rows[8] * x + rows[9] * y + rows[10] * z,
    )


def pose_rows(pose: Sequence[float]) -> Rows:
    """Return the transform of a pose: X, Y, Z in mm, RX, RY, RZ in degrees, R = Rz·Ry·Rx."""
    cx, cy, cz = (math.cos(math.radians(angle)) for angle in pose[3:])
    sx, sy, sz = (math.sin(math.radians(angle)) for angle in pose[3:])
    x, y, z = (length / 1000.0 for length in pose[:3])
    return (
        *(cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx, x),
        *(sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx, y),
        *(-sy, cy * sx, cy * cx, z),
    )
