"""Where the frames of an export come from: a log file of any program, or an indexed session."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from armui.session.frames import NotALogError
from armui.session.reader import LogFile
from armui.session.recording.recorded_session import RecordedSession

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from pathlib import Path
    from typing import Any

    from armui.session.frames import Damage, FrameBatch
    from armui.session.session import Session


class FileSource:
    """A log file, read once from its beginning to its end.

    Args:
        path: Of any format that `LogFile` reads.

    Raises:
        NotALogError: It cannot be opened, or is no log.
    """

    lines: Sequence[Mapping[str, Any]] = ()
    """What a recording of this program says of itself; nothing of other logs."""

    def __init__(self, path: Path) -> None:
        self._log = LogFile(path, pipes=True)

    @property
    def frames(self) -> int:
        """Frames read so far."""
        return self._log.frames

    @property
    def done(self) -> float | None:
        """How much of its bytes, 0 to 1; `None` where nobody knows."""
        return min(self._log.position / self._log.size, 1.0) if self._log.size else None

    @property
    def damages(self) -> Sequence[Damage]:
        """The damaged places met so far, bounded."""
        return self._log.damages.since(0)

    @property
    def damage_count(self) -> int:
        """All of them."""
        return self._log.damages.count

    def batches(self) -> Iterator[FrameBatch]:
        """The frames; only once."""
        return self._log.batches()

    def close(self) -> None:
        """Closes the file."""
        self._log.close()


class SessionSource:
    """A session with all its files, read as a `FileSource` is.

    Args:
        session: Closed with this.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._at_s = session.start_s
        self.lines: Sequence[Mapping[str, Any]] = getattr(session, "lines", ())
        self.frames = 0

    @property
    def done(self) -> float | None:
        """How much of its time, 0 to 1; `None` where nobody knows."""
        length_s = self._session.end_s - self._session.start_s
        return min((self._at_s - self._session.start_s) / length_s, 1.0) if length_s > 0 else None

    @property
    def damages(self) -> Sequence[Damage]:
        """The damaged places met so far, bounded."""
        return self._session.damages

    @property
    def damage_count(self) -> int:
        """All of them."""
        return self._session.damage_count

    def batches(self) -> Iterator[FrameBatch]:
        """The frames; only once."""
        for batch in self._session.frames_between(-math.inf, math.inf):
            self.frames += len(batch)
            self._at_s = float(batch.times_s[-1])
            yield batch

    def close(self) -> None:
        """Closes the session."""
        self._session.close()


ExportSource = FileSource | SessionSource


def open_source(path: Path) -> ExportSource:
    """Opens a recording: all files of one of this program's, or any log.

    Raises:
        NotALogError: It cannot be opened, or is no log.
    """
    try:
        return SessionSource(RecordedSession(path))
    except NotALogError:
        return FileSource(path)
