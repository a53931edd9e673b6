"""How far the pointer carries a handle that is held. Pure."""

from __future__ import annotations

import itertools
import math
from typing import Final

from armui.viewport.camera import Vector
from armui.viewport.grips import EDGE_ON, Grip, GripKind, from_segment_px, sight
from armui.viewport.projection import Projection, Ray, dot
from armui.viewport.robot_shape import unit, without_part_along
from armui.viewport.vectors import cross, minus, square_to

_SAME_PX: Final = 3.0
"""Seen from its edge, the near and the far side of an arc lie so close together."""
_ROUND_DEG: Final = 60.0
"""So far from the side that faces the eye the pointer stays on the place it has taken; beyond, a
pixel of it would be more and more degrees, and the rest of a turn is as far as at that place."""
_ROUND: Final = math.sin(math.radians(_ROUND_DEG))
_BEYOND: Final = 1.0 / math.cos(math.radians(_ROUND_DEG))


class GripDrag:
    """A handle that is held, from the press on.

    What turns is followed in the plane that it turns in. A joint's arc that is seen from its edge
    is followed on the cylinder about the joint's axis instead, on the side that was taken hold of:
    the pointer goes along the line that is seen, and turns the joint as it would turn a wheel.

    Args:
        grip: Which.
        projection: Of the picture at the press; the camera rests while a handle is held.
        x_px: Where it was taken hold of.
        y_px: Likewise.
    """

    def __init__(self, grip: Grip, projection: Projection, x_px: float, y_px: float) -> None:
        self.grip = grip
        self._projection = projection
        self._radius_m = 0.0  # of the cylinder; 0: it is followed in its plane
        self._first = square_to(grip.axis)  # where angles are counted from
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
        """How far the pointer has carried it: mm along an axis, degrees about one.

        Returns:
            None where the pointer leads nowhere, beyond the horizon of the plane it turns in.
        """
        now = self._at(self._projection.ray(x_px, y_px))
        if now is None:
            return None
        if self.grip.kind is GripKind.AXIS:
            return (now - self._start) * 1000.0
        if self._radius_m > 0.0:
            return now - self._start  # a wheel's angle grows without end
        # on the shorter way round from the last place: a ring can be turned more than once
        self._turns += (now - self._last + 180.0) % 360.0 - 180.0
        self._last = now
        return self._turns

    def _at(self, ray: Ray) -> float | None:
        """Metres along the axis, or degrees about it, of what a ray points at."""
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
        """Degrees about the axis of where a ray meets the cylinder, seen along its axis."""
        first, second = self._first, cross(self.grip.axis, self._first)
        to_eye = (-dot(ray.direction, first), -dot(ray.direction, second))
        length = math.hypot(*to_eye)
        if length < 1e-6:
            return None
        start = minus(ray.start_m, self.grip.origin)
        # how far beside the axis the ray passes, in radii, counted the way the angles are
        passed_m = to_eye[0] * dot(start, second) - to_eye[1] * dot(start, first)
        aside = passed_m / (length * self._radius_m)
        turned_deg = _wheel_deg(aside)
        facing_deg = math.degrees(math.atan2(to_eye[1], to_eye[0]))
        return facing_deg + (turned_deg if self._is_near else 180.0 - turned_deg)


def _wheel_deg(aside: float) -> float:
    """Degrees from the side that faces the eye, of what is seen so many radii beside the middle."""
    if abs(aside) <= _ROUND:
        return math.degrees(math.asin(aside))
    beyond = math.degrees((abs(aside) - _ROUND) * _BEYOND)
    return math.copysign(_ROUND_DEG + beyond, aside)


def _is_near(grip: Grip, projection: Projection, ahead: Vector, at_px: tuple[float, float]) -> bool:
    """Whether the side that faces the eye is taken hold of; where both are there, it is that."""
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
    """How far along a line the place is that a ray passes nearest to."""
    away = minus(ray.start_m, origin)
    slope = dot(ray.direction, axis)
    square = 1.0 - slope * slope
    if square < 1e-6:
        return None
    return (dot(away, axis) - slope * dot(away, ray.direction)) / square
