"""Vectors in plain Python: the window computes with them before numpy is loaded. Pure."""

from __future__ import annotations

import math

Vector = tuple[float, float, float]


def dot(one: Vector, other: Vector) -> float:
    """Return the scalar product."""
    return one[0] * other[0] + one[1] * other[1] + one[2] * other[2]


def cross(one: Vector, other: Vector) -> Vector:
    """Return the vector product."""
    return (
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    )


def minus(one: Vector, other: Vector) -> Vector:
    """Return the vector from the other place to the one."""
    return (one[0] - other[0], one[1] - other[1], one[2] - other[2])


def plus(start: Vector, direction: Vector, distance: float) -> Vector:
    """Return the place at a distance from a start in a direction."""
    return (
        start[0] + direction[0] * distance,
        start[1] + direction[1] * distance,
        start[2] + direction[2] * distance,
    )


def square_to(axis: Vector) -> Vector:
    """Return a unit vector square to a given one."""
    plain = (1.0, 0.0, 0.0) if abs(axis[0]) < 0.7 else (0.0, 1.0, 0.0)
    return unit(without_part_along(plain, axis))


def unit(vector: Vector) -> Vector:
    """Return the unit vector of a direction."""
    length = math.hypot(*vector)
    return (vector[0] / length, vector[1] / length, vector[2] / length)


def without_part_along(vector: Vector, axis: Vector) -> Vector:
    """Return the part of a vector that is square to a unit axis."""
    along = vector[0] * axis[0] + vector[1] * axis[1] + vector[2] * axis[2]
    return (
        vector[0] - along * axis[0],
        vector[1] - along * axis[1],
        vector[2] - along * axis[2],
    )
