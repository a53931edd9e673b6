"""A recording in progress: frames go into a queue, and a thread writes them to the disk."""

from __future__ import annotations

import logging
import threading
import time
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Final

from armui.session.recording.rows import FrameRows, joined
from armui.session.recording.sidecar import Line
from armui.session.recording.writer import RecordingPlan, RecordingWriter
from armui.system.clock import steady_s

_LOG: Final = logging.getLogger(__name__)

_ROWS_OF_A_BLOCK: Final = 3_000
BLOCK_S: Final = 0.25
"""The period of writing: a killed program loses no more than this, and the frames in the queue."""
MOST_WAITING: Final = 400_000
"""The most frames that may wait for a busy disk: over two minutes of a full bus, 9 MB."""


class SessionRecording:
    """Records frames from any thread, without ever blocking it.

    It begins at once; a folder that cannot be written shows as `failure`.

    Args:
        plan: The plan of the recording.
        clock: The program's, in seconds.
        most_waiting: The most waiting frames; further ones are dropped and counted.

    Attributes:
        plan: As given.
        begun_s: The time of its beginning, by the program's clock.
        lost: The number of frames lost because the disk was too slow.
        failure: The error that ended it early, or ``None``.
    """

    def __init__(
        self,
        plan: RecordingPlan,
        clock: Callable[[], float] = steady_s,
        most_waiting: int = MOST_WAITING,
    ) -> None:
        self.plan = plan
        self.begun_s = plan.base.steady_s
        self._clock = clock
        self._most_waiting = most_waiting
        self._rows: deque[FrameRows] = deque()
        self._lines: deque[Line] = deque()
        self._waiting = 0
        self._lock = threading.Lock()
        self._ending = threading.Event()
        self._urgent = threading.Event()
        self._end_facts: Mapping[str, object] = {}
        self._lost_told = 0
        self.lost = 0
        self.failure: Exception | None = None
        self._writer: RecordingWriter | None = None
        self._thread = threading.Thread(target=self._run, name="armui-recording", daemon=True)
        self._thread.start()

    @property
    def running(self) -> bool:
        """True if it is still being written."""
        return self._thread.is_alive()

    @property
    def name(self) -> str | None:
        """The recording's name; ``None`` until its folder was found writable."""
        return None if self._writer is None else self._writer.name

    @property
    def path(self) -> Path | None:
        """The path of its first file, which may not exist yet; ``None`` likewise."""
        return None if self._writer is None else self._writer.path

    @property
    def frames(self) -> int:
        """The number of frames written so far."""
        return 0 if self._writer is None else self._writer.frames

    @property
    def total_bytes(self) -> int:
        """The bytes written so far."""
        return 0 if self._writer is None else self._writer.total_bytes

    def put(self, rows: FrameRows) -> None:
        """Record frames in the order of time; those from before the beginning are left out."""
        if self.failure is not None:
            return
        rows = rows.part(int(rows.times_s.searchsorted(self.begun_s)), len(rows))
        with self._lock:
            if self._waiting + len(rows) > self._most_waiting:
                self.lost += len(rows)
                return
            self._waiting += len(rows)
            self._rows.append(rows)

    def note(self, line: Line) -> None:
        """Add a line to the sidecar."""
        self._lines.append(line)

    def end(self, facts: Mapping[str, object]) -> None:
        """End the recording properly in the background; see `wait`.

        Args:
            facts: For the last line of the sidecar.
        """
        self._end_facts = facts
        self._ending.set()
        self._urgent.set()

    def wait(self, within_s: float) -> bool:
        """Wait up to a time, and return whether the recording has ended."""
        self._thread.join(within_s)
        return not self._thread.is_alive()

    def _run(self) -> None:
        try:
            writer = self._writer = RecordingWriter(self.plan, self._clock)
        except OSError as error:
            self.failure = error
            return
        try:
            due_s = time.monotonic() + BLOCK_S
            while not self._ending.is_set():
                self._urgent.wait(max(0.0, due_s - time.monotonic()))
                due_s = time.monotonic() + BLOCK_S  # set before writing, which takes time, too
                self._write(writer)
            self._write(writer)
        except Exception as error:  # noqa: BLE001 - any error: the written part stays readable
            self.failure = error
            if not isinstance(error, OSError):
                _LOG.exception("A recording has failed")
        facts: dict[str, object] = {"lost": self.lost, **self._end_facts}
        if self.failure is not None:
            facts["failure"] = str(self.failure)
        writer.finish(facts)

    def _write(self, writer: RecordingWriter) -> None:
        with self._lock:
            parts, waiting = list(self._rows), self._waiting
            self._rows.clear()
        lines: list[Line] = []
        while self._lines:
            lines.append(self._lines.popleft())
        if self.lost > self._lost_told:
            count, self._lost_told = self.lost - self._lost_told, self.lost
            at_s = self._clock() + self.plan.base.shift_s
            lines.append({"kind": "lost", "time_s": at_s, "count": count})
        try:
            writer.write(joined(parts), lines)
        finally:
            with self._lock:
                self._waiting -= waiting


def write_at_once(
    plan: RecordingPlan,
    parts: Sequence[FrameRows],
    lines: Sequence[Line],
    facts: Mapping[str, object],
    clock: Callable[[], float] = steady_s,
) -> Path:
    """Write frames in memory as a recording of its own, block by block.

    Args:
        plan: The plan of the recording.
        parts: Frames in the order of time.
        lines: The sidecar's lines on this time.
        facts: For the last line of the sidecar.
        clock: The program's, in seconds.

    Returns:
        The first file.

    Raises:
        OSError: It could not be written; the part written is intact.
    """
    writer = RecordingWriter(plan, clock)
    failure: dict[str, object] = {}
    try:
        for rows in parts:
            for begin in range(0, len(rows), _ROWS_OF_A_BLOCK):
                writer.write(rows.part(begin, begin + _ROWS_OF_A_BLOCK))
                time.sleep(0)  # releases the GIL, so that other threads are not held up
        writer.write(joined([]), lines)
    except OSError as error:
        failure = {"failure": str(error)}
        raise
    finally:
        writer.finish({**facts, **failure})
    return writer.path
