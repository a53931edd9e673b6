"""Lines over the picture: the tool's frame, the range of a joint. Pure.

Their places are in the base frame, in metres; `armui.viewport.stroke_painter` projects them with
the camera of the picture.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from armui.viewport.palette import ScenePalette
from armui.viewport.robot_shape import RobotShape, Rows, moved, rotation, turned
from armui.viewport.vectors import Vector

FRAME_M: Final = 0.07
ARC_M: Final = 0.13
_ARC_STEP_DEG: Final = 4.0
_TICK_SHARE: Final = 0.12


@dataclass(frozen=True, slots=True)
class Stroke:
    """A line through places, or a surface.

    Attributes:
        places: The places in the base frame, metres.
        color: "#rrggbb".
        width_px: The width of the line.
        filled: True if the places are the rim of a translucent surface.
        label: The label at its last place.
    """

    places: tuple[Vector, ...]
    color: str
    width_px: float = 2.0
    filled: bool = False
    label: str = ""


@dataclass(frozen=True, slots=True)
class FrameMark:
    """A user frame in the picture.

    Attributes:
        name: Its name.
        rows: Its place in the base.
        lit: True for the one in force, or that is to be looked at; the others are faint.
    """

    name: str
    rows: Rows
    lit: bool = False


def tool_frame(rows: Rows, palette: ScenePalette) -> list[Stroke]:
    """Return the axes of the tool centre point."""
    return [
        Stroke((_origin(rows), end), color, 2.5, label=name)
        for end, color, name in zip(_axis_ends(rows), palette.axes, "xyz", strict=True)
    ]


def user_frames(marks: Sequence[FrameMark], palette: ScenePalette) -> list[Stroke]:
    """Return the axes and the names of user frames; the name stands below the origin."""
    strokes = []
    for mark in marks:
        colors = palette.axes if mark.lit else (palette.muted,) * 3
        names, width_px = ("XYZ", 2.5) if mark.lit else (" " * 3, 1.0)
        start = _origin(mark.rows)
        for end, color, name in zip(_axis_ends(mark.rows), colors, names, strict=True):
            strokes.append(Stroke((start, end), color, width_px, label=name.strip()))
        below = moved(mark.rows, (0.0, 0.0, -0.01))
        color = palette.text if mark.lit else palette.muted
        strokes.append(Stroke((start, below), color, width_px, label=mark.name))
    return strokes


def _origin(rows: Rows) -> Vector:
    return rows[3], rows[7], rows[11]


def _axis_ends(rows: Rows) -> list[Vector]:
    ends = ((FRAME_M, 0.0, 0.0), (0.0, FRAME_M, 0.0), (0.0, 0.0, FRAME_M))
    return [moved(rows, end) for end in ends]


def joint_range(
    shape: RobotShape,
    angles_deg: Sequence[float],
    number: int,
    limits_deg: tuple[float, float],
    palette: ScenePalette,
    *,
    measured_deg: float | None = None,
) -> list[Stroke]:
    """Return the range of a joint as an arc about its axis, with a needle at its angle.

    Args:
        shape: The robot.
        angles_deg: Six joint angles as on the bus: those measured, or those of a target.
        number: The joint's number, 1–6.
        limits_deg: The lowest and the highest angle.
        palette: The theme's colours.
        measured_deg: The joint's measured angle, if the six are those of a target: it gets a
            needle, too.
    """
    links = shape.links(angles_deg)
    place, axis = shape.joint_frame(number, links)
    pointer = shape.joint_pointer(number, links)
    angle_deg = angles_deg[number - 1]
    low_deg, high_deg = limits_deg

    def at(degrees: float, radius_m: float = ARC_M) -> Vector:
        x, y, z = turned(rotation(axis, math.radians(degrees - angle_deg)), pointer)
        return (
            place[0] + radius_m * x,
            place[1] + radius_m * y,
            place[2] + radius_m * z,
        )

    steps = max(2, math.ceil((high_deg - low_deg) / _ARC_STEP_DEG))
    arc = tuple(at(low_deg + (high_deg - low_deg) * step / steps) for step in range(steps + 1))
    beyond = not low_deg <= angle_deg <= high_deg
    inner, outer = ARC_M * (1.0 - _TICK_SHARE), ARC_M * (1.0 + _TICK_SHARE)
    is_target = measured_deg is not None
    hand = palette.fault if beyond else palette.commanded if is_target else palette.text
    measured = [] if measured_deg is None else [(place, at(measured_deg, outer))]
    return [
        Stroke((place, *arc), palette.accent, 0.0, filled=True),
        Stroke(arc, palette.accent, 2.5),
        Stroke(
            (at(low_deg, inner), at(low_deg, outer)), palette.accent, 2.5, label=f"{low_deg:g}°"
        ),
        Stroke(
            (at(high_deg, inner), at(high_deg, outer)), palette.accent, 2.5, label=f"{high_deg:g}°"
        ),
        *(Stroke(needle, palette.text, 2.5) for needle in measured),
        Stroke(
            (place, at(angle_deg, outer)), hand, 2.5, label=f"{angle_deg:.3f}°" if is_target else ""
        ),
    ]
