"""Moves the ghost arm through a planned motion: a time slider, play, close."""

from __future__ import annotations

import re
from typing import Final

from PySide6.QtCore import QElapsedTimer, QSignalBlocker, QTimer, Signal
from PySide6.QtWidgets import QFrame

from armui.ui import format as fmt
from armui.ui.actions.act import Act, HasActs
from armui.ui.widgets.buttons import caption, describe, named, push_button
from armui.ui.widgets.layouts import in_row
from armui.ui.widgets.text_label import ValueLabel
from armui.ui.widgets.track_slider import TrackSlider
from armui.ui.widgets.translated import Translated

_STEP_S: Final = 0.01
_FRAME_MS: Final = 33


class PreviewBar(HasActs, Translated, QFrame):
    """Shows the ghost's time, and lets the operator change it.

    Nothing is ever sent.

    Signals:
        time_changed: seconds from the beginning of the motion.
        closed: the preview is no longer wanted.
    """

    _close = Act("Close preview", named="preview_close", key="view.close_preview")
    time_changed = Signal(float)
    closed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("preview_bar")
        self._duration_s = 0.0
        self._play = push_button("preview_play", on_enter=False)
        self._play.setCheckable(True)
        self._slider = named("preview_slider", TrackSlider(_STEP_S, origin=0.0))
        self._slider.setSingleStep(10)
        self._slider.setPageStep(100)
        self._time = named("preview_time", ValueLabel(""))
        parts = (self._play, (self._slider, 1), self._time, self._close)
        in_row(*parts, on=self, spacing=6, margins=8)
        self._clock = QElapsedTimer()
        self._timer = QTimer(self, interval=_FRAME_MS)
        self._timer.timeout.connect(self._on_frame)
        self._slider.valueChanged.connect(self._on_moved)
        self._play.toggled.connect(self._on_play)
        self.hide()
        self.retranslate_ui()

    @property
    def time_s(self) -> float:
        """The ghost's time in seconds."""
        return self._slider.requested

    @property
    def is_playing(self) -> bool:
        """True while the ghost moves by itself."""
        return self._play.isChecked()

    @property
    def _at_end(self) -> bool:
        return self._slider.sliderPosition() >= self._slider.maximum()

    def open(self, duration_s: float) -> None:
        """Show a motion of this duration from its beginning."""
        self._play.setChecked(False)
        self._duration_s = duration_s
        widest = re.sub(r"\d", "0", fmt.clock(duration_s, 1))
        self._time.set_widest(f"{widest} / {widest}")
        self._slider.set_limits(0.0, duration_s)
        self.go_to(0.0)
        self.show()

    def go_to(self, time_s: float) -> None:
        """Move the ghost to a time."""
        with QSignalBlocker(self._slider):
            self._slider.show_requested(time_s)
        self._on_moved()

    def play(self) -> None:
        """Begin to move the ghost along the path."""
        self._play.setChecked(True)

    def set_shown(self, shown: bool) -> None:
        """Show the bar, or hide it and stop playing."""
        if not shown:
            self._play.setChecked(False)
        self.setVisible(shown)

    @_close.pressed
    def _on_close(self) -> None:
        self.closed.emit()

    def _on_moved(self) -> None:
        self._time.show_text(
            f"{fmt.clock(self.time_s, 1)} / {fmt.clock(self._duration_s, 1)}", stale=False
        )
        self.time_changed.emit(self.time_s)

    def _on_play(self, playing: bool) -> None:
        if not playing:
            self._timer.stop()
        else:
            if self._at_end:
                self.go_to(0.0)
            self._clock.start()
            self._timer.start()
        self._name_play()

    def _on_frame(self) -> None:
        passed_s = self._clock.restart() / 1000.0
        self.go_to(min(self.time_s + passed_s, self._duration_s))
        if self._at_end:
            self._play.setChecked(False)

    def _name_play(self) -> None:
        text = self.tr("Pause") if self._play.isChecked() else self.tr("Play")
        tip = self.tr("Moves the ghost arm only; the real arm stays where it is.")
        caption(self._play, text, tip=tip)

    def retranslate_ui(self) -> None:
        """Set the texts in the operator's language."""
        tip = self.tr("Moves the ghost arm through the motion.")
        describe(self._slider, self.tr("Time of the preview"), tip)
        self.show_acts()
        self._name_play()
