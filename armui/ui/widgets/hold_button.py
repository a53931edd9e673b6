"""A button that must be held for a while: a slip or a double click does nothing."""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, QPoint, QRect, QRectF, QTimer, QVariantAnimation, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainterPath, QPaintEvent
from PySide6.QtWidgets import QPushButton, QToolTip

from armui.control.operations.started import ARM_CHANGED
from armui.ui.theme import colors_of
from armui.ui.widgets import painting
from armui.ui.widgets.hold_guard import can_be_let_go
from armui.ui.widgets.tips import uncover
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.link.arm_mark import ArmMark

_HELD_UP_S: Final = 0.25
"""After a longer pause of the event loop, pending releases are handled before it acts."""
HOLD_MS: Final = 1000
"""The time of holding: long enough to be intended, short enough to wait for."""

_HINT_MS: Final = 4000
_TRACK_PX: Final = 3.0
_FOCUS_PX: Final = 2.0
"""The border of the style sheet around what has the focus."""


class HoldButton(Translated, QPushButton):
    """A button that acts when held by mouse or space bar for a second; its lower edge fills up.

    Releasing it, leaving it, or its loss of the focus, disabling and hiding all cancel the hold. A
    mere click only shows a line at the button that it must be held; its tooltip says so, too. It
    never acts on another arm than the one connected at the press.

    Args:
        controller: Gives the connected arm.
        text: The text.

    Attributes:
        progress: The animation that runs while the button is held, from 0 to 1.
    """

    held = Signal()
    """Emitted when it was held to the end."""

    def __init__(self, controller: ArmController, text: str = "") -> None:
        super().__init__(text)
        self._controller = controller
        self._pressed_for: ArmMark | None = None
        self.setAutoDefault(False)
        self._use = ""
        self._was_held = self._was_held_up = False
        self._ticked_s = 0.0
        self.progress = QVariantAnimation(self)
        self.progress.setStartValue(0.0)
        self.progress.setEndValue(1.0)
        self.progress.setDuration(HOLD_MS)
        self.progress.valueChanged.connect(self._on_tick)
        self.progress.finished.connect(self._on_finished)
        self.pressed.connect(self._on_pressed)
        self.released.connect(self._begin_anew)
        self.clicked.connect(self._on_clicked)
        self.retranslate_ui()

    @property
    def share(self) -> float:
        """The part of the time that has passed, 0–1."""
        return self.progress.currentTime() / HOLD_MS

    def setToolTip(self, use: str) -> None:  # noqa: N802 - the name Qt calls
        """Set the purpose with a hint to hold the button, or only the reason if disabled."""
        self._use = use
        hint = self._hint() if self.isEnabled() else ""
        super().setToolTip("\n".join(filter(None, (use, hint))))

    def changeEvent(self, event: QEvent) -> None:
        """Update the tooltip when the button is enabled or disabled."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.EnabledChange:
            self.setToolTip(self._use)

    def retranslate_ui(self) -> None:
        """Set the hint to hold the button in the operator's language."""
        self.setToolTip(self._use)
        self.setAccessibleDescription(self._hint())

    def _hint(self) -> str:
        return self.tr("Hold it for {seconds} s, with the mouse or the space bar.").format(
            seconds=f"{HOLD_MS / 1000:g}"
        )

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin the hold, unless Qt would not report its release."""
        if can_be_let_go(event):
            super().mousePressEvent(event)
        else:
            event.ignore()

    def _on_pressed(self) -> None:
        self._pressed_for = self._controller.mark
        self._was_held = False
        self._ticked_s = monotonic()
        self.progress.start()

    def _on_tick(self) -> None:
        last_s, self._ticked_s = self._ticked_s, monotonic()
        self._was_held_up = self._ticked_s - last_s > _HELD_UP_S
        self.update()

    def _on_finished(self) -> None:
        if self._was_held_up:  # first handle a release that waits in the event queue
            QTimer.singleShot(0, self, self._act)
        else:
            self._act()

    def _act(self) -> None:
        if self.progress.state() is QVariantAnimation.State.Running:
            return  # it was released and pressed again
        self._was_held = True
        # the button may have been released, disabled or hidden in the last moment
        if self.isDown() and self.isEnabled() and self.isVisible():
            # the press was meant for the arm as it was then: it must not act on another one
            if self._pressed_for is not None and self._pressed_for.is_still(self._controller.mark):
                self.held.emit()
            else:
                self._controller.report_withdrawn(self.text(), ARM_CHANGED())
        self._begin_anew()

    def _on_clicked(self) -> None:
        """Show the hint after a short press; above the button, as its question may be below."""
        if not self._was_held:
            above = self.mapToGlobal(QPoint(0, -2 * self.height()))
            QToolTip.showText(above, self._hint(), self, QRect(), _HINT_MS)
            uncover()

    def _begin_anew(self) -> None:
        self.progress.stop()
        self.progress.setCurrentTime(0)
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw a track along the lower edge, within its corners, and how far it is filled."""
        super().paintEvent(event)
        colors, inset = colors_of(self), _FOCUS_PX if self.hasFocus() else 0.0
        ground = QRectF(self.rect()).adjusted(inset, inset, -inset, -inset)
        shape = QPainterPath()
        shape.addRoundedRect(ground, painting.CORNER_PX - inset, painting.CORNER_PX - inset)
        track = ground.adjusted(0.0, ground.height() - _TRACK_PX, 0.0, 0.0)
        filled = QRectF(track)
        filled.setWidth(self.share * track.width())
        painter = painting.begin(self)
        painter.setClipPath(shape)
        painter.fillRect(track, QColor(colors.border))
        painter.fillRect(filled, QColor(colors.warn))
        painter.end()
