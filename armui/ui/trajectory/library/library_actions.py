"""The operator's actions on the list of the library, with undo."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Final

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QPushButton

from armui.control.events import Level
from armui.trajectory.library.folders import shown_folder
from armui.trajectory.library.history import (
    Deletion,
    LibraryHistory,
    Moving,
    Origin,
    Renaming,
    Step,
)
from armui.trajectory.library.store import Deleted, Listing
from armui.trajectory.points.program import Trajectory
from armui.ui import format as fmt
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.keys import SHORTCUTS, key_text
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.widgets.buttons import named
from armui.ui.widgets.message_line import Words

_WIDEST_PX: Final = 170


class _CutButton(QPushButton):
    """Cuts a text that would make it too wide."""

    def setText(self, text: str) -> None:  # noqa: N802 - Qt's name
        """Set the text, shortened to the greatest width."""
        right = Qt.TextElideMode.ElideRight
        super().setText(self.fontMetrics().elidedText(text, right, _WIDEST_PX))


class LibraryActions(HasActs, QObject):
    """Creates, copies, renames, deletes; actions can be undone, the last one first.

    Args:
        work: Changes the library.
        why_used: Returns why these are not changed now; "" if they may be.
        parent: Its owner.

    Signals:
        message_changed: A text, or a function that returns it, and its :class:`Level`.
        changed: The library has changed; with the names to be selected.
    """

    message_changed = Signal(object, object)
    changed = Signal(object)
    undo_button = Act(
        SHORTCUTS["library.undo"].title,
        named="library_undo",
        key="library.undo",
        shortcut="",
        kind=lambda name: named(name, _CutButton()),
    )

    def __init__(
        self, work: LibraryWork, why_used: Callable[[Sequence[str]], str], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._work = work
        self._library = work.library
        self._why_used = why_used
        self._history = LibraryHistory(work.library)

    def listing(self) -> Listing:
        """Return the library's content, after dropping steps that cannot be undone any more.

        For the thread that works on the library.

        Raises:
            LibraryError: The folder cannot be read.
        """
        seen = self._library.listing()
        self._history.drop_outdated(seen)
        return seen

    def create(
        self, name: str, then: Callable[[Trajectory], object], refused: Callable[[str], object]
    ) -> None:
        """Put an empty trajectory into the library.

        Args:
            name: Its name.
            then: Called with it once it exists.
            refused: Called with the reason as a text, if it could not be created.
        """

        def make() -> Trajectory:
            trajectory = self._library.create(name)
            self._history.note_made([name], Origin.CREATED)
            return trajectory

        def made(trajectory: Trajectory) -> None:
            self._done([trajectory.name])
            then(trajectory)

        self._work.do(make, made, refused)

    def duplicate(self, name: str) -> None:
        """Copy a trajectory under a free name."""

        def make() -> list[str]:
            new = self._library.free_name(name)
            self._library.duplicate(name, new)
            self._history.note_made([new], Origin.COPIED)
            return [new]

        self._work.do(make, self._done, self._on_refused)

    def rename(self, name: str, new: str) -> None:
        """Rename a trajectory."""
        if not self._refuse_used([name]):
            self._work.do(
                lambda: self._history.rename(name, new),
                lambda _: self._done([new]),
                self._on_refused,
            )

    def delete(self, names: Sequence[str]) -> None:
        """Move trajectories to the bin."""
        if not names or self._refuse_used(names):
            return
        self._work.do(lambda: self._history.delete(names), self._on_deleted, self._on_refused)

    def _on_deleted(self, deleted: Deleted) -> None:
        gone = deleted.names
        self._done([], partial(self._deleted, gone) if gone else "")

    def move(self, names: Sequence[str], folder: str) -> None:
        """Move trajectories to a sub-folder; "" for the library's folder itself."""

        def moved(now: tuple[str, ...]) -> None:
            self._done(None, partial(self._moved, now, folder) if now else "")

        self._work.do(lambda: self._history.move(names, folder), moved, self._on_refused)

    def create_folder(
        self, name: str, then: Callable[[], object], refused: Callable[[str], object]
    ) -> None:
        """Make a sub-folder.

        Args:
            name: Its name.
            then: Called once it exists.
            refused: Called with the reason as a text, if it could not be created.
        """
        self._change_folders(lambda: self._library.create_folder(name), then, refused)

    def rename_folder(
        self, old: str, new: str, then: Callable[[], object], refused: Callable[[str], object]
    ) -> None:
        """Give a sub-folder another name; see `create_folder`."""
        self._change_folders(lambda: self._library.rename_folder(old, new), then, refused)

    def delete_folder(self, name: str, then: Callable[[], object]) -> None:
        """Delete an empty sub-folder; one that is not empty is refused in words."""
        self._change_folders(lambda: self._library.delete_folder(name), then, self._on_refused)

    def _change_folders(
        self,
        change: Callable[[], None],
        then: Callable[[], object],
        refused: Callable[[str], object],
    ) -> None:
        def done(_: None) -> None:
            then()
            self._done(None)

        def not_done(text: str) -> None:
            self.changed.emit(None)  # somebody else may have changed the folders
            refused(text)

        self._work.do(change, done, not_done)

    def note_imported(self, names: Sequence[str]) -> None:
        """Remember imported trajectories, so that the import can be undone."""
        if names:
            self._work.do(
                lambda: self._history.note_made(names, Origin.IMPORTED),
                lambda _: self.show_acts(),
                self._on_refused,
            )

    @undo_button.pressed
    def undo(self) -> None:
        """Undo the last step."""
        step = self._history.last
        if step is None or self._refuse_used(step.touched):
            return
        self._work.do(
            self._history.undo,
            lambda back: self._done(back, partial(self._undone, step, back)),
            self._on_refused,
        )

    def bring_back(self, deleted: Sequence[Deleted]) -> None:
        """Restore deleted trajectories."""
        self._work.do(
            lambda: self._history.bring_back(deleted),
            lambda back: self._done(back, partial(self._brought_back, back)),
            self._on_refused,
        )

    def _refuse_used(self, names: Sequence[str]) -> bool:
        """Return whether one of these is in use; then that is said."""
        why = self._why_used(names)
        if why:
            self.message_changed.emit(why, Level.WARNING)
        return bool(why)

    def _on_refused(self, text: str) -> None:
        # the library may have changed since it was listed
        self.changed.emit(None)
        self.show_acts()
        self.message_changed.emit(text, Level.FAULT)

    def _done(self, names: Sequence[str] | None, text: Words = "") -> None:
        self.changed.emit(names)
        self.show_acts()
        self.message_changed.emit(text, Level.DONE)

    # Texts ------------------------------------------------------------------------------------

    def _undone(self, step: Step, back: Sequence[str]) -> str:
        if isinstance(step, Deletion):
            return self._brought_back(back)
        if isinstance(step, Renaming):
            return self.tr("“{new}” is called “{old}” again.").format(new=step.new, old=step.old)
        if isinstance(step, Moving):
            return self.tr("Moved back: {names}").format(names=fmt.name_list(back))
        return self._deleted(step.names)

    def _deleted(self, names: Sequence[str]) -> str:
        return self.tr("Deleted: {names}").format(names=fmt.name_list(names))

    def _moved(self, names: Sequence[str], folder: str) -> str:
        told = fmt.name_list(names)
        if not folder:
            return self.tr("In no folder now: {names}").format(names=told)
        text = self.tr("Moved to the folder “{folder}”: {names}")
        return text.format(folder=shown_folder(folder), names=told)

    def _brought_back(self, names: Sequence[str]) -> str:
        return self.tr("Restored: {names}").format(names=fmt.name_list(names))

    @undo_button.there
    def _can_undo(self) -> bool:
        return self._history.last is not None

    @undo_button.text
    def _undo_text(self) -> str:
        return self._undo_texts()[0]

    @undo_button.tip
    def _undo_tip(self) -> str:
        text, effect = self._undo_texts()
        return f"{text} ({key_text('library.undo')})\n{effect}"

    def _undo_texts(self) -> tuple[str, str]:
        """Return the name and the effect of the next step of undo; empty texts if there is none."""
        step = self._history.last
        if step is None:
            return "", ""
        names = fmt.name_list(step.names)
        if isinstance(step, Deletion):
            text, effect = self.tr("Undo deleting “{names}”"), self.tr("Restores it.")
        elif isinstance(step, Renaming):
            text = self.tr("Undo renaming to “{names}”")
            effect = self.tr("It is called “{names}” again.").format(names=names)
            names = step.new
        elif isinstance(step, Moving):
            text = self.tr("Undo moving “{names}”")
            effect = self.tr("It goes back to the folder it came from.")
        else:
            text = {
                Origin.CREATED: self.tr("Undo creating “{names}”"),
                Origin.COPIED: self.tr("Undo copying to “{names}”"),
                Origin.IMPORTED: self.tr("Undo importing “{names}”"),
            }[step.origin]
            effect = self.tr("Deletes it; it can be restored for 30 days.")
        return text.format(names=names), effect
