"""A CSV file for each message: every frame of it, as decoded signals."""

from __future__ import annotations

import contextlib
import os
from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from armui.session.exports.csv_table import BOM, TIME_TITLES
from armui.system.files import open_file

if TYPE_CHECKING:
    from pathlib import Path

    from armui.protocol.layout import MessageLayout, SignalLayout
    from armui.session.exports.history import History, Samples
    from armui.session.exports.sink import ExportFacts, TimeSpan


class CsvMessages:
    """Writes the frames as they come.

    Args:
        folder: Where the files go; it exists, and is empty.
        facts: Of the recorded arm.

    Attributes:
        items: Rows written so far, of all files together.
    """

    def __init__(self, folder: Path, facts: ExportFacts) -> None:
        self._folder = folder
        self._start_s = facts.start_s
        self._files: dict[str, BinaryIO] = {}
        self.items = 0

    def take(self, history: History, span: TimeSpan) -> None:
        """Write what a piece of the log adds, see `Sink`."""
        for samples in history.heard():
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
        """The file of a message, begun with its first frame."""
        file = self._files.get(layout.name)
        if file is None:
            path = self._folder / f"{layout.arbitration_id:03X}_{layout.name}.csv"
            file = self._files[layout.name] = open_file(path, "xb")
            titles = (*TIME_TITLES, *map(_title, layout.signals.values()))
            file.write(BOM + ",".join(titles).encode() + b"\r\n")
        return file

    def finish(self) -> None:
        """Bring them to the disk.

        Raises:
            OSError: It does not take them.
        """
        for file in self._files.values():
            file.flush()
            os.fsync(file.fileno())
            file.close()

    def abandon(self) -> None:
        """Close them; their folder is removed by whoever made it."""
        for file in self._files.values():
            with contextlib.suppress(OSError):
                file.close()


def _title(signal: SignalLayout) -> str:
    return f"{signal.name} [{signal.unit}]" if signal.unit else signal.name


def _template(signal: SignalLayout) -> str:
    """Raw values and those divided by a whole number are exact in few digits."""
    if not signal.is_scaled:
        return "%d"
    return "%s" if signal.divisor is not None and not signal.offset else "%.10g"
