"""A card of controls that scrolls where the screen is too low for it."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFrame, QScrollArea, QWidget

_LOWEST_PX: Final = 120


class CardArea(QScrollArea):
    """Takes its card when it is first shown.

    A scroll area asks at once how large its widget is, which styles everything in it; Qt would do
    that again for each parent that the area is given later.

    Args:
        card: What scrolls.
    """

    def __init__(self, card: QFrame) -> None:
        super().__init__()
        self._card = card

    def showEvent(self, event: QShowEvent) -> None:
        """Show it where it stays."""
        if self.widget() is None:
            self.setWidget(self._card)
        super().showEvent(event)


def scrolled(card: QFrame, tallest_px: int) -> QScrollArea:
    """Let a card scroll, so that the buttons and the message below it stay where they are seen.

    Args:
        card: What scrolls.
        tallest_px: It grows no higher.
    """
    card.setProperty("card", True)
    area = CardArea(card)
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setMinimumHeight(_LOWEST_PX)
    area.setMaximumHeight(tallest_px)
    return area


def bare_area(content: QWidget | None = None) -> QScrollArea:
    """Let something scroll down without a frame around it; it is as wide as the area.

    Args:
        content: What scrolls, if it is known by now.
    """
    area = QScrollArea()
    if content is not None:
        area.setWidget(content)
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return area
