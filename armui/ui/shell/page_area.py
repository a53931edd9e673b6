"""The pages beside the 3D picture: one is seen, those below it wait as they were left."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QWidget

from armui.ui.shell.page_bar import PageBar
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.page import Page
from armui.ui.widgets.page_stack import PageStack

_LEAST_PX: Final = 480


class PageArea(QWidget):
    """Stands in the place of the panels while a page is seen.

    Signals:
        shown: A page is to be seen: the area is to be shown.
        emptied: The last page was left.
        take_out_wanted: The page that is seen shall stand in a window of its own.
    """

    shown = Signal()
    emptied = Signal()
    take_out_wanted = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("page_area")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setMinimumWidth(_LEAST_PX)
        self._open: list[Page] = []
        self._bar = PageBar()
        self._stack = PageStack()
        in_column(self._bar, (self._stack, 1), on=self, spacing=10, margins=(16, 10, 16, 10))
        self._bar.back_wanted.connect(self._on_back)
        self._bar.page_wanted.connect(self._on_back)
        self._bar.take_out_wanted.connect(self._on_take_out)

    @property
    def pages(self) -> tuple[Page, ...]:
        """Those that are open here, the one that is seen last."""
        return tuple(self._open)

    @property
    def current(self) -> Page | None:
        """The page that is seen, or would be if the area were."""
        return self._open[-1] if self._open else None

    def show_page(self, page: Page) -> None:
        """Show a page in front of the others; it stays until it is dropped."""
        if page in self._open:
            self._open.remove(page)
        else:
            page.titled.connect(self._name)
        self._open.append(page)
        self._show_current()
        self.shown.emit()
        page.take_focus()

    def drop_page(self, page: Page) -> None:
        """Let go of a page; the one before it is seen again."""
        if page not in self._open:
            return
        seen = page.isVisible()
        self._open.remove(page)
        page.titled.disconnect(self._name)
        self._stack.drop_page(page)
        if not self._open:
            self.emptied.emit()
        else:
            self._show_current()
            if seen:
                self._open[-1].take_focus()

    def _show_current(self) -> None:
        self._stack.show_page(self._open[-1])
        self._name()

    def _name(self) -> None:
        path: list[Page] = []
        page: Page | None = self._open[-1]
        while page is not None:
            path.insert(0, page)
            page = page.above
        self._bar.show_path(path)

    def _on_back(self, *_: object) -> None:
        """To go back is to leave the page that is seen, which may ask."""
        self._open[-1].leave()

    def _on_take_out(self) -> None:
        self.take_out_wanted.emit(self._open[-1])
