"""A button that must be held for a while: a slip or a double click does nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QPoint, QRect, QRectF, QSize, QVariantAnimation, Signal
from PySide6.QtGui import QColor, QPaintEvent, QPen
from PySide6.QtWidgets import QPushButton, QToolTip

from armui.control.operations.started import ARM_CHANGED
from armui.ui.theme import colors_of
from armui.ui.widgets import painting
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.link.arm_mark import ArmMark

HOLD_MS: Final = 1000
"""Long enough to be meant, short enough to be waited for."""

_HINT_MS: Final = 4000
_RING_PX: Final = 16.0
_GAP_PX: Final = 8
_FULL_TURN: Final = 360 * 16
_TOP: Final = 90 * 16


class HoldButton(Translated, QPushButton):
    """Held with the mouse or the space bar for a second, it acts; a ring shows how far it is.

    Letting go, leaving the button, losing the focus, being disabled and being hidden all begin
    anew. A click alone does nothing but say, in one line at the button, that it wants to be held;
    its tooltip says so, too. Nor does it act on another arm than the one that was there when it
    went down.

    Args:
        controller: Knows the arm.
        text: What stands on it.

    Attributes:
        progress: Runs while the button is held, from 0 to 1.
    """

    held = Signal()
    """It was held to the end."""

    def __init__(self, controller: ArmController, text: str = "") -> None:
        super().__init__(text)
        self._controller = controller
        self._pressed_for: ArmMark | None = None
        self.setAutoDefault(False)
        self._use = ""
        self._was_held = False
        self.progress = QVariantAnimation(self)
        self.progress.setStartValue(0.0)
        self.progress.setEndValue(1.0)
        self.progress.setDuration(HOLD_MS)
        self.progress.valueChanged.connect(self.update)
        self.progress.finished.connect(self._on_finished)
        self.pressed.connect(self._on_pressed)
        self.released.connect(self._begin_anew)
        self.clicked.connect(self._on_clicked)
        self.retranslate_ui()

    @property
    def share(self) -> float:
        """How much of the time it has been held, 0–1."""
        return self.progress.currentTime() / HOLD_MS

    def setToolTip(self, use: str) -> None:  # noqa: N802 - the name Qt calls
        """Say what it is for, and that it wants to be held; or only why it cannot be."""
        self._use = use
        hint = self._hint() if self.isEnabled() else ""
        super().setToolTip("\n".join(filter(None, (use, hint))))

    def changeEvent(self, event: QEvent) -> None:
        """Follow being enabled, too."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.EnabledChange:
            self.setToolTip(self._use)

    def retranslate_ui(self) -> None:
        """Say in the operator's language that it wants to be held."""
        self.setToolTip(self._use)
        self.setAccessibleDescription(self._hint())

    def _hint(self) -> str:
        return self.tr("Hold it for {seconds} s, with the mouse or the space bar.").format(
            seconds=f"{HOLD_MS / 1000:g}"
        )

    def _on_pressed(self) -> None:
        self._pressed_for = self._controller.mark
        self._was_held = False
        self.progress.start()

    def _on_finished(self) -> None:
        self._was_held = True
        if self.isDown() and self.isEnabled() and self.isVisible():
            if self._pressed_for is not None and self._pressed_for.is_still(self._controller.mark):
                self.held.emit()
            else:
                self._controller.tell_withdrawn(self.text(), ARM_CHANGED())
        self._begin_anew()

    def _on_clicked(self) -> None:
        """Nothing was done: say why, over the button, where its question may stand below."""
        if not self._was_held:
            above = self.mapToGlobal(QPoint(0, -2 * self.height()))
            QToolTip.showText(above, self._hint(), self, QRect(), _HINT_MS)

    def _begin_anew(self) -> None:
        self.progress.stop()
        self.progress.setCurrentTime(0)
        self.update()

    def sizeHint(self) -> QSize:
        """Room for the ring beside the text."""
        size = super().sizeHint()
        return QSize(size.width() + int(_RING_PX) + 2 * _GAP_PX, size.height())

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the ring, and in it how far it is."""
        super().paintEvent(event)
        colors = colors_of(self)
        box = QRectF(_GAP_PX + 2, (self.height() - _RING_PX) / 2, _RING_PX, _RING_PX)
        painter = painting.begin(self)
        painter.setPen(QPen(QColor(colors.faint), 2.4))
        painter.drawEllipse(box)
        if self.share > 0:
            painter.setPen(QPen(QColor(colors.warn), 3.0))
            painter.drawArc(box, _TOP, -round(self.share * _FULL_TURN))
        painter.end()
