"""The work area and what the hand holds in the picture: plain data for the render process."""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from armui.viewport.robot_shape import moved
from armui.viewport.vectors import Vector

_FURTHEST_M: Final = 1.2
"""The part of a large box that is fitted into the picture: so far on each side of the base."""


@dataclass(frozen=True, slots=True)
class AreaShape:
    """A plane or a box of the work area, or what the hand holds.

    Attributes:
        rows: Its frame in the base: the upper three rows of the transform, row by row, in metres.
            The Z axis of a plane points to the side on which the arm stays.
        size_mm: The edges of a box; ``None`` for a plane.
        near: True if the arm is near, so that it is lit.
        held: True if the frame is in the flange instead, and it moves with the arm.
        is_rod: True for a rod along the Z axis, as long as its edge there.
        pale: True if it is not confirmed: only its edges are drawn, in no colour.
    """

    rows: tuple[float, ...]
    size_mm: tuple[float, ...] | None = None
    near: bool = False
    held: bool = False
    is_rod: bool = False
    pale: bool = False


AreaPicture = tuple[AreaShape, ...]


def corners(area: AreaPicture) -> Iterator[Vector]:
    """Yield the corners of the boxes in the base, in metres; those far off are moved nearer."""
    for shape in area:
        if shape.size_mm is not None and not shape.held:
            for x, y, z in itertools.product(*((-mm / 2e3, mm / 2e3) for mm in shape.size_mm)):
                x, y, z = (  # noqa: PLW2901 - the corner in the base
                    max(-_FURTHEST_M, min(each, _FURTHEST_M))
                    for each in moved(shape.rows, (x, y, z))
                )
                yield x, y, z
