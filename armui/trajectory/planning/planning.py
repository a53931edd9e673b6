"""Plans the route of a trajectory over the points the arm can reach, with reasons for others."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.models import ArmModel
from armui.kinematics.inverse import missing_mm
from armui.kinematics.poses import Joints, Matrix, pose_to_matrix
from armui.kinematics.tool_path import Arc, ArcError
from armui.trajectory.planning.findings import Finding, FindingKind, Severity
from armui.trajectory.planning.stops import TOOL_MOVES, Route, Stops, as_told, choose, stops
from armui.trajectory.planning.tool_moves import Paths, PlannedToolMoves, plan_tool_moves
from armui.trajectory.points.program import Waypoint

Array = npt.NDArray[np.float64]

_ROUNDS: Final = 3
"""The number of times that the route is planned again without unreachable points."""
_NO_WAY: Final = 1e-9
"""Transforms that differ by less are the same place."""
_SAME_DEG: Final = 1e-6
_SMALLEST_MM: Final = 0.5
"""The least distance between the points of an arc: within it the arm counts as arrived."""
_FLATTEST_MM: Final = 0.02
"""The least height of an arc's three points over a line: twenty steps of the arm's pose feedback.
"""
_MOST_CYCLES: Final = 16
"""The most cycles planned. A pose has eight solutions at most: a difference between later cycles is
drift.
"""
_REPEATS_DEG: Final = 0.005
"""Joints this near to an earlier visit of the same point are in the same configuration: the arm
rounds poses.
"""
_LONGEST_MM: Final = 5000.0
"""A longer arc does not stay within reach."""
_ARC_STEPS: Final = 64
_FEW_ROWS: Final = 16
"""The number of rows of a further cycle that are examined first,"""
_MORE: Final = 4
"""and the factor by which that number grows each time."""

NEVER_REPEATS = FindingKind(
    "never_repeats",
    "Each of the first {cycles} cycles takes another way than those before, so that the next ones "
    "cannot be checked. Give one of the points as joint angles (MOVE J), or run fewer cycles.",
    Severity.ERROR,
)
ARC_NO_CIRCLE = FindingKind(
    "arc_no_circle",
    "The point before, the middle and the end lie on one line or coincide: that is no arc. "
    "Move the middle aside, or use MOVE L.",
    Severity.ERROR,
)
OUT_OF_REACH = FindingKind(
    "out_of_reach",
    "The flange cannot get there: the point is {missing} mm too far. Move it nearer.",
    Severity.ERROR,
)
PATH_SINGULAR = FindingKind(
    "path_singular",
    "After {gone} % of the way joint {joint} would have to leap: the arm is in a singular pose "
    "there. Put another point between, or use MOVE J.",
    Severity.ERROR,
)
PATH_OUT_OF_REACH = FindingKind(
    "path_out_of_reach",
    "After {gone} % of the way the tool would be out of reach. Put another point between, or use "
    "MOVE J.",
    Severity.ERROR,
)
START_UNKNOWN = FindingKind(
    "start_unknown",
    "This would begin where row {before} ends, and the arm does not come there. Change row "
    "{before} first.",
    Severity.ERROR,
)


@dataclass(frozen=True, slots=True)
class Plan:
    """The planned route of the joints.

    Attributes:
        route: The route from stop to stop.
        moves: The lines and arcs on it.
        problems: The reason for each stop that is left out.
        known: The number of stops for which it is right: behind them a line or an arc ends
            elsewhere than the route continues.
    """

    route: Route
    moves: list[PlannedToolMoves]
    problems: dict[int, Finding]
    known: int

    def ends_deg(self) -> Array:
        """Return the joints at each stop but the first, (stops, 6), NaN for those left out."""
        ends = self.route.ends_deg.copy()
        for group in self.moves:
            wanted = group.broken < 0
            ends[group.stops[wanted]] = group.joints_deg[wanted, -1]
        ends[list(self.problems)] = math.nan
        return ends[1:]

    def up_to(self, stop: int) -> Plan:
        """Return the part of the plan that leads to a stop."""
        unsure = {each: ways for each, ways in self.route.unsure.items() if each <= stop}
        origins, ends_deg = self.route.origins[: stop + 1], self.route.ends_deg[: stop + 1]
        route = Route(origins, ends_deg, [], unsure)
        moves = [group.only(group.stops <= stop) for group in self.moves]
        problems = {each: found for each, found in self.problems.items() if each <= stop}
        return Plan(route, [each for each in moves if len(each.stops)], problems, stop)


@dataclass(frozen=True, slots=True)
class Leg:
    """One cycle's part of a run.

    Attributes:
        cycle: The cycle, from 1.
        first: The row of its first stop.
        plan: The plan of this part; it begins where the one before ends.
    """

    cycle: int
    first: int
    plan: Plan


def plan_run(
    points: Sequence[Waypoint], arm: ArmModel, start_deg: Sequence[float], first: int, cycles: int
) -> tuple[list[Leg], Finding | None]:
    """Plan a run as it is driven: every cycle begins where the one before has ended.

    Planning ends when the joints reach a point as in an earlier cycle, because the rest repeats. A
    cycle that cannot be driven to its end is the last.

    Args:
        points: The trajectory.
        arm: The arm.
        start_deg: The joint angles before the run.
        first: The row to begin with.
        cycles: The number of cycles; 0 without end.

    Returns:
        The parts of the run, and a finding if it does not repeat.
    """
    legs: list[Leg] = []
    most = min(cycles, _MOST_CYCLES) if cycles else _MOST_CYCLES
    visited = np.full((most, len(points), 6), math.nan) if most > 1 else None
    joints: Sequence[float] = tuple(start_deg)
    failed = False
    for cycle in range(1, most + 1):
        row = first if cycle == 1 else 0
        size = len(points) if cycle == 1 else _FEW_ROWS
        while row < len(points):
            plan = plan_route(points[row : row + size], arm, joints)
            ends = plan.ends_deg()[: plan.known]
            count, repeats = plan.known, False
            if visited is not None and cycle > 1:
                before = visited[: cycle - 1, row : row + count]
                same = (np.abs(before - ends) <= _REPEATS_DEG).all(axis=2).any(axis=0)
                repeats = bool(same.any())
                count = int(np.argmax(same)) + 1 if repeats else count
            legs.append(Leg(cycle, row, plan.up_to(count)))
            failed |= bool(legs[-1].plan.problems)
            if repeats or (failed and cycle > 1):
                return legs, None
            if visited is not None:
                visited[cycle - 1, row : row + count] = ends[:count]
            come_to = ends[:count][~np.isnan(ends[:count, 0])]
            joints = tuple(come_to[-1].tolist()) if len(come_to) else joints
            row += count
            size = max(_FEW_ROWS, _MORE * count)
        if failed or not points:
            return legs, None
    unknown = cycles == 0 or cycles > most
    return legs, NEVER_REPEATS(cycles=most) if unknown else None


def plan_route(points: Sequence[Waypoint], arm: ArmModel, start_deg: Sequence[float]) -> Plan:
    """Plan a route over all points, and again without those that cannot be reached."""
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
        off = _compare(route, moves, followed)
        if not found and (off is None or turn >= _ROUNDS):
            break
        problems |= found
        if turn >= _ROUNDS - 1:
            problems |= _behind(points, problems)
    return Plan(route, moves, problems, len(points) if off is None else off)


def single_pace(
    way: Sequence[Sequence[float]], start_deg: Sequence[float], arm: ArmModel
) -> tuple[float, float, float] | None:
    """Return the flange's highest speeds along one line or arc at 100 %, and the braking time.

    The speeds are in mm/s and °/s, the time to brake from them in seconds.

    Args:
        way: The pose at the end of a line, or the poses at start, middle and end of an arc.
        start_deg: The present joint angles.
        arm: The arm.

    Returns:
        The three figures, or ``None`` if the arm cannot follow the path, or it has no length.
    """
    start = arm.kinematics.matrix(start_deg)
    poses = [pose_to_matrix(pose) for pose in way]
    try:
        arc = Arc(start, *poses[1:]) if len(poses) > 1 else None
    except ArcError:
        return None
    if arc is None and _same_place(start, poses[-1]):
        return None
    if arc is not None and arc.length_mm > _LONGEST_MM:
        return None
    starts_deg = np.array([start_deg], dtype=float)
    paths = Paths(np.array([1]), start[None], poses[-1][None], starts_deg, [arc])
    (move,) = plan_tool_moves(paths, arm, roughly=True)
    if move.broken[0] >= 0:
        return None
    speed = float(move.speeds[0])
    turn_deg = float(move.angles_deg[0])
    if arc is not None:  # on an arc the hand does not turn evenly: its fastest step counts
        turns = arc.poses(np.linspace(0.0, 1.0, _ARC_STEPS + 1))[:, :3, :3]
        between = np.einsum("nji,njk->nik", turns[:-1], turns[1:])
        cosines = (np.trace(between, axis1=1, axis2=2) - 1.0) / 2.0
        turn_deg = _ARC_STEPS * float(np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0))).max())
    ramp_s = speed / float(move.accelerations[0])
    return speed * float(move.lengths_mm[0]), speed * turn_deg, ramp_s


def _paths(
    points: Sequence[Waypoint], table: Stops, route: Route, found: dict[int, Finding]
) -> Paths:
    """Return the lines and arcs of a route; an arc through no circle is added to what was found."""
    chosen, arcs = [], []
    for stop, point in enumerate(points, start=1):
        origin = int(route.origins[stop])
        if point.move not in TOOL_MOVES or origin < 0 or stop in found:
            continue
        arc = None
        if point.middle is not None:
            try:
                middle = pose_to_matrix(as_told(point.middle))
                arc = _arc(table.goals[origin], middle, table.goals[stop])
            except ArcError:
                found[stop] = replace(ARC_NO_CIRCLE(), row=stop - 1)
                continue
        elif _same_place(table.goals[origin], table.goals[stop]):
            route.ends_deg[stop] = route.ends_deg[origin]
            continue
        chosen.append(stop)
        arcs.append(arc)
    wanted = np.array(chosen, dtype=np.int64)
    origins = route.origins[wanted]
    return Paths(wanted, table.goals[origins], table.goals[wanted], route.ends_deg[origins], arcs)


def _arc(start: Matrix, middle: Matrix, end: Matrix) -> Arc:
    """Return an arc through three poses, if rounding them cannot change it much.

    The arc begins at the pose the arm measures. With two points almost in one place, rounding alone
    would decide in which direction the arc runs.

    Raises:
        ArcError: There is no such arc.
    """
    ways = (middle - start)[:3, 3], (end - middle)[:3, 3], (start - end)[:3, 3]
    lengths = [float(np.linalg.norm(way)) for way in ways]
    height = float(np.linalg.norm(np.cross(ways[0], ways[1]))) / max(*lengths, _SMALLEST_MM)
    if min(lengths) < _SMALLEST_MM or height < _FLATTEST_MM:
        raise ArcError("points too near to each other, or to a line, to tell where the arc goes")
    return Arc(start, middle, end)


def _kept(moves: list[PlannedToolMoves], paths: Paths) -> tuple[list[PlannedToolMoves], Paths]:
    """Return the planned moves whose start is unchanged, and the paths still to be followed."""
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
    place = table.goals[stop, :3, 3] + table.goals[stop, :3, :3] @ np.array(arm.tip_mm)
    found = OUT_OF_REACH(missing=round(missing, 1))
    return replace(found, row=stop - 1, place_mm=tuple(place.tolist()))


def _broken(group: PlannedToolMoves) -> dict[int, Finding]:
    """Return the reasons why lines and arcs cannot be followed, by stop."""
    found = {}
    steps = group.joints_deg.shape[1] - 1
    for index in np.flatnonzero(group.broken >= 0).tolist():
        stop, place = int(group.stops[index]), int(group.broken[index])
        gone = round(100.0 * place / steps)
        before = group.joints_deg[index, place - 1]
        if group.singular[index]:
            leaps = np.abs(group.joints_deg[index, place] - before)
            problem = PATH_SINGULAR(gone=gone, joint=int(np.argmax(leaps)) + 1)
        else:
            problem = PATH_OUT_OF_REACH(gone=gone)
        found[stop] = replace(problem, row=stop - 1, joints_deg=tuple(before.tolist()))
    return found


def _compare(
    route: Route, moves: list[PlannedToolMoves], followed: dict[int, tuple[Joints, Joints]]
) -> int | None:
    """Return the first line or arc that ends elsewhere than the route continues; note its real end.

    Returns ``None`` if all of them end where the route continues.
    """
    first: int | None = None
    for group in moves:
        ends = group.joints_deg[:, -1]
        expected = route.ends_deg[group.stops]
        off = ~(np.abs(ends - expected) <= _SAME_DEG).all(axis=1)  # true for NaN, too
        for index in np.flatnonzero(off & (group.broken < 0)).tolist():
            stop = int(group.stops[index])
            first = stop if first is None else min(first, stop)
            start = tuple(group.joints_deg[index, 0].tolist())
            followed[stop] = (start, tuple(ends[index].tolist()))
    return first


def _behind(points: Sequence[Waypoint], problems: dict[int, Finding]) -> dict[int, Finding]:
    """Return findings for lines and arcs that begin at a stop which the arm cannot reach."""
    left_out: dict[int, Finding] = {}
    for stop, point in enumerate(points, start=1):
        before = problems.get(stop - 1) or left_out.get(stop - 1)
        if point.move in TOOL_MOVES and before is not None and stop not in problems:
            left_out[stop] = replace(START_UNKNOWN(before=stop - 1), row=stop - 1)
    return left_out
