"""The area between next step and status bar: panels or pages, the picture, the drawer."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QSize, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSplitter, QWidget

from armui.ui.dialogs.base import on_screen, place_of, screens
from armui.ui.shell.drawer import DRAWER_PX, Drawer
from armui.ui.shell.page_area import PageArea

if TYPE_CHECKING:
    from armui.ui.shell.layout_keeper import LayoutKeeper
    from armui.ui.shell.workspace_layout import WorkspaceLayout


PANEL_PX: Final = 460
PAGE_SHARE: Final = 0.6
_LEAST_PANEL_PX: Final = 400
_LEAST_VIEW_PX: Final = 300
_NARROW_VIEW_PX: Final = 390
"""The width left for the picture beside a page whose table needs more than its share."""
_LEAST_WORK_PX: Final = 260
_MOVED: Final = frozenset({QEvent.Type.Move, QEvent.Type.Resize, QEvent.Type.WindowStateChange})


class WorkArea(QSplitter):
    """Panels or pages beside the picture, with a width for the panels and a share for the pages.

    A width that does not fit is not applied, but kept.

    Args:
        panels: The chosen panel of the menu.
        pages: Replaces it while a page is visible.
        view: The picture; never narrower than its figures need.

    Attributes:
        panel_px: The width of the panels.
        page_share: The share of the width for pages, 0–1.

    Signals:
        turned: Pages are visible now (``True``), or panels.
        sized: The operator has moved the border.
    """

    turned = Signal(bool)
    sized = Signal()

    def __init__(self, panels: QWidget, pages: PageArea, view: QWidget) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.setObjectName("splitter")
        self.setHandleWidth(1)
        self.panel_px = PANEL_PX
        self.page_share = PAGE_SHARE
        self._panels, self._pages, self._view = panels, pages, view
        panels.setMinimumWidth(_LEAST_PANEL_PX)
        view.setMinimumWidth(_LEAST_VIEW_PX)
        for widget in (panels, pages, view):
            self.addWidget(widget)
        self.setChildrenCollapsible(False)
        for place, stretch in enumerate((0, 0, 1)):
            self.setStretchFactor(place, stretch)
        pages.hide()
        pages.shown.connect(self.show_pages)
        pages.emptied.connect(self.show_panels)
        self.splitterMoved.connect(self._on_moved)

    @property
    def shows_pages(self) -> bool:
        """True if a page replaces the panels."""
        return not self._pages.isHidden()

    def show_pages(self) -> None:
        """Show the pages, if one is open."""
        if self._pages.current is not None:
            self._turn(pages=True)

    def show_panels(self) -> None:
        """Show the panels; the pages keep their state."""
        self._turn(pages=False)

    def set_widths(self, panel_px: int, page_share: float) -> None:
        """Set the width of the panels in pixels, and the share of the width for pages."""
        self.panel_px, self.page_share = panel_px, page_share
        self.fit()

    def _turn(self, *, pages: bool) -> None:
        if pages == self.shows_pages:
            return
        self._panels.setVisible(not pages)
        self._pages.setVisible(pages)
        self.fit()
        self.turned.emit(pages)

    def fit(self) -> None:
        """Apply the widths, as far as there is room."""
        room = self.width() - self.handleWidth()
        _left, least = self._least()
        width = max(least, min(self._wanted(room), room - self._view.minimumWidth()))
        of_panels, of_pages = (0, width) if self.shows_pages else (width, 0)
        self.setSizes([of_panels, of_pages, max(0, room - width)])

    def _wanted(self, room: int) -> int:
        """Return the width left of the picture; a table may get more than the default share."""
        if not self.shows_pages:
            return self.panel_px
        share = round(self.page_share * room)
        if self.page_share != PAGE_SHARE:
            return share
        return max(share, min(self._pages.wanted_px, room - _NARROW_VIEW_PX))

    def _least(self) -> tuple[QWidget, int]:
        """Return the widget at the left of the picture, and its least width."""
        left = self._pages if self.shows_pages else self._panels
        return left, max(left.minimumWidth(), left.minimumSizeHint().width())

    def event(self, event: QEvent) -> bool:
        """Fit again when a page's controls have changed and may need more width."""
        done = super().event(event)
        if event.type() == QEvent.Type.LayoutRequest:
            left, least = self._least()
            room = self.width() - self.handleWidth()
            if left.width() < min(max(least, self._wanted(room)), room - self._view.minimumWidth()):
                self.fit()
        return done

    def left_of_picture(self) -> QRect:
        """Return the area between window's left edge and picture, in pixels of the desktop."""
        top = self.mapToGlobal(QPoint(0, 0)).y()
        left = self.window().mapToGlobal(QPoint(0, 0)).x()
        return QRect(left, top, self._view.mapToGlobal(QPoint(0, 0)).x() - left, self.height())

    def _on_moved(self, *_: int) -> None:
        left = self._pages if self.shows_pages else self._panels
        if self.shows_pages:
            self.page_share = left.width() / max(1, self.width() - self.handleWidth())
        else:
            self.panel_px = left.width()
        self.sized.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit again: the picture gets the rest beside panels; pages keep their share."""
        super().resizeEvent(event)
        self.fit()


class WorkColumn(QSplitter):
    """The work area with the drawer below, which takes height from it only while open.

    Args:
        area: Panels or pages, and the picture.
        drawer: The drawer below them.

    Attributes:
        area, drawer: As given.
        drawer_px: The height of the open drawer.

    Signals:
        sized: The operator has moved a border.
    """

    sized = Signal()

    def __init__(self, area: WorkArea, drawer: Drawer) -> None:
        super().__init__(Qt.Orientation.Vertical)
        self.setObjectName("work_column")
        self.setHandleWidth(1)
        self.setChildrenCollapsible(False)
        self.area = area
        self.drawer_px = DRAWER_PX
        self.drawer = drawer
        self.addWidget(area)
        self.addWidget(drawer)
        self.setStretchFactor(0, 1)
        self.setStretchFactor(1, 0)
        drawer.turned.connect(self.fit)
        self.splitterMoved.connect(self._on_moved)
        area.sized.connect(self.sized)

    def set_drawer(self, height_px: int) -> None:
        """Set the height of the drawer."""
        self.drawer_px = height_px
        self.fit()

    def fit(self, *_: object) -> None:
        """Apply the height of the drawer, as far as there is room."""
        if self.drawer.isHidden():
            return
        room = self.height() - self.handleWidth()
        least = max(_LEAST_WORK_PX, self.area.minimumSizeHint().height())
        height = max(self.drawer.minimumHeight(), min(self.drawer_px, room - least))
        self.setSizes([max(0, room - height), height])

    def _on_moved(self, *_: int) -> None:
        self.drawer_px = self.drawer.height()
        self.sized.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the height of the drawer."""
        super().resizeEvent(event)
        self.fit()


class WindowLayout(QObject):
    """Restores the place of the window and its borders, and stores changes.

    Args:
        keeper: The stored arrangement.
        window: The main window, before it is shown.
        column: The borders in it.
        first_size: The size of the window at the first start.
    """

    def __init__(
        self, keeper: LayoutKeeper, window: QWidget, column: WorkColumn, first_size: QSize
    ) -> None:
        super().__init__(window)
        self._keeper = keeper
        self._window = window
        self._column = column
        layout = keeper.layout
        if layout.window is None:
            room = screens()[0]  # without the window's title and frame
            window.resize(first_size.boundedTo(QSize(room.width, room.height)))
        else:
            window.setGeometry(on_screen(layout.window))
        if layout.maximized:
            window.setWindowState(Qt.WindowState.WindowMaximized)
        column.area.set_widths(layout.panel_px or PANEL_PX, layout.page_share or PAGE_SHARE)
        column.set_drawer(layout.drawer_px or DRAWER_PX)
        column.sized.connect(keeper.note)
        column.drawer.turned.connect(keeper.note)
        keeper.collect_by(self._collect)
        window.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Store the place when the window was moved or resized."""
        if event.type() in _MOVED and self._window.isVisible():
            self._keeper.note()
        return super().eventFilter(watched, event)

    def _collect(self, layout: WorkspaceLayout) -> WorkspaceLayout:
        window, area = self._window, self._column.area
        return replace(
            layout,
            window=place_of(window.normalGeometry()),
            maximized=window.isMaximized(),
            panel_px=area.panel_px,
            page_share=round(area.page_share, 4),
            drawer_px=self._column.drawer_px,
            drawer=self._column.drawer.open_key,
        )
