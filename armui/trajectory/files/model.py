"""The content of a trajectory file, and the checks that all formats share."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Final

from armui.arm.refusal import Reason, Refusal
from armui.trajectory.files.errors import TrajectoryFileError, broken
from armui.trajectory.points.program import (
    OF_FLANGE,
    Trajectory,
    Waypoint,
    check_point,
    check_trajectory,
)
from armui.trajectory.samples.recording import Recording, check_recording

TIME_BAD = Reason(
    "time_bad", ("“{value}” is not a date and time. Write it as 2026-01-31T12:00:00.")
)


Content = Trajectory | Recording
"""The content of a file."""

VERSION: Final = 1
"""The version of all formats."""
CELL_VERSION: Final = 2
"""The version of a file whose points name things of a cell: one that knows of no frames refuses it,
instead of taking their coordinates for those of the base.
"""
TOOL_VERSION: Final = 3
"""The version of a file that names the tool of its poses, and where the user frames were."""
VERSIONS: Final = (VERSION, CELL_VERSION, TOOL_VERSION)

LARGEST_BYTES: Final = 256 * 1024 * 1024


def version_of(content: Content) -> int:
    """Return the version of the file of a content: the lowest that can hold it."""
    points = content.points if isinstance(content, Trajectory) else ()
    if isinstance(content, Trajectory) and content.poses_of != OF_FLANGE:
        return TOOL_VERSION
    of_cell = any(point.frame or point.holds is not None for point in points)
    return CELL_VERSION if of_cell else VERSION


class UnwritableError(ValueError):
    """Content that no file can hold.

    Attributes:
        row: The point or sample to blame, from 1; 0 for the whole.
        refusal: The reason.
    """

    def __init__(self, name: str, row: int, refusal: Refusal) -> None:
        super().__init__(f"{name!r} cannot be kept: row {row}, {refusal}")
        self.row = row
        self.refusal = refusal


def first_fault(content: Content) -> tuple[int, Refusal] | None:
    """Return the first row that cannot be kept, and why not; ``None`` if all can."""
    if isinstance(content, Recording):
        return check_recording(content)
    return check_trajectory(content)


def verify(content: Content) -> None:
    """Checks before writing that the content can be read again.

    Raises:
        UnwritableError: It could not be read again.
    """
    found = first_fault(content)
    if found is not None:
        raise UnwritableError(content.name, *found)


def verified(content: Content, lines: Sequence[int] = ()) -> Content:
    """Return content that was read, if it is valid.

    Args:
        content: The content that was read.
        lines: The line of each point or sample.

    Raises:
        TrajectoryFileError: It is not valid.
    """
    found = first_fault(content)
    if found is not None:
        row, reason = found
        raise TrajectoryFileError(reason, lines[row - 1] if 0 < row <= len(lines) else 0)
    return content


def verified_point(point: Waypoint, line: int, column: int = 0) -> Waypoint:
    """Return a point that was read, if it is valid.

    Raises:
        TrajectoryFileError: It is not valid.
    """
    reason = check_point(point)
    if reason is not None:
        raise TrajectoryFileError(reason, line, column)
    return point


def parse_time(text: str, line: int, column: int) -> datetime:
    """Return a date and time in ISO 8601; without a time zone it is taken as UTC.

    Raises:
        TrajectoryFileError: The text is no date and time.
    """
    try:
        when = datetime.fromisoformat(text)
    except ValueError:
        raise broken(TIME_BAD, line, column, value=text) from None
    return when if when.tzinfo is not None else when.replace(tzinfo=UTC)
