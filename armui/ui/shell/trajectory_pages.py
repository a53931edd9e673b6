"""轨迹库 and the pages it leads to; loaded when the library is first opened."""

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
    from armui.ui.picture.picture_work import PictureWork
    from armui.ui.shell.page_area import PageArea
    from armui.ui.shell.workspace import Workspace
    from armui.ui.trajectory.editor.editor_page import EditorPage
    from armui.ui.trajectory.library.library_page import LibraryPage
    from armui.ui.trajectory.preview.path_preview import PathPreview


class TrajectoryPages(QObject):
    """Makes the library, and has every page of it stand where pages stand.

    Args:
        controller: Runs trajectories, and knows where the arm is.
        workspace: Takes care of the pages.
        area: Where they stand in the main window.
        preferences: Keep the tool.
        workers: Who does what takes long.
        files: Who does what waits for a disk; the workers by default.
        folder: Of the library; the user's own by default.
        preview: Shows the path that was checked last.
        picture: What is clicked and dragged in the 3D picture leads to a page.
        parent: The main window.

    Signals:
        run_asks: The name of what was sent and waits for the operator to agree; "": nothing does.
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
            name: Of the trajectory; the editor that was used last by default, if one is open.
        """
        if name:
            self._made().open_trajectory(name)
        elif self.editor is not None:
            self.editor.open()

    def open_file(self, path: Path) -> None:
        """Show what a file holds in an editor, or why it cannot be shown, in the library."""
        self._made().open_file(path)

    def open_recorder(self) -> None:
        """Show the page that records; the way back from it leads to the library."""
        self._made().open_recorder()

    def keep_drafts(self) -> None:
        """Write down what is not saved; the program may go on."""
        if self._library is not None:
            self._library.editors.keep_drafts()

    def keep_work(self) -> None:
        """The program ends: what is not saved is offered the next time."""
        if self._library is not None:
            self._library.keep_work()

    def _made(self) -> LibraryPage:
        if self._library is None:
            self._library = self._make()
        return self._library

    def _make(self) -> LibraryPage:
        from armui.trajectory.library.store import Library  # noqa: PLC0415 - numpy, scipy
        from armui.ui.trajectory.library.library_page import LibraryPage  # noqa: PLC0415 - as above
        from armui.ui.trajectory.preview.preview_link import PreviewLink  # noqa: PLC0415 - as above

        folder = self._folder or paths.trajectories()
        files = self._files
        library = (
            Library(folder, call=files.call) if isinstance(files, FileThread) else Library(folder)
        )
        background = Background(self._workers, files, self)
        page = LibraryPage(self._controller, background, library)
        self._workspace.add(page, self._area)
        page.run_asks.connect(self.run_asks)
        page.page_made.connect(partial(self._workspace.add, home=self._area))
        self._picture.link(PreviewLink(page, self._preview, self._controller))
        return page
