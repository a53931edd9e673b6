"""Sends a frame by hand: a button must be held to unlock it, and again for frames that act."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QLineEdit, QWidget

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.control.safety.hand_frame import FrameEffect, effect_of, parse_frame
from armui.protocol.frame import Frame
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.watch.bus.cells import byte_font
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import in_column, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.frames import frame_effect
from armui.ui.words.text import joined

if TYPE_CHECKING:
    from PySide6.QtGui import QHideEvent

    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.ui.watch.bus.frame_model import FrameTexts

UNLOCKED_MS: Final = 60_000
"""The time after the last frame at which it locks automatically."""
_ID_PX: Final = 90
_DATA_PX: Final = 260
_GRAVE: Final = frozenset(
    {FrameEffect.DROPS, FrameEffect.LIMP, FrameEffect.SINKS, FrameEffect.UNKNOWN}
)


class SendBox(HasActs, Translated, QWidget):
    """A frame, its meaning, and the button that sends it; seen only while it is unlocked.

    It locks when it is hidden, at disconnecting, and after a minute. Its page gives the button that
    unlocks it a place.

    Args:
        controller: Sends the frame.
        texts: Formats the typed frame.
    """

    unlock = Act("Send by hand", named="bus_unlock", key="bus.unlock", held=True, risky=True)
    send = Act("Send", named="bus_send", key="bus.send", leads=True)
    hold = Act("Hold to send", named="bus_hold_to_send", held=True)
    lock = Act(
        "Lock",
        named="bus_lock",
        tip="Send nothing more; it also locks by itself after a minute",
        key="bus.lock",
    )

    def __init__(self, controller: ArmController, texts: FrameTexts) -> None:
        super().__init__()
        self._controller = controller
        self._texts = texts
        self._pressed: Frame | None = None
        self._sent = ""
        self.identifier = named("bus_send_id", QLineEdit(maxLength=10))
        self.identifier.setFixedWidth(_ID_PX)
        self.data = named("bus_send_data", QLineEdit(maxLength=60))
        self.data.setMinimumWidth(_DATA_PX)
        for field in (self.identifier, self.data):
            field.setFont(byte_font(field))
            field.textChanged.connect(self._on_typed)
        self.decoded = text_label("bus_send_decoded", wraps=True, plain=True)
        self.message = named("bus_send_message", MessageLine())
        self._timer = QTimer(self, singleShot=True, interval=UNLOCKED_MS)
        self._timer.timeout.connect(self.close_lock)
        self._lay_out()
        for button in (self.send, self.hold):
            button.pressed.connect(self._on_pressed)
        controller.operating_state_changed.connect(self._on_operating_state)
        self.retranslate_ui()
        self.close_lock()

    def _lay_out(self) -> None:
        row = in_row(self.identifier, (self.data, 1), self.send, self.hold, self.lock, spacing=8)
        in_column(row, self.decoded, self.message, on=self, spacing=6, margins=0)

    # The lock ---------------------------------------------------------------------------------

    @property
    def is_open(self) -> bool:
        """True if a frame can be sent."""
        return self._timer.isActive()

    @lock.pressed
    def close_lock(self) -> None:
        """Lock and hide the box, until it is unlocked again by a long press."""
        self._timer.stop()
        self._sent = ""
        self._show()

    @unlock.pressed
    def _on_unlocked(self) -> None:
        if self._controller.bus.why_not_send() is None:
            self._timer.start()
            self._show()
            self.identifier.setFocus()

    def _on_operating_state(self, _operating_state: OperatingState) -> None:
        if not self.unlock.isVisible():
            return
        if self.is_open and self._controller.operating_state.device is None:
            self.close_lock()
        self._show()

    def hideEvent(self, event: QHideEvent) -> None:
        """Lock the box, because it is hidden."""
        self.close_lock()
        super().hideEvent(event)

    # The frame --------------------------------------------------------------------------------

    def take(self, arbitration_id: int, data: bytes) -> None:
        """Set the fields to a frame."""
        self.identifier.setText(f"{arbitration_id:03X}")
        self.data.setText(data.hex(" ").upper())

    def _on_typed(self) -> None:
        self._sent = ""
        self._show()

    def _typed(self) -> Frame | Refusal:
        return parse_frame(self.identifier.text(), self.data.text())

    def _on_pressed(self) -> None:
        """Note the frame in the fields at the press: no other one, typed meanwhile, is sent."""
        frame = self._typed()
        self._pressed = frame if isinstance(frame, Frame) else None

    @send.pressed
    def _on_send(self) -> None:
        self._send(held=False)

    @hold.pressed
    def _on_held(self) -> None:
        self._send(held=True)

    def _send(self, *, held: bool) -> None:
        frame, self._pressed = self._pressed, None
        if frame is None or frame != self._typed() or not self.is_open:
            return
        refusal = self._controller.bus.send(frame, held=held)
        if refusal is None:
            self._timer.start()
            self._sent = str(frame)
        self._show()

    def refresh(self) -> None:
        """Check again whether the typed frame can be sent, and show the reason if not."""
        if self.is_open:
            self._show()

    # What is shown ----------------------------------------------------------------------------

    def _show(self) -> None:
        is_open = self.is_open
        self.setVisible(is_open)
        self.show_acts()
        frame = self._typed()
        harmless = isinstance(frame, Frame) and effect_of(frame) is FrameEffect.HARMLESS
        self.send.setVisible(harmless)
        self.hold.setVisible(not harmless)
        if is_open:
            means = self._texts.describe(frame) if isinstance(frame, Frame) else ""
            if means != self.decoded.text():
                self.decoded.setText(means)
            text, level = self._says(frame, self._why_not_send())
            if text != self.message.text():
                self.message.show_message(text, level)

    @unlock.why_not
    def _why_not_unlock(self) -> Refusal | None:
        return self._controller.bus.why_not_send()

    @unlock.tip
    def _unlock_tip(self) -> str:
        return self._use

    @send.why_not
    @hold.why_not
    def _why_not_send(self) -> Refusal | None:
        frame = self._typed()
        return frame if isinstance(frame, Refusal) else self._controller.bus.why_not_send(frame)

    def _says(self, frame: Frame | Refusal, why_not: Refusal | None) -> tuple[str, Level]:
        if isinstance(frame, Refusal):
            empty = not self.identifier.text().strip()
            return (self._use, Level.INFO) if empty else (words.refusal(frame), Level.WARNING)
        if why_not is not None:
            return words.refusal(why_not), Level.WARNING
        effect = effect_of(frame)
        text = frame_effect(effect)
        if self._sent:
            sent = self.tr("Sent: {frame}.").format(frame=self._sent)
            text = joined(sent, text)
        if effect is FrameEffect.HARMLESS:
            return text, Level.INFO
        return text, Level.FAULT if effect in _GRAVE else Level.WARNING

    @property
    def _use(self) -> str:
        return self.tr(
            "A frame sent by hand is only checked for its form, and counts as another "
            "program's: any motion of this program ends."
        )

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.identifier.setPlaceholderText(self.tr("ID, hex"))
        self.identifier.setAccessibleName(self.tr("Identifier of the frame, hexadecimal"))
        self.data.setPlaceholderText(self.tr("Data, hex: 01 00 00 00 …"))
        self.data.setAccessibleName(self.tr("Data of the frame, hexadecimal"))
        self._show()
