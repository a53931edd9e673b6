"""A percentage that may be changed while the arm moves: a slider and a field."""

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
_TYPED_PERCENT: Final = 999


class _PercentBox(QSpinBox):
    """A field whose steps stay within 0–100 %; for a typed figure beyond, the reason is shown."""

    def __init__(self) -> None:
        super().__init__()
        # a wider range than is valid: else Qt would drop digits without an explanation
        self.setRange(-_TYPED_PERCENT, _TYPED_PERCENT)

    def stepBy(self, steps: int) -> None:  # noqa: N802 - the name Qt calls
        """Step within the range."""
        super().stepBy(min(max(steps, -self.value()), _FULL_PERCENT - self.value()))


class PercentInput(QObject):
    """Connects a slider and a field for 0–100 %.

    A lower percentage takes effect while the handle is dragged, a higher one when it is released;
    keys, clicks and the field take effect at once.

    Args:
        name: The slider is named ``<name>_slider``, the field ``<name>_field``.
        value: Returns the percentage in force.
        choose: Called with the operator's new choice.
        parent: The widget that lays both out.

    Attributes:
        slider: Shows the percentage in force, and optionally a measured one.
        field: The field for a figure.
    """

    def __init__(
        self, name: str, value: Callable[[], int], choose: Callable[[int], object], parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._value = value
        self._choose = choose
        self.slider = named(f"{name}_slider", TrackSlider(1.0, origin=0.0, jumps=False))
        self.slider.setRange(0, _FULL_PERCENT)
        self.slider.setPageStep(_STEP_PERCENT)
        self.slider.setTracking(False)
        self.field = named(f"{name}_field", _PercentBox())
        self.field.setSuffix(" %")
        self.field.setKeyboardTracking(False)
        self.field.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.field.setMinimumWidth(_FIELD_PX)
        self.slider.valueChanged.connect(self._on_chosen)
        self.slider.sliderMoved.connect(self._on_dragged)
        self.slider.sliderReleased.connect(self._on_released)
        self.field.valueChanged.connect(self._on_chosen)

    def _on_dragged(self, percent: int) -> None:
        """Show the handle's place in the field; only a lower percentage takes effect yet."""
        with QSignalBlocker(self.field):
            self.field.setValue(percent)
        if percent < self._value():
            self._choose(percent)

    def _on_released(self) -> None:
        """Take the percentage where the handle was released, even if it was not moved."""
        self._on_chosen(self.slider.sliderPosition())

    def _on_chosen(self, percent: int) -> None:
        if percent != self._value():
            self._choose(percent)
        self.show_value()

    def follow_value(self) -> None:
        """Show the percentage in force, unless the operator is dragging the handle.

        A figure that is being typed stays until it is entered.
        """
        if self.slider.isSliderDown():
            return
        self._show_in_slider()
        typed = self.field.cleanText() != self.field.textFromValue(self.field.value())
        if not (typed and self.field.hasFocus()):
            self._show_in_field()

    def show_value(self) -> None:
        """Show the percentage in force."""
        self._show_in_slider()
        self._show_in_field()

    def _show_in_slider(self) -> None:
        self.slider.show_requested(self._value())

    def _show_in_field(self) -> None:
        with QSignalBlocker(self.field):
            self.field.setValue(self._value())
