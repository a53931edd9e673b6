"""Which axis of a device moves which of the arm, and how far it is pushed now."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QWidget

from armui.gamepad.device_state import DeviceKind, DeviceState
from armui.gamepad.layout import DEAD_ZONES, SOURCES, SPEED_AXIS, JogMode, deflections, speed_share
from armui.ui.gamepad.axis_bar import AxisBar
from armui.ui.widgets.layouts import empty_grid
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.widgets.value_label import ValueLabel
from armui.ui.words.gamepad import gamepad_axis, gamepad_source, moved_axis

_AXES: Final = range(6)


class AxisRows(Translated, QWidget):
    """A row an axis of the arm, and one for the trigger.

    Args:
        kind: Of the device.
    """

    def __init__(self, kind: DeviceKind) -> None:
        super().__init__()
        self._kind = kind
        self._mode = JogMode.JOINT
        self._sources = [text_label() for _ in _AXES]
        self._bars = [AxisBar(DEAD_ZONES[kind]) for _ in _AXES]
        self._targets = [QLabel() for _ in _AXES]
        grid = empty_grid(self, gaps=(12, 6), margins=0)
        grid.setColumnStretch(1, 1)
        for row, cells in enumerate(zip(self._sources, self._bars, self._targets, strict=True)):
            for column, cell in enumerate(cells):
                grid.addWidget(cell, row, column)
        self._trigger_label = text_label()
        self._trigger = AxisBar(0.0, from_left=True)
        self._share = ValueLabel("100 %", alignment=Qt.AlignmentFlag.AlignLeft)
        if kind is DeviceKind.GAMEPAD:
            row = grid.rowCount()
            for column, cell in enumerate((self._trigger_label, self._trigger, self._share)):
                grid.addWidget(cell, row, column)
        grid.setRowStretch(grid.rowCount(), 1)
        self.retranslate_ui()

    def show_mode(self, mode: JogMode) -> None:
        """What the axes move."""
        if mode is not self._mode:
            self._mode = mode
            self.retranslate_ui()

    def show_state(self, state: DeviceState | None) -> None:
        """Show how far each axis is pushed; None: nothing is known."""
        pushed = (0.0,) * 6 if state is None else deflections(state, self._mode)
        for bar, value in zip(self._bars, pushed, strict=True):
            bar.show_value(value)
        if self._kind is DeviceKind.GAMEPAD:
            self._trigger.show_value(0.0 if state is None else state.axes.get(SPEED_AXIS, 0.0))
            self._share.show_text("—" if state is None else f"{100 * speed_share(state):.0f} %")

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        sources = SOURCES[self._kind][self._mode]
        for place, source in enumerate(sources):
            self._sources[place].setText(gamepad_source(source))
            self._targets[place].setText(moved_axis(self._mode, place))
            self._bars[place].setAccessibleName(gamepad_source(source))
        self._trigger_label.setText(gamepad_axis(SPEED_AXIS))
        self._trigger.setAccessibleName(gamepad_axis(SPEED_AXIS))
        self._share.setToolTip(self.tr("Of the speed at the top; without the trigger a fifth"))
