"""Regions 1, 3, 4 and 5: communication, speed, enable, halt and emergency stop."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from armui.control.devices.motors import why_not_disable, why_not_enable
from armui.control.operating_state import OperatingState
from armui.ui import words
from armui.ui.dialogs.confirm import confirm
from armui.ui.shell.communication_button import CommunicationButton
from armui.ui.shell.enable_button import EnableButton
from armui.ui.shell.speed_control import SpeedControl
from armui.ui.widgets.halt_button import HaltButton
from armui.ui.widgets.layouts import fill, in_row
from armui.ui.widgets.stop_button import StopButton
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class TopBar(Translated, QWidget):
    """What must be seen and reached whatever panel is open.

    Args:
        controller: Whom to tell.
        open_connection: Opens the window in which a CAN device is chosen.
    """

    def __init__(
        self,
        controller: ArmController,
        open_connection: Callable[[], None],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("top_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._controller = controller
        self._communication = CommunicationButton()
        self._enable = EnableButton()
        left = (self._communication, (SpeedControl(controller), 1))
        layout = in_row(*left, on=self, spacing=12, margins=(8, 6, 8, 6))
        layout.addStretch(0)
        stop = StopButton(controller, ask_to_resume=self.ask_to_resume)
        fill(layout, self._enable, HaltButton(controller), stop)
        self._communication.clicked.connect(open_connection)
        self._enable.clicked.connect(self._on_enable)
        controller.operating_state_changed.connect(self._show_operating_state)
        self._show_operating_state(controller.operating_state)

    def _show_operating_state(self, operating_state: OperatingState) -> None:
        self._communication.show_operating_state(operating_state)
        self._enable.show_operating_state(operating_state)
        self._describe_enable(operating_state)

    def _describe_enable(self, operating_state: OperatingState) -> None:
        off = self._enable.turns_off
        blocked = (why_not_disable if off else why_not_enable)(operating_state)
        self._enable.setEnabled(blocked is None)
        if blocked is not None:
            tip = words.refusal(blocked)
        elif off:
            tip = self.tr("Disables all six motors: the arm will drop, so hold it first.")
        else:
            tip = self.tr("Enables all six motors.")
        self._enable.setToolTip(tip)

    def ask_to_resume(self) -> None:
        """Ask whether to end the emergency stop: the arm drops."""
        confirm(
            self.window(),
            self._controller,
            title=self.tr("Resume after the emergency stop"),
            text=self.tr(
                "Resuming cuts the power of the motors: the arm will drop. Hold the arm.\n"
                "Afterwards the motors must be enabled again."
            ),
            action_label=self.tr("Resume"),
            on_confirmed=self._controller.motors.resume,
            hold=True,
        )

    def _on_enable(self) -> None:
        if not self._enable.turns_off:
            self._controller.motors.enable()
            return
        confirm(
            self.window(),
            self._controller,
            title=self.tr("Disable the motors"),
            text=self.tr("The arm will drop when its motors are disabled. Hold the arm."),
            action_label=self.tr("Disable"),
            on_confirmed=self._controller.motors.disable,
            hold=True,
        )

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._describe_enable(self._controller.operating_state)
