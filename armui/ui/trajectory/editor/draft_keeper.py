"""Keeps what is not saved on the disk, so that a crash loses no more than the last second."""

from __future__ import annotations

import threading
from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.editor.document import Document
from armui.ui.trajectory.library.library_work import LibraryWork

_AFTER_MS: Final = 700
"""After the last change: typing is not slowed down, and little can be lost."""
_REST_S: Final = 0.004
"""Between two stretches of the work, so that Python's lock is free for the window."""


class DraftKeeper(QObject):
    """Follows a document, and has its draft written when the edits pause.

    Args:
        document: What is edited.
        work: Has the library keep drafts beside its trajectories.

    Signals:
        failed: Why the draft could not be written, as a text.
    """

    failed = Signal(str)

    def __init__(self, document: Document, work: LibraryWork) -> None:
        super().__init__(document)
        self._document = document
        self._work = work
        self._writing = False
        self._hurry = threading.Event()
        self._timer = QTimer(self, singleShot=True, interval=_AFTER_MS)
        self._timer.timeout.connect(self._write_behind)
        # the signal's number must not become the timer's milliseconds
        document.stack.indexChanged.connect(lambda _index: self._timer.start())

    def write(self) -> None:
        """Bring the draft up to date at once, and quickly: the program may be ending."""
        self._timer.stop()
        self._hurry.set()
        self._begin(self._unsaved())

    def forget(self) -> None:
        """The changes are not wanted: no draft of them shall be left."""
        self._timer.stop()
        self._hurry.set()
        self._begin(None)

    def _write_behind(self) -> None:
        if self._writing:
            self._timer.start()  # with what has been edited since
        else:
            self._hurry.clear()
            self._begin(self._unsaved())

    def _unsaved(self) -> Trajectory | None:
        return None if self._document.saved else self._document.trajectory()

    def _begin(self, unsaved: Trajectory | None) -> None:
        """Write the draft, or do away with one that says no more than what is saved."""
        self._writing = True
        library, name, hurry = self._work.library, self._document.name, self._hurry

        def write() -> None:
            if unsaved is None:
                library.drop_draft(name)
            else:
                library.save_draft(name, unsaved, lambda: hurry.wait(_REST_S))

        self._work.do(write, lambda _: self._written(), self._written)

    def _written(self, problem: str = "") -> None:
        self._writing = False
        if problem:
            self.failed.emit(problem)
