"""Rows, columns and grids of widgets, said in one line each."""

from __future__ import annotations

from typing import Final, TypeAlias, TypeVar

from PySide6.QtWidgets import QBoxLayout, QGridLayout, QHBoxLayout, QLayout, QVBoxLayout, QWidget

STRETCH: Final = None
"""Takes the room that is left."""

Item: TypeAlias = QWidget | QLayout | tuple[QWidget | QLayout, int] | int | None
"""A widget or layout, alone or with its share of the room; pixels of space; or `STRETCH`."""

Margins: TypeAlias = int | tuple[int, int, int, int]
"""In pixels: left, top, right and bottom, or one for all."""

Box = TypeVar("Box", bound=QBoxLayout)


def in_row(
    *items: Item,
    on: QWidget | None = None,
    spacing: int | None = None,
    margins: Margins | None = None,
) -> QHBoxLayout:
    """Put items beside one another.

    Args:
        items: From left to right.
        on: The widget whose layout it becomes.
        spacing: Between two items, in pixels; by default the style's.
        margins: Around them; by default the style's.
    """
    return _filled(QHBoxLayout() if on is None else QHBoxLayout(on), items, spacing, margins)


def in_column(
    *items: Item,
    on: QWidget | None = None,
    spacing: int | None = None,
    margins: Margins | None = None,
) -> QVBoxLayout:
    """Put items below one another; as :func:`in_row`."""
    return _filled(QVBoxLayout() if on is None else QVBoxLayout(on), items, spacing, margins)


def empty_grid(
    on: QWidget | None = None,
    *,
    gaps: tuple[int | None, int | None] = (None, None),
    margins: Margins | None = None,
) -> QGridLayout:
    """A grid to be filled.

    Args:
        on: The widget whose layout it becomes.
        gaps: Between two columns and between two rows, in pixels; None: the style's.
        margins: Around it; by default the style's.
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
