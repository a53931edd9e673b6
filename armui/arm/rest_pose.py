"""The pose in which an arm lies when it is switched on."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

REST_DEG: Final = (0.0, -1.999, 1.971, -1.412, 22.110, -2.608)
"""The six angles in degrees, joint 1 first, as a PiPER told them when it was switched on in 2026.

Joints 2 and 3 lie 2° outside their limits, and the hand lies on the base. For the other models it
is not published.
"""

_OLDER_ZEROS_DEG: Final = (0.0, -2.0, 2.0, 0.0, 0.0, 0.0)
"""The zeros before S-V1.6-3, counted from today's."""


def rest_pose_deg(*, older_zeros: bool = False) -> tuple[float, ...]:
    """Return the angles that an arm tells in its rest pose.

    Args:
        older_zeros: True if it counts from the zeros before S-V1.6-3.
    """
    zeros_deg = _OLDER_ZEROS_DEG if older_zeros else (0.0,) * 6
    return tuple(angle - zero for angle, zero in zip(REST_DEG, zeros_deg, strict=True))


def from_rest_deg(joints_deg: Sequence[float]) -> tuple[float, ...]:
    """Return how far each joint is from where it may rest: between its zero and its rest pose."""
    return tuple(
        max(min(0.0, rest) - angle, angle - max(0.0, rest), 0.0)
        for angle, rest in zip(joints_deg, REST_DEG, strict=True)
    )
