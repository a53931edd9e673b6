"""The window of the joint inspection: room for the swings, the swings, the report."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import Qt
from PySide6.QtGui import QFont, QHideEvent, QShowEvent
from PySide6.QtWidgets import QFrame, QLabel, QTextBrowser, QWidget

from armui.arm.limits import JOINTS
from armui.control.events import Level
from armui.control.operations.started import refusal_of
from armui.control.run.inspection import AMPLITUDE, USUAL_DEG, Inspection
from armui.control.run.player import why_not_run
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.files import FileExport
from armui.ui.theme import colors_of
from armui.ui.widgets.buttons import named, spin_box
from armui.ui.widgets.layouts import STRETCH, empty_grid, fill, in_row
from armui.ui.widgets.message_line import MessageLine
from armui.ui.widgets.text_label import text_label

if TYPE_CHECKING:
    from pathlib import Path

    from armui.arm.refusal import Refusal
    from armui.control.arm_controller import ArmController
    from armui.control.run.inspection import InspectionReport
    from armui.ui.background import Background

_SIZE_PX: Final = (780, 720)
_STEP_DEG: Final = 5
_REPORT_PX: Final = 600


class ReportExport(FileExport):
    """Saves the report as a page to print."""

    def save(self, report: InspectionReport, arm: list[str], font: QFont) -> None:
        """Let the operator choose the file, and write it in another thread."""
        write = partial(self._write, report, arm, font)
        self._choose(self.tr("Save the report"), "inspection", "pdf", write)

    def _write(self, report: InspectionReport, arm: list[str], font: QFont, path: Path) -> None:
        from armui.ui.dialogs.inspection_report import write_pdf  # noqa: PLC0415 - numpy

        self._background.begin_here(self._job(path), write_pdf, report, arm, font, path)


class InspectionDialog(ArmDialog):
    """Shows how far each joint may swing, has them swing, and shows what that has found.

    Args:
        controller: Carries out the inspection.
        background: Writes the report.
        parent: The main window.
    """

    begin_button = Act(
        "Inspect",
        named="inspection_start",
        does=Inspection.start,
        key="inspection.start",
        held=True,
        primary=True,
    )
    save_button = Act("Save report…", named="inspection_save", key="inspection.save")

    def __init__(
        self, controller: ArmController, background: Background, parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._refusal: Refusal | None = None
        self._shown: tuple[object, ...] = ()
        self._export = ReportExport(controller, background, self)
        self._build()
        self.resize(*_SIZE_PX)
        self._export.message_changed.connect(self._message.show_message)
        self.amplitude.valueChanged.connect(self._on_amplitude)
        controller.state_changed.connect(self._on_changed)
        controller.operating_state_changed.connect(self._on_changed)
        self.retranslate_ui()

    def _build(self) -> None:
        self._intro = text_label("inspection_intro", rank="muted", wraps=True)
        self._amplitude_label = QLabel()
        least, most = int(AMPLITUDE.minimum), int(AMPLITUDE.maximum)
        self.amplitude = named("inspection_amplitude", spin_box(least, most, "°", step=_STEP_DEG))
        self.amplitude.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.amplitude.setPrefix("±")
        self.amplitude.setValue(int(USUAL_DEG))
        self._amplitude_label.setBuddy(self.amplitude)
        self._speed = text_label("inspection_speed", rank="muted")
        self._table = QFrame()
        grid = empty_grid(self._table, gaps=(28, 6), margins=0)
        self._heads = [text_label(rank="muted") for _ in range(3)]
        for column, head in enumerate(self._heads):
            grid.addWidget(head, 0, column)
        self._labels: dict[int, tuple[QLabel, QLabel, QLabel]] = {}
        for joint in JOINTS:
            result = text_label(f"inspection_{joint}", wraps=True, plain=True)
            cells = (text_label(), text_label(f"inspection_swing_{joint}"), result)
            self._labels[joint] = cells
            for column, cell in enumerate(cells):
                grid.addWidget(cell, joint, column)
        grid.setColumnStretch(2, 1)
        grid.setRowStretch(len(JOINTS) + 1, 1)
        self.report_view = named("inspection_report", QTextBrowser())
        self.report_view.setMinimumWidth(_REPORT_PX)  # a report is as wide as its curves
        self._message = named("inspection_message", MessageLine(keeps_room=False))
        choice = in_row(self._amplitude_label, self.amplitude, self._speed, STRETCH, spacing=10)
        fill(self.body, self._intro, choice, (self._table, 1), (self.report_view, 1), self._message)
        fill(self.footer, self.begin_button, self.save_button, STRETCH, CloseButton(self))

    def showEvent(self, event: QShowEvent) -> None:
        """Begin to watch how far each joint can swing."""
        super().showEvent(event)
        if not event.spontaneous():
            self._refusal = None
            self._on_amplitude()

    def hideEvent(self, event: QHideEvent) -> None:
        """Stop watching the room; an inspection under way goes on, shown in the run's line."""
        super().hideEvent(event)
        self._controller.inspection.set_amplitude(None)

    # -- what the operator does ---------------------------------------------------------------

    def _on_amplitude(self) -> None:
        if self.isVisible():
            self._controller.inspection.set_amplitude(float(self.amplitude.value()))
            self._show()

    @begin_button.why_not
    def _why_not_begin(self) -> Refusal | None:
        inspection = self._controller.inspection
        return why_not_run(self._controller.operating_state) or inspection.why_not_ready()

    @begin_button.pressed
    def _on_begin(self) -> None:
        self._refusal = refusal_of(self._controller.inspection.start(float(self.amplitude.value())))
        self._show()

    @save_button.why_not
    def _why_not_save(self) -> str:
        report = self._controller.inspection.report
        return "" if report is not None else self.tr("There is no report yet.")

    @save_button.pressed
    def _on_save(self) -> None:
        report = self._controller.inspection.report
        if report is not None:
            self._export.save(report, self._arm(), self.font())

    # -- appearance ---------------------------------------------------------------------------

    def _on_changed(self) -> None:
        if self.isVisible():
            self._show()

    def _show(self) -> None:
        inspection, now = self._controller.inspection, self._controller.operating_state
        under_way = inspection.joint is not None
        self.amplitude.setEnabled(not now.running)
        self.show_acts()
        refusal = None if under_way else self._refusal or self._why_not_begin()
        said = words.why_not(refusal)
        if under_way:
            said = self.tr("J{joint} swings. Keep clear of the arm.").format(joint=inspection.joint)
        shows = (
            *(said, inspection.plan, inspection.joint, len(inspection.measured)),
            *(inspection.report, now.speed_percent, colors_of(self)),
        )
        if shows == self._shown:
            return
        self._shown = shows
        self._message.show_message(said, Level.WARNING if refusal is not None else Level.INFO)
        self._show_speed(now.speed_percent)
        report = None if under_way else inspection.report
        self._table.setVisible(report is None)
        self.report_view.setVisible(report is not None)
        if report is None:
            self._show_joints(inspection)
        else:
            self._show_report(report)

    def _show_speed(self, percent: int) -> None:
        from armui.trajectory.samples.swing_samples import speed_at  # noqa: PLC0415 - numpy

        speed = speed_at(percent / 100.0)
        self._speed.setText(self.tr("slowly, at {speed}°/s").format(speed=f"{speed:.1f}"))

    def _show_joints(self, inspection: Inspection) -> None:
        plan = inspection.plan
        swings = {} if plan is None else {each.joint: each for each in plan.swings}
        for joint, (name, swing, result) in self._labels.items():
            name.setText(f"{'▸ ' if inspection.joint == joint else ''}J{joint}")
            there = swings.get(joint)
            swing.setText(
                fmt.NOTHING if there is None else f"−{there.below_deg:g}° +{there.above_deg:g}°"
            )
            why = words.why_not(None if there is None else there.shortened)
            result.setText(self.tr("over") if joint in inspection.measured else why)

    def _show_report(self, report: InspectionReport) -> None:
        from armui.ui.dialogs.inspection_report import document  # noqa: PLC0415 - numpy

        made = document(report, self._arm(), colors_of(self), self.font())
        # the view does not own a document: without a parent Python would delete it
        made.setParent(self.report_view)
        self.report_view.setDocument(made)

    def _arm(self) -> list[str]:
        """Return model, firmware, node and serial number for the report, a line each."""
        from armui.ui.dialogs.about_arm import about_rows  # noqa: PLC0415 - for its window

        state, now = self._controller.state, self._controller.operating_state
        rows = about_rows(state, now, (), online_s=None, frames_per_s=None)
        wanted = ("model", "firmware", "node", "serial")
        return [f"{row.label}: {row.value}" for row in rows if row.key in wanted]

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Joint inspection"))
        self._controller.inspection.name = self.tr("Joint inspection")
        self._intro.setText(
            self.tr(
                "Each joint in turn swings to either side and comes back, the others hold. How far "
                "it stays behind, the current it needs and its temperature are compared with the "
                "other joints and with earlier inspections of this arm. Choose a place with room "
                "around the arm, and the load it usually carries."
            )
        )
        self._amplitude_label.setText(self.tr("Swing"))
        heads = (self.tr("Joint"), self.tr("Room"), "")
        for head, text in zip(self._heads, heads, strict=True):
            head.setText(text)
        self.report_view.setAccessibleName(self.tr("Report"))
        self._shown = ()
        self._show()
