"""The table as CSV."""

from __future__ import annotations

from operator import itemgetter
from typing import TYPE_CHECKING, BinaryIO, Final

from armui.session.exports.columns import RecordColumns, TableColumns
from armui.session.exports.table import table_rows

if TYPE_CHECKING:
    from collections.abc import Sequence

    from armui.session.exports.history import History, Samples
    from armui.session.exports.sink import ExportFacts, TimeSpan

BOM: Final = b"\xef\xbb\xbf"
"""The mark of the encoding: spreadsheets take it for something else otherwise."""
TIME_TITLES: Final = ("time [s]", "since_start [s]")


class CsvTable:
    """Writes the rows as they come.

    Args:
        stream: Where to.
        facts: Of the recorded arm.

    Attributes:
        items: Rows written so far.
    """

    def __init__(self, stream: BinaryIO, facts: ExportFacts) -> None:
        self._stream = stream
        self._start_s = facts.start_s
        self._records = TableColumns(facts.codec).records
        self._templates = {each.message: _template(each) for each in self._records}
        self.items = 0
        titles = [column.title for record in self._records for column in record.columns]
        self._stream.write(BOM + ",".join((*TIME_TITLES, *titles)).encode() + b"\r\n")

    def take(self, history: History, span: TimeSpan) -> None:
        """Write what a piece of the log adds, see `Sink`."""
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
            texts = [*self._texts(record, samples), empty]  # the last one stands at -1
            picked = itemgetter(*which.tolist())(texts)
            columns.append((picked,) if len(which) == 1 else picked)
        lines = map(",".join, zip(*columns, strict=True))
        self._stream.write(("\r\n".join(lines) + "\r\n").encode())
        self.items += len(table.rows)

    def finish(self) -> None:
        """Nothing more is to come."""

    def abandon(self) -> None:
        """Nothing is held."""

    def _texts(self, record: RecordColumns, samples: Samples) -> list[str]:
        """What stands in the columns of a message, for each of its samples."""
        template = self._templates[record.message]
        values = [column.values(samples).tolist() for column in record.columns]
        return [template % figures for figures in zip(*values, strict=True)]


def _template(record: RecordColumns) -> str:
    """Figures as the arm sent them are whole in few digits; those turned into degrees are cut."""
    return ",".join(
        "%d" if column.whole else "%s" if column.factor == 1.0 else "%.10g"
        for column in record.columns
    )
