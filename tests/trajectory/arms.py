"""Arms and points for tests of plans."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from armui.arm.held_shape import HeldShape
from armui.arm.models import ArmModel
from armui.arm.state import EndLimits
from armui.arm.tool_capsule import ToolCapsule
from armui.kinematics.arm_kinematics import Kinematics
from armui.kinematics.geometry import Geometry
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ways.own_body import OwnBody
from tests.family import FACTORY_ACCELERATION_DEG_S2, FACTORY_LIMITS, PIPER

KINEMATICS = Kinematics(PIPER)
ARM = ArmModel(
    limits=FACTORY_LIMITS,
    accelerations_deg_s2=(FACTORY_ACCELERATION_DEG_S2,) * 6,
    end_limits=EndLimits(1.0, 1.0, 1.0, 1.0),
    kinematics=KINEMATICS,
    tool_mm=140.0,
    stroke_mm=70.0,
)
"""As it leaves the factory; the limits of the tool are the simulated arm's."""

HERE = (10.0, 70.0, -60.0, 10.0, 25.0, -20.0)


def pose_near(
    joints_deg: Sequence[float], by_mm: Sequence[float] = (0, 0, 0), turned_deg: float = 0.0
) -> tuple[float, ...]:
    """The pose some way off the one at these joints, in the steps of the protocol."""
    x, y, z, rx, ry, rz = KINEMATICS.forward(joints_deg)
    dx, dy, dz = by_mm
    return tuple(round(v, 3) for v in (x + dx, y + dy, z + dz, rx, ry, rz + turned_deg))


def joint(*angles_deg: float, speed: int = 100, dwell_s: float = 0.0) -> Waypoint:
    return Waypoint(MoveMode.MOVE_J, angles_deg, speed_percent=speed, dwell_s=dwell_s)


def pose(target: Sequence[float], speed: int = 100) -> Waypoint:
    return Waypoint(MoveMode.MOVE_P, tuple(target), speed_percent=speed)


def line(target: Sequence[float], speed: int = 100) -> Waypoint:
    return Waypoint(MoveMode.MOVE_L, tuple(target), speed_percent=speed)


def arc(middle: Sequence[float], end: Sequence[float], speed: int = 100) -> Waypoint:
    return Waypoint(MoveMode.MOVE_C, tuple(end), middle=tuple(middle), speed_percent=speed)


def run(*points: Waypoint) -> Trajectory:
    return Trajectory("t", points=points)


def collisions(
    geometry: Geometry,
    joints_deg: npt.ArrayLike,
    tool_mm: float,
    turned_deg: float = 0.0,
    *,
    tool: ToolCapsule | None = None,
    held: HeldShape | None = None,
) -> dict[int, str]:
    """The first two parts that reach into each other, by the pose's index."""
    body = OwnBody(geometry, tool_mm, turned_deg, tool, held)
    touch = body.gaps(joints_deg) < 0.0
    return {
        row: body.pairs[int(touch[row].argmax())]
        for row in np.flatnonzero(touch.any(axis=1)).tolist()
    }
