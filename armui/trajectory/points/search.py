"""Find and replace in the figures and notes of a trajectory's points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from armui.arm.refusal import Refusal
from armui.trajectory.points.program import Waypoint, check_figure, check_point


@dataclass(frozen=True, slots=True)
class FigureQuery:
    """Looks for a figure of the target or for a speed or dwell.

    Attributes:
        field: ``J1``…``J6``, ``X``…``RZ``, ``speed`` or ``dwell``.
        value: What it should be.
        tolerance: How far off it may be.
    """

    field: str
    value: float
    tolerance: float = 0.0005


def find_text(points: Sequence[Waypoint], text: str, *, match_case: bool = False) -> Iterator[int]:
    """Indices of the points whose note holds a text."""
    wanted = text if match_case else text.casefold()
    for index, point in enumerate(points):
        if wanted in (point.note if match_case else point.note.casefold()):
            yield index


def find_figure(points: Sequence[Waypoint], query: FigureQuery) -> Iterator[int]:
    """Indices of the points where a figure has a value."""
    for index, point in enumerate(points):
        value = _figure(point, query.field)
        if value is not None and abs(value - query.value) <= query.tolerance:
            yield index


def replace_text(point: Waypoint, text: str, by: str) -> Waypoint | Refusal:
    """A point with a text of its note replaced, letter by letter as given."""
    changed = replace(point, note=point.note.replace(text, by))
    return check_point(changed) or changed


def replace_figure(point: Waypoint, field: str, value: float) -> Waypoint | Refusal:
    """A point with one figure replaced; a point without such a figure stays as it is."""
    refusal = check_figure(field, value)
    if refusal is not None:
        return refusal
    if field == "speed":
        return replace(point, speed_percent=int(value))
    if field == "dwell":
        return replace(point, dwell_s=value)
    if field not in point.names:
        return point
    target = list(point.target)
    target[point.names.index(field)] = value
    return replace(point, target=tuple(target))


def _figure(point: Waypoint, field: str) -> float | None:
    if field == "speed":
        return point.speed_percent
    if field == "dwell":
        return point.dwell_s
    return point.target[point.names.index(field)] if field in point.names else None
