"""Keeps what is not saved on the disk, so that a crash loses no more than the last second."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QObject, QTimer, Signal

from armui.trajectory.library import Library, LibraryError
from armui.ui.trajectory.document import Document

_AFTER_MS: Final = 700
"""After the last change: typing is not slowed down, and little can be lost."""


class DraftKeeper(QObject):
    """Follows a document.

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
        self._timer = QTimer(self, singleShot=True, interval=_AFTER_MS)
        self._timer.timeout.connect(self.write)
        # the signal's number must not become the timer's milliseconds
        document.stack.indexChanged.connect(lambda _index: self._timer.start())

    def write(self) -> None:
        """Bring the draft up to date, or do away with one that says no more than what is saved."""
        self._timer.stop()
        try:
            if self._document.saved:
                self._library.drop_draft(self._document.name)
            else:
                self._library.save_draft(self._document.name, self._document.trajectory())
        except LibraryError as error:
            self.failed.emit(error)

    def forget(self) -> None:
        """The changes are not wanted: no draft of them shall be left."""
        self._timer.stop()
        try:
            self._library.drop_draft(self._document.name)
        except LibraryError as error:
            self.failed.emit(error)
