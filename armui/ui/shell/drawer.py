"""The drawer below panels and picture: pages to watch or read beside the work, one at a time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QToolButton, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import caption, choice_button, describe, named
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.page import Page, PageStack
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.ui.shell.page_entry import PageEntry

_ICON_PX: Final = 16
DRAWER_PX: Final = 324
_LEAST_PX: Final = 190


class Drawer(Translated, QWidget):
    """Tabs of pages, each created when it is first wanted; closed at first.

    Args:
        pages: The pages by their keys, from left to right; the tab of one is named
            ``drawer_<key>``.

    Signals:
        page_wanted: A page shall be shown, by its key.
        take_out_wanted: The visible page shall move to a window of its own.
        turned: It was opened (``True``) or closed.
    """

    page_wanted = Signal(str)
    take_out_wanted = Signal(object)
    turned = Signal(bool)

    def __init__(self, pages: Mapping[str, PageEntry[Any]]) -> None:
        super().__init__()
        self.setObjectName("drawer")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)  # else no background is drawn
        self.setMinimumHeight(_LEAST_PX)
        self._pages = pages
        self._group = QButtonGroup(self)
        self._tabs = {key: choice_button(f"drawer_{key}") for key in pages}
        self._stack = PageStack()
        self._take_out = named("drawer_take_out", QToolButton())
        self._fold = named("drawer_fold", QToolButton())
        for key, tab in self._tabs.items():
            self._group.addButton(tab)
            tab.clicked.connect(lambda _on=False, key=key: self._on_tab(key))
        for button in (self._take_out, self._fold):
            button.setIconSize(QSize(_ICON_PX, _ICON_PX))
        head = in_row(*self._tabs.values(), STRETCH, self._take_out, self._fold, spacing=2)
        in_column(head, (self._stack, 1), on=self, spacing=4, margins=(16, 2, 16, 4))
        self._take_out.clicked.connect(self._on_take_out)
        self._fold.clicked.connect(self.fold)
        self.hide()
        self.retranslate_ui()
        self._recolor()

    @property
    def current(self) -> Page | None:
        """The page that is visible, or would be if the drawer were open."""
        return self._stack.current

    @property
    def open_key(self) -> str:
        """The key of the page that is visible; "" if the drawer is closed."""
        return "" if self.current is None or self.isHidden() else self.current.key

    def show_page(self, page: Page) -> None:
        """Open the drawer at a page."""
        self._stack.show_page(page)
        self._tabs[page.key].setChecked(True)
        if self.isHidden():
            self.show()
            self.turned.emit(True)
        page.take_focus()

    def drop_page(self, page: Page) -> None:
        """Release a page, and close the drawer if it was the visible one."""
        if not self._stack.holds(page):
            return
        if page is self.current:
            self.fold()
        self._stack.drop_page(page)

    def fold(self) -> None:
        """Close the drawer; hidden pages do no work."""
        if not self.isHidden():
            self.hide()
            self.turned.emit(False)

    def _on_tab(self, key: str) -> None:
        """Request a page, which may open in a window: the tab of the page here stays pressed."""
        self.page_wanted.emit(key)
        if self.current is not None:
            self._tabs[self.current.key].setChecked(True)

    def _on_take_out(self) -> None:
        if self.current is not None:
            self.take_out_wanted.emit(self.current)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        for key, page in self._pages.items():
            caption(self._tabs[key], page.title.text(), tip=page.tip_text)
        tip = self.tr("Moves this page into its own window, for a second screen.")
        describe(self._take_out, self.tr("Own window"), tip)
        describe(self._fold, self.tr("Fold away"), self.tr("Folds the drawer away (Esc)"))

    def _recolor(self) -> None:
        ink = colors_of(self).muted
        self._take_out.setIcon(icons.icon("take_out", ink))
        self._fold.setIcon(icons.icon("fold", ink))
