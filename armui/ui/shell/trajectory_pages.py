"""Loads 轨迹库 and its pages when the library is first opened."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from armui.system import paths
from armui.system.helper_process import FileThread
from armui.ui.background import Background

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from armui.control.arm_controller import ArmController
    from armui.settings import SettingsStore
    from armui.trajectory.library.store import Library
    from armui.ui.picture.picture_work import PictureWork
    from armui.ui.shell.page_area import PageArea
    from armui.ui.shell.workspace import Workspace
    from armui.ui.trajectory.editor.editor_page import EditorPage
    from armui.ui.trajectory.library.library_page import LibraryPage
    from armui.ui.trajectory.preview.path_preview import PathPreview


class TrajectoryPages(QObject):
    """Creates the library, and shows each of its pages in the place of pages.

    Args:
        controller: Runs trajectories, and gives the arm's state.
        workspace: Manages the pages.
        area: Their place in the main window.
        preferences: The settings with the tool.
        workers: Runs long work.
        files: Runs work that waits for a disk; by default the workers.
        folder: The folder of the library; by default the user's own.
        preview: Shows the path that was checked last.
        picture: The 3D picture, in which points are clicked and dragged.
        parent: The main window.

    Signals:
        run_asks: The name of the trajectory that waits for confirmation; "" if none does.
    """

    run_asks = Signal(str)

    def __init__(
        self,
        controller: ArmController,
        workspace: Workspace,
        area: PageArea,
        *,
        preferences: SettingsStore,
        workers: Executor,
        files: Executor | None,
        folder: Path | None,
        preview: PathPreview,
        picture: PictureWork,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._preferences = preferences
        self._workers, self._files, self._folder = workers, files, folder
        self._workspace, self._area = workspace, area
        self._preview, self._picture = preview, picture
        self._library: LibraryPage | None = None

    def open_library(self) -> None:
        """Show 轨迹库 (manual 1.0.9)."""
        self._made().open()

    @property
    def editor(self) -> EditorPage | None:
        """The editor that was used last, if one is open."""
        return None if self._library is None else self._library.editors.used

    def open_editor(self, name: str = "") -> None:
        """Show an editor.

        Args:
            name: The name of the trajectory; by default the editor used last is shown, if one is
                open.
        """
        if name:
            self._made().open_trajectory(name)
        elif self.editor is not None:
            self.editor.open()

    def open_file(self, path: Path) -> None:
        """Open a file in an editor, or show in the library why that fails."""
        self._made().open_file(path)

    def open_recorder(self) -> None:
        """Show the page that records, from which the way back leads to the library."""
        self._made().open_recorder()

    def keep_drafts(self) -> None:
        """Save unsaved trajectories as drafts; the program may go on."""
        if self._library is not None:
            self._library.editors.keep_drafts()

    def keep_work(self) -> None:
        """Save all unsaved work, because the program ends; it is offered the next time."""
        if self._library is not None:
            self._library.keep_work()

    def _made(self) -> LibraryPage:
        if self._library is None:
            self._library = self._make()
        return self._library

    def _make(self) -> LibraryPage:
        from armui.ui.trajectory.library.library_page import LibraryPage  # noqa: PLC0415 - as above
        from armui.ui.trajectory.preview.preview_link import PreviewLink  # noqa: PLC0415 - as above

        library = open_library(self._folder or paths.trajectories(), self._files)
        background = Background(self._workers, self._files, self)
        page = LibraryPage(self._controller, background, library)
        self._workspace.add(page, self._area)
        page.run_asks.connect(self.run_asks)
        page.page_made.connect(partial(self._workspace.add, home=self._area))
        self._picture.link(PreviewLink(page, self._preview, self._controller))
        return page


def open_library(folder: Path, files: Executor | None) -> Library:
    """Return the library in a folder; where there is a thread for files, it has large ones read."""
    from armui.trajectory.library.store import Library  # noqa: PLC0415 - numpy, scipy

    return Library(folder, call=files.call) if isinstance(files, FileThread) else Library(folder)
