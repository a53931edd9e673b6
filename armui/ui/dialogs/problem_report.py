"""The window «Report a problem»: a report for support, seen before it is saved."""

from __future__ import annotations

import time
from collections.abc import Mapping
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QCheckBox, QFileDialog, QListWidget, QPlainTextEdit, QWidget

from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.doctor.facts import Diagnosis
from armui.doctor.judge_heard import ARM
from armui.doctor.problem_report import BUS_FILE, ReportFile, collect, doctor_files, save
from armui.doctor.process import DoctorProcess
from armui.doctor.report import as_json, as_text
from armui.system.files import size_text
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.actions.command import Command, Target
from armui.ui.background import Background, Job
from armui.ui.dialogs.adapter_line import Examination, Examine
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.doctor import with_connected
from armui.ui.dialogs.files import choose_file
from armui.ui.dialogs.finding_row import WORDS
from armui.ui.widgets.buttons import caption, enable_or_explain, named
from armui.ui.widgets.layouts import STRETCH, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label
from armui.ui.words.text import Text

_SIZE_PX: Final = (900, 640)
_LIST_WIDTH_PX: Final = 260
_SHOWN_BYTES: Final = 100_000
"""The bytes shown of either end of a large file: a text of 40 MB would hold up window and stop."""
_HANGS_MS: Final = 10_000
"""The time after which a disk that has not answered counts as hanging."""


class ProblemReportDialog(ArmDialog):
    """Collects the report at each opening; sends nothing, and writes only when asked to.

    Args:
        controller: Gives the state of the connected arm, and the last minutes of its bus.
        background: Reads logs and settings, and writes the file.
        settings: The program's file of settings.
        parent: The main window.
        examine: Begins an examination.
    """

    commands = (
        Command("report.bus", Text("ProblemReportDialog", "Add the last minutes of the bus")),
    )
    save_button = Act("Save the report…", named="report_save", key="report.save", primary=True)
    _answered = Signal(object, object)

    def __init__(
        self,
        controller: ArmController,
        background: Background,
        settings: Path,
        parent: QWidget | None = None,
        examine: Examine = DoctorProcess,
    ) -> None:
        super().__init__(controller, parent)
        self._background = background
        self._settings = settings
        self._examine = examine
        self._under_way: Examination | None = None
        self._began = (0.0, 0)
        self._number = 0
        self._files: tuple[ReportFile, ...] = ()
        self._bus: ReportFile | None = None
        self._collecting = False
        self._bus_job: Job[bytes] | None = None
        self._saving: Job[Path | Refusal] | None = None
        self._hangs = False
        self._build()
        self.resize(*_SIZE_PX)
        # queued, for an answer may come while the examination is being begun
        self._answered.connect(self._on_answered, Qt.ConnectionType.QueuedConnection)
        self.list.currentRowChanged.connect(self._show_file)
        self.bus_box.clicked.connect(self._on_bus)
        self._late = QTimer(self, singleShot=True, interval=_HANGS_MS)
        self._late.timeout.connect(self._on_late)
        self.retranslate_ui()

    def command_targets(self) -> Mapping[str, Target]:
        """Return what carries out each command, by the command's name."""
        return {**super().command_targets(), "report.bus": self.bus_box}

    # Layout -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self._note = text_label(rank="muted", wraps=True, plain=True)
        self._message = named("report_message", MessageLine())
        self.bus_box = named("report_bus", QCheckBox())
        self.list = named("report_files", QListWidget())
        self.list.setFixedWidth(_LIST_WIDTH_PX)
        self.text = named("report_text", QPlainTextEdit(readOnly=True))
        self.text.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        shown = in_row(self.list, (self.text, 1), spacing=12)
        fill(self.body, self._note, self.bus_box, (shown, 1), self._message)
        fill(self.footer, STRETCH, self.save_button, CloseButton(self))

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Report a problem"))
        self._note.setText(
            self.tr(
                "These files are put into one zip file on this computer: look at each before. "
                "Nothing is sent anywhere; you give the file to whoever helps. The folder of your "
                "user is called ~ in it; serial numbers of adapters stay."
            )
        )
        caption(self.bus_box, self.tr("Add the last minutes of the bus"))
        self.list.setAccessibleName(self.tr("Files of the report"))
        self.text.setAccessibleName(self.tr("The file that is chosen"))
        self._refresh()

    # What the operator does -------------------------------------------------------------------

    def open(self) -> None:
        """Show the dialog and collect anew."""
        super().open()
        self.collect()

    def collect(self) -> None:
        """Examine as the diagnosis does, then read logs and settings."""
        self._end()
        self._number += 1
        number = self._number
        self._files, self._bus = (), None
        self.bus_box.setChecked(False)
        self._collecting = True
        self._began = (time.monotonic(), self._controller.state.frames)
        self._message.show_message(self.tr("Looking at this computer, logs and settings…"))
        # the examination must not open an adapter in use: one of the two would lose it
        connected = self._controller.operating_state.device is not None
        self._under_way = self._examine(
            ["--no-listen"] if connected else [], lambda answer: self._answered.emit(number, answer)
        )
        self._refresh()

    def _on_bus(self) -> None:
        if self._bus_job is not None:
            self._bus_job.wanted, self._bus_job = False, None
        self._bus = None
        write = self._controller.sessions.ring_as_text() if self.bus_box.isChecked() else None
        if write is not None:
            self._bus_job = Job(self._on_bus_written)
            self._background.begin_here(self._bus_job, write)
        self._refresh()

    @save_button.pressed
    def _on_save(self) -> None:
        now = datetime.now().astimezone()
        chooser = choose_file(
            self,
            self._controller,
            title=self.tr("Save the report"),
            name_filter="ZIP (*.zip)",
            on_chosen=self._on_chosen,
            new_file=f"armui-report-{now:%Y%m%d-%H%M%S}.zip",
        )
        # an existing file is never replaced: saving reports it, so Qt need not ask
        chooser.setOption(QFileDialog.Option.DontConfirmOverwrite)

    def _on_chosen(self, path: Path) -> None:
        if self._saving is not None:
            self._saving.wanted = False
        self._saving = Job(self._on_saved)
        self._message.show_message(self.tr("Saving {path}…").format(path=path))
        self._hangs = False
        self._late.start()
        self._background.begin_here(self._saving, save, path, self.files())
        self._refresh()

    # Results of background work ---------------------------------------------------------------

    def files(self) -> tuple[ReportFile, ...]:
        """Return what is in the report now."""
        return self._files if self._bus is None else (*self._files, self._bus)

    def _on_answered(self, number: int, answer: list[Diagnosis] | str) -> None:
        if number != self._number:
            return
        self._under_way = None
        if isinstance(answer, str):
            found = [ReportFile("doctor.txt", f"{answer}\n".encode())]
        else:
            begun_s, frames = self._began
            findings = with_connected(self._controller, answer, frames=frames, begun_s=begun_s)
            answers = any(each.kind == ARM for each in findings)
            found = doctor_files(
                *(
                    render(findings, WORDS, arm_answers=answers, asked=False)
                    for render in (as_text, as_json)
                )
            )
        job: Job[tuple[ReportFile, ...]] = Job(lambda files: self._on_collected(number, files))
        self._background.begin_here(job, collect, found, self._settings)

    def _on_collected(self, number: int, files: tuple[ReportFile, ...] | Refusal) -> None:
        if number != self._number:
            return
        self._collecting = False
        if isinstance(files, Refusal):
            self._message.show_message(partial(words.refusal, files), Level.FAULT)
        else:
            self._files = files
            self._message.show_message("")
        self._refresh()

    def _on_bus_written(self, data: bytes | Refusal) -> None:
        self._bus_job = None
        if isinstance(data, Refusal):
            self.bus_box.setChecked(False)
            self._message.show_message(partial(words.refusal, data), Level.FAULT)
        else:
            self._bus = ReportFile(BUS_FILE, data)
        self._refresh()

    def _on_saved(self, saved: Path | Refusal) -> None:
        self._late.stop()
        self._saving = None
        if isinstance(saved, Refusal):
            self._message.show_message(partial(words.refusal, saved), Level.FAULT)
        else:
            said = self.tr("Saved: {path}").format(path=saved)
            self._message.show_message(said, Level.DONE)
        self._refresh()

    def _on_late(self) -> None:
        """Say that the disk does not answer, so that the report can be saved in another folder."""
        said = self.tr("The disk does not answer. Save the report in another folder.")
        self._message.show_message(said, Level.FAULT)
        self._hangs = True
        self._refresh()

    # Appearance -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        files = self.files()
        labels = [f"{each.name}  ({size_text(len(each.data))})" for each in files]
        if labels != [self.list.item(row).text() for row in range(self.list.count())]:
            row = max(0, self.list.currentRow())
            self.list.clear()
            self.list.addItems(labels)
            self.list.setCurrentRow(min(row, len(labels) - 1))
            self._show_file(self.list.currentRow())
        self.show_acts()
        heard = self._controller.sessions.ring().frames
        nothing = "" if heard else self.tr("Nothing was heard on a bus.")
        enable_or_explain(self.bus_box, nothing)

    @save_button.why_not
    def _why_not_save(self) -> str:
        if self._collecting:
            return self.tr("The report is being collected.")
        if self._bus_job is not None:
            return self.tr("The frames are being written down.")
        if self._saving is not None and not self._hangs:
            return self.tr("The report is being saved.")
        return "" if self._files else self.tr("There is nothing to save.")

    def _show_file(self, row: int) -> None:
        files = self.files()
        self.text.setPlainText(self._shown(files[row].data) if 0 <= row < len(files) else "")

    def _shown(self, data: bytes) -> str:
        left_out = len(data) - 2 * _SHOWN_BYTES
        if left_out <= 0:
            return data.decode("utf-8", "replace")
        between = self.tr("… {size} are not shown here …").format(size=size_text(left_out))
        first = data[:_SHOWN_BYTES].decode("utf-8", "replace")
        return f"{first}\n\n{between}\n\n{data[-_SHOWN_BYTES:].decode('utf-8', 'replace')}"

    # Closing ----------------------------------------------------------------------------------

    def reject(self) -> None:
        """Close by Escape, button or frame; a report that is being saved is saved."""
        self._end()
        super().reject()

    def _end(self) -> None:
        self._number += 1
        if self._bus_job is not None:
            self._bus_job.wanted, self._bus_job = False, None
        if self._under_way is not None:
            self._under_way.end()
            self._under_way = None
