"""Widgets that follow the operator's language and the colours of the theme."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent

from armui.ui.override_guard import guarded

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget as _Base
else:
    _Base = object


class Translated(_Base):
    """A mixin, placed before a widget's Qt class, that updates texts and colours after a change."""

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        raise NotImplementedError

    def _recolor(self) -> None:
        """Draw anew what the widget has painted in the theme's colours."""

    @guarded
    def changeEvent(self, event: QEvent) -> None:
        """Update texts or colours after a change of language or theme."""
        if event.type() == QEvent.Type.LanguageChange:
            self.retranslate_ui()
        elif event.type() == QEvent.Type.PaletteChange:
            self._recolor()
        super().changeEvent(event)
