"""The points of a trajectory as arrays, and where the joints are at each of them.

Stop 0 is where the arm stands before it runs; stop i is the point in row i − 1.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.limits import ANGLE_STEP_DEG
from armui.arm.models import ArmModel
from armui.kinematics.forward import flange_transforms
from armui.kinematics.inverse import FREE_DEG, nearest_first, same_way, solutions
from armui.kinematics.poses import Joints, pose_to_matrix
from armui.protocol.codes import MoveMode
from armui.trajectory.points.program import Waypoint

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

TOOL_MOVES: Final = frozenset({MoveMode.MOVE_L, MoveMode.MOVE_C})
"""Motions that lead the tool along a path."""
_UNSURE_DEG: Final = 0.5
"""A run begins within as much of where the arm stood at the check."""
_OTHER_WAY_DEG: Final = 5.0
"""Ways that are less different lead the arm through about the same places."""


@dataclass(frozen=True, slots=True)
class Stops:
    """What is known of the stops before the way between them is.

    Attributes:
        joints_deg: (n, 6) targets of MOVE J, and of the start; NaN for poses.
        goals: (n, 4, 4) transforms of the flange.
        solutions_deg: (n, 8, 6) ways to hold the flange, see `armui.kinematics.inverse`.
        within: (n, 8) whether each is within the joints' limits.
        stretched: (n,) whether the wrist may leave a joint free there.
    """

    joints_deg: Array
    goals: Array
    solutions_deg: Array
    within: npt.NDArray[np.bool_]
    stretched: npt.NDArray[np.bool_]


def stops(points: Sequence[Waypoint], arm: ArmModel, start_deg: Sequence[float]) -> Stops:
    """Return the stops of a trajectory that begins where the joints are at `start_deg`."""
    targets = np.array([start_deg, *(point.target for point in points)], dtype=float)
    targets[1:] = as_told(targets[1:])
    posed = np.array([False, *(not point.is_joint for point in points)])
    joints_deg = np.where(posed[:, None], math.nan, targets)
    goals = np.empty((len(targets), 4, 4))
    goals[~posed] = flange_transforms(arm.kinematics.geometry, targets[~posed])
    goals[posed] = pose_to_matrix(targets[posed])
    ways, bends = solutions(arm.kinematics.geometry, goals)
    low, high = bounds(arm)
    within = np.asarray(((ways >= low) & (ways <= high)).all(axis=2))
    return Stops(joints_deg, goals, ways, within, bends < FREE_DEG)


def as_told(values: Array | Sequence[float]) -> Array:
    """Return a target as the arm is told it: in whole steps of 0.001 mm or degrees."""
    told: Array = np.round(np.array(values, dtype=float) / ANGLE_STEP_DEG) * ANGLE_STEP_DEG
    return told


def bounds(arm: ArmModel) -> tuple[Array, Array]:
    """Return the lowest and highest angles of the joints, with the bus's rounding."""
    half_step = ANGLE_STEP_DEG / 2
    low = np.array([limits.min_deg - half_step for limits in arm.limits])
    high = np.array([limits.max_deg + half_step for limits in arm.limits])
    return low, high


@dataclass(frozen=True, slots=True)
class Route:
    """Where the joints go from stop to stop.

    Attributes:
        origins: (n,) the stop each motion begins at; −1 for stops that are left out.
        ends_deg: (n, 6) the joints at each stop; NaN where it is not known.
        unreachable: Poses no way leads to.
        unsure: Poses of MOVE P that two ways lead to, about equally near: the joint that turns
            most differently, and how far in either.
    """

    origins: Whole
    ends_deg: Array
    unreachable: list[int]
    unsure: dict[int, tuple[int, float, float]]


def choose(
    points: Sequence[Waypoint],
    table: Stops,
    arm: ArmModel,
    skipped: Mapping[int, object],
    followed: Mapping[int, tuple[Joints, Joints]],
) -> Route:
    """Return where the joints go, as the arm chooses among the ways to its poses.

    MOVE P goes to the nearest way within the limits; lines and arcs stay on the way where they
    begin, and where they really end is told by following them.

    Args:
        points: The trajectory.
        table: Its stops.
        arm: The arm.
        skipped: Stops that cannot be reached: the arm stays where it is.
        followed: By stop, the joints a tool move was followed from, and to.
    """
    count = len(points) + 1
    route = Route(np.full(count, -1), np.full((count, 6), math.nan), [], {})
    joints: Joints = tuple(table.joints_deg[0].tolist())
    route.ends_deg[0] = joints
    here = 0
    for stop, point in enumerate(points, start=1):
        if stop in skipped:
            continue
        end: Joints | None
        if point.is_joint:
            end = tuple(table.joints_deg[stop].tolist())
        elif point.move in TOOL_MOVES:
            before = followed.get(stop)
            if before is not None and before[0] == joints:
                end = before[1]
            else:
                end = same_way(
                    arm.kinematics.geometry,
                    table.solutions_deg[here],
                    joints,
                    table.solutions_deg[stop],
                )
        else:
            end, other = _nearest(table, stop, joints, arm)
            if end is not None and other is not None:
                joint = int(np.argmax(np.abs(np.array(end) - other)))
                route.unsure[stop] = (joint + 1, end[joint], other[joint])
        route.origins[stop] = here
        if end is None:
            if np.isnan(table.solutions_deg[stop]).all():
                route.unreachable.append(stop)
            continue
        route.ends_deg[stop] = joints = end
        here = stop
    return route


def _nearest(
    table: Stops, stop: int, joints: Joints, arm: ArmModel
) -> tuple[Joints | None, Joints | None]:
    """Return the nearest way to a pose, of those within the limits if there is one.

    And another one that is about as near: joints that stand a little elsewhere might take it.
    """
    if table.stretched[stop]:
        return _nearest_stretched(table.goals[stop], joints, arm), None
    ways = table.solutions_deg[stop]
    off: Array = ways - np.array(joints)
    gaps = np.einsum("ij,ij->i", off, off)
    gaps[np.isnan(gaps)] = math.inf
    inside = np.where(table.within[stop], gaps, math.inf)
    chosen = inside if np.isfinite(inside).any() else gaps
    best = int(np.argmin(chosen))
    if not math.isfinite(gaps[best]):
        return None, None
    near = np.sqrt(chosen) < math.sqrt(chosen[best]) + _UNSURE_DEG
    if near.sum() > 1:
        for other in np.flatnonzero(near).tolist():
            if np.abs(ways[other] - ways[best]).max() > _OTHER_WAY_DEG:
                return tuple(ways[best].tolist()), tuple(ways[other].tolist())
    return tuple(ways[best].tolist()), None


def _nearest_stretched(goal: Array, joints: Joints, arm: ArmModel) -> Joints | None:
    """The same with a wrist that leaves a joint free: it stays where it is."""
    low, high = bounds(arm)
    ways = nearest_first(arm.kinematics.geometry, goal, joints)
    inside = [way for way in ways if (low <= way).all() and (way <= high).all()]
    best = inside or ways
    return best[0] if best else None
