"""The second level of 轨迹库: one trajectory, point by point (manual figure 1-20)."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QSize, Signal
from PySide6.QtWidgets import QLineEdit, QWidget

from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.control.run.progress import OVER, Progress
from armui.trajectory.files.errors import TrajectoryFileError
from armui.trajectory.planning.findings import Severity
from armui.trajectory.points import edits
from armui.trajectory.points.edits import Change
from armui.trajectory.points.program import Trajectory, Waypoint
from armui.ui import words
from armui.ui.dialogs.base import ArmDialog
from armui.ui.trajectory.editor.document import Document
from armui.ui.trajectory.editor.draft_keeper import DraftKeeper
from armui.ui.trajectory.editor.editor_actions import EditorActions
from armui.ui.trajectory.editor.find_bar import FindBar
from armui.ui.trajectory.editor.findings_pane import FindingsPane
from armui.ui.trajectory.editor.leave_question import LeaveQuestion
from armui.ui.trajectory.editor.point_edits import Outcome, PointEdits
from armui.ui.trajectory.editor.points_model import PointsModel
from armui.ui.trajectory.editor.points_table import PointsTable
from armui.ui.trajectory.running.preflight import Checks, Preflight
from armui.ui.trajectory.running.run_strip import RunStrip
from armui.ui.widgets.buttons import named
from armui.ui.widgets.layouts import fill
from armui.ui.widgets.message_line import MessageLine

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.protocol.codes import MoveMode
    from armui.ui.trajectory.library.library_work import LibraryWork

_SIZE: Final = QSize(1220, 720)


class EditorWindow(ArmDialog):
    """Edits a trajectory of the library.

    Args:
        controller: Knows where the arm is, moves it and runs what is edited.
        checks: Checks what is edited.
        work: Keeps the trajectory in the library.
        trajectory: As it is kept.
        draft: Changes of it that an earlier run of the program could not save.
        parent: The window it belongs to.

    Signals:
        saved: The trajectory is in the library as it is shown.
        left: The window was closed for good.
        selected_row_changed: The row the operator is in, −1 for none.
        preview_wanted: A :class:`Preflight` whose path is to be shown in 3D, or ``None``.
    """

    saved = Signal()
    left = Signal()
    selected_row_changed = Signal(int)
    preview_wanted = Signal(object)

    def __init__(
        self,
        controller: ArmController,
        checks: Checks,
        work: LibraryWork,
        trajectory: Trajectory,
        *,
        draft: Trajectory | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._work = work
        work.setParent(self)
        self._library = work.library
        self._saving = False
        self.document = Document(trajectory, self)
        self.model = PointsModel(self.document, self._to_move, self)
        self.table = PointsTable(self.model)
        self._edits = PointEdits(controller, self.document, self.table)
        self._drafts = DraftKeeper(self.document, work)
        self._find_bar = FindBar()
        self._note = named("trajectory_note", QLineEdit(trajectory.note))
        self._message = named("editor_message", MessageLine())
        self._findings = FindingsPane()
        self._strip = RunStrip(controller, checks, lambda then: then(self.document.trajectory()))
        self._actions = EditorActions(self, self.table, self._handlers())
        self._lay_out()
        self._connect()
        self.retranslate_ui()
        self.resize(_SIZE)
        if draft is not None:
            self._take_draft(draft)
        self._strip.show_content(len(self.document.points))
        self.table.select_row(0)
        self.table.setFocus()

    def _handlers(self) -> dict[str, Callable[[], object]]:
        rows = self._edits
        of_rows = (
            *(rows.insert_before, rows.insert_after, rows.insert_measured),
            *(rows.replace_by_measured, rows.duplicate, rows.delete, rows.cut, rows.copy),
            *(rows.paste, rows.move_up, rows.move_down, rows.convert, rows.go_to),
        )
        return {
            **{edit.__name__: partial(self._do, edit) for edit in of_rows},
            "save": self.save,
            "undo": partial(self._step, self.document.stack.undo),
            "redo": partial(self._step, self.document.stack.redo),
            "find": self._find_bar.open,
            "check": self._strip.check,
        }

    def _lay_out(self) -> None:
        self._find_bar.hide()
        bar = self._actions.bar()
        bar.addWidget(self._note, 3)
        fill(self.body, bar, self._find_bar, (self.table, 1))
        fill(self.body, self._findings, self._strip, self._message)

    def _connect(self) -> None:
        stack = self.document.stack
        stack.canUndoChanged.connect(self._actions["undo"].setEnabled)
        stack.canRedoChanged.connect(self._actions["redo"].setEnabled)
        self._actions["undo"].setEnabled(False)
        self._actions["redo"].setEnabled(False)
        self.document.saved_changed.connect(self._show_title)
        self.document.note_changed.connect(lambda: self._note.setText(self.document.note))
        self._note.editingFinished.connect(self._on_note)
        self._find_bar.next_wanted.connect(self._find)
        self._find_bar.replace_wanted.connect(self._replace)
        self._find_bar.closed.connect(self.table.setFocus)
        self._drafts.failed.connect(self._show_failure)
        self.table.row_chosen.connect(self.selected_row_changed)
        self._strip.checked.connect(self._show_check)
        self._strip.refused.connect(lambda reason: self._say(words.refusal(reason), Level.WARNING))
        self._strip.progressed.connect(self._on_progress)
        self._findings.row_wanted.connect(self.table.select_row)
        self.document.changed.connect(self._on_points)

    # Editing ----------------------------------------------------------------------------------

    def select_row(self, row: int) -> None:
        """Show a row and make it the current one."""
        self.table.select_row(row)

    def _to_move(self, row: int, move: MoveMode) -> Waypoint | Refusal:
        return self._edits.to_move(row, move)

    def _step(self, step: Callable[[], None]) -> None:
        """Undo or redo, and show the rows in which something has changed."""
        shown: list[Change] = []
        connection = self.document.changed.connect(shown.append)
        step()
        self.document.changed.disconnect(connection)
        for change in shown:
            if change.added:
                self.table.select_rows(change.first, len(change.added))
            else:
                self.table.select_row(min(change.first, len(self.document.points) - 1))

    def _on_note(self) -> None:
        self.document.set_note(self._note.text(), self.tr("Note"))

    def _take_draft(self, draft: Trajectory) -> None:
        """Bring back what was not saved, as an edit that can be undone."""
        self.document.set_note(draft.note, self.tr("Unsaved changes"))
        self.document.edit(draft.points, self.tr("Unsaved changes"))
        self._say(
            self.tr(
                "These changes were not saved when the program ended. Save them, or undo them."
            ),
            Level.WARNING,
        )

    def _find(self, by: int) -> None:
        rows = self._find_bar.found(self.document.points)
        if isinstance(rows, Refusal):
            self._find_bar.show_refusal(rows)
            return
        if not rows:
            self._find_bar.show_result(self.tr("Not found"))
            return
        here = self.table.current_row()
        ahead = [row for row in rows if row > here] if by > 0 else [r for r in rows if r < here]
        row = (ahead or rows)[0 if by > 0 else -1]
        self.table.select_row(row)
        self._find_bar.show_result(
            self.tr("{place} of {count}").format(place=rows.index(row) + 1, count=len(rows))
        )

    def _replace(self, everywhere: bool) -> None:
        points = self.document.points
        rows = self._find_bar.found(points)
        if not isinstance(rows, Refusal) and not everywhere:
            rows = [row for row in rows if row == self.table.current_row()]
        changed: dict[int, Waypoint] = {}
        for row in [] if isinstance(rows, Refusal) else rows:
            point = self._find_bar.replaced(points[row])
            if isinstance(point, Refusal):
                rows = point
                break
            changed[row] = point
        if isinstance(rows, Refusal):
            self._find_bar.show_refusal(rows)
            return
        self.document.edit(edits.change(points, changed), self.tr("Replace"))
        if everywhere:
            self._find_bar.show_result(self.tr("{count} replaced").format(count=len(changed)))
        else:
            self._find(1)

    # Checking and running ---------------------------------------------------------------------

    def _on_points(self, _change: Change) -> None:
        """What was found and planned was of other points."""
        self._findings.clear()
        self._strip.drop_check()
        self._strip.show_content(len(self.document.points))
        self.preview_wanted.emit(None)

    def _show_check(self, checked: Preflight, accept: Callable[[], object] | None) -> None:
        self._findings.show_check(checked, accept)
        faults: dict[int, bool] = {}
        for finding in checked.findings:
            if finding.row is not None:
                error = finding.severity is Severity.ERROR
                faults[finding.row] = faults.get(finding.row, False) or error
        self.model.show_faults(faults)
        self._say("")
        if self.document.saved:
            self._note_check(checked)
        self.preview_wanted.emit(checked)

    def _note_check(self, checked: Preflight) -> None:
        """Have the list show how the check ended."""
        length_s = sum(checked.outcome.expected_s)
        name = self.document.name
        self._work.do(
            lambda: self._library.mark(name, check=checked.mark, length_s=length_s),
            lambda _: self.saved.emit(),
            self._show_failure,
        )

    def _on_progress(self, progress: Progress) -> None:
        ours = progress.name == self.document.name
        under_way = ours and progress.phase not in OVER
        row = progress.index if under_way else -1
        self.model.show_current(row)
        if under_way and self.isVisible():
            self.table.scrollTo(self.model.index(row, 0))
        if ours and progress.reason is not None:
            text = self.tr("Ended at row {row}. {reason}").format(
                row=progress.index + 1, reason=words.refusal(progress.reason)
            )
            self._say(text, Level.FAULT)

    # Saving -----------------------------------------------------------------------------------

    def save(self, then: Callable[[], object] = lambda: None) -> None:
        """Put it into the library.

        Args:
            then: Called when it is there.
        """
        if self._saving:
            return
        self._on_note()
        trajectory, place = self.document.trajectory(), self.document.stack.index()
        self._saving = True
        self._work.do(
            lambda: self._library.save(trajectory, replacing=trajectory.name),
            lambda displaced: self._on_saved(trajectory, place, displaced, then),
            self._on_not_saved,
        )

    def _on_saved(
        self, trajectory: Trajectory, place: int, displaced: bool, then: Callable[[], object]
    ) -> None:
        self._saving = False
        if self.document.stack.index() == place:
            self.document.mark_saved(trajectory)
        self._drafts.write()
        if displaced:
            text = self.tr(
                "Saved. Another program had changed “{name}” since it was opened here: what it "
                "saved is in the library under “Recently deleted…”."
            )
            self._say(text.format(name=trajectory.name), Level.WARNING)
        else:
            self._say(self.tr("Saved."), Level.DONE)
        self.saved.emit()
        then()

    def _on_not_saved(self, text: str) -> None:
        self._saving = False
        self._show_failure(text)

    def keep_draft(self) -> None:
        """The program ends: what is not saved is offered when it is started again."""
        self._drafts.write()

    def reject(self) -> None:
        """Close; what is not saved asks first."""
        self._on_note()
        if self.document.saved:
            self._leave()
            return
        question = LeaveQuestion(self._controller, self, self.document.name)
        question.accepted.connect(self._leave)
        question.save_wanted.connect(self._save_and_leave)
        question.finished.connect(question.deleteLater)
        question.open()

    def _save_and_leave(self) -> None:
        self.save(self._leave)

    def _leave(self) -> None:
        self._drafts.forget()
        super().reject()
        self.left.emit()

    # Words ------------------------------------------------------------------------------------

    def _do(self, edit: Callable[[], Outcome]) -> None:
        outcome = edit()
        if outcome is None:
            self._say("")
        elif isinstance(outcome, TrajectoryFileError):
            text = self.tr("Not pasted. {reason}").format(reason=words.file_error(outcome))
            self._say(text, Level.WARNING)
        else:
            self._say(words.refusal(outcome), Level.WARNING)

    def _show_failure(self, text: str) -> None:
        self._say(text, Level.FAULT)

    def _say(self, text: str, level: Level = Level.INFO) -> None:
        self._message.show_message(text, level)

    def _show_title(self) -> None:
        star = "" if self.document.saved else " *"
        self.set_title(f"{self.document.name}{star}")
        self._actions["save"].setEnabled(not self.document.saved)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self._actions.retranslate()
        self.model.retranslate()
        self._note.setPlaceholderText(self.tr("What this trajectory is for"))
        self.table.setAccessibleName(self.tr("Points"))
        self._show_title()
