"""A card of controls that scrolls where the screen is too low for it."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QScrollArea

_LOWEST_PX: Final = 120


def scrolled(card: QFrame, tallest_px: int) -> QScrollArea:
    """Let a card scroll, so that the buttons and the message below it stay where they are seen.

    Args:
        card: What scrolls.
        tallest_px: It grows no higher.
    """
    card.setProperty("card", True)
    area = QScrollArea()
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setWidget(card)
    area.setMinimumHeight(_LOWEST_PX)
    area.setMaximumHeight(tallest_px)
    return area
