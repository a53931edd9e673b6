"""Singular poses: joints turn fast there for little motion of the flange, or cannot follow it.

In them the elbow is straight, or the wrist's centre is above joint 1; a spherical wrist is
straight, or joint 5 of a parallel wrist is at ±90°.
"""

from __future__ import annotations

from typing import Final, TypeVar

import numpy as np
import numpy.typing as npt

from armui.kinematics.forward import SIDE, plane_vectors, stacked
from armui.kinematics.geometry import Geometry, Wrist
from armui.kinematics.poses import Matrix

_Figure = TypeVar("_Figure", float, Matrix)

NEAR_SINGULAR: Final = 0.02
"""A smallest singular value, in m and rad per rad: at it a hand moving at 60 mm/s needs a joint's 3
rad/s.
"""

_FINE_STEP_MM: Final = 1.0
_FINE_STEP_DEG: Final = 0.25
"""The length of a fine step of a tool path, or the turn of the hand in it."""
_STEEPEST_DEG: Final = 5.0
"""A joint that turns further in a fine step of a path is at a singular pose."""
JITTER_DEG: Final = 0.01
"""A turn up to this is rounding, in however short a step."""


def jacobians(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """Return the Jacobian of the flange at (…, 6) joint angles.

    Returns:
        (…, 6, 6): the first three rows are its velocity in m/rad, the others its angular velocity
        in rad/rad.
    """
    arm = plane_vectors(geometry, joints_deg)
    up, shoulder = (0.0, 0.0, 1.0), (0.0, 0.0, geometry.base_mm)
    shape = (*joints_deg.shape[:-1], 3)
    axes, origins = (
        np.stack([np.broadcast_to(stacked(arm.turned(each)), shape) for each in vectors], axis=-1)
        for vectors in (
            (up, SIDE, SIDE, arm.axis_4, arm.bend_axis, arm.hand),
            (shoulder, shoulder, arm.elbow, arm.wrist, arm.centre, arm.centre),
        )
    )
    levers_m = (stacked(arm.turned(arm.flange))[..., None] - origins) / 1e3
    return np.concatenate((np.cross(axes, levers_m, axis=-2), axes), axis=-2)


def margins(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """Return (…) a quick measure, 0 to 1, of how far (…, 6) joint angles are from singular poses.

    It finds the pose of a path that is nearest to a singular one; how near that is, the smallest
    singular value tells.
    """
    arm = plane_vectors(geometry, joints_deg)
    (wrist_out, _, wrist_up), (elbow_out, _, elbow_up) = arm.wrist, arm.elbow
    fore_out, fore_up = wrist_out - elbow_out, wrist_up - elbow_up
    elbow = arm.upper_arm[0] * fore_up - arm.upper_arm[2] * fore_out
    bend = np.radians(joints_deg[..., 4])
    hand = np.cos(bend) if geometry.wrist is Wrist.PARALLEL else np.sin(bend)
    reach = geometry.upper_arm_mm + geometry.elbow_to_wrist_mm + geometry.wrist_mm
    margin: Matrix = np.abs(hand * elbow * arm.centre[0]) / (geometry.elbow_to_wrist_mm * reach)
    return margin


def smallest_singular_values(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """Return (…) that of the Jacobians at (…, 6) angles: 0 in a singular pose, 0.1 in a good one.

    Its inverse is the most a joint turns for 1 m, or 1 rad, of the flange's motion.
    """
    values = np.linalg.svd(jacobians(geometry, joints_deg), compute_uv=False)
    return np.asarray(values[..., -1], dtype=np.float64)


def fine_steps(length_mm: _Figure, angle_deg: _Figure) -> _Figure:
    """Return the number of fine steps of tool paths, from lengths and turns of the hand."""
    steps: _Figure = np.maximum(length_mm / _FINE_STEP_MM, angle_deg / _FINE_STEP_DEG)
    return steps


def turns(joints_deg: Matrix) -> Matrix:
    """Return (…, places − 1) the turn of the fastest joint between places of paths (…, places, 6).

    It is in degrees, and 0 where the joints are not known.
    """
    fastest: Matrix = np.nan_to_num(np.abs(np.diff(joints_deg, axis=-2)).max(axis=-1))
    return fastest


def leaps(joints_deg: Matrix, fine_steps: Matrix | float) -> npt.NDArray[np.bool_]:
    """Return whether a joint would turn too far from place to place of a path.

    Args:
        joints_deg: (…, places, 6) along paths.
        fine_steps: The number of fine steps between two places of each path.

    Returns:
        (…, places − 1), true where a joint would turn too far.
    """
    most = _STEEPEST_DEG * np.asarray(fine_steps) + JITTER_DEG
    return np.asarray(turns(joints_deg) > most[..., None])
