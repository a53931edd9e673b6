"""The maker's recorded CSV: no titles; `wait_s, j1 … j6` in rad, perhaps the gripper in m.

The wait of a row is the time since the row before it.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from armui.arm.refusal_codes import RefusalCode
from armui.trajectory.files import csv_file
from armui.trajectory.files.errors import broken
from armui.trajectory.files.model import Content, verified
from armui.trajectory.files.text import parse_number
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Recording

_COUNTS: Final = (GRIPPER, COLUMN_COUNT)
_STEP_DIGITS: Final = 6


def is_maker_csv(text: str) -> bool:
    """Whether the first row holds 7 or 8 numbers and nothing else."""
    first = text.lstrip().partition("\n")[0].split(",")
    try:
        return len(first) in _COUNTS and all(math.isfinite(float(cell)) for cell in first)
    except ValueError:
        return False


def read(text: str, name: str) -> Content:
    """The recording of a text.

    Raises:
        TrajectoryFileError: With the line and, as column, the cell.
    """
    rows: list[list[float]] = []
    lines: list[int] = []
    for line, cells in csv_file.rows(text):
        if len(cells) not in _COUNTS:
            raise broken(RefusalCode.CELLS_COUNT, line, value=len(cells), expected="7 / 8")
        row = [parse_number(cell, line, column) for column, cell in enumerate(cells, start=1)]
        rows.append(row if len(row) == COLUMN_COUNT else [*row, math.nan])
        lines.append(line)
    raw = np.array(rows, dtype=np.float64).reshape(-1, COLUMN_COUNT)
    samples = np.empty_like(raw)
    samples[:, 0] = np.round(np.cumsum(raw[:, 0]) - raw[:1, 0].sum(), _STEP_DIGITS)
    samples[:, 1:GRIPPER] = np.degrees(raw[:, 1:GRIPPER])
    samples[:, GRIPPER] = 1e3 * raw[:, GRIPPER]
    return verified(Recording(name, samples=samples), lines)
