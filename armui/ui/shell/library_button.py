"""Region 9: opens 轨迹库, below the menu; it is down while a page is seen."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QSizePolicy, QToolButton

from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.translated import Translated


class LibraryButton(Translated, QToolButton):
    """An icon and the name of the page it opens."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("library_button")
        self.setCheckable(True)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setIconSize(QSize(20, 20))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._recolor()
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Its name in the operator's language."""
        self.setText(f" {self.tr('Trajectory library')}")
        self.setAccessibleName(self.tr("Trajectory library"))
        self.setToolTip(self.tr("Make, check, run and record trajectories"))

    def _recolor(self) -> None:
        self.setIcon(icons.icon("library", colors_of(self).accent))
