"""A trajectory being edited; every edit can be undone."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from typing import Any, Final

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from armui.trajectory.points import edits
from armui.trajectory.points.edits import Change, Points
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.library.library_work import LibraryWork

_UNDO_STEPS: Final = 1000


class Document(QObject):
    """The edited points; views follow :attr:`changed`.

    Args:
        trajectory: The trajectory as it was opened.

    Signals:
        changed: A :class:`Change` of the points, after it was made.
        note_changed: The note has changed.
        taught_on_changed: The arm it was taught on has changed, or become known.
        saved_changed: Emitted with whether everything is saved, when that changes.
    """

    changed = Signal(object)
    note_changed = Signal()
    taught_on_changed = Signal()
    saved_changed = Signal(bool)

    def __init__(self, trajectory: Trajectory, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._trajectory = trajectory
        self.stack = QUndoStack(self)
        self.stack.setUndoLimit(_UNDO_STEPS)
        self.stack.cleanChanged.connect(self.saved_changed)

    @property
    def points(self) -> Points:
        """The present points."""
        return self._trajectory.points

    @property
    def name(self) -> str:
        """The name of the trajectory."""
        return self._trajectory.name

    @property
    def note(self) -> str:
        """The operator's note."""
        return self._trajectory.note

    @property
    def saved(self) -> bool:
        """True if everything is saved."""
        return self.stack.isClean()

    def trajectory(self) -> Trajectory:
        """Return the present trajectory, with the present time if it differs from the saved one."""
        if self.saved:
            return self._trajectory
        return replace(self._trajectory, modified=datetime.now().astimezone())

    def edit(self, points: Points, label: str) -> bool:
        """Replace the points, as one step of undo.

        Args:
            points: All points after the edit.
            label: The edit's name in the undo menu.

        Returns:
            True if anything differs.
        """
        change = edits.difference(self.points, points)
        if change is None:
            return False
        self.stack.push(_Edit(self.take, change.reversed(), change, label))
        return True

    def note_taught(self, arm: str, count: int = 1) -> None:
        """Set the arm on which the first points were taught; later points do not change it.

        Args:
            arm: The arm as in `ModelFit.taught_on`; "" if not known.
            count: The number of points if these are all.
        """
        if arm and len(self.points) == count and not self._trajectory.taught_on:
            self.take_taught_on(arm)

    @property
    def taught_on(self) -> str:
        """The arm it was taught on; "" if not known."""
        return self._trajectory.taught_on

    def convert(self, points: Points, arm: str, label: str) -> None:
        """Replace the points by those converted for another arm, as one step of undo."""
        self.stack.beginMacro(label)
        self.edit(points, label)
        self.stack.push(_Edit(self.take_taught_on, self.taught_on, arm))
        self.stack.endMacro()

    def set_note(self, note: str, label: str) -> None:
        """Change the note, as one step of undo."""
        if note != self.note:
            self.stack.push(_Edit(self.take_note, self.note, note, label))

    def mark_saved(self, saved: Trajectory) -> None:
        """Note that the present state is on the disk."""
        self._trajectory = replace(self._trajectory, name=saved.name, modified=saved.modified)
        self.stack.setClean()

    def take(self, change: Change) -> None:
        """Apply a change; only the undo stack calls this."""
        self._trajectory = replace(self._trajectory, points=change.apply(self.points))
        self.changed.emit(change)

    def take_note(self, note: str) -> None:
        """Set the note; only the undo stack calls this."""
        self._trajectory = replace(self._trajectory, note=note)
        self.note_changed.emit()

    def take_taught_on(self, arm: str) -> None:
        """Set the arm it was taught on; beside `note_taught` only the undo stack calls this."""
        self._trajectory = replace(self._trajectory, taught_on=arm)
        self.taught_on_changed.emit()


class _Edit(QUndoCommand):
    """One step of undo: a function that applies a state, and the states before and after.

    For the points both are a `Change`, which holds only the rows that differ.
    """

    def __init__(
        self, take: Callable[[Any], object], before: object, after: object, label: str = ""
    ) -> None:
        super().__init__(label)
        self._take, self._before, self._after = take, before, after

    def redo(self) -> None:
        self._take(self._after)

    def undo(self) -> None:
        self._take(self._before)


_AFTER_MS: Final = 700
"""The delay after the last change: typing is not slowed down, and little can be lost."""
_REST_S: Final = 0.004
"""The pause between two stretches of the work, so that Python's lock is free for the window."""


class DraftKeeper(QObject):
    """Follows a document, and has its draft written when the edits pause.

    Args:
        document: The document.
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

    def write_draft(self) -> None:
        """Update the draft at once, because the program may be ending."""
        self._timer.stop()
        self._hurry.set()
        self._begin(self._unsaved())

    def drop_draft(self) -> None:
        """Delete the draft, because the changes are not wanted."""
        self._timer.stop()
        self._hurry.set()
        self._begin(None)

    def _write_behind(self) -> None:
        if self._writing:
            self._timer.start()  # again later, with the edits made meanwhile
        else:
            self._hurry.clear()
            self._begin(self._unsaved())

    def _unsaved(self) -> Trajectory | None:
        return None if self._document.saved else self._document.trajectory()

    def _begin(self, unsaved: Trajectory | None) -> None:
        """Write the draft, or delete it with ``None``, because everything is saved or dropped."""
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
