"""The table as a Parquet file, if the package pyarrow is installed."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any, BinaryIO, Final

import numpy as np

from armui.session.exports.export_columns import ExportColumn, RowTimes, TableColumns, table_rows

if TYPE_CHECKING:
    from armui.session.exports.history import ExportFacts, History, TimeSpan

_GROUP_ROWS: Final = 20_000
"""The rows that are collected and written together: some 20 MB."""
_TIMES: Final = (("time", "as recorded"), ("since_start", "since the log's first frame"))


class ParquetTable:
    """Writes the rows in groups; units are in the metadata of the columns.

    Args:
        stream: The output.
        facts: The facts on the recorded arm.

    Attributes:
        items: The number of rows so far.

    Raises:
        ImportError: pyarrow is not installed.
    """

    def __init__(self, stream: BinaryIO, facts: ExportFacts) -> None:
        import pyarrow as pa  # noqa: PLC0415 - optional
        from pyarrow import parquet  # noqa: PLC0415 - optional

        self._arrow = pa
        self._start_s = facts.start_s
        self._table = TableColumns(facts.codec)
        fields = [
            pa.field(name, pa.float64(), nullable=False, metadata={"unit": "s", "about": about})
            for name, about in _TIMES
        ]
        fields += [
            pa.field(each.name, _type(pa, each), metadata={"unit": each.unit})
            for each in self._table.columns
        ]
        self._schema = pa.schema(fields, metadata=dict(facts.notes))
        self._writer = parquet.ParquetWriter(stream, self._schema, compression="zstd")
        self._waiting: list[Any] = []
        self._waiting_rows = 0
        self.items = 0

    def write_span(self, history: History, span: TimeSpan) -> None:
        """Write the rows of a piece of the log; see `Sink`."""
        rows = table_rows(history, span)
        if rows is None:
            return
        self._waiting.append(self._batch(history, rows))
        self._waiting_rows += len(rows.rows)
        self.items += len(rows.rows)
        if self._waiting_rows >= _GROUP_ROWS:
            self._write_group()

    def finish(self) -> None:
        """Write the remaining rows and the end of the file."""
        if self._waiting:
            self._write_group()
        self._writer.close()

    def abandon(self) -> None:
        """Close the writer, which would else write to the file when it is garbage-collected."""
        with contextlib.suppress(Exception):
            self._writer.close()
        self._writer.is_open = False

    def _write_group(self) -> None:
        table = self._arrow.Table.from_batches(self._waiting, self._schema)
        self._writer.write_table(table, row_group_size=self._waiting_rows)
        self._waiting.clear()
        self._waiting_rows = 0

    def _batch(self, history: History, rows: RowTimes) -> Any:
        pa = self._arrow
        arrays = [pa.array(rows.times_s), pa.array(np.round(rows.times_s - self._start_s, 6))]
        for record in self._table.records:
            told = record.told_at(history, rows.rows, rows.times_s)
            for column in record.columns:
                kind = _type(pa, column)
                if told is None:
                    arrays.append(pa.nulls(len(rows.rows), kind))
                    continue
                samples, which = told
                values = column.values(samples)[which]
                arrays.append(pa.array(values, kind, mask=np.asarray(which < 0)))
        return pa.record_batch(arrays, schema=self._schema)


def _type(pa: Any, column: ExportColumn) -> Any:
    return pa.int32() if column.whole else pa.float64()
