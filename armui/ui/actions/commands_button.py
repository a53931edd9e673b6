"""In the status bar: opens the command palette, and tells its key."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QToolButton

from armui.ui.actions.keys import key_text
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.translated import Translated

_ICON_PX: Final = 14
_HIGHEST_PX: Final = 20
"""The button is no higher than the line of text beside it."""


class CommandsButton(Translated, QToolButton):
    """A magnifying glass and the key."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("commands_button")
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setMaximumHeight(_HIGHEST_PX)
        self.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self.setProperty("quiet", True)
        self.retranslate_ui()
        self._recolor()

    def retranslate_ui(self) -> None:
        """Put the words into the operator's language."""
        key = key_text("everywhere.palette")
        self.setText(key)
        self.setAccessibleName(self.tr("Commands"))
        self.setToolTip(f"{self.tr('Find every function by its name')} ({key})")

    def _recolor(self) -> None:
        self.setIcon(icons.icon("search", colors_of(self).muted))
