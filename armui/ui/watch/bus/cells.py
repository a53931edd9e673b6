"""What the cells of both views have in common: roles, bytes, colours."""

from __future__ import annotations

import enum
from typing import Final, NamedTuple

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontDatabase, QFontMetrics, QPainter, QPalette
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem, QTreeView, QWidget

from armui.ui.theme import Colors, colors_of

Index = QModelIndex | QPersistentModelIndex

BYTES_ROLE: Final = Qt.ItemDataRole.UserRole
"""A `Payload`, painted in place of the text."""
TONE_ROLE: Final = Qt.ItemDataRole.UserRole + 1
"""A `Tone`."""
KEY_ROLE: Final = Qt.ItemDataRole.UserRole + 2
"""The key of the quantity that the row shows."""

_GAP_PX: Final = 4
_SIDE_PX: Final = 6
_MORE: Final = "…"


class Tone(enum.Enum):
    """How a cell is to be read."""

    PLAIN = enum.auto()
    MUTED = enum.auto()
    """Stale, or of no weight."""
    NOTE = enum.auto()
    """Sent by somebody else."""
    TROUBLE = enum.auto()


class Payload(NamedTuple):
    """Bytes of a frame.

    Attributes:
        data: The bytes.
        lit: Which of the first eight are to be lit.
    """

    data: bytes
    lit: tuple[bool, ...]

    @property
    def text(self) -> str:
        """In hexadecimal."""
        return self.data.hex(" ").upper()


def byte_font(widget: QWidget) -> QFont:
    """A font in which all figures are of one width."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    font.setPointSizeF(widget.font().pointSizeF())
    return font


def bytes_width(widget: QWidget) -> int:
    """Room for eight bytes, in pixels."""
    byte_px = QFontMetrics(byte_font(widget)).horizontalAdvance("00")
    return 8 * (byte_px + _GAP_PX) + 2 * _SIDE_PX


class CellDelegate(QStyledItemDelegate):
    """Paints bytes, the changed ones lit, and text in the colour of its tone."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:  # noqa: N802 - Qt
        """The colour of the text."""
        super().initStyleOption(option, index)
        tone = index.data(TONE_ROLE)
        if isinstance(tone, Tone) and tone is not Tone.PLAIN and option.widget is not None:
            color = QColor(_ink(tone, colors_of(option.widget)))
            option.palette.setColor(QPalette.ColorRole.Text, color)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """Text as ever, bytes one by one."""
        super().paint(painter, option, index)
        payload = index.data(BYTES_ROLE)
        if not isinstance(payload, Payload) or option.widget is None:
            return
        widget = option.widget
        colors = colors_of(widget)
        tone = index.data(TONE_ROLE)
        ink = QColor(_ink(tone if isinstance(tone, Tone) else Tone.PLAIN, colors))
        font = byte_font(widget)
        metrics = QFontMetrics(font)
        byte_px, height_px = metrics.horizontalAdvance("00"), metrics.height()
        painter.save()
        painter.setClipRect(option.rect)
        left, top = option.rect.left() + _SIDE_PX, option.rect.center().y() - height_px // 2
        for place, byte in enumerate(payload.data[:8]):
            box = QRect(left + place * (byte_px + _GAP_PX), top, byte_px, height_px)
            lit = place < len(payload.lit) and payload.lit[place]
            font.setBold(lit)
            painter.setFont(font)
            if lit:
                painter.fillRect(box.adjusted(-1, 0, 1, 1), QColor(colors.warn_pale))
            painter.setPen(QColor(colors.warn) if lit else ink)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, f"{byte:02X}")
        if len(payload.data) > 8:
            end = left + 8 * (byte_px + _GAP_PX)
            painter.setPen(ink)
            painter.drawText(QRect(end, top, byte_px, height_px), _MORE)
        painter.restore()

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        """A little air above and below."""
        size = super().sizeHint(option, index)
        return QSize(size.width(), max(size.height(), option.fontMetrics.height() + 8))


def _ink(tone: Tone, colors: Colors) -> str:
    return {
        Tone.PLAIN: colors.text,
        Tone.MUTED: colors.muted,
        Tone.NOTE: colors.accent,
        Tone.TROUBLE: colors.stop,
    }[tone]


def prepare_view(view: QTreeView) -> None:
    """Rows of one height, nothing to be edited, whole rows chosen."""
    view.setUniformRowHeights(True)
    view.setEditTriggers(QTreeView.EditTrigger.NoEditTriggers)
    view.setSelectionBehavior(QTreeView.SelectionBehavior.SelectRows)
    view.setSelectionMode(QTreeView.SelectionMode.ExtendedSelection)
    view.setAllColumnsShowFocus(True)
    view.setItemDelegate(CellDelegate(view))
    view.header().setStretchLastSection(False)
    view.header().setHighlightSections(False)
    view.header().setSectionsMovable(False)
