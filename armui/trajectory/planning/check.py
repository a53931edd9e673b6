"""Checks a trajectory before it is run, by planning the whole path and examining it.

This room has neither windows nor a bus, so that a check can run in a process of its own: 10,000
points take from half a second to many seconds, depending on their distances.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby, pairwise
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.held_shape import HeldShape
from armui.arm.limits import JOINTS, SAG_DEG, outside_limits
from armui.arm.models import ArmModel
from armui.arm.rest_pose import from_rest_deg
from armui.cell.area_check import AreaCheck
from armui.kinematics.singularity import NEAR_SINGULAR as SINGULAR_BELOW
from armui.kinematics.singularity import margins, smallest_singular_values
from armui.protocol.codes import MoveMode
from armui.trajectory.files import Content
from armui.trajectory.planning.findings import FAR_FROM_START, Finding, FindingKind, Severity
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
from armui.ways.inside import NEAR_MM, is_on_base, ways_inside
from armui.ways.law import Excess, Rule, breaches, first_breach
from armui.ways.rules import AREA, FLOOR, LIMITS, OWN_BODY, FloorRule, rules_of
from armui.ways.way import Way, joint_way

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
"""Speeds computed from samples may exceed a limit by this factor: samples carry jitter."""
JUMP_DEG: Final = 5.0
"""A joint that turns this far between two samples shows that they were not recorded in one go."""
_STROKE_SLACK_MM: Final = 1.0
"""A gripper at its stop may measure this much more than its stroke."""
_TREMBLES_DEG: Final = 0.5
"""The measured angles of an arm at rest waver by no more than this."""
_SAMPLES_ON_END: Final = 50
"""The number of samples of a recording that are examined together: half a second at 100 Hz."""

FRAME_UNKNOWN = FindingKind(
    "frame_unknown",
    "The point is in the user frame “{name}”, which the cell does not have: its place is unknown. "
    "Choose the cell that has it, or make a frame of this name under Cell.",
    Severity.ERROR,
)
HELD_UNKNOWN = FindingKind(
    "held_unknown",
    "From here on the gripper holds “{name}”, which the cell does not have: its size is unknown. "
    "Choose the cell that has it, or add it under Cell, Held.",
    Severity.ERROR,
)
EMPTY = FindingKind("empty", "There is nothing to run. Add points, or record.", Severity.ERROR)
TARGET_BEYOND_LIMIT = FindingKind(
    "target_beyond_limit",
    "Joint {joint} would be at {value}°, beyond its limits {minimum}° to {maximum}°.",
    Severity.ERROR,
    "Change the point.",
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
    "The arm would hit itself: {other} against {one}.",
    Severity.ERROR,
    "Put another point between, or change the point.",
)
BEGINS_OUTSIDE = FindingKind(
    "begins_outside",
    "Its first {seconds} s lie outside the limits, as an arm does at rest: it is replayed from "
    "here on.",
    Severity.WARNING,
)
ENDS_OUTSIDE = FindingKind(
    "ends_outside",
    "Its last {seconds} s lie outside the limits, as an arm does at rest: it is replayed up to "
    "here.",
    Severity.WARNING,
)
LIES_OUTSIDE = FindingKind(
    "lies_outside",
    "{joints} outside the limits, as an arm lies at rest: it is led just inside them instead.",
    Severity.WARNING,
)
JOINT_TOO_FAST = FindingKind(
    "joint_too_fast",
    "Joint {joint} would have to turn at {value}°/s; its limit is {maximum}°/s. The replay goes at "
    "{percent} % at most.",
    Severity.WARNING,
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
    "are kept.",
    Severity.ERROR,
    "Put another point between, or change the point.",
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

BELOW_LOWEST = FindingKind(
    "below_lowest",
    "The tool or what is held would come to {value} mm; motions end at {minimum} mm, as chosen "
    "under Settings.",
    Severity.ERROR,
    "Put another point between, or change the point.",
)

_KINDS: Final = {
    LIMITS: TARGET_BEYOND_LIMIT,
    FLOOR: BELOW_LOWEST,
    AREA: AREA_TOO_NEAR,
    OWN_BODY: LINKS_COLLIDE,
}
"""The kind of finding for each broken rule."""
_OF_A_WAY: Final = (PATH_BEYOND_LIMIT, PATH_OUT_OF_REACH, PATH_SINGULAR)
"""Findings that depend on where the arm comes from, and not on a point alone."""


@dataclass(frozen=True, slots=True)
class Carried:
    """The object in the gripper, as a check sees it.

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
        first: The index of the point to begin with, in the first cycle.
        cycles: The number of cycles; 0 runs until it is ended.
        area: The work area of this arm with what it carries; ``None`` if it may go anywhere.
        lowest_mm: The least height that the operator has chosen, or ``None``.
        carried: The objects that its points name as held, as far as the cell has them.
    """

    content: Content
    arm: ArmModel
    start_deg: Sequence[float]
    first: int = 0
    cycles: int = 1
    area: AreaCheck | None = None
    lowest_mm: float | None = None
    carried: Mapping[str, Carried] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class CheckOutcome:
    """The result of a check.

    Attributes:
        path: The path of the arm.
        expected_s: The duration of each point at its own speed; empty for a recording.
        findings: The findings, errors first, then warnings of a contact, then by row.
        profile: The replay profile of a recording; ``None`` for points.
        as_checked: The content as it was checked, and will be run: all points in the base, a
            recording without the samples in which the arm lies at rest, points in which it does
            led inside; ``None`` if it is the request's.
    """

    path: PlannedPath
    expected_s: tuple[float, ...]
    findings: tuple[Finding, ...]
    profile: ReplayProfile | None = None
    as_checked: Content | None = None

    @property
    def errors(self) -> tuple[Finding, ...]:
        """The findings that forbid a run."""
        return tuple(each for each in self.findings if each.severity is Severity.ERROR)


def warm_up() -> None:
    """Load this module and its libraries in the calling process."""


def check(request: CheckRequest) -> CheckOutcome:
    """Plan a trajectory or recording, and report what this arm cannot do or should not do."""
    content, arm, start_deg = request.content, request.arm, request.start_deg
    changed: Content | None = None
    begin = 0
    if isinstance(content, Trajectory):
        unknown = tuple(_unknown(content, request))
        if unknown:
            nothing = plan_path(replace(content, points=()), arm, start_deg)
            return CheckOutcome(nothing, (), unknown)
        points = in_base(content.points, dict(arm.frames))
        if points is not content.points:
            content = changed = replace(content, points=points)
        content, found_at_rest = _led_inside(content, request)
        changed = content if found_at_rest else changed
    else:
        begin, end = _without_rest(content, request)
        found_at_rest = tuple(_left_out(content, begin, end))
        if found_at_rest:
            content = changed = replace(content, samples=content.samples[begin:end])
    path = plan_path(
        *(content, arm, start_deg),
        first=request.first,
        cycles=request.cycles,
    )
    profile = replay_profile(content) if isinstance(content, Recording) else None
    found = _findings(content, path, request, profile)
    if isinstance(content, Recording):
        found = [_timed(one, content) for one in found]
    if begin:
        path = replace(path, rows=path.rows + begin)
        found = [one if one.row is None else replace(one, row=one.row + begin) for one in found]
    found += found_at_rest
    by_place: dict[tuple[FindingKind, int | None, bool], Finding] = {}
    for one in found:
        by_place.setdefault((one.kind, one.row, one.approach), one)
    findings = tuple(sorted(by_place.values(), key=_rank))
    return CheckOutcome(path, path.expected_s, findings, profile, changed)


def _timed(found: Finding, recording: Recording) -> Finding:
    if found.row is None:
        return found
    return replace(found, at_s=round(float(recording.samples[found.row][0]), 2))


def _without_rest(recording: Recording, request: CheckRequest) -> tuple[int, int]:
    """Return the range of samples left without those at either end that lie at rest outside limits.

    Samples at the end count as such only if the arm has come to its rest pose, with the hand on its
    base.
    """
    angles = recording.joints_deg
    inside = _are_inside(angles, request.arm)
    if inside.all() or not inside.any():
        return 0, len(angles)
    begin, end = _lying_on_end(angles, inside, request, 0.0), len(angles)
    if not inside[-1] and _as_at_rest(angles[-1], request.arm):
        end -= _lying_on_end(angles[::-1], inside[::-1], request, NEAR_MM)
    return (begin, end) if begin < end else (0, len(angles))


def _lying_on_end(angles: Array, inside: Flags, request: CheckRequest, near_mm: float) -> int:
    """Return how many first poses lie outside the limits at rest; some may waver about them."""
    if inside[0]:
        return 0
    stirs = np.abs(angles - angles[0]).max(axis=1) > _TREMBLES_DEG
    lying = int(np.argmax(stirs)) if stirs.any() else 0
    trembling = np.flatnonzero(~inside[:lying])
    first = max(int(np.argmax(inside)), int(trembling[-1]) + 1 if len(trembling) else 0)
    on_base = is_on_base(angles[first : first + _SAMPLES_ON_END], rules_of(request.arm), near_mm)
    return first if on_base.all() else first + int(np.argmin(on_base))


def _are_inside(angles: Array, arm: ArmModel) -> Flags:
    low, high = bounds(arm)
    inside: Flags = np.all((angles >= low) & (angles <= high), axis=1)
    return inside


def _as_at_rest(joints_deg: Sequence[float], arm: ArmModel) -> bool:
    """Return whether the joints that are outside their limits are no further so than at rest."""
    away = from_rest_deg(joints_deg)
    return all(away[joint - 1] <= SAG_DEG for joint in outside_limits(joints_deg, arm.limits))


def _left_out(recording: Recording, begin: int, end: int) -> Iterator[Finding]:
    """Yield the findings about samples that are not replayed."""
    times_s = recording.times_s
    if begin:
        yield replace(
            BEGINS_OUTSIDE(seconds=round(float(times_s[begin] - times_s[0]), 1)), row=begin
        )
    if end < len(times_s):
        yield replace(
            ENDS_OUTSIDE(seconds=round(float(times_s[-1] - times_s[end - 1]), 1)), row=end - 1
        )


def _led_inside(
    content: Trajectory, request: CheckRequest
) -> tuple[Trajectory, tuple[Finding, ...]]:
    """Return the points with those at rest outside the limits moved inside, and the findings."""
    arm, found, points = request.arm, [], list(content.points)
    for row, point in enumerate(points):
        if (
            point.is_joint
            and (joints := outside_limits(point.target, arm.limits))
            and _as_at_rest(point.target, arm)
        ):
            points[row] = replace(point, target=ways_inside(point.target, rules_of(arm))[-1])
            found.append(
                replace(LIES_OUTSIDE(joints=", ".join(f"J{each}" for each in joints)), row=row)
            )
    return (replace(content, points=tuple(points)), tuple(found)) if found else (content, ())


def _unknown(content: Trajectory, request: CheckRequest) -> Iterator[Finding]:
    """Yield a finding for each frame or held object that a point names and the cell lacks."""
    frames = dict(request.arm.frames)
    for row, point in enumerate(content.points):
        if point.frame and point.frame not in frames:
            yield replace(FRAME_UNKNOWN(name=point.frame), row=row)
        if point.holds is not None and point.holds not in request.carried:
            yield replace(HELD_UNKNOWN(name=point.holds), row=row)


def _rank(finding: Finding) -> tuple[bool, bool, int]:
    """Return the key that sorts errors first, then warnings of a contact; the whole before rows."""
    warns, row = finding.severity is not Severity.ERROR, finding.row
    return warns, warns and finding.contact is None, -1 if row is None else row


def _findings(
    content: Content, path: PlannedPath, request: CheckRequest, profile: ReplayProfile | None
) -> list[Finding]:
    """Return the findings on a path by row, those on the whole first."""
    arm = request.arm
    findings = list(path.problems)
    if content.taught_on and arm.kind and content.taught_on != arm.kind:
        findings.append(OTHER_ARM(taught=content.taught_on, arm=arm.kind))
    if isinstance(content, Recording):
        findings += _recorded(content, path, arm)
        slow = np.zeros(len(path.rows), dtype=bool)
    elif not len(path.times_s):
        findings += [] if content.points else [EMPTY()]
        slow = np.empty(0, dtype=bool)
    else:
        slow = _by_row(path, [point.move in TOOL_MOVES for point in content.points])
        findings += _arcs_at_limits(path, [point.move for point in content.points], arm)
        findings += _near_singular(path, slow, arm)
        posed = [not point.is_joint and point.move not in TOOL_MOVES for point in content.points]
        findings += _large_turns(path, _by_row(path, posed))
    if isinstance(content, Trajectory):
        findings += _grippers(content.points, arm)
    if len(path.times_s):
        findings += _far_from_start(path)
        findings += _tool_too_fast(path, ~slow, arm)
        caps = [int(each.params["percent"]) for each in findings if each.kind == JOINT_TOO_FAST]
        capped = (min(caps, default=100) / 100.0) ** 2
        astray = None if profile is None else profile.astray_deg.astype(float) * capped
        for carried, legs in _carried_legs(content, path, request):
            findings += _broken(path, legs, carried, request, astray)
        findings = _marked_approach(findings, path)
    if any(each.cycle > 1 and each.severity is Severity.ERROR for each in findings):
        # The error of a later cycle already says why the cycles do not repeat.
        findings = [each for each in findings if each.kind != NEVER_REPEATS]
    findings.sort(key=lambda each: (-1 if each.row is None else each.row, each.severity.value))
    return findings


@dataclass(frozen=True, slots=True)
class _Leg:
    """A part of the path: the way to a point, or some samples of a recording on end.

    Attributes:
        begin, end: The indices of its first and its last sample; it begins where the one before
            ends.
        by_joints: True if the arm is told its last pose only, and turns there by itself.
    """

    begin: int
    end: int
    by_joints: bool = False

    def way(self, path: PlannedPath) -> Way:
        """Return the way along it: straight in the joint angles, or through its samples."""
        if self.by_joints:
            return joint_way(path.joints_deg[self.begin], path.joints_deg[self.end])
        return Way(path.joints_deg[self.begin : self.end + 1])

    def nearest(self, path: PlannedPath, joints_deg: Sequence[float]) -> int:
        """Return the index of its sample that is nearest to six angles: its end, or the first."""
        away = np.abs(path.joints_deg[self.begin : self.end + 1] - np.array(joints_deg))
        away_deg = away.max(axis=1)
        return self.end if away_deg[-1] <= away_deg.min() else self.begin + int(away_deg.argmin())


def _legs(content: Content, path: PlannedPath) -> list[_Leg]:
    """Return the parts of a path in order; the first leads from where the arm stands."""
    last = len(path.rows) - 1
    if isinstance(content, Recording):
        ends = [*range(_first_point(path), last, _SAMPLES_ON_END), last]
        return [_Leg(begin, end) for begin, end in pairwise((0, *ends))]
    ends = [*(np.flatnonzero(path.begins)[1:] - 1).tolist(), last]
    turns = [point.move not in TOOL_MOVES for point in content.points]
    return [_Leg(begin, end, turns[path.rows[end]]) for begin, end in pairwise((0, *ends))]


def _carried_legs(
    content: Content, path: PlannedPath, request: CheckRequest
) -> Iterator[tuple[Carried, list[_Leg]]]:
    """Yield each held object with the parts of the path on which it is held; at a change, both."""
    holds = [point.holds for point in content.points] if isinstance(content, Trajectory) else []
    now, legs = Carried(request.arm.held, request.area), _legs(content, path)
    if all(name is None for name in holds):
        yield now, legs
        return
    # A further cycle begins with the object that the one before ended with.
    last = path.cycles[-1]
    again = [leg for leg in legs if path.cycles[leg.end] == last] if request.cycles != 1 else []
    found: dict[str | None, list[_Leg]] = {}
    name: str | None = None
    for leg in (*legs, *again):
        found.setdefault(name, []).append(leg)
        told = holds[path.rows[leg.end]]
        if told is not None:
            name = told
            found.setdefault(name, []).append(_Leg(leg.end, leg.end))
    for name, carrying in found.items():
        yield now if name is None else request.carried[name], carrying


def _broken(
    path: PlannedPath,
    legs: Sequence[_Leg],
    carried: Carried,
    request: CheckRequest,
    astray_deg: Array | None,
) -> Iterator[Finding]:
    """Yield where parts of a path break a rule, as the gate will ask it."""
    arm = replace(request.arm, held=carried.held)
    rules = rules_of(arm, carried.area, request.lowest_mm)
    ways = [rules.ramped(leg.way(path)) for leg in legs]
    if astray_deg is not None:
        rows = [path.rows[leg.begin : leg.end + 1] for leg in legs]
        ways[1:] = [
            replace(way, beside_deg=astray_deg[row])
            for way, row in zip(ways[1:], rows[1:], strict=True)
        ]
    for rule in rules.every:
        for leg, breach in _broken_legs(path, legs, ways, rule):
            kind = _KINDS[rule.name]
            if rule.name == LIMITS and leg.nearest(path, breach.joints_deg) < leg.end:
                kind = TARGET_BEYOND_LIMIT if _is_recorded(path) else PATH_BEYOND_LIMIT
            figures = rule.refuse(breach, found_outside=False).params
            found = replace(kind(**figures), contact=rule.contact(breach))
            yield _on_leg(path, leg, breach, found)
    if request.lowest_mm is None or request.lowest_mm < FLOOR_MM:
        floor = FloorRule(arm, FLOOR_MM)
        for leg, breach in _broken_legs(path, legs, ways, floor):
            found = BELOW_FLOOR(value=round(breach.outside, 1))
            yield _on_leg(path, leg, breach, replace(found, contact=floor.contact(breach)))


def _broken_legs(
    path: PlannedPath, legs: Sequence[_Leg], ways: Sequence[Way], rule: Rule
) -> Iterator[tuple[_Leg, Excess]]:
    """Yield which parts of a path break a rule, and the worst place of each.

    Of successive samples of a recording only the worst is yielded.
    """
    planned = 0
    found: list[tuple[int, Excess]] = []
    if legs[0].begin == 0:
        planned = 1
        breach = _broken_approach(ways[0], rule)
        found += [] if breach is None else [(0, breach)]
    found += [(planned + place, breach) for place, breach in breaches(ways[planned:], rule)]
    # A breach where a part begins is reported at the end of the part before; its own end is checked
    # for itself.
    for which, (place, breach) in reversed([*enumerate(found)]):
        leg = legs[place]
        if leg.begin in {0, leg.end} or leg.nearest(path, breach.joints_deg) > leg.begin:
            continue
        at_end = None if _is_recorded(path) else _broken_end(ways[place], rule)
        found[which : which + 1] = [] if at_end is None else [(place, at_end)]
    runs = groupby(enumerate(found), lambda one: one[1][0] - one[0] if _is_recorded(path) else one)
    for _, run in runs:
        place, breach = max((one for _, one in run), key=lambda one: one[1].outside)
        yield legs[place], breach


def _broken_approach(way: Way, rule: Rule) -> Excess | None:
    """Return where the way from the arm's present place breaks a rule, preferably at its end.

    An arm that is outside already may come back on this way, but its end must lie inside.
    """
    if not rule.bounds:
        return None
    at_end = _broken_end(way, rule)
    if at_end is not None:
        return at_end
    if rule.outside(way.joints_deg[:1]).max() > rule.exact:
        return first_breach(way, rule)
    return next((breach for _, breach in breaches([way], rule)), None)


def _broken_end(way: Way, rule: Rule) -> Excess | None:
    """Return how the end of a way breaks a rule, or ``None``."""
    (outside,) = rule.outside(way.joints_deg[-1:])
    bound = int(np.argmax(outside))
    if not outside[bound] > rule.exact:
        return None
    return Excess(bound, float(outside[bound]), way.end_deg)


def _on_leg(path: PlannedPath, leg: _Leg, breach: Excess, found: Finding) -> Finding:
    """Return a finding with its place on a part of the path."""
    index = leg.nearest(path, breach.joints_deg)
    return replace(
        _at(path, index if _is_recorded(path) else max(index, min(leg.begin + 1, leg.end)), found),
        joints_deg=breach.joints_deg,
        place_mm=tuple(path.places_mm[index].tolist()),
        approach=leg.begin == 0 and index < leg.end,
    )


def _is_recorded(path: PlannedPath) -> bool:
    """Return whether a path is that of a recording: such a path has no planned durations."""
    return path.expected_s == ()


def _marked_approach(findings: Sequence[Finding], path: PlannedPath) -> list[Finding]:
    """Mark the findings on the way from the arm's present place to the first point."""
    first = int(path.rows[0]) if len(path.rows) else 0
    return [
        replace(one, approach=True)
        if (one.row, one.cycle) == (first, 1) and one.kind in _OF_A_WAY
        else one
        for one in findings
    ]


def _grippers(points: Sequence[Waypoint], arm: ArmModel) -> Iterator[Finding]:
    widest_mm = arm.stroke_mm if arm.widest_mm is None else arm.widest_mm
    if widest_mm is None:
        return
    for row, point in enumerate(points):
        action = point.gripper
        if isinstance(action, GripperOpening) and action.opening_mm > widest_mm:
            most, wanted = float(widest_mm), float(action.opening_mm)
            yield replace(GRIPPER_BEYOND_STROKE(value=wanted, maximum=most), row=row)


def _arcs_at_limits(
    path: PlannedPath, moves: Sequence[MoveMode], arm: ArmModel
) -> Iterator[Finding]:
    """Yield a finding for each arc beginning at a joint's limit: rounded, it may lie beyond."""
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


def _tool_too_fast(path: PlannedPath, free: Flags, arm: ArmModel) -> Iterator[Finding]:
    """Yield findings for joint motions; on lines and arcs the arm keeps the tool's limit."""
    if arm.end_limits is None:
        return
    most = 1e3 * arm.end_limits.max_linear_speed_m_s
    speeds = path.speeds_mm_s
    fast = free & (speeds > _SPEED_SLACK * most)
    slow_way = _first_point(path) if _is_recorded(path) else 0
    for index in _worst(fast, speeds, path):
        value = round(float(speeds[index]))
        found = _at(path, index, TOOL_TOO_FAST(value=value, maximum=round(most)))
        # The speed of the approach is chosen by this program, not recorded.
        yield replace(found, approach=True) if index < slow_way else found


def _worst(mask: Flags, badness: Array, path: PlannedPath) -> Iterable[int]:
    """Return the worst marked sample on each way to a point, in a recording of each run of them.

    Those of an earlier cycle come first.
    """
    marked = np.flatnonzero(mask)
    if not len(marked):
        return []
    groups = np.cumsum(path.begins)[marked]
    if _is_recorded(path):
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

    Of successive samples with the same problem, the first is named.
    """
    if len(recording.samples) < 2:
        yield EMPTY()
        return
    joints_deg = recording.joints_deg
    times_s = path.times_s[path.cycles == 1][-len(joints_deg) :]  # without approach and way back
    for joint, angles, limits in zip(JOINTS, joints_deg.T, arm.limits, strict=True):
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
    """Return where each run of marked samples begins."""
    begins: list[int] = np.flatnonzero(mask & ~np.concatenate(([False], mask[:-1]))).tolist()
    return begins


def _at_sample(recording: Recording, row: int, found: Finding) -> Finding:
    return replace(found, row=row, joints_deg=tuple(recording.joints_deg[row].tolist()))
