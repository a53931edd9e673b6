"""录制: records the arm's motion; then trims and thins it, and saves it as samples or points."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QLabel, QLineEdit

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.control.operating_state import BUSY, OperatingState
from armui.control.operations.operation import operation_of
from armui.control.run.preflight import Checks, Preflight
from armui.control.run.recorder import Recorder
from armui.system.files import size_text
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.library.store import Library
from armui.trajectory.samples import thin
from armui.trajectory.samples.recording import Recording
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command, Target
from armui.ui.background import Job
from armui.ui.dialogs.confirm_dialog import LeaveQuestion, SaveQuestion
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.recording.recorded_curves import RecordedCurves
from armui.ui.widgets.buttons import named
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.page import Page
from armui.ui.widgets.seen_timer import SeenTimer
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.control.run.recorder import Recorder
    from armui.control.run.sample_store import Recorded
    from armui.trajectory.files import Content
    from armui.trajectory.library.recording_drafts import RecordingDraft
    from armui.ui.background import Background

_TOLERANCE_DEG: Final = 0.1
"""The default deviation that thinning may cause."""
_FIELD_PX: Final = 120
_AFTER_MS: Final = 250
"""The delay after a key: half an hour of samples is not thinned at each one."""


_GROW_MS: Final = 250
_SEEN_SAMPLES: Final = 4000
"""The number of last samples shown of a running recording: 20 s at 200 Hz."""
_WRITE_MS: Final = 1000
"""The period of writing, and the most that is lost if the program is killed."""


class RecordingKeeper(QObject):
    """Writes a recording to a file as it grows, until it is saved or not wanted.

    Args:
        recorder: Records.
        work: Has the library write.

    Signals:
        failed: The reason why it is not written any more, as a text; recording goes on.
    """

    failed = Signal(str)

    def __init__(self, recorder: Recorder, work: LibraryWork) -> None:
        super().__init__(work)
        self._recorder = recorder
        self._work = work
        self._draft: RecordingDraft | None = None
        self._written = 0
        self._refused = False
        self._timer = QTimer(self, interval=_WRITE_MS)
        self._timer.timeout.connect(self.write)

    def begin(self, name: str, taught_on: str) -> None:
        """Begin to write a new recording.

        Args:
            name: Its future name.
            taught_on: The arm it is of.
        """
        self.drop()
        self._draft = self._work.library.begin_recording(name, taught_on)
        self._written, self._refused = 0, False
        self._timer.start()

    def write(self) -> None:
        """Append the samples since the last time."""
        draft, count = self._draft, self._recorder.count
        if draft is None or self._refused:
            return
        if not self._recorder.recording:
            self._timer.stop()
        rows = self._recorder.rows_from(self._written) if count > self._written else None
        if rows is not None:
            self._written = count
            append = partial(self._work.library.append_recording, draft, rows)
            self._work.do(append, refused=partial(self._on_refused, draft))

    def drop(self) -> None:
        """Delete the file, because the recording is saved or not wanted."""
        self._timer.stop()
        draft, self._draft = self._draft, None
        if draft is not None:
            self._work.do(partial(self._work.library.drop_recording, draft))

    def _on_refused(self, draft: RecordingDraft, text: str) -> None:
        if draft is self._draft and not self._refused:
            self._refused = True
            self._timer.stop()
            self.failed.emit(text)


@dataclass(frozen=True, slots=True, eq=False)
class RecordingCut:
    """The part of a recording that would be kept.

    Attributes:
        recording: The whole recording.
        from_s, to_s: The beginning and the end of the kept part.
        at_s: The operator's place: the end that was moved last.
    """

    recording: Recording
    from_s: float
    to_s: float
    at_s: float


class RecordingPage(Page):
    """The page to record, trim, thin and save.

    Args:
        controller: Records, and gives the arm's state.
        background: Thins recordings.
        library: The library.
        recording: A recording of the library to trim and thin; by default a new one is recorded.

    Signals:
        saved: The name of a saved trajectory or recording.
        preview_wanted: A :class:`Preflight` of what would be saved, to be shown in 3D.
        cut_changed: `cut` has changed.
    """

    commands = (
        Command(
            "recording.record",
            Text("RecordingPage", "Start recording"),
            operation_of(Recorder.start),
        ),
        Command("recording.stop", Text("RecordingPage", "Stop recording")),
    )
    _record = Act("Start recording", named="record")
    _preview = Act(
        "Preview",
        named="record_preview",
        tip="The path in the 3D view, and a ghost arm; the real arm stays where it is",
        key="recording.preview",
        leads=True,
    )
    _as_points = Act(
        "Save as points",
        named="save_points",
        tip="The arm comes to rest in every point",
        key="recording.points",
    )
    _as_samples = Act("Save as recording", named="save_recording", key="recording.samples")
    saved = Signal(str)
    preview_wanted = Signal(object)
    cut_changed = Signal()

    def __init__(
        self,
        controller: ArmController,
        background: Background,
        library: Library,
        recording: Recording | None = None,
    ) -> None:
        super().__init__("recording")
        self._controller = controller
        self._background = background
        self._checks = Checks(controller, background)
        self._job: Job[Recording | None] | None = None
        self._library = library
        self._work = LibraryWork(library, background, self)
        self._keeper = RecordingKeeper(controller.recorder, self._work)
        self._joining = self._leaving = False
        self._recording = self._result = recording
        self._is_kept = recording is not None
        """True if the recording was opened from the library."""
        self._at_s = 0.0
        self._unsaved = False
        self._timer = QTimer(self, singleShot=True, interval=_AFTER_MS)
        self._timer.timeout.connect(self._work_out)
        self._make_widgets()
        self._lay_out()
        self._connect()
        if recording is not None:
            self._show_recording(recording)
        self.retranslate_ui()
        self.take_focus()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        record = "stop" if self._controller.recorder.recording else "record"
        return {**super().command_targets(), f"recording.{record}": self._record}

    def _make_widgets(self) -> None:
        self._state = text_label("record_state")
        self._name = named("record_name", QLineEdit())
        self._from = _field("record_from", 3, "s")
        self._to = _field("record_to", 3, "s")
        self._tolerance = _field("record_tolerance", 3, "°")
        self._tolerance.step = 0.1
        self._kept = text_label("record_kept", rank="muted")
        self._curves = RecordedCurves()
        SeenTimer(self, _GROW_MS, self._show_growing)
        self._labels = [QLabel() for _ in range(4)]
        self._message = named("record_message", MessageLine())

    def _lay_out(self) -> None:
        head = in_row(self._record, (self._state, 1))
        grid = empty_grid(gaps=(10, None))
        fields = (self._name, self._from, self._to, self._tolerance)
        for row, (label, field) in enumerate(zip(self._labels, fields, strict=True)):
            grid.addWidget(label, row, 0)
            grid.addWidget(field, row, 1, 1, 2 if field is self._name else 1)
            label.setBuddy(field)
        grid.addWidget(self._kept, 3, 2)
        grid.setColumnStretch(2, 1)
        fill(self.body, head, (self._curves, 1), grid, self._message)
        fill(self.footer, self._preview, STRETCH, self._as_points, self._as_samples)

    def _connect(self) -> None:
        for field in (self._from, self._to, self._tolerance):
            field.value_edited.connect(self._timer.start)
        self._from.value_edited.connect(lambda: self._on_typed(self._from))
        self._to.value_edited.connect(lambda: self._on_typed(self._to))
        self._curves.trimmed.connect(self._on_trimmed)
        self._keeper.failed.connect(self._on_not_kept)
        self._controller.recorder.changed.connect(self._on_recorder)
        self._controller.operating_state_changed.connect(self._on_operating_state)

    @property
    def in_use(self) -> bool:
        """True if it records, or holds an unsaved recording."""
        return self._controller.recorder.recording or self._joining or self._unsaved

    # Recording --------------------------------------------------------------------------------

    @_record.pressed
    def _on_record(self) -> None:
        if self._controller.recorder.recording:
            self._take()
        elif self._unsaved:
            self._ask_to_replace()
        else:
            self._begin()

    def _ask_to_replace(self) -> None:
        """Ask before a new recording takes the place of an unsaved one."""
        text = self.tr("“{name}” has not been saved. A new recording replaces it.")
        text = text.format(name=self._wanted_name())
        question = SaveQuestion(self._controller, self, text, concerns_arm=False)
        question.accepted.connect(self._begin)
        question.save_wanted.connect(lambda: self._work_out(partial(self._save, then=self._begin)))
        self._open(question)

    def _open(self, question: SaveQuestion) -> None:
        """Open a question in the place of one that is open."""
        for older in self.findChildren(SaveQuestion):
            if older is not question:
                older.reject()
        question.finished.connect(question.deleteLater)
        question.open()

    def _begin(self) -> None:
        answer = self._controller.recorder.start()
        if isinstance(answer, Refusal):
            self._show_message(partial(words.refusal, answer), Level.WARNING)
        else:
            self._drop_work()
            self._recording = self._result = None
            self._is_kept = self._unsaved = False
            self.set_title(self.tr("Recording"))
            self._curves.show_recording(None)
            self.cut_changed.emit()
            taught_on = self._controller.operating_state.model_fit.taught_on
            self._keeper.begin(self._wanted_name(), taught_on)
            self._show_message("")
        self._show_state()

    def _show_growing(self) -> None:
        """Show the last seconds of what is being recorded."""
        recorder = self._controller.recorder
        if not recorder.recording or self._recording is not None:
            return
        rows = recorder.rows_from(max(0, recorder.count - _SEEN_SAMPLES))
        if rows is not None and len(rows):
            rows[:, 0] -= rows[0, 0]
            self._curves.show_recording(Recording("", samples=rows), grows=True)

    def _wanted_name(self) -> str:
        return self._name.text().strip() or self.tr("Recording")

    def keep_draft(self) -> None:
        """Write the unsaved recording, because the program ends; it is offered the next time."""
        self._keeper.write()

    def _on_not_kept(self, text: str) -> None:
        said = self.tr("It is in memory alone until it is saved. {reason}").format(reason=text)
        self._show_message(said, Level.WARNING)

    def _take(self) -> None:
        name = self._wanted_name()
        recorded = self._controller.recorder.finish(name)
        if recorded is None:
            self._show_message(
                self.tr("Nothing was recorded: the arm reported no angles."), Level.WARNING
            )
            self._show_state()
            return
        self._keeper.write()
        self._unsaved = self._joining = True
        self._show_message(self.tr("Working…"))
        self._show_state()
        self._work.do(
            lambda: recorded.joined(self._library.free_name(name)),
            self._on_joined,
            lambda text: self._on_not_joined(recorded, text),
        )

    def _on_joined(self, recording: Recording) -> None:
        self._show_message("")
        self._show_joined(recording)

    def _on_not_joined(self, recorded: Recorded, text: str) -> None:
        """The library cannot be read: the recording is kept under the name that was asked for."""
        self._show_message(text, Level.FAULT)
        self._work.do(recorded.joined, self._show_joined)

    def _show_joined(self, recording: Recording) -> None:
        self._joining = False
        self._show_recording(recording)
        self._go_on_leaving()

    def _go_on_leaving(self) -> None:
        if self._leaving and not self._joining and self._job is None:
            self._leaving = False
            self.leave()

    def _show_recording(self, recording: Recording) -> None:
        self._recording = recording
        self._name.setText(recording.name)
        self._from.show_value(0.0)
        self._to.show_value(recording.duration_s)
        self._tolerance.show_value(_TOLERANCE_DEG)
        self._curves.show_recording(recording)
        self._at_s = 0.0
        self.cut_changed.emit()
        self._work_out()
        self._show_state()

    # Trimming ---------------------------------------------------------------------------------

    @property
    def cut(self) -> RecordingCut | None:
        """The part that would be kept; ``None`` without a recording, or with invalid figures."""
        from_s, to_s = self._from.value, self._to.value
        if self._recording is None or from_s is None or to_s is None or not 0 <= from_s <= to_s:
            return None
        return RecordingCut(self._recording, from_s, to_s, self._at_s)

    def _on_trimmed(self, from_s: float, to_s: float, at_s: float) -> None:
        """Take over the range, in s, while a handle of the curves is dragged."""
        self._from.show_value(from_s)
        self._to.show_value(to_s)
        self._at_s = at_s
        self._timer.start()
        self.cut_changed.emit()

    def _on_typed(self, field: FigureField) -> None:
        cut = self.cut
        if cut is not None and field.value is not None:
            self._at_s = field.value
            self._curves.show_range(cut.from_s, cut.to_s)
        self.cut_changed.emit()

    def _work_out(self, then: Callable[[Recording], object] | None = None) -> None:
        """Trim and thin the recording by the values of the fields.

        Args:
            then: Called with the result.
        """
        self._drop_work()
        whole = self._recording
        if whole is None:
            return
        for field in (self._from, self._to, self._tolerance):
            field.show_attention(wanted=field.value is None or field.value < 0.0)
        figures = [field.value for field in (self._from, self._to, self._tolerance)]
        from_s, to_s, tolerance_deg = (-1.0 if value is None else value for value in figures)
        self._result = None
        if min(from_s, to_s, tolerance_deg) >= 0.0:
            self._job = Job(partial(self._take_result, then))
            # the field rounds to milliseconds: the last sample may be up to half of one later
            self._background.begin(self._job, thin.cut, whole, from_s, to_s + 0.0005, tolerance_deg)
        self._show_kept()

    def _drop_work(self) -> None:
        self._timer.stop()
        if self._job is not None:
            self._job.wanted = False
            self._job = None

    def _take_result(
        self, then: Callable[[Recording], object] | None, result: Recording | Refusal | None
    ) -> None:
        self._job = None
        if isinstance(result, Refusal):
            self._show_message(partial(words.refusal, result), Level.FAULT)
            result = None
        self._result = result
        self._show_kept()
        if result is not None and then is not None:
            then(result)
        self._go_on_leaving()

    def _show_kept(self) -> None:
        whole, result = self._recording, self._result
        if whole is None:
            self._kept.clear()
        elif self._job is not None:
            self._kept.setText(self.tr("Working…"))
        elif result is None:
            self._kept.setText(self.tr("Nothing is left: correct the marked fields."))
        else:
            text = self.tr("Keeps {kept} of {count} samples, {time}, {size}")
            kept, count = fmt.count(len(result.samples)), fmt.count(len(whole.samples))
            time, size = fmt.duration(result.duration_s), size_text(result.samples.nbytes)
            self._kept.setText(text.format(kept=kept, count=count, time=time, size=size))
        self.show_acts()

    @_preview.why_not
    @_as_samples.why_not
    @_as_points.why_not
    def _why_nothing_kept(self) -> str:
        if self._result is not None or self._job is not None:
            return ""
        if self._recording is None:
            return self.tr("Lead the arm by hand, or move it by anything, while it records.")
        return self.tr("Nothing is left: correct the marked fields.")

    @_preview.pressed
    def preview(self) -> None:
        """Show in 3D the path of what would be saved; nothing is sent."""
        self._work_out(self._plan_preview)

    def _plan_preview(self, recording: Recording) -> None:
        self._checks.begin(recording, RunOptions(), self._show_preview)

    def _show_preview(self, checked: Preflight | Refusal) -> None:
        if isinstance(checked, Refusal):
            self._show_message(partial(words.refusal, checked), Level.FAULT)
            return
        self._show_message(self.tr("The path is shown in the 3D view."))
        self.preview_wanted.emit(checked)

    # Keeping ----------------------------------------------------------------------------------

    @_as_samples.pressed
    def save_samples(self) -> None:
        """Save it as a recording, to be replayed in its own time."""
        self._work_out(self._save)

    @_as_points.pressed
    def save_points(self) -> None:
        """Save it as points of MOVE J for editing; the arm will come to rest in each."""
        self._work_out(self._save_as_points)

    def _save_as_points(self, recording: Recording) -> None:
        limits = self._controller.operating_state.limits
        self._keep(recording, lambda: thin.to_points(recording, limits))

    def _save(self, recording: Recording, then: Callable[[], object] = lambda: None) -> None:
        self._keep(recording, lambda: recording, then)

    def _keep(
        self,
        recording: Recording,
        make: Callable[[], Content],
        then: Callable[[], object] = lambda: None,
    ) -> None:
        wanted = self._name.text().strip() or recording.name
        whole = self._recording

        def save() -> str:
            name = self._library.free_name(wanted)
            self._library.save(replace(make(), name=name))
            return name

        self._work.do(
            save,
            partial(self._on_saved, whole, then),
            lambda text: self._show_message(text, Level.FAULT),
        )

    def _on_saved(self, whole: Recording | None, then: Callable[[], object], name: str) -> None:
        if self._recording is whole:
            self._unsaved = False
            self._keeper.drop()
        self._show_message(self.tr("Saved as “{name}”.").format(name=name), Level.DONE)
        self.saved.emit(name)
        then()

    def leave(self) -> None:
        """Close the page, after ending a running recording; an unsaved one asks first."""
        if self._controller.recorder.recording and self._recording is None:
            self._take()
        if self._joining or self._job is not None:
            self._leaving = True  # close it when joining and trimming are done
            return
        if not self._unsaved:
            super().leave()
            return
        question = LeaveQuestion(self._controller, self, self._name.text())
        question.accepted.connect(self._discard)
        question.save_wanted.connect(self.save_samples)
        self._open(question)

    def _discard(self) -> None:
        self._unsaved = False
        self._keeper.drop()
        super().leave()

    # Texts ------------------------------------------------------------------------------------

    def _show_state(self) -> None:
        recorder = self._controller.recorder
        running = recorder.recording
        if running:
            text = self.tr("Recording: {time}, {count} samples").format(
                time=fmt.duration(recorder.duration_s), count=fmt.count(recorder.count)
            )
            if recorder.dropped:
                text += self.tr(" ({count} lost)").format(count=recorder.dropped)
        elif self._recording is None:
            text = self.tr("Lead the arm by hand, or move it by anything, while it records.")
        else:
            samples = self._recording.samples
            text = self._state_text().format(
                time=fmt.duration(self._recording.duration_s),
                count=fmt.count(len(samples)),
                size=size_text(samples.nbytes),
            )
        self._state.setText(text)
        for field in (self._from, self._to, self._tolerance):
            field.setEnabled(self._recording is not None)
        self._show_kept()

    @_record.text
    def _record_text(self) -> str:
        recording = self._controller.recorder.recording
        return self.tr("Stop recording") if recording else self.tr("Start recording")

    def _state_text(self) -> str:
        """Return the heading; without an arm's name it is an import, or of an unknown arm."""
        if self._recording is not None and self._is_kept and not self._recording.taught_on:
            return self.tr("Imported file, or of an unknown arm: {time}, {count} samples, {size}")
        return self.tr("Recorded: {time}, {count} samples, {size}")

    def take_focus(self) -> None:
        """Focus the button that records, or that shows what the library has."""
        (self._preview if self._is_kept else self._record).setFocus()

    def showEvent(self, event: QShowEvent) -> None:
        """Update the state, which was not updated while the page was hidden."""
        super().showEvent(event)
        self._show_state()

    def _on_recorder(self) -> None:
        if self.isVisible():
            self._show_state()

    def _on_operating_state(self, _operating_state: OperatingState) -> None:
        if self.isVisible():
            self.show_acts()

    @_record.why_not
    def _why_not_record(self) -> Refusal | None:
        if self._joining:
            return BUSY(what="recording")
        recording = self._controller.recorder.recording
        return None if recording else self._controller.operating_state.unreachable

    def _show_message(self, text: Words, level: Level = Level.INFO) -> None:
        self._message.show_message(text, level)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Trim samples") if self._is_kept else self.tr("Recording"))
        texts = (self.tr("Name"), self.tr("From"), self.tr("To"), self.tr("Tolerance"))
        for label, text in zip(self._labels, texts, strict=True):
            label.setText(text)
        self._tolerance.setToolTip(
            self.tr("How far a joint may be off where samples are left out, in degrees")
        )
        self._show_state()


def _field(name: str, decimals: int, unit: str) -> FigureField:
    field = named(name, FigureField(decimals, unit))
    field.setFixedWidth(_FIELD_PX)
    return field
