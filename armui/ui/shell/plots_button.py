"""Opens the window 曲线, below the menu."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtWidgets import QSizePolicy, QToolButton, QWidget

from armui.ui.theme import colors_of
from armui.ui.widgets import icons


class PlotsButton(QToolButton):
    """An icon and the name of the window it opens."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("plots_button")
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setIconSize(QSize(20, 20))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._draw_icon()
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Its name in the operator's language."""
        self.setText(f" {self.tr('Curves')}")
        self.setAccessibleName(self.tr("Curves"))
        self.setToolTip(
            self.tr(
                "What was heard and commanded in the last half hour. The right button on any "
                "figure shows it here."
            )
        )

    def _draw_icon(self) -> None:
        self.setIcon(icons.icon("plots", colors_of(self).accent))

    def changeEvent(self, event: QEvent) -> None:
        """Follow the language and the colours."""
        if event.type() == QEvent.Type.LanguageChange:
            self.retranslate_ui()
        elif event.type() == QEvent.Type.PaletteChange:
            self._draw_icon()
        super().changeEvent(event)
