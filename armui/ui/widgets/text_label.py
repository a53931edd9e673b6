"""Labels as the program uses them."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel


def text_label(
    name: str = "", *, rank: str = "", wraps: bool = False, plain: bool = False
) -> QLabel:
    """An empty label.

    Args:
        name: Its object name.
        rank: How the style sheet shows it: ``title``, ``muted``, …
        wraps: Whether long text goes on below.
        plain: Whether text that looks like HTML is shown as it is.
    """
    label = QLabel()
    label.setObjectName(name)
    if rank:
        label.setProperty("rank", rank)
    label.setWordWrap(wraps)
    if plain:
        label.setTextFormat(Qt.TextFormat.PlainText)
    return label
