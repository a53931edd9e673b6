"""Plans the duration and the path of a trajectory, as the arm moves.

MOVE J and P go from rest to rest, with all joints arriving together; lines and arcs keep the limits
of joints and tool all along. Each point begins when the one before is reached and its dwell is
over.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.models import ArmModel
from armui.kinematics import trapezoids
from armui.trajectory.planning.findings import Finding, FindingKind, Severity
from armui.trajectory.planning.planned_path import PlannedPath, sampled_path
from armui.trajectory.planning.planning import Leg, Plan, plan_run
from armui.trajectory.points.program import Trajectory
from armui.trajectory.samples.recording import Recording

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]

APPROACH_PERCENT: Final = 15
"""The speed in percent at which a replay approaches its first sample."""

_STEP_DEG: Final = 2.5
_FEWEST_STEPS: Final = 8
_NO_ROWS: Final = np.empty(0, dtype=np.int64)
_SLOWEST: Final = 0.05
"""Limits of 0 are replaced by this many °/s and °/s², so that the duration is long but finite."""

EITHER_WAY = FindingKind(
    "either_way",
    "Two ways to hold this pose are about equally near: joint {joint} at {value}°, which was "
    "checked, or at {other}°. Give the point as joint angles, so that it is certain which.",
    Severity.WARNING,
)


def plan_path(
    content: Trajectory | Recording,
    arm: ArmModel,
    start_deg: Sequence[float],
    *,
    speed_factor: float = 1.0,
    first: int = 0,
    cycles: int = 1,
) -> PlannedPath:
    """Plan a trajectory or the replay of a recording.

    Several cycles are planned until they repeat; for a recording the way back to its start is
    included.

    Args:
        content: The trajectory or recording.
        arm: The arm.
        start_deg: The joint angles before the run. A recording is approached from there.
        speed_factor: The factor, above 0, on the speed of every point, or on the recorded speed.
        first: The index of the point to begin with, in the first cycle.
        cycles: The number of cycles; 0 without end.
    """
    if isinstance(content, Recording):
        return _replay(content, arm, start_deg, speed_factor, again=cycles != 1)
    legs, endless = plan_run(content.points, arm, start_deg, first, cycles)
    percents = np.array([point.speed_percent for point in content.points], dtype=float)
    shares = np.clip(np.round(percents * speed_factor), 1, 100) / 100.0
    dwells_s = np.array([point.dwell_s for point in content.points])
    return _joined(legs, endless, arm, shares, dwells_s)


@dataclass(frozen=True, slots=True)
class _Motions:
    """The motions from stop to stop in the order of the run, without those left out.

    Attributes:
        rows: (m,) the points they lead to.
        starts_deg, ends_deg: (m, 6) the joint angles at both ends.
        lasting_s, even_s: (m,) the durations without dwells; `even_s` also without ramps.
        counts: (m,) the number of samples of each, both ends included.
    """

    rows: Whole
    starts_deg: Array
    ends_deg: Array
    lasting_s: Array
    even_s: Array
    counts: Whole


@dataclass(frozen=True, slots=True)
class _Samples:
    """A part of the way in samples.

    Attributes:
        times_s, joints_deg, rows: As in `PlannedPath`, from its own beginning.
        expected_s, even_s: (points,) as there, 0 for those left out.
    """

    times_s: Array
    joints_deg: Array
    rows: Whole
    expected_s: Array
    even_s: Array


def _joined(
    legs: Sequence[Leg], endless: Finding | None, arm: ArmModel, shares: Array, dwells_s: Array
) -> PlannedPath:
    """Return the path made of all parts of the run.

    Args:
        legs: The parts.
        endless: The finding on the cycles as a whole, if any.
        arm: The arm.
        shares: (points,) of the highest speed.
        dwells_s: (points,) how long the arm stays.
    """
    expected_s, even_s = np.zeros(len(shares)), np.zeros(len(shares))
    times, joints, rows, cycles = [np.empty(0)], [np.empty((0, 6))], [_NO_ROWS], [_NO_ROWS]
    problems = [] if endless is None else [endless]
    begun_s = 0.0
    for leg in legs:
        here = slice(leg.first, leg.first + leg.plan.known)
        part = _sampled(leg.plan, arm, shares[here], dwells_s[here])
        times.append(begun_s + part.times_s)
        joints.append(part.joints_deg)
        rows.append(leg.first + part.rows)
        cycles.append(np.full(len(part.rows), leg.cycle))
        begun_s = float(times[-1][-1]) if len(part.times_s) else begun_s
        expected_s[here] = np.maximum(expected_s[here], part.expected_s)
        even_s[here] = np.maximum(even_s[here], part.even_s)
        problems += (_placed(leg.plan.problems[stop], leg) for stop in sorted(leg.plan.problems))
        for stop, (joint, one, other) in leg.plan.route.unsure.items():
            found = EITHER_WAY(joint=joint, value=round(one, 1), other=round(other, 1))
            problems.append(_placed(replace(found, row=stop - 1), leg))
    return sampled_path(
        np.concatenate(times),
        np.concatenate(joints),
        np.concatenate(rows),
        arm,
        cycles=np.concatenate(cycles),
        expected_s=tuple(expected_s.tolist()),
        even_s=tuple(even_s.tolist()),
        problems=tuple(problems),
    )


def _placed(found: Finding, leg: Leg) -> Finding:
    """Return a finding with its row in the trajectory."""
    params = dict(found.params)
    if "before" in params:
        params["before"] = leg.first + int(params["before"])
    row = None if found.row is None else leg.first + found.row
    return replace(found, params=params, row=row, cycle=leg.cycle)


def _sampled(plan: Plan, arm: ArmModel, shares: Array, dwells_s: Array) -> _Samples:
    """Return a part of the way in samples; for the arguments see `_joined`."""
    motions = _motions(plan, arm, shares)
    _, accelerations = _limits(arm)
    dwells_s = dwells_s[motions.rows]
    # one more sample marks the end of a dwell
    counts = motions.counts + (dwells_s > 0.0)
    firsts = np.cumsum(counts) - counts
    begins_s = np.cumsum(motions.lasting_s + dwells_s) - motions.lasting_s - dwells_s
    total = int(counts.sum())
    which = np.repeat(np.arange(len(counts)), counts)
    local = np.arange(total) - firsts[which]
    parts = np.minimum(local / np.maximum(motions.counts[which] - 1, 1), 1.0)
    lasting_s = motions.lasting_s[which, None]
    spent_s = parts[:, None] * lasting_s
    even = trapezoids.even_speeds(
        motions.ends_deg - motions.starts_deg, motions.lasting_s[:, None], accelerations
    )
    joints = motions.starts_deg[which] + trapezoids.places(
        spent_s, lasting_s, even[which], accelerations
    )
    times_s = spent_s[:, 0]
    index_of = np.full(len(shares), -1)
    index_of[motions.rows] = np.arange(len(motions.rows))
    for group in plan.moves:
        wanted = group.broken < 0
        indices = index_of[group.stops[wanted] - 1]
        steps = group.joints_deg.shape[1]
        at = firsts[indices][:, None] + np.arange(steps)
        joints[at] = group.joints_deg[wanted]
        rate = group.speeds[wanted, None] * shares[motions.rows[indices], None]
        times_s[at] = trapezoids.times(
            np.linspace(0.0, 1.0, steps), np.array(1.0), rate, group.accelerations[wanted, None]
        )
    ended = local >= motions.counts[which] - 1
    joints[ended] = motions.ends_deg[which[ended]]
    stays = local >= motions.counts[which]
    times_s[stays] += dwells_s[which[stays]]
    expected_s, even_s = np.zeros(len(shares)), np.zeros(len(shares))
    expected_s[motions.rows] = motions.lasting_s + dwells_s
    even_s[motions.rows] = motions.even_s
    # rounding must not let time run backwards
    times_s = np.maximum.accumulate(times_s + begins_s[which])
    return _Samples(times_s, joints, motions.rows[which], expected_s, even_s)


def _motions(plan: Plan, arm: ArmModel, shares: Array) -> _Motions:
    route = plan.route
    run = np.flatnonzero((route.origins >= 0) & ~np.isnan(route.ends_deg[:, 0]))
    starts, ends = route.ends_deg[route.origins[run]], route.ends_deg[run]
    rows = run - 1
    lasting_s, even_s, counts = _joint_moves(starts, ends, shares[rows], arm)
    index_of = np.full(len(route.origins), -1)
    index_of[run] = np.arange(len(run))
    for group in plan.moves:
        wanted = group.broken < 0
        indices = index_of[group.stops[wanted]]
        rate = group.speeds[wanted] * shares[rows[indices]]
        ones = np.ones(len(indices))
        lasting_s[indices] = trapezoids.durations(ones, rate, group.accelerations[wanted])
        even_s[indices] = ones / rate
        counts[indices] = group.joints_deg.shape[1]
        ends[indices] = group.joints_deg[wanted, -1]
    return _Motions(rows, starts, ends, lasting_s, even_s, counts)


def _joint_moves(
    starts_deg: Array, ends_deg: Array, shares: Array, arm: ArmModel
) -> tuple[Array, Array, Whole]:
    """Return how long MOVE J takes, how long without ramps, and how many samples show it."""
    tops, accelerations = _limits(arm)
    ways = np.abs(ends_deg - starts_deg)
    speeds = np.maximum(shares[:, None] * tops, _SLOWEST)
    each_s = trapezoids.durations(ways, speeds, accelerations)
    even_s = (ways / speeds).max(axis=1, initial=0.0)
    steps = np.maximum(np.ceil(ways.max(axis=1, initial=0.0) / _STEP_DEG), _FEWEST_STEPS)
    return each_s.max(axis=1, initial=0.0), even_s, steps.astype(np.int64) + 1


def _limits(arm: ArmModel) -> tuple[Array, Array]:
    """Return the highest speeds and accelerations of the joints."""
    tops = np.array([limits.max_speed_deg_s for limits in arm.limits])
    return tops, np.maximum(np.array(arm.accelerations_deg_s2), _SLOWEST)


def _replay(
    recording: Recording,
    arm: ArmModel,
    start_deg: Sequence[float],
    speed_factor: float,
    *,
    again: bool,
) -> PlannedPath:
    """Return the approach to the first sample, then the samples in their time.

    For further cycles the way back to the first sample is appended.
    """
    samples = recording.joints_deg
    if not len(samples):
        return sampled_path(np.empty(0), np.empty((0, 6)), np.empty(0, dtype=np.int64), arm)
    to_first_s, approach = _approach(np.array([start_deg], dtype=float), samples[:1], arm)
    recorded_s = (recording.times_s - recording.times_s[0]) / speed_factor
    times = [to_first_s[:-1], to_first_s[-1] + recorded_s]
    joints = [approach[:-1], samples]
    rows = [np.zeros(len(approach) - 1, dtype=np.int64), np.arange(len(samples))]
    if again:
        back_s, back = _approach(samples[-1:], samples[:1], arm)
        times.append(times[-1][-1] + back_s)
        joints.append(back)
        rows.append(np.zeros(len(back), dtype=np.int64))
    cycles = np.repeat((1, 1, 2)[: len(rows)], [len(each) for each in rows])
    return sampled_path(
        np.concatenate(times), np.vstack(joints), np.concatenate(rows), arm, cycles=cycles
    )


def _approach(start_deg: Array, first_deg: Array, arm: ArmModel) -> tuple[Array, Array]:
    """Return times and joints of the slow way to the first sample; both ends are (1, 6)."""
    lasting_s, _, counts = _joint_moves(
        start_deg, first_deg, np.array([APPROACH_PERCENT / 100.0]), arm
    )
    _, accelerations = _limits(arm)
    even = trapezoids.even_speeds(first_deg - start_deg, lasting_s[:, None], accelerations)
    times_s = np.linspace(0.0, float(lasting_s[0]), int(counts[0]))
    return times_s, start_deg + trapezoids.places(times_s[:, None], lasting_s, even, accelerations)
