"""倍率: the speed override, beside the progress of the run that it slows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QLabel, QSizePolicy, QSpinBox, QWidget

from armui.control.run.speed_override import FULL_PERCENT, STEP_PERCENT
from armui.ui.actions.keys import key_text
from armui.ui.widgets.buttons import describe, named
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent

    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState

_SLIDER_PX: Final = 110
_FIELD_PX: Final = 70


class OverrideControl(Translated, QWidget):
    """Slider and field for 0–100 % of the speed that a run has by itself.

    A lower one counts while it is dragged, a higher one when the handle is let go.

    Args:
        controller: Owns the override.

    Attributes:
        field: Takes a figure.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._label = QLabel()
        self._slider = named("override_slider", TrackSlider(1.0, origin=0.0, jumps=False))
        self._slider.setRange(0, FULL_PERCENT)
        self._slider.setPageStep(STEP_PERCENT)
        self._slider.setTracking(False)
        self._slider.setFixedWidth(_SLIDER_PX)
        self.field = named("override_field", QSpinBox())
        self.field.setRange(0, FULL_PERCENT)
        self.field.setSingleStep(STEP_PERCENT)
        self.field.setSuffix(" %")
        self.field.setKeyboardTracking(False)
        self.field.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.field.setMinimumWidth(_FIELD_PX)
        self._label.setBuddy(self.field)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        in_row(self._label, self._slider, self.field, on=self, spacing=6, margins=0)
        self._slider.valueChanged.connect(self._on_chosen)
        self._slider.sliderMoved.connect(self._on_dragged)
        self._slider.sliderReleased.connect(self._on_released)
        self.field.valueChanged.connect(self._on_chosen)
        controller.operating_state_changed.connect(self._on_operating_state)
        self.retranslate_ui()
        self._show()

    def _on_dragged(self, percent: int) -> None:
        with QSignalBlocker(self.field):
            self.field.setValue(percent)
        if percent < self._controller.speed_override.percent:
            self._controller.speed_override.set_percent(percent)

    def _on_released(self) -> None:
        """The place where the handle was let go counts, also where it was taken."""
        self._on_chosen(self._slider.sliderPosition())

    def _on_chosen(self, percent: int) -> None:
        if percent != self._controller.speed_override.percent:
            self._controller.speed_override.set_percent(percent)
        self._show()

    def _on_operating_state(self, _now: OperatingState) -> None:
        if self.isVisible() and not self._slider.isSliderDown():
            self._show()

    def _show(self) -> None:
        percent = self._controller.speed_override.percent
        self._slider.show_requested(percent, attention=percent < FULL_PERCENT)
        with QSignalBlocker(self.field):
            self.field.setValue(percent)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._label.setText(self.tr("Override"))
        tip = self.tr(
            "Share of the run's own speed, changed while it runs; 0 % pauses it. Slower {slower}, "
            "faster {faster}."
        ).format(slower=key_text("everywhere.slower"), faster=key_text("everywhere.faster"))
        for widget in (self._slider, self.field):
            describe(widget, self.tr("Speed override of the run"), tip)

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what was chosen while it was hidden."""
        super().showEvent(event)
        self._show()
