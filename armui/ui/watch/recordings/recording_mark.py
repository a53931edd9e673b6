"""In the status bar, while the session is recorded: that it is, and for how long."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtWidgets import QToolButton, QWidget

from armui.ui.theme import colors_of
from armui.ui.watch.recordings import figures
from armui.ui.widgets import icons
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.sessions.session_recorder import SessionRecorder

_ICON_PX: Final = 14
_LOOK_MS: Final = 1000


class RecordingMark(Translated, QToolButton):
    """A red dot and the time; a click opens the window of the recordings.

    Args:
        sessions: Records them.
    """

    def __init__(self, sessions: SessionRecorder, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._sessions = sessions
        self.setObjectName("recording_mark")
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self.setAutoRaise(True)
        self.setProperty("narrow", True)
        self.setFixedHeight(self.fontMetrics().height())  # the bar keeps its height
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self._show_time)
        self._recolor()
        self.retranslate_ui()
        sessions.changed.connect(self._on_changed)
        self._on_changed()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.setAccessibleName(self.tr("Recording of the session"))
        self.setToolTip(self.tr("The session is being recorded. Click for the recordings."))
        self._show_time()

    def _recolor(self) -> None:
        self.setIcon(icons.icon("record", colors_of(self).stop, _ICON_PX))

    def _on_changed(self) -> None:
        recording = self._sessions.recording
        self.setVisible(recording)
        if recording:
            self._timer.start()
            self._show_time()
        else:
            self._timer.stop()

    def _show_time(self) -> None:
        progress = self._sessions.progress()
        if progress is not None:
            text = figures.length(progress.elapsed_s)
            self.setText(f" {text}")
            self.setAccessibleName(self.tr("Recording, {length}").format(length=text))
