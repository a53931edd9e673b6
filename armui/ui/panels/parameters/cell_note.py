"""The line below a value that says how it stands: a mark and a word."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from armui.control.parameters.setting_draft import CellStatus
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting, state_mark
from armui.ui.widgets.state_mark import Mark

_FONT_SCALE: Final = 0.82
_RADIUS_PX: Final = 4.5
_GAP_PX: Final = 4.0

_MARKS: Final = {
    CellStatus.NOT_READ: Mark.UNKNOWN,
    CellStatus.READING: Mark.WAITING,
    CellStatus.CORRUPT: Mark.ATTENTION,
    CellStatus.CHANGED: Mark.CHANGED,
    CellStatus.WRONG: Mark.ATTENTION,
    CellStatus.SAVING: Mark.WAITING,
    CellStatus.SAVED: Mark.GOOD,
    CellStatus.NOT_SAVED: Mark.FAULT,
}


class CellNote(QWidget):
    """Keeps its room when there is nothing to say."""

    def __init__(self) -> None:
        super().__init__()
        self._status = CellStatus.READ
        self._text = ""
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

    def text(self) -> str:
        """The word."""
        return self._text

    @property
    def status(self) -> CellStatus:
        """What the mark tells."""
        return self._status

    def show_status(self, status: CellStatus, text: str) -> None:
        """Show another mark and word."""
        if (status, text) != (self._status, self._text):
            self._status, self._text = status, text
            self.setAccessibleName(text)
            self.update()

    def sizeHint(self) -> QSize:
        """One line of small text."""
        return QSize(0, QFontMetrics(self._font()).height())

    def minimumSizeHint(self) -> QSize:
        """Its width is that of the value above."""
        return self.sizeHint()

    def _font(self) -> QFont:
        return scaled_font(self, _FONT_SCALE)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the mark and, at its right, the word; both towards the right edge."""
        mark = _MARKS.get(self._status)
        if mark is None and not self._text:
            return
        painter = painting.begin(self)
        painter.setFont(self._font())
        metrics = painter.fontMetrics()
        mark_px = 0.0 if mark is None else 2 * _RADIUS_PX + _GAP_PX
        room_px = self.width() - mark_px
        text = metrics.elidedText(self._text, Qt.TextElideMode.ElideRight, int(room_px))
        width_px = metrics.horizontalAdvance(text)
        colors = colors_of(self)
        if mark is not None:
            x = self.width() - width_px - _GAP_PX - _RADIUS_PX
            center = QPointF(x, self.height() / 2)
            state_mark.draw(painter, colors, center, _RADIUS_PX, mark)
        painter.setPen(QColor(colors.muted))
        area = QRectF(self.width() - width_px, 0, width_px + 1, self.height())
        painter.drawText(area, Qt.AlignmentFlag.AlignVCenter, text)
        painter.end()
