"""CSV: one table of everything, or a file for each message with every frame decoded."""

from __future__ import annotations

import contextlib
import os
from operator import itemgetter
from typing import TYPE_CHECKING, BinaryIO, Final

import numpy as np

from armui.session.exports.export_columns import RecordColumns, TableColumns, table_rows, titled
from armui.system.files import open_file

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from armui.protocol.layout import MessageLayout, SignalLayout
    from armui.session.exports.history import ExportFacts, History, Samples, TimeSpan

BOM: Final = b"\xef\xbb\xbf"
"""The byte order mark, without which spreadsheets take the encoding for another one."""
TIME_TITLES: Final = ("time [s]", "since_start [s]")


class CsvTable:
    """Writes the table's rows as they come.

    Args:
        stream: The output.
        facts: The facts on the recorded arm.

    Attributes:
        items: Rows written so far.
    """

    def __init__(self, stream: BinaryIO, facts: ExportFacts) -> None:
        self._stream = stream
        self._start_s = facts.start_s
        self._records = TableColumns(facts.codec).records
        self._templates = {each.message: _table_template(each) for each in self._records}
        self.items = 0
        titles = [titled(column) for record in self._records for column in record.columns]
        self._stream.write(BOM + ",".join((*TIME_TITLES, *titles)).encode() + b"\r\n")

    def write_span(self, history: History, span: TimeSpan) -> None:
        """Write the rows of a piece of the log; see `Sink`."""
        table = table_rows(history, span)
        if table is None:
            return
        since = table.times_s - self._start_s
        times = zip(table.times_s.tolist(), since.tolist(), strict=True)
        columns: list[Sequence[str]] = [[f"{at_s:.6f},{t_s:.6f}" for at_s, t_s in times]]
        for record in self._records:
            empty = "," * (len(record.columns) - 1)
            told = record.told_at(history, table.rows, table.times_s)
            if told is None:
                columns.append([empty] * len(table.rows))
                continue
            samples, which = told
            texts = [*self._texts(record, samples), empty]  # for -1, "not heard"
            picked = itemgetter(*which.tolist())(texts)
            columns.append((picked,) if len(which) == 1 else picked)
        lines = map(",".join, zip(*columns, strict=True))
        self._stream.write(("\r\n".join(lines) + "\r\n").encode())
        self.items += len(table.rows)

    def finish(self) -> None:
        """Do nothing: a CSV file has no end part."""

    def abandon(self) -> None:
        """Do nothing: no file is held."""

    def _texts(self, record: RecordColumns, samples: Samples) -> list[str]:
        """Return the text of a message's cells for each of its samples.

        A figure that a sample lacks is blank, as the angle of a gripper that reports its opening.
        """
        template = self._templates[record.message]
        values = [column.values(samples).tolist() for column in record.columns]
        return [(template % figures).replace("nan", "") for figures in zip(*values, strict=True)]


def _table_template(record: RecordColumns) -> str:
    """Return the format of a row; only figures turned into degrees need to be rounded."""
    return ",".join(
        "%d" if column.whole else "%s" if column.factor == 1.0 else "%.10g"
        for column in record.columns
    )


class CsvMessages:
    """Writes the frames of each message to a file of its own.

    Args:
        folder: The folder for the files; it exists and is empty.
        facts: The facts on the recorded arm.

    Attributes:
        items: Rows written so far, of all files together.
    """

    def __init__(self, folder: Path, facts: ExportFacts) -> None:
        self._folder = folder
        self._start_s = facts.start_s
        self._files: dict[str, BinaryIO] = {}
        self.items = 0

    def write_span(self, history: History, span: TimeSpan) -> None:
        """Write the frames of a piece of the log; see `Sink`."""
        for samples in history.all_samples():
            self._write(samples, span)

    def _write(self, samples: Samples, span: TimeSpan) -> None:
        inside = span.holds(samples.times_s)
        inside[: samples.old] = False
        if not inside.any():
            return
        times_s, signals = samples.times_s[inside], samples.layout.signals.values()
        columns = [times_s.tolist(), (times_s - self._start_s).tolist()]
        columns += [samples.column(each.name)[inside].tolist() for each in signals]
        template = ",".join(("%.6f", "%.6f", *map(_template, signals)))
        lines = [template % row for row in zip(*columns, strict=True)]
        self._file(samples.layout).write(("\r\n".join(lines) + "\r\n").encode())
        self.items += int(np.count_nonzero(inside))

    def _file(self, layout: MessageLayout) -> BinaryIO:
        """Return the file of a message, begun with its first frame."""
        file = self._files.get(layout.name)
        if file is None:
            path = self._folder / f"{layout.arbitration_id:03X}_{layout.name}.csv"
            file = self._files[layout.name] = open_file(path, "xb")
            titles = (*TIME_TITLES, *map(titled, layout.signals.values()))
            file.write(BOM + ",".join(titles).encode() + b"\r\n")
        return file

    def finish(self) -> None:
        """Write the files to the disk and close them.

        Raises:
            OSError: The disk does not take them.
        """
        for file in self._files.values():
            file.flush()
            os.fsync(file.fileno())
            file.close()

    def abandon(self) -> None:
        """Close the files; their folder is removed by its creator."""
        for file in self._files.values():
            with contextlib.suppress(OSError):
                file.close()


def _template(signal: SignalLayout) -> str:
    """Return the format of a signal; raw and evenly divided values are exact as they are."""
    if not signal.is_scaled:
        return "%d"
    return "%s" if signal.divisor is not None and not signal.offset else "%.10g"
