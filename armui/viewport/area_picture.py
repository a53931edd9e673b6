"""The work area in the picture: plain data, passed to the render process."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class AreaShape:
    """A plane or a box of the work area.

    Attributes:
        rows: Its frame in the base: the upper three rows of the transform, row by row, in mm. The
            Z axis of a plane points to the side on which the arm stays.
        size_mm: The edges of a box; ``None`` for a plane.
        near: True if the arm is near, so that it is lit.
    """

    rows: tuple[float, ...]
    size_mm: tuple[float, ...] | None = None
    near: bool = False


AreaPicture = tuple[AreaShape, ...]
