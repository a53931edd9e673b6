"""Region 2: the vertical menu; below it region 10."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final

from PySide6.QtCore import QCoreApplication, QEvent, QSize, Qt, Signal
from PySide6.QtWidgets import QButtonGroup, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import icons

_WIDTH_PX: Final = 176


@dataclass(frozen=True, slots=True)
class MenuEntry:
    """One panel of the operation area.

    Attributes:
        key: Its name in the program; the button is called ``menu_<key>``.
        title: What the menu says, marked for translation in the context ``SideMenu``.
        icon: The name of its icon.
        make_panel: Makes the panel.
    """

    key: str
    title: str
    icon: str
    make_panel: Callable[[], QWidget]


class SideMenu(QWidget):
    """One entry a panel; the chosen one stands on pale blue.

    Args:
        entries: From top to bottom.
        at_bottom: What stands apart from them at the lower end.

    Signals:
        chosen: The entry's place in the list.
    """

    chosen = Signal(int)

    def __init__(
        self, entries: Sequence[MenuEntry], at_bottom: QWidget, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("side_menu")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._entries = tuple(entries)
        self._group = QButtonGroup(self)
        self.setFixedWidth(_WIDTH_PX)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 14, 8, 14)
        layout.setSpacing(4)
        for place, entry in enumerate(self._entries):
            button = QToolButton()
            button.setObjectName(f"menu_{entry.key}")
            button.setProperty("entry", True)
            button.setCheckable(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            button.setIconSize(QSize(20, 20))
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self._group.addButton(button, place)
            layout.addWidget(button)
        layout.addStretch(1)
        layout.addWidget(at_bottom)
        self._group.button(0).setChecked(True)
        self._group.idClicked.connect(self.chosen)
        self._group.idClicked.connect(self._draw_icons)
        self.retranslate_ui()
        self._draw_icons()

    def retranslate_ui(self) -> None:
        """Put the entries into the operator's language."""
        for place, entry in enumerate(self._entries):
            title = QCoreApplication.translate("SideMenu", entry.title)
            self._group.button(place).setText(f" {title}")
            self._group.button(place).setAccessibleName(title)

    def _draw_icons(self) -> None:
        colors = colors_of(self)
        for place, entry in enumerate(self._entries):
            color = colors.accent if place == self._group.checkedId() else colors.muted
            self._group.button(place).setIcon(icons.icon(entry.icon, color))

    def changeEvent(self, event: QEvent) -> None:
        """Follow the language and the colours."""
        if event.type() == QEvent.Type.LanguageChange:
            self.retranslate_ui()
        elif event.type() == QEvent.Type.PaletteChange:
            self._draw_icons()
        super().changeEvent(event)
