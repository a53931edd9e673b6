"""Above each plot: which colour is which quantity, and its value now."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFontMetricsF, QPainter
from PySide6.QtWidgets import QApplication, QSizePolicy, QWidget

from armui.ui.theme import colors_of, scaled_font
from armui.ui.watch.carrying import carry_away

if TYPE_CHECKING:
    from PySide6.QtGui import QMouseEvent, QPaintEvent, QResizeEvent

_SWATCH_PX: Final = 14.0
_GAP_PX: Final = 6.0
_BETWEEN_PX: Final = 18.0
_LINE_PX: Final = 4.0
_WIDEST: Final = "−0000.000"


@dataclass(frozen=True, slots=True)
class Entry:
    """One curve in the legend.

    Attributes:
        key: Of the quantity.
        name: In the operator's language.
        color: Of the curve.
        value: As text; "" where it shall have no room.
        stale: Not heard for half a second.
    """

    key: str
    name: str
    color: str
    value: str = ""
    stale: bool = False


class Legend(QWidget):
    """Painted: a new value costs one repaint and no new layout.

    Args:
        plot: The place of its plot: goes with what is dragged away.

    Signals:
        chosen: An entry was clicked: its key.
    """

    chosen = Signal(str)

    def __init__(self, plot: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._entries: tuple[Entry, ...] = ()
        self._title = ""
        self._value_px: dict[str, float] = {}
        self._places: list[QRectF] = []
        self._pressed: QPoint | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    @property
    def entries(self) -> tuple[Entry, ...]:
        """What it shows."""
        return self._entries

    @property
    def title(self) -> str:
        """What stands before the entries."""
        return self._title

    def show_entries(self, entries: Sequence[Entry], title: str = "") -> None:
        """Show these, behind what they have in common."""
        wanted = tuple(entries)
        if (wanted, title) == (self._entries, self._title):
            return
        names = [(each.key, each.name) for each in wanted]
        metrics = QFontMetricsF(self.font())
        grown = False
        for entry in wanted:
            value_px = metrics.horizontalAdvance(entry.value)
            if value_px > self._value_px.get(entry.key, metrics.horizontalAdvance(_WIDEST)):
                # grows, and never shrinks: words change, and figures stand still
                self._value_px[entry.key] = value_px
                grown = True
        moved = (
            grown
            or title != self._title
            or names != [(each.key, each.name) for each in self._entries]
        )
        self._entries, self._title = wanted, title
        if moved:
            self._arrange()
        self.update()

    def key_at(self, place: QPoint) -> str | None:
        """The quantity of the entry at a place."""
        for rect, entry in zip(self._places, self._entries, strict=True):
            if rect.contains(QPointF(place)):
                return entry.key
        return None

    def place_of(self, key: str) -> QPoint:
        """The middle of an entry.

        Raises:
            ValueError: It is not shown.
        """
        keys = [entry.key for entry in self._entries]
        return self._places[keys.index(key)].center().toPoint()

    def _arrange(self) -> None:
        metrics = QFontMetricsF(self.font())
        line_px = metrics.height() + _LINE_PX
        top = 0.0
        left = begin = self._title_px()
        self._places = []
        for entry in self._entries:
            width = _SWATCH_PX + 2 * _GAP_PX + metrics.horizontalAdvance(entry.name)
            width += self._value_px.get(entry.key, metrics.horizontalAdvance(_WIDEST))
            if left > begin and left + width > self.width():
                left, top = begin, top + line_px
            self._places.append(QRectF(left, top, min(width, float(self.width())), line_px))
            left += width + _BETWEEN_PX
        self.setFixedHeight(round(top + line_px))

    def _title_px(self) -> float:
        if not self._title:
            return 0.0
        metrics = QFontMetricsF(scaled_font(self, 1.0, bold=True))
        return metrics.horizontalAdvance(self._title) + _BETWEEN_PX

    def minimumSizeHint(self) -> QSize:
        """It wraps."""
        return QSize(120, self.fontMetrics().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Wrap anew."""
        super().resizeEvent(event)
        self._arrange()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        colors = colors_of(self)
        metrics = QFontMetricsF(self.font())
        painter = QPainter(self)
        if self._title:
            painter.setFont(scaled_font(self, 1.0, bold=True))
            painter.setPen(QColor(colors.text))
            whole = QRectF(0, 0, self._title_px(), metrics.height() + _LINE_PX)
            painter.drawText(whole, Qt.AlignmentFlag.AlignVCenter, self._title)
            painter.setFont(self.font())
        for rect, entry in zip(self._places, self._entries, strict=True):
            middle = rect.center().y()
            painter.fillRect(QRectF(rect.left(), middle - 1.5, _SWATCH_PX, 3.0), entry.color)
            left = rect.left() + _SWATCH_PX + _GAP_PX
            text = QRectF(left, rect.top(), rect.right() - left, rect.height())
            flags = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
            painter.setPen(QColor(colors.muted if entry.stale else colors.text))
            painter.drawText(text, flags, entry.name)
            text.setLeft(left + metrics.horizontalAdvance(entry.name) + _GAP_PX)
            painter.setPen(QColor(colors.muted))
            painter.drawText(text, flags, entry.value)
        painter.end()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """A drag may begin; between the entries the press is the plot's."""
        place = event.position().toPoint()
        if event.button() == Qt.MouseButton.LeftButton and self.key_at(place) is not None:
            self._pressed = place
        else:
            event.ignore()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Take a quantity to another plot."""
        pressed, now = self._pressed, event.position().toPoint()
        if pressed is None:
            return
        key = self.key_at(pressed)
        far = (now - pressed).manhattanLength() >= QApplication.startDragDistance()
        if key is not None and far:
            self._pressed = None
            carry_away(self, [key], self._plot)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A click without a drag chooses."""
        key = None if self._pressed is None else self.key_at(event.position().toPoint())
        self._pressed = None
        if key is not None:
            self.chosen.emit(key)
