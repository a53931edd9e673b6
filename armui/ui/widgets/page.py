"""The pages beside the 3D picture or in their own windows, and the stacks that hold them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QContextMenuEvent, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QFrame, QHeaderView, QScrollArea, QStackedWidget, QWidget

from armui.ui.actions.act import HasActs
from armui.ui.widgets.curve_menu import offer_curves
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.translated import Translated

_GAP_PX: Final = 12


class Page(HasActs, Translated, QWidget):
    """Content without a frame: its holder shows the title, the way back, and the stops.

    A page is left, never just closed: :meth:`leave` may ask first. It works only while it is
    visible.

    Args:
        key: Its name in the settings; pages of one kind share it.
        parent: The parent widget.
        footed: True if its body scrolls in a low window, so that the footer stays visible.

    Attributes:
        above: The page that leads to it, and to which the way back leads.
        first: The widget to focus at first; ``None`` for the page itself.
        body: The layout for its content.
        footer: The layout for its last buttons, from left to right.
        leaves_at_escape: True if Escape leaves it.

    Signals:
        titled: Its title has changed.
        wanted: It shall be shown in front.
        closed: It was left for good, and its holder removes it.
    """

    leaves_at_escape = True
    titled = Signal()
    wanted = Signal()
    closed = Signal()

    def __init__(self, key: str, parent: QWidget | None = None, *, footed: bool = False) -> None:
        super().__init__(parent)
        self.key: Final = key
        self.above: Page | None = None
        self.first: QWidget | None = None
        self._title = ""
        self.body = in_column(spacing=_GAP_PX)
        self.footer = in_row(spacing=_GAP_PX // 2)
        self._area = _scrolled(self.body) if footed else None
        in_column((self._area or self.body, 1), self.footer, on=self, spacing=_GAP_PX, margins=0)

    @property
    def subject(self) -> str:
        """The object it works on, if there are several pages of its kind."""
        return ""

    @property
    def wanted_px(self) -> int:
        """The width at which its table shows every column; 0 if it has none that matters."""
        return 0

    @property
    def title(self) -> str:
        """The present title."""
        return self._title

    def set_title(self, title: str) -> None:
        """Set the title."""
        if title != self._title:
            self._title = title
            self.setAccessibleName(title)
            self.titled.emit()

    def headers(self) -> Mapping[str, QHeaderView]:
        """Return the headers of its tables by name, whose widths and order are stored."""
        return {}

    def bring_into_sight(self, part: QWidget) -> None:
        """Scroll to a part of the body once the layout has placed it; ignore a hidden part."""
        area = self._area

        def scroll() -> None:
            if area is not None and part.isVisible():
                area.ensureWidgetVisible(part, 0, 0)

        if area is not None:
            QTimer.singleShot(0, area, scroll)

    # Coming and going -------------------------------------------------------------------------

    def open(self) -> None:
        """Show the page in front, wherever it is."""
        self.wanted.emit()

    def leave(self) -> None:
        """Leave the page for good; one with unsaved work asks first."""
        self.closed.emit()

    def take_focus(self) -> None:
        """Focus the main widget, because the operator has opened the page."""
        found = (each for each in (self.focusWidget(), self.first) if each is not None)
        next(found, self).setFocus(Qt.FocusReason.OtherFocusReason)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Leave the page instead of closing it."""
        event.ignore()
        self.leave()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Leave the page at Escape, unless a field or a table has handled it."""
        if event.key() == Qt.Key.Key_Escape and self.leaves_at_escape:
            event.accept()
            self.leave()
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to show the figure as a curve."""
        offer_curves(self, event)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language; called again when that changes."""


class _Room(QWidget):
    """Holds a stack, and needs only the least size of the visible page, not that of the largest."""

    def __init__(self, stack: QStackedWidget) -> None:
        super().__init__()
        self.stack = stack
        stack.setParent(self)
        stack.currentChanged.connect(self.updateGeometry)

    def minimumSizeHint(self) -> QSize:
        """Return the least size of the visible page in the present width."""
        page = self.stack.currentWidget()
        if page is None:
            return QSize(0, 0)
        least, layout = page.minimumSizeHint(), page.layout()
        if layout is not None and layout.hasHeightForWidth():
            least.setHeight(layout.minimumHeightForWidth(max(self.width(), least.width())))
        return least

    def sizeHint(self) -> QSize:
        """Return the same as :meth:`minimumSizeHint`."""
        return self.minimumSizeHint()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Update the size, because controls wrap differently in another width."""
        super().resizeEvent(event)
        self.stack.setGeometry(self.rect())
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def event(self, event: QEvent) -> bool:
        """Update the size when the page needs more or less room."""
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().event(event)


class StackArea(QScrollArea):
    """A scroll area that never needs more height than there is: the status bar stays visible.

    Args:
        stack: The stack, of which one widget is visible.
    """

    def __init__(self, stack: QStackedWidget) -> None:
        super().__init__()
        viewport = QWidget()
        viewport.setAutoFillBackground(False)
        # its own viewport, because asking for Qt's makes PySide load every class of widgets
        self.setViewport(viewport)
        self._room = _Room(stack)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.setWidget(self._room)
        self._room.setAutoFillBackground(False)
        stack.currentChanged.connect(self._begin)

    def _begin(self) -> None:
        """Show a newly chosen widget from its top, not scrolled like the one before."""
        self.updateGeometry()
        self.verticalScrollBar().setValue(0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Update the size hint when the widget wants another width: a scroll area does not."""
        if event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)

    def minimumSizeHint(self) -> QSize:
        """Return the width of the visible widget beside the scroll bar, without height."""
        bar_px = self.verticalScrollBar().sizeHint().width()
        return QSize(self._room.minimumSizeHint().width() + bar_px, 0)


def _scrolled(body: QBoxLayout) -> StackArea:
    """Return an area in which the body of a page scrolls."""
    content, stack = QWidget(), QStackedWidget()
    in_column((body, 1), on=content, margins=0)
    stack.addWidget(content)
    return StackArea(stack)


class PageStack(StackArea):
    """Holds a changing set of pages."""

    def __init__(self) -> None:
        self._stack = QStackedWidget()
        super().__init__(self._stack)

    @property
    def current(self) -> Page | None:
        """The page that is visible, or would be if the stack were."""
        page = self._stack.currentWidget()
        return page if isinstance(page, Page) else None

    def holds(self, page: Page) -> bool:
        """Return whether a page is in this stack."""
        return self._stack.indexOf(page) >= 0

    def show_page(self, page: Page) -> None:
        """Show a page, adding it if it is not in this stack."""
        if not self.holds(page):
            self._stack.addWidget(page)
        self._stack.setCurrentWidget(page)
        self._room.updateGeometry()

    def drop_page(self, page: Page) -> None:
        """Release a page, hidden, with the window as its parent."""
        self._stack.removeWidget(page)
        page.hide()
        page.setParent(self.window())
        self._room.updateGeometry()
