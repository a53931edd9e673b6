"""Which button of a device does what, to be chosen; the one that is down is marked."""

from __future__ import annotations

from functools import partial
from typing import Final

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QLabel, QWidget

from armui.gamepad.device_state import DeviceKind
from armui.gamepad.layout import ACTIONS, BUTTONS, DEFAULTS, Assignment, swapped
from armui.ui.widgets.buttons import caption, named, push_button
from armui.ui.widgets.layouts import STRETCH, empty_grid, in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.gamepad import gamepad_action, gamepad_button

_MOST_SEEN: Final = 12
_OPTIONAL: Final = frozenset({"halt", "mode"})


class ButtonRows(Translated, QWidget):
    """A row for each thing a button can do.

    Args:
        kind: Of the device.
    """

    chosen = Signal(object)
    """An :class:`Assignment`: the operator wants it so."""

    def __init__(self, kind: DeviceKind) -> None:
        super().__init__()
        self._kind = kind
        self._now = DEFAULTS[kind]
        self._labels = {action: QLabel() for action in ACTIONS}
        self._boxes = {action: named(f"gamepad_{action}_box", QComboBox()) for action in ACTIONS}
        self._down = text_label("gamepad_down", rank="muted", wraps=True)
        self._first = push_button("gamepad_defaults_button", on_enter=False)
        grid = empty_grid(self, gaps=(12, 8), margins=0)
        grid.setColumnStretch(1, 1)
        for row, action in enumerate(ACTIONS):
            label, box = self._labels[action], self._boxes[action]
            label.setBuddy(box)
            box.setMaxVisibleItems(_MOST_SEEN)
            for button in self._choices(action):
                box.addItem("", button)
            box.activated.connect(partial(self._on_chosen, action))
            grid.addWidget(label, row, 0)
            grid.addWidget(box, row, 1)
        grid.addLayout(in_row(STRETCH, self._first), len(ACTIONS), 0, 1, 2)
        grid.addWidget(self._down, len(ACTIONS) + 1, 0, 1, 2)
        grid.setRowStretch(len(ACTIONS) + 2, 1)
        self._first.clicked.connect(lambda: self.chosen.emit(DEFAULTS[self._kind]))
        self.retranslate_ui()

    def show_assignment(self, now: Assignment) -> None:
        """Show what holds."""
        self._now = now
        for action, box in self._boxes.items():
            box.setCurrentIndex(box.findData(getattr(now, action)))

    def show_down(self, down: frozenset[str]) -> None:
        """Name the buttons that are down, and mark what they do."""
        names = " · ".join(gamepad_button(self._kind, name) for name in sorted(down))
        self._down.setText(self.tr("Pressed: {buttons}").format(buttons=names or "—"))
        for action, label in self._labels.items():
            lit = getattr(self._now, action) in down
            font = label.font()
            if font.bold() != lit:
                font.setBold(lit)
                label.setFont(font)

    def _choices(self, action: str) -> tuple[str, ...]:
        return (*(("",) if action in _OPTIONAL else ()), *BUTTONS[self._kind])

    def _on_chosen(self, action: str, place: int) -> None:
        button = self._boxes[action].itemData(place)
        self.chosen.emit(swapped(self._now, action, button))

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        for action, box in self._boxes.items():
            self._labels[action].setText(gamepad_action(action))
            for place, button in enumerate(self._choices(action)):
                text = gamepad_button(self._kind, button) if button else self.tr("No button")
                box.setItemText(place, text)
        tip = self.tr("The buttons as they are at first")
        caption(self._first, self.tr("Restore"), tip=tip)
        self.show_down(frozenset())
