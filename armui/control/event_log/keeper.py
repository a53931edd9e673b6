"""Keeps the events on the disk in a rotating file, without holding anybody up."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from datetime import datetime
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer

from armui.system.files import error_text
from armui.telemetry import event_json
from armui.telemetry.event_json import to_json

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future
    from pathlib import Path

    from armui.control.event_log.collector import EventCollector
    from armui.telemetry.events import EventEntry

_EVERY_MS: Final = 1000
_AGAIN_TICKS: Final = 30
"""A write that failed is tried again after this many seconds."""


class EventKeeper(QObject):
    """Passes new events to the thread that writes files, once a second.

    Events that cannot be written stay in the log, as far as it reaches back, and are written once
    the disk allows it. The operator is told of the failure once.

    Args:
        collector: Writes the log.
        folder: The folder of the file; it need not exist.
        files: Runs work that waits for a disk.
    """

    def __init__(self, collector: EventCollector, folder: Path, files: Executor) -> None:
        super().__init__()
        self._collector = collector
        self._folder = folder
        self._files = files
        self._run = f"{datetime.now():%Y%m%d-%H%M%S}-{os.getpid()}"
        self._kept = 0
        self._writing: tuple[Future[None], int] | None = None
        self._failing = False
        self._waits = self._silent = 0
        self._timer = QTimer(self, interval=_EVERY_MS)
        self._timer.timeout.connect(self.keep)
        self._timer.start()

    def keep(self) -> None:
        """Have new events written, unless the disk is still busy with earlier ones."""
        if self._writing is not None:
            self._look_after(*self._writing)
        if self._writing is not None:
            return
        if self._waits:
            self._waits -= 1
        else:
            self._write()

    def close(self) -> None:
        """Have the rest written; the writing thread ends later."""
        self._timer.stop()
        if self._writing is not None and self._writing[0].done():
            self._look_after(*self._writing)
        after = self._kept if self._writing is None else self._writing[1]
        _revision, entries = self._collector.log.since(after)
        if entries:
            self._files.submit(write, self._folder, self._run, entries)

    def _write(self) -> None:
        if self._collector.log.revision == self._kept:
            return
        revision, entries = self._collector.log.since(self._kept)
        future = self._files.submit(write, self._folder, self._run, entries)
        self._writing = future, revision
        if future.done():
            self._look_after(future, revision)

    def _look_after(self, future: Future[None], revision: int) -> None:
        if not future.done():
            self._silent += 1
            if self._silent > _AGAIN_TICKS and not self._failing:
                self._fail(None)
            return
        self._writing, self._silent = None, 0
        error = None if future.cancelled() else future.exception()
        if error is None:
            self._kept, self._failing, self._waits = revision, False, 0
            return
        self._waits = _AGAIN_TICKS
        if not self._failing:
            self._fail(error_text(error))

    def _fail(self, text: str | None) -> None:
        self._failing = True
        self._collector.on_not_kept(text)


def write(folder: Path, run: str, entries: Sequence[EventEntry]) -> None:
    """Append events to the file; this waits for the disk.

    Args:
        folder: The folder of the file.
        run: Names the run of the program they belong to: each begins at number 1.
        entries: The new events.

    Raises:
        OSError: The disk or the folder does not allow it.
    """
    head = f'{{"run":{json.dumps(run)},'
    event_json.append(folder, "".join(f"{head}{to_json(entry)[1:]}\n" for entry in entries))
