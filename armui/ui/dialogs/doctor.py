"""The window 诊断: faults of this computer, the bus and the arm, with their remedies."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, Final

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QProgressBar, QWidget

from armui.arm.device import Device
from armui.arm.models import model_data
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.link.link_state import LinkState
from armui.doctor.facts import Diagnosis, DiagnosisLevel, HeardFacts, Section
from armui.doctor.hearing import arm_facts
from armui.doctor.judge_heard import ARM, OTHER_HOST, judge_heard
from armui.doctor.process import DoctorProcess
from armui.doctor.report import as_text
from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.ui.actions.act import Act
from armui.ui.dialogs.adapter_line import AdapterLine, Examination, Examine
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.finding_row import WORDS, FindingRow
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import STRETCH, bare_area, fill, in_column
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label

_SIZE_PX: Final = (860, 640)
_GAP_PX: Final = 12
_AT_ONCE: Final = 8


def judge_connected(controller: ArmController, *, frames: int, seconds: float) -> list[Diagnosis]:
    """Return the findings on the arm on the open device; none if no device is open.

    Args:
        controller: Gives the arm's state.
        frames: The number of frames received while listening.
        seconds: The time of listening.
    """
    now = controller.operating_state
    if now.device is None:
        return []
    generation = now.generation or Generation.TWO
    online = now.link is LinkState.ONLINE
    arm = arm_facts(
        controller.state,
        Codec(generation, now.addressing),
        reason="",
        frames_per_s=frames / seconds if seconds > 0 else 0.0,
        firmware=controller.state.firmware,
    )
    arm = replace(arm, chosen_model=model_data(now.model).name)
    heard = HeardFacts(
        interface=now.device.interface,
        channel=str(now.device.channel),
        seconds=seconds,
        frames=frames,
        arm=arm if online else None,
        problem="" if now.link_problem is None else now.link_problem.code,
        problem_text="" if now.link_problem is None else str(now.link_problem.params),
        leader=now.teaching_input,
    )
    findings = judge_heard(heard)
    if now.other_host is not None and not now.teaching_input:
        findings.append(OTHER_HOST(device=now.device.name, frames=now.other_host.frames))
    return findings


def with_connected(
    controller: ArmController, findings: list[Diagnosis], *, frames: int, begun_s: float
) -> list[Diagnosis]:
    """Replace the findings on arms by those on the arm on the open device, if there is one.

    Args:
        controller: Gives the state of the connected arm.
        findings: Those of an examination, which does not listen to an open device.
        frames: The number of frames received before it began.
        begun_s: The time at which it began, by `time.monotonic`.
    """
    seconds = time.monotonic() - begun_s
    heard = max(0, controller.state.frames - frames)
    connected = judge_connected(controller, frames=heard, seconds=seconds)
    if connected:
        findings = [each for each in findings if each.section is not Section.ARM]
    return [*findings, *connected]


class DoctorDialog(ArmDialog):
    """Examines at each opening, in a process of its own; an open device is not disturbed.

    Args:
        controller: Gives the state of the connected arm.
        parent: The main window.
        examine: Starts an examination.
        adapter: Sets an adapter up by a click.

    Signals:
        report_wanted: The operator wants to report a problem.
    """

    copy_button = Act("Copy report", named="doctor_copy", key="doctor.copy")
    report_button = Act("Report a problem…", named="doctor_report")
    again_button = Act("Run again", named="doctor_again", key="doctor.again")
    report_wanted = Signal()
    _answered = Signal(object, object)

    def __init__(
        self,
        controller: ArmController,
        parent: QWidget | None = None,
        examine: Examine = DoctorProcess,
        adapter: AdapterLine | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._adapter = adapter or AdapterLine(controller)
        self._adapter.listens_elsewhere = self._listens_to
        self._examine = examine
        self._device: Device | None = None
        self._under_way: Examination | None = None
        self._number = 0
        self._began = (0.0, 0)
        self._answer: list[Diagnosis] | str | None = None
        self._rows: list[Callable[[], QWidget]] = []
        self._build()
        self.resize(*_SIZE_PX)
        self._adapter.changed.connect(self._on_adapter_changed)
        # queued, for an answer may come while the examination is being begun
        self._answered.connect(self._on_answered, Qt.ConnectionType.QueuedConnection)
        self.retranslate_ui()

    # Layout -----------------------------------------------------------------------------------

    def _build(self) -> None:
        self._message = named("doctor_message", MessageLine())
        self._progress = QProgressBar(maximum=0, textVisible=False)
        self._note = text_label(rank="muted", wraps=True, plain=True)
        self._area = named("doctor_findings", bare_area())
        self.close_button = CloseButton(self)
        self.close_button.setDefault(True)
        shown = (self._message, self._progress, self._adapter, (self._area, 1), self._note)
        fill(self.body, *shown)
        kept = (self.copy_button, self.report_button)
        fill(self.footer, *kept, STRETCH, self.again_button, self.close_button)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Diagnosis"))
        self._note.setText(
            self.tr("Only looked and listened: nothing was sent. In a terminal: armui doctor")
        )
        self._refresh()

    # What the operator does -------------------------------------------------------------------

    def examine_device(self, device: Device | None) -> None:
        """Open the dialog for a device that could not be connected, or for all with ``None``."""
        self._device = device
        self.open()

    def open(self) -> None:
        """Show the dialog and examine."""
        super().open()
        self.examine()

    @again_button.pressed
    def examine(self) -> None:
        """Start the examination again."""
        self._end()
        self._number += 1
        number = self._number
        self._answer = None
        self._began = (time.monotonic(), self._controller.state.frames)
        self._under_way = self._examine(
            self._arguments(), lambda answer: self._answered.emit(number, answer)
        )
        self._refresh()

    def _arguments(self) -> list[str]:
        if self._controller.operating_state.device is not None:
            return ["--no-listen"]  # two programs on one adapter: one of them would lose it
        device = self._device
        if device is None or device.simulated:
            return []
        bitrate = [] if device.bitrate is None else ["--bitrate", str(device.bitrate)]
        return ["--interface", device.interface, "--channel", str(device.channel), *bitrate]

    def _listens_to(self, interface: str) -> bool:
        """Return whether an examination that begins now listens to an interface."""
        if self._controller.operating_state.device is not None or not self.isVisible():
            return False
        device = self._device
        return device is None or device.simulated or str(device.channel) == interface

    def _on_adapter_changed(self) -> None:
        if self.isVisible():
            self.examine()

    @report_button.pressed
    def _on_report(self) -> None:
        self.report_wanted.emit()

    @copy_button.pressed
    def _on_copy(self) -> None:
        QGuiApplication.clipboard().setText(self.report())

    def report(self) -> str:
        """Return the report as text, for a support mail."""
        findings = self._findings()
        answers = any(each.kind == ARM for each in findings)
        return as_text(findings, WORDS, arm_answers=answers, asked=False)

    # Results of background work ---------------------------------------------------------------

    def _on_answered(self, number: int, answer: Any) -> None:
        if number != self._number:
            return
        self._under_way = None
        self._answer = answer
        if not isinstance(answer, str):
            begun_s, frames = self._began
            self._answer = with_connected(self._controller, answer, frames=frames, begun_s=begun_s)
        self._adapter.show_heard(self._answer)
        self._refresh()

    def _findings(self) -> list[Diagnosis]:
        return self._answer if isinstance(self._answer, list) else []

    def _refresh(self) -> None:
        waiting = self._under_way is not None
        self._progress.setVisible(waiting)
        self.show_acts()
        self._refresh_message(waiting=waiting)
        self._refresh_rows()

    @again_button.why_not
    def _why_not_again(self) -> str:
        return "" if self._under_way is None else self.tr("The diagnosis is running.")

    @copy_button.why_not
    def _why_not_copy(self) -> str:
        nothing = "" if self._findings() else self.tr("There is no report yet.")
        return self._why_not_again() or nothing

    def _refresh_message(self, *, waiting: bool) -> None:
        if waiting:
            self._message.show_message(
                self.tr("Looking at this computer, its CAN devices and the bus…")
            )
            return
        if isinstance(self._answer, str):
            text = self.tr("The diagnosis failed: {text}").format(text=self._answer)
            self._message.show_message(text, Level.FAULT)
            return
        levels = [each.severity for each in self._findings()]
        faults, warnings = levels.count(DiagnosisLevel.FAULT), levels.count(DiagnosisLevel.WARNING)
        if faults or warnings:
            text = self.tr("Faults: {faults}, warnings: {warnings}").format(
                faults=faults, warnings=warnings
            )
            level = Level.FAULT if faults else Level.WARNING
            self._message.show_message(text, level)
        elif levels:
            self._message.show_message(self.tr("No fault was found."), Level.DONE)
        else:
            self._message.show_message("")

    def _refresh_rows(self) -> None:
        self._rows = []
        for section in Section:
            findings = [each for each in self._findings() if each.section is section]
            if findings:
                self._rows.append(partial(text_label, text=WORDS.section(section), rank="muted"))
            self._rows += [partial(FindingRow, each, self._adapter) for each in findings]
        column = QWidget()
        layout = in_column(STRETCH, on=column, spacing=_GAP_PX, margins=(0, 0, _GAP_PX, 0))
        self._column = layout
        self._add_rows()
        column.setAutoFillBackground(False)
        self._area.setWidget(column)
        self._area.viewport().setAutoFillBackground(False)

    def _add_rows(self) -> None:
        """Add some rows at a time: all at once would block the window and its stop button."""
        now, self._rows = self._rows[:_AT_ONCE], self._rows[_AT_ONCE:]
        for make in now:
            self._column.insertWidget(self._column.count() - 1, make())
        if self._rows:
            QTimer.singleShot(0, self, self._add_rows)

    # Closing ----------------------------------------------------------------------------------

    def reject(self) -> None:
        """Cancel the examination and close, by Escape, the button or the frame."""
        self._end()
        self._adapter.end()
        self._refresh()
        super().reject()

    def _end(self) -> None:
        self._number += 1
        if self._under_way is not None:
            self._under_way.end()
            self._under_way = None
