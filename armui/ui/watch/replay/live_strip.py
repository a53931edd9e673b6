"""In the replay window: the arm that is connected meanwhile, its next step, status and events."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QRectF, Qt
from PySide6.QtWidgets import QLabel, QWidget

from armui.control.events import Level
from armui.control.operating_state import LinkState
from armui.ui import words
from armui.ui.shell.status_bar import StatusBar
from armui.ui.theme import colors_of
from armui.ui.widgets import icons, painting
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from PySide6.QtGui import QPaintEvent

    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.control.safety.recovery_steps import Step

_ICON_PX: Final = 18


class LiveStrip(Translated, QWidget):
    """Shown while a device is open. It only tells; acting is for the main window.

    Args:
        controller: Of the arm that is connected, not of the log.
    """

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self.setObjectName("live_strip")
        self._controller = controller
        self._step = controller.recovery.step
        self._heading = text_label("live_heading", plain=True)
        self._icon = QLabel()
        self._text = text_label("live_step", wraps=True, plain=True)
        self.status = StatusBar(controller)
        row = in_row(spacing=10, margins=(14, 8, 14, 0))
        row.addWidget(self._heading, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self._icon, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self._text, 1)
        in_column(row, self.status, on=self, spacing=2, margins=3)
        controller.step_changed.connect(self._on_step)
        controller.operating_state_changed.connect(self._on_operating_state)
        self._on_operating_state(controller.operating_state)
        self.retranslate_ui()

    def _on_step(self, step: Step) -> None:
        self._step = step
        self._show_step()

    def _on_operating_state(self, operating_state: OperatingState) -> None:
        self.setVisible(operating_state.link is not LinkState.NO_DEVICE)

    def _show_step(self) -> None:
        colors = colors_of(self)
        self._text.setText(words.step(self._step))
        color = {Level.WARNING: colors.warn, Level.FAULT: colors.stop_ink}.get(self._step.level)
        self._icon.setVisible(color is not None)
        if color is not None:
            ratio = self.devicePixelRatioF()
            self._icon.setPixmap(icons.pixmap("warning", color, _ICON_PX, ratio))
        self.update()

    def retranslate_ui(self) -> None:
        """Put the words into the operator's language."""
        self._heading.setText(self.tr("The arm that is connected now:"))
        self._show_step()

    def _recolor(self) -> None:
        self._show_step()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """A ground in the colour of what is the matter."""
        colors = colors_of(self)
        ground = {Level.WARNING: colors.warn_pale, Level.FAULT: colors.stop_pale}
        line = {Level.WARNING: colors.warn, Level.FAULT: colors.stop_ink}
        painter = painting.begin(self)
        painting.panel(
            painter,
            QRectF(self.rect()),
            ground.get(self._step.level, colors.surface),
            line.get(self._step.level, colors.ok),
            2,
        )
        painter.end()
