"""Above a page: the way back, where one is («轨迹库 › 取放托盘»), and out into a window."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.elided_label import ElidedLabel
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.page import Page
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

_ICON_PX: Final = 18


class PageBar(Translated, QWidget):
    """One line: back, the pages that lead here, the name of this one, a button to take it out.

    Signals:
        back_wanted: The page shall be left.
        page_wanted: One of the pages that lead here was clicked.
        take_out_wanted: The page shall stand in a window of its own.
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
        self._name = named("page_name", ElidedLabel())
        self._name.setProperty("rank", "title")
        parts = (self._back, self._crumbs, (self._name, 1), self._take_out)
        in_row(*parts, on=self, spacing=8, margins=0)
        self._back.clicked.connect(self.back_wanted)
        self._take_out.clicked.connect(self.take_out_wanted)
        self.retranslate_ui()
        self._recolor()

    def show_path(self, path: Sequence[Page]) -> None:
        """Say where one is.

        Args:
            path: The pages that lead to the one that is shown, and it.
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
            arrow = text_label(rank="muted")
            arrow.setText("›")
            for widget in (crumb, arrow):
                self._crumbs.addWidget(widget)
                widget.show()
        self._name.show_text(shown.title)
        self._before = before[-1] if before else None
        self._describe_back()

    def _describe_back(self) -> None:
        to = self.tr("the panel") if self._before is None else self._before.title
        describe(self._back, self.tr("Back"), self.tr("Back to {where} (Esc)").format(where=to))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._describe_back()
        self._take_out.setText(self.tr("Own window"))
        tip = self.tr("Takes this page out into a window of its own, for a second screen.")
        describe(self._take_out, self.tr("Own window"), tip)

    def _recolor(self) -> None:
        colors = colors_of(self)
        self._back.setIcon(icons.icon("back", colors.text))
        self._take_out.setIcon(icons.icon("take_out", colors.muted))


class _Crumb(QToolButton):
    """Leads to a page and is called as that page is, which may stand elsewhere.

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
