"""Estimates how long a content will take, planned from its own first point on."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from armui.arm.models import ArmModel
from armui.protocol.codes import MoveMode
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.planning.findings import Severity
from armui.trajectory.planning.timing import plan_path
from armui.trajectory.planning.user_frames import in_base, why_unknown
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.trajectory.samples.recording import Recording

MOST_POINTS: Final = 5_000
"""The most points that are planned here: a check asked for meanwhile would wait for more."""
_ZEROS_DEG: Final = (0.0,) * 6
_ONCE: Final = RunOptions()


def estimate_s(
    content: Trajectory | Recording,
    arm: ArmModel,
    options: RunOptions = _ONCE,
    start_deg: Sequence[float] | None = None,
    speed_percent: int = 100,
) -> float | None:
    """Return the seconds that a content takes.

    Args:
        content: The trajectory or recording.
        arm: The arm.
        options: The options of the run. For an endless run the time of a further cycle is returned,
            which begins with the first row wherever the run began.
        start_deg: The six joint angles from which the arm goes to the first point; ``None`` to
            leave that way out. The way to a recording, and of an endless run, is always left out.
        speed_percent: The operator's speed, from 1.

    Returns:
        The seconds; ``None`` for no points, for more than `MOST_POINTS`, for a point in a frame
        that the cell has not, and for a point or a way that the arm cannot reach.
    """
    further, first = max(options.cycles, 1) - 1, options.first
    speed_factor = speed_percent / 100.0
    if isinstance(content, Recording):
        return content.duration_s / speed_factor * (1 + further)
    points, frames = content.points, dict(arm.frames)
    if not 0 <= first < len(points) or len(points) > MOST_POINTS or why_unknown(points, frames):
        return None
    points = in_base(points, frames)
    whole_s = 0.0
    if further or not options.cycles:  # from the last point back to the first, and on to the last
        again_s = _lasting_s((*points, points[0]), arm, speed_factor)
        if again_s is None or not options.cycles:
            return again_s
        whole_s = further * again_s
    if start_deg is not None:
        path = plan_path(
            Trajectory("", points=points[first:]), arm, start_deg, speed_factor=speed_factor
        )
        failed = any(found.severity is Severity.ERROR for found in path.problems)
        return None if failed else sum(path.expected_s) + whole_s
    lasting_s = _lasting_s(points[first:], arm, speed_factor)
    return None if lasting_s is None else lasting_s + points[first].dwell_s + whole_s


def estimates_s(
    content: Trajectory | Recording,
    arm: ArmModel,
    options: RunOptions,
    percents: Sequence[int],
    start_deg: Sequence[float] | None = None,
) -> tuple[float | None, ...]:
    """Return what `estimate_s` does, at each of some speeds in percent."""
    return tuple(estimate_s(content, arm, options, start_deg, percent) for percent in percents)


def _lasting_s(points: tuple[Waypoint, ...], arm: ArmModel, speed_factor: float) -> float | None:
    """Return the duration of all points but the first, at which the arm stands; with dwells."""
    begins = points[0]
    # The arm stands at the first point already; a line to it, from anywhere, could not be planned.
    if begins.move in {MoveMode.MOVE_L, MoveMode.MOVE_C}:
        begins = replace(begins, move=MoveMode.MOVE_P, middle=None)
    path = plan_path(
        Trajectory("", points=(begins, *points[1:])), arm, _ZEROS_DEG, speed_factor=speed_factor
    )
    if any(found.severity is Severity.ERROR for found in path.problems):
        return None
    return sum(path.expected_s[1:])
