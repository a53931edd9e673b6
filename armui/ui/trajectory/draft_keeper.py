"""Keeps what is not saved on the disk, so that a crash loses no more than the last second."""

from __future__ import annotations

import threading
from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from armui.trajectory.library import Library, LibraryError
from armui.trajectory.program import Trajectory
from armui.ui.trajectory.document import Document

_AFTER_MS: Final = 700
"""After the last change: typing is not slowed down, and little can be lost."""
_REST_S: Final = 0.004
"""Between two stretches of the work, so that Python's lock is free for the window."""


class DraftKeeper(QObject):
    """Follows a document, and writes in a thread of its own when the edits pause.

    Args:
        document: What is edited.
        library: Keeps drafts beside its trajectories.

    Signals:
        failed: A :class:`LibraryError`: the draft could not be written.
    """

    failed = Signal(object)

    def __init__(self, document: Document, library: Library) -> None:
        super().__init__(document)
        self._document = document
        self._library = library
        self._thread: threading.Thread | None = None
        self._hurry = threading.Event()
        self._timer = QTimer(self, singleShot=True, interval=_AFTER_MS)
        self._timer.timeout.connect(self._write_behind)
        # the signal's number must not become the timer's milliseconds
        document.stack.indexChanged.connect(lambda _index: self._timer.start())

    def write(self) -> None:
        """Bring the draft up to date now."""
        self._wait()
        self._write(self._unsaved())

    def forget(self) -> None:
        """The changes are not wanted: no draft of them shall be left."""
        self._wait()
        self._write(None)

    def _write_behind(self) -> None:
        if self._thread is not None and self._thread.is_alive():
            self._timer.start()  # with what has been edited since
            return
        self._thread = threading.Thread(
            target=self._write, args=(self._unsaved(),), name="armui-draft"
        )
        self._thread.start()

    def _unsaved(self) -> Trajectory | None:
        return None if self._document.saved else self._document.trajectory()

    def _wait(self) -> None:
        """See to it that nothing is written behind our back."""
        self._timer.stop()
        if self._thread is not None:
            self._hurry.set()
            self._thread.join()
            self._hurry.clear()

    def _write(self, unsaved: Trajectory | None) -> None:
        """Write the draft, or do away with one that says no more than what is saved."""
        try:
            if unsaved is None:
                self._library.drop_draft(self._document.name)
            else:
                self._library.save_draft(
                    self._document.name, unsaved, lambda: self._hurry.wait(_REST_S)
                )
        except LibraryError as error:
            self.failed.emit(error)
