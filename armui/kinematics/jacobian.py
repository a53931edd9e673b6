"""How the flange moves with each joint."""

from __future__ import annotations

import numpy as np

from armui.kinematics.forward import SIDE, plane_vectors, stacked
from armui.kinematics.geometry import Geometry
from armui.kinematics.poses import Matrix


def jacobians(geometry: Geometry, joints_deg: Matrix) -> Matrix:
    """The Jacobian of the flange at (…, 6) joint angles.

    Returns:
        (…, 6, 6): rows are its velocity in m/rad, then its angular velocity in rad/rad.
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
