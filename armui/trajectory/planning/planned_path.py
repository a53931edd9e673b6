"""The planned path: where the arm is at every moment of a trajectory."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from armui.arm.models import ArmModel
from armui.kinematics.forward import links
from armui.kinematics.poses import Joints
from armui.trajectory.planning.findings import Finding

Array = npt.NDArray[np.float64]
Whole = npt.NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class PlannedPath:
    """The whole path as samples, not evenly spaced, but close together in time and place.

    Attributes:
        times_s: (n,) from 0, never decreasing.
        joints_deg: (n, 6).
        places_mm: (n, 3) the places of the tool's tip, which is as far beyond the flange as the
            gripper reaches.
        speeds_mm_s: (n,) the speeds of the tip.
        rows: (n,) the index of the point to which the arm moves, or at which it waits; for a
            recording the index of the sample.
        cycles: (n,) the cycle, from 1.
        expected_s: The duration of each point from the one before, dwell included: the longest of
            all cycles, 0 for those left out; empty for a recording.
        even_s: The same without dwells, and as if the arm moved evenly all the way: what is left
            is the time of its ramps, which a lower speed does not stretch.
        problems: The findings of the planning: points left out because the arm cannot reach them,
            and points for which it is not certain which solution the arm takes.
    """

    times_s: Array
    joints_deg: Array
    places_mm: Array
    speeds_mm_s: Array
    rows: Whole
    cycles: Whole
    expected_s: tuple[float, ...] = ()
    even_s: tuple[float, ...] = ()
    problems: tuple[Finding, ...] = ()

    @property
    def duration_s(self) -> float:
        """The time from the first pose to the last, in s; 0 for an empty path."""
        return float(self.times_s[-1]) if len(self.times_s) else 0.0

    @property
    def first_cycle_s(self) -> float:
        """The duration of the first cycle, from where the arm stands before it."""
        first = self.times_s[self.cycles == 1]
        return float(first[-1]) if len(first) else 0.0

    @property
    def lap_s(self) -> float:
        """The duration of a cycle that follows another: of the last way to each point."""
        ends = np.flatnonzero(np.append(self.begins[1:], True))
        lasting_s = np.diff(self.times_s[ends], prepend=0.0).tolist()
        return sum(dict(zip(self.rows[ends].tolist(), lasting_s, strict=True)).values())

    @property
    def begins(self) -> npt.NDArray[np.bool_]:
        """(n,) true for each sample that is the first on the way to a point, in any cycle."""
        changes = (np.diff(self.rows) != 0) | (np.diff(self.cycles) != 0)
        return np.concatenate((np.ones(min(1, len(self.rows)), dtype=bool), changes))

    def at(self, t_s: float) -> Joints:
        """Return the six joint angles at a time after the start, clipped to the path's ends.

        Raises:
            IndexError: The path is empty.
        """
        after = int(np.searchsorted(self.times_s, t_s))
        if not 0 < after < len(self.times_s):
            return tuple(self.joints_deg[min(after, len(self.times_s) - 1)].tolist())
        before_s, after_s = self.times_s[after - 1 : after + 1].tolist()
        share = (t_s - before_s) / (after_s - before_s)
        one, other = self.joints_deg[after - 1], self.joints_deg[after]
        return tuple((one + share * (other - one)).tolist())

    def ends(self) -> dict[int, int]:
        """Return the index of the last sample of each row, in the first cycle that reaches it."""
        if not len(self.rows):
            return {}
        lasts = np.flatnonzero(np.append(self.begins[1:], True))[::-1].tolist()
        return dict(sorted((int(self.rows[last]), last) for last in lasts))

    def outline(self, most: int) -> Whole:
        """Return the indices of about `most` evenly spaced samples, and of each row's last one."""
        step = max(1, len(self.rows) // most)
        wanted = np.append(self.begins[1:], True)
        wanted[::step] = True
        return np.flatnonzero(wanted)


def sampled_path(
    times_s: Array,
    joints_deg: Array,
    rows: Whole,
    arm: ArmModel,
    *,
    cycles: Whole | None = None,
    expected_s: tuple[float, ...] = (),
    even_s: tuple[float, ...] = (),
    problems: tuple[Finding, ...] = (),
) -> PlannedPath:
    """Return a path with the places and speeds of the tool's tip computed."""
    arm_links = links(arm.kinematics.geometry, joints_deg)
    along, palm, hand = arm.tip_mm
    places = arm_links.flange + hand * arm_links.hand
    if along or palm:
        places += along * arm_links.along + palm * arm_links.palm
    cycles = np.ones_like(rows) if cycles is None else cycles
    speeds = _speeds(times_s, places)
    return PlannedPath(
        times_s, joints_deg, places, speeds, rows, cycles, expected_s, even_s, problems
    )


def _speeds(times_s: Array, places_mm: Array) -> Array:
    """Return (n,) the means of the speeds before and after each place."""
    gone, spent = np.linalg.norm(np.diff(places_mm, axis=0), axis=1), np.diff(times_s)
    moving = spent > 0.0
    between = np.where(moving, gone / np.where(moving, spent, 1.0), 0.0)
    speeds = np.zeros(len(times_s))
    speeds[:-1] += between / 2.0
    speeds[1:] += between / 2.0
    return speeds
