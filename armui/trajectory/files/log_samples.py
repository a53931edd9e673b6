"""The samples of a recording in our text format: time, six angles and perhaps the gripper."""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from armui.arm.refusal_codes import RefusalCode
from armui.trajectory.files.errors import broken
from armui.trajectory.files.figures import read_figures
from armui.trajectory.files.model import Content, verified
from armui.trajectory.files.text import number, parse_number
from armui.trajectory.samples.recording import COLUMN_COUNT, GRIPPER, Array, Recording

_TITLES: Final = "# t_s J1 J2 J3 J4 J5 J6 (deg) gripper_mm"


def write_samples(samples: Array) -> str:
    """Lines of samples; the gripper is left out where it was not recorded."""
    lines = [_TITLES]
    for row in samples.tolist():
        values = row[:GRIPPER] if math.isnan(row[GRIPPER]) else row
        lines.append(" ".join(map(number, values)))
    return "\n".join(lines) + "\n"


def read_samples(lines: list[str], begin: int, fields: dict[str, Any]) -> Content:
    """The recording of a text.

    Args:
        lines: Of the file.
        begin: Index of the first after the header.
        fields: What the header says.

    Raises:
        TrajectoryFileError: With line and column.
    """
    places = [place for place in range(begin, len(lines)) if _is_sample(lines[place])]
    figures = read_figures([lines[place] for place in places], None)
    if figures is not None and figures.shape[1] in (GRIPPER, COLUMN_COUNT):
        samples = np.full((len(figures), COLUMN_COUNT), np.nan)
        samples[:, : figures.shape[1]] = figures
        return verified(Recording(samples=samples, **fields), [place + 1 for place in places])
    return _read_one_by_one(lines, begin, fields)


def _is_sample(line: str) -> bool:
    text = line.lstrip()
    return bool(text) and not text.startswith("#")


def _read_one_by_one(lines: list[str], begin: int, fields: dict[str, Any]) -> Content:
    """The same where only some samples hold the gripper, or one is wrong."""
    rows: list[list[float]] = []
    numbers: list[int] = []
    for line, text in enumerate(lines[begin:], start=begin + 1):
        words = text.split()
        if not words or words[0].startswith("#"):
            continue
        if len(words) not in (GRIPPER, COLUMN_COUNT):
            raise broken(RefusalCode.VALUES_COUNT, line, 1, value=len(words), expected="7 or 8")
        try:
            row = list(map(float, words))
        except ValueError:
            row = [parse_number(word, line, text.find(word) + 1) for word in words]
        rows.append(row if len(row) == COLUMN_COUNT else [*row, math.nan])
        numbers.append(line)
    samples = np.array(rows, dtype=np.float64).reshape(-1, COLUMN_COUNT)
    return verified(Recording(samples=samples, **fields), numbers)
