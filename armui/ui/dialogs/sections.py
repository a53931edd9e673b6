"""Text for reading: sections in columns, each with a heading and explaining lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QScrollArea, QSizePolicy, QWidget

from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting
from armui.ui.widgets.layouts import empty_grid, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent


_COLUMN_GAP_PX: Final = 36
_SECTION_GAP_PX: Final = 12


class KeyCap(QLabel):
    """A word in a box that looks like a key."""

    def __init__(self) -> None:
        super().__init__()
        self.setContentsMargins(9, 4, 9, 5)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the key, then the word on it."""
        colors = colors_of(self)
        painter = painting.begin(self)
        box = QRectF(self.rect())
        painting.panel(painter, box, colors.border, colors.border)
        painting.panel(painter, box.adjusted(0, 0, 0, -2), colors.surface, colors.border)
        painter.end()
        super().paintEvent(event)


@dataclass(frozen=True, slots=True)
class HelpSection:
    """A heading and its lines: an action or a sign, and its effect or meaning.

    Attributes:
        heading: The heading.
        lines: The left and right texts; those without a translation are plain strings.
        keys: True if the left texts are keys or gestures.
    """

    heading: Text
    lines: Sequence[tuple[Text | str, Text]]
    keys: bool = True


class SectionsArea(Translated, QScrollArea):
    """Shows the sections.

    Args:
        columns: The columns, from left to right.
        gaps_px: The gaps within a line, and between two.
    """

    def __init__(self, *columns: Sequence[HelpSection], gaps_px: tuple[int, int]) -> None:
        super().__init__()
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._texts: list[tuple[QLabel, Text]] = []
        self._content = QWidget()
        row = in_row(on=self._content, spacing=_COLUMN_GAP_PX, margins=(0, 0, 8, 0))
        for sections in columns:
            grid = empty_grid(gaps=gaps_px)
            grid.setColumnStretch(1, 1)
            for section in sections:
                self._add_section(grid, section)
            grid.setRowStretch(grid.rowCount(), 1)
            row.addLayout(grid, 1)
        self.setWidget(self._content)
        self.retranslate_ui()

    def _add_section(self, grid: QGridLayout, section: HelpSection) -> None:
        row = grid.rowCount()
        grid.setRowMinimumHeight(row, _SECTION_GAP_PX if row > 1 else 0)
        row += 1
        heading = text_label(rank="muted")
        grid.addWidget(heading, row, 0, 1, 2)
        self._texts.append((heading, section.heading))
        align = Qt.AlignmentFlag.AlignVCenter if section.keys else Qt.AlignmentFlag.AlignTop
        for what, meaning in section.lines:
            row += 1
            left, right = KeyCap() if section.keys else QLabel(), QLabel()
            left.setFont(scaled_font(left, 1.0, bold=not section.keys))
            right.setWordWrap(True)
            grid.addWidget(left, row, 0, align | Qt.AlignmentFlag.AlignLeft)
            grid.addWidget(right, row, 1, align)
            self._texts.append((right, meaning))
            if isinstance(what, Text):
                self._texts.append((left, what))
            else:
                left.setText(what)

    def showEvent(self, event: QShowEvent) -> None:
        """Update the heights of the lines for the fonts of the style sheet."""
        super().showEvent(event)
        layout = self._content.layout()
        if layout is not None:
            layout.invalidate()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        for label, text in self._texts:
            label.setText(text.text())
