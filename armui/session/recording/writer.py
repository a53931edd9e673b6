"""Writes one recording: its files, its index, its sidecar; intact after every block."""

from __future__ import annotations

import contextlib
import errno
import os
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Final

from armui import __version__
from armui.session.recording import index_file, sidecar
from armui.session.recording.formats import block_format
from armui.session.recording.index_file import Block, StandingFrames
from armui.session.recording.kinds import BlockFormat, RecordingFormat, file_name
from armui.session.recording.rows import FrameRows
from armui.session.recording.sidecar import Line
from armui.system.clock import steady_s
from armui.system.files import open_file

# A file that only grows, by whole pieces: one that does not fit leaves no trace.

_TO_DISK_S: Final = 5.0
"""The period of syncing to the disk: a power cut loses no more."""


class DiskFile:
    """A new file open for writing; no existing file is ever changed.

    Args:
        path: The file; it must not exist.

    Attributes:
        path: As given.
        size: Its size in bytes.

    Raises:
        FileExistsError: There is one of this name.
        OSError: It cannot be made.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.size = 0
        self._file = open_file(path, "xb")
        self._handle = self._file.fileno()  # unbuffered: a killed program loses no bytes
        self._to_disk_s = time.monotonic()
        self._syncing: threading.Thread | None = None
        self._sync_error: OSError | None = None

    def append(self, data: bytes) -> None:
        """Append bytes.

        Raises:
            OSError: It was not written, or only partly: then the part is removed.
        """
        try:
            self._check_there()
            self._write(data)
        except OSError:
            with contextlib.suppress(OSError):
                os.ftruncate(self._handle, self.size)
                os.lseek(self._handle, self.size, os.SEEK_SET)
            raise
        self.size += len(data)

    def rewrite(self, data: bytes) -> None:
        """Overwrite the beginning of the file.

        Raises:
            OSError: It was not written.
        """
        os.lseek(self._handle, 0, os.SEEK_SET)
        try:
            self._write(data)
        finally:
            os.lseek(self._handle, self.size, os.SEEK_SET)

    def to_disk(self, *, now: bool = False) -> None:
        """Have the system sync the file to the disk now and then, or wait for that now.

        Raises:
            OSError: The disk has failed.
        """
        if now:
            os.fsync(self._handle)
        elif time.monotonic() - self._to_disk_s >= _TO_DISK_S:
            self.begin_to_disk()
        error, self._sync_error = self._sync_error, None
        if error is not None:
            raise error

    def begin_to_disk(self) -> None:
        """Have the system sync the file to the disk; later writes do not wait for it.

        On a busy disk that takes seconds; frames that waited for it would be lost if the program
        were killed.

        Raises:
            OSError: There are no more handles.
        """
        if self._syncing is not None and self._syncing.is_alive():
            return
        self._to_disk_s = time.monotonic()
        same = os.dup(self._handle)  # it may be closed meanwhile
        self._syncing = threading.Thread(
            target=self._sync, args=(same,), name="armui-to-disk", daemon=True
        )
        self._syncing.start()

    def _sync(self, handle: int) -> None:
        try:
            os.fsync(handle)
        except OSError as error:
            self._sync_error = error
        finally:
            os.close(handle)

    def close(self) -> None:
        """Close the file; a disk that is gone is ignored."""
        with contextlib.suppress(OSError):
            self._file.close()

    def discard(self) -> None:
        """Close and delete the file, which is not needed after all."""
        self.close()
        with contextlib.suppress(OSError):
            self.path.unlink()

    def _write(self, data: bytes) -> None:
        left = memoryview(data)
        while left:
            left = left[os.write(self._handle, left) :]

    def _check_there(self) -> None:
        """Check that the file has not been deleted: the system would accept further bytes silently.

        Raises:
            OSError: It was deleted.
        """
        if os.fstat(self._handle).st_nlink == 0:
            raise OSError(errno.ENOENT, os.strerror(errno.ENOENT), str(self.path))


@dataclass(frozen=True, slots=True)
class TimeBase:
    """One moment by two clocks.

    Log time is the time of day counted from it, whatever happens to the time of day later.

    Attributes:
        steady_s: The time by the program's clock, that of the frames.
        unix_s: Seconds since 1970.
    """

    steady_s: float
    unix_s: float

    @property
    def shift_s(self) -> float:
        """The difference from the program's clock to log time."""
        return self.unix_s - self.steady_s


@dataclass(frozen=True, slots=True)
class RecordingPlan:
    """The plan of a recording.

    Attributes:
        folder: The folder; it is created if it does not exist.
        name: The wanted name, if it is free.
        kind: The format.
        base: Its time base.
        rotate_bytes: A file that has reached this size is followed by another.
        channel: The bus's name.
        facts: Further facts for the first line: the device, the source of the request.
    """

    folder: Path
    name: str
    kind: RecordingFormat
    base: TimeBase
    rotate_bytes: int
    channel: str = "can0"
    facts: Mapping[str, object] | None = None


_MOST_NAMES: Final = 1_000
_CLOCK_JUMP_S: Final = 1.0
"""A smaller difference between the clocks is drift, and not noted."""


class RecordingWriter:
    """Writes a recording; used by one thread.

    Args:
        plan: The plan. A name that is taken gets a number appended.
        clock: The program's, in seconds, as of the frames.
        time_of_day: The system's, in seconds since 1970.

    Attributes:
        name: Its name.
        path: Its first file, once there is one.
        frames: The number of frames written so far.
        total_bytes: The size of all its files.

    Raises:
        OSError: The folder cannot be written.
    """

    def __init__(
        self,
        plan: RecordingPlan,
        clock: Callable[[], float] = steady_s,
        time_of_day: Callable[[], float] = time.time,
    ) -> None:
        self._plan = plan
        self._clock = clock
        self._time_of_day = time_of_day
        self._file: DiskFile | None = None
        self._format: BlockFormat | None = None
        self._number = 0
        self._standing = StandingFrames()
        self._clock_off_s = 0.0
        self.frames = 0
        self._closed_bytes = 0
        plan.folder.mkdir(parents=True, exist_ok=True)
        self.name, self._sidecar = self._begin()
        try:
            self._index = self._begun(f"{self.name}{index_file.SUFFIX}", index_file.MAGIC)
        except OSError:
            self._sidecar.discard()
            raise

    @property
    def path(self) -> Path:
        """The first file with frames; there is none before the first frame."""
        return self._plan.folder / file_name(self.name, 1, self._plan.kind.value)

    @property
    def total_bytes(self) -> int:
        """The size of its files with frames."""
        return self._closed_bytes + (0 if self._file is None else self._file.size)

    def write(self, rows: FrameRows, lines: Sequence[Line] = ()) -> None:
        """Write frames as one block, and the sidecar's lines on this time.

        Args:
            rows: In the order of time, by the program's clock.
            lines: For the sidecar.

        Raises:
            OSError: They were not written; everything before is intact.
        """
        if len(rows):
            self._write_rows(rows.shifted(self._plan.base.shift_s))
        noted = [*lines, *self._clock_line()]
        if noted:
            self._sidecar.append(sidecar.as_bytes(noted))
            self._sidecar.to_disk()

    def finish(self, facts: Mapping[str, object]) -> None:
        """End the recording properly; harmless if the disk is full or gone.

        Args:
            facts: Facts for the last line: the reason, and what is missing.
        """
        end: Line = {"kind": "end", "frames": self.frames, "bytes": self.total_bytes, **facts}
        with contextlib.suppress(OSError):
            self._close_file()
        with contextlib.suppress(OSError):
            self._sidecar.append(sidecar.as_bytes([end]))
        for each in (self._file, self._index, self._sidecar):
            if each is not None:
                with contextlib.suppress(OSError):
                    each.to_disk(now=True)
                each.close()

    def _begin(self) -> tuple[str, DiskFile]:
        """Return a name that is free, taken by making its sidecar.

        Raises:
            OSError: The folder cannot be written.
        """
        plan = self._plan
        for number in count(1):
            name = plan.name if number == 1 else f"{plan.name}-{number}"
            taken = (plan.folder / file_name(name, 1, plan.kind.value)).exists()
            if taken and number < _MOST_NAMES:
                continue
            first = sidecar.as_bytes([self._first_line()])
            try:
                return name, self._begun(f"{name}{sidecar.SUFFIX}", first)
            except FileExistsError:
                if number == _MOST_NAMES:
                    raise
        raise AssertionError("count() never ends")

    def _begun(self, name: str, first: bytes) -> DiskFile:
        """Return a new file with its first bytes; it is removed if these cannot be written.

        Raises:
            OSError: It cannot be made, or not be written.
        """
        found = DiskFile(self._plan.folder / name)
        try:
            found.append(first)
        except OSError:
            found.discard()
            raise
        return found

    def _first_line(self) -> Line:
        plan = self._plan
        return {
            "kind": "session",
            "version": sidecar.VERSION,
            "program": f"armui {__version__}",
            "format": plan.kind.value,
            "channel": plan.channel,
            "unix_s": plan.base.unix_s,
            "steady_s": plan.base.steady_s,
            **(plan.facts or {}),
        }

    def _write_rows(self, rows: FrameRows) -> None:
        """Write frames with log times."""
        if self._file is not None and self._file.size >= self._plan.rotate_bytes:
            self._close_file()
            self._closed_bytes += self._file.size
            self._file.begin_to_disk()
            self._file.close()
            self._file = None
        if self._file is None or self._format is None:
            self._file, self._format = self._next_file(float(rows.times_s[0]))
        rows.table["time_s"] = self._format.rounded(rows.times_s)
        byte = self._file.size
        data = self._format.block(rows, byte)
        self._file.append(data)
        header = self._format.header(self._file.size)
        if header:
            self._file.rewrite(header)
        block = Block(
            self._number,
            byte,
            len(data),
            self.frames,
            len(rows),
            float(rows.times_s[0]),
            float(rows.times_s[-1]),
            self._format.start_s,
            self._standing.add_rows(rows),
        )
        self._index.append(block.record())
        self.frames += len(rows)
        self._file.to_disk()
        self._index.to_disk()

    def _next_file(self, start_s: float) -> tuple[DiskFile, BlockFormat]:
        plan = self._plan
        number = self._number + 1
        path = plan.folder / file_name(self.name, number, plan.kind.value)
        new_format = block_format(plan.kind, start_s, plan.channel)
        file = DiskFile(path)
        try:
            file.append(new_format.opening())
            facts: Line = {"kind": "file", "number": number, "start_s": new_format.start_s}
            self._sidecar.append(sidecar.as_bytes([facts]))
        except OSError:
            file.discard()
            raise
        self._number = number
        return file, new_format

    def _close_file(self) -> None:
        if self._file is not None and self._format is not None:
            self._file.append(self._format.closing())

    def _clock_line(self) -> list[Line]:
        """Return a line for the sidecar if the time of day was set during the recording."""
        base = self._plan.base
        off_s = self._time_of_day() - base.unix_s - (self._clock() - base.steady_s)
        if abs(off_s - self._clock_off_s) < _CLOCK_JUMP_S:
            return []
        jump_s, self._clock_off_s = off_s - self._clock_off_s, off_s
        return [{"kind": "clock", "jump_s": round(jump_s, 3), "off_s": round(off_s, 3)}]
