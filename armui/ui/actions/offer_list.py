"""The rows of the command palette, and how one looks."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from PySide6.QtCore import (
    QAbstractListModel,
    QRect,
    QSize,
    Qt,
)
from PySide6.QtGui import QColor, QFontMetrics, QPainter
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem, QWidget

from armui.ui.actions.offer import Offer
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets.table_model import Index

_SIDE_PX: Final = 12
_GAP_PX: Final = 10
_ONE_LINE_PX: Final = 32
_TWO_LINES_PX: Final = 50


class OfferModel(QAbstractListModel):
    """The offers that the search has found, best first."""

    def __init__(self) -> None:
        super().__init__()
        self._offers: list[Offer] = []

    def show_offers(self, offers: Sequence[Offer]) -> None:
        """Show others."""
        self.beginResetModel()
        self._offers = list(offers)
        self.endResetModel()

    def offer(self, row: int) -> Offer | None:
        """That of a row; ``None`` if there is no such row."""
        return self._offers[row] if 0 <= row < len(self._offers) else None

    def row_like(self, offer: Offer | None) -> int:
        """The row of an offer that was made at another moment; 0 if it is there no more."""
        if offer is None:
            return 0
        same = (row for row, each in enumerate(self._offers) if each.is_like(offer))
        return next(same, 0)

    def rowCount(self, parent: Index | None = None) -> int:  # noqa: N802 - the name Qt calls
        """One row an offer."""
        return 0 if parent is not None and parent.isValid() else len(self._offers)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """Its words; under ``UserRole`` the offer itself."""
        offer = self.offer(index.row())
        if offer is None:
            return None
        if role in {Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole}:
            return "  ".join(filter(None, (offer.title, offer.place, offer.keys, offer.reason)))
        if role == Qt.ItemDataRole.ToolTipRole:
            return offer.reason or None
        return offer if role == Qt.ItemDataRole.UserRole else None


class OfferDelegate(QStyledItemDelegate):
    """Title, place and keys in one line; the reason of what cannot be done below them."""

    def __init__(self, view: QWidget) -> None:
        super().__init__(view)
        self._view = view

    def sizeHint(self, _option: QStyleOptionViewItem, index: Index) -> QSize:
        """Room for the reason where there is one."""
        offer: Offer = index.data(Qt.ItemDataRole.UserRole)
        return QSize(200, _TWO_LINES_PX if offer.reason else _ONE_LINE_PX)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """Draw a row."""
        offer: Offer = index.data(Qt.ItemDataRole.UserRole)
        colors = colors_of(self._view)
        rect: QRect = option.rect
        chosen = index == self._view.currentIndex()  # type: ignore[attr-defined]
        painter.save()
        if chosen:
            painter.fillRect(rect, QColor(colors.accent_pale))
            painter.fillRect(QRect(rect.left(), rect.top(), 3, rect.height()), colors.accent)
        line = QRect(rect.left() + _SIDE_PX, rect.top(), rect.width() - 2 * _SIDE_PX, _ONE_LINE_PX)
        middle = Qt.AlignmentFlag.AlignVCenter
        plain, small = scaled_font(self._view, 1.0), scaled_font(self._view, 0.9)
        if offer.keys:
            painter.setFont(small)
            painter.setPen(QColor(colors.muted))
            painter.drawText(line, middle | Qt.AlignmentFlag.AlignRight, offer.keys)
            taken = QFontMetrics(small).horizontalAdvance(offer.keys) + _GAP_PX
            line.setRight(line.right() - taken)
        painter.setFont(scaled_font(self._view, 1.0, bold=chosen))
        painter.setPen(QColor(colors.muted if offer.reason else colors.text))
        metrics = QFontMetrics(painter.font())
        title = metrics.elidedText(offer.title, Qt.TextElideMode.ElideRight, line.width())
        painter.drawText(line, middle, title)
        line.setLeft(line.left() + metrics.horizontalAdvance(title) + _GAP_PX)
        painter.setFont(plain)
        painter.setPen(QColor(colors.muted))
        place = QFontMetrics(plain).elidedText(
            offer.place, Qt.TextElideMode.ElideRight, max(0, line.width())
        )
        painter.drawText(line, middle, place)
        if offer.reason:
            below = rect.adjusted(_SIDE_PX, _ONE_LINE_PX - 6, -_SIDE_PX, -4)
            painter.setFont(small)
            reason = QFontMetrics(small).elidedText(
                offer.reason, Qt.TextElideMode.ElideRight, below.width()
            )
            painter.drawText(below, middle, reason)
        painter.restore()
