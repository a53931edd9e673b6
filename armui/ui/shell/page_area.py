"""The pages beside the 3D picture: one is visible, the others below it keep their state."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.page import Page, PageStack
from armui.ui.widgets.text_label import ElidedLabel, text_label
from armui.ui.widgets.translated import Translated

_LEAST_PX: Final = 480
_ASIDE_PX: Final = 16
_ICON_PX: Final = 18


class PageBar(Translated, QWidget):
    """One line: back, the pages that lead here, the title of this one, a button to take it out.

    Signals:
        back_wanted: The page shall be left.
        page_wanted: One of the pages that lead here was clicked.
        take_out_wanted: The page shall move to a window of its own.
    """

    back_wanted = Signal()
    page_wanted = Signal(object)
    take_out_wanted = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("page_bar")
        self._before: Page | None = None
        self._back = _tool("page_back")
        self._take_out = _tool("page_take_out")
        self._take_out.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._crumbs: QHBoxLayout = in_row(spacing=2)
        self._name = named("page_name", ElidedLabel("title"))
        parts = (self._back, self._crumbs, (self._name, 1), self._take_out)
        in_row(*parts, on=self, spacing=8, margins=0)
        self._back.clicked.connect(self.back_wanted)
        self._take_out.clicked.connect(self.take_out_wanted)
        self.retranslate_ui()
        self._recolor()

    def show_path(self, path: Sequence[Page]) -> None:
        """Show the way to the present page.

        Args:
            path: The pages that lead to the visible one, and that one.
        """
        *before, shown = path
        while (item := self._crumbs.takeAt(0)) is not None:
            old = item.widget()
            if old is not None:
                old.hide()
                old.deleteLater()
        for page in before:
            crumb = named("page_crumb", _Crumb(page))
            crumb.clicked.connect(lambda _on=False, page=page: self.page_wanted.emit(page))
            page.titled.connect(self._describe_back)
            for widget in (crumb, text_label(text="›", rank="muted")):
                self._crumbs.addWidget(widget)
                widget.show()
        self._name.show_text(shown.title)
        self._before = before[-1] if before else None
        self._describe_back()

    def _describe_back(self) -> None:
        to = self.tr("the panel") if self._before is None else self._before.title
        describe(self._back, self.tr("Back"), self.tr("Back to {where} (Esc)").format(where=to))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._describe_back()
        self._take_out.setText(self.tr("Own window"))
        tip = self.tr("Moves this page into its own window, for a second screen.")
        describe(self._take_out, self.tr("Own window"), tip)

    def _recolor(self) -> None:
        colors = colors_of(self)
        self._back.setIcon(icons.icon("back", colors.text))
        self._take_out.setIcon(icons.icon("take_out", colors.muted))


class _Crumb(QToolButton):
    """A button that leads to a page and shows its title, wherever the page is.

    Args:
        page: The page.
    """

    def __init__(self, page: Page) -> None:
        super().__init__()
        self._page = page
        self.setProperty("crumb", True)
        page.titled.connect(self._show_title)
        self._show_title()

    def _show_title(self) -> None:
        self.setText(self._page.title)
        self.setAccessibleName(self._page.title)


def _tool(name: str) -> QToolButton:
    button = named(name, QToolButton())
    button.setIconSize(QSize(_ICON_PX, _ICON_PX))
    return button


class PageArea(QWidget):
    """Replaces the panels while a page is visible.

    Signals:
        shown: The area shall be shown with a page.
        emptied: The last page was left.
        take_out_wanted: The visible page shall move to a window of its own.
    """

    shown = Signal()
    emptied = Signal()
    take_out_wanted = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("page_area")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)  # else no background is drawn
        self.setMinimumWidth(_LEAST_PX)
        self._open: list[Page] = []
        self._bar = PageBar()
        self._stack = PageStack()
        margins = (_ASIDE_PX, 10, _ASIDE_PX, 10)
        in_column(self._bar, (self._stack, 1), on=self, spacing=10, margins=margins)
        self._bar.back_wanted.connect(self._on_back)
        self._bar.page_wanted.connect(self._on_back)
        self._bar.take_out_wanted.connect(self._on_take_out)

    @property
    def pages(self) -> tuple[Page, ...]:
        """The pages that are open here; the last one is visible."""
        return tuple(self._open)

    @property
    def current(self) -> Page | None:
        """The page that is visible, or would be if the area were."""
        return self._open[-1] if self._open else None

    @property
    def wanted_px(self) -> int:
        """The width that the visible page would like; 0 if it has no wish."""
        wanted = self._open[-1].wanted_px if self._open else 0
        return wanted + 2 * _ASIDE_PX if wanted else 0

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
        """Release a page and show the one before it."""
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
        """Leave the page that is seen; it may ask first what becomes of unsaved changes."""
        self._open[-1].leave()

    def _on_take_out(self) -> None:
        self.take_out_wanted.emit(self._open[-1])
