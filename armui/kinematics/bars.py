"""Two bars in the arm's plane, upper arm and forearm: how they reach a place."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from armui.kinematics.geometry import Geometry
from armui.kinematics.poses import Matrix, components

_ROUNDING: Final = 1e-9


def wrist_centres(geometry: Geometry, targets: Matrix) -> tuple[Matrix, Matrix, Matrix]:
    """Of each target: how far from joint 1's axis, how high above the shoulder, in which turn.

    Args:
        geometry: Of the arm.
        targets: (…, 4, 4) transforms of the flange.
    """
    centres = targets[..., :3, 3] - geometry.hand_mm * targets[..., :3, 2]
    x, y, z = components(centres)
    return np.hypot(x, y), z - geometry.base_mm, np.arctan2(y, x)


def bar_angles(
    geometry: Geometry, out: Matrix, height: Matrix, elbow_above: npt.NDArray[np.bool_] | Any
) -> tuple[Matrix, Matrix]:
    """How both bars rise, in radians, to end in a place of the plane; NaN out of their reach.

    Args:
        geometry: Of the arm; its second bar is the straight line from elbow to wrist.
        out: (…) outwards from the shoulder, in mm.
        height: (…) above it, in mm.
        elbow_above: Whether the first bar rises more than the straight line to the place.
    """
    upper_mm, fore_mm = geometry.upper_arm_mm, geometry.elbow_to_wrist_mm
    straight = np.hypot(out, height)
    with np.errstate(divide="ignore", invalid="ignore"):
        cosine = (upper_mm**2 - fore_mm**2 + straight**2) / (2 * upper_mm * straight)
        # a pose the arm itself has reported may be out of reach by rounding
        cosine = np.where(np.abs(cosine) <= 1.0 + _ROUNDING, np.clip(cosine, -1.0, 1.0), math.nan)
    upper = np.arctan2(height, out) + np.arccos(cosine) * np.where(elbow_above, 1.0, -1.0)
    fore = np.arctan2(height - upper_mm * np.sin(upper), out - upper_mm * np.cos(upper))
    return upper, fore


def out_of_reach_mm(geometry: Geometry, out: Matrix, height: Matrix) -> Matrix:
    """(…) how far a place of the plane is out of both bars' reach, in mm; 0 within it."""
    straight = np.hypot(out, height)
    upper_mm, fore_mm = geometry.upper_arm_mm, geometry.elbow_to_wrist_mm
    beyond = np.maximum(straight - upper_mm - fore_mm, abs(upper_mm - fore_mm) - straight)
    missing: Matrix = np.maximum(beyond, 0.0)
    return missing
