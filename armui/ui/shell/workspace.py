"""The place of each page: in the main window, or in a window of its own."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final, Protocol

from PySide6.QtCore import QMargins, QObject, QRect, QSize, Qt, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QDialog, QToolButton, QWidget

from armui.ui.dialogs.base import FRAME, ArmDialog, on_screen, place_of
from armui.ui.shell.workspace_layout import OpenWindow
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.keeps_focus import restore_parent
from armui.ui.widgets.layouts import fill

if TYPE_CHECKING:
    from collections.abc import Callable

    from PySide6.QtGui import QHideEvent, QMoveEvent, QResizeEvent

    from armui.control.arm_controller import ArmController
    from armui.ui.shell.layout_keeper import LayoutKeeper
    from armui.ui.widgets.page import Page


_ASIDE_PX: Final = 32
"""The offset of a second window of a kind, so that it does not hide the first."""
_AROUND: Final = QMargins(20, -16, 20, 20)
"""The margins of a page in its window. The stops are thus lower than the button that took the page
out, so that a double click on it does not press one.
"""
_LEAST: Final = QSize(640, 460)
_SIZE: Final = QSize(1180, 760)
_ICON_PX: Final = 18


class PageWindow(ArmDialog):
    """The window of a page: closing it leaves the page, a button puts the page back.

    Args:
        controller: Receives halt and emergency stop.
        page: The page in it.
        parent: The main window.
        bar: The bar above the page, which shows who moves the arm, as the main window may be
            covered.

    Signals:
        put_back_wanted: The page shall return to the main window.
        placed: It was moved or resized.
    """

    put_back_wanted = Signal()
    placed = Signal()

    def __init__(
        self, controller: ArmController, page: Page, parent: QWidget, bar: QWidget
    ) -> None:
        super().__init__(controller, parent)
        self.setObjectName(f"{page.key}_window")
        self.setWindowFlags(Qt.WindowType.Window)
        self._moved = True  # keeps the base class from placing it: it opens at its stored place
        self._page: Page | None = page
        self._put_back = named("page_put_back", QToolButton())
        self._put_back.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self._put_back.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._put_back.setFixedHeight(self.stop_button.sizeHint().height())
        self._put_back.clicked.connect(self.put_back_wanted)
        self.add_to_header(self._put_back)
        fill(self.body, bar, (page, 1))
        page.titled.connect(self._name)
        page.show()
        self.resize(_SIZE.boundedTo(self.screen().availableSize()))
        self.retranslate_ui()
        self._recolor()

    def release(self) -> Page | None:
        """Release the page, hidden, and delete this window."""
        page, self._page = self._page, None
        if page is not None:
            page.titled.disconnect(self._name)
            page.hide()
            page.setParent(self.parentWidget())
            for each in page.findChildren(QWidget):
                restore_parent(each)
        self.hide()
        self.deleteLater()
        return page

    def open(self) -> None:
        """Show the window in front, and focus the page's main widget."""
        super().open()
        if self._page is not None:
            self._page.take_focus()

    def reject(self) -> None:
        """Leave the page, because the window is closed."""
        if self._page is None:
            super().reject()
        else:
            self._page.leave()

    def room_for_questions(self) -> QRect:
        """Return the area below its stops."""
        top = self.stop_button.mapToGlobal(self.stop_button.rect().bottomLeft()).y()
        left = self.mapToGlobal(self.rect().topLeft())
        return QRect(left.x(), top, self.width(), left.y() + self.height() - top)

    def _name(self) -> None:
        if self._page is not None:
            self.set_title(self._page.title)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._name()
        self._put_back.setText(self.tr("Put back"))
        tip = self.tr("Puts this page back beside the 3D picture.")
        describe(self._put_back, self.tr("Put back"), tip)

    def _recolor(self) -> None:
        self._put_back.setIcon(icons.icon("put_back", colors_of(self).muted))

    def moveEvent(self, event: QMoveEvent) -> None:
        """Report the new place."""
        super().moveEvent(event)
        self.placed.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Report the new size."""
        super().resizeEvent(event)
        self.placed.emit()

    def hideEvent(self, event: QHideEvent) -> None:
        """Report the change; guards release any held control."""
        super().hideEvent(event)
        self.placed.emit()


class PageHome(Protocol):
    """A region of the main window that shows pages."""

    def show_page(self, page: Page) -> None:
        """Show a page in front of the others."""

    def drop_page(self, page: Page) -> None:
        """Remove a page from the region; it is not deleted."""


class Workspace(QObject):
    """Manages all pages, and shows each where the operator wants pages of its kind.

    Args:
        controller: Receives the stops of the windows.
        keeper: Stores which pages were taken out, with their places.
        window: The main window.
        bar: Makes the bar above each page in a window of its own.
    """

    def __init__(
        self,
        controller: ArmController,
        keeper: LayoutKeeper,
        window: QWidget,
        bar: Callable[[], QWidget],
    ) -> None:
        super().__init__(window)
        self._bar = bar
        self._controller = controller
        self._keeper = keeper
        self._window = window
        self._homes: dict[Page, PageHome] = {}
        self._kept: dict[str, Page] = {}
        self._windows: dict[Page, PageWindow] = {}
        self._out_for_now: set[Page] = set()
        known = keeper.layout.taken_out
        self._left_open = [each for each in keeper.layout.open_windows if each.key in known]
        if keeper.layout.drawer:
            self._left_open.append(OpenWindow(keeper.layout.drawer))
        self._ends = False

    def add(self, page: Page, home: PageHome) -> None:
        """Manage a page from now on; nothing is shown until the page wants it.

        Args:
            page: A new page.
            home: Its region in the main window.
        """
        page.hide()
        page.setParent(self._window)
        self._homes[page] = home
        for name, header in page.headers().items():
            self._keeper.follow(name, header)
        page.wanted.connect(partial(self._show, page))
        page.closed.connect(partial(self._on_closed, page))
        page.destroyed.connect(partial(self._forget, page))

    def keep(self, key: str, page: Page, home: PageHome) -> None:
        """Manage the single page of a kind from now on.

        Args:
            key: The kind.
            page: The new page.
            home: Its region in the main window.
        """
        self._kept[key] = page
        self.add(page, home)

    def kept(self, key: str) -> Page | None:
        """Return the single page of a kind, or ``None`` if it was not created."""
        return self._kept.get(key)

    def page_of(self, key: str) -> Page | None:
        """Return a page of a kind, preferably a visible one, or ``None``."""
        found = [page for page in self._homes if page.key == key]
        return next((page for page in found if page.isVisible()), found[0] if found else None)

    def is_taken_out(self, page: Page) -> bool:
        """Return whether a page is in a window of its own."""
        return page in self._windows

    def take_out(self, page: Page) -> None:
        """Move a page to a window of its own; pages of its kind open so from now on."""
        stood = QRect(page.mapToGlobal(page.rect().topLeft()), page.size())
        self._homes[page].drop_page(page)
        window = self._window_of(page)
        if page.key not in self._keeper.layout.taken_out:
            window.setGeometry(first_place(stood, window, self._window))
        self._note(window, page)
        window.open()

    def uncover(self, page: Page, *, for_now: bool = False) -> None:
        """Move a page to a window if the window of another page covers it, which stays in front.

        Args:
            page: The visible page.
            for_now: True to do so if any window of the program covers it, for this time only.
        """
        stands = QRect(page.mapToGlobal(page.rect().topLeft()), page.size())
        others = QApplication.topLevelWidgets() if for_now else self._windows.values()
        dialogs = (each for each in others if isinstance(each, QDialog) and each.isVisible())
        covered = any(each.geometry().intersects(stands) for each in dialogs)
        if covered and page.isVisible() and page not in self._windows:
            if for_now:
                self._out_for_now.add(page)
            self.take_out(page)

    def put_back(self, page: Page) -> None:
        """Move a page back; pages of its kind open in the main window from now on."""
        self._release_page(page)
        layout = self._keeper.layout
        left = {key: place for key, place in layout.taken_out.items() if key != page.key}
        self._keeper.layout = replace(layout, taken_out=left)
        self._keeper.note()
        self._homes[page].show_page(page)
        self._window.raise_()
        self._window.activateWindow()

    def close_windows(self) -> None:
        """Close all windows because the program ends, keeping their places."""
        self._ends = True
        for page in list(self._windows):
            self._release_page(page)

    def next_left_open(self) -> OpenWindow | None:
        """Return the next page that was open when the program ended, or ``None``.

        These are the pages in windows, and the visible page of the drawer.
        """
        return self._left_open.pop(0) if self._left_open else None

    def note_windows(self) -> None:
        """Store which pages are in windows, with those of the last time still to be opened."""
        if self._ends:
            return
        lasting = (page for page in self._windows if page not in self._out_for_now)
        now = [OpenWindow(page.key, page.subject) for page in lasting]
        kept = tuple(dict.fromkeys([*now, *self._left_open]))
        self._keeper.layout = replace(self._keeper.layout, open_windows=kept)
        self._keeper.note()

    def _show(self, page: Page) -> None:
        if page in self._windows:
            self._windows[page].open()
        elif page.key in self._keeper.layout.taken_out:
            self._homes[page].drop_page(page)
            self._window_of(page).open()
        else:
            self._homes[page].show_page(page)

    def _window_of(self, page: Page) -> PageWindow:
        window = self._windows[page] = PageWindow(self._controller, page, self._window, self._bar())
        window.put_back_wanted.connect(partial(self.put_back, page))
        window.placed.connect(partial(self._on_placed, window, page))
        kept = self._keeper.layout.taken_out.get(page.key)
        if kept is not None:
            others = sum(each.key == page.key for each in self._windows) - 1
            aside = replace(kept, x=kept.x + others * _ASIDE_PX, y=kept.y + others * _ASIDE_PX)
            window.setGeometry(on_screen(aside))
        self.note_windows()
        return window

    def _on_placed(self, window: PageWindow, page: Page) -> None:
        if window.isVisible():
            self._note(window, page)

    def _note(self, window: PageWindow, page: Page) -> None:
        if page in self._out_for_now:
            return
        layout = self._keeper.layout
        kept = {**layout.taken_out, page.key: place_of(window.geometry())}
        self._keeper.layout = replace(layout, taken_out=kept)
        self._keeper.note()

    def _on_closed(self, page: Page) -> None:
        """Release a page that was left; if it was docked, show the page that led to it."""
        docked = page not in self._windows and page.isVisible()
        self._release_page(page)
        self._homes[page].drop_page(page)
        if docked and page.above is not None:
            page.above.open()

    def _release_page(self, page: Page) -> None:
        window = self._windows.pop(page, None)
        if window is not None:
            window.release()
            self._out_for_now.discard(page)
            self.note_windows()

    def _forget(self, page: Page) -> None:
        self._homes.pop(page, None)


def first_place(stood: QRect, window: QWidget, main: QWidget) -> QRect:
    """Return the place of a page's window when it is taken out for the first time.

    It is the middle of a second screen, if there is one; else the page's own place and size, so
    that the picture stays visible.

    Args:
        stood: The page in the main window, in pixels of the desktop.
        window: The page's window, in the size that suits it.
        main: The main window.
    """
    others = [each for each in QGuiApplication.screens() if each is not main.screen()]
    if others:
        room = others[0].availableGeometry().marginsRemoved(FRAME)
        place = QRect(room.topLeft(), window.size().boundedTo(room.size()))
        place.moveCenter(room.center())
        return place
    around = stood.marginsAdded(_AROUND)
    return on_screen(place_of(QRect(around.topLeft(), around.size().expandedTo(_LEAST))))
