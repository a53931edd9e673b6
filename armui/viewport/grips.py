"""Handles in the picture: three axes and three rings at the tool, an arc at each joint. Pure.

What is dragged is worked out from the camera alone: no picture and no other process is asked.
"""

from __future__ import annotations

import enum
import itertools
import math
from collections.abc import Iterable, Sequence
from typing import Final, NamedTuple

from armui.viewport.camera import Vector
from armui.viewport.palette import ScenePalette
from armui.viewport.projection import Projection, Ray, dot
from armui.viewport.robot_shape import RobotShape, Rows, rotation, turned, unit, without_part_along

_LENGTH_PX: Final = 92.0
_GAP_SHARE: Final = 0.22
"""The axes begin beside the tool, so that all three can be taken."""
_RING_SHARE: Final = 0.72
_JOINT_PX: Final = 58.0
_JOINT_HALF_DEG: Final = 70.0
_ARC_STEP_DEG: Final = 6.0
_NEAR_PX: Final = 8.0
_ALONG_SIGHT: Final = 0.97
"""An axis that points at the eye can't be dragged along: a pixel would be a metre."""
_EDGE_ON: Final = 0.13
"""A ring seen from its edge can't be turned, for the same reason."""
_ARROW_SHARE: Final = 0.09


class GripKind(enum.Enum):
    """What a handle does."""

    AXIS = enum.auto()
    """Moves the tool along an axis."""
    RING = enum.auto()
    """Turns the tool about an axis."""
    JOINT = enum.auto()
    """Turns a joint."""


class Grip(NamedTuple):
    """One handle.

    Attributes:
        kind: What it does.
        number: 0–2 for X, Y, Z; of a joint 1–6.
        origin: Where it stands, in the base frame, metres.
        axis: A unit vector along or about which it goes.
        places: The line that is drawn and taken hold of.
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
    """The handles at a tool, always as large on the screen.

    Args:
        tool: Of the tool centre point, in the base frame.
        frame: Whose axes they have; None: the base's.
        projection: Of the picture.
        palette: The theme's colours.
    """
    origin = (tool[3], tool[7], tool[11])
    scale = projection.pixels_a_metre(origin)
    if scale <= 0.0:
        return []
    length = _LENGTH_PX / scale
    sight = _sight(projection, origin)
    grips = []
    for number, plain in enumerate(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))):
        axis = plain if frame is None else turned(frame, plain)
        color = palette.axes[number]
        slope = abs(dot(axis, sight))
        if slope < _ALONG_SIGHT:
            places = _arrow(origin, axis, sight, length)
            grips.append(Grip(GripKind.AXIS, number, origin, axis, places, color))
        if slope > _EDGE_ON:
            places = _circle(origin, axis, length * _RING_SHARE)
            grips.append(Grip(GripKind.RING, number, origin, axis, places, color))
    return grips


def joint_grips(
    shape: RobotShape, angles_deg: Sequence[float], projection: Projection, palette: ScenePalette
) -> list[Grip]:
    """An arc at each joint, about its axis, beside what it moves."""
    links = shape.links(angles_deg)
    grips = []
    for number in range(1, len(angles_deg) + 1):
        origin, axis = shape.joint_frame(number, links)
        scale = projection.pixels_a_metre(origin)
        if scale <= 0.0 or abs(dot(axis, _sight(projection, origin))) <= _EDGE_ON:
            continue
        pointer = shape.joint_pointer(number, links)
        radius = _JOINT_PX / scale
        places = _arc(origin, axis, pointer, radius, (-_JOINT_HALF_DEG, _JOINT_HALF_DEG))
        grips.append(Grip(GripKind.JOINT, number, origin, axis, places, palette.speeds[1]))
    return grips


def grip_at(grips: Iterable[Grip], projection: Projection, x_px: float, y_px: float) -> Grip | None:
    """The handle under the pointer; of several the nearest."""
    nearest: tuple[float, Grip] | None = None
    for grip in grips:
        away_px = _away_px(grip, projection, x_px, y_px)
        if away_px <= _NEAR_PX and (nearest is None or away_px < nearest[0]):
            nearest = (away_px, grip)
    return None if nearest is None else nearest[1]


class GripDrag:
    """A handle that is held, from the press on.

    Args:
        grip: Which.
        projection: Of the picture at the press; the camera rests while a handle is held.
        x_px: Where it was taken hold of.
        y_px: Likewise.
    """

    def __init__(self, grip: Grip, projection: Projection, x_px: float, y_px: float) -> None:
        self.grip = grip
        self._projection = projection
        self._start = self._at(projection.ray(x_px, y_px)) or 0.0
        self._last = self._start
        self._turns = 0.0

    def amount(self, x_px: float, y_px: float) -> float | None:
        """How far the pointer has carried it: mm along an axis, degrees about one.

        Returns:
            None where the pointer leads nowhere, beyond the horizon of the plane it turns in.
        """
        now = self._at(self._projection.ray(x_px, y_px))
        if now is None:
            return None
        if self.grip.kind is GripKind.AXIS:
            return (now - self._start) * 1000.0
        # on the shorter way round from the last place: a ring can be turned more than once
        self._turns += (now - self._last + 180.0) % 360.0 - 180.0
        self._last = now
        return self._turns

    def _at(self, ray: Ray) -> float | None:
        """Metres along the axis, or degrees about it, of what a ray points at."""
        grip = self.grip
        if grip.kind is GripKind.AXIS:
            return _along(ray, grip.origin, grip.axis)
        slope = dot(ray.direction, grip.axis)
        if abs(slope) < 1e-6:
            return None
        away = _minus(grip.origin, ray.start_m)
        distance = dot(away, grip.axis) / slope
        if distance <= 0.0:
            return None
        arm = _minus(ray.at(distance), grip.origin)
        first = _square_to(grip.axis)
        second = _cross(grip.axis, first)
        return math.degrees(math.atan2(dot(arm, second), dot(arm, first)))


def snapped(value: float, step: float) -> float:
    """The nearest multiple of a step."""
    return round(value / step) * step


def _along(ray: Ray, origin: Vector, axis: Vector) -> float | None:
    """How far along a line the place is that a ray passes nearest to."""
    away = _minus(ray.start_m, origin)
    slope = dot(ray.direction, axis)
    square = 1.0 - slope * slope
    if square < 1e-6:
        return None
    return (dot(away, axis) - slope * dot(away, ray.direction)) / square


def _away_px(grip: Grip, projection: Projection, x_px: float, y_px: float) -> float:
    """How far the pointer is from a handle's line."""
    pixels = [projection.pixel(place) for place in grip.places]
    nearest = math.inf
    for one, other in itertools.pairwise(pixels):
        if one is not None and other is not None:
            nearest = min(nearest, _from_segment_px((x_px, y_px), one, other))
    return nearest


def _from_segment_px(
    at: tuple[float, float], one: tuple[float, float], other: tuple[float, float]
) -> float:
    across, down = other[0] - one[0], other[1] - one[1]
    length_2 = across * across + down * down
    share = 0.0
    if length_2 > 0.0:
        share = ((at[0] - one[0]) * across + (at[1] - one[1]) * down) / length_2
        share = min(1.0, max(0.0, share))
    return math.hypot(at[0] - one[0] - share * across, at[1] - one[1] - share * down)


def _sight(projection: Projection, place: Vector) -> Vector:
    """A unit vector from the eye to a place."""
    outward, _, _ = projection.camera.axes()
    if projection.camera.orthographic:
        return (-outward[0], -outward[1], -outward[2])
    return unit(_minus(place, projection.camera.eye_m))


def _arrow(origin: Vector, axis: Vector, sight: Vector, length: float) -> tuple[Vector, ...]:
    """A line with a head, seen from its side."""
    aside = unit(_cross(axis, sight))
    tip = _plus(origin, axis, length)
    neck = _plus(origin, axis, length * (1.0 - 1.6 * _ARROW_SHARE))
    left = _plus(neck, aside, length * _ARROW_SHARE)
    right = _plus(neck, aside, -length * _ARROW_SHARE)
    return (_plus(origin, axis, length * _GAP_SHARE), tip, left, tip, right)


def _circle(origin: Vector, axis: Vector, radius: float) -> tuple[Vector, ...]:
    return _arc(origin, axis, _square_to(axis), radius, (0.0, 360.0))


def _arc(
    origin: Vector, axis: Vector, pointer: Vector, radius: float, ends_deg: tuple[float, float]
) -> tuple[Vector, ...]:
    first, last = ends_deg
    steps = max(2, math.ceil((last - first) / _ARC_STEP_DEG))
    angles = (first + (last - first) * step / steps for step in range(steps + 1))
    return tuple(
        _plus(origin, turned(rotation(axis, math.radians(angle)), pointer), radius)
        for angle in angles
    )


def _square_to(axis: Vector) -> Vector:
    """A unit vector square to another."""
    plain = (1.0, 0.0, 0.0) if abs(axis[0]) < 0.7 else (0.0, 1.0, 0.0)
    return unit(without_part_along(plain, axis))


def _cross(one: Vector, other: Vector) -> Vector:
    return (
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    )


def _minus(one: Vector, other: Vector) -> Vector:
    return (one[0] - other[0], one[1] - other[1], one[2] - other[2])


def _plus(start: Vector, direction: Vector, distance: float) -> Vector:
    return (
        start[0] + direction[0] * distance,
        start[1] + direction[1] * distance,
        start[2] + direction[2] * distance,
    )
