"""Opens pages by their names, takes them out and puts them back: for the palette, at a start."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from armui.ui.actions.places import MOVABLE

if TYPE_CHECKING:
    from armui.ui.actions.offer import Doing, Doings
    from armui.ui.main_window import MainWindow
    from armui.ui.shell.drawer import Drawer
    from armui.ui.shell.trajectory_pages import TrajectoryPages
    from armui.ui.shell.watch_windows import WatchWindows
    from armui.ui.shell.workspace import Workspace
    from armui.ui.widgets.page import Page


class PageActions(QObject):
    """Knows how each place is opened, and why it cannot be.

    Args:
        window: The main window.
        workspace: Knows where each page stands.
        pages: Open the library and what it leads to.
        watch: Opens the drawer's pages and the recordings.
        drawer: Is folded away.

    Attributes:
        is_done: Whether what was open at the end of the program before is open again.
    """

    def __init__(
        self,
        window: MainWindow,
        workspace: Workspace,
        pages: TrajectoryPages,
        watch: WatchWindows,
        drawer: Drawer,
    ) -> None:
        super().__init__(window)
        self._window = window
        self.is_done = False
        self._workspace = workspace
        self._pages = pages
        self._drawer = drawer
        self._openers: Mapping[str, Doing] = {
            "library": pages.open_library,
            "editor": pages.open_editor,
            "recording": pages.open_recorder,
            "plots": lambda: watch.show_as_curves(()),
            "events": watch.show_events,
            "bus": watch.open_bus_monitor,
            "sessions": watch.open_sessions,
            "connect": window.open_connect_dialog,
            "settings": window.open_settings_dialog,
        }

    def openers(self) -> Doings:
        """By place: what opens it, and why that is not possible now."""
        return {place: (do, partial(self._why_not, place)) for place, do in self._openers.items()}

    def doings(self) -> Doings:
        """By the names of commands that no button does while their page is not seen."""
        found: dict[str, tuple[Doing, Callable[[], str]]] = {
            "drawer.fold": (self._drawer.fold, self._why_no_fold),
        }
        for key in MOVABLE:
            found[f"{key}.take_out"] = (
                partial(self._take_out, key),
                partial(self._why_no_take_out, key),
            )
            found[f"{key}.put_back"] = (
                partial(self._put_back, key),
                partial(self._why_no_put_back, key),
            )
        return found

    def reopen(self) -> None:
        """Open the windows that were open when the program ended, one at each turn of the loop.

        The first window is seen and its modules are loaded by then: a start waits for none of them.
        """
        left = self._workspace.next_left_open()
        if left is None:
            self._workspace.note_windows()  # what is not there any more is forgotten
            self._window.activateWindow()
            self.is_done = True
            return
        if left.key == "editor":
            self._pages.open_editor(left.subject)
        elif left.key in MOVABLE:
            self._openers[left.key]()
        QTimer.singleShot(0, self, self.reopen)

    def _why_not(self, place: str) -> str:
        if place == "editor" and self._pages.editor is None:
            return self.tr("Open a trajectory of the library first.")
        return ""

    def _page(self, key: str) -> Page | None:
        """The page of a kind: of several editors the one that was used last."""
        return self._pages.editor if key == "editor" else self._workspace.page_of(key)

    def _is_out(self, key: str) -> bool:
        page = self._page(key)
        return page is not None and self._workspace.is_taken_out(page)

    def _take_out(self, key: str) -> None:
        self._openers[key]()
        page = self._page(key)
        if page is not None and not self._workspace.is_taken_out(page):
            self._workspace.take_out(page)

    def _put_back(self, key: str) -> None:
        page = self._page(key)
        if page is not None:
            self._workspace.put_back(page)

    def _why_no_take_out(self, key: str) -> str:
        if self._is_out(key):
            return self.tr("It stands in a window of its own.")
        return self._why_not(key)

    def _why_no_put_back(self, key: str) -> str:
        return "" if self._is_out(key) else self.tr("It stands in no window of its own.")

    def _why_no_fold(self) -> str:
        return self.tr("The drawer is folded away.") if self._drawer.isHidden() else ""
