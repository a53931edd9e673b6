"""Where the simulated arm is, judged without the program's own geometry.

The arm is its centre line, from the shoulder over elbow and wrist to the fingertips, and a little
around it: less than its links are thick. So what this calls inside is inside.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation

Array = npt.NDArray[np.float64]

# a(i-1) mm, alpha(i-1) °, d(i) mm, offset of theta ° (modified DH, firmware from S-V1.6-3)
_DH: Final = (
    (0.0, 0.0, 123.0, 0.0),
    (0.0, -90.0, 0.0, -172.22),
    (285.03, 0.0, 0.0, -102.78),
    (-21.98, 90.0, 250.75, 0.0),
    (0.0, -90.0, 0.0, 0.0),
    (0.0, 90.0, 91.0, 0.0),
)
_FINGERS_MM: Final = 135.0
"""From the flange to the tips of the fingers, less than the maker's own."""
_ROUND_MM: Final = 12.0
_APART_MM: Final = 10.0


def _frames(joints_deg: Sequence[float]) -> list[Array]:
    frame, found = np.eye(4), []
    for (a, alpha_deg, d, offset_deg), angle_deg in zip(_DH, joints_deg, strict=True):
        alpha, theta = math.radians(alpha_deg), math.radians(angle_deg + offset_deg)
        ca, sa, ct, st = math.cos(alpha), math.sin(alpha), math.cos(theta), math.sin(theta)
        frame = frame @ np.array(
            [
                [ct, -st, 0.0, a],
                [st * ca, ct * ca, -sa, -sa * d],
                [st * sa, ct * sa, ca, ca * d],
                [0.0, 0.0, 0.0, 1.0],
            ]
        )
        found.append(frame)
    return found


def pose_of(joints_deg: Sequence[float]) -> tuple[float, ...]:
    """The flange: X, Y, Z in mm, RX, RY, RZ in degrees, as the arm reports it."""
    flange = _frames(joints_deg)[-1]
    turned = Rotation.from_matrix(flange[:3, :3]).as_euler("xyz", degrees=True)
    return (*(float(each) for each in flange[:3, 3]), *(float(each) for each in turned))


def tip_of(joints_deg: Sequence[float]) -> Array:
    """Where the tips of the fingers are, in mm."""
    return np.asarray(_centre_line(_frames(joints_deg))[-1])


def _centre_line(frames: Sequence[Array]) -> list[Array]:
    flange = frames[5]
    tip = flange[:3, 3] + _FINGERS_MM * flange[:3, 2]
    return [frames[1][:3, 3], frames[2][:3, 3], frames[4][:3, 3], flange[:3, 3], tip]


def _places(joints_deg: Sequence[float]) -> Array:
    """(n, 3) places on the centre line, from the elbow on: the shoulder moves nowhere."""
    corners = _centre_line(_frames(joints_deg))[1:]
    found = []
    for start, end in itertools.pairwise(corners):
        count = max(2, int(np.linalg.norm(end - start) / _APART_MM))
        found.append(start + np.linspace(0.0, 1.0, count)[:, None] * (end - start))
    return np.concatenate(found)


def depth_in_box_mm(
    joints_deg: Sequence[float], centre_mm: Sequence[float], size_mm: Sequence[float]
) -> float:
    """How deep the arm is in a box along the base's axes; below 0 it is clear of it."""
    away = np.abs(_places(joints_deg) - np.asarray(centre_mm)) - np.asarray(size_mm) / 2
    outside = np.linalg.norm(np.maximum(away, 0.0), axis=1)
    inside = np.minimum(away.max(axis=1), 0.0)
    return float(_ROUND_MM - (outside + inside).min())


def depth_beyond_mm(joints_deg: Sequence[float], x_mm: float) -> float:
    """How far the arm is beyond a plane across X; below 0 it is this side of it."""
    return float(_places(joints_deg)[:, 0].max() + _ROUND_MM - x_mm)


def height_mm(joints_deg: Sequence[float]) -> float:
    """How high flange or fingertips are above the base's plane, whichever is lower."""
    *_others, flange, tip = _centre_line(_frames(joints_deg))
    return float(min(flange[2], tip[2]))
