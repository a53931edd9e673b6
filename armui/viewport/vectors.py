"""Plain arithmetic with places and directions. Pure."""

from __future__ import annotations

from armui.viewport.camera import Vector
from armui.viewport.robot_shape import unit, without_part_along


def cross(one: Vector, other: Vector) -> Vector:
    """The vector product."""
    return (
        one[1] * other[2] - one[2] * other[1],
        one[2] * other[0] - one[0] * other[2],
        one[0] * other[1] - one[1] * other[0],
    )


def minus(one: Vector, other: Vector) -> Vector:
    """From the other to the one."""
    return (one[0] - other[0], one[1] - other[1], one[2] - other[2])


def plus(start: Vector, direction: Vector, distance: float) -> Vector:
    """The place so far from a start in a direction."""
    return (
        start[0] + direction[0] * distance,
        start[1] + direction[1] * distance,
        start[2] + direction[2] * distance,
    )


def square_to(axis: Vector) -> Vector:
    """A unit vector square to another."""
    plain = (1.0, 0.0, 0.0) if abs(axis[0]) < 0.7 else (0.0, 1.0, 0.0)
    return unit(without_part_along(plain, axis))
