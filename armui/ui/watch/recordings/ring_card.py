"""What is kept in memory, and its saving."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QCheckBox, QFrame, QProgressBar

from armui.control.sessions.session_recorder import KEPT_S
from armui.ui.watch.recordings import figures
from armui.ui.widgets.buttons import named, push_button
from armui.ui.widgets.layouts import STRETCH, in_column
from armui.ui.widgets.text_label import text_label
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.control.sessions.session_recorder import SessionRecorder
    from armui.settings import SettingsStore


class RingCard(Translated, QFrame):
    """The last minutes of everything on the bus.

    Args:
        sessions: Keeps them.
        store: Keeps whether they are saved by themselves.
    """

    def __init__(self, sessions: SessionRecorder, store: SettingsStore) -> None:
        super().__init__()
        self._sessions = sessions
        self._store = store
        self.setProperty("card", True)
        self._title = text_label(rank="heading")
        self.content_label = text_label("ring_content")
        self.memory_label = text_label("ring_memory", rank="muted")
        self._bar = QProgressBar(minimum=0, maximum=round(KEPT_S), textVisible=False)
        self._bar.setFixedHeight(6)
        self.save_button = push_button("ring_save", primary=True)
        self.save_button.setAutoDefault(False)
        self.at_faults_box = named("ring_save_at_faults", QCheckBox())
        in_column(
            self._title,
            self.content_label,
            self._bar,
            self.memory_label,
            STRETCH,
            self.save_button,
            self.at_faults_box,
            on=self,
            spacing=8,
            margins=(16, 12, 16, 14),
        )
        self.save_button.clicked.connect(lambda: self._sessions.save_ring())  # noqa: PLW0108
        self.at_faults_box.clicked.connect(
            lambda checked: self._store.change(session_save_at_faults=checked)
        )
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._title.setText(self.tr("The last minutes, in memory"))
        self.at_faults_box.setText(self.tr("Save by itself at a fault or a stop"))
        self.at_faults_box.setToolTip(
            self.tr(
                "A few seconds after a fault or a stop, the last minutes are saved as a recording. "
                "Faults that follow one another are saved together."
            )
        )
        self.refresh()

    def refresh(self) -> None:
        """Show what is kept now."""
        ring = self._sessions.ring()
        self.at_faults_box.setChecked(self._store.settings.session_save_at_faults)
        self._bar.setValue(round(min(ring.span_s, KEPT_S)))
        saving = self._sessions.saving
        self.save_button.setText(
            self.tr("Saving…") if saving else self.tr("Save what just happened")
        )
        self.save_button.setEnabled(bool(ring.frames) and not saving)
        if not ring.frames:
            self.content_label.setText(self.tr("Nothing heard yet"))
            self.memory_label.setText(
                self.tr("Everything on the bus, for {minutes} minutes.").format(
                    minutes=round(KEPT_S / 60)
                )
            )
            return
        self.content_label.setText(
            self.tr("{length} of {minutes} minutes · {frames} frames").format(
                length=figures.length(ring.span_s),
                minutes=round(KEPT_S / 60),
                frames=figures.count(ring.frames),
            )
        )
        self.memory_label.setText(
            self.tr("{now} of memory, {most} at most").format(
                now=figures.size(ring.bytes_kept), most=figures.size(ring.most_bytes)
            )
        )
