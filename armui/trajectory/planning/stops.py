"""The points of a trajectory as arrays, and the joint angles at each of them.

Stop 0 is where the arm stands before the run; stop i is the point in row i − 1.
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
"""A run may begin this far from where the arm stood at the check."""
_OTHER_WAY_DEG: Final = 5.0
"""Solutions that differ by less lead the arm through nearly the same places."""


@dataclass(frozen=True, slots=True)
class Stops:
    """The stops before the route between them is known.

    Attributes:
        joints_deg: (n, 6) targets of MOVE J, and of the start; NaN for poses.
        goals: (n, 4, 4) transforms of the flange.
        solutions_deg: (n, 8, 6) solutions for the flange's pose, see `armui.kinematics.inverse`.
        within: (n, 8) true for solutions within the joints' limits.
        stretched: (n,) true if a singular wrist may leave a joint free there.
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
    """Return a target as it is sent to the arm: in whole steps of 0.001 mm or degrees."""
    told: Array = np.round(np.array(values, dtype=float) / ANGLE_STEP_DEG) * ANGLE_STEP_DEG
    return told


def bounds(arm: ArmModel) -> tuple[Array, Array]:
    """Return the lowest and highest joint angles, widened by the bus's rounding."""
    half_step = ANGLE_STEP_DEG / 2
    low = np.array([limits.min_deg - half_step for limits in arm.limits])
    high = np.array([limits.max_deg + half_step for limits in arm.limits])
    return low, high


@dataclass(frozen=True, slots=True)
class Route:
    """The route of the joints from stop to stop.

    Attributes:
        origins: (n,) the stop each motion begins at; −1 for stops that are left out.
        ends_deg: (n, 6) the joints at each stop; NaN if not known.
        unreachable: Poses without a solution.
        unsure: Poses of MOVE P with two solutions about equally near: the joint that differs most,
            and its turn in either.
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
    """Return the route of the joints, with the solutions that the arm itself would choose.

    MOVE P goes to the nearest solution within the limits; lines and arcs stay in the solution
    branch in which they begin, and their real end is found by following them.

    Args:
        points: The trajectory.
        table: Its stops.
        arm: The arm.
        skipped: Stops that cannot be reached: the arm does not move for them.
        followed: By stop, the joints at begin and end of a tool move that was followed.
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

    Return also another way about as near, which slightly different joint angles could lead to.
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
    """Return the nearest way with a singular wrist: the joint left free keeps its angle."""
    low, high = bounds(arm)
    ways = nearest_first(arm.kinematics.geometry, goal, joints)
    inside = [way for way in ways if (low <= way).all() and (way <= high).all()]
    best = inside or ways
    return best[0] if best else None
