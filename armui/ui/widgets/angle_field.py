"""The field for a joint's target angle."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QLineEdit, QWidget

from armui.ui import format as fmt
from armui.ui.theme import colors_of

_UNIT = "°"


class AngleField(QLineEdit):
    """Takes any figure, also one out of limits: what is wrong with it is said, not prevented.

    Empty until something is known or typed. Enter and leaving the field tidy the figure up;
    Escape brings back what stood there before; the arrow keys turn it by :attr:`step_deg`.
    """

    value_edited = Signal()
    """The operator changed the text."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.step_deg = 1.0
        self._committed = ""
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setPlaceholderText(fmt.NOTHING)
        self.setTextMargins(0, 0, 5, 0)
        self.setFixedHeight(32)
        self.setMaxLength(16)
        self.textEdited.connect(self.value_edited)
        self.editingFinished.connect(self._on_editing_finished)

    @property
    def value_deg(self) -> float | None:
        """The figure in the field to a thousandth of a degree; ``None`` if there is none."""
        value = fmt.parse_number(self.text())
        return None if value is None else round(value, fmt.DECIMALS)

    def show_value(self, value_deg: float | None) -> None:
        """Put a figure into the field; ``None`` empties it."""
        self._committed = "" if value_deg is None else fmt.number(value_deg)
        self.setText(self._committed)

    def is_nonsense(self) -> bool:
        """Whether there is text that is no figure."""
        return bool(self.text().strip()) and self.value_deg is None

    def show_attention(self, *, wanted: bool) -> None:
        """Mark the field, or take the mark away."""
        if bool(self.property("attention")) != wanted:
            self.setProperty("attention", wanted)
            self.style().unpolish(self)
            self.style().polish(self)

    def _on_editing_finished(self) -> None:
        value = self.value_deg
        if value is not None:
            self.show_value(value)
        elif not self.text().strip():
            self.show_value(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrow keys and Escape; all else edits the text."""
        steps = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}.get(Qt.Key(event.key()))
        value = self.value_deg
        if event.key() == Qt.Key.Key_Escape and self.text() != self._committed:
            self.setText(self._committed)
            self.value_edited.emit()
        elif steps is not None and value is not None:
            self.setText(fmt.number(value + steps * self.step_deg))
            self.value_edited.emit()
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Tab chooses the whole figure, to be typed over."""
        super().focusInEvent(event)
        if event.reason() in {Qt.FocusReason.TabFocusReason, Qt.FocusReason.BacktabFocusReason}:
            self.selectAll()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the unit behind the figure."""
        super().paintEvent(event)
        if not self.text():
            return
        painter = QPainter(self)
        colors = colors_of(self)
        painter.setPen(QColor(colors.muted if self.isEnabled() else colors.faint))
        area = self.rect().adjusted(0, 0, -9, 0)
        painter.drawText(area, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, _UNIT)
        painter.end()
