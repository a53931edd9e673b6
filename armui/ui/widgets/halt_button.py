"""Halt and hold 停住: ends any motion with power on; beside the emergency stop, and smaller."""

from __future__ import annotations

from typing import Final

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QWidget

from armui.control.arm_controller import ArmController
from armui.ui.theme import Colors
from armui.ui.widgets.press_button import Face, Inks, PressButton
from armui.ui.widgets.stop_shortcut import HALT_KEY_NAME
from armui.ui.widgets.translated import Translated

_LARGE: Final = Face(52, 0, 8.0, 9.0, 14.0, 8.0, 1.15, has_caption=True)
_SLIM: Final = Face(30, 0, 6.0, 7.0, 12.0, 8.0, 1.0, has_caption=False)
_SQUARE: Final = 1.5
"""The side of the stop square, by the sign's radius. Two bars would mean a pause that continues."""


class HaltButton(Translated, PressButton):
    """Ends the arm's motion when pressed down; the joints hold where they come to rest.

    Args:
        controller: The controller of the arm.
        slim: True for one line, as in the windows beside the main one.
    """

    def __init__(
        self, controller: ArmController, parent: QWidget | None = None, *, slim: bool = False
    ) -> None:
        super().__init__(_SLIM if slim else _LARGE, parent)
        self.setObjectName("halt_button")
        self._controller = controller
        self.retranslate_ui()

    def act(self) -> None:
        """End any motion; the motors keep their power."""
        self._controller.halt_and_hold()

    def retranslate_ui(self) -> None:
        """Set the text in the operator's language."""
        self.setText(self.tr("Halt"))
        self.setAccessibleName(self.text())
        self.setToolTip(
            self.tr(
                "Ends any motion; the motors keep their power and the arm holds where it comes to "
                "rest. Key: {key}"
            ).format(key=HALT_KEY_NAME)
        )
        self.updateGeometry()
        self.update()

    def _inks(self, colors: Colors, *, pressed: bool) -> Inks:
        ground = colors.stop_pale if pressed else colors.surface
        return Inks(ground, colors.stop_ink, colors.stop_ink, colors.muted)

    def _all_words(self) -> list[str]:
        return [self.text()]

    def _caption(self) -> str:
        return HALT_KEY_NAME

    def _draw_sign(self, painter: QPainter, center: QPointF, colors: Colors) -> None:
        side_px = _SQUARE * self._face.sign_px
        square = QRectF(0.0, 0.0, side_px, side_px)
        square.moveCenter(center)
        painter.fillRect(square, QColor(colors.stop_ink))
