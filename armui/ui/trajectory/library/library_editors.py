"""The pages of the library: an editor for each trajectory, one page for recordings."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from armui.control.events import Level
from armui.trajectory.points.program import Trajectory
from armui.ui.actions.operator_view import why_taken
from armui.ui.trajectory.editor.editor_page import EditorPage
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.recording.recording_page import RecordingPage

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.run.preflight import Checks
    from armui.trajectory.files import Content
    from armui.trajectory.samples.recording import Recording
    from armui.ui.background import Background
    from armui.ui.trajectory.running.run_bar import RunChoices


class LibraryEditors(QObject):
    """Opens trajectories, each of them once, with their unsaved changes.

    Args:
        controller: For the pages.
        background: Runs long work.
        checks: Checks trajectories.
        work: Reads and saves them.
        choices: The options of runs.
        parent: The library's page.

    Signals:
        page_made: A :class:`Page`, before it wants to be shown.
        editor_opened: An :class:`EditorPage`, before it is shown.
        recorder_opened: A :class:`RecordingPage` likewise.
        changed: Something was saved or left; with the names to be selected, or ``None``.
        message_changed: A text and its :class:`Level`.
        refused: The library's reason for a refusal, as a text.
    """

    page_made = Signal(object)
    editor_opened = Signal(object)
    recorder_opened = Signal(object)
    changed = Signal(object)
    message_changed = Signal(str, object)
    refused = Signal(str)

    def __init__(
        self,
        controller: ArmController,
        background: Background,
        checks: Checks,
        work: LibraryWork,
        *,
        choices: RunChoices,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._background = background
        self._checks = checks
        self._choices = choices
        self._work = work
        self._library = work.library
        self._editors: dict[str, EditorPage] = {}
        self._folders: Mapping[str, str] = {}
        self._used = ""
        self._recorder: RecordingPage | None = None

    def __contains__(self, name: str) -> bool:
        """Return whether a trajectory is open."""
        return name in self._editors

    @property
    def used(self) -> EditorPage | None:
        """The editor used last, or ``None`` if none is open."""
        last = next(reversed(self._editors.values()), None)
        return self._editors.get(self._used, last)

    def show_folders(self, folders: Mapping[str, str]) -> None:
        """Show in the titles where trajectories lie.

        Args:
            folders: The sub-folder of each by its name; "" for the library's folder itself.
        """
        self._folders = folders
        for name, editor in self._editors.items():
            editor.show_folder(folders.get(name, ""))

    def open(self, name: str, *, unsaved: bool) -> None:
        """Open a trajectory, or a recording.

        Args:
            name: Its name in the library.
            unsaved: True if only unsaved changes of it exist.
        """
        if taken := why_taken("editor.open"):
            self.message_changed.emit(taken, Level.WARNING)
        elif name in self._editors:
            self._editors[name].open()
        elif unsaved:
            self._open_draft(name)
        else:
            self._work.do(
                lambda: self._library.load(name, to_edit=True),
                self._open_content,
                self.refused.emit,
            )

    def _open_content(self, content: Content) -> None:
        if isinstance(content, Trajectory):
            self.open_editor(content)
        else:
            self.open_recorder(content)

    def _open_draft(self, name: str) -> None:
        """Open a trajectory that was never saved: its draft is applied to an empty one."""

        def opened(draft: Trajectory | None) -> None:
            if draft is None:  # another program has saved or discarded it meanwhile
                self.changed.emit(None)
            else:
                self._show_editor(Trajectory(name, modified=draft.modified), draft)

        self._work.do(lambda: self._library.draft(name), opened, self.refused.emit)

    def open_editor(self, trajectory: Trajectory) -> None:
        """Open a trajectory that was read, with its unsaved changes."""

        def damaged(text: str) -> None:
            self.message_changed.emit(text, Level.WARNING)
            self._show_editor(trajectory, None)

        def read() -> tuple[Trajectory | None, bool]:
            aside = self._library.set_aside_draft(trajectory)
            return self._library.draft(trajectory.name), aside

        def show(found: tuple[Trajectory | None, bool]) -> None:
            draft, aside = found
            self._show_editor(trajectory, draft, aside=aside)

        self._work.do(read, show, damaged)

    def _show_editor(
        self, trajectory: Trajectory, draft: Trajectory | None, *, aside: bool = False
    ) -> None:
        name = trajectory.name
        if name in self._editors:  # opened again while it was being read
            self._editors[name].open()
            return
        work = LibraryWork(self._library, self._background, self)
        editor = EditorPage(
            self._controller, self._checks, self._choices, work, trajectory, draft=draft
        )
        editor.show_folder(self._folders.get(name, ""))
        if aside:
            editor.show_draft_not_applied()
        self._editors[name] = editor
        self.page_made.emit(editor)
        self.editor_opened.emit(editor)
        editor.saved.connect(lambda: self.changed.emit(None))
        editor.closed.connect(partial(self._on_left, name))
        editor.used.connect(partial(self._on_used, name))
        editor.insert_wanted.connect(self._insert_current)
        editor.open()

    def _on_used(self, name: str) -> None:
        self._used = name

    def _insert_current(self) -> None:
        """Insert the arm's position as a point in the editor that was used last."""
        if self._used in self._editors:
            self._editors[self._used].insert_current()

    def _on_left(self, name: str) -> None:
        self._editors.pop(name).deleteLater()  # not at once: the page is emitting the signal
        self.changed.emit(None)

    def keep_drafts(self) -> None:
        """Save all drafts, because the program may end."""
        for editor in self._editors.values():
            editor.keep_draft()
        if self._recorder is not None:
            self._recorder.keep_draft()

    # Recordings -------------------------------------------------------------------------------

    def open_recorder(self, recording: Recording | None = None) -> None:
        """Open the page that records, or trims and thins a given recording.

        A page in use is shown unchanged, so that its content is not replaced by another recording.
        """
        recorder = self._recorder
        if recorder is not None and recording is not None and not recorder.in_use:
            recorder.leave()
            recorder = self._recorder
        if recorder is None:
            recorder = self._recorder = RecordingPage(
                self._controller, self._background, self._library, recording
            )
            recorder.saved.connect(lambda name: self.changed.emit([name]))
            recorder.closed.connect(self._on_recorder_closed)
            self.page_made.emit(recorder)
            self.recorder_opened.emit(recorder)
        recorder.open()

    def _on_recorder_closed(self) -> None:
        if self._recorder is not None:
            self._recorder.deleteLater()
            self._recorder = None
