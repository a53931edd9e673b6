"""The controls below the time line: play, pause, speed, single frames, next fault, time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import QPushButton, QWidget

from armui.ui.actions.keys import key_text, listen_for
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import drop_down, push_button
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from collections.abc import Callable

SPEEDS: Final = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 10.0, 20.0)
_ICON_PX: Final = 18


class Transport(Translated, QWidget):
    """Emits the operator's commands, and shows the replay's state.

    Signals:
        play_wanted: To play, or to pause if it plays.
        step_wanted: One frame further.
        step_back_wanted: To the moment before.
        fault_wanted: To the next fault or stop: 1, or the one before: -1.
        speed_wanted: The factor on the original speed.
    """

    play_wanted = Signal()
    step_wanted = Signal()
    step_back_wanted = Signal()
    fault_wanted = Signal(int)
    speed_wanted = Signal(float)

    def __init__(self) -> None:
        super().__init__()
        self._playing = False
        self._drawn: bool | None = None
        acts: dict[str, Callable[[], object]] = {
            "previous_fault": lambda: self.fault_wanted.emit(-1),
            "step_back": self.step_back_wanted.emit,
            "play": self.play_wanted.emit,
            "step": self.step_wanted.emit,
            "next_fault": lambda: self.fault_wanted.emit(1),
        }
        self.buttons = {name: self._button(name, act) for name, act in acts.items()}
        self.speeds = drop_down("replay_speed")
        for speed in SPEEDS:
            self.speeds.addItem(f"{speed:g}×", speed)
        self.speeds.setCurrentIndex(SPEEDS.index(1.0))
        self.speeds.activated.connect(lambda place: self.speed_wanted.emit(SPEEDS[place]))
        self.place = text_label("replay_place", plain=True)
        self.frame = text_label("replay_frame", rank="muted", plain=True)
        beside = (self.speeds, 12, self.place, 12)
        row = in_row(*self.buttons.values(), *beside, on=self, spacing=8, margins=0)
        row.addWidget(self.frame, 1, Qt.AlignmentFlag.AlignRight)
        self.retranslate_ui()
        self._recolor()

    def _button(self, name: str, act: Callable[[], object]) -> QPushButton:
        button = push_button(f"replay_{name}", on_enter=False)
        button.setIconSize(QSize(_ICON_PX, _ICON_PX))
        # a click leaves the focus, so that a key held down does not act on this button
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.clicked.connect(lambda _on=False: act())
        listen_for(f"replay.{name}", self, act, Qt.ShortcutContext.WindowShortcut)
        return button

    def show_playing(self, *, playing: bool, at_end: bool) -> None:
        """Show whether the log plays, and whether it is at its end."""
        self._playing = playing
        self.buttons["step"].setEnabled(not at_end)
        if playing is not self._drawn:
            self._drawn = playing
            self._show_play()

    def show_faults(self, *, before: bool, after: bool) -> None:
        """Show whether there is a fault to go to in either direction."""
        self.buttons["previous_fault"].setEnabled(before)
        self.buttons["next_fault"].setEnabled(after)

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        self.buttons["previous_fault"].setText(self.tr("Previous fault"))
        self.buttons["next_fault"].setText(self.tr("Next fault"))
        self._set_tip("previous_fault", self.tr("To the previous fault or stop"))
        self._set_tip("next_fault", self.tr("To the next fault or stop"))
        self._set_tip("step_back", self.tr("Pause, at the moment of the frame before"))
        self._set_tip("step", self.tr("Pause, one frame further"))
        self.speeds.setAccessibleName(self.tr("Speed of the replay"))
        self.speeds.setToolTip(
            self.tr("Multiple of the original speed. Above 4× not every frame is processed.")
        )
        self._show_play()

    def _show_play(self) -> None:
        button = self.buttons["play"]
        button.setText(self.tr("Pause") if self._playing else self.tr("Play"))
        self._set_tip("play", self.tr("Play or pause"))
        self._draw("play", "pause" if self._playing else "play")
        widest = max(
            button.fontMetrics().horizontalAdvance(word)
            for word in (self.tr("Pause"), self.tr("Play"))
        )
        button.setMinimumWidth(widest + _ICON_PX + 36)

    def _set_tip(self, name: str, tip: str) -> None:
        button = self.buttons[name]
        button.setAccessibleName(button.text() or tip)
        button.setToolTip(f"{tip} ({key_text(f'replay.{name}')})")

    def _recolor(self) -> None:
        self._draw("step_back", "step_back")
        self._draw("step", "step")
        self._draw("play", "pause" if self._playing else "play")

    def _draw(self, name: str, icon: str) -> None:
        self.buttons[name].setIcon(icons.icon(icon, colors_of(self).replay, _ICON_PX))
