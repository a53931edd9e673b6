"""The way back of an arm that is found outside its limits, as a resting one is when switched on."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.limits import JOINTS, LIFTED, LIFTED_DEG, clipped, outside_limits, settled
from armui.ways.law import Flags
from armui.ways.rules import Rules

_INSIDE_DEG: Final = 0.5
"""A joint is brought this far inside its limit, so that sag does not bring it out again."""
_REST: Final = "base/hand"
NEAR_MM: Final = 5.0
"""The capsules lie a little within the covers: parts this near to each other may touch."""


def ways_inside(joints_deg: Sequence[float], rules: Rules) -> tuple[tuple[float, ...], ...]:
    """Return the targets, one after the other, that bring an arm inside; none if it is inside.

    The arm takes no target before all of its joints are inside, so the first one brings them in
    together. The second one turns joint 5 until hand and base are apart.

    Args:
        joints_deg: The six measured angles.
        rules: Those in force.
    """
    limits = rules.arm.limits
    outside = outside_limits(joints_deg, limits)
    inside = list(settled(joints_deg, limits))
    for joint in outside:
        place = joint - 1
        limit_deg = clipped(inside[place], limits[place])
        step_deg = _INSIDE_DEG if inside[place] < limit_deg else -_INSIDE_DEG
        inside[place] = clipped(limit_deg + step_deg, limits[place])
    targets = [tuple(inside)] if outside else []
    if is_on_base(inside, rules).any() and inside[LIFTED] > LIFTED_DEG:
        inside[LIFTED] = LIFTED_DEG
        targets.append(tuple(inside))
    return tuple(targets)


def is_on_base(poses_deg: npt.ArrayLike, rules: Rules, near_mm: float = NEAR_MM) -> Flags:
    """Return for (n, 6) angles whether hand and base are less than a distance in mm apart."""
    poses = np.asarray(poses_deg, dtype=float).reshape(-1, len(JOINTS))
    on_base = np.zeros(len(poses), dtype=bool)
    for rule in rules.every:
        if _REST in rule.bounds:
            on_base |= rule.outside(poses)[:, rule.bounds.index(_REST)] > -near_mm
    return on_base
