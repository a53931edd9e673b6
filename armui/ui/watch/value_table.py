"""The samples of some quantities as a table in a CSV file: pure, for another thread or process.

There is a row for each millisecond with any sample; cells without a sample are empty.
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.system.atomic import WholeFile

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.telemetry.store import Telemetry

_PER_S: Final = 1000
_CHUNK: Final = 4096


@dataclass(frozen=True, slots=True)
class Column:
    """One quantity.

    Attributes:
        title: The name and unit.
        times_s: Monotonic times of its samples.
        figures: Its values; NaN if not reported.
    """

    title: str
    times_s: NDArray[np.float64]
    figures: NDArray[Any]


def columns(
    telemetry: Telemetry, titles: Sequence[tuple[str, str]], begin_s: float, end_s: float
) -> list[Column]:
    """Return the samples of a stretch of time.

    Args:
        telemetry: The series.
        titles: For each quantity its key and its title.
        begin_s: Monotonic time of the beginning.
        end_s: Monotonic time of the end.
    """
    samples: dict[str, NDArray[Any]] = {}
    made = []
    for key, title in titles:
        quantity, series = telemetry.find(key)
        if quantity.series not in samples:
            samples[quantity.series] = series.samples(begin_s, end_s)
        of_it = samples[quantity.series]
        made.append(Column(title, of_it["time_s"].copy(), of_it[quantity.field].copy()))
    return made


def write_csv(path: Path, table: Sequence[Column], edge_s: float, edge: datetime) -> int:
    """Write a table, replacing an existing file in one step.

    Args:
        path: The file.
        table: The table.
        edge_s: The monotonic time from which the column ``t_s`` counts.
        edge: The time of day then.

    Returns:
        The number of rows.

    Raises:
        OSError: The disk or the folder does not allow it.
    """
    stamps = [np.round((each.times_s - edge_s) * _PER_S).astype(np.int64) for each in table]
    rows = np.unique(np.concatenate(stamps)) if stamps else np.empty(0, np.int64)
    places = [np.searchsorted(rows, each) for each in stamps]
    titles = [f'"{each.title.replace(chr(34), chr(39))}"' for each in table]
    with WholeFile(path) as whole:
        # the byte order mark: without it spreadsheets assume another encoding
        file = io.TextIOWrapper(whole.stream, "utf-8-sig", newline="")
        file.write(",".join(["time", "t_s", *titles]) + "\r\n")
        for begin in range(0, rows.size, _CHUNK):
            file.write(_chunk(rows[begin : begin + _CHUNK], begin, table, places, edge))
        file.flush()
        whole.finish()
    return int(rows.size)


def _chunk(
    rows: NDArray[np.int64],
    begin: int,
    table: Sequence[Column],
    places: Sequence[NDArray[np.intp]],
    edge: datetime,
) -> str:
    cells = np.full((rows.size, len(table) + 2), "", dtype=object)
    for row, stamp in enumerate(rows.tolist()):
        at = edge + timedelta(milliseconds=stamp)
        cells[row, 0] = at.isoformat(sep=" ", timespec="milliseconds")
        cells[row, 1] = f"{stamp / _PER_S:.3f}"
    for number, (column, where) in enumerate(zip(table, places, strict=True), 2):
        first, behind = np.searchsorted(where, (begin, begin + rows.size))
        for place, figure in zip(
            where[first:behind].tolist(), column.figures[first:behind].tolist(), strict=True
        ):
            if figure == figure:  # noqa: PLR0124 - not NaN
                cells[place - begin, number] = f"{figure:.7g}"
    return "".join(",".join(row) + "\r\n" for row in cells.tolist())
