"""The place where the measured arm is nearer to its work area than allowed: plain data."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class AreaIntrusion:
    """The place where the measured arm is nearer to its work area than allowed.

    Attributes:
        name: The name of the plane or box.
        part: The part of the arm.
        value_mm: The missing distance, in mm.
    """

    name: str
    part: str
    value_mm: int
