"""Below the menu: one button for each window that watches, remembers and replays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final, NamedTuple

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QSizePolicy, QToolButton, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

_COLUMNS: Final = 2


class WatchEntry(NamedTuple):
    """One window.

    Attributes:
        key: Its icon's name; the button is called ``<key>_button``.
        title: What the button says.
        tip: What the window is for.
        open_window: Shows it.
    """

    key: str
    title: Text
    tip: Text
    open_window: Callable[[], object]


class WatchMenu(Translated, QWidget):
    """A button a window, two in a row; a single one is as wide as the menu.

    Args:
        entries: Row by row.
    """

    def __init__(self, entries: Sequence[WatchEntry]) -> None:
        super().__init__()
        self.setObjectName("watch_menu")
        self._buttons: list[tuple[WatchEntry, QToolButton]] = []
        layout = empty_grid(self, gaps=(4, 4), margins=0)
        for place, entry in enumerate(entries):
            button = named(f"{entry.key}_button", QToolButton())
            button.setProperty("half", True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            button.setIconSize(QSize(18, 18))
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(lambda _on=False, entry=entry: entry.open_window())
            row, column = divmod(place, _COLUMNS)
            alone = column == 0 and place == len(entries) - 1
            layout.addWidget(button, row, column, 1, _COLUMNS if alone else 1)
            self._buttons.append((entry, button))
        self._recolor()
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put the names into the operator's language."""
        for entry, button in self._buttons:
            title = entry.title.text()
            button.setText(f" {title}")
            button.setAccessibleName(title)
            button.setToolTip(entry.tip.text())

    def _recolor(self) -> None:
        for entry, button in self._buttons:
            button.setIcon(icons.icon(entry.key, colors_of(self).accent))
