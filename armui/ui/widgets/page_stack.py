"""Pages or panels in one place, one of them seen; what is too large for the room scrolls."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QStackedWidget, QWidget

from armui.ui.widgets.page import Page


class _Room(QWidget):
    """Needs the least room of the page that is seen, not that of the largest, nor what it likes."""

    def __init__(self, stack: QStackedWidget) -> None:
        super().__init__()
        self.stack = stack
        stack.setParent(self)
        stack.currentChanged.connect(self.updateGeometry)

    def minimumSizeHint(self) -> QSize:
        """That of the page that is seen, in the width there is."""
        page = self.stack.currentWidget()
        if page is None:
            return QSize(0, 0)
        least, layout = page.minimumSizeHint(), page.layout()
        if layout is not None and layout.hasHeightForWidth():
            least.setHeight(layout.minimumHeightForWidth(max(self.width(), least.width())))
        return least

    def sizeHint(self) -> QSize:
        """The same."""
        return self.minimumSizeHint()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """In another width the lines of controls are others."""
        super().resizeEvent(event)
        self.stack.setGeometry(self.rect())
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def event(self, event: QEvent) -> bool:
        """Something in the page needs more room, or less."""
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().event(event)


class StackArea(QScrollArea):
    """Never asks for more height than there is: a low window keeps its status bar in sight.

    Args:
        stack: One of its widgets is seen.
    """

    def __init__(self, stack: QStackedWidget) -> None:
        super().__init__()
        viewport = QWidget()
        viewport.setAutoFillBackground(False)
        self.setViewport(viewport)  # to ask for Qt's own has PySide load every class of widgets
        self._room = _Room(stack)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setWidget(self._room)
        self._room.setAutoFillBackground(False)
        stack.currentChanged.connect(self.updateGeometry)

    def minimumSizeHint(self) -> QSize:
        """As wide as what is seen needs beside the scroll bar; as low as may be."""
        bar_px = self.verticalScrollBar().sizeHint().width()
        return QSize(self._room.minimumSizeHint().width() + bar_px, 0)


class PageStack(StackArea):
    """Holds pages that come and go."""

    def __init__(self) -> None:
        self._stack = QStackedWidget()
        super().__init__(self._stack)

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
        self._room.updateGeometry()

    def drop_page(self, page: Page) -> None:
        """Let go of a page, which is hidden then and belongs to the window."""
        self._stack.removeWidget(page)
        page.hide()
        page.setParent(self.window())
        self._room.updateGeometry()
