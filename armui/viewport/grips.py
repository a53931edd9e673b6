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
from armui.viewport.projection import Projection, dot
from armui.viewport.robot_shape import RobotShape, Rows, rotation, turned, unit
from armui.viewport.vectors import cross, minus, plus, square_to

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
EDGE_ON: Final = 0.13
"""Cosine of the angle between sight and axis below which a ring is seen from its edge: it can't be
turned then, for the same reason. A joint's arc can, see `armui.viewport.grip_drag`."""
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
    """An arc at each joint, about its axis, beside what it moves."""
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
    """The handle under the pointer; of several the nearest."""
    nearest: tuple[float, Grip] | None = None
    for grip in grips:
        away_px = _away_px(grip, projection, x_px, y_px)
        if away_px <= _NEAR_PX and (nearest is None or away_px < nearest[0]):
            nearest = (away_px, grip)
    return None if nearest is None else nearest[1]


def snapped(value: float, step: float) -> float:
    """The nearest multiple of a step."""
    return round(value / step) * step


def _away_px(grip: Grip, projection: Projection, x_px: float, y_px: float) -> float:
    """How far the pointer is from a handle's line."""
    pixels = [projection.pixel(place) for place in grip.places]
    nearest = math.inf
    for one, other in itertools.pairwise(pixels):
        if one is not None and other is not None:
            nearest = min(nearest, from_segment_px((x_px, y_px), one, other))
    return nearest


def from_segment_px(
    at: tuple[float, float], one: tuple[float, float], other: tuple[float, float]
) -> float:
    """How far a pixel is from a line between two others."""
    across, down = other[0] - one[0], other[1] - one[1]
    length_2 = across * across + down * down
    share = 0.0
    if length_2 > 0.0:
        share = ((at[0] - one[0]) * across + (at[1] - one[1]) * down) / length_2
        share = min(1.0, max(0.0, share))
    return math.hypot(at[0] - one[0] - share * across, at[1] - one[1] - share * down)


def sight(projection: Projection, place: Vector) -> Vector:
    """A unit vector from the eye to a place."""
    outward, _, _ = projection.camera.axes()
    if projection.camera.orthographic:
        return (-outward[0], -outward[1], -outward[2])
    return unit(minus(place, projection.camera.eye_m))


def _arrow(origin: Vector, axis: Vector, sight: Vector, length: float) -> tuple[Vector, ...]:
    """A line with a head, seen from its side."""
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
