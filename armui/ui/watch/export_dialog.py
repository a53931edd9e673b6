"""The window 导出: a recorded log as MCAP, CSV or Parquet."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Protocol

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, Qt, Signal
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QLabel,
    QLineEdit,
    QWidget,
)

from armui.arm.models import all_models
from armui.arm.refusal import Reason, Refusal
from armui.control.events import Level
from armui.export.process import ExportDone, ExportProcess
from armui.protocol.generation import Generation
from armui.session.exports.request import (
    ArmOptions,
    ExportFormat,
    ExportProblem,
    ExportProgress,
    ExportRequest,
    default_target,
)
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.dialogs.base import ArmDialog
from armui.ui.dialogs.confirm_dialog import confirm
from armui.ui.dialogs.files import choose_file, choose_folder
from armui.ui.widgets.buttons import choice_group, named, push_button
from armui.ui.widgets.figure_field import FigureField
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.progress import quiet_progress
from armui.ui.widgets.text_label import ElidedLabel, text_label
from armui.ui.widgets.translated import Translated
from armui.ui.words.text import Texts, joined

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


_SIZE_PX: Final = (780, 560)
_STEPS: Final = 1000
_FIELD_PX: Final = 130
_FORMATS: Final = {
    ExportFormat.MCAP: "MCAP",
    ExportFormat.CSV: "CSV",
    ExportFormat.PARQUET: "Parquet",
    ExportFormat.CSV_MESSAGES: QT_TRANSLATE_NOOP("ExportForm", "CSV per message"),
    ExportFormat.LEROBOT: "LeRobot",
}
_ABOUT: Final = Texts("ExportDialog") | {
    ExportFormat.MCAP: "ROS 2 messages: joint states, targets, end pose, transforms of the links, "
    "diagnostics. For Foxglove, PlotJuggler, rerun and ROS 2 itself.",
    ExportFormat.CSV: "A table as text: a row for each set of joint angles, all else as last heard "
    "then. For spreadsheets and scripts.",
    ExportFormat.PARQUET: "The same table with types and units, small and quick to open. For "
    "pandas and the like; needs the package pyarrow.",
    ExportFormat.CSV_MESSAGES: "A folder with a file for each message: every frame with its time, "
    "decoded into signals with their units.",
    ExportFormat.LEROBOT: "A dataset to learn from: the marked episodes at 30 frames a second, "
    "without images. What is left out is said. For LeRobot 0.6; needs the package pyarrow.",
}
"""The content of a format, and the programs that open it."""
_PROBLEMS: Final = Texts("ExportDialog") | {
    None: "The export failed: {detail}",
    ExportProblem.NO_LOG: "The log cannot be read: {detail}",
    ExportProblem.NO_CHANNEL: "The log has no such channel. It has: {detail}",
    ExportProblem.NO_FRAMES: "The log has no frames. No file was written.",
    ExportProblem.NO_ARM: "No frame of the log is an arm's. No file was written. Another channel?",
    ExportProblem.NO_ANGLES: "A table has a row for each set of joint angles, and none was heard. "
    "No file was written. MCAP holds what else there is.",
    ExportProblem.NOTHING_THEN: "Nothing was heard in this time. No file was written.",
    ExportProblem.EXISTS: "{target} exists already.",
    ExportProblem.SAME_FILE: "The target is the log itself. Choose another name.",
    ExportProblem.CANNOT_WRITE: "{target} cannot be written: {detail}",
    ExportProblem.NO_PYARROW: "Parquet needs the package pyarrow: pip install 'armui[parquet]'. "
    "CSV has the same table without it.",
    ExportProblem.NO_EPISODE: "In no second of it were the angles heard and the arm without a "
    "fault. No dataset was written.",
}
"""Why nothing was written, with the remedy."""
_LOGS: Final = "*.blf *.log *.asc *.trc *.csv *.db *.txt *.gz"
_GENERATIONS: Final = (None, Generation.ONE, Generation.TWO)
_BELOW_FORMATS: Final = 2
"""The row with the description of the chosen format."""


def finished_text(report: dict[str, Any], export_format: ExportFormat, target: Path) -> str:
    """Return the text on a finished export: what was written, and where."""
    text = QCoreApplication.translate("ExportDialog", "Saved: {target} ({items:,} rows)")
    if export_format is ExportFormat.MCAP:
        text = QCoreApplication.translate("ExportDialog", "Saved: {target} ({items:,} messages)")
    elif export_format is ExportFormat.LEROBOT:
        text = QCoreApplication.translate("ExportDialog", "Saved: {target} ({items:,} frames)")
    return text.format(target=target, items=report["items"])


def remarks_text(report: dict[str, Any]) -> list[str]:
    """Return remarks on an export, a line each, the damaged places first."""
    translate = QCoreApplication.translate
    lines = []
    if report["damage_count"]:
        first = report["damages"][0]
        text = translate(
            "ExportDialog",
            "Unreadable places in the log: {count}; the first: {place} ({reason}). "
            "Everything else was exported.",
        )
        lines.append(text.format(count=report["damage_count"], place=first[0], reason=first[1]))
    notes = [Refusal(Reason(**note["reason"]), note["params"]) for note in report["notes"]]
    lines += map(words.refusal, notes)
    if report["of_other_channels"]:
        text = translate(
            "ExportDialog",
            "Only channel {channel} was exported; {count:,} frames of {others} were left out.",
        )
        others = fmt.listed(report["other_channels"])
        lines.append(
            text.format(channel=report["channel"], count=report["of_other_channels"], others=others)
        )
    if report["pose_fits"]:
        text = translate(
            "ExportDialog", "Exported as a {model}, but the end pose in the log fits a {fits}."
        )
        lines.append(text.format(model=report["model"], fits=report["pose_fits"]))
    text = translate("ExportDialog", "{frames:,} frames read as generation {generation}, {model}.")
    line = text.format(
        frames=report["frames"], generation=report["generation"], model=report["model"]
    )
    if report["not_understood"]:
        text = translate("ExportDialog", "{count:,} of them do not belong to the arm.")
        line = joined(line, text.format(count=report["not_understood"]))
    if report["questions"]:
        text = translate("ExportDialog", "{count:,} are questions of this program or another host.")
        line = joined(line, text.format(count=report["questions"]))
    lines.append(line)
    return lines


class ExportForm(Translated, QWidget):
    """The fields of the export.

    Args:
        controller: For the emergency stop in the file choosers.

    Signals:
        changed: Something was entered or chosen.
    """

    changed = Signal()

    def __init__(self, controller: ArmController) -> None:
        super().__init__()
        self._controller = controller
        self._log: Path | None = None
        self._target: Path | None = None
        self._target_chosen = False
        self._build()
        self.log_button.clicked.connect(self._on_choose_log)
        self.target_button.clicked.connect(self._on_choose_target)
        self.formats.idClicked.connect(self._on_format)
        self.begin_field.value_edited.connect(self.changed)
        self.end_field.value_edited.connect(self.changed)
        self.retranslate_ui()

    def _build(self) -> None:
        self._labels = [QLabel() for _row in range(7)]
        self._log_label = named("export_log", ElidedLabel())
        self._target_label = named("export_target", ElidedLabel())
        self.log_button, self.target_button = (push_button(on_enter=False) for _ in range(2))
        self.formats = choice_group(self, (f"format_{each}" for each in ExportFormat))
        generations = ("generation_auto", "generation_1", "generation_2")
        self.generations = choice_group(self, generations)
        self.model_box = QComboBox()
        self.model_box.addItem("", None)
        for model, data in all_models().items():
            self.model_box.addItem(data.name, model)
        self._about = text_label("export_about", rank="muted", wraps=True, plain=True)
        self.begin_field, self.end_field = FigureField(3, "s"), FigureField(3, "s")
        self._until = QLabel()
        for field in (self.begin_field, self.end_field):
            field.setFixedWidth(_FIELD_PX)
        self._counted_from = text_label(rank="muted")
        stretch = QWidget()
        times = (self.begin_field, self._until, self.end_field, self._counted_from, STRETCH)
        in_row(*times, on=stretch, margins=0)
        self.channel_field = QLineEdit()
        self.channel_field.setFixedHeight(32)
        grid = empty_grid(self, gaps=(14, 10), margins=0)
        grid.setColumnStretch(1, 1)
        rows = (
            *(self._log_label, _in_line(self.formats), stretch, _in_line(self.generations)),
            *(self.model_box, self.channel_field, self._target_label),
        )
        for row, (label, content) in enumerate(zip(self._labels, rows, strict=True)):
            place = row if row < _BELOW_FORMATS else row + 1
            grid.addWidget(label, place, 0)
            # the buttons stand beside the two files; all else has the whole width
            width = 1 if content in {self._log_label, self._target_label} else 2
            grid.addWidget(content, place, 1, 1, width)
        grid.addWidget(self.log_button, 0, 2)
        grid.addWidget(self._about, _BELOW_FORMATS, 1, 1, 2)
        grid.addWidget(self.target_button, len(rows), 2)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        texts = (
            self.tr("Log"),
            self.tr("Format"),
            self.tr("Time"),
            self.tr("Protocol"),
            self.tr("Model"),
            self.tr("Channel"),
            self.tr("Target"),
        )
        for label, text in zip(self._labels, texts, strict=True):
            label.setText(text)
        for button in (self.log_button, self.target_button):
            button.setText(self.tr("Choose…"))
        self.log_button.setAccessibleName(self.tr("Choose the log"))
        self.target_button.setAccessibleName(self.tr("Choose the target"))
        for place, each in enumerate(ExportFormat):
            self.formats.button(place).setText(self.tr(str(_FORMATS[each])))
        names = (self.tr("As found in the log"), self.tr("Generation 1"), self.tr("Generation 2"))
        for place, name in enumerate(names):
            self.generations.button(place).setText(name)
        self.model_box.setItemText(0, self.tr("As in the log"))
        self.model_box.setAccessibleName(self.tr("Model"))
        self.model_box.setToolTip(
            self.tr(
                "Where the links and the tool are depends on it. A log of this program says "
                "it; of other logs it is the one that fits the end pose in them."
            )
        )
        self._until.setText(self.tr("to"))
        self._counted_from.setText(self.tr("counted from the first frame"))
        self.begin_field.setPlaceholderText(self.tr("beginning"))
        self.end_field.setPlaceholderText(self.tr("end"))
        self.begin_field.setAccessibleName(self.tr("From, in seconds from the first frame"))
        self.end_field.setAccessibleName(self.tr("Up to, in seconds from the first frame"))
        self.channel_field.setPlaceholderText(self.tr("the one on which an arm is heard"))
        self.channel_field.setAccessibleName(self.tr("Channel"))
        self._show_paths()

    # What is entered --------------------------------------------------------------------------

    @property
    def format(self) -> ExportFormat:
        """The chosen format."""
        return tuple(ExportFormat)[self.formats.checkedId()]

    def show_log(self, path: Path) -> None:
        """Set the log; the target is proposed beside it."""
        self._log = path
        self._target_chosen = False
        self._propose_target()

    def show_target(self, path: Path) -> None:
        """Set the file to be written; another log does not replace it by a proposal."""
        self._target, self._target_chosen = path, True
        self._show_paths()
        self.changed.emit()

    def reason(self) -> str:
        """Return why the export is not possible; empty if it is."""
        if self._log is None:
            return self.tr("Choose the log first.")
        begin_s, end_s = self.begin_field.value or 0.0, self.end_field.value
        wrong = self.begin_field.is_nonsense() or self.end_field.is_nonsense()
        if wrong or begin_s < 0 or (end_s is not None and end_s <= begin_s):
            return self.tr("The time must begin at 0 s or later, and end after that.")
        return ""

    def has_log(self) -> bool:
        """Return whether a recording is chosen."""
        return self._log is not None

    def request(self) -> ExportRequest | None:
        """Return the request, or ``None`` if something is missing or wrong."""
        if self._log is None or self._target is None or self.reason():
            return None
        end_s = self.end_field.value
        wishes = ArmOptions(
            _GENERATIONS[self.generations.checkedId()],
            channel=self.channel_field.text().strip() or None,
            model=self.model_box.currentData(),
        )
        begin_s = self.begin_field.value or 0.0
        end_s = math.inf if end_s is None else end_s
        return ExportRequest(self._log, self._target, self.format, begin_s, end_s, wishes)

    # What the operator does -------------------------------------------------------------------

    def _on_choose_log(self) -> None:
        choose_file(
            self,
            self._controller,
            title=self.tr("Choose the log"),
            name_filter=self.tr("CAN log") + f" ({_LOGS})",
            start=self._log,
            on_chosen=self.show_log,
        )

    def _on_choose_target(self) -> None:
        proposed = self._target or self.format.named(Path.home() / "recording")
        if self.format.is_folder:
            choose_folder(
                self._controller,
                self.window(),
                title=self.tr("Choose where to put the folder of the export"),
                start=proposed.parent,
                on_chosen=lambda folder: self.show_target(folder / proposed.name),
            )
            return
        choose_file(
            self,
            self._controller,
            title=self.tr("Choose the target"),
            name_filter=f"{_FORMATS[self.format]} (*.{self.format})",
            start=proposed,
            new_file=proposed.name,
            on_chosen=self.show_target,
        )

    def _on_format(self) -> None:
        if self._target is not None and self._target_chosen:
            self._target = self.format.named(self._target)
            self._show_paths()
            self.changed.emit()
        else:
            self._propose_target()

    def _propose_target(self) -> None:
        if self._log is not None:
            self._target = default_target(self._log, self.format)
        self._show_paths()
        self.changed.emit()

    def _show_paths(self) -> None:
        self._log_label.show_text(str(self._log or self.tr("none chosen")))
        self._target_label.show_text(str(self._target or self.tr("beside the log")))
        self._about.setText(_ABOUT.text(self.format))


def _in_line(group: QButtonGroup) -> QWidget:
    row = QWidget()
    in_row(*((button, 1) for button in group.buttons()), on=row, spacing=6, margins=0)
    return row


class RunningExport(Protocol):
    """An export in progress."""

    def end(self) -> None:
        """End the export; nothing remains of it."""


BeginExport = Callable[
    [ExportRequest, Callable[[ExportProgress | ExportDone], object]], RunningExport
]
"""Starts an export; see :class:`armui.export.process.ExportProcess`."""


class ExportDialog(ArmDialog):
    """The choice of a log, a format, a stretch of time and a target.

    The export runs in a process of its own. Closing the dialog cancels it.

    Args:
        controller: Receives the emergency stop.
        parent: The main window.
        begin: Starts an export.
    """

    export_button = Act("Export", named="export_button", primary=True)
    close_button = Act("Close", named="export_close")
    _answered = Signal(int, object)

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        begin: BeginExport = ExportProcess,
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._begin = begin
        self._under_way: RunningExport | None = None
        self._request: ExportRequest | None = None
        self._number = 0
        self._progress = ExportProgress(None, 0)
        self._done: ExportDone | None = None
        self._cancelled = False
        self._build()
        self.form.changed.connect(self._on_changed)
        # queued, for an answer comes in another thread
        self._answered.connect(self._on_answered, Qt.ConnectionType.QueuedConnection)
        self.resize(*_SIZE_PX)
        self.retranslate_ui()

    # Layout -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self.form = ExportForm(self._controller)
        self._message = named("export_message", MessageLine())
        self._remarks = text_label("export_remarks", rank="muted", wraps=True, plain=True)
        self.progress = quiet_progress()
        fill(self.body, self.form, STRETCH, self._message, self._remarks, self.progress)
        fill(self.footer, STRETCH, self.export_button, self.close_button)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Export a log"))
        self._refresh()

    # What the operator does -------------------------------------------------------------------

    def open(self) -> None:
        """Show the dialog, and focus the choice of the recording."""
        super().open()
        self.form.log_button.setFocus()

    def show_log(self, path: Path) -> None:
        """Set the recording, unless an export is running."""
        if self._under_way is None:
            self.form.show_log(path)

    def _on_changed(self) -> None:
        if self._under_way is None:
            self._done, self._cancelled = None, False
            self._refresh()

    @export_button.pressed
    def _on_export(self) -> None:
        request = self.form.request()
        if request is not None and self._under_way is None:
            self._run(request)

    def _run(self, request: ExportRequest) -> None:
        self._end()
        number = self._number
        self._request = request
        self._done, self._cancelled = None, False
        self._progress = ExportProgress(None, 0)
        self._under_way = self._begin(request, lambda said: self._answered.emit(number, said))
        self._refresh()

    @close_button.pressed
    def _on_close(self) -> None:
        if self._under_way is None:
            self.close()
        else:
            self._cancel()

    def _cancel(self) -> None:
        self._end()
        self._cancelled = True
        self._refresh()

    def _ask_to_replace(self, request: ExportRequest) -> None:
        text = self.tr("{target} exists already. It is replaced once the export is complete.")
        confirm(
            self,
            self._controller,
            title=self.tr("Replace the file?"),
            text=text.format(target=request.target),
            action_label=self.tr("Replace"),
            on_confirmed=partial(self._run, replace(request, replace=True)),
            concerns_arm=False,
        )

    # Results of background work ---------------------------------------------------------------

    def _on_answered(self, number: int, said: Any) -> None:
        if number != self._number:
            return
        if isinstance(said, ExportProgress):
            self._progress = said
            self._refresh_progress()
            return
        self._under_way = None
        self._done = said
        self._refresh()
        if said.problem is ExportProblem.EXISTS and self._request is not None:
            self._ask_to_replace(self._request)

    def _refresh(self) -> None:
        running = self._under_way is not None
        self.show_acts()
        self.form.setEnabled(not running)
        self.progress.setVisible(running)
        self._refresh_message()
        self._refresh_progress()

    @export_button.why_not
    def _why_not_export(self) -> str:
        return self.tr("An export is under way.") if self._under_way else self.form.reason()

    @close_button.text
    def _close_text(self) -> str:
        return self.tr("Cancel the export") if self._under_way else self.tr("Close")

    def _refresh_message(self) -> None:
        done, request = self._done, self._request
        remarks: list[str] = []
        if self._cancelled:
            text = self.tr("The export was cancelled; nothing was written.")
            self._message.show_message(text, Level.WARNING)
        elif done is None or request is None:
            reason = self.form.reason() if self.form.has_log() else ""
            self._message.show_message(reason, Level.WARNING if reason else Level.INFO)
        elif done.report is None:
            text = _PROBLEMS.entry(done.problem).text()
            text = text.format(detail=done.detail, target=request.target)
            self._message.show_message(text, Level.FAULT)
        else:
            text = finished_text(done.report, request.format, request.target)
            level = Level.WARNING if done.report["damage_count"] else Level.DONE
            self._message.show_message(text, level)
            remarks = remarks_text(done.report)
        self._remarks.setText("\n".join(remarks))

    def _refresh_progress(self) -> None:
        if self._under_way is None:
            return
        done = self._progress.done
        self.progress.setRange(0, 0 if done is None else _STEPS)
        if done is not None:
            self.progress.setValue(round(done * _STEPS))
        text = self.tr("Exporting… {frames:,} frames read")
        self._message.show_message(text.format(frames=self._progress.frames))

    # Closing ----------------------------------------------------------------------------------

    def reject(self) -> None:
        """Cancel a running export, and close, by Escape or the frame."""
        if self._under_way is not None:
            self._cancel()
        super().reject()

    def _end(self) -> None:
        """End the helper, and have its late answers ignored: they bear an older number."""
        self._number += 1
        if self._under_way is not None:
            self._under_way.end()
            self._under_way = None
