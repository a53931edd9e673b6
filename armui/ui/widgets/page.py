"""A page: work with a title of its own beside the 3D picture or in its own window; its stacks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QCloseEvent, QContextMenuEvent, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import QFrame, QHeaderView, QScrollArea, QStackedWidget, QWidget

from armui.ui.actions.command import Command, Target
from armui.ui.widgets.curve_menu import offer_curves
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.translated import Translated

_GAP_PX: Final = 12


class Page(Translated, QWidget):
    """Content without a frame: whoever holds it shows its title, the way back, and the stops.

    A page is left, never just closed: :meth:`leave` may ask first. It works while it is seen and
    costs nothing while it is not.

    Args:
        key: Its name in the settings; pages of one kind share it.

    Attributes:
        above: The page that leads to it, and to which the way back leads.
        first: The widget that gets the keys at first; ``None``: the page itself.
        body: Where its content goes.
        footer: Where its last buttons go, from left to right.
        commands: What the command palette offers of it.

    Signals:
        titled: Its title is another.
        wanted: It is to be seen, in front.
        closed: It was left for good; whoever holds it takes it away.
    """

    commands: Sequence[Command] = ()
    titled = Signal()
    wanted = Signal()
    closed = Signal()

    def __init__(self, key: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.key: Final = key
        self.above: Page | None = None
        self.first: QWidget | None = None
        self._title = ""
        self.body = in_column(spacing=_GAP_PX)
        self.footer = in_row(spacing=_GAP_PX // 2)
        in_column((self.body, 1), self.footer, on=self, spacing=_GAP_PX, margins=0)

    @property
    def subject(self) -> str:
        """What it works on, where there are several of its kind."""
        return ""

    @property
    def title(self) -> str:
        """What it is called now."""
        return self._title

    def set_title(self, title: str) -> None:
        """Call it something else."""
        if title != self._title:
            self._title = title
            self.setAccessibleName(title)
            self.titled.emit()

    def headers(self) -> Mapping[str, QHeaderView]:
        """The heads of its tables by name: how wide the columns are, and the order, is kept."""
        return {}

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each of its commands, by the command's name."""
        return {}

    # Coming and going -------------------------------------------------------------------------

    def open(self) -> None:
        """Have it shown in front, wherever it stands."""
        self.wanted.emit()

    def leave(self) -> None:
        """Leave it for good; a page in which something is not saved asks first."""
        self.closed.emit()

    def take_focus(self) -> None:
        """The operator has come here: the keys go to what is worked with."""
        found = (each for each in (self.focusWidget(), self.first) if each is not None)
        next(found, self).setFocus(Qt.FocusReason.OtherFocusReason)

    def closeEvent(self, event: QCloseEvent) -> None:
        """To close it is to leave it."""
        event.ignore()
        self.leave()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Escape leads back, unless a field or a table has taken it for itself."""
        if event.key() == Qt.Key.Key_Escape:
            event.accept()
            self.leave()
        else:
            super().keyPressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer to show the figure as a curve."""
        offer_curves(self, event)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language; called anew when that changes."""


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
        """Return whether a page is one of these."""
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
