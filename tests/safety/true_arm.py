"""Where an arm truly is, by the maker's table of its geometry and nothing of the program's own."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import starmap
from math import radians

import numpy as np

_ROWS = (
    # a(i-1) mm, alpha(i-1) °, d(i) mm, offset of theta °
    (0.0, 0.0, 123.0, 0.0),
    (0.0, -90.0, 0.0, -172.22),
    (285.03, 0.0, 0.0, -102.78),
    (-21.98, 90.0, 250.75, 0.0),
    (0.0, -90.0, 0.0, 0.0),
    (0.0, 90.0, 91.0, 0.0),
)
_FINGERTIP_MM = 140.0


def flange(joints_deg: Sequence[float]) -> np.ndarray:
    """The flange's transform in the base, in mm, at six angles in degrees."""
    pose = np.eye(4)
    for step in starmap(_step, zip(joints_deg, _ROWS, strict=True)):
        pose = pose @ step
    return pose


def lowest_mm(joints_deg: Sequence[float]) -> float:
    """The height of flange or fingertip over the base plane, whichever is lower."""
    pose = flange(joints_deg)
    return float(pose[2, 3] + min(0.0, _FINGERTIP_MM * pose[2, 2]))


def _step(angle_deg: float, row: Sequence[float]) -> np.ndarray:
    a_mm, alpha_deg, d_mm, offset_deg = row
    theta, alpha = radians(angle_deg + offset_deg), radians(alpha_deg)
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array(
        [
            [ct, -st, 0.0, a_mm],
            [st * ca, ct * ca, -sa, -d_mm * sa],
            [st * sa, ct * sa, ca, d_mm * ca],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
