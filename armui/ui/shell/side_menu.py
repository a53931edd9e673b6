"""Region 2: the vertical menu; below it regions 9 and 10."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Final, NamedTuple

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

_WIDTH_PX: Final = 176


class MenuEntry(NamedTuple):
    """One panel of the operation area.

    Attributes:
        key: Its name in the program and its icon's; the button is called ``menu_<key>``.
        title: What the menu says.
        make_panel: Makes the panel.
    """

    key: str
    title: Text
    make_panel: Callable[[], QWidget]


class SideMenu(Translated, QWidget):
    """One entry a panel; the chosen one stands on pale blue. Scrolls on a low screen.

    Args:
        entries: From top to bottom.
        at_bottom: What stands apart from them at the lower end.

    Signals:
        chosen: The entry's place in the list.
    """

    chosen = Signal(int)

    def __init__(self, entries: Sequence[MenuEntry], at_bottom: Sequence[QWidget]) -> None:
        super().__init__()
        self.setObjectName("side_menu")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._entries = tuple(entries)
        # no group of Qt's: Tab would reach only the chosen one of its buttons
        self._buttons: list[QToolButton] = []
        self._chosen: int | None = 0
        self.setFixedWidth(_WIDTH_PX)
        column = QWidget()
        layout = in_column(on=column, spacing=2, margins=0)
        for place, entry in enumerate(self._entries):
            button = named(f"menu_{entry.key}", QToolButton())
            button.setProperty("entry", True)
            button.setCheckable(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            button.setIconSize(QSize(20, 20))
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            button.clicked.connect(partial(self._on_clicked, place))
            self._buttons.append(button)
            layout.addWidget(button)
        layout.addStretch(1)
        entries_area = (self._scrolled(column), 1)
        in_column(entries_area, *at_bottom, on=self, spacing=6, margins=(8, 10, 8, 10))
        self.retranslate_ui()
        self.choose(0)

    def _on_clicked(self, place: int, _on: bool = False) -> None:
        self.choose(place)
        self.chosen.emit(place)

    def open_entry(self, key: str) -> None:
        """Have an entry opened, as by a press on it, unless it is open already."""
        keys = [entry.key for entry in self._entries]
        place = keys.index(key)
        if place != self._chosen and self.isVisible():
            self._on_clicked(place)

    def choose(self, place: int | None) -> None:
        """Show an entry, or none, as the chosen one, without telling anyone."""
        self._chosen = place
        for number, button in enumerate(self._buttons):
            button.setChecked(number == place)
        self._recolor()

    def _scrolled(self, column: QWidget) -> QScrollArea:
        area = QScrollArea()
        area.setViewport(QWidget())
        area.setObjectName("side_menu_entries")
        area.setWidgetResizable(True)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(column)
        area.viewport().setAutoFillBackground(False)
        column.setAutoFillBackground(False)
        self._bar = area.verticalScrollBar()
        # later: the area is not to be resized while it lays out what it holds
        queued = Qt.ConnectionType.QueuedConnection
        self._bar.rangeChanged.connect(self._make_room, queued)
        return area

    def _make_room(self, _least: int, most: int) -> None:
        """Where the entries scroll, the bar stands beside them, not over their right ends."""
        self.setFixedWidth(_WIDTH_PX + (self._bar.sizeHint().width() if most else 0))

    def retranslate_ui(self) -> None:
        """Put the entries into the operator's language."""
        for place, entry in enumerate(self._entries):
            title = entry.title.text()
            self._buttons[place].setText(f" {title}")
            self._buttons[place].setAccessibleName(title)

    def _recolor(self) -> None:
        colors = colors_of(self)
        for place, entry in enumerate(self._entries):
            color = colors.accent if place == self._chosen else colors.muted
            self._buttons[place].setIcon(icons.icon(entry.key, color))
