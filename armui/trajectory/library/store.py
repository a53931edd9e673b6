"""The folder of the trajectories: a file for each, every one always complete.

Points are kept as `.log`, recordings as `.npz`. The name of a trajectory is stored within its file;
the file's own name is as close to it as every file system allows. A file that somebody else has
damaged is listed with its fault, and never overwritten.
"""

from __future__ import annotations

import contextlib
import threading
import time
from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from armui.arm.models import ArmModel
from armui.arm.refusal import Reason, Refusal
from armui.system.atomic import remove_abandoned, replace_file, sync_folder
from armui.system.files import error_text
from armui.trajectory import files
from armui.trajectory.files import Content, TrajectoryFileError, UnwritableError
from armui.trajectory.files.errors import broken
from armui.trajectory.files.model import first_fault
from armui.trajectory.library.bin import Bin, Deleted
from armui.trajectory.library.drafts import Drafts, is_draft
from armui.trajectory.library.file_names import file_stem, folded, free_stem
from armui.trajectory.library.folders import (
    FOLDER_GONE,
    FOLDER_NOT_CHANGED,
    FOLDER_NOT_EMPTY,
    FOLDER_TAKEN,
    Folders,
    check_folder_name,
)
from armui.trajectory.library.index import Check, IndexEntry, Listing, Stamp, entry_of
from armui.trajectory.library.recording_drafts import (
    RecordingDraft,
    RecordingDrafts,
    UnsavedRecording,
)
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.library.stored_files import (
    Call,
    FileStore,
    StoredFile,
    call_directly,
    is_large,
    load_by,
    name_inside,
    suffix_of,
    write_content,
)
from armui.trajectory.planning.estimate import estimate_s
from armui.trajectory.points.program import LONGEST_NAME, Trajectory, check_name
from armui.trajectory.samples.recording import Array

LIBRARY_UNREADABLE = Reason(
    "library_unreadable",
    "The library cannot be read: {name}: {text}. Check the rights to this folder.",
)
FILE_GONE = Reason("file_gone", "It is not in the library any more.")
NAME_TAKEN = Reason("name_taken", "There is a “{name}” already. Choose another name.")
LIBRARY_NOT_SAVED = Reason(
    "library_not_saved",
    "“{name}” was not saved: {text}. What was kept before is unchanged. Check the disk, then "
    "save again.",
)
LIBRARY_NOT_DELETED = Reason(
    "library_not_deleted", "Not deleted: {name}: {text}. Check the rights to the library's folder."
)
DELETED_GONE = Reason(
    "deleted_gone",
    "“{name}” is no longer among the deleted ones. It has been restored already, or its time "
    "was up.",
)
LIBRARY_NOT_RESTORED = Reason(
    "library_not_restored",
    "Not restored: {name}: {text}. Check the rights to the library's folder.",
)
LIBRARY_DAMAGED = Reason(
    "library_damaged",
    "The file of “{name}” is damaged and is not written over. Save under another name.",
)

__all__ = ["Check", "Deleted", "IndexEntry", "Library", "LibraryError", "Listing"]

_BIN: Final = ".deleted"
_RECORDINGS: Final = ".recordings"
_ROOM_FOR_NUMBER: Final = 8
_MOMENT_S: Final = 0.2
"""The longest time that estimates hold up other users of the library."""


class LibraryError(Exception):
    """An action on the library that failed; everything is as it was.

    Attributes:
        refusal: The reason.
        row: The point or sample to blame, from 1; 0 if none.
    """

    def __init__(self, refusal: Refusal, row: int = 0) -> None:
        super().__init__(refusal, row)
        self.refusal = refusal
        self.row = row

    def __str__(self) -> str:
        return f"row {self.row}: {self.refusal}" if self.row else str(self.refusal)


@contextlib.contextmanager
def on_disk(code: Reason, name: str) -> Iterator[None]:
    """Raise errors of the disk as `LibraryError` with this reason."""
    try:
        yield
    except OSError as error:
        refusal = Refusal(code, {"name": name, "text": error_text(error)})
        raise LibraryError(refusal) from error


class Library:
    """Keeps trajectories and recordings by name.

    It is for one thread; other programs may use the folder at the same time.

    Args:
        folder: The folder; it need not exist.
        now: Returns the time that is stored as that of the last change.
        call: Calls a function that may take long with its arguments, for example in another
            process. Used for large files; by default they are read directly.

    Attributes:
        turn: Held by the thread at work, if there may be several.
        new_in: The sub-folder in which new trajectories are kept; "" for the library's folder
            itself, which also takes them if that sub-folder is gone.
    """

    def __init__(
        self,
        folder: Path,
        now: Callable[[], datetime] = lambda: datetime.now(UTC),
        call: Call = call_directly,
    ) -> None:
        self.turn = threading.Lock()
        self.new_in = ""
        self._folder = folder
        self._now = now
        self._call = call
        self._file_store = FileStore(folder, call)
        self._folders = Folders(folder)
        self._bin = Bin(folder / _BIN)
        self._drafts = Drafts(folder, call)
        self._recordings = RecordingDrafts(folder / _RECORDINGS, call)
        self._met: dict[str, Stamp] = {}
        """The files as they were loaded to be edited, by the name of what they hold."""
        self._bases: dict[str, datetime] = {}
        """The time of change of each trajectory when it was loaded to be edited or saved; drafts
        refer to it."""

    def tidy(self) -> None:
        """Remove half-written files of killed programs, and what was deleted long ago."""
        for folder in (self._folder, *self._paths_of_folders()):
            remove_abandoned(folder)
        self._bin.remove_outdated()

    @property
    def folder(self) -> Path:
        """The folder that holds the trajectories' files."""
        return self._folder

    def entries(self) -> list[IndexEntry]:
        """Return all entries by name; only new or changed files are opened.

        An unsaved state whose trajectory was never saved, or is gone, is listed as `draft`.

        Raises:
            LibraryError: The folder cannot be read.
        """
        found = self._scan()
        entries = [kept.entry for kept in found.values()]
        with on_disk(LIBRARY_UNREADABLE, str(self._folder)):
            entries += self._drafts.entries(but=found)
        return sorted(entries, key=lambda one: one.name)

    def listing(self) -> Listing:
        """Return the entries, the names with unsaved changes, and the sub-folders.

        Raises:
            LibraryError: The folder cannot be read.
        """
        entries, drafts = tuple(self.entries()), tuple(self.drafts())
        folders, closed = self._file_store.folders, self._file_store.closed
        return Listing(entries, drafts, folders, closed)

    def load(self, name: str, *, to_edit: bool = False) -> Content:
        """Return a trajectory or recording.

        Args:
            name: Its name.
            to_edit: True if `save` shall report that another program has saved it since.

        Raises:
            TrajectoryFileError: It is damaged, or gone.
            LibraryError: The folder cannot be read.
        """
        kept = self._scan().get(name)
        if kept is None:
            raise TrajectoryFileError(broken(FILE_GONE).refusal, file=name)
        if to_edit:
            self._met[name] = kept.stamp
        content: Content = load_by(self._call, kept.path, kept.stamp.size)
        if to_edit:
            self._bases[name] = content.modified
        return content if content.name == name else replace(content, name=name)

    def free_name(self, wanted: str) -> str:
        """Return a name that nothing has, not even a draft: the wanted one, or with a number added.

        Args:
            wanted: Any text; characters that no name can hold are left out.
        """
        return free_name(wanted, {*self._scan(), *self._drafts.names()})

    # Changes --------------------------------------------------------------------------------------

    def save(self, content: Content, *, replacing: str | None = None) -> bool:
        """Save a trajectory or recording, with the present time as that of its last change.

        Its draft is deleted.

        Args:
            content: The content to save.
            replacing: The name of the trajectory it replaces, which may differ from its own.

        Returns:
            True if another program had saved the replaced one since it was loaded here; that
            version is then among the recently deleted.

        Raises:
            LibraryError: It cannot be written, its name is taken, the one to replace is damaged, or
                the disk refuses.
        """
        self._verify(content)
        displaced = self._write(replace(content, modified=self._now()), replacing)
        for name in {content.name, replacing or content.name}:
            self.drop_draft(name)
        return displaced

    def create(self, name: str) -> Trajectory:
        """Keep a new trajectory without points.

        Raises:
            LibraryError: The name is taken, also by an unsaved state, or no name; or the disk
                refuses.
        """
        if name in self._drafts.names():
            raise LibraryError(NAME_TAKEN(name=name))
        trajectory = Trajectory(name, modified=self._now())
        self._verify(trajectory)
        self._write(trajectory, None)
        return trajectory

    def rename(self, name: str, new: str) -> None:
        """Rename a trajectory together with its draft.

        Raises:
            LibraryError: The new name is taken or invalid, or the disk refuses.
            TrajectoryFileError: It is damaged, or gone.
        """
        if new == name:
            return
        found, drafts = self._scan(), self._drafts.names()
        only_draft = self._drafts.load(name) if name not in found else None
        content = replace(only_draft or self.load(name), name=new)
        self._verify(content)
        if new in found or new in drafts:
            raise LibraryError(NAME_TAKEN(name=new))
        if isinstance(only_draft, Trajectory):
            self.save_draft(new, only_draft)
            self.drop_draft(name)
            return
        known = found[name].entry
        if name in drafts:
            with on_disk(LIBRARY_NOT_SAVED, new):
                self._drafts.copy(name, new)
        try:
            self._write(content, name)
        except LibraryError:
            self.drop_draft(new)
            raise
        self.drop_draft(name)
        self.mark(new, check=known.check, arm=known.checked_for)

    def duplicate(self, name: str, new: str) -> None:
        """Copy a trajectory under another name.

        Raises:
            LibraryError: The new name is taken or invalid, or the disk refuses.
            TrajectoryFileError: It is damaged, or gone.
        """
        content = replace(self.load(name), name=new)
        self._verify(content)
        known = self._scan()[name].entry
        self._write(content, None, known.folder)
        self.mark(new, check=known.check, arm=known.checked_for)

    # Folders --------------------------------------------------------------------------------------

    def create_folder(self, name: str) -> None:
        """Make a sub-folder.

        Raises:
            LibraryError: The name is taken, or no folder's name; or the disk refuses.
        """
        self._verify_folder(name)
        with on_disk(FOLDER_NOT_CHANGED, name):
            self._folders.create(name)

    def rename_folder(self, old: str, new: str) -> None:
        """Give a sub-folder another name; what is in it stays in it, with its check marks.

        Raises:
            LibraryError: It is gone, the new name is taken or no folder's name, or the disk
                refuses.
        """
        if new == old:
            return
        self._verify_folder(new, but=old)
        inside = [kept.path for kept in self._scan().values() if kept.entry.folder == old]
        with on_disk(FOLDER_NOT_CHANGED, old):
            if self._folders.path(old) is None:
                raise LibraryError(FOLDER_GONE(name=old))
            self._folders.rename(old, new)
            self._file_store.note_moved((path, self._folder / new / path.name) for path in inside)

    def delete_folder(self, name: str) -> None:
        """Delete an empty sub-folder.

        Raises:
            LibraryError: It is gone, there is something in it, or the disk refuses.
        """
        with on_disk(FOLDER_NOT_CHANGED, name):
            if self._folders.path(name) is None:
                raise LibraryError(FOLDER_GONE(name=name))
            held = self._folders.held(name)
            if held:
                raise LibraryError(FOLDER_NOT_EMPTY(name=name, held=", ".join(held)))
            self._folders.delete(name)

    def move(self, names: Sequence[str], folder: str) -> tuple[str, ...]:
        """Move trajectories to a sub-folder, all or none; nothing there is replaced.

        Args:
            names: Their names; those that are gone, and drafts, which lie in no sub-folder, are
                ignored.
            folder: The sub-folder; "" for the library's folder itself.

        Returns:
            The names of the moved ones, as they are listed now.

        Raises:
            LibraryError: The sub-folder is gone, or the disk refuses; nothing is moved.
        """
        found = self._scan()
        kept = [found[name] for name in dict.fromkeys(names) if name in found]
        moves: list[tuple[Path, Path]] = []
        with on_disk(FOLDER_NOT_CHANGED, ", ".join(names)):
            target = self._folders.path(folder)
            if target is None:
                raise LibraryError(FOLDER_GONE(name=folder))
            taken = {folded(path.stem) for path in target.iterdir()} if target.is_dir() else set()
            try:
                for each in (one for one in kept if one.entry.folder != folder):
                    stem = free_stem(each.path.stem, taken)
                    new = target / f"{stem}{each.path.suffix}"
                    replace_file(each.path, new)
                    moves.append((each.path, new))
                    taken.add(folded(stem))
            except OSError:
                for old, new in moves:
                    replace_file(new, old)
                raise
            for path in {each.parent for pair in moves for each in pair}:
                sync_folder(path)
            self._file_store.note_moved(moves)
        now = {one.path: name for name, one in self._scan().items()}
        return tuple(now[path] for _, path in moves if path in now)

    def _verify_folder(self, name: str, but: str = "") -> None:
        """Make sure that a sub-folder can have a name.

        Raises:
            LibraryError: It cannot.
        """
        reason = check_folder_name(name)
        if reason is not None:
            raise LibraryError(reason)
        with on_disk(LIBRARY_UNREADABLE, str(self._folder)):
            if self._folders.is_taken(name, but):
                raise LibraryError(FOLDER_TAKEN(name=name))

    def _paths_of_folders(self) -> list[Path]:
        with contextlib.suppress(OSError):
            return [self._folder / name for name in self._folders.names()]
        return []

    # Deleted and restored -------------------------------------------------------------------------

    def delete(self, names: Sequence[str]) -> Deleted:
        """Move trajectories and their drafts to the bin, from which `restore` brings them back.

        Args:
            names: Their names; a draft without a trajectory counts as well. Those that are gone
                already are ignored.

        Returns:
            The argument for `restore`.

        Raises:
            LibraryError: The disk refuses; nothing is deleted.
        """
        found, drafts = self._scan(), self._drafts.paths()
        gone = [name for name in dict.fromkeys(names) if name in found or name in drafts]
        paths = [found[name].path for name in gone if name in found]
        paths += [drafts[name] for name in gone if name in drafts]
        with on_disk(LIBRARY_NOT_DELETED, ", ".join(gone)):
            places, when = self._bin.take(paths)
        entries = tuple(found[name].entry for name in gone if name in found)
        return Deleted(tuple(gone), places, when, entries)

    def recently_deleted(self) -> list[Deleted]:
        """Return what can still be restored, the last deleted first, each trajectory by itself.

        Raises:
            LibraryError: The disk refuses.
        """
        with on_disk(LIBRARY_UNREADABLE, str(self._folder)):
            return self._bin.contents()

    def restore(self, deleted: Deleted) -> tuple[str, ...]:
        """Restore deleted trajectories, adding a number to a name that is taken by now.

        Returns:
            The names under which they are listed now.

        Raises:
            LibraryError: The disk refuses, or nothing is left of them.
        """
        places = [(file, place) for file, place in deleted.places if place.exists()]
        if not places and deleted.places:
            raise LibraryError(DELETED_GONE(name=", ".join(deleted.names)))
        names: dict[str, str] = {}
        with on_disk(LIBRARY_NOT_RESTORED, ", ".join(deleted.names)):
            self._folder.mkdir(parents=True, exist_ok=True)
            for file, place in places:
                if not is_draft(place):
                    names[name_inside(place)] = self._put_back(file, place)
            for _file, place in filter(lambda each: is_draft(each[1]), places):
                name = name_inside(place)
                names[name] = self._put_draft_back(place, names.get(name))
        for entry in deleted.entries:
            self.mark(names.get(entry.name, ""), check=entry.check, arm=entry.checked_for)
            if entry.ran_with is not None:
                self.note_run(names.get(entry.name, ""), entry.ran_with)
        return tuple(names.values())

    def _put_back(self, file: str, place: Path) -> str:
        """Bring back a trajectory; no draft of another one of its name becomes its own."""
        name = name_inside(place)
        free = self.free_name(name)
        folder = self._place_for(file.rpartition("/")[0])
        if free != name:
            with contextlib.suppress(TrajectoryFileError):  # a damaged draft is left unchanged
                self._write(replace(files.load(place), name=free), None, folder)
                self._bin.remove(place)
                return free
        path = self._bin.give_back(place.name, place, self._folder / folder)
        return next(name for name, kept in self._scan().items() if kept.path == path)

    def _place_for(self, folder: str) -> str:
        """Return the sub-folder to restore something to, created again if it is gone.

        If something else has taken its name, it is the library's folder itself.

        Raises:
            OSError: It cannot be made.
        """
        if folder and not self._folders.has(folder):
            try:
                self._folders.create(folder)
            except FileExistsError:
                return ""
        return folder

    def _put_draft_back(self, place: Path, owner: str | None) -> str:
        """Bring back a draft, to the trajectory it was deleted with where it was."""
        name = name_inside(place)
        free = owner or self.free_name(name)
        if free != name:
            with contextlib.suppress(TrajectoryFileError):
                content = files.load(place)
                if isinstance(content, Trajectory):
                    self._drafts.save(replace(content, name=free))
                    self._bin.remove(place)
                    return free
        self._bin.give_back(place.name, place, self._folder)
        return free

    def mark(self, name: str, *, check: Check | None, arm: str = "") -> None:
        """Store the result of a check, valid until the file changes.

        Args:
            name: The name; nothing is stored if the file is gone or damaged.
            check: The result of the check.
            arm: The `ArmModel.fingerprint_of` its frames that it was checked for.
        """
        kept = self._scan().get(name)
        if kept is None or kept.entry.damage is not None:
            return
        self._file_store.mark(kept, replace(kept.entry, check=check, checked_for=arm))

    def note_run(self, name: str, options: RunOptions) -> None:
        """Store that a trajectory was run, with its options; ignored if it is gone.

        Args:
            name: Its name.
            options: The options of the run; the next one begins at the first row again.
        """
        kept = self._scan().get(name)
        if kept is not None and kept.entry.damage is None:
            entry = replace(kept.entry, ran_with=replace(options, first=0))
            self._file_store.mark(kept, entry)

    def estimate(self, names: Iterable[str], arm: ArmModel) -> dict[str, float | None]:
        """Estimate the times of trajectories in turn, and end after a moment.

        Args:
            names: The trajectories, in the order of the estimates; those that are gone or damaged
                are left out.
            arm: The arm that the estimates are for.

        Returns:
            The seconds by name, or ``None`` where the time is not known; they are kept until the
            file changes. Trajectories that the moment did not suffice for are missing.

        Raises:
            LibraryError: The folder cannot be read.
        """
        found, begun_s = self._scan(), time.monotonic()
        marked: dict[str, tuple[StoredFile, IndexEntry]] = {}
        for name in names:
            kept = found.get(name)
            if kept is None or kept.entry.damage is not None:
                continue
            with contextlib.suppress(TrajectoryFileError):  # gone, or damaged since
                content = load_by(self._call, kept.path, kept.stamp.size)
                seconds: float | None = self._call(estimate_s, content, arm)
                holds_for = arm.fingerprint_of(kept.entry.frames)
                entry = replace(kept.entry, estimated_s=seconds, estimated_for=holds_for)
                marked[name] = kept, entry
            if time.monotonic() - begun_s > _MOMENT_S:
                break
        self._file_store.mark_all(marked.values())
        return {name: entry.estimated_s for name, (_, entry) in marked.items()}

    # Drafts ---------------------------------------------------------------------------------------

    def save_draft(
        self, name: str, content: Trajectory, rest: Callable[[], object] = lambda: None
    ) -> None:
        """Keep the unsaved state of a trajectory through a crash; may be called from any thread.

        Args:
            name: Its present or future name in the library.
            content: Its present state.
            rest: Called about every millisecond of the work.

        Raises:
            LibraryError: It cannot be written, or the disk refuses.
        """
        content = replace(content, name=name, modified=self._bases.get(name, content.modified))
        with on_disk(LIBRARY_NOT_SAVED, name):
            try:
                self._drafts.save(content, rest)
            except UnwritableError as error:
                raise LibraryError(error.refusal, error.row) from error

    def draft(self, name: str) -> Trajectory | None:
        """Return the unsaved state of a trajectory, or ``None``.

        Raises:
            TrajectoryFileError: It is damaged.
        """
        return self._drafts.load(name)

    def set_aside_draft(self, over: Trajectory) -> bool:
        """Delete a draft that is based on another version of the file.

        This happens when a program was killed after saving, or another one has saved since: such a
        draft would undo what was saved. It is then among the recently deleted, if its content
        differs.

        Args:
            over: The content of the file.

        Returns:
            True if there was a draft with different content.

        Raises:
            TrajectoryFileError: The draft is damaged.
            LibraryError: The disk refuses.
        """
        draft = self._drafts.load(over.name)
        if draft is None or draft.modified == over.modified:
            return False
        if replace(draft, modified=over.modified) == over:
            self.drop_draft(over.name)
            return False
        with on_disk(LIBRARY_NOT_DELETED, over.name):
            self._bin.take([self._drafts.paths()[over.name]])
        return True

    def drop_draft(self, name: str) -> None:
        """Delete the unsaved state of a trajectory.

        Raises:
            LibraryError: The disk refuses.
        """
        with on_disk(LIBRARY_NOT_DELETED, name):
            self._drafts.drop(name)

    def drafts(self) -> list[str]:
        """Return the names of all trajectories that have an unsaved state."""
        return self._drafts.names()

    # Recordings that are not saved ----------------------------------------------------------------

    def begin_recording(self, name: str, taught_on: str) -> RecordingDraft:
        """Return a draft that keeps a recording through a crash; may be called from any thread."""
        return self._recordings.begin(name, taught_on)

    def append_recording(self, draft: RecordingDraft, samples: Array) -> None:
        """Append samples to the draft of a recording.

        Raises:
            LibraryError: The disk refuses.
        """
        with on_disk(LIBRARY_NOT_SAVED, draft.name):
            draft.append(samples)

    def drop_recording(self, draft: RecordingDraft) -> None:
        """Delete the draft of a recording that is saved, or not wanted.

        Raises:
            LibraryError: The disk refuses.
        """
        with on_disk(LIBRARY_NOT_DELETED, draft.name):
            draft.drop()

    def unsaved_recordings(self) -> list[UnsavedRecording]:
        """Return the unsaved recordings of killed programs, the oldest first.

        Raises:
            LibraryError: The folder cannot be read.
        """
        with on_disk(LIBRARY_UNREADABLE, str(self._folder)):
            return self._recordings.abandoned()

    def keep_recording(self, unsaved: UnsavedRecording) -> str:
        """Save the unsaved recording of a killed program.

        Returns:
            Its name.

        Raises:
            LibraryError: It is gone, it cannot be written, or the disk refuses.
        """
        with on_disk(LIBRARY_NOT_SAVED, unsaved.name):
            recording = self._recordings.load(unsaved)
        name = self.free_name(recording.name)
        self.save(replace(recording, name=name))
        with on_disk(LIBRARY_NOT_DELETED, unsaved.name):
            self._recordings.drop(unsaved)
        return name

    def discard_recording(self, unsaved: UnsavedRecording) -> Deleted:
        """Move the unsaved recording of a killed program to the bin, where `restore` finds it.

        Raises:
            LibraryError: See `keep_recording`.
        """
        return self.delete([self.keep_recording(unsaved)])

    # Files ----------------------------------------------------------------------------------------

    def _scan(self) -> dict[str, StoredFile]:
        """Return all files by the name of what they hold."""
        with on_disk(LIBRARY_UNREADABLE, str(self._folder)):
            return self._file_store.scan()

    def _verify(self, content: Content) -> None:
        """Ensure that the saved content can be read again.

        Raises:
            LibraryError: It could not.
        """
        call = self._call if is_large(content) else call_directly
        found = call(first_fault, content)
        if found is not None:
            row, reason = found
            raise LibraryError(reason, row)

    def _write(self, content: Content, replacing: str | None, into: str | None = None) -> bool:
        """Write a content: in the place of the one to replace, or as a new file.

        Args:
            content: The content of the file.
            replacing: The name of the trajectory to replace, if any.
            into: The sub-folder for a new file; ``None`` for `new_in`.

        Returns:
            True if another program had changed the one to replace.
        """
        found = self._scan()
        if content.name != replacing and content.name in found:
            raise LibraryError(NAME_TAKEN(name=content.name))
        old = None if replacing is None else found.get(replacing)
        if old is not None and old.entry.damage is not None:
            raise LibraryError(LIBRARY_DAMAGED(name=str(replacing)))
        stems = {folded(kept.path.stem) for kept in found.values() if kept is not old}
        folder = self._folders.path(self.new_in if into is None else into) or self._folder
        if old is not None:
            folder = old.path.parent
        fitting = folder / (free_stem(content.name, stems) + suffix_of(content))
        in_place = old is not None and old.path.suffix == fitting.suffix
        path = old.path if old is not None and in_place else fitting
        with on_disk(LIBRARY_NOT_SAVED, content.name):
            self._folder.mkdir(parents=True, exist_ok=True)
            met = None if replacing is None else self._met.get(replacing)
            displaced = old is not None and met is not None and met != old.stamp
            if displaced and old is not None:
                self._bin.keep_copy(old.path)
            (self._call if is_large(content) else call_directly)(write_content, path, content)
            if old is not None and not in_place:
                old.path.unlink()
        if path != fitting and file_stem(content.name) != file_stem(str(replacing)):
            # The file is renamed to fit; where that fails, the name inside the file counts.
            with contextlib.suppress(OSError):
                path = path.rename(fitting)
        with on_disk(LIBRARY_UNREADABLE, str(self._folder)):
            ran_with = None if old is None else old.entry.ran_with
            entry = replace(entry_of(content), ran_with=ran_with)
            self._met[content.name] = self._file_store.note(path, entry)
        self._bases[content.name] = content.modified
        return displaced


def free_name(wanted: str, taken: Container[str]) -> str:
    """Return a name that is not taken: the wanted, or the wanted with a number.

    Args:
        wanted: Any text; what no name can hold is left out of it.
        taken: The names there are.
    """
    if check_name(wanted) is not None:
        plain = wanted.encode(errors="ignore").decode().replace("\0", "")
        wanted = " ".join(plain.split()) or "?"
    wanted = wanted[: LONGEST_NAME - _ROOM_FOR_NUMBER].rstrip()
    name, number = wanted, 1
    while name in taken:
        number += 1
        name = f"{wanted} {number}"
    return name
