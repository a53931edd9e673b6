"""Which way a trajectory takes: over all points the arm can reach, and why not over the others."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from armui.arm.model import ArmModel
from armui.kinematics.inverse import missing_mm
from armui.kinematics.poses import Joints, Matrix, pose_to_matrix
from armui.kinematics.tool_path import Arc, ArcError
from armui.trajectory.planning.findings import Finding, FindingCode
from armui.trajectory.planning.stops import TOOL_MOVES, Route, Stops, choose, stops
from armui.trajectory.planning.tool_moves import Paths, PlannedToolMoves, plan_tool_moves
from armui.trajectory.points.program import Waypoint

_ROUNDS: Final = 3
"""So often the way is looked for anew without the points that cannot be reached."""
_NO_WAY: Final = 1e-9
"""Transforms as much alike are one place."""
_SAME_DEG: Final = 1e-6


@dataclass(frozen=True, slots=True)
class Plan:
    """Where the joints go.

    Attributes:
        route: From stop to stop.
        moves: The lines and arcs on it.
        problems: By stop, why it is left out.
    """

    route: Route
    moves: list[PlannedToolMoves]
    problems: dict[int, Finding]


def plan_route(points: Sequence[Waypoint], arm: ArmModel, start_deg: Sequence[float]) -> Plan:
    """Looks for a way over all points; again without those that cannot be reached."""
    table = stops(points, arm, start_deg)
    problems: dict[int, Finding] = {}
    followed: dict[int, tuple[Joints, Joints]] = {}
    moves: list[PlannedToolMoves] = []
    for turn in range(2 * _ROUNDS):
        route = choose(points, table, arm, problems, followed)
        found = {stop: _out_of_reach(table, arm, stop) for stop in route.unreachable}
        paths = _paths(points, table, route, found)
        kept, changed = _kept(moves, paths)
        moves = kept + plan_tool_moves(changed, arm)
        for group in moves:
            found |= _broken(group)
        settled = _compare(route, moves, followed)
        if not found and (settled or turn >= _ROUNDS):
            break
        problems |= found
        if turn >= _ROUNDS - 1:
            problems |= _behind(points, problems)
    return Plan(route, moves, problems)


def _paths(
    points: Sequence[Waypoint], table: Stops, route: Route, found: dict[int, Finding]
) -> Paths:
    """The lines and arcs of a route; an arc through no circle is added to what was found."""
    chosen, arcs = [], []
    for stop, point in enumerate(points, start=1):
        origin = int(route.origins[stop])
        if point.move not in TOOL_MOVES or origin < 0 or stop in found:
            continue
        arc = None
        if point.middle is not None:
            try:
                arc = Arc(table.goals[origin], pose_to_matrix(point.middle), table.goals[stop])
            except ArcError:
                found[stop] = Finding(FindingCode.ARC_NO_CIRCLE, row=stop - 1)
                continue
        elif _same_place(table.goals[origin], table.goals[stop]):
            route.ends_deg[stop] = route.ends_deg[origin]
            continue
        chosen.append(stop)
        arcs.append(arc)
    wanted = np.array(chosen, dtype=np.int64)
    origins = route.origins[wanted]
    return Paths(wanted, table.goals[origins], table.goals[wanted], route.ends_deg[origins], arcs)


def _kept(moves: list[PlannedToolMoves], paths: Paths) -> tuple[list[PlannedToolMoves], Paths]:
    """What was followed before and begins where it did, and the paths that are left to follow."""
    kept = []
    left = np.ones(len(paths.stops), dtype=bool)
    for group in moves:
        places = np.searchsorted(paths.stops, group.stops)
        same = np.flatnonzero(np.isin(group.stops, paths.stops))
        begun = group.joints_deg[same, 0] == paths.starts_deg[places[same]]
        same = same[begun.all(axis=1)]
        left[places[same]] = False
        kept.append(group.only(same))
    return kept, paths.only(np.flatnonzero(left))


def _same_place(start: Matrix, goal: Matrix) -> bool:
    return bool(np.abs(start - goal).max() < _NO_WAY)


def _out_of_reach(table: Stops, arm: ArmModel, stop: int) -> Finding:
    missing = missing_mm(arm.kinematics.geometry, table.goals[stop])
    place = table.goals[stop, :3, 3] + arm.tool_mm * table.goals[stop, :3, 2]
    params = {"missing": round(missing, 1)}
    return Finding(FindingCode.OUT_OF_REACH, params, stop - 1, place_mm=tuple(place.tolist()))


def _broken(group: PlannedToolMoves) -> dict[int, Finding]:
    """What keeps lines and arcs from being followed."""
    found = {}
    steps = group.joints_deg.shape[1] - 1
    for index in np.flatnonzero(group.broken >= 0).tolist():
        stop, place = int(group.stops[index]), int(group.broken[index])
        params: dict[str, float | int | str] = {"gone": round(100.0 * place / steps)}
        before = group.joints_deg[index, place - 1]
        if group.singular[index]:
            leaps = np.abs(group.joints_deg[index, place] - before)
            params["joint"] = int(np.argmax(leaps)) + 1
        code = FindingCode.PATH_SINGULAR if group.singular[index] else FindingCode.PATH_OUT_OF_REACH
        found[stop] = Finding(code, params, stop - 1, tuple(before.tolist()))
    return found


def _compare(
    route: Route, moves: list[PlannedToolMoves], followed: dict[int, tuple[Joints, Joints]]
) -> bool:
    """Whether every line and arc ends where the route goes on; notes where it does."""
    settled = True
    for group in moves:
        ends = group.joints_deg[:, -1]
        expected = route.ends_deg[group.stops]
        off = ~(np.abs(ends - expected) <= _SAME_DEG).all(axis=1)  # NaN is off too
        for index in np.flatnonzero(off & (group.broken < 0)).tolist():
            settled = False
            start = tuple(group.joints_deg[index, 0].tolist())
            followed[int(group.stops[index])] = (start, tuple(ends[index].tolist()))
    return settled


def _behind(points: Sequence[Waypoint], problems: dict[int, Finding]) -> dict[int, Finding]:
    """Lines and arcs that would begin where the arm does not come to."""
    left_out: dict[int, Finding] = {}
    for stop, point in enumerate(points, start=1):
        before = problems.get(stop - 1) or left_out.get(stop - 1)
        if point.move in TOOL_MOVES and before is not None and stop not in problems:
            left_out[stop] = Finding(FindingCode.START_UNKNOWN, {"before": stop - 1}, stop - 1)
    return left_out
