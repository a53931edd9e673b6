"""A trajectory under the operator's hands: every edit can be undone."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime
from typing import Final

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from armui.trajectory.points import edits
from armui.trajectory.points.edits import Change, Points
from armui.trajectory.points.program import Trajectory

_UNDO_STEPS: Final = 1000


class Document(QObject):
    """Holds the points; whoever shows them follows :attr:`changed`.

    Args:
        trajectory: As it was opened.

    Signals:
        changed: A :class:`Change` of the points, after it was made.
        note_changed: The trajectory's note is another.
        taught_on_changed: The arm it was taught on is another, or known now.
        saved_changed: Whether everything is saved, when that differs.
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
        """As they are now."""
        return self._trajectory.points

    @property
    def name(self) -> str:
        """What the trajectory is called."""
        return self._trajectory.name

    @property
    def note(self) -> str:
        """What it is for."""
        return self._trajectory.note

    @property
    def saved(self) -> bool:
        """Whether everything is saved."""
        return self.stack.isClean()

    def trajectory(self) -> Trajectory:
        """The trajectory as it is now, changed now if it differs from what is saved."""
        if self.saved:
            return self._trajectory
        return replace(self._trajectory, modified=datetime.now().astimezone())

    def edit(self, points: Points, label: str) -> bool:
        """Put other points in the place of the present ones.

        Args:
            points: All of them, after the edit.
            label: What the edit does, for the undo menu.

        Returns:
            Whether anything differs.
        """
        change = edits.difference(self.points, points)
        if change is None:
            return False
        self.stack.push(_Edit(self, change, label))
        return True

    def note_taught(self, arm: str, count: int = 1) -> None:
        """Take over on which arm the first points were taught; of others it is not known.

        Args:
            arm: As `ModelFit.taught_on` tells; "": not known.
            count: How many points there are if these are all.
        """
        if arm and len(self.points) == count and not self._trajectory.taught_on:
            self.take_taught_on(arm)

    @property
    def taught_on(self) -> str:
        """The arm it was taught on; "" where that is not known."""
        return self._trajectory.taught_on

    def convert(self, points: Points, arm: str, label: str) -> None:
        """Put points as they are for another arm in the place of the present ones, as one edit."""
        self.stack.beginMacro(label)
        self.edit(points, label)
        self.stack.push(_EditTaughtOn(self, self.taught_on, arm))
        self.stack.endMacro()

    def set_note(self, note: str, label: str) -> None:
        """Change what the trajectory is for."""
        if note != self.note:
            self.stack.push(_EditNote(self, self.note, note, label))

    def mark_saved(self, saved: Trajectory) -> None:
        """What is on the disk now is what is held."""
        self._trajectory = replace(self._trajectory, name=saved.name, modified=saved.modified)
        self.stack.setClean()

    def take(self, change: Change) -> None:
        """Make a change; only the undo stack calls this."""
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
    """One edit of the points; it keeps no more than what differs."""

    def __init__(self, document: Document, change: Change, label: str) -> None:
        super().__init__(label)
        self._document = document
        self._change = change

    def redo(self) -> None:
        self._document.take(self._change)

    def undo(self) -> None:
        self._document.take(self._change.reversed())


class _EditNote(QUndoCommand):
    """Another note for the trajectory."""

    def __init__(self, document: Document, before: str, after: str, label: str) -> None:
        super().__init__(label)
        self._document = document
        self._before, self._after = before, after

    def redo(self) -> None:
        self._document.take_note(self._after)

    def undo(self) -> None:
        self._document.take_note(self._before)


class _EditTaughtOn(QUndoCommand):
    """Another arm that the points are meant for."""

    def __init__(self, document: Document, before: str, after: str) -> None:
        super().__init__()
        self._document = document
        self._before, self._after = before, after

    def redo(self) -> None:
        self._document.take_taught_on(self._after)

    def undo(self) -> None:
        self._document.take_taught_on(self._before)
