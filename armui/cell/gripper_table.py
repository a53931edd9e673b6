"""The gripper's openings as measured with callipers: a table, interpolated both ways.

Owners report 45 mm asked for and 38 mm opened, and a cube of 40 mm read as 50. What is asked for
and what is reported are the arm's own figures; the table leads from them to the measured ones, and
back.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from armui.arm.json_fields import Fields
from armui.arm.refusal import Reason, Refusal
from armui.cell.checks import check_figure

GRIPPER_TABLE_LONG = Reason(
    "gripper_table_long",
    "The gripper table has {value} pairs; it holds {maximum} at most. Leave some out.",
)
GRIPPER_TABLE_SHORT = Reason(
    "gripper_table_short",
    "The gripper table needs two pairs at least, so that openings between them are known.",
)
GRIPPER_TABLE_NOT_RISING = Reason(
    "gripper_table_not_rising",
    "The gripper table does not rise: {value} mm measured at {maximum} mm asked for, but "
    "{before} mm at {minimum} mm. Measure the two once more.",
)

MOST_PAIRS: Final = 8
_WIDEST_MM: Final = 200.0
_LEAST_RISE_MM: Final = 0.1
"""Two openings closer than this cannot be told apart with callipers."""

Pairs = tuple[tuple[float, float], ...]
"""Pairs of an opening asked for and the one measured, mm, rising."""


@dataclass(frozen=True, slots=True)
class GripperTable:
    """A table that holds: two pairs at least, rising.

    Attributes:
        pairs: The openings asked for and measured, mm.
    """

    pairs: Pairs

    def measured_mm(self, asked_mm: float) -> float:
        """Return the measured opening for one that is commanded or reported."""
        return _interpolated(self.pairs, asked_mm)

    def asked_mm(self, measured_mm: float) -> float:
        """Return the opening to command, so that the wanted one is measured."""
        return _interpolated([(there, asked) for asked, there in self.pairs], measured_mm)


def check_gripper_table(pairs: Sequence[tuple[float, float]], *, used: bool) -> Refusal | None:
    """Return why pairs are no table, or ``None``.

    Args:
        pairs: The openings asked for and measured, mm, by what is asked for.
        used: True if the table is applied: then two pairs are needed.
    """
    if len(pairs) > MOST_PAIRS:
        return GRIPPER_TABLE_LONG(value=len(pairs), maximum=MOST_PAIRS)
    for asked, measured in pairs:
        for field, value in (("asked_mm", asked), ("measured_mm", measured)):
            refusal = check_figure("gripper_table", field, value, 0.0, _WIDEST_MM)
            if refusal is not None:
                return refusal
    for before, after in pairwise(pairs):
        if min(b - a for a, b in zip(before, after, strict=True)) < _LEAST_RISE_MM:
            figures = {"minimum": before[0], "before": before[1]}
            return GRIPPER_TABLE_NOT_RISING(maximum=after[0], value=after[1], **figures)
    return GRIPPER_TABLE_SHORT() if used and len(pairs) < 2 else None


def to_entries(pairs: Pairs) -> list[Mapping[str, float]]:
    """Return pairs as objects of a cell's file."""
    return [{"asked_mm": asked, "measured_mm": measured} for asked, measured in pairs]


def from_entries(entries: Iterable[Fields]) -> Pairs:
    """Return the pairs in objects of a cell's file.

    Raises:
        FieldError: A field is missing, unknown or of another type.
    """
    pairs = []
    for fields in entries:
        pairs.append((fields.number("asked_mm"), fields.number("measured_mm")))
        fields.nothing_else()
    return tuple(pairs)


def _interpolated(pairs: Sequence[tuple[float, float]], value: float) -> float:
    """Return the interpolated figure; beyond the ends the last piece is extended."""
    pieces = list(pairwise(pairs))
    (x, y), (x2, y2) = next((piece for piece in pieces if value <= piece[1][0]), pieces[-1])
    return y + (value - x) * (y2 - y) / (x2 - x)
