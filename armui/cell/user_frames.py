"""User frames: places of the work with axes of their own, by name, in the base.

Three points give one, captured with the tool centre point: its origin, a point on +X, and one on
the side of +Y. The right hand tells Z.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_pose

FRAME_POINTS_NEAR = Reason(
    "frame_points_near",
    "The point for {point} is {value} mm from the origin; at least {minimum} mm are needed. Take "
    "it again, further away.",
)
FRAME_POINTS_IN_LINE = Reason(
    "frame_points_in_line",
    "The three points lie nearly in line: the third is {value}° off the X axis, at least "
    "{minimum}° are needed. Take the point on the +Y side again, further to the side.",
)

FURTHEST_MM: Final = 5000.0
LEAST_APART_MM: Final = 20.0
"""Two points must be so far apart: a tip that is 0.1 mm off then turns an axis by 0.3°."""
LEAST_OFF_DEG: Final = 10.0
"""The third point must be so far off the X axis, seen from the origin."""
NO_FRAME: Final = (0.0,) * 6


@dataclass(frozen=True, slots=True)
class UserFrame:
    """A frame of the operator's.

    Attributes:
        name: Its name in the cell.
        pose: The frame in the base: X, Y, Z in mm, RX, RY, RZ in degrees.
    """

    name: str
    pose: tuple[float, ...] = NO_FRAME


def check_user_frame(frame: UserFrame) -> Refusal | None:
    """Return why the figures of a frame are not possible, or ``None``."""
    return check_pose(frame.name, frame.pose, FURTHEST_MM)


def frame_from_points(
    origin: Sequence[float], on_x: Sequence[float], on_y_side: Sequence[float]
) -> tuple[float, ...] | Refusal:
    """Return the pose of a right-handed frame in the base, or why the points give none.

    Args:
        origin: The place of its origin, X, Y, Z in mm; what follows is not looked at.
        on_x: A place on its X axis, on the positive side.
        on_y_side: A place in its XY plane, on the side of +Y.
    """
    # imported here, because the window starts without numpy
    import numpy as np  # noqa: PLC0415

    from armui.kinematics.poses import matrix_to_pose  # noqa: PLC0415

    places = np.array([each[:3] for each in (origin, on_x, on_y_side)], dtype=np.float64)
    ways = places[1:] - places[0]
    for point, place in (("+X", on_x), ("+Y", on_y_side)):
        if near := why_near(origin, place, point):
            return near
    x, aside = (way / np.linalg.norm(way) for way in ways)
    z = np.cross(x, aside)
    _, off_deg = off_x_axis(*places.tolist())
    if off_deg < LEAST_OFF_DEG:
        return FRAME_POINTS_IN_LINE(value=off_deg, minimum=round(LEAST_OFF_DEG))
    z /= np.linalg.norm(z)
    matrix = np.eye(4)
    matrix[:3] = np.column_stack((x, np.cross(z, x), z, places[0]))
    return tuple(matrix_to_pose(matrix))


def why_near(origin: Sequence[float], place: Sequence[float], point: str) -> Refusal | None:
    """Return why a place is too near to the origin to be taken for a point, or ``None``."""
    apart_mm = math.dist(origin[:3], place[:3])
    if apart_mm < LEAST_APART_MM:
        return FRAME_POINTS_NEAR(point=point, value=apart_mm, minimum=round(LEAST_APART_MM))
    return None


def off_x_axis(
    origin: Sequence[float], on_x: Sequence[float], place: Sequence[float]
) -> tuple[float, float]:
    """Return how far a place is off the line from an origin to a point on X: in mm, in degrees.

    The angle is seen from the origin, and never more than 90°.
    """
    x, way = ([a - b for a, b in zip(each[:3], origin, strict=False)] for each in (on_x, place))
    along_mm = sum(a * b for a, b in zip(x, way, strict=True)) / max(math.hypot(*x), 1e-9)
    off_mm = math.sqrt(max(0.0, math.hypot(*way) ** 2 - along_mm**2))
    return off_mm, math.degrees(math.atan2(off_mm, abs(along_mm)))
