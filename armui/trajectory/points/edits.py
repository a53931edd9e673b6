"""Edits of a trajectory's points: each function takes the points and returns the new ones.

Points are a tuple and are never changed in place, so that undo restores the former tuple, and an
edit's changes are found by comparing the two.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from armui.arm.refusal import Refusal
from armui.trajectory.points.program import Waypoint, check_point

Points = tuple[Waypoint, ...]


@dataclass(frozen=True, slots=True)
class Change:
    """The effect of an edit: from a row on, some points were replaced by others.

    Attributes:
        first: The first row that differs, from 0.
        removed: The points removed there.
        added: The points put there.
    """

    first: int
    removed: Points
    added: Points

    def apply(self, points: Points) -> Points:
        """Return the points after the edit."""
        return points[: self.first] + self.added + points[self.first + len(self.removed) :]

    def reversed(self) -> Change:
        """Return the edit that undoes this one."""
        return Change(self.first, self.added, self.removed)


def difference(before: Points, after: Points) -> Change | None:
    """Return the smallest stretch in which two lists of points differ, or ``None`` if equal."""
    shorter = min(len(before), len(after))
    first = 0
    while first < shorter and before[first] is after[first]:
        first += 1
    last = 0
    while last < shorter - first and before[-1 - last] is after[-1 - last]:
        last += 1
    change = Change(first, before[first : len(before) - last], after[first : len(after) - last])
    return None if change.removed == change.added else change


def insert(points: Points, row: int, new: Iterable[Waypoint]) -> Points:
    """Return the points with new ones before a row; at the number of rows, after the last."""
    return (*points[:row], *new, *points[row:])


def remove(points: Points, rows: Iterable[int]) -> Points:
    """Return the points without some rows."""
    gone = frozenset(rows)
    return tuple(point for row, point in enumerate(points) if row not in gone)


def change(points: Points, changed: Mapping[int, Waypoint]) -> Points:
    """Return the points with some rows replaced."""
    result = list(points)
    for row, point in changed.items():
        result[row] = point
    return tuple(result)


def turned(points: Points, by_deg: Sequence[float]) -> Points:
    """Return the points with the joints turned; poses, which count from the base, stay."""
    return tuple(
        replace(point, target=tuple(a + by for a, by in zip(point.target, by_deg, strict=True)))
        if point.is_joint
        else point
        for point in points
    )


def chosen(points: Points, rows: Iterable[int]) -> Points:
    """Return the points of some rows, from top to bottom."""
    return tuple(points[row] for row in sorted(set(rows)))


def move(points: Points, rows: Sequence[int], before: int) -> tuple[Points, int]:
    """Move some rows, together, before another row.

    Args:
        points: All points.
        rows: The rows to move.
        before: The row before which they go, counted before the move.

    Returns:
        The new points, and the row of the first moved one.
    """
    moved = chosen(points, rows)
    gone = frozenset(rows)
    first = before - sum(1 for row in gone if row < before)
    return insert(remove(points, gone), first, moved), first


def shift(points: Points, rows: Sequence[int], by: int) -> tuple[Points, int]:
    """Move some rows up or down by one; at the ends nothing changes.

    Args:
        points: All points.
        rows: The rows to move.
        by: −1 up, +1 down.

    Returns:
        As :func:`move`.
    """
    first, last = min(rows), max(rows)
    if first + min(by, 0) < 0 or last + max(by, 0) >= len(points):
        return points, first
    return move(points, rows, first + by if by < 0 else last + 1 + by)


@dataclass(frozen=True, slots=True)
class FigureQuery:
    """The search for a figure of the target, or for a speed or dwell.

    Attributes:
        field: ``J1``…``J6``, ``X``…``RZ``, ``speed`` or ``dwell``.
        value: The value searched for.
        tolerance: The allowed difference.
    """

    field: str
    value: float
    tolerance: float = 0.0005


def find_text(points: Sequence[Waypoint], text: str) -> Iterator[int]:
    """Yield the indices of the points whose note contains a text."""
    for index, point in enumerate(points):
        if text in point.note:
            yield index


def find_figure(points: Sequence[Waypoint], query: FigureQuery) -> Iterator[int]:
    """Yield the indices of the points whose figure matches a query."""
    for index, point in enumerate(points):
        value = _figure(point, query.field)
        if value is not None and abs(value - query.value) <= query.tolerance:
            yield index


def replace_text(point: Waypoint, text: str, by: str) -> Waypoint | Refusal:
    """Return a point with a text of its note replaced, or why the new note is refused."""
    changed = replace(point, note=point.note.replace(text, by))
    return check_point(changed) or changed


def _figure(point: Waypoint, field: str) -> float | None:
    if field == "speed":
        return point.speed_percent
    if field == "dwell":
        return point.dwell_s
    return point.target[point.names.index(field)] if field in point.names else None
