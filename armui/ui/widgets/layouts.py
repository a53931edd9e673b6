"""Functions that make rows, columns and grids of widgets, and cards that scroll."""

from __future__ import annotations

from typing import Final, TypeAlias, TypeVar

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLayout,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

STRETCH: Final = None
"""An item that takes the rest of the room."""

Item: TypeAlias = QWidget | QLayout | tuple[QWidget | QLayout, int] | int | None
"""A widget or layout, alone or with its stretch factor; pixels of space; or `STRETCH`."""

Margins: TypeAlias = int | tuple[int, int, int, int]
"""The left, top, right and bottom margins in pixels, or one for all."""

Box = TypeVar("Box", bound=QBoxLayout)
_LOWEST_PX: Final = 120


class CardArea(QScrollArea):
    """A scroll area that takes its card when it is first shown.

    A scroll area computes the size of its widget at once, which styles everything in it; Qt would
    repeat that for each parent that the area gets later.

    Args:
        card: The card that scrolls; the area is never higher than it.
    """

    def __init__(self, card: QWidget) -> None:
        super().__init__()
        self._card = card
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    @property
    def wanted_px(self) -> int:
        """Return the height at which the whole card is visible."""
        card = self._card
        least = card.minimumSizeHint().height()
        if card.hasHeightForWidth():
            least = max(least, card.heightForWidth(self.viewport().width()))
        return least + 2 * self.frameWidth()

    def showEvent(self, event: QShowEvent) -> None:
        """Take the card, at the first time."""
        if self.widget() is None:
            self.setWidget(self._card)
            self._card.setAutoFillBackground(False)  # it would fill the round corners
        self.fit()
        super().showEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the height, because text wraps differently in another width."""
        super().resizeEvent(event)
        self.fit()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Fit the height after a change of texts or parts."""
        if watched is self._card and event.type() == QEvent.Type.LayoutRequest:
            self.fit()
        return super().eventFilter(watched, event)

    def fit(self) -> None:
        """Be no higher than the card."""
        if self.widget() is not None:
            self.setMaximumHeight(self.wanted_px)


def scrolled(card: QFrame) -> QScrollArea:
    """Return a scroll area for a card, so that the parts below it stay visible."""
    card.setProperty("card", True)
    area = CardArea(card)
    area.setMinimumHeight(_LOWEST_PX)
    return area


def bare_area(content: QWidget | None = None) -> QScrollArea:
    """Return a vertical scroll area without frame, with a content of its own width.

    Args:
        content: The content, if it is known already.
    """
    area = QScrollArea()
    if content is not None:
        area.setWidget(content)
    area.setWidgetResizable(True)
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    return area


def in_row(
    *items: Item,
    on: QWidget | None = None,
    spacing: int | None = None,
    margins: Margins | None = None,
) -> QHBoxLayout:
    """Put items beside one another.

    Args:
        items: The items from left to right.
        on: The widget whose layout it becomes.
        spacing: The space between two items, in pixels; by default the style's.
        margins: The margins around them; by default the style's.
    """
    return _filled(QHBoxLayout() if on is None else QHBoxLayout(on), items, spacing, margins)


def in_column(
    *items: Item,
    on: QWidget | None = None,
    spacing: int | None = None,
    margins: Margins | None = None,
) -> QVBoxLayout:
    """Put items below one another; see :func:`in_row`."""
    return _filled(QVBoxLayout() if on is None else QVBoxLayout(on), items, spacing, margins)


def empty_grid(
    on: QWidget | None = None,
    *,
    gaps: tuple[int | None, int | None] = (None, None),
    margins: Margins | None = None,
) -> QGridLayout:
    """Return an empty grid.

    Args:
        on: The widget whose layout it becomes.
        gaps: The space between two columns and between two rows, in pixels; None for the style's.
        margins: The margins around it; by default the style's.
    """
    grid = QGridLayout() if on is None else QGridLayout(on)
    _set_margins(grid, margins)
    across, down = gaps
    if across is not None:
        grid.setHorizontalSpacing(across)
    if down is not None:
        grid.setVerticalSpacing(down)
    return grid


def fill(layout: QBoxLayout, *items: Item) -> None:
    """Add items to a row or column, one after another."""
    for each in items:
        if each is None:
            layout.addStretch(1)
        elif isinstance(each, int):
            layout.addSpacing(each)
        else:
            content, share = each if isinstance(each, tuple) else (each, 0)
            if isinstance(content, QWidget):
                layout.addWidget(content, share)
            else:
                layout.addLayout(content, share)


def _filled(
    layout: Box, items: tuple[Item, ...], spacing: int | None, margins: Margins | None
) -> Box:
    _set_margins(layout, margins)
    if spacing is not None:
        layout.setSpacing(spacing)
    fill(layout, *items)
    return layout


def _set_margins(layout: QLayout, margins: Margins | None) -> None:
    if margins is not None:
        layout.setContentsMargins(*((margins,) * 4 if isinstance(margins, int) else margins))
