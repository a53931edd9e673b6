"""How a cell of the window 关节状态 is drawn: mark, word, and small under it the figure."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from armui.ui import format as fmt
from armui.ui.dialogs.joint_status_model import CELL_ROLE, CellView
from armui.ui.theme import Colors, colors_of, scaled_font
from armui.ui.widgets import state_mark
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.table_model import Index

_MARK_PX: Final = 7.0
_LEFT_PX: Final = 10.0
_GAP_PX: Final = 8.0
_TEXT_LEFT_PX: Final = _LEFT_PX + 2 * _MARK_PX + _GAP_PX
_ROW_PX: Final = 40
_SMALL: Final = 0.84


class JointCellDelegate(QStyledItemDelegate):
    """Draws a :class:`CellView`; a fault stands on a ground of its own."""

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: Index,
    ) -> None:
        """Draw one cell."""
        view = index.data(CELL_ROLE)
        table = self.parent()
        if not isinstance(view, CellView) or not isinstance(table, QWidget):
            return
        colors = colors_of(table)
        state, box = option.state, QRectF(option.rect)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        is_fault = view.mark is Mark.FAULT
        if is_fault and not view.stale:
            painter.fillRect(box, QColor(colors.stop_pale))
        if state & QStyle.StateFlag.State_HasFocus:
            painter.setPen(QPen(QColor(colors.accent), 2))
            painter.drawRect(box.adjusted(1, 1, -1, -1))
        self._draw_text(painter, colors, box, view, table)
        painter.restore()

    @staticmethod
    def _draw_text(
        painter: QPainter, colors: Colors, box: QRectF, view: CellView, table: QWidget
    ) -> None:
        is_fault = view.mark is Mark.FAULT
        word_font = scaled_font(table, 1.0, bold=is_fault)
        small_font = scaled_font(table, _SMALL)
        word_px = QFontMetrics(word_font).height()
        small_px = QFontMetrics(small_font).height() if view.small else 0
        top = box.center().y() - (word_px + small_px) / 2
        left, width = box.left() + _TEXT_LEFT_PX, box.width() - _TEXT_LEFT_PX
        if view.mark is not None:
            center = QPointF(box.left() + _LEFT_PX + _MARK_PX, top + word_px / 2)
            state_mark.draw(painter, colors, center, _MARK_PX, view.mark, muted=view.stale)
        painter.setFont(word_font)
        dim = view.stale or view.text == fmt.NOTHING
        painter.setPen(QColor(colors.muted if dim else colors.text))
        painter.drawText(QRectF(left, top, width, word_px), Qt.AlignmentFlag.AlignLeft, view.text)
        if view.small:
            small_color = colors.text if is_fault and not view.stale else colors.muted
            painter.setFont(small_font)
            painter.setPen(QColor(small_color))
            below = QRectF(left, top + word_px, width, small_px)
            painter.drawText(below, Qt.AlignmentFlag.AlignLeft, view.small)

    def sizeHint(self, _option: QStyleOptionViewItem, _index: Index) -> QSize:
        """The columns share the table's width."""
        return QSize(0, _ROW_PX)


def cell_width(table: QWidget, words: list[str]) -> int:
    """How wide a column must be for these words, bold, behind their mark."""
    metrics = QFontMetrics(scaled_font(table, 1.0, bold=True))
    widest = max(metrics.horizontalAdvance(word) for word in words)
    small = QFontMetrics(scaled_font(table, _SMALL)).horizontalAdvance("-00.00 °/s · 00:00:00")
    return int(_TEXT_LEFT_PX + max(widest, small) + _GAP_PX)
