"""Opens pages by their keys, takes them out and puts them back, by the palette and at the start."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer

from armui.ui.actions.command import Command, CommandSource, Target, new_action, source_of
from armui.ui.shell.pages import PAGES
from armui.ui.widgets.buttons import enable_or_explain
from armui.ui.widgets.page import Page
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from armui.ui.actions.palette_items import Callback
    from armui.ui.shell.drawer import Drawer
    from armui.ui.shell.page_opener import PageOpener
    from armui.ui.shell.workspace import Workspace

_MOVABLE: Final = tuple(key for key, page in PAGES.items() if page.movable)


class PageActions(QObject):
    """The actions on pages and windows, with the reasons against them.

    Args:
        window: The main window.
        workspace: Manages the places of pages.
        pages: Opens pages and windows.
        drawer: The drawer that is closed.

    Attributes:
        startup_done: True when the windows open at the last end of the program have been reopened.
    """

    commands = (
        *(
            Command(f"{key}.{act}", title)
            for key in _MOVABLE
            for act, title in (
                ("take_out", Text("PageBar", "Own window")),
                ("put_back", Text("PageWindow", "Put back")),
            )
        ),
        Command("drawer.fold", Text("Drawer", "Fold away")),
    )

    def __init__(
        self, window: QWidget, workspace: Workspace, pages: PageOpener, drawer: Drawer
    ) -> None:
        super().__init__(window)
        self._window = window
        self.startup_done = False
        self._workspace = workspace
        self._pages = pages
        self._drawer = drawer
        does: dict[str, Callback] = {"drawer.fold": drawer.fold}
        for key in _MOVABLE:
            does[f"{key}.take_out"] = partial(self._take_out, key)
            does[f"{key}.put_back"] = partial(self._put_back, key)
        self._actions = {name: new_action(self, do) for name, do in does.items()}

    def command_targets(self) -> Mapping[str, Target]:
        """Return the actions that take pages out, put them back, and close the drawer."""
        for key in _MOVABLE:
            enable_or_explain(self._actions[f"{key}.take_out"], self._why_no_take_out(key))
            enable_or_explain(self._actions[f"{key}.put_back"], self._why_no_put_back(key))
        enable_or_explain(self._actions["drawer.fold"], self._why_no_fold())
        return self._actions

    def sources(self) -> list[CommandSource]:
        """Return the commands of each page and each window."""
        own = (
            CommandSource(
                page.kind().commands,  # imports the page's module, if idle time has not done so
                partial(self._pages.existing, key),
                partial(self._pages.show, key),
                why_not=partial(self._why_not, key),
            )
            for key, page in PAGES.items()
        )
        return [*own, source_of(self)]

    def reopen(self) -> None:
        """Open what was open when the program ended, one page in each turn of the event loop.

        The main window is visible and its modules are loaded by then, so that the start is not
        delayed.
        """
        left = self._workspace.next_left_open()
        if left is None:
            self._workspace.note_windows()  # forget windows that could not be opened again
            self._window.activateWindow()
            self.startup_done = True
            return
        if left.key == "editor":
            self._pages.trajectories.open_editor(left.subject)
        elif left.key in _MOVABLE:
            focus = self._window.focusWidget() or self._window
            self._pages.show(left.key)
            focus.setFocus()  # give it back: the operator did not ask for the page
        QTimer.singleShot(0, self, self.reopen)

    def _why_not(self, place: str) -> str:
        if place == "editor" and self._pages.existing("editor") is None:
            return self.tr("Open a trajectory of the library first.")
        return ""

    def _page(self, key: str) -> Page | None:
        page = self._pages.existing(key)
        return page if isinstance(page, Page) else None

    def _is_out(self, key: str) -> bool:
        page = self._page(key)
        return page is not None and self._workspace.is_taken_out(page)

    def _take_out(self, key: str) -> None:
        self._pages.show(key)
        page = self._page(key)
        if page is not None and not self._workspace.is_taken_out(page):
            self._workspace.take_out(page)

    def _put_back(self, key: str) -> None:
        page = self._page(key)
        if page is not None:
            self._workspace.put_back(page)

    def _why_no_take_out(self, key: str) -> str:
        if self._is_out(key):
            return self.tr("It is in its own window.")
        return self._why_not(key)

    def _why_no_put_back(self, key: str) -> str:
        return "" if self._is_out(key) else self.tr("It is not in its own window.")

    def _why_no_fold(self) -> str:
        return self.tr("The drawer is folded away.") if self._drawer.isHidden() else ""
