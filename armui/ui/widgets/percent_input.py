"""A percentage that may be changed while the arm moves: a slider and a field that go together."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from PySide6.QtCore import QObject, QSignalBlocker, Qt
from PySide6.QtWidgets import QSpinBox, QWidget

from armui.ui.widgets.buttons import named
from armui.ui.widgets.track_slider import TrackSlider

_FIELD_PX: Final = 70
_STEP_PERCENT: Final = 10
_FULL_PERCENT: Final = 100


class PercentInput(QObject):
    """Joins a slider and a field for 0–100 %.

    A lower percentage counts while the handle is dragged, a higher one when it is let go; keys,
    clicks and the field count at once.

    Args:
        name: The slider is called ``<name>_slider``, the field ``<name>_field``.
        value: Tells the percentage that holds.
        choose: Called with another one that the operator has chosen.
        parent: The widget that lays both out.
        warns: Whether less than 100 % is shown as something to be noticed.

    Attributes:
        slider: Shows the percentage that holds, and may show a measured one.
        field: Takes a figure.
    """

    def __init__(
        self,
        name: str,
        value: Callable[[], int],
        choose: Callable[[int], object],
        parent: QWidget,
        *,
        warns: bool = False,
    ) -> None:
        super().__init__(parent)
        self._value = value
        self._choose = choose
        self._warns = warns
        self.slider = named(f"{name}_slider", TrackSlider(1.0, origin=0.0, jumps=False))
        self.slider.setRange(0, _FULL_PERCENT)
        self.slider.setPageStep(_STEP_PERCENT)
        self.slider.setTracking(False)
        self.field = named(f"{name}_field", QSpinBox())
        self.field.setRange(0, _FULL_PERCENT)
        self.field.setSuffix(" %")
        self.field.setKeyboardTracking(False)
        self.field.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.field.setMinimumWidth(_FIELD_PX)
        self.slider.valueChanged.connect(self._on_chosen)
        self.slider.sliderMoved.connect(self._on_dragged)
        self.slider.sliderReleased.connect(self._on_released)
        self.field.valueChanged.connect(self._on_chosen)

    def _on_dragged(self, percent: int) -> None:
        """Show in the field where the handle is; only a lower percentage counts yet."""
        with QSignalBlocker(self.field):
            self.field.setValue(percent)
        if percent < self._value():
            self._choose(percent)

    def _on_released(self) -> None:
        """Choose the place where the handle was let go, also where it was taken."""
        self._on_chosen(self.slider.sliderPosition())

    def _on_chosen(self, percent: int) -> None:
        if percent != self._value():
            self._choose(percent)
        self.show_value()

    def follow_value(self) -> None:
        """Show the percentage that holds, unless the operator has the handle in hand.

        A figure that is being typed stays until it is entered.
        """
        if self.slider.isSliderDown():
            return
        self._show_in_slider()
        typed = self.field.cleanText() != self.field.textFromValue(self.field.value())
        if not (typed and self.field.hasFocus()):
            self._show_in_field()

    def show_value(self) -> None:
        """Show the percentage that holds."""
        self._show_in_slider()
        self._show_in_field()

    def _show_in_slider(self) -> None:
        percent = self._value()
        self.slider.show_requested(percent, attention=self._warns and percent < _FULL_PERCENT)

    def _show_in_field(self) -> None:
        with QSignalBlocker(self.field):
            self.field.setValue(self._value())
