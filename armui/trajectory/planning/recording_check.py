"""What only a recording can have wrong: samples beyond limits, too fast, or far from each other."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.limits import JOINTS
from armui.arm.model import ArmModel
from armui.trajectory.planning.findings import Finding, FindingCode
from armui.trajectory.planning.planned_path import PlannedPath
from armui.trajectory.planning.stops import bounds
from armui.trajectory.samples.recording import Recording

Array = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]

JUMP_DEG: Final = 5.0
"""A joint that turns so far from one sample to the next was not recorded in one go."""
_SPEED_OVER_S: Final = 0.1
"""Speeds are taken over so long: samples carry the bus's jitter."""
_SPEED_SLACK: Final = 1.02
_STROKE_SLACK_MM: Final = 1.0
"""A gripper that stands at its stop may measure so much more."""


def check_recorded(recording: Recording, path: PlannedPath, arm: ArmModel) -> Iterator[Finding]:
    """Checks the samples, at the speed the path was planned with.

    Of samples on end with the same problem, the first is named.
    """
    if len(recording.samples) < 2:
        yield Finding(FindingCode.EMPTY)
        return
    joints_deg = recording.joints_deg
    times_s = path.times_s[path.cycles == 1][-len(joints_deg) :]  # behind them is the way back
    low, high = bounds(arm)
    for joint, angles, limits in zip(JOINTS, joints_deg.T, arm.limits, strict=True):
        beyond = (angles < low[joint - 1]) | (angles > high[joint - 1])
        for row in _firsts(beyond):
            figures: dict[str, float | int | str] = {
                "joint": joint,
                "value": float(angles[row]),
                "minimum": limits.min_deg,
                "maximum": limits.max_deg,
            }
            yield _at(recording, row, FindingCode.TARGET_BEYOND_LIMIT, figures)
        speeds = _speeds(times_s, angles)
        fast = speeds > _SPEED_SLACK * limits.max_speed_deg_s
        for row in _firsts(fast):
            slow = np.flatnonzero(~fast[row:])
            end = row + int(slow[0]) if len(slow) else len(fast)
            fastest = float(speeds[row:end].max())
            figures = {
                "joint": joint,
                "value": round(fastest, 1),
                "maximum": round(limits.max_speed_deg_s, 1),
                "percent": math.floor(100.0 * limits.max_speed_deg_s / fastest),
            }
            yield _at(recording, row, FindingCode.JOINT_TOO_FAST, figures)
    steps = np.abs(np.diff(joints_deg, axis=0))
    for row in np.flatnonzero((steps > JUMP_DEG).any(axis=1)).tolist():
        joint = int(np.argmax(steps[row]))
        figures = {"joint": JOINTS[joint], "value": round(float(steps[row, joint]), 1)}
        yield _at(recording, row + 1, FindingCode.SAMPLE_JUMP, figures)
    if arm.stroke_mm is not None:
        for row in _firsts(recording.gripper_mm > arm.stroke_mm + _STROKE_SLACK_MM):
            figures = {"value": float(recording.gripper_mm[row]), "maximum": float(arm.stroke_mm)}
            yield _at(recording, row, FindingCode.GRIPPER_BEYOND_STROKE, figures)


def _speeds(times_s: Array, angles_deg: Array) -> Array:
    """(n,) how fast a joint is asked to turn around each sample, in °/s."""
    before = np.maximum(times_s - _SPEED_OVER_S / 2, times_s[0])
    after = np.minimum(times_s + _SPEED_OVER_S / 2, times_s[-1])
    ways = np.interp(after, times_s, angles_deg) - np.interp(before, times_s, angles_deg)
    speeds: Array = np.abs(ways) / np.maximum(after - before, 1e-9)
    return speeds


def _firsts(mask: Flags) -> list[int]:
    """Where runs of marked samples begin."""
    begins: list[int] = np.flatnonzero(mask & ~np.concatenate(([False], mask[:-1]))).tolist()
    return begins


def _at(
    recording: Recording, row: int, code: FindingCode, figures: dict[str, float | int | str]
) -> Finding:
    return Finding(code, figures, row, tuple(recording.joints_deg[row].tolist()))
