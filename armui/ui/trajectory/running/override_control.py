"""倍率: the speed override, beside the progress of the run that it slows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from armui.control.run.speed_override import STEP_PERCENT
from armui.ui.actions.keys import key_text
from armui.ui.widgets.buttons import describe
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.percent_input import PercentInput
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QShowEvent

    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState

_SLIDER_PX: Final = 110


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
        override = controller.speed_override
        self._input = PercentInput(
            "override", lambda: override.percent, override.set_percent, self, warns=True
        )
        self._input.slider.setFixedWidth(_SLIDER_PX)
        self.field = self._input.field
        self.field.setSingleStep(STEP_PERCENT)
        self._label.setBuddy(self.field)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        in_row(self._label, self._input.slider, self.field, on=self, spacing=6, margins=0)
        controller.operating_state_changed.connect(self._on_operating_state)
        self.retranslate_ui()
        self._input.show_value()

    def _on_operating_state(self, _now: OperatingState) -> None:
        if self.isVisible():
            self._input.follow_value()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._label.setText(self.tr("Override"))
        tip = self.tr(
            "Share of the run's own speed, changed while it runs; 0 % pauses it. Slower {slower}, "
            "faster {faster}."
        ).format(slower=key_text("everywhere.slower"), faster=key_text("everywhere.faster"))
        for widget in (self._input.slider, self.field):
            describe(widget, self.tr("Speed override of the run"), tip)

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what was chosen while it was hidden."""
        super().showEvent(event)
        self._input.show_value()
