"""The emergency stop: in the top bar and in every window, never disabled, never asked about."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen
from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.control.operating_state import OperatingState, StopState
from armui.ui import words
from armui.ui.theme import Colors
from armui.ui.widgets import painting
from armui.ui.widgets.press_button import Face, Inks, PressButton
from armui.ui.widgets.stop_shortcut import STOP_KEY_NAME
from armui.ui.widgets.translated import Translated

_LARGE: Final = Face(52, 200, 13.0, 12.0, 22.0, 10.0, 1.35, has_caption=True)
_SLIM: Final = Face(30, 0, 8.0, 8.0, 12.0, 8.0, 1.0, has_caption=False)


class StopButton(Translated, PressButton):
    """Stops the arm when pressed down, at every press: also an arm that has stopped, once more.

    It never releases the arm, which is the held button in the line of the next step.

    Args:
        controller: The controller of the arm.
        slim: True for one line, as in the windows beside the main one.
    """

    def __init__(
        self, controller: ArmController, parent: QWidget | None = None, *, slim: bool = False
    ) -> None:
        super().__init__(_SLIM if slim else _LARGE, parent)
        self.setObjectName("stop_button")
        self._controller = controller
        self._operating_state = controller.operating_state
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self.retranslate_ui()

    # -- behaviour ----------------------------------------------------------------------------

    def act(self) -> None:
        """Send the emergency stop."""
        self._controller.emergency_stop()

    # -- appearance ---------------------------------------------------------------------------

    def _on_operating_state_changed(self, operating_state: OperatingState) -> None:
        old, self._operating_state = self._operating_state, operating_state
        if _shown(old) != _shown(operating_state):
            self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set the present text in the operator's language."""
        self.setText(self._words())
        self.setAccessibleName(self.text())
        if self._operating_state.stop is StopState.STOPPED:
            tip = self.tr(
                "The arm has taken the emergency stop; a press sends it again. Release stands in "
                "the line of the next step above the panel: hold the arm before."
            )
        else:
            tip = self.tr(
                "Ends at once whatever drives the arm, and takes the power from its joints: they "
                "are only damped, and the arm sinks. Hold it. Key: {key}"
            ).format(key=STOP_KEY_NAME)
        self.setToolTip(tip)
        self.updateGeometry()
        self.update()

    def _words(self) -> str:
        if self._operating_state.stop is StopState.REQUESTED:
            if self._operating_state.stop_lapsed:
                return self.tr("Stop outstanding")
            if self._operating_state.stop_unconfirmed:
                return self.tr("Stop unconfirmed")
            return self.tr("Stopping…")
        return self.tr("Emergency stop")

    def _caption(self) -> str:
        stop = self._operating_state.stop
        if stop is StopState.STOPPED:
            motion = self._operating_state.uncommanded
            if motion is not None:
                return words.uncommanded_motion_short(motion) or STOP_KEY_NAME
            return self.tr("The arm is at rest")
        if self._operating_state.stop_lapsed:
            return self.tr("Press to send it")
        return {
            StopState.REQUESTED: self.tr("Waiting for the arm"),
            StopState.RESUMING: self.tr("Hold the arm"),
        }.get(stop, STOP_KEY_NAME)

    def _all_words(self) -> list[str]:
        return [
            self.tr("Emergency stop"),
            self.tr("Stopping…"),
            self.tr("Stop unconfirmed"),
            self.tr("Stop outstanding"),
        ]

    def _inks(self, colors: Colors, *, pressed: bool) -> Inks:
        fill = colors.stop_strong if pressed else colors.stop
        return Inks(fill, fill, colors.on_stop, colors.on_stop)

    def _draw_sign(self, painter: QPainter, center: QPointF, colors: Colors) -> None:
        """Draw an octagon, with an exclamation mark until the arm confirms the stop."""
        unit = self._face.sign_px / 2
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colors.on_stop))
        painter.drawPolygon(painting.octagon(center, self._face.sign_px))
        painter.setPen(QPen(QColor(colors.stop), 0.52 * unit, c=Qt.PenCapStyle.RoundCap))
        if self._operating_state.stop is StopState.REQUESTED:
            painter.drawLine(center + QPointF(0, -unit), center + QPointF(0, 0.08 * unit))
            painter.drawPoint(center + QPointF(0, unit))
        else:
            painter.drawLine(center + QPointF(-0.92 * unit, 0), center + QPointF(0.92 * unit, 0))


def _shown(operating_state: OperatingState) -> tuple[object, ...]:
    """Return the values that its words depend on."""
    now = operating_state
    return (now.stop, now.stop_unconfirmed, now.stop_lapsed, now.uncommanded)
