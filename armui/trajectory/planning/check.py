"""Checks a trajectory before it is run, by planning the whole path and examining it.

This room has neither windows nor a bus, so that a check can run in a process of its own: 10,000
points take from half a second to many seconds, depending on their distances.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.held_shape import HeldShape
from armui.arm.limits import JOINTS
from armui.arm.models import STANDING, ArmModel
from armui.cell.area_check import AreaCheck
from armui.kinematics.forward import flange_heights, flange_transforms
from armui.kinematics.singularity import NEAR_SINGULAR as SINGULAR_BELOW
from armui.kinematics.singularity import margins, smallest_singular_values
from armui.protocol.codes import MoveMode
from armui.trajectory.files import Content
from armui.trajectory.planning.findings import (
    FAR_FROM_START,
    Approach,
    Finding,
    FindingKind,
    Severity,
)
from armui.trajectory.planning.planned_path import PlannedPath
from armui.trajectory.planning.planning import NEVER_REPEATS, PATH_OUT_OF_REACH, PATH_SINGULAR
from armui.trajectory.planning.stops import TOOL_MOVES, bounds
from armui.trajectory.planning.timing import plan_path
from armui.trajectory.planning.user_frames import in_base
from armui.trajectory.points.program import GripperOpening, Trajectory, Waypoint
from armui.trajectory.samples.recording import (
    Recording,
    ReplayProfile,
    replay_profile,
    turning_speeds,
)
from armui.ways.own_body import collisions

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]

FAR_FROM_START_DEG: Final = 30.0
"""A first point further than this from the present joint angles is reported."""
LARGE_TURN_DEG: Final = 90.0
"""A joint that turns further than this to a pose is reported: the arm may reach it in another
configuration than meant.
"""
FLOOR_MM: Final = 0.0
"""The height of the plane on which the arm stands."""
_ROUNDED_DEG: Final = 0.01
"""The error of a joint angle that may come from rounding a pose to the steps of the bus."""
_SPEED_SLACK: Final = 1.02
JUMP_DEG: Final = 5.0
"""A joint that turns this far between two samples shows that they were not recorded in one go."""
_STROKE_SLACK_MM: Final = 1.0
"""A gripper at its stop may measure this much more than its stroke."""
_COLLISION_STEP_DEG: Final = 2.0

FRAME_UNKNOWN = FindingKind(
    "frame_unknown",
    "The point is in the user frame “{name}”, which the cell does not have: its place is unknown. "
    "Choose the cell that has it, or make a frame of this name under Cell.",
    Severity.ERROR,
)
HELD_UNKNOWN = FindingKind(
    "held_unknown",
    "From here on the hand holds “{name}”, which the cell does not have: its size is unknown. "
    "Choose the cell that has it, or add it under Cell, Held.",
    Severity.ERROR,
)
EMPTY = FindingKind("empty", "There is nothing to run. Add points, or record.", Severity.ERROR)
TARGET_BEYOND_LIMIT = FindingKind(
    "target_beyond_limit",
    "Joint {joint} would be at {value}°, beyond its limits {minimum}° to {maximum}°. Change the "
    "point.",
    Severity.ERROR,
)
PATH_BEYOND_LIMIT = FindingKind(
    "path_beyond_limit",
    "On the way joint {joint} would come to {value}°, beyond its limits {minimum}° to {maximum}°. "
    "Put another point between, or use MOVE J.",
    Severity.ERROR,
)
ARC_AT_LIMIT = FindingKind(
    "arc_at_limit",
    "The arc begins with joint {joint} at its limit ({value}°): the arm may not find its way "
    "there again. End the point before a little further in, or use MOVE L.",
    Severity.ERROR,
)
LINKS_COLLIDE = FindingKind(
    "links_collide",
    "The arm would hit itself: {other} against {one}. Put another point between, or change the "
    "point.",
    Severity.ERROR,
)
JOINT_TOO_FAST = FindingKind(
    "joint_too_fast",
    "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. Replay at "
    "{percent} % of this speed at most.",
    Severity.ERROR,
)
GRIPPER_BEYOND_STROKE = FindingKind(
    "gripper_beyond_stroke",
    "The gripper would have to open {value} mm; it opens {maximum} mm at most. Enter less.",
    Severity.ERROR,
)
NEAR_SINGULAR = FindingKind(
    "near_singular",
    "The way passes near a singular pose ({value}, should be {minimum} or more): joints turn fast "
    "there and the tool is slow. Use MOVE J, or turn the wrist.",
    Severity.WARNING,
)
LARGE_TURN = FindingKind(
    "large_turn",
    "Joint {joint} turns {value}° to hold this pose. If that is not meant, give the point as "
    "joint angles.",
    Severity.WARNING,
)
SAMPLE_JUMP = FindingKind(
    "sample_jump",
    "Joint {joint} jumps {value}° from the sample before. Trim the recording there, or record "
    "again.",
    Severity.WARNING,
)
TOOL_TOO_FAST = FindingKind(
    "tool_too_fast",
    "The tool would go at {value} mm/s; its limit is {maximum} mm/s, and the arm does not keep it "
    "here by itself. Lower the speed.",
    Severity.WARNING,
)
AREA_TOO_NEAR = FindingKind(
    "area_too_near",
    "Too near to “{name}” of the work area: {part} would come to {value} mm, where {minimum} mm "
    "are kept. Put another point between, or change the point.",
    Severity.ERROR,
)
OTHER_ARM = FindingKind(
    "other_arm",
    "This was taught on another arm: {taught}; connected is {arm}. The same joint angles may hold "
    "the tool elsewhere. It was checked for {arm}, and nothing was converted. Watch the preview "
    "before you accept this.",
    Severity.WARNING,
)
BELOW_FLOOR = FindingKind(
    "below_floor",
    "The tool or what is held would be {value} mm below the floor. Accept this only if there is "
    "nothing.",
    Severity.WARNING,
)

_OF_A_WAY: Final = (PATH_BEYOND_LIMIT, PATH_OUT_OF_REACH, PATH_SINGULAR)
"""Findings that depend on where the arm comes from, and not on a point alone."""


@dataclass(frozen=True, slots=True)
class Carried:
    """What the hand holds, as a check sees it.

    Attributes:
        held: Its shape; ``None`` for nothing.
        area: The work area of the arm with it; ``None`` if it may go anywhere.
    """

    held: HeldShape | None = None
    area: AreaCheck | None = None


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """The input of a check.

    Attributes:
        content: The trajectory or recording to be run.
        arm: The arm that will run it.
        start_deg: The joint angles at the start.
        speed_factor: The factor on each point's speed, or on the recorded speed.
        first: The index of the point to begin with, in the first cycle.
        cycles: The number of cycles; 0 runs until it is ended.
        area: The work area of this arm with what it carries; ``None`` if it may go anywhere.
        carried: What its points have the hand hold, as far as the cell knows it, by name.
    """

    content: Content
    arm: ArmModel
    start_deg: Sequence[float]
    speed_factor: float = 1.0
    first: int = 0
    cycles: int = 1
    area: AreaCheck | None = None
    carried: Mapping[str, Carried] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class CheckOutcome:
    """The result of a check.

    Attributes:
        path: The path of the arm.
        expected_s: The duration of each point at the speed of the run; empty for a recording.
        findings: The findings, errors first, then by row.
        profile: The replay profile of a recording; ``None`` for points.
        in_base: The trajectory with all its points in the base, as it was checked; ``None`` if it
            is that of the request.
    """

    path: PlannedPath
    expected_s: tuple[float, ...]
    findings: tuple[Finding, ...]
    profile: ReplayProfile | None = None
    in_base: Trajectory | None = None

    @property
    def errors(self) -> tuple[Finding, ...]:
        """The findings that forbid a run."""
        return tuple(each for each in self.findings if each.severity is Severity.ERROR)


def warm_up() -> None:
    """Load this module and its libraries in the calling process."""


def check(request: CheckRequest) -> CheckOutcome:
    """Plan a trajectory or recording, and report what this arm cannot do or should not do."""
    content, arm, start_deg = request.content, request.arm, request.start_deg
    based = None
    if isinstance(content, Trajectory):
        unknown = tuple(_unknown(content, request))
        if unknown:
            nothing = plan_path(replace(content, points=()), arm, start_deg)
            return CheckOutcome(nothing, (), unknown)
        points = in_base(content.points, dict(arm.frames))
        if points is not content.points:
            content = based = replace(content, points=points)
    path = plan_path(
        *(content, arm, start_deg),
        first=request.first,
        cycles=request.cycles,
        speed_factor=request.speed_factor,
    )
    found = _findings(content, path, request)
    profile = replay_profile(content) if isinstance(content, Recording) else None
    by_place = {(one.kind, one.row, one.approach): one for one in reversed(found)}
    findings = tuple(sorted(by_place.values(), key=_rank))
    return CheckOutcome(path, path.expected_s, findings, profile, based)


def _unknown(content: Trajectory, request: CheckRequest) -> Iterator[Finding]:
    """What points name and the cell has not."""
    frames = dict(request.arm.frames)
    for row, point in enumerate(content.points):
        if point.frame and point.frame not in frames:
            yield replace(FRAME_UNKNOWN(name=point.frame), row=row)
        if point.holds is not None and point.holds not in request.carried:
            yield replace(HELD_UNKNOWN(name=point.holds), row=row)


def _rank(finding: Finding) -> tuple[bool, int]:
    """Errors come first, and what concerns the whole before its rows."""
    return finding.severity is not Severity.ERROR, -1 if finding.row is None else finding.row


def _findings(content: Content, path: PlannedPath, request: CheckRequest) -> list[Finding]:
    """Return what speaks against a path, by row; what concerns the whole comes first."""
    arm = request.arm
    findings = list(path.problems)
    if content.taught_on and arm.kind and content.taught_on != arm.kind:
        findings.append(OTHER_ARM(taught=content.taught_on, arm=arm.kind))
    if isinstance(content, Recording):
        findings += _recorded(content, path, arm)
        slow = np.zeros(len(path.rows), dtype=bool)
    elif not len(path.times_s):
        findings += _empty(content.points)
        slow = np.empty(0, dtype=bool)
    else:
        slow = _by_row(path, [point.move in TOOL_MOVES for point in content.points])
        findings += _limits(path, slow, arm)
        findings += _arcs_at_limits(path, [point.move for point in content.points], arm)
        findings += _near_singular(path, slow, arm)
        posed = [not point.is_joint and point.move not in TOOL_MOVES for point in content.points]
        findings += _large_turns(path, _by_row(path, posed))
    if isinstance(content, Trajectory):
        findings += _grippers(content.points, arm)
    if len(path.times_s):
        findings += _far_from_start(path)
        findings += _tool_too_fast(path, ~slow, arm)
        for carried, there in _stretches(content, path, request):
            carrying = replace(arm, held=carried.held)
            findings += _below_floor(path, carrying, there)
            findings += _collisions(path, carrying, there)
            findings += _too_near(path, carried.area, there)
        findings = _tell_approach(findings, path)
    if any(each.cycle > 1 and each.severity is Severity.ERROR for each in findings):
        # what ends a later cycle says why they do not repeat
        findings = [each for each in findings if each.kind != NEVER_REPEATS]
    findings.sort(key=lambda each: (-1 if each.row is None else each.row, each.severity.value))
    return findings


def _stretches(
    content: Content, path: PlannedPath, request: CheckRequest
) -> Iterator[tuple[Carried, Flags]]:
    """Yield what the hand holds, and (samples,) where on the path; where it changes, both."""
    holds = [point.holds for point in content.points] if isinstance(content, Trajectory) else []
    now = Carried(request.arm.held, request.area)
    if all(name is None for name in holds):
        yield now, np.ones(len(path.rows), dtype=bool)
        return
    begins = np.flatnonzero(path.begins).tolist()
    ways = list(zip(begins, [*begins[1:], len(path.rows)], strict=True))
    if request.cycles != 1:  # further cycles begin with what the last one ends with
        ways += [way for way in ways if path.cycles[way[0]] == path.cycles[-1]]
    found: dict[str | None, Flags] = {}
    name: str | None = None
    for begin, end in ways:
        found.setdefault(name, np.zeros(len(path.rows), dtype=bool))[begin:end] = True
        told = holds[path.rows[begin]]
        if told is not None:
            name = told
            found.setdefault(name, np.zeros(len(path.rows), dtype=bool))[end - 1] = True
    for name, there in found.items():
        yield now if name is None else request.carried[name], there


def _tell_approach(findings: Sequence[Finding], path: PlannedPath) -> list[Finding]:
    """Mark what is about the way from where the arm is to the first point of a trajectory."""
    first = int(path.rows[0]) if len(path.rows) else 0
    return [
        replace(one, approach=Approach.WAY)
        if (one.row, one.cycle) == (first, 1) and one.kind in _OF_A_WAY and one.approach is None
        else one
        for one in findings
    ]


def _empty(points: Sequence[Waypoint]) -> Iterator[Finding]:
    if not points:
        yield EMPTY()


def _grippers(points: Sequence[Waypoint], arm: ArmModel) -> Iterator[Finding]:
    widest_mm = arm.stroke_mm if arm.widest_mm is None else arm.widest_mm
    if widest_mm is None:
        return
    for row, point in enumerate(points):
        action = point.gripper
        if isinstance(action, GripperOpening) and action.opening_mm > widest_mm:
            most, wanted = float(widest_mm), float(action.opening_mm)
            yield replace(GRIPPER_BEYOND_STROKE(value=wanted, maximum=most), row=row)


def _limits(path: PlannedPath, led: Flags, arm: ArmModel) -> Iterator[Finding]:
    """Of a motion of the joints its end counts, of a line or an arc every place.

    Joints that begin beyond a limit may come back.
    """
    low, high = bounds(arm)
    over = np.maximum(low - path.joints_deg, path.joints_deg - high)
    last = np.append(path.begins[1:], True)
    beyond = (over > 0.0).any(axis=1) & (led | last)
    for index in _worst(beyond, over.max(axis=1, initial=-np.inf), path):
        joint = int(np.argmax(over[index]))
        limits = arm.limits[joint]
        found = (TARGET_BEYOND_LIMIT if last[index] else PATH_BEYOND_LIMIT)(
            joint=JOINTS[joint],
            value=float(path.joints_deg[index, joint]),
            minimum=limits.min_deg,
            maximum=limits.max_deg,
        )
        yield _at(path, index, found)


def _arcs_at_limits(
    path: PlannedPath, moves: Sequence[MoveMode], arm: ArmModel
) -> Iterator[Finding]:
    """The arm is told where an arc begins by a rounded pose, and goes there within its limits."""
    arcs = _by_row(path, [move is MoveMode.MOVE_C for move in moves])
    low, high = bounds(arm)
    for index in np.flatnonzero(path.begins & arcs).tolist():
        joints = path.joints_deg[index]
        at = (joints < low + _ROUNDED_DEG) | (joints > high - _ROUNDED_DEG)
        if at.any():
            joint = int(np.argmax(at))
            value = round(float(joints[joint]), 3)
            yield _at(path, index, ARC_AT_LIMIT(joint=JOINTS[joint], value=value))


def _near_singular(path: PlannedPath, led: Flags, arm: ArmModel) -> Iterator[Finding]:
    places = np.flatnonzero(led)
    nearness = np.zeros(len(path.rows))
    geometry = arm.kinematics.geometry
    nearness[places] = -margins(geometry, path.joints_deg[places])
    nearest = np.array(list(_worst(led, nearness, path)), dtype=np.int64)
    if not len(nearest):
        return
    smallest = smallest_singular_values(geometry, path.joints_deg[nearest])
    for index, value in zip(nearest.tolist(), smallest.tolist(), strict=True):
        if value < SINGULAR_BELOW:
            yield _at(path, index, NEAR_SINGULAR(value=value, minimum=SINGULAR_BELOW))


def _large_turns(path: PlannedPath, posed: Flags) -> Iterator[Finding]:
    firsts = np.flatnonzero(path.begins)
    lasts = np.append(firsts[1:], len(path.rows)) - 1
    turns = np.abs(path.joints_deg[lasts] - path.joints_deg[firsts])
    for which in np.flatnonzero((turns > LARGE_TURN_DEG).any(axis=1) & posed[lasts]).tolist():
        joint = int(np.argmax(turns[which]))
        value = round(float(turns[which, joint]), 1)
        yield _at(path, int(lasts[which]), LARGE_TURN(joint=JOINTS[joint], value=value))


def _far_from_start(path: PlannedPath) -> Iterator[Finding]:
    further = np.flatnonzero(path.begins[1:])
    last = int(further[0]) if len(further) else len(path.rows) - 1
    away = np.abs(path.joints_deg[last] - path.joints_deg[0])
    joint = int(np.argmax(away))
    if away[joint] > FAR_FROM_START_DEG:
        value = round(float(away[joint]), 1)
        yield _at(path, last, FAR_FROM_START(joint=JOINTS[joint], value=value))


def _below_floor(path: PlannedPath, arm: ArmModel, there: Flags) -> Iterator[Finding]:
    up, base_mm = np.array(arm.rising[:3]), arm.rising[3]
    geometry = arm.kinematics.geometry
    if arm.rising == STANDING and arm.held is None:
        flanges_mm = flange_heights(geometry, path.joints_deg)
        flanges = None
    else:
        flanges = flange_transforms(geometry, path.joints_deg)
        flanges_mm = flanges[:, :3, 3] @ up + base_mm
    tips_mm = path.places_mm @ up + base_mm
    heights = np.minimum(tips_mm, flanges_mm)
    if arm.tool is not None:
        heights = arm.tool.lowest(flanges_mm, tips_mm)
    if arm.held is not None and flanges is not None:
        heights = np.minimum(
            heights, arm.held.lowest(flanges_mm, tuple((up @ flanges[:, :3, :3]).T))
        )
    below = FLOOR_MM - heights
    only_way = below[_first_point(path)] <= 0.0
    for index in _worst((below > 0.0) & there, below, path):
        found = _at(path, index, BELOW_FLOOR(value=round(float(below[index]), 1)))
        on_way = only_way and (found.row, found.cycle) == (int(path.rows[0]), 1)
        yield replace(found, approach=Approach.WAY) if on_way else found


def _tool_too_fast(path: PlannedPath, free: Flags, arm: ArmModel) -> Iterator[Finding]:
    """Motions of the joints: the arm keeps the tool's limit on lines and arcs only."""
    if arm.end_limits is None:
        return
    most = 1e3 * arm.end_limits.max_linear_speed_m_s
    speeds = path.speeds_mm_s
    fast = free & (speeds > _SPEED_SLACK * most)
    slow_way = _first_point(path) if path.expected_s == () else 0
    for index in _worst(fast, speeds, path):
        value = round(float(speeds[index]))
        found = _at(path, index, TOOL_TOO_FAST(value=value, maximum=round(most)))
        # how fast a recording is approached is nothing that is recorded
        yield replace(found, approach=Approach.WAY) if index < slow_way else found


def _collisions(path: PlannedPath, arm: ArmModel, there: Flags) -> Iterator[Finding]:
    turned = np.abs(np.diff(path.joints_deg, axis=0)).max(axis=1, initial=0.0)
    strides = np.floor(np.concatenate(([0.0], np.cumsum(turned))) / _COLLISION_STEP_DEG)
    looked_at = np.flatnonzero(np.diff(strides, prepend=-1.0) != 0.0)
    hits = collisions(
        arm.kinematics.geometry,
        path.joints_deg[looked_at],
        arm.tool_mm,
        arm.gripper_turned_deg,
        tool=arm.tool,
        held=arm.held,
    )
    hits = {which: parts for which, parts in hits.items() if there[looked_at[which]]}
    recorded = path.expected_s == ()
    rows = path.rows[looked_at]
    to_first = (rows == rows[0]) & (path.cycles[looked_at] == 1)
    end_of_first = int(np.flatnonzero(to_first)[-1])
    told: set[tuple[int, Approach | None]] = set()
    for which in sorted(hits):
        index = int(looked_at[which])
        row = int(path.rows[index])
        approach = None
        if which <= end_of_first:
            approach = Approach.WAY if which else Approach.HERE
            if which == end_of_first:
                approach = None  # the point itself
            elif (row, Approach.HERE) in told:
                continue  # it has not come clear yet, or will be looked at again
        # of a recording the first of those on end is enough: on the way there, and in itself
        before = which - 1 in hits and recorded and which != end_of_first
        if (row, approach) not in told and not before:
            told.add((row, approach))
            one, other = hits[which].split("/")
            found = _at(path, index, LINKS_COLLIDE(one=one, other=other))
            yield replace(found, approach=approach)


def _too_near(path: PlannedPath, area: AreaCheck | None, there: Flags) -> Iterator[Finding]:
    """The nearest place of each way to a point; of a recording, of each run of such samples."""
    if area is None:
        return
    entries = area.entries(path.joints_deg)
    gaps_mm = np.full(len(path.rows), np.inf)
    gaps_mm[list(entries)] = [entry.gap_mm for entry in entries.values()]
    gaps_mm[~there] = np.inf
    first = _first_point(path)
    if 0 in entries and there[0]:  # from there it is moved out, which is no run
        gaps_mm[1:first] = np.inf
    for index in _worst(np.isfinite(gaps_mm), -gaps_mm, path):
        entry = entries[index]
        kind = AREA_TOO_NEAR(
            name=entry.zone.name,
            part=entry.part,
            value=round(entry.gap_mm, 1),
            minimum=area.margin_mm,
        )
        found = _at(path, index, kind)
        if index < first:
            found = replace(found, approach=Approach.WAY if index else Approach.HERE)
        yield found


def _worst(mask: Flags, badness: Array, path: PlannedPath) -> Iterable[int]:
    """The worst sample of each way to a point that is marked; of a recording, of each run of them.

    Those of an earlier cycle come first.
    """
    marked = np.flatnonzero(mask)
    if not len(marked):
        return []
    groups = np.cumsum(path.begins)[marked]
    if path.expected_s == ():
        groups = np.cumsum(np.diff(marked, prepend=marked[0]) > 1)
    order = np.lexsort((-badness[marked], groups))
    _, firsts = np.unique(groups[order], return_index=True)
    worst: list[int] = marked[order[firsts]].tolist()
    return worst


def _first_point(path: PlannedPath) -> int:
    """Return the place on the path where the arm has come to the first point or sample."""
    further = np.flatnonzero((np.diff(path.rows) != 0) | (np.diff(path.cycles) != 0))
    return int(further[0]) if len(further) else len(path.rows) - 1


def _by_row(path: PlannedPath, flags: Sequence[bool]) -> Flags:
    return np.array(flags, dtype=bool)[path.rows]


def _at(path: PlannedPath, index: int, found: Finding) -> Finding:
    return replace(
        found,
        row=int(path.rows[index]),
        joints_deg=tuple(path.joints_deg[index].tolist()),
        place_mm=tuple(path.places_mm[index].tolist()),
        cycle=int(path.cycles[index]),
    )


def _recorded(recording: Recording, path: PlannedPath, arm: ArmModel) -> Iterator[Finding]:
    """Check the samples, at the speed the path was planned with.

    Of samples on end with the same problem, the first is named.
    """
    if len(recording.samples) < 2:
        yield EMPTY()
        return
    joints_deg = recording.joints_deg
    times_s = path.times_s[path.cycles == 1][-len(joints_deg) :]  # behind them is the way back
    low, high = bounds(arm)
    for joint, angles, limits in zip(JOINTS, joints_deg.T, arm.limits, strict=True):
        beyond = (angles < low[joint - 1]) | (angles > high[joint - 1])
        for row in _firsts(beyond):
            beyond_limit = TARGET_BEYOND_LIMIT(
                joint=joint,
                value=float(angles[row]),
                minimum=limits.min_deg,
                maximum=limits.max_deg,
            )
            yield _at_sample(recording, row, beyond_limit)
        speeds = turning_speeds(times_s, angles)
        fast = speeds > _SPEED_SLACK * limits.max_speed_deg_s
        for row in _firsts(fast):
            slow = np.flatnonzero(~fast[row:])
            end = row + int(slow[0]) if len(slow) else len(fast)
            fastest = float(speeds[row:end].max())
            too_fast = JOINT_TOO_FAST(
                joint=joint,
                value=round(fastest, 1),
                maximum=round(limits.max_speed_deg_s, 1),
                percent=math.floor(100.0 * limits.max_speed_deg_s / fastest),
            )
            yield _at_sample(recording, row, too_fast)
    steps = np.abs(np.diff(joints_deg, axis=0))
    for row in np.flatnonzero((steps > JUMP_DEG).any(axis=1)).tolist():
        joint = int(np.argmax(steps[row]))
        value = round(float(steps[row, joint]), 1)
        yield _at_sample(recording, row + 1, SAMPLE_JUMP(joint=JOINTS[joint], value=value))
    if arm.stroke_mm is not None:
        for row in _firsts(recording.gripper_mm > arm.stroke_mm + _STROKE_SLACK_MM):
            value, most = float(recording.gripper_mm[row]), float(arm.stroke_mm)
            yield _at_sample(recording, row, GRIPPER_BEYOND_STROKE(value=value, maximum=most))


def _firsts(mask: Flags) -> list[int]:
    """Where runs of marked samples begin."""
    begins: list[int] = np.flatnonzero(mask & ~np.concatenate(([False], mask[:-1]))).tolist()
    return begins


def _at_sample(recording: Recording, row: int, found: Finding) -> Finding:
    return replace(found, row=row, joints_deg=tuple(recording.joints_deg[row].tolist()))
