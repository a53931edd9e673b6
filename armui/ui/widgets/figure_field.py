"""A field for a figure, in which wrong entries are explained, not prevented."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QLineEdit

from armui.ui import format as fmt
from armui.ui.theme import colors_of
from armui.ui.widgets.painting import repolish


class FigureField(QLineEdit):
    """A field that accepts any text; a figure in it is :attr:`value`.

    It is empty until a value is known or typed. Enter and leaving the field format the figure;
    Escape restores the former one; the arrow keys change it by :attr:`step`.

    Args:
        decimals: The decimals; with 0 only whole numbers are valid.
        unit: The unit drawn behind it.
    """

    value_edited = Signal()
    """Emitted when the operator has changed the text."""
    restored = Signal()
    """Emitted after ``value_edited`` when Escape has restored the former text."""

    def __init__(self, decimals: int, unit: str = "") -> None:
        super().__init__()
        self.step = 1.0
        self._decimals = decimals
        self.unit = unit
        self._committed = ""
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setPlaceholderText(fmt.NOTHING)
        self.setTextMargins(0, 0, self._unit_px(), 0)
        self.setFixedHeight(32)
        self.setMaxLength(16)
        self.textEdited.connect(self.value_edited)
        self.editingFinished.connect(self._on_editing_finished)

    @property
    def value(self) -> float | None:
        """The figure in the field, rounded to its decimals; ``None`` if there is none."""
        value = fmt.parse_number(self.text())
        if value is None or (self._decimals == 0 and not value.is_integer()):
            return None
        return round(value, self._decimals)

    def show_value(self, value: float | None) -> None:
        """Set the figure; ``None`` empties the field."""
        self._committed = "" if value is None else fmt.number(value, self._decimals)
        self.setText(self._committed)

    def follow(self, value: float | None) -> bool:
        """Show a changing figure, and return whether its text has changed.

        A selected text stays selected.
        """
        text = "" if value is None else fmt.number(value, self._decimals)
        if text == self.text():
            return False
        chosen = bool(self.selectedText()) and self.selectedText() == self.text()
        self.show_value(value)
        if chosen:
            self.selectAll()
        return True

    def is_nonsense(self) -> bool:
        """Return whether the text is no figure."""
        return bool(self.text().strip()) and self.value is None

    def show_attention(self, *, wanted: bool) -> None:
        """Mark the field, or remove the mark."""
        self._mark("attention", wanted=wanted)

    def show_typed(self, *, wanted: bool) -> None:
        """Mark that the figure is the operator's own, where others follow, or remove the mark."""
        self._mark("typed", wanted=wanted)

    def _mark(self, name: str, *, wanted: bool) -> None:
        if bool(self.property(name)) != wanted:
            self.setProperty(name, wanted)
            repolish(self)

    def _unit_px(self) -> int:
        """Return the width of the unit in pixels; only a degree sign has no gap before it."""
        if self.unit in {"", "°"}:
            return 5 * len(self.unit)
        return self.fontMetrics().horizontalAdvance(self.unit) + 5

    def _on_editing_finished(self) -> None:
        value = self.value
        if value is not None:
            self.show_value(value)
        elif not self.text().strip():
            self.show_value(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Handle arrow keys and Escape; other keys edit the text."""
        steps = {Qt.Key.Key_Up: 1, Qt.Key.Key_Down: -1}.get(Qt.Key(event.key()))
        value = self.value
        if event.key() == Qt.Key.Key_Escape and self.text() != self._committed:
            self.setText(self._committed)
            self.value_edited.emit()
            self.restored.emit()
        elif steps is not None and value is not None:
            self.setText(fmt.number(value + steps * self.step, self._decimals))
            self.value_edited.emit()
        else:
            super().keyPressEvent(event)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Select the whole figure when the field is entered by Tab."""
        super().focusInEvent(event)
        if event.reason() in {Qt.FocusReason.TabFocusReason, Qt.FocusReason.BacktabFocusReason}:
            self.selectAll()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the unit behind the figure."""
        super().paintEvent(event)
        if not (self.text() and self.unit):
            return
        painter = QPainter(self)
        colors = colors_of(self)
        painter.setPen(QColor(colors.muted if self.isEnabled() else colors.faint))
        area = self.rect().adjusted(0, 0, -9, 0)
        flags = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(area, flags, self.unit)
        painter.end()
