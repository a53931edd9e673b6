"""Has the style sheet look at a widget again, when a property it asks for has another value."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget


def repolish(widget: QWidget) -> None:
    """Have the style sheet asked anew; for a widget that was never shown it is asked then."""
    if widget.testAttribute(Qt.WidgetAttribute.WA_WState_Polished):
        style = widget.style()
        style.unpolish(widget)
        style.polish(widget)


def set_rank(widget: QWidget, rank: str) -> None:
    """Show the widget's text in the colour the style sheet has for a rank.

    A colour set by `QWidget.setPalette` is lost as soon as another theme is chosen.
    """
    if widget.property("rank") != rank:
        widget.setProperty("rank", rank)
        repolish(widget)
