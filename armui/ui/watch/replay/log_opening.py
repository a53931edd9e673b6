"""Opens a log, read once by a process of its own, with progress in the window."""

from __future__ import annotations

import mmap
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer, Signal

from armui.arm.refusal import Reason, Refusal
from armui.session.foreign.indexed import (
    PROGRESS_BYTES,
    IndexedLog,
    LogIndex,
    ReadingProgress,
    map_progress,
)
from armui.session.foreign.indexing import REPLAY_NO_DISK, index_or_reason
from armui.session.frames import NotALogError
from armui.session.survey import ChannelSurvey, survey
from armui.system.files import error_text
from armui.system.helper_process import HelperProcess
from armui.system.scratch import ScratchFolder, make_folder, remove_leftovers
from armui.ui.background import WORK_FAILED, Background, Job

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from armui.session.session import Session

REPLAY_FAILED = Reason(
    "replay_failed",
    "{name} can be read no further: {text}. Open it again; if that does not help, copy it to "
    "another disk first.",
)


_LOOK_MS: Final = 100
Opened = tuple["Session", tuple[ChannelSurvey, ...]]
OpenOwn = Callable[[Path], "Session"]


class LogOpening(QObject):
    """The opening of one log, which may be cancelled at any time.

    Args:
        path: The file.
        background: Examines files.
        make_helper: Creates the process that reads the log; it is ended afterwards, or at
            cancelling.
        open_own: Opens a recording of this program by the index beside it; it raises
            `NotALogError` for any other log, which is read whole then.

    Signals:
        progressed: A :class:`ReadingProgress`, now and then.
        opened: The session, and the surveys of its channels.
        refused: The :class:`Refusal` why it cannot be replayed.
    """

    progressed = Signal(object)
    opened = Signal(object, object)
    refused = Signal(object)

    def __init__(
        self,
        path: Path,
        background: Background,
        make_helper: Callable[[], Executor] = HelperProcess,
        parent: QObject | None = None,
        *,
        open_own: OpenOwn | None = None,
    ) -> None:
        super().__init__(parent)
        self._open_own = open_own
        self._path = path
        self._background = background
        self._helper = make_helper()
        self._reading = Background(self._helper, None, self)
        self._folder: ScratchFolder | None = None
        self._progress: mmap.mmap | None = None
        self._job: Job[object] | None = None
        self._is_over = False
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self._emit_progress)

    def begin(self) -> None:
        """Begin to open the log: by its index if it is a recording of ours, else by reading it."""
        if self._open_own is None:
            self._prepare()
        else:
            self._background.begin_here(
                Job(self._on_looked_at), _own_session, self._open_own, self._path
            )

    def _on_looked_at(self, opened: Opened | Refusal | None) -> None:
        if self._is_over:
            if isinstance(opened, tuple):
                self._background.begin_here(Job(lambda _done: None), opened[0].close)
        elif isinstance(opened, tuple):
            self._on_opened(opened)
        else:
            self._prepare()

    def _prepare(self) -> None:
        self._background.begin_here(Job(self._on_prepared), _prepare)

    def call_off(self) -> None:
        """Cancel the opening, and kill the process."""
        if not self._is_over:
            self._end()
            self._background.begin_here(
                Job(lambda _done: None), _clear_away, self._helper, self._folder
            )

    def end(self) -> None:
        """Cancel the opening, with everything done when this returns."""
        if not self._is_over:
            self._end()
            _clear_away(self._helper, self._folder)

    def _end(self) -> None:
        self._is_over = True
        self._timer.stop()
        if self._job is not None:
            self._job.wanted = False
        if self._progress is not None:
            self._progress.close()
            self._progress = None

    def _on_prepared(self, prepared: tuple[ScratchFolder, mmap.mmap] | Refusal) -> None:
        if isinstance(prepared, Refusal):
            self._refuse(prepared)
            return
        self._folder, self._progress = prepared
        if self._is_over:  # cancelled meanwhile
            self._progress.close()
            self._background.begin_here(
                Job(lambda _done: None), _clear_away, self._helper, self._folder
            )
            return
        self._timer.start()
        self._job = Job(self._on_indexed)
        self._reading.begin(self._job, index_or_reason, self._path, self._folder.path)

    def _emit_progress(self) -> None:
        if self._progress is not None:
            self.progressed.emit(ReadingProgress.read_from(self._progress[:PROGRESS_BYTES]))

    def _on_indexed(self, index: object) -> None:
        if not isinstance(index, LogIndex):
            self._refuse(index if isinstance(index, Refusal) else self._failed(str(index)))
            return
        self._timer.stop()
        job = Job(self._on_opened)
        assert self._folder is not None  # noqa: S101 - it was prepared before
        work = partial(_open, index, self._folder, self._helper)
        self._background.begin_here(job, work)

    def _on_opened(self, opened: Opened | Refusal) -> None:
        if isinstance(opened, Refusal):
            self._refuse(opened)
        elif self._is_over:
            self._background.begin_here(Job(lambda _done: None), opened[0].close)
        else:
            self._end()
            self.opened.emit(*opened)

    def _refuse(self, reason: Refusal) -> None:
        if self._is_over:
            return
        self._end()
        self._background.begin_here(
            Job(lambda _done: None), _clear_away, self._helper, self._folder
        )
        if reason.reason == WORK_FAILED:
            reason = self._failed(str(reason.params.get("text", "")))
        self.refused.emit(reason)

    def _failed(self, text: str) -> Refusal:
        return REPLAY_FAILED(name=self._path.name, text=text)


def _own_session(open_own: OpenOwn, path: Path) -> Opened | None:
    """Open a recording of this program, and survey its arms; ``None`` for any other log."""
    try:
        session = open_own(path)
    except NotALogError:
        return None
    return (session, survey(session)) if session.frames else None


def _prepare() -> tuple[ScratchFolder, mmap.mmap] | Refusal:
    """Make a folder for the columns, and the shared memory for the progress."""
    try:
        remove_leftovers()
        folder = make_folder("replay")
        return folder, map_progress(folder.path)
    except OSError as error:
        return REPLAY_NO_DISK(text=error_text(error))


def _open(index: LogIndex, folder: ScratchFolder, helper: Executor) -> Opened:
    helper.shutdown()
    session = IndexedLog(index, folder.path, folder.remove)
    return session, survey(session)


def _clear_away(helper: Executor, folder: ScratchFolder | None) -> None:
    helper.shutdown()
    if folder is not None:
        folder.remove()
