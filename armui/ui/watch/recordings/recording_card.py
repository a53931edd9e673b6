"""Cards of the present recording and of the ring, and the mark in the status bar."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication, QSize, QTimer
from PySide6.QtWidgets import (
    QFrame,
    QLabel,
    QLineEdit,
    QProgressBar,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from armui.control.sessions.episodes import LONGEST_TASK, Episodes
from armui.control.sessions.session_recorder import KEPT_S
from armui.setting_fields import ROTATE_MB
from armui.system.clock import local_time
from armui.system.files import size_text
from armui.ui import format as fmt
from armui.ui.actions.act import Act, HasActs, check_box
from armui.ui.dialogs.files import choose_folder
from armui.ui.theme import colors_of
from armui.ui.widgets import icons
from armui.ui.widgets.buttons import MARK_ICON_PX, drop_down, named, show_as_mark, spin_box
from armui.ui.widgets.layouts import STRETCH, in_column, in_row
from armui.ui.widgets.text_label import ElidedLabel, text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.sessions.progress import RecordingProgress
    from armui.control.sessions.session_recorder import SessionRecorder
    from armui.setting_checks import SessionFormat
    from armui.settings import SettingsStore


_FORMATS: Final[tuple[tuple[SessionFormat, str], ...]] = (
    (".blf", "BLF"),
    (".asc", "ASC"),
    (".log", "candump"),
)
_ICON_PX: Final = 18
_LOOK_MS: Final = 1000
_BETWEEN_PX: Final = 12
_FOLDER_PX: Final = 70
_FIGURES_PX: Final = 215
_INSIDE: Final = (8, 6, 8, 6)
"""The margins of a card: it has only two lines, to leave the drawer's height to the list."""


def episode_text(number: int, elapsed_s: float) -> str:
    """Return the text on the episode under way."""
    text = QCoreApplication.translate("RecordingCard", "episode {number} under way, {length}")
    return text.format(number=number, length=fmt.duration(elapsed_s, 0))


def moment_text(unix_s: float) -> str:
    """Return a local time to the second; «—» for 0, which means unknown."""
    at = local_time(unix_s) if unix_s else None
    return fmt.NOTHING if at is None else f"{at:%Y-%m-%d %H:%M:%S}"


class RingCard(HasActs, Translated, QFrame):
    """The last minutes of everything on the bus.

    Args:
        sessions: Has the ring.
        store: Holds the setting that has them saved automatically.
    """

    save_button = Act("Save what just happened", named="ring_save", key="sessions.ring")
    at_faults_box = Act(
        "Save by itself at a fault or a stop",
        named="ring_save_at_faults",
        tip="A few seconds after a fault or a stop, the last minutes are saved as a log. "
        "Faults that follow one another are saved together.",
        key="sessions.ring_at_faults",
        kind=check_box,
    )

    def __init__(self, sessions: SessionRecorder, store: SettingsStore) -> None:
        super().__init__()
        self._sessions = sessions
        self._store = store
        self.setProperty("card", True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.content_label = named("ring_content", ElidedLabel())
        self.memory_label = named("ring_memory", ElidedLabel("muted"))
        for label in (self.content_label, self.memory_label):
            label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
            label.setMinimumWidth(_FIGURES_PX)
        self._bar = QProgressBar(minimum=0, maximum=round(KEPT_S), textVisible=False)
        self._bar.setFixedHeight(6)
        words = in_column(self.content_label, self.memory_label, spacing=0)
        head = in_row(self.save_button, (words, 1), spacing=_BETWEEN_PX)
        below = in_row(self.at_faults_box, STRETCH)
        in_column(head, self._bar, STRETCH, below, on=self, spacing=4, margins=_INSIDE)
        self.retranslate_ui()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.setAccessibleName(self.tr("The last minutes, in memory"))
        self.refresh()

    def refresh(self) -> None:
        """Show the present content of the ring."""
        ring = self._sessions.ring()
        self.at_faults_box.setChecked(self._store.settings.session_save_at_faults)
        self._bar.setValue(round(min(ring.span_s, KEPT_S)))
        self.show_acts()
        if not ring.frames:
            self.content_label.show_text(self.tr("Nothing heard yet"))
            self.memory_label.show_text(
                self.tr("Everything on the bus, for {minutes} minutes.").format(
                    minutes=round(KEPT_S / 60)
                )
            )
            return
        self.content_label.show_text(
            self.tr("{length} of {minutes} minutes · {frames} frames").format(
                length=fmt.duration(ring.span_s, 0),
                minutes=round(KEPT_S / 60),
                frames=fmt.count(ring.frames),
            )
        )
        self.memory_label.show_text(
            self.tr("{now} of memory, {most} at most").format(
                now=size_text(ring.bytes_kept), most=size_text(ring.most_bytes)
            )
        )

    @at_faults_box.pressed
    def _on_at_faults(self) -> None:
        self._store.change(session_save_at_faults=self.at_faults_box.isChecked())

    @save_button.text
    def _save_text(self) -> str:
        saving = self._sessions.saving
        return self.tr("Saving…") if saving else self.tr("Save what just happened")

    @save_button.why_not
    def _why_not_save(self) -> str:
        if self._sessions.saving:
            return self.tr("Saving…")
        return "" if self._sessions.ring().frames else self.tr("Nothing heard yet")

    @save_button.pressed
    def _on_save(self) -> None:
        self._sessions.save_ring()


class RecordingCard(HasActs, Translated, QFrame):
    """The controls and the state of the recording to the disk.

    Args:
        controller: Receives the emergency stop of the file chooser.
        store: The settings of format, folder and size.
    """

    record_button = Act("Start log", named="session_record", key="sessions.record")
    folder_button = Act(
        "Choose…",
        named="session_choose_folder",
        key="sessions.folder",
        title=Text("Action", "Folder of the logs"),
    )

    begin_button = Act(
        "Begin episode",
        named="episode_begin",
        does=Episodes.begin,
        tip="Marks the beginning of an episode, for a dataset. F6 does it anywhere.",
        key="sessions.begin_episode",
    )
    end_button = Act(
        "End episode",
        named="episode_end",
        does=Episodes.end,
        tip="Marks the end of the episode. F6 does it anywhere.",
        key="sessions.end_episode",
    )
    discard_button = Act(
        "Discard episode",
        named="episode_discard",
        does=Episodes.discard,
        tip="Leaves the last episode out of datasets; nothing of the log is deleted.",
        key="sessions.discard_episode",
    )

    def __init__(self, controller: ArmController, store: SettingsStore) -> None:
        super().__init__()
        self._controller = controller
        self._episodes: Episodes = controller.episodes
        self._sessions: SessionRecorder = controller.sessions
        self._store = store
        self._before: tuple[float, int] | None = None
        self._rate = 0.0
        self.setProperty("card", True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._make_widgets()
        self._lay_out()
        self.format_box.activated.connect(self._on_format)
        self.size_box.valueChanged.connect(self._on_size)
        self.task_field.editingFinished.connect(self._on_task)
        self._episodes.changed.connect(self.refresh)
        self.retranslate_ui()

    def _make_widgets(self) -> None:
        self.record_button.setIconSize(QSize(_ICON_PX, _ICON_PX))
        self.state_label = named("session_state", ElidedLabel())
        self.figures_label = text_label("session_figures", rank="muted")
        self._format_label, self._size_label, self._folder_label = QLabel(), QLabel(), QLabel()
        self.format_box = drop_down("session_format")
        for suffix, name in _FORMATS:
            self.format_box.addItem(f"{name} ({suffix})", suffix)
        size = spin_box(ROTATE_MB.least, ROTATE_MB.most, " MB", step=50)
        self.size_box = named("session_rotate_size", size)
        self.size_box.setKeyboardTracking(False)
        self.task_field = named("episode_task", QLineEdit(maxLength=LONGEST_TASK))
        self._task_label = QLabel()
        self.folder_name = named("session_folder", ElidedLabel())
        for cut in (self.state_label, self.folder_name):
            cut.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.folder_name.setMinimumWidth(_FOLDER_PX)

    def _lay_out(self) -> None:
        words = in_column(self.state_label, self.figures_label, spacing=0)
        head = in_row(self.record_button, (words, 1), spacing=_BETWEEN_PX)
        chosen = in_row(
            *(self._format_label, self.format_box, 4, self._size_label, self.size_box, 4),
            *(self._folder_label, (self.folder_name, 1), self.folder_button),
            spacing=5,
        )
        marks = in_row(
            *(self._task_label, (self.task_field, 1)),
            *(self.begin_button, self.end_button, self.discard_button),
            spacing=5,
        )
        in_column(head, chosen, marks, STRETCH, on=self, spacing=4, margins=_INSIDE)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.setAccessibleName(self.tr("Log to the disk"))
        self._format_label.setText(self.tr("Format"))
        self._size_label.setText(self.tr("New file at"))
        self._folder_label.setText(self.tr("Folder"))
        self._task_label.setText(self.tr("Task"))
        self.task_field.setAccessibleName(self.tr("Task of the episodes"))
        self.task_field.setToolTip(
            self.tr("What is done in an episode. It is kept for the episodes that follow.")
        )
        self.format_box.setAccessibleName(self._format_label.text())
        self.size_box.setAccessibleName(self._size_label.text())
        self.size_box.setToolTip(
            self.tr("A file that has grown to this size is followed by another.")
        )
        self.refresh()

    def _recolor(self) -> None:
        self._show_icon(recording=self._sessions.recording)

    def refresh(self) -> None:
        """Show the state of the recording."""
        progress = self._sessions.progress()
        settings = self._store.settings
        self.format_box.setCurrentIndex(self.format_box.findData(settings.session_format))
        if not self.size_box.hasFocus():
            before = self.size_box.blockSignals(True)  # showing the setting must not store it again
            self.size_box.setValue(settings.session_rotate_mb)
            self.size_box.blockSignals(before)
        self.folder_name.show_text(str(self._sessions.choices.folder))
        self._show_icon(recording=progress is not None)
        if not self.task_field.hasFocus():
            self.task_field.setText(self._episodes.task)
        self.show_acts()
        if progress is None:
            self._before, self._rate = None, 0.0
            self.state_label.show_text(self.tr("Not logging"))
            self.figures_label.setText(self.tr("The last minutes are kept in memory anyway."))
            return
        state = progress.name or self.tr("Opening the file…")
        self.state_label.show_text(" · ".join([state, *self._episode_texts()]))
        self.figures_label.setText(self._figures(progress))

    def _episode_texts(self) -> list[str]:
        episode = self._episodes.under_way
        if episode is not None:
            return [episode_text(episode.number, self._episodes.elapsed_s)]
        kept = self._episodes.kept
        return [self.tr("{count} episodes").format(count=kept)] if kept else []

    def _figures(self, progress: RecordingProgress) -> str:
        if self._before is not None and progress.elapsed_s - self._before[0] >= 1.0:
            passed_s = progress.elapsed_s - self._before[0]
            self._rate = (progress.total_bytes - self._before[1]) / passed_s
        if self._before is None or progress.elapsed_s - self._before[0] >= 1.0:
            self._before = progress.elapsed_s, progress.total_bytes
        text = self.tr("{length} · {frames} frames · {size} · {rate}/s").format(
            length=fmt.duration(progress.elapsed_s, 0),
            frames=fmt.count(progress.frames),
            size=size_text(progress.total_bytes),
            rate=size_text(round(self._rate)),
        )
        if progress.lost:
            text += " · " + self.tr("{count} lost").format(count=fmt.count(progress.lost))
        return text

    @record_button.text
    def _record_text(self) -> str:
        recording = self._sessions.recording
        text = self.tr("Stop log") if recording else self.tr("Start log")
        return f" {text}"

    def _show_icon(self, *, recording: bool) -> None:
        name = "stop_recording" if recording else "record"
        self.record_button.setIcon(icons.icon(name, colors_of(self).text, _ICON_PX))

    # What the operator does -------------------------------------------------------------------

    @record_button.pressed
    def _on_record(self) -> None:
        if self._sessions.recording:
            self._sessions.stop()
        else:
            self._sessions.start()
        self.refresh()

    @begin_button.pressed
    def _on_begin(self) -> None:
        self._on_task()
        self._episodes.begin()

    @end_button.pressed
    def _on_end(self) -> None:
        self._episodes.end()

    @discard_button.pressed
    def _on_discard(self) -> None:
        self._episodes.discard()

    def _on_task(self) -> None:
        self._episodes.task = self.task_field.text().strip()

    def _on_format(self) -> None:
        self._store.change(session_format=self.format_box.currentData())

    def _on_size(self, megabytes: int) -> None:
        self._store.change(session_rotate_mb=megabytes)

    @folder_button.pressed
    def _on_folder(self) -> None:
        choose_folder(
            self._controller,
            self.window(),
            title=self.tr("Folder of the logs"),
            start=self._sessions.choices.folder,
            on_chosen=self._take_folder,
        )

    def _take_folder(self, folder: Path) -> None:
        self._store.change(session_folder=str(folder))
        self.refresh()


class RecordingMark(Translated, QToolButton):
    """A red dot and the time; a click opens the page of the recordings.

    Args:
        sessions: Gives the recording.
        episodes: Gives the episode under way.
    """

    def __init__(
        self, sessions: SessionRecorder, episodes: Episodes, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._sessions = sessions
        self._episodes = episodes
        self.setObjectName("recording_mark")
        show_as_mark(self)
        self._timer = QTimer(self, interval=_LOOK_MS)
        self._timer.timeout.connect(self._show_time)
        self._recolor()
        self.retranslate_ui()
        sessions.changed.connect(self._on_changed)
        episodes.changed.connect(self._show_time)
        self._on_changed()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.setAccessibleName(self.tr("Log being written"))
        self.setToolTip(self.tr("A log is being written. Click for the logs."))
        self._show_time()

    def _recolor(self) -> None:
        self.setIcon(icons.icon("record", colors_of(self).accent, MARK_ICON_PX))

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
            text = fmt.duration(progress.elapsed_s, 0)
            episode = self._episodes.under_way
            if episode is not None:
                text += " · " + episode_text(episode.number, self._episodes.elapsed_s)
            self.setText(f" {text}")
            self.setAccessibleName(self.tr("Log being written, {length}").format(length=text))
