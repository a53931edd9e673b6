"""Reads a table by a mapping, into a recording over time or a trajectory through its rows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

import numpy as np

from armui.arm.refusal import Reason, Refusal
from armui.protocol.codes import MoveMode
from armui.trajectory.columns.model import (
    JOINTS,
    POSE,
    SPACES,
    UNITS,
    ColumnMapping,
    ColumnQuantity,
    Sheet,
    as_number,
    lines_from,
    table,
)
from armui.trajectory.files.csv_file import CELLS_COUNT
from armui.trajectory.files.errors import broken
from armui.trajectory.files.model import Content, verified, verified_point
from armui.trajectory.files.text import NUMBER_BAD, read_figures
from armui.trajectory.planning.tool_points import ToolPoints
from armui.trajectory.points.program import GripperOpening, Trajectory, Waypoint
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Array, Recording

COLUMNS_TWICE = Reason(
    "columns_twice", "Columns {first} and {second} are both {field}. Leave one of them out."
)
COLUMNS_UNIT = Reason(
    "columns_unit", "Column {column}: {field} is not given in “{value}”. Choose one of {choices}."
)
COLUMNS_MISSING = Reason(
    "columns_missing", "Still missing: {missing}. Say which columns hold them."
)


_TIME_DIGITS: Final = 6
"""The decimals of seconds, so that a sum of waits does not drift by rounding."""

_MAY_BE_EMPTY: Final = (ColumnQuantity.GRIPPER, ColumnQuantity.SPEED, ColumnQuantity.DWELL)


def check_mapping(mapping: ColumnMapping) -> Refusal | None:
    """Return why a mapping is incomplete or ambiguous, or ``None`` if it is fine."""
    columns: dict[ColumnQuantity, int] = {}
    for number, column in enumerate(mapping.columns, start=1):
        if column is None:
            continue
        quantity, unit = column
        if quantity in columns:
            first = columns[quantity]
            return COLUMNS_TWICE(first=first, second=number, field=str(quantity))
        if unit not in UNITS[quantity]:
            choices = ", ".join(UNITS[quantity])
            return COLUMNS_UNIT(column=number, field=str(quantity), value=unit, choices=choices)
        columns[quantity] = number
    needed = POSE if mapping.move in (MoveMode.MOVE_P, MoveMode.MOVE_L) else JOINTS
    missing = [str(quantity) for quantity in needed if quantity not in columns]
    timed = ColumnQuantity.TIME in columns or ColumnQuantity.WAIT in columns
    if mapping.move is None and not timed:
        missing.insert(0, str(ColumnQuantity.TIME))
    return COLUMNS_MISSING(missing=", ".join(missing)) if missing else None


def apply(text: str, sheet: Sheet, mapping: ColumnMapping, name: str) -> Content:
    """Return a recording or trajectory from a table.

    Args:
        text: The text of the whole file.
        sheet: The table's dialect and columns.
        mapping: The meaning of the columns.
        name: The name of the result.

    Raises:
        TrajectoryFileError: A row does not fit, with the line and, as column, the cell.
        ValueError: The mapping is not possible; see `check_mapping`.
    """
    reason = check_mapping(mapping)
    if reason is not None:
        raise ValueError(str(reason))
    if len(mapping.columns) != sheet.width:
        raise ValueError(f"{len(mapping.columns)} columns mapped of {sheet.width}")
    places = {
        column.quantity: place for place, column in enumerate(mapping.columns) if column is not None
    }
    note = places.pop(ColumnQuantity.NOTE, None)
    values, notes, lines = _read(text, sheet, places, note)
    for index, place in enumerate(places.values()):
        column = mapping.columns[place]
        if column is not None:
            values[:, index] *= UNITS[column.quantity][column.unit]
    found = {quantity: values[:, index] for index, quantity in enumerate(places)}
    if mapping.move is None:
        return verified(Recording(name, samples=_samples(found)), lines)
    points = _points(found, notes, lines, mapping)
    return verified(Trajectory(name, points=points), lines)


def _read(
    text: str, sheet: Sheet, places: dict[ColumnQuantity, int], note: int | None
) -> tuple[Array, list[str], list[int]]:
    """Return the figures (n, len(places)) of the rows, their notes, and the line of each."""
    wanted = list(places.values())
    if note is None and sheet.decimal == "." and '"' not in text:
        numbered = list(lines_from(text, sheet.first_line))
        delimiter = None if sheet.delimiter == SPACES else sheet.delimiter
        table_figures = read_figures([line for _, line in numbered], delimiter)
        if table_figures is not None and table_figures.shape[1] == sheet.width:
            return table_figures[:, wanted], [], [number for number, _ in numbered]
    return _read_one_by_one(text, sheet, places, note)


def _read_one_by_one(
    text: str, sheet: Sheet, places: dict[ColumnQuantity, int], note: int | None
) -> tuple[Array, list[str], list[int]]:
    """Return the same as `_read`, cell by cell: some hold texts or nothing, or one is wrong."""
    wanted = list(places.values())
    plain = sheet.decimal == "." and "_" not in text  # Python accepts "_" in numbers
    figures: list[list[float]] = []
    notes: list[str] = []
    lines: list[int] = []
    for line, cells in table(text, sheet.delimiter, sheet.first_line):
        if len(cells) < sheet.width or any(map(str.strip, cells[sheet.width :])):
            raise broken(CELLS_COUNT, line, value=len(cells), expected=sheet.width)
        try:
            row = [float(cells[place]) for place in wanted] if plain else None
        except ValueError:
            row = None
        if row is None:
            row = [_figure(cells[place], sheet, line, places, place) for place in wanted]
        figures.append(row)
        lines.append(line)
        if note is not None:
            notes.append(cells[note].strip())
    return np.array(figures, dtype=np.float64).reshape(-1, len(wanted)), notes, lines


def _figure(
    cell: str, sheet: Sheet, line: int, places: dict[ColumnQuantity, int], place: int
) -> float:
    """Return the number of a cell; NaN for an empty one where none is needed."""
    if not cell.strip() and any(places.get(quantity) == place for quantity in _MAY_BE_EMPTY):
        return math.nan
    value = as_number(cell, sheet.decimal)
    if value is None or not math.isfinite(value):
        raise broken(NUMBER_BAD, line, place + 1, value=cell)
    return value


def _samples(found: dict[ColumnQuantity, Array]) -> Array:
    """Return samples (n, 8) as `Recording` needs them, with times from 0 s."""
    count = len(found[ColumnQuantity.J1])
    samples = np.full((count, COLUMN_COUNT), np.nan)
    times = found.get(ColumnQuantity.TIME)
    if times is None:
        times = np.cumsum(found[ColumnQuantity.WAIT])
    samples[:, 0] = np.round(times - times[:1].sum(), _TIME_DIGITS)
    samples[:, 1:GRIPPER] = np.column_stack([found[joint] for joint in JOINTS])
    if ColumnQuantity.GRIPPER in found:
        samples[:, GRIPPER] = found[ColumnQuantity.GRIPPER]
    return samples


def _points(
    found: dict[ColumnQuantity, Array],
    notes: Sequence[str],
    lines: Sequence[int],
    mapping: ColumnMapping,
) -> tuple[Waypoint, ...]:
    move = MoveMode.MOVE_J if mapping.move is None else mapping.move  # not `or`: MOVE P is 0
    targets = np.column_stack([found[name] for name in (JOINTS if move.name == "MOVE_J" else POSE)])
    empty = np.full(len(targets), np.nan)
    options = (found.get(name, empty).tolist() for name in _MAY_BE_EMPTY)
    points: list[Waypoint] = []
    for index, (target, opening, speed, dwell) in enumerate(
        zip(targets.tolist(), *options, strict=True)
    ):
        percent = mapping.speed_percent if math.isnan(speed) else speed
        point = Waypoint(
            move,
            tuple(target),
            # The check reports a speed that is no whole number.
            speed_percent=int(percent) if percent == int(percent) else percent,
            dwell_s=0.0 if math.isnan(dwell) else dwell,
            gripper=None if math.isnan(opening) else GripperOpening(opening),
            note=notes[index] if notes else "",
            frame="" if move is MoveMode.MOVE_J else mapping.frame,
        )
        points.append(verified_point(point, lines[index]))
    return tuple(ToolPoints(mapping.tool).all_kept(points))
