"""Jogging by keys: only while the dead-man key and exactly one key of a direction are held."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent
from PySide6.QtWidgets import QFrame, QLabel

from armui.ui.widgets.hold_guard import HoldGuard
from armui.ui.widgets.layouts import empty_grid, in_column
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

DEAD_MAN_KEY: Final = Qt.Key.Key_Space
"""Under the thumb of either hand, no letter, and none of the keys that stop the arm."""

Keys = Sequence[tuple[str, str, str]]
"""Of each place, in order: its name, the key for + and the key for −, as on the keyboard."""

_KEYS: Final = {
    "↑": Qt.Key.Key_Up,
    "↓": Qt.Key.Key_Down,
    "←": Qt.Key.Key_Left,
    "→": Qt.Key.Key_Right,
    "PgUp": Qt.Key.Key_PageUp,
    "PgDn": Qt.Key.Key_PageDown,
}
_COLUMNS: Final = 3


class KeyPad(Translated, QFrame):
    """Takes keys only while it has the focus, and says on itself which key does what.

    Releasing either key, a second key of a direction, the loss of the focus and all that
    :class:`HoldGuard` watches for end the motion. It takes a new press to begin again.

    Args:
        keys: What can be moved, and by which keys.
        name: Of the widget in the program.
    """

    pressed = Signal(int, int)
    """A key of a direction went down: the place in ``keys``, and +1 or −1."""
    let_go = Signal()
    """The hold is over; comes once after each :attr:`pressed`."""
    unattended = Signal()
    """It ended because the operator gave no sign for too long."""

    def __init__(self, keys: Keys, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setProperty("card", True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._moves: dict[int, tuple[int, int]] = {}
        self._down: set[int] = set()
        self._armed = False
        self._holding = False
        self._why_not = ""
        self._continuous = False
        self._guard = HoldGuard(self)
        self._guard.lost.connect(self._forget)
        self._guard.unattended.connect(self.unattended)
        self._hint = text_label(f"{name}_hint", wraps=True)
        grid = empty_grid(gaps=(18, 2))
        for place, (what, plus, minus) in enumerate(keys):
            for text, direction in ((plus, 1), (minus, -1)):
                self._moves[_key(text)] = (place, direction)
            label = QLabel(f"{what}  + {plus}  − {minus}")
            label.setProperty("rank", "muted")
            grid.addWidget(label, place // _COLUMNS, place % _COLUMNS)
        in_column(self._hint, grid, on=self, spacing=1, margins=(14, 5, 14, 5))
        self.retranslate_ui()

    def set_continuous(self, wanted: bool) -> None:
        """Whether a key moves until it is let go, or by one step a press."""
        self._continuous = wanted
        self.retranslate_ui()

    def allow(self, why_not: str) -> None:
        """Take keys, or none and say why."""
        self._why_not = why_not
        if why_not:
            self._forget()
        self.retranslate_ui()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Begin with the one key of a direction that goes down while the dead-man key is held."""
        key = event.key()
        if key != DEAD_MAN_KEY and key not in self._moves:
            super().keyPressEvent(event)
            return
        if event.isAutoRepeat():
            return
        if key == DEAD_MAN_KEY:
            self._armed = True
            return
        self._end()
        self._down.add(key)
        if self._armed and len(self._down) == 1 and not self._why_not:
            self._holding = True
            self._guard.watch()
            self.pressed.emit(*self._moves[key])

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Either key that comes up ends it."""
        key = event.key()
        if key != DEAD_MAN_KEY and key not in self._moves:
            super().keyReleaseEvent(event)
            return
        if event.isAutoRepeat():
            return
        self._down.discard(key)
        if key == DEAD_MAN_KEY:
            self._armed = False
        self._end()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show that keys are taken now."""
        super().focusInEvent(event)
        self.retranslate_ui()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """No key that is released elsewhere is heard of: none counts as held."""
        self._forget()
        super().focusOutEvent(event)
        self.retranslate_ui()

    def hideEvent(self, event: QHideEvent) -> None:
        """What is not seen is not held."""
        self._forget()
        super().hideEvent(event)

    def _forget(self) -> None:
        self._armed = False
        self._down.clear()
        self._end()

    def _end(self) -> None:
        """The motion ends before anything is done that could fail."""
        if self._holding:
            self._holding = False
            self.let_go.emit()
        self._guard.release()

    def retranslate_ui(self) -> None:
        """Say what the keys do, or what is missing."""
        self.setAccessibleName(self.tr("Keyboard jogging"))
        self.setToolTip(self._why_not)
        if self._why_not:
            text = self.tr("Jogging is not possible now.")
        elif self.hasFocus() and not self._continuous:
            text = self.tr("Hold the space bar; each press of a key is one step.")
        elif self.hasFocus():
            text = self.tr("Hold the space bar and press a key; release either and the arm stops.")
        else:
            text = self.tr("Click here to jog by keys.")
        self._hint.setText(text)


def _key(text: str) -> int:
    named = _KEYS.get(text)
    return int(named) if named is not None else ord(text)
