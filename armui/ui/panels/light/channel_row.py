"""One colour channel: its name, a slider and a field for the same grey value."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QWidget

from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.track_slider import TrackSlider

FULL: Final = 255
"""The highest grey value."""

_FIELD_PX: Final = 74
_PAGE: Final = 16


class ChannelRow(QWidget):
    """A grey value of 0–255; the field takes other figures too and is marked then.

    Args:
        name: For the names of slider and field: ``<name>_slider``, ``<name>_field``.

    Signals:
        edited: The operator changed the value.
    """

    edited = Signal()

    def __init__(self, name: str) -> None:
        super().__init__()
        self.label = QLabel()
        self.slider = named(f"{name}_slider", TrackSlider(1.0, origin=0.0))
        self.slider.setRange(0, FULL)
        self.slider.setPageStep(_PAGE)
        self.field = named(f"{name}_field", FigureField(0))
        self.field.setFixedWidth(_FIELD_PX)
        self.label.setBuddy(self.field)
        in_row((self.slider, 1), self.field, on=self, spacing=10, margins=0)
        self.slider.valueChanged.connect(self._on_slider_moved)
        self.field.value_edited.connect(self._on_field_edited)

    @property
    def value(self) -> int | None:
        """The grey value, or ``None`` if the field holds none."""
        value = self.field.value
        return None if value is None or not 0 <= value <= FULL else int(value)

    def show_value(self, value: int) -> None:
        """Show a grey value without telling anyone."""
        self.field.show_value(value)
        self._after_change()

    def _on_slider_moved(self) -> None:
        self.field.show_value(self.slider.requested)
        self._after_change()
        self.edited.emit()

    def _on_field_edited(self) -> None:
        self._after_change()
        self.edited.emit()

    def _after_change(self) -> None:
        """The slider goes with the field as far as its track reaches."""
        wrong = self.value is None
        self.slider.show_requested(self.field.value, attention=wrong)
        self.field.show_attention(wanted=wrong)

    def describe(self, name: str, tip: str) -> None:
        """Name the channel in the operator's language."""
        self.label.setText(name)
        for widget in (self.slider, self.field):
            describe(widget, name, tip)
