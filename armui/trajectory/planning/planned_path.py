"""Where an arm is at every moment of a trajectory."""

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
    """The whole way, sampled: evenly spaced in no respect, closely enough in every one.

    Attributes:
        times_s: (n,) from 0 up, never back.
        joints_deg: (n, 6).
        places_mm: (n, 3) the tip of the tool: as far beyond the flange as the gripper reaches.
        speeds_mm_s: (n,) how fast the tip goes.
        rows: (n,) the index of the point the arm is on its way to, or waits at; of a recording
            the index of the sample.
        cycles: (n,) in which cycle that is, from 1.
        expected_s: How long each point takes from the one before, dwell included: the longest of
            all cycles, 0 for those left out; of a recording empty.
        problems: What was found in planning: why points were left out, for the arm cannot get
            there, and where it is not certain which way the arm takes.
    """

    times_s: Array
    joints_deg: Array
    places_mm: Array
    speeds_mm_s: Array
    rows: Whole
    cycles: Whole
    expected_s: tuple[float, ...] = ()
    problems: tuple[Finding, ...] = ()

    @property
    def duration_s(self) -> float:
        """How long it takes in all."""
        return float(self.times_s[-1]) if len(self.times_s) else 0.0

    @property
    def first_cycle_s(self) -> float:
        """How long the first cycle takes, from where the arm stands before it."""
        first = self.times_s[self.cycles == 1]
        return float(first[-1]) if len(first) else 0.0

    @property
    def begins(self) -> npt.NDArray[np.bool_]:
        """(n,) whether each sample is the first on the way to a point, in whichever cycle."""
        changes = (np.diff(self.rows) != 0) | (np.diff(self.cycles) != 0)
        return np.concatenate((np.ones(min(1, len(self.rows)), dtype=bool), changes))

    def at(self, t_s: float) -> Joints:
        """Return six angles so long after the start; before and after the path its ends.

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
        """Return the index of the last sample of each row, where the arm first comes to it."""
        if not len(self.rows):
            return {}
        lasts = np.flatnonzero(np.append(self.begins[1:], True))[::-1].tolist()
        return dict(sorted((int(self.rows[last]), last) for last in lasts))

    def outline(self, most: int) -> Whole:
        """Return the indices of about so many samples, evenly, and of each row's last."""
        step = max(1, len(self.rows) // most)
        wanted = np.append(self.begins[1:], True)
        wanted[::step] = True
        return np.flatnonzero(wanted)

    def row_at(self, t_s: float) -> int:
        """Return the index of the point under way so long after the start."""
        index = int(np.searchsorted(self.times_s, t_s, side="left"))
        return int(self.rows[min(index, len(self.rows) - 1)])


def sampled_path(
    times_s: Array,
    joints_deg: Array,
    rows: Whole,
    arm: ArmModel,
    *,
    cycles: Whole | None = None,
    expected_s: tuple[float, ...] = (),
    problems: tuple[Finding, ...] = (),
) -> PlannedPath:
    """Return a path with the places and the speeds of the tool's tip worked out."""
    arm_links = links(arm.kinematics.geometry, joints_deg)
    places = arm_links.flange + arm.tool_mm * arm_links.hand
    cycles = np.ones_like(rows) if cycles is None else cycles
    speeds = _speeds(times_s, places)
    return PlannedPath(times_s, joints_deg, places, speeds, rows, cycles, expected_s, problems)


def _speeds(times_s: Array, places_mm: Array) -> Array:
    """(n,) the mean of the speeds before and after each place."""
    gone, spent = np.linalg.norm(np.diff(places_mm, axis=0), axis=1), np.diff(times_s)
    moving = spent > 0.0
    between = np.where(moving, gone / np.where(moving, spent, 1.0), 0.0)
    speeds = np.zeros(len(times_s))
    speeds[:-1] += between / 2.0
    speeds[1:] += between / 2.0
    return speeds
