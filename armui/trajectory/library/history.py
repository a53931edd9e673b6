"""The undo history of the library for this run of the program.

Not Qt's undo stack: that one assumes that a step once done can be undone, but a disk may refuse, or
another program may have changed the files. A step the disk refuses stays and can be tried again;
one that can never be undone any more is dropped, and the operator is told.
"""

from __future__ import annotations

import enum
import os.path
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from typing import Final

from armui.arm.refusal import Reason
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.folders import FOLDER_NOT_CHANGED
from armui.trajectory.library.store import (
    LIBRARY_NOT_DELETED,
    LIBRARY_NOT_RESTORED,
    LIBRARY_NOT_SAVED,
    LIBRARY_UNREADABLE,
    Deleted,
    Library,
    LibraryError,
    Listing,
)

CHANGED_SINCE = Reason(
    "changed_since",
    "“{name}” has been changed since it was made, and is kept. Delete it if you do not want it.",
)


_TRY_AGAIN: Final = frozenset(
    {
        FOLDER_NOT_CHANGED,
        LIBRARY_NOT_SAVED,
        LIBRARY_NOT_DELETED,
        LIBRARY_NOT_RESTORED,
        LIBRARY_UNREADABLE,
    }
)
"""Errors of the disk, after which the step is kept."""


@dataclass(frozen=True, slots=True)
class Deletion:
    """A deletion, undone by restoring what was deleted together.

    Attributes:
        deleted: The deleted files.
    """

    deleted: Deleted

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the restored trajectories."""
        return self.deleted.names

    @property
    def touched(self) -> tuple[str, ...]:
        """The present trajectories that undoing changes: none."""
        return ()

    def is_possible(self, _seen: Listing) -> bool:
        """Return whether at least one of the files is still in the bin."""
        return any(os.path.exists(place) for _, place in self.deleted.places)  # noqa: PTH110 - never raises

    def undo(self, library: Library) -> tuple[str, ...]:
        """Undo the deletion, and return the names of the restored trajectories."""
        return library.restore(self.deleted)


@dataclass(frozen=True, slots=True)
class Renaming:
    """A renaming, undone by giving back the old name.

    Attributes:
        old: The old name.
        new: The new name.
    """

    old: str
    new: str

    @property
    def names(self) -> tuple[str, ...]:
        """The name that undoing gives back."""
        return (self.old,)

    @property
    def touched(self) -> tuple[str, ...]:
        """The present trajectories that undoing changes."""
        return (self.new,)

    def is_possible(self, seen: Listing) -> bool:
        """Return whether the new name exists and the old one is free."""
        names = {entry.name for entry in seen.entries}
        return self.new in names and self.old not in names

    def undo(self, library: Library) -> tuple[str, ...]:
        """Undo the renaming, and return the old name."""
        library.rename(self.new, self.old)
        return (self.old,)


class Origin(enum.Enum):
    """The way a new trajectory came into the library."""

    CREATED = enum.auto()
    COPIED = enum.auto()
    IMPORTED = enum.auto()


@dataclass(frozen=True, slots=True)
class Making:
    """New trajectories, undone by deleting them as long as they are unchanged.

    Attributes:
        made: The name of each, and the time at which it was made.
        origin: The way they were made.
    """

    made: tuple[tuple[str, datetime], ...]
    origin: Origin

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the new trajectories."""
        return tuple(name for name, _ in self.made)

    @property
    def touched(self) -> tuple[str, ...]:
        """The present trajectories that undoing changes."""
        return self.names

    def is_possible(self, seen: Listing) -> bool:
        """Return whether some of them exist, and none has been changed."""
        there = {entry.name for entry in seen.entries}
        return not there.isdisjoint(self.names) and self._changed(seen) is None

    def undo(self, library: Library) -> tuple[str, ...]:
        """Undo it by deleting the trajectories; return no names."""
        name = self._changed(library.listing())
        if name is not None:
            raise LibraryError(CHANGED_SINCE(name=name))
        library.delete(self.names)
        return ()

    def _changed(self, seen: Listing) -> str | None:
        """Return the first that was worked on, saved or not."""
        there = {entry.name: entry.modified for entry in seen.entries}
        for name, modified in self.made:
            if name in seen.drafts or there.get(name, modified) != modified:
                return name
        return None


@dataclass(frozen=True, slots=True)
class Moving:
    """Trajectories moved to another folder, undone by moving them back.

    Attributes:
        moved: The name of each, and the sub-folder it was in; "" for the library's folder itself.
        folder: The sub-folder they were moved to.
    """

    moved: tuple[tuple[str, str], ...]
    folder: str

    @property
    def names(self) -> tuple[str, ...]:
        """The names of the moved trajectories."""
        return tuple(name for name, _ in self.moved)

    @property
    def touched(self) -> tuple[str, ...]:
        """The present trajectories that undoing changes: none, for they only lie elsewhere."""
        return ()

    def is_possible(self, seen: Listing) -> bool:
        """Return whether some are still there, and so is a folder they came from."""
        there = {entry.name for entry in seen.entries if entry.folder == self.folder}
        return any(name in there and old in {"", *seen.folders} for name, old in self.moved)

    def undo(self, library: Library) -> tuple[str, ...]:
        """Undo the move, and return the names of those that are back."""
        back: list[str] = []
        for folder in dict.fromkeys(old for _, old in self.moved):
            back += library.move([name for name, old in self.moved if old == folder], folder)
        return tuple(back)


Step = Deletion | Renaming | Making | Moving


class LibraryHistory:
    """Changes the library, and remembers the steps for undo.

    Args:
        library: The library.
    """

    def __init__(self, library: Library) -> None:
        self._library = library
        self._steps: list[Step] = []

    @property
    def last(self) -> Step | None:
        """The step that would be undone next."""
        return next(iter(self._steps[-1:]), None)

    def delete(self, names: Sequence[str]) -> Deleted:
        """Delete trajectories and drafts.

        Raises:
            LibraryError: See `Library.delete`.
        """
        deleted = self._library.delete(names)
        if deleted.names:
            self._steps.append(Deletion(deleted))
        return deleted

    def rename(self, name: str, new: str) -> None:
        """Give a trajectory another name.

        Raises:
            LibraryError: See `Library.rename`.
            TrajectoryFileError: See `Library.rename`.
        """
        self._library.rename(name, new)
        if new != name:
            self._steps.append(Renaming(name, new))

    def move(self, names: Sequence[str], folder: str) -> tuple[str, ...]:
        """Move trajectories to a sub-folder, and return the names of those that were moved.

        Raises:
            LibraryError: See `Library.move`.
        """
        before = {entry.name: entry.folder for entry in self._library.entries()}
        asked = [name for name in dict.fromkeys(names) if before.get(name, folder) != folder]
        moved = self._library.move(asked, folder)
        if moved and len(moved) == len(asked):
            olds = (before[name] for name in asked)
            self._steps.append(Moving(tuple(zip(moved, olds, strict=True)), folder))
        return moved

    def drop_outdated(self, seen: Listing) -> None:
        """Drop the last steps as long as they cannot be undone any more.

        Args:
            seen: The present content of the library.
        """
        while self._steps and not self._steps[-1].is_possible(seen):
            self._steps.pop()

    def note_made(self, names: Sequence[str], origin: Origin) -> None:
        """Remember that trajectories were just made.

        Args:
            names: Their names.
            origin: The way they were made.

        Raises:
            LibraryError: The library cannot be read.
        """
        there = {entry.name: entry.modified for entry in self._library.entries()}
        made = tuple((name, there[name]) for name in names if name in there)
        if made:
            self._steps.append(Making(made, origin))

    def undo(self) -> tuple[str, ...]:
        """Undo the last step.

        Returns:
            The names of the trajectories that came back, as they are listed now.

        Raises:
            LibraryError: It could not be undone; after an error of the disk it can be tried again.
            TrajectoryFileError: The file is damaged, or gone.
        """
        step = self._steps[-1]
        try:
            names = step.undo(self._library)
        except LibraryError as error:
            if error.refusal.reason not in _TRY_AGAIN:
                self._steps.pop()
            raise
        except TrajectoryFileError:
            self._steps.pop()
            raise
        self._steps.pop()
        return names

    def bring_back(self, deleted: Sequence[Deleted]) -> tuple[str, ...]:
        """Restore deleted trajectories, even from before this run of the program.

        Returns:
            The names under which they are listed now.

        Raises:
            LibraryError: The disk refuses, or one is gone; those before it have been restored.
        """
        names: list[str] = []
        for one in deleted:
            names += self._library.restore(one)
            self._forget(one)
        return tuple(names)

    def _forget(self, back: Deleted) -> None:
        """Remove restored files from the steps; the rest of each step can still be undone."""
        places = {place for _, place in back.places}
        steps: list[Step] = []
        for step in self._steps:
            if isinstance(step, Deletion):
                left = tuple(each for each in step.deleted.places if each[1] not in places)
                if not left:
                    continue
                names = tuple(name for name in step.names if name not in back.names)
                step = Deletion(replace(step.deleted, names=names, places=left))  # noqa: PLW2901
            steps.append(step)
        self._steps = steps
