"""Plans many lines and arcs at once: the joint angles along them, and their pace.

Moves of similar length are taken together in arrays; each has as many places as its length wants,
rounded up to a power of two. A move on which joints turn fast is sampled again more finely.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
import numpy.typing as npt
from scipy.interpolate import CubicSpline

from armui.arm.models import ArmModel
from armui.kinematics.follow import follow
from armui.kinematics.pace import Demand, joint_demand, pace, tool_demand
from armui.kinematics.singularity import JITTER_DEG, fine_steps, leaps, turns
from armui.kinematics.tool_path import Arc, StraightLines

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]

_STEP_MM: Final = 5.0
_STEP_DEG: Final = 1.5
_FEWEST_STEPS: Final = 8
_MOST_STEPS: Final = 8192
_MOST_PLACES: Final = 200_000
"""The number of places that are computed together."""
_FAST_DEG: Final = 4.0
"""A move is sampled more finely if a joint turns further than this in a step,"""
_BENT_DEG: Final = 0.5
"""or if the turn differs by this much from that of the step before,"""
_SHARP: Final = 4.0
"""or if that difference is this many times its mean along the path."""
_FINER: Final = 2


@dataclass(frozen=True, slots=True)
class PlannedToolMoves:
    """Planned moves with the same number of places.

    Attributes:
        stops: (m,) the stops they lead to.
        joints_deg: (m, places, 6) evenly along each path; NaN from where it cannot be followed.
        lengths_mm, angles_deg: (m,) lengths of the tool's paths, and turns of the hand.
        speeds: (m,) highest along the path, in paths per second; 0 if the path cannot be followed.
        accelerations: (m,) highest along the path, in paths per second².
        broken: (m,) the first place that cannot be passed; −1 if all can.
        singular: (m,) true if a joint would have to leap there.
    """

    stops: Whole
    joints_deg: Array
    lengths_mm: Array
    angles_deg: Array
    speeds: Array
    accelerations: Array
    broken: Whole
    singular: Flags

    def only(self, wanted: Whole | Flags) -> PlannedToolMoves:
        """Return some of the moves, by their indices or a mask."""
        return PlannedToolMoves(
            self.stops[wanted],
            self.joints_deg[wanted],
            self.lengths_mm[wanted],
            self.angles_deg[wanted],
            self.speeds[wanted],
            self.accelerations[wanted],
            self.broken[wanted],
            self.singular[wanted],
        )


@dataclass(frozen=True, slots=True)
class Paths:
    """Paths of the flange; arcs have a middle pose as well.

    Attributes:
        stops: (m,) the stops they lead to.
        starts, goals: (m, 4, 4) transforms of the flange.
        starts_deg: (m, 6) the joints at the start.
        arcs: (m,) the arcs; ``None`` for lines.
    """

    stops: Whole
    starts: Array
    goals: Array
    starts_deg: Array
    arcs: Sequence[Arc | None]

    def only(self, wanted: Whole) -> Paths:
        """Return some of the paths, by their indices."""
        return Paths(
            self.stops[wanted],
            self.starts[wanted],
            self.goals[wanted],
            self.starts_deg[wanted],
            [self.arcs[index] for index in wanted.tolist()],
        )

    def sizes(self) -> tuple[Array, Array]:
        """Return (m,) lengths in mm and (m,) turns in degrees."""
        lines = StraightLines(self.starts, self.goals)
        lengths, angles = lines.lengths_mm, lines.angles_deg
        for index, arc in enumerate(self.arcs):
            if arc is not None:
                lengths[index], angles[index] = arc.length_mm, arc.angle_deg
        return lengths, angles

    def poses(self, shares: Array) -> Array:
        """Return (m, places, 4, 4) transforms at parts of the paths."""
        poses = StraightLines(self.starts, self.goals).poses(shares)
        for index, arc in enumerate(self.arcs):
            if arc is not None:
                poses[index] = arc.poses(shares)
        return poses


def plan_tool_moves(
    paths: Paths, arm: ArmModel, *, roughly: bool = False
) -> list[PlannedToolMoves]:
    """Follow lines and arcs as the arm does, and compute their pace.

    Args:
        paths: The ways of the flange.
        arm: The arm.
        roughly: True to sample no path more finely: that is quick, and if joints turn fast the pace
            is overestimated rather than underestimated.
    """
    if not len(paths.stops):
        return []
    lengths, angles = paths.sizes()
    units = fine_steps(lengths, angles)
    coarse = _steps(np.maximum(lengths / _STEP_MM, angles / _STEP_DEG))
    fine = _steps(units)
    done: list[PlannedToolMoves] = []
    again: list[Whole] = []
    for steps, wanted in _groups(coarse):
        moves = _followed(paths.only(wanted), arm, steps, units[wanted])
        fast = (_uneven(moves.joints_deg) | moves.singular) & (fine[wanted] > steps)
        fast &= not roughly
        again.append(wanted[fast])
        done.append(moves.only(~fast))
    rest = np.concatenate(again)
    for steps, chosen in _groups(fine[rest]):
        wanted = rest[chosen]
        done.append(_followed(paths.only(wanted), arm, steps, units[wanted]))
    return [_paced(moves, paths, arm) for moves in done if len(moves.stops)]


def _followed(paths: Paths, arm: ArmModel, steps: int, units: Array) -> PlannedToolMoves:
    """Return moves with their joint angles and broken places, but without a pace."""
    shares = np.linspace(0.0, 1.0, steps + 1)
    joints = follow(arm.kinematics.geometry, paths.poses(shares), paths.starts_deg)
    lost = np.isnan(joints[:, 1:, 0])
    bad = lost | leaps(joints, units / steps)
    broken = np.where(bad.any(axis=1), np.argmax(bad, axis=1) + 1, -1)
    rows = np.arange(len(broken))
    singular = (broken > 0) & ~lost[rows, np.maximum(broken - 1, 0)]
    lengths, angles = paths.sizes()
    unknown = np.zeros(len(broken))
    return PlannedToolMoves(
        paths.stops, joints, lengths, angles, unknown, unknown, broken, singular
    )


def _paced(moves: PlannedToolMoves, paths: Paths, arm: ArmModel) -> PlannedToolMoves:
    """Return the moves with their speeds and accelerations."""
    good = np.flatnonzero(moves.broken < 0)
    speeds, accelerations = np.zeros(len(moves.stops)), np.zeros(len(moves.stops))
    if not len(good):
        return moves
    steps = moves.joints_deg.shape[1] - 1
    way = CubicSpline(np.linspace(0.0, 1.0, steps + 1), moves.joints_deg[good].swapaxes(0, 1))
    fine = np.linspace(0.0, 1.0, _FINER * steps + 1)
    tops = [limits.max_speed_deg_s for limits in arm.limits]
    demands = [joint_demand(way, fine, tops, arm.accelerations_deg_s2)]
    if arm.end_limits is not None:
        demands.append(_tool_demand(moves.only(good), paths, arm))
    speeds[good], accelerations[good] = pace(demands)
    return replace(moves, speeds=speeds, accelerations=accelerations)


def _tool_demand(moves: PlannedToolMoves, paths: Paths, arm: ArmModel) -> Demand:
    """Return the tool's demand: constant along a line, the maximum along an arc."""
    end = arm.end_limits
    if end is None:
        raise ValueError("an arm that has not told the limits of its tool")
    limits = (
        end.max_linear_speed_m_s,
        end.max_angular_speed_rad_s,
        end.max_linear_acceleration_m_s2,
        end.max_angular_acceleration_rad_s2,
    )
    rates = np.stack((moves.lengths_mm / 1e3, np.radians(moves.angles_deg)), axis=1)[None]
    bends = np.zeros_like(rates)
    arcs = dict(zip(paths.stops.tolist(), paths.arcs, strict=True))
    places = np.linspace(0.0, 1.0, _FINER * moves.joints_deg.shape[1])
    for index, stop in enumerate(moves.stops.tolist()):
        arc = arcs[stop]
        if arc is not None:
            demand = tool_demand(arc.poses(places), places, limits)
            rates[0, index], bends[0, index] = demand.rates.max(axis=0), demand.bends.max(axis=0)
    return Demand(rates, bends, np.array(limits[:2]), np.array(limits[2:]))


def _steps(wanted: Array) -> Whole:
    """Return the numbers of steps: powers of two, so that there are few different ones."""
    wanted = np.clip(wanted, _FEWEST_STEPS, _MOST_STEPS)
    steps: Whole = (2 ** np.ceil(np.log2(wanted))).astype(np.int64)
    return steps


def _groups(steps: Whole) -> Iterator[tuple[int, Whole]]:
    """Yield each number of steps with its indices, in groups of bounded memory."""
    groups: dict[int, list[int]] = defaultdict(list)
    for index, count in enumerate(steps.tolist()):
        groups[count].append(index)
    for count, members in groups.items():
        most = max(1, _MOST_PLACES // count)
        for first in range(0, len(members), most):
            yield count, np.array(members[first : first + most])


def _uneven(joints_deg: Array) -> Flags:
    """Return (m,) true if joints turn so fast or change so suddenly that the steps are too wide."""
    bends = np.nan_to_num(np.abs(np.diff(joints_deg, n=2, axis=1)).max(axis=2))
    sharpest, mean = bends.max(axis=1), bends.mean(axis=1)
    sharp = (sharpest > _SHARP * mean) & (sharpest > JITTER_DEG)
    fast = (turns(joints_deg).max(axis=1) > _FAST_DEG) | (sharpest > _BENT_DEG)
    return np.asarray(sharp | fast)
