"""Pages in one place, one of them seen; what is too high for the room there is scrolls."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QFrame, QScrollArea, QStackedWidget

from armui.ui.widgets.page import Page


class _Stack(QStackedWidget):
    """Needs the room of the page that is seen, not that of the largest."""

    def minimumSizeHint(self) -> QSize:
        """That of the page that is seen."""
        page = self.currentWidget()
        return QSize(0, 0) if page is None else page.minimumSizeHint()

    def sizeHint(self) -> QSize:
        """Likewise."""
        page = self.currentWidget()
        return QSize(0, 0) if page is None else page.sizeHint()


class PageStack(QScrollArea):
    """Never asks for more height than there is: a low window keeps its status bar in sight."""

    def __init__(self) -> None:
        super().__init__()
        self._stack = _Stack()
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWidget(self._stack)
        self.viewport().setAutoFillBackground(False)
        self._stack.setAutoFillBackground(False)

    @property
    def current(self) -> Page | None:
        """The page that is seen, or would be if the stack were."""
        page = self._stack.currentWidget()
        return page if isinstance(page, Page) else None

    def holds(self, page: Page) -> bool:
        """Whether a page is one of these."""
        return self._stack.indexOf(page) >= 0

    def show_page(self, page: Page) -> None:
        """Show a page, which becomes one of these."""
        if not self.holds(page):
            self._stack.addWidget(page)
        self._stack.setCurrentWidget(page)
        self._stack.updateGeometry()

    def drop_page(self, page: Page) -> None:
        """Let go of a page, which is hidden then and belongs to the window."""
        self._stack.removeWidget(page)
        page.hide()
        page.setParent(self.window())
        self._stack.updateGeometry()

    def minimumSizeHint(self) -> QSize:
        """As wide as the page needs; as low as may be."""
        return QSize(self._stack.minimumSizeHint().width(), 0)
