"""Handles in the picture: three axes and three rings at the tool, an arc at each joint. Pure.

A drag is computed from the camera alone, without the picture or another process.
"""

from __future__ import annotations

import enum
import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

from armui.viewport.palette import ScenePalette
from armui.viewport.projection import Projection, Ray
from armui.viewport.robot_shape import RobotShape, Rows, rotation, turned
from armui.viewport.vectors import (
    Vector,
    cross,
    dot,
    minus,
    plus,
    square_to,
    unit,
    without_part_along,
)

_LENGTH_PX: Final = 92.0
_GAP_SHARE: Final = 0.22
"""The axes begin at a distance from the tool, so that all three can be grabbed."""
_RING_SHARE: Final = 0.72
_JOINT_PX: Final = 58.0
_JOINT_HALF_DEG: Final = 70.0
_ARC_STEP_DEG: Final = 6.0
_NEAR_PX: Final = 8.0
_ALONG_SIGHT: Final = 0.97
"""An axis can't be dragged if its cosine with the sight is above this: a pixel would be a metre."""
EDGE_ON: Final = 0.13
"""The cosine between sight and axis below which a ring is seen from its edge: it can't be turned
then, for the same reason. A joint's arc can, see :class:`GripDrag`."""
_ARROW_SHARE: Final = 0.09
_SAME_PX: Final = 3.0
"""The distance at which the near and the far side of an arc, seen from its edge, coincide."""
_ROUND_DEG: Final = 60.0
"""Up to this angle from the side that faces the eye the pointer stays on the grabbed point; beyond,
a pixel would mean more and more degrees, so the rest of a turn keeps the ratio of that place.
"""
_ROUND: Final = math.sin(math.radians(_ROUND_DEG))
_BEYOND: Final = 1.0 / math.cos(math.radians(_ROUND_DEG))


class GripKind(enum.Enum):
    """The kind of motion by a handle."""

    AXIS = enum.auto()
    """Moves the tool along an axis."""
    RING = enum.auto()
    """Turns the tool about an axis."""
    JOINT = enum.auto()
    """Turns a joint."""


@dataclass(frozen=True, slots=True)
class Grip:
    """One handle.

    Attributes:
        kind: The kind of motion.
        number: 0–2 for X, Y, Z; 1–6 for a joint.
        origin: Its place in the base frame, metres.
        axis: The unit vector along or about which it moves.
        places: The points of the line that is drawn and grabbed.
        color: "#rrggbb".
    """

    kind: GripKind
    number: int
    origin: Vector
    axis: Vector
    places: tuple[Vector, ...]
    color: str


def tool_grips(
    tool: Rows, frame: Rows | None, projection: Projection, palette: ScenePalette
) -> list[Grip]:
    """Return the handles at a tool, of constant size on the screen.

    Args:
        tool: The tool centre point in the base frame.
        frame: The frame whose axes they have; None for the base's.
        projection: The projection of the picture.
        palette: The theme's colours.
    """
    origin = (tool[3], tool[7], tool[11])
    scale = projection.pixels_a_metre(origin)
    if scale <= 0.0:
        return []
    length = _LENGTH_PX / scale
    ahead = sight(projection, origin)
    grips = []
    for number, plain in enumerate(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))):
        axis = plain if frame is None else turned(frame, plain)
        color = palette.axes[number]
        slope = abs(dot(axis, ahead))
        if slope < _ALONG_SIGHT:
            places = _arrow(origin, axis, ahead, length)
            grips.append(Grip(GripKind.AXIS, number, origin, axis, places, color))
        if slope > EDGE_ON:
            places = _circle(origin, axis, length * _RING_SHARE)
            grips.append(Grip(GripKind.RING, number, origin, axis, places, color))
    return grips


def joint_grips(
    shape: RobotShape, angles_deg: Sequence[float], projection: Projection, palette: ScenePalette
) -> list[Grip]:
    """Return an arc at each joint, about its axis, beside the links it moves."""
    links = shape.links(angles_deg)
    grips = []
    for number in range(1, len(angles_deg) + 1):
        origin, axis = shape.joint_frame(number, links)
        scale = projection.pixels_a_metre(origin)
        if scale <= 0.0:
            continue
        pointer = shape.joint_pointer(number, links)
        radius = _JOINT_PX / scale
        places = _arc(origin, axis, pointer, radius, (-_JOINT_HALF_DEG, _JOINT_HALF_DEG))
        grips.append(Grip(GripKind.JOINT, number, origin, axis, places, palette.speeds[1]))
    return grips


def grip_at(grips: Iterable[Grip], projection: Projection, x_px: float, y_px: float) -> Grip | None:
    """Return the handle under the pointer, the nearest if there are several."""
    nearest: tuple[float, Grip] | None = None
    for grip in grips:
        away_px = _away_px(grip, projection, x_px, y_px)
        if away_px <= _NEAR_PX and (nearest is None or away_px < nearest[0]):
            nearest = (away_px, grip)
    return None if nearest is None else nearest[1]


def snapped(value: float, step: float) -> float:
    """Return the nearest multiple of a step."""
    return round(value / step) * step


def _away_px(grip: Grip, projection: Projection, x_px: float, y_px: float) -> float:
    """Return how far the pointer is from a handle's line."""
    pixels = [projection.pixel(place) for place in grip.places]
    nearest = math.inf
    for one, other in itertools.pairwise(pixels):
        if one is not None and other is not None:
            nearest = min(nearest, from_segment_px((x_px, y_px), one, other))
    return nearest


def from_segment_px(
    at: tuple[float, float], one: tuple[float, float], other: tuple[float, float]
) -> float:
    """Return the distance of a pixel from the segment between two others."""
    across, down = other[0] - one[0], other[1] - one[1]
    length_2 = across * across + down * down
    share = 0.0
    if length_2 > 0.0:
        share = ((at[0] - one[0]) * across + (at[1] - one[1]) * down) / length_2
        share = min(1.0, max(0.0, share))
    return math.hypot(at[0] - one[0] - share * across, at[1] - one[1] - share * down)


def sight(projection: Projection, place: Vector) -> Vector:
    """Return a unit vector from the eye to a place."""
    outward, _, _ = projection.camera.axes()
    if projection.camera.orthographic:
        return (-outward[0], -outward[1], -outward[2])
    return unit(minus(place, projection.camera.eye_m))


def _arrow(origin: Vector, axis: Vector, sight: Vector, length: float) -> tuple[Vector, ...]:
    """Return a line with a head, seen from its side."""
    aside = unit(cross(axis, sight))
    tip = plus(origin, axis, length)
    neck = plus(origin, axis, length * (1.0 - 1.6 * _ARROW_SHARE))
    left = plus(neck, aside, length * _ARROW_SHARE)
    right = plus(neck, aside, -length * _ARROW_SHARE)
    return (plus(origin, axis, length * _GAP_SHARE), tip, left, tip, right)


def _circle(origin: Vector, axis: Vector, radius: float) -> tuple[Vector, ...]:
    return _arc(origin, axis, square_to(axis), radius, (0.0, 360.0))


def _arc(
    origin: Vector, axis: Vector, pointer: Vector, radius: float, ends_deg: tuple[float, float]
) -> tuple[Vector, ...]:
    first, last = ends_deg
    steps = max(2, math.ceil((last - first) / _ARC_STEP_DEG))
    angles = (first + (last - first) * step / steps for step in range(steps + 1))
    return tuple(
        plus(origin, turned(rotation(axis, math.radians(angle)), pointer), radius)
        for angle in angles
    )


class GripDrag:
    """The drag of a handle, from the press on.

    A turn is computed in its plane. For a joint's arc seen from its edge the cylinder about the
    joint's axis is used instead, on the grabbed side: the pointer moves along the visible line, and
    turns the joint like a wheel.

    Args:
        grip: The handle.
        projection: The projection at the press; the camera does not move while a handle is held.
        x_px: The place of the press.
        y_px: Likewise.
    """

    def __init__(self, grip: Grip, projection: Projection, x_px: float, y_px: float) -> None:
        self.grip = grip
        self._projection = projection
        self._radius_m = 0.0  # the cylinder's; 0 while the pointer is followed in the turn's plane
        self._first = square_to(grip.axis)  # the direction of angle 0
        self._is_near = True
        ahead = sight(projection, grip.origin)
        if grip.kind is GripKind.JOINT and abs(dot(grip.axis, ahead)) <= EDGE_ON:
            self._radius_m = math.dist(grip.places[0], grip.origin)
            self._first = unit(minus((0.0, 0.0, 0.0), without_part_along(ahead, grip.axis)))
            self._is_near = _is_near(grip, projection, ahead, (x_px, y_px))
        self._start = self._at(projection.ray(x_px, y_px)) or 0.0
        self._last = self._start
        self._turns = 0.0

    def amount(self, x_px: float, y_px: float) -> float | None:
        """Return the distance or angle of the drag so far: mm along an axis, degrees about one.

        Returns:
            The amount, or None if the pointer is beyond the horizon of the turn's plane.
        """
        now = self._at(self._projection.ray(x_px, y_px))
        if now is None:
            return None
        if self.grip.kind is GripKind.AXIS:
            return (now - self._start) * 1000.0
        if self._radius_m > 0.0:
            return now - self._start  # the angle of a wheel may exceed a whole turn
        # on the shorter way round from the last place: a ring can be turned more than once
        self._turns += (now - self._last + 180.0) % 360.0 - 180.0
        self._last = now
        return self._turns

    def _at(self, ray: Ray) -> float | None:
        """Return where a ray points: metres along the axis, or degrees about it; or None."""
        grip = self.grip
        if grip.kind is GripKind.AXIS:
            return _along(ray, grip.origin, grip.axis)
        if self._radius_m > 0.0:
            return self._on_cylinder(ray)
        slope = dot(ray.direction, grip.axis)
        if abs(slope) < 1e-6:
            return None
        away = minus(grip.origin, ray.start_m)
        distance = dot(away, grip.axis) / slope
        if distance <= 0.0:
            return None
        arm = minus(ray.at(distance), grip.origin)
        first, second = self._first, cross(grip.axis, self._first)
        return math.degrees(math.atan2(dot(arm, second), dot(arm, first)))

    def _on_cylinder(self, ray: Ray) -> float | None:
        """Return the angle about the axis, degrees, at which a ray meets the cylinder."""
        first, second = self._first, cross(self.grip.axis, self._first)
        to_eye = (-dot(ray.direction, first), -dot(ray.direction, second))
        length = math.hypot(*to_eye)
        if length < 1e-6:
            return None
        start = minus(ray.start_m, self.grip.origin)
        # the distance of the ray from the axis in radii, with the sign of the angles
        passed_m = to_eye[0] * dot(start, second) - to_eye[1] * dot(start, first)
        aside = passed_m / (length * self._radius_m)
        turned_deg = _wheel_deg(aside)
        facing_deg = math.degrees(math.atan2(to_eye[1], to_eye[0]))
        return facing_deg + (turned_deg if self._is_near else 180.0 - turned_deg)


def _wheel_deg(aside: float) -> float:
    """Return the angle from the side facing the eye for a distance from the axis, in radii."""
    if abs(aside) <= _ROUND:
        return math.degrees(math.asin(aside))
    beyond = math.degrees((abs(aside) - _ROUND) * _BEYOND)
    return math.copysign(_ROUND_DEG + beyond, aside)


def _is_near(grip: Grip, projection: Projection, ahead: Vector, at_px: tuple[float, float]) -> bool:
    """Return whether the arc was grabbed on the side facing the eye, or on both at once."""
    pixels = [projection.pixel(place) for place in grip.places]
    away: list[tuple[float, float]] = []
    for place, (one, other) in zip(grip.places, itertools.pairwise(pixels), strict=False):
        if one is not None and other is not None:
            behind = dot(minus(place, grip.origin), ahead)
            away.append((from_segment_px(at_px, one, other), behind))
    if not away:
        return True
    nearest_px = min(away)[0]
    return min(behind for px, behind in away if px <= nearest_px + _SAME_PX) <= 0.0


def _along(ray: Ray, origin: Vector, axis: Vector) -> float | None:
    """Return how far along a line the place is that a ray passes nearest to."""
    away = minus(ray.start_m, origin)
    slope = dot(ray.direction, axis)
    square = 1.0 - slope * slope
    if square < 1e-6:
        return None
    return (dot(away, axis) - slope * dot(away, ray.direction)) / square
