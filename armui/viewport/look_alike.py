"""Whether two poses of the arm can be told apart in a picture. Pure."""

from __future__ import annotations

from typing import Final

_SAME_ANGLE_DEG: Final = 0.005
"""Less moves nothing by a pixel: an arm at rest that reports the last digit is not drawn anew."""


def look_alike(one: tuple[float, ...] | None, other: tuple[float, ...] | None) -> bool:
    """Whether two poses of the arm, six angles in degrees each, can't be told apart on a screen."""
    if one is None or other is None:
        return False
    return all(abs(a - b) < _SAME_ANGLE_DEG for a, b in zip(one, other, strict=True))
