"""One motor of the motor panel: its driver's values, and its commands."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QLabel, QLayout, QWidget

from armui.arm.state import DriverFast, DriverSlow, Reading
from armui.ui import format as fmt
from armui.ui.theme import colors_of, scaled_font
from armui.ui.widgets import painting, state_mark
from armui.ui.widgets.buttons import describe
from armui.ui.widgets.curve_menu import set_quantities
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.state_mark import Mark
from armui.ui.widgets.text_label import ValueLabel
from armui.ui.widgets.translated import Translated

_MARK_PX: Final = 7.0
_WIDEST_TEMPERATURE: Final = "−000 °C"
_WIDEST_CURRENT: Final = "−00.00 A"
_WIDEST_WORD: Final = "Disabled"
_WIDEST_VOLTAGE: Final = "00.0 V"
FIGURE_PX: Final = 62
"""The width of a column of figures."""
COLUMN_GAP_PX: Final = 5


class PowerMark(QWidget):
    """Shows by shape and colour whether a motor is enabled."""

    def __init__(self) -> None:
        super().__init__()
        self._mark, self._muted = Mark.UNKNOWN, False
        self.setFixedSize(QSize(20, 20))

    def show_mark(self, mark: Mark, *, muted: bool) -> None:
        """Show another mark."""
        if (mark, muted) != (self._mark, self._muted):
            self._mark, self._muted = mark, muted
            self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the mark."""
        painter = painting.begin(self)
        center = QPointF(self.rect().center()) + QPointF(0.5, 0.5)
        state_mark.draw(painter, colors_of(self), center, _MARK_PX, self._mark, muted=self._muted)
        painter.end()


class MotorRow(Translated, QWidget):
    """The driver's figures above the four buttons.

    Args:
        joint: Its number, 1–6.
        acts: The row of its buttons.
    """

    def __init__(self, joint: int, acts: QLayout) -> None:
        super().__init__()
        self.joint = joint
        self._mark = PowerMark()
        name = QLabel(f"J{joint}")
        name.setFont(scaled_font(name, 1.1, bold=True))
        self.power = ValueLabel(_WIDEST_WORD, alignment=Qt.AlignmentFlag.AlignLeft)
        self.figures = {
            "motor_temperature": ValueLabel(_WIDEST_TEMPERATURE),
            "driver_temperature": ValueLabel(_WIDEST_TEMPERATURE),
            "current": ValueLabel(_WIDEST_CURRENT),
            "voltage": ValueLabel(_WIDEST_VOLTAGE),
        }
        self.power.setObjectName(f"motor_power_{joint}")
        for key, label in self.figures.items():
            label.setObjectName(f"{key}_{joint}")
            kind = "motor_current" if key == "current" else key
            set_quantities(label, f"arm.{kind}.{joint}")
            label.setFixedWidth(FIGURE_PX)
        figures = in_row(
            self._mark, name, self.power, STRETCH, *self.figures.values(), spacing=COLUMN_GAP_PX
        )
        in_column(figures, acts, on=self, spacing=4, margins=0)
        self.retranslate_ui()

    def show_slow(self, heard: Reading[DriverSlow] | None, *, stale: bool) -> None:
        """Show the values of 0x261–0x266."""
        driver = None if heard is None else heard.value
        self._show_power(None if driver is None else driver.enabled, stale=stale)
        texts = {
            "motor_temperature": driver and f"{fmt.number(driver.motor_temperature_c, 0)} °C",
            "driver_temperature": driver and f"{fmt.number(driver.driver_temperature_c, 0)} °C",
            "voltage": driver and f"{fmt.number(driver.voltage_v, 1)} V",
        }
        for key, text in texts.items():
            self.figures[key].show_text(text or fmt.NOTHING, stale=stale)
        for key, hot in (
            ("motor_temperature", driver is not None and driver.motor_overtemperature),
            ("driver_temperature", driver is not None and driver.driver_overtemperature),
            ("voltage", driver is not None and driver.undervoltage),
        ):
            self.figures[key].show_attention(wanted=hot and not stale)

    def show_fast(self, heard: Reading[DriverFast] | None, *, stale: bool) -> None:
        """Show the values of 0x251–0x256."""
        text = fmt.NOTHING if heard is None else f"{fmt.number(heard.value.current_a, 2)} A"
        self.figures["current"].show_text(text, stale=stale)

    def _show_power(self, enabled: bool | None, *, stale: bool) -> None:
        mark = Mark.UNKNOWN if enabled is None else Mark.GOOD if enabled else Mark.OFF
        self._mark.show_mark(mark, muted=stale)
        word = {None: fmt.NOTHING, True: self.tr("Enabled"), False: self.tr("Disabled")}[enabled]
        self.power.show_text(word, stale=stale)

    def retranslate_ui(self) -> None:
        """Set the names in the operator's language; the words follow with the next values."""
        for key, name in (
            ("motor_temperature", self.tr("Motor temperature of joint {joint}")),
            ("driver_temperature", self.tr("Driver temperature of joint {joint}")),
            ("current", self.tr("Motor current of joint {joint}")),
            ("voltage", self.tr("Supply voltage of joint {joint}")),
        ):
            describe(self.figures[key], name.format(joint=self.joint))
        self.power.setAccessibleName(self.tr("State of motor {joint}").format(joint=self.joint))
