"""The speed percentage: what is wanted, and beside it what the arm says it has."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QLabel, QSpinBox, QWidget

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.arm.state import ArmState
from armui.control.operating_state import OperatingState
from armui.protocol.generation import Generation
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.freshness import is_stale
from armui.ui.widgets.buttons import named
from armui.ui.widgets.curve_menu import tell_quantities
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.widgets.translated import Translated
from armui.ui.widgets.value_label import ValueLabel

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


_WIDEST_PX: Final = 620


class SpeedControl(Translated, QWidget):
    """Slider and field for 0–100 % of the arm's highest speed (manual 1.0.3, 0x151 byte 2).

    Dragging sends when the handle is let go; keys, clicks and the field send at once.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self.setMaximumWidth(_WIDEST_PX)
        self._label = QLabel()
        self._slider = named("speed_slider", TrackSlider(1.0, origin=0.0, jumps=False))
        self._slider.setRange(0, 100)
        self._slider.setPageStep(10)
        self._slider.setTracking(False)
        self._field = named("speed_field", QSpinBox())
        self._field.setRange(0, 100)
        self._field.setSuffix(" %")
        self._field.setKeyboardTracking(False)
        self._field.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._field.setMinimumWidth(70)
        self._field.setFixedHeight(34)
        self._label.setBuddy(self._field)
        self._arm_label = QLabel()
        self._arm_label.setProperty("rank", "muted")
        self._arm_value = named("arm_speed", ValueLabel(fmt.percent(100)))
        tell_quantities(self, "arm.speed_percent", "own.speed_percent", "other.speed_percent")
        wanted = (self._label, (self._slider, 1), self._field)
        in_row(*wanted, self._arm_label, self._arm_value, on=self, spacing=8, margins=0)
        self._slider.valueChanged.connect(self._on_chosen)
        self._slider.sliderMoved.connect(self._on_dragged)
        self._field.valueChanged.connect(self._on_chosen)
        controller.state_changed.connect(self._on_state_changed)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self.retranslate_ui()
        self._show_setpoint()

    def _on_dragged(self, percent: int) -> None:
        """While the handle is held the field only says where it is."""
        with QSignalBlocker(self._field):
            self._field.setValue(percent)

    def _on_chosen(self, percent: int) -> None:
        if percent != self._controller.operating_state.speed_percent:
            self._controller.motion.set_speed_percent(percent)
        self._show_setpoint()

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        if not self._slider.isSliderDown():
            self._show_setpoint()
        self._allow(operating_state)
        self._show_what_is_told(operating_state.generation)
        self._on_state_changed(self._controller.state)

    def _allow(self, operating_state: OperatingState) -> None:
        """A run sends each point with its own speed: another one would change it in silence."""
        reason = (
            words.refusal(Refusal(RefusalCode.RUN_UNDER_WAY)) if operating_state.running else ""
        )
        use = self.tr("Speed of motions, 0–100 % of the arm's highest; 0 % means no motion.")
        for widget in (self._slider, self._field):
            widget.setEnabled(not reason)
            widget.setToolTip(reason or use)

    def _show_setpoint(self) -> None:
        percent = self._controller.operating_state.speed_percent
        self._slider.show_requested(percent)
        with QSignalBlocker(self._field):
            self._field.setValue(percent)

    def _on_state_changed(self, state: ArmState) -> None:
        if not self.isVisible():
            return
        percent = None if state.status is None else state.status.value.speed_percent
        stale = is_stale(state.status, state, self._controller.operating_state)
        self._arm_value.show_text(fmt.percent(percent), stale=stale)
        self._slider.show_measured(None if stale else percent)

    def _show_what_is_told(self, generation: Generation | None) -> None:
        """Only firmware of generation 1 reports a speed percentage; else nothing is shown."""
        for widget in (self._arm_label, self._arm_value):
            widget.setVisible(generation is Generation.ONE)
            widget.setToolTip(self.tr("The speed percentage the arm reports"))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._label.setText(self.tr("Speed"))
        self._arm_label.setText(self.tr("Arm"))
        for widget in (self._slider, self._field):
            widget.setAccessibleName(self.tr("Speed percentage"))
        self._allow(self._controller.operating_state)
        self._arm_value.setAccessibleName(self.tr("Speed percentage reported by the arm"))
        self._show_what_is_told(self._controller.operating_state.generation)
