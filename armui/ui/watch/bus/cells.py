"""The common part of both views: cells, and rows painted as a whole."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final, Protocol

from PySide6.QtCore import QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QFontMetricsF, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QHeaderView, QStyleOptionViewItem, QTreeView, QWidget

from armui.ui.theme import Colors, colors_of
from armui.ui.widgets.table_model import Index, ViewColumns

KEY_ROLE: Final = Qt.ItemDataRole.UserRole
"""The role of the key of the row's quantity."""

_SIDE_PX: Final = 6
_PAD_PX: Final = 18
_MORE: Final = " …"
_BYTES: Final = 8
_BYTE_CHARACTERS: Final = 3
"""The characters of a byte as shown: two digits and a space."""


class Tone(enum.Enum):
    """The colour of a cell's text."""

    PLAIN = enum.auto()
    MUTED = enum.auto()
    """Stale or unimportant."""
    NOTE = enum.auto()
    """Sent by another host."""
    TROUBLE = enum.auto()


@dataclass(frozen=True, slots=True)
class Payload:
    """Bytes of a frame.

    Attributes:
        data: The bytes.
        lit: The bytes among the first eight to highlight.
    """

    data: bytes
    lit: tuple[bool, ...]

    @property
    def text(self) -> str:
        """The bytes in hexadecimal."""
        return self.data.hex(" ").upper()


@dataclass(frozen=True, slots=True)
class TableCell:
    """The content of a cell.

    Attributes:
        text: The text.
        tone: The colour of the text.
        right: True for figures, which are aligned to the right.
        payload: The bytes shown instead of the text.
    """

    text: str = ""
    tone: Tone = Tone.PLAIN
    right: bool = False
    payload: Payload | None = None

    def data(self, role: int) -> str | None:
        """Return the answer to a role of Qt."""
        if role == Qt.ItemDataRole.AccessibleTextRole and self.payload is not None:
            return self.payload.text
        asked = {
            Qt.ItemDataRole.DisplayRole,
            Qt.ItemDataRole.ToolTipRole,
            Qt.ItemDataRole.AccessibleTextRole,
        }
        return self.text if role in asked else None


class HasCells(Protocol):
    """A model that returns a row's cells at once: `data` would be called ten times for each."""

    def cells(self, index: Index) -> Sequence[TableCell]:
        """Return the cells from the first column to the last."""


def byte_font(widget: QWidget) -> QFont:
    """Return a font with digits of equal width."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    font.setPointSizeF(widget.font().pointSizeF())
    return font


def bytes_width(widget: QWidget) -> int:
    """Return the width of eight bytes, in pixels."""
    figure_px = QFontMetricsF(byte_font(widget)).horizontalAdvance("0")
    return round(_BYTES * _BYTE_CHARACTERS * figure_px) + 2 * _SIDE_PX


class RowView(QTreeView):
    """Paints whole rows: text in the colour of its tone, bytes with the changed ones highlighted.

    Args:
        rows: The model, as the interface for whole rows.
    """

    def __init__(self, rows: HasCells, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows
        self._colors = colors_of(self)
        self._prepare_fonts()
        self.setUniformRowHeights(True)
        self.setEditTriggers(QTreeView.EditTrigger.NoEditTriggers)
        self.setSelectionBehavior(QTreeView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QTreeView.SelectionMode.ExtendedSelection)
        self.header().setStretchLastSection(False)
        self.header().setHighlightSections(False)
        self.header().setSectionsMovable(False)

    def fit_columns(self, columns: Iterable[ViewColumns], data: int, rest: int) -> None:
        """Make the columns as wide as their samples.

        Args:
            columns: The columns.
            data: The one of the bytes.
            rest: The one that takes the rest of the width.
        """
        for column in columns:
            sample_px = self._metrics.horizontalAdvance(column.declared.sample)
            self.header().resizeSection(column, sample_px + _PAD_PX)
        self.header().resizeSection(data, bytes_width(self) + _PAD_PX)
        self.header().setSectionResizeMode(rest, QHeaderView.ResizeMode.Stretch)

    def _prepare_fonts(self) -> None:
        self._byte_font = byte_font(self)
        self._lit_font = QFont(self._byte_font)
        self._lit_font.setBold(True)
        self._metrics = self.fontMetrics()
        self._figure_px = QFontMetricsF(self._byte_font).horizontalAdvance("0")

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the rows with the colours and fonts looked up once."""
        self._colors = colors_of(self)
        self._prepare_fonts()
        super().paintEvent(event)

    def drawRow(  # noqa: N802 - the name Qt calls
        self, painter: QPainter, option: QStyleOptionViewItem, index: Index
    ) -> None:
        """Draw one row, from the first column to the last."""
        top, height = option.rect.top(), option.rect.height()
        header = self.header()
        if self.selectionModel().isSelected(index):
            painter.fillRect(option.rect, QColor(self._colors.accent_pale))
        depth = 1 + index.parent().isValid() if self.rootIsDecorated() else 0
        indent_px = depth * self.indentation()
        if indent_px:
            left = self.columnViewportPosition(0)
            self.drawBranches(painter, QRect(left, top, indent_px, height), index)
        for column, cell in enumerate(self._rows.cells(index)):
            if not (cell.text or cell.payload):
                continue
            left = self.columnViewportPosition(column) + _SIDE_PX
            width = header.sectionSize(column) - 2 * _SIDE_PX
            if column == 0:
                left, width = left + indent_px, width - indent_px
            box = QRect(left, top, width, height)
            if cell.payload is not None:
                self._draw_bytes(painter, box, cell.payload, cell.tone)
            else:
                self._draw_text(painter, box, cell)
        if index.row() == self.currentIndex().row() and self.hasFocus():
            self._draw_focus(painter, option.rect, index)

    def _draw_focus(self, painter: QPainter, box: QRect, index: Index) -> None:
        current = self.currentIndex()
        if index.sibling(index.row(), 0) == current.sibling(current.row(), 0):
            painter.setPen(QPen(QColor(self._colors.accent)))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRect(box.adjusted(0, 0, -1, -1))

    def _draw_text(self, painter: QPainter, box: QRect, cell: TableCell) -> None:
        text = cell.text
        if self._metrics.horizontalAdvance(text) > box.width():
            text = self._metrics.elidedText(text, Qt.TextElideMode.ElideRight, box.width())
        side = Qt.AlignmentFlag.AlignRight if cell.right else Qt.AlignmentFlag.AlignLeft
        painter.setFont(self.font())
        painter.setPen(QColor(_ink(cell.tone, self._colors)))
        painter.drawText(box, side | Qt.AlignmentFlag.AlignVCenter, text)

    def _draw_bytes(self, painter: QPainter, box: QRect, payload: Payload, tone: Tone) -> None:
        """Draw the changed bytes one by one, highlighted, and all others as one text."""
        data, lit = payload.data[:_BYTES], payload.lit
        figures = [
            "  " if place < len(lit) and lit[place] else f"{byte:02X}"
            for place, byte in enumerate(data)
        ]
        more = _MORE if len(payload.data) > _BYTES else ""
        painter.setFont(self._byte_font)
        painter.setPen(QColor(_ink(tone, self._colors)))
        middle = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(box, middle, " ".join(figures) + more)
        painter.setFont(self._lit_font)
        painter.setPen(QColor(self._colors.warn))
        for place, byte in enumerate(data):
            if figures[place] == "  ":
                left = box.left() + place * _BYTE_CHARACTERS * self._figure_px
                ground = QRectF(left, box.top() + 3, 2 * self._figure_px, box.height() - 6)
                painter.fillRect(ground.adjusted(-2, 0, 2, 0), QColor(self._colors.warn_pale))
                painter.drawText(ground, Qt.AlignmentFlag.AlignCenter, f"{byte:02X}")


def _ink(tone: Tone, colors: Colors) -> str:
    return {
        Tone.PLAIN: colors.text,
        Tone.MUTED: colors.muted,
        Tone.NOTE: colors.accent,
        Tone.TROUBLE: colors.warn,
    }[tone]
