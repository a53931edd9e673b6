"""The second level of 轨迹库: one trajectory, point by point (manual figure 1-20)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import QHeaderView, QLineEdit, QMenu, QWidget

from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.control.events import Level
from armui.control.operations.started import Started, refusal_of
from armui.control.run.preflight import Checks, Preflight
from armui.control.run.progress import OVER, Progress
from armui.control.run.replay import RUN_EMPTY
from armui.control.run.runner import ended_early
from armui.protocol.codes import MoveMode
from armui.trajectory.files.errors import TrajectoryFileError
from armui.trajectory.library.folders import shown_folder
from armui.trajectory.planning.findings import Finding, Severity
from armui.trajectory.points.edits import Change
from armui.trajectory.points.program import Trajectory, Values, Waypoint, frames_in, speeds_of
from armui.ui import words
from armui.ui.actions.command import Command, Target
from armui.ui.dialogs.confirm_dialog import LeaveQuestion, drive
from armui.ui.panels.jogging.jog_box import JogBox
from armui.ui.trajectory.editor.document import Document, DraftKeeper
from armui.ui.trajectory.editor.editor_actions import NAMES, EditorActions, EditorHint
from armui.ui.trajectory.editor.find_bar import FindBar, Finder
from armui.ui.trajectory.editor.findings_pane import FindingsPane
from armui.ui.trajectory.editor.long_edits import EDIT_UNDER_WAY, LongEdit, LongEdits
from armui.ui.trajectory.editor.other_arm_line import OtherArmLine
from armui.ui.trajectory.editor.point_edits import (
    FrameGiven,
    OfOtherArm,
    OfShownTool,
    Outcome,
    PointEdits,
)
from armui.ui.trajectory.editor.points_model import PointsModel
from armui.ui.trajectory.editor.points_table import PointsTable
from armui.ui.trajectory.running.run_bar import (
    POINTS_CHANGED_SINCE_RUN,
    RunBar,
    RunChoices,
    run_commands,
)
from armui.ui.widgets.buttons import named, push_button, show_primary
from armui.ui.widgets.layouts import fill, in_column
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.page import Page
from armui.ui.widgets.translated import Translated

if TYPE_CHECKING:
    from armui.cell.cell import Cell
    from armui.control.arm_controller import ArmController
    from armui.trajectory.library.run_options import RunOptions
    from armui.ui.trajectory.library.library_work import LibraryWork


class EditorJog(Translated, QWidget):
    """The jog box of the editor, closed at first, and created when it is first wanted.

    Args:
        controller: Sends the motions.
        keys: The name of the button's key.

    Signals:
        refused: A :class:`Refusal`, or ``None`` when something was done.
        insert_wanted: The button was pressed.
    """

    refused = Signal(object)
    insert_wanted = Signal()

    def __init__(self, controller: ArmController, keys: str) -> None:
        super().__init__()
        self._controller = controller
        self._keys = keys
        self._box: JogBox | None = None
        self._insert = push_button("box_insert", primary=True, on_enter=False)
        self._insert.clicked.connect(lambda _checked=False: self.insert_wanted.emit())
        self._column = in_column(on=self, margins=0)
        self.hide()
        self.retranslate_ui()

    def unfold(self, wanted: bool) -> None:
        """Show or hide the box; a hidden one moves nothing."""
        if wanted and self._box is None:
            self._box = JogBox(self._controller, self._insert)
            self._box.refused.connect(self.refused)
            self._column.addWidget(self._box)
        self.setVisible(wanted)

    def give_way(self, asked: bool) -> None:
        """Style the button as the primary one, unless a question or the conversion comes first."""
        show_primary(self._insert, wanted=not asked)

    @property
    def with_gripper(self) -> bool:
        """True if inserted points include the measured opening of the gripper."""
        return self._box is not None and self._box.gripper.inserted.isChecked()

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        text = self.tr("Insert current pose")
        self._insert.setText(text)
        tip = self.tr("Inserts the arm's present pose as a point after the selected row.")
        self._insert.setToolTip(f"{tip} ({self._keys})")


_OF_POINTS: Final = (
    *("go_to", "find", "check", "preview", "replace_by_measured", "duplicate", "delete", "cut"),
    *("copy", "move_up", "move_down", "convert", "frame"),
)
"""Actions that are possible with points only."""
_NOTE_PX: Final = 200
"""Below this width the note's field moves to a line of its own."""
_LEAST_BODY_PX: Final = 270
"""The height for the actions and some rows of the table beside a jog box that does not scroll."""


class EditorPage(Page):
    """Edits a trajectory of the library.

    Args:
        controller: Gives the arm's state, moves it and runs the trajectory.
        checks: Checks the trajectory.
        choices: The options of runs.
        work: Keeps the trajectory in the library.
        trajectory: As it is kept.
        draft: Changes of it that an earlier run of the program could not save.

    Signals:
        saved: The trajectory is in the library as it is shown.
        used: The operator has turned to this editor.
        insert_wanted: The key to insert the arm's position was pressed, in any window.
        selected_row_changed: The row the operator is in, −1 for none.
        preview_wanted: A :class:`Preflight` whose path is to be shown in 3D, or ``None``.
        found_changed: The same, with the findings that hold where the arm is now.
        play_wanted: The path that is shown is to be played.
        finding_wanted: A :class:`Finding` whose place is to be shown in 3D.
    """

    commands = (
        *(Command(f"editor.{name}", leads=name == "go_to") for name in NAMES),
        *run_commands("editor"),
    )
    saved = Signal()
    used = Signal()
    insert_wanted = Signal()
    selected_row_changed = Signal(int)
    preview_wanted = Signal(object)
    found_changed = Signal(object)
    play_wanted = Signal()
    finding_wanted = Signal(object)

    def __init__(
        self,
        controller: ArmController,
        checks: Checks,
        choices: RunChoices,
        work: LibraryWork,
        trajectory: Trajectory,
        *,
        draft: Trajectory | None = None,
    ) -> None:
        super().__init__("editor", footed=True)
        self._controller = controller
        self._work = work
        work.setParent(self)  # with this page deleted, `LibraryWork` drops its results
        self._library = work.library
        self._saving = False
        self._shows_saved = False
        self._folder = ""
        self.document = Document(trajectory, self)
        self.model = PointsModel(self.document, self._to_move, self._limits, self)
        self.table = PointsTable(self.model)
        self._cell = controller.cell.cell
        self.model.show_cell(self._cell)
        self._tool = _tool_shown(controller)
        self.model.show_tool(*self._tool)
        self._edits = PointEdits(controller, self.document, self.table)
        self._drafts = DraftKeeper(self.document, work)
        self._find_bar = FindBar()
        self._long_edits = LongEdits(self.document, checks.background, self)
        self._finder = Finder(self.document, self.table, self._find_bar, self._long_edits)
        self._note = named("trajectory_note", QLineEdit(trajectory.note))
        self._note.setMinimumWidth(_NOTE_PX)
        self._other_arm = OtherArmLine()
        self._message = named("editor_message", MessageLine(keeps_room=False))
        self._findings = FindingsPane(controller)
        self._plays = self._shows_run = self._shows_refusal = False
        self._ran: tuple[Progress | None, bool] = None, False
        self._actions = EditorActions(self, self.table, self._handlers())
        self._run_bar = RunBar(
            *(controller, checks, choices),
            self._read_points,
            lambda then: then(self.document.trajectory()),
            beside=map(self._actions.button, ("check", "preview")),
        )
        EditorHint(self.table, self._actions)
        everywhere = QShortcut(self._actions.keys("insert_measured"), self)
        everywhere.setContext(Qt.ShortcutContext.ApplicationShortcut)
        everywhere.activated.connect(self.insert_wanted)
        everywhere.activatedAmbiguously.connect(self.insert_wanted)
        keys = everywhere.key().toString(QKeySequence.SequenceFormat.NativeText)
        self._jog = EditorJog(controller, keys)
        self._lay_out()
        self._connect()
        self.retranslate_ui()
        self._show_arms()
        if draft is not None:
            self._take_draft(draft)
        self._show_count()
        self.table.show_middle(wanted=_has_arcs(self.document.points))
        self.table.make_room()
        self.table.select_row(0)
        if not self.document.points:
            self._actions["jog"].trigger()
        self.table.setFocus()

    @property
    def wanted_px(self) -> int:
        """The width at which every column is in sight."""
        return self.table.wanted_px

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **{f"editor.{name}": target for name, target in self._actions.targets().items()},
            **self._run_bar.command_targets("editor"),
        }

    def _handlers(self) -> dict[str, Callable[[], object]]:
        rows = self._edits
        of_rows = (
            *(rows.insert_before, rows.insert_after),
            *(rows.replace_by_measured, rows.duplicate, rows.delete, rows.cut, rows.copy),
            *(rows.paste, rows.move_up, rows.move_down, rows.convert),
        )
        return {
            **{edit.__name__: partial(self._do, edit) for edit in of_rows},
            "insert_measured": self.insert_current,
            "save": self.save,
            "undo": partial(self._step, self.document.stack.undo),
            "redo": partial(self._step, self.document.stack.redo),
            "find": self._find_bar.open,
            "check": self._check,
            "preview": lambda: self._check(plays=True),
            "jog": self._show_jog,
            "frame": self._choose_frame,
            "go_to": self._go_to,
        }

    def _lay_out(self) -> None:
        self._find_bar.hide()
        # bars that come and go take height from the table: jog buttons and 发送 never move
        fill(self.body, self._actions.bar(self._note), self._find_bar, (self.table, 1))
        fill(self.body, self._findings, self._other_arm, self._message)
        # Added empty, because the jog box moves to the body: PySide makes objects for the items of
        # a filled layout and keeps them when Qt deletes the items, which ends in a crash
        self._foot = in_column(margins=0)
        self.footer.addLayout(self._foot, 1)
        fill(self._foot, self._jog, self._run_bar)

    def _connect(self) -> None:
        stack = self.document.stack
        stack.undoTextChanged.connect(self._show_steps)
        stack.redoTextChanged.connect(self._show_steps)
        self.document.saved_changed.connect(self._on_saved_changed)
        self.document.note_changed.connect(lambda: self._note.setText(self.document.note))
        self._note.editingFinished.connect(self._on_note)
        self.document.taught_on_changed.connect(self._show_arms)
        self._controller.operating_state_changed.connect(self._show_arms)
        self._other_arm.convert_wanted.connect(self._convert_zeros)
        self._find_bar.closed.connect(self.table.setFocus)
        self._drafts.failed.connect(self._show_failure)
        self.table.row_chosen.connect(self.selected_row_changed)
        self._run_bar.listen(self)
        self._run_bar.checked.connect(self._show_check)
        self._run_bar.withdrawn.connect(self._findings.withdraw_question)
        self._run_bar.refused.connect(self._on_send_refused)
        self._run_bar.obstacle_gone.connect(self._on_obstacle_gone)
        self._run_bar.progressed.connect(self._on_progress)
        self._run_bar.started.connect(self._on_started)
        self._run_bar.started.connect(self._findings.note_run)
        self._jog.insert_wanted.connect(self.insert_current)
        self._jog.refused.connect(self._on_refused)
        self._findings.placed.connect(partial(self.bring_into_sight, self._findings))
        self._findings.finding_wanted.connect(self._show_finding)
        self._findings.found_changed.connect(self._mark_rows)
        self._findings.found_changed.connect(self.found_changed)
        self._findings.dismissed.connect(self._run_bar.drop_check)
        self._findings.asks.connect(self._show_rank)
        self.document.changed.connect(self._on_points)
        self._controller.cell_changed.connect(self._on_cell_changed)

    @property
    def subject(self) -> str:
        """The trajectory's name."""
        return self.document.name

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Place the jog box for the new height."""
        super().resizeEvent(event)
        self._place_jog()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Close what is open at Escape, one thing after another, before the page is left."""
        if event.key() == Qt.Key.Key_Escape and self._close_open():
            event.accept()
        else:
            super().keyPressEvent(event)

    def _close_open(self) -> bool:
        """Close one thing that is open in the page; return whether there was any."""
        if self._note.hasFocus():
            self._note.setText(self.document.note)
            self.table.setFocus()
        elif self._find_bar.isVisible():
            self._find_bar.put_away()
        elif self._findings.isVisible():
            self._findings.dismiss()
        elif self._actions["jog"].isChecked():
            self._actions["jog"].trigger()
        else:
            return False
        return True

    def _place_jog(self) -> None:
        """Keep the jog box below the table, or let it scroll with the table in a low window."""
        foot_px = sum(_height_of(each, self.width()) for each in (self._jog, self._run_bar))
        low = self.height() - foot_px < _LEAST_BODY_PX
        if low == (self._foot.indexOf(self._jog) >= 0):
            if low:
                self.body.addWidget(self._jog)
            else:
                self._foot.insertWidget(0, self._jog)

    def _show_jog(self) -> None:
        """Show the jog box, or hide it."""
        jogs = self._actions["jog"].isChecked()
        self._jog.unfold(jogs)
        self._place_jog()
        self._show_rank()

    def _show_rank(self, *_: object) -> None:
        """Style one button as primary: the answer, the conversion, the jogged point or 发送."""
        asked, converts = self._findings.is_asking, self._other_arm.converts
        self._other_arm.give_way(asked)
        self._jog.give_way(asked or converts)
        others = converts or self._findings.has_errors or self._actions["jog"].isChecked()
        self._run_bar.show_secondary(others)

    # Editing ----------------------------------------------------------------------------------

    def select_row(self, row: int) -> None:
        """Select a row, and scroll to it."""
        self.table.select_row(row)

    def insert_current(self) -> None:
        """Insert a point with the arm's position after the selected row."""
        self._do(partial(self._edits.insert_measured, with_gripper=self._jog.with_gripper))

    def event(self, event: QEvent) -> bool:
        """Note that the operator has turned to this editor."""
        if event.type() in {QEvent.Type.Show, QEvent.Type.WindowActivate}:
            self.used.emit()
        return super().event(event)

    def _show_arms(self, *_: object) -> None:
        fit = self._controller.operating_state.model_fit
        if self._other_arm.show_arms(self.document.taught_on, fit):
            self._show_rank()

    def _convert_zeros(self) -> None:
        if self._edits.convert_zeros():
            text = self.tr(
                "The angles count from the zeros of {arm} now; poses stay as they are. Save it, "
                "or undo it."
            )
            self._show_message(text.format(arm=words.arm_kind(self.document.taught_on)), Level.DONE)
        self.table.setFocus()

    def _on_send_refused(self, reason: Refusal) -> None:
        self._on_refused(reason)
        self._shows_refusal = True

    def _on_obstacle_gone(self) -> None:
        if self._shows_refusal:
            self._show_message("")

    def _on_refused(self, refusal: Refusal | None) -> None:
        self._show_message(
            "" if refusal is None else partial(words.refusal, refusal), Level.WARNING
        )
        if refusal is not None:  # below findings a low window has no room for it
            self.bring_into_sight(self._message)

    def _limits(self) -> Sequence[JointLimits]:
        return self._controller.operating_state.limits

    def _to_move(self, row: int, move: MoveMode) -> Waypoint | Refusal:
        return self._edits.to_move(row, move)

    def _choose_frame(self) -> None:
        """Show the frames that the selected points may count from."""
        menu = named("frame_menu", QMenu(self))
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        chosen = {self.document.points[row].frame for row in self.table.rows()}
        for name in ("", *self._edits.frames()):
            action = menu.addAction(name or self.tr("Base"))
            action.setCheckable(True)
            action.setChecked(chosen == {name})
            edit = partial(self._edits.set_frame, name)
            action.triggered.connect(lambda _checked=False, edit=edit: self._do(edit))
        cell = self.table.visualRect(self.table.currentIndex())
        menu.popup(self.table.viewport().mapToGlobal(cell.bottomLeft()))

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
        """Restore unsaved changes as an edit that can be undone."""
        self.document.set_note(draft.note, self.tr("Unsaved changes"))
        if draft.taught_on == self.document.taught_on:
            self.document.edit(draft.points, self.tr("Unsaved changes"))
        else:
            self.document.convert(draft.points, draft.taught_on, self.tr("Unsaved changes"))
        self._show_message(
            self.tr(
                "These changes were not saved when the program ended. Save them, or undo them."
            ),
            Level.WARNING,
        )

    def show_draft_not_applied(self) -> None:
        """Show that unsaved changes based on another version of the file were not applied."""
        text = self.tr(
            "“{name}” has been saved since these unsaved changes were kept: they are not put over "
            "it. They are in the library under “Recently deleted…”."
        )
        self._show_message(text.format(name=self.document.name), Level.WARNING)

    # Checking and running ---------------------------------------------------------------------

    def _on_points(self, change: Change) -> None:
        """Drop the check and its path: they are of the points before this change."""
        if _has_arcs(change.added):
            self.table.show_middle(wanted=True)
        self.table.make_room()
        self._forget_check()
        if any(self._ran) or self._run_bar.progress.phase not in OVER:
            self._on_progress(self._run_bar.progress)

    def _on_cell_changed(self, cell: Cell | None) -> None:
        """Drop the check if a frame or held object that points name is changed in the cell."""
        tool = _tool_shown(self._controller)
        if tool != self._tool:
            self._show_tool(*tool)
        before, self._cell = self._cell, cell
        if _offered(cell) != _offered(before):
            self.model.show_cell(cell)
        points = self.document.points
        if _named_by(points, cell) != _named_by(points, before):
            self._forget_check()

    def _show_tool(self, tool: Values, name: str) -> None:
        """Show poses for another tool in force, and drop a pose being typed for the last one."""
        dropped = self.table.drop_figures()
        if tool != self._tool[0]:
            self._forget_check()
        self._tool = tool, name
        self.model.show_tool(tool, name)
        self.table.make_room()
        if dropped:
            text = self.tr("The tool has changed: the figure that was being typed is not taken.")
            self._show_message(text, Level.WARNING)

    def _forget_check(self) -> None:
        self._findings.clear()
        self.model.show_faults({})
        self._run_bar.drop_check()
        self._show_count()
        self._run_bar.renew_estimate()
        self.preview_wanted.emit(None)

    def _show_count(self) -> None:
        count = len(self.document.points)
        empty = RUN_EMPTY(name=self.document.name)
        self._run_bar.show_content(
            self.document.name,
            count,
            speeds=speeds_of(self.document.points),
            nothing=None if count else empty,
            state=self.document.points,
        )
        for name in _OF_POINTS:
            self._actions.allow(name, "" if count else words.refusal(empty))

    def _read_points(self, then: Callable[[Trajectory | None], object]) -> None:
        """Pass on the points with the entry being typed, or ``None`` if that is not valid."""
        untaken = self.table.take_entry()
        if untaken is not None:
            self._show_message(partial(self._not_taken, *untaken), Level.WARNING)
            self.bring_into_sight(self._message)
        then(self.document.trajectory() if untaken is None else None)

    def _not_taken(self, row: int, reason: Refusal) -> str:
        text = self.tr("An entry in row {row} was not taken: {reason}")
        return text.format(row=row + 1, reason=words.refusal(reason))

    def _check(self, *, plays: bool = False) -> None:
        """Check without running, and then let the ghost go along the path, if wanted."""
        self._plays = plays
        self._run_bar.check()

    def _show_check(self, checked: Preflight, accept: Callable[[], object] | None) -> None:
        found = self._findings.show_check(checked, accept)
        self.bring_into_sight(self._findings)
        self._mark_rows(found)
        self._show_message("")
        if self.document.saved and checked.whole:
            self._note_check(checked)
        self.preview_wanted.emit(found)
        if self._plays:
            self.play_wanted.emit()
        self._plays = False

    def _mark_rows(self, found: Preflight) -> None:
        faults: dict[int, bool] = {}
        for finding in found.findings:
            if finding.row is not None and not finding.approach:
                error = finding.severity is Severity.ERROR
                faults[finding.row] = faults.get(finding.row, False) or error
        self.model.show_faults(faults)

    def _show_finding(self, finding: Finding) -> None:
        """Select the row of a finding, and show the ghost at its place."""
        if finding.row is not None:
            self.table.select_row(finding.row)
        self.finding_wanted.emit(finding)

    def _note_check(self, checked: Preflight) -> None:
        """Have the list show how the check ended."""
        name = self.document.name
        self._work.do(
            lambda: self._library.mark(name, check=checked.mark, arm=checked.fingerprint),
            lambda _: self.saved.emit(),
            self._show_failure,
        )

    def _on_started(self, name: str, options: RunOptions) -> None:
        """Store the run's options in the library."""
        self._work.do(lambda: self._library.note_run(name, options), refused=self._show_failure)

    def _on_progress(self, progress: Progress) -> None:
        ours = progress.name == self.document.name
        under_way, ended = ours and progress.phase not in OVER, ours and ended_early(progress)
        same = self._run_bar.goes_by(self.document.points)
        row = progress.index if under_way and same else -1
        self.model.show_current(row)
        if row >= 0 and self.isVisible():
            self.table.scrollTo(self.model.index(row, 0))
        ran = progress if ended else None, (under_way or ended) and not same
        if ran != self._ran:
            self._ran = ran
            if any(ran):
                level = Level.INFO if progress.refusal is None else Level.FAULT
                self._show_message(partial(self._of_run, *ran), level)
                self._shows_run = True
            elif self._shows_run:
                self._show_message("")  # the end of an earlier run

    def _of_run(self, ended: Progress | None, changed: bool) -> str:
        """Return a text on where a run ended, or that it runs other points than the table's."""
        if ended is None:
            return self.tr(
                "The table is not what runs: the run goes by the points as they were when it "
                "began. No row is marked."
            )
        text = self.tr("Ended at row {row}. {reason}")
        if changed:
            text = self.tr("Ended at row {row} of the table as it was. {reason} {changed}")
        changed_since = words.refusal(POINTS_CHANGED_SINCE_RUN())
        reason = words.why_ended(ended.refusal)
        text = text.format(row=ended.index + 1, reason=reason, changed=changed_since)
        return " ".join(text.split())

    # Saving -----------------------------------------------------------------------------------

    def save(self, then: Callable[[], object] = lambda: None) -> None:
        """Save the trajectory in the library.

        Args:
            then: Called when it is saved.
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
        self._drafts.write_draft()
        if displaced:
            text = self.tr(
                "Saved. Another program had changed “{name}” since it was opened here: what it "
                "saved is in the library under “Recently deleted…”."
            )
            self._show_message(text.format(name=trajectory.name), Level.WARNING)
        else:
            self._show_message(self.tr("Saved."), Level.DONE)
            self._shows_saved = True
        self.saved.emit()
        then()

    def _on_not_saved(self, text: str) -> None:
        self._saving = False
        self._show_failure(text)

    def keep_draft(self) -> None:
        """Save the draft, because the program ends; it is offered at the next start."""
        self._drafts.write_draft()

    def leave(self) -> None:
        """Close the page; unsaved changes ask first."""
        self._on_note()
        if self.document.saved:
            self._leave()
            return
        question = LeaveQuestion(self._controller, self, self.document.name)
        question.accepted.connect(self._leave)
        question.save_wanted.connect(partial(self.save, self._leave))
        question.finished.connect(question.deleteLater)
        question.open()

    def _leave(self) -> None:
        self._drafts.drop_draft()
        self._run_bar.drop_check()
        self._long_edits.drop()
        super().leave()

    def take_focus(self) -> None:
        """Focus the table."""
        self.table.setFocus()

    def headers(self) -> Mapping[str, QHeaderView]:
        """Return the table's header, whose columns are stored."""
        return {"points": self.table.horizontalHeader()}

    def _go_to(self) -> None:
        """Send the arm to the current point at the speed for single motions."""
        move = EDIT_UNDER_WAY() if self._long_edits.busy else self._edits.motion_here()
        if isinstance(move, Refusal):
            self._on_outcome(move)
        else:
            drive(self, self._controller, move, self._on_driven, self._edits.current_point)

    def _on_driven(self, answer: Started | Refusal) -> None:
        self._on_outcome(refusal_of(answer))

    # Texts ------------------------------------------------------------------------------------

    def _do(self, edit: Callable[[], Outcome]) -> None:
        self._on_outcome(EDIT_UNDER_WAY() if self._long_edits.busy else edit())

    def _on_outcome(self, outcome: Outcome) -> None:
        if isinstance(outcome, LongEdit):
            self._long_edits.begin(outcome, self._on_outcome)
            if self._long_edits.busy:
                text = self.tr("Working on {count} rows…").format(count=outcome.rows)
                self._show_message(text)
        elif outcome is None:
            if not self._shows_run:
                self._show_message("")
        elif isinstance(outcome, TrajectoryFileError):
            text = self.tr("Not pasted. {reason}").format(reason=words.file_error(outcome))
            self._show_message(text, Level.WARNING)
        elif isinstance(outcome, OfOtherArm):
            text = self.tr(
                "These points were taught on another arm: {pasted}. Those here were taught on "
                "{here}. The same joint angles may hold the tool elsewhere: check them, or undo."
            )
            kinds = {"pasted": words.arm_kind(outcome.pasted), "here": words.arm_kind(outcome.here)}
            self._show_message(text.format(**kinds), Level.WARNING)
        elif isinstance(outcome, FrameGiven):
            frame = f"“{outcome.name}”" if outcome.name else self.tr("the base")
            if outcome.lost:
                text = self.tr(
                    "“{lost}” is not known: the figures stayed, and count from {frame} "
                    "now. The points are elsewhere then: check them, or undo."
                )
                self._show_message(text.format(lost=outcome.lost, frame=frame), Level.WARNING)
            else:
                text = self.tr("The points stay where they are; their figures are in {frame} now.")
                self._show_message(text.format(frame=frame), Level.DONE)
        elif isinstance(outcome, OfShownTool):
            text = self.tr(
                "Pasted as poses of {tool}, as the table shows them. Undo if they are of the "
                "flange or another tool."
            )
            self._show_message(text.format(tool=outcome.tool), Level.WARNING)
        else:
            self._show_message(partial(words.refusal, outcome), Level.WARNING)

    def _show_failure(self, text: str) -> None:
        self._show_message(text, Level.FAULT)

    def _show_message(self, text: Words, level: Level = Level.INFO) -> None:
        self._shows_saved = self._shows_run = self._shows_refusal = False
        self._message.show_message(text, level)

    def _on_saved_changed(self, saved: bool) -> None:
        self._show_title()
        if self._shows_saved and not saved:
            self._show_message("")

    def show_folder(self, folder: str) -> None:
        """Show the library's sub-folder before the name; "" for none."""
        self._folder = folder
        self._show_title()

    def _show_title(self) -> None:
        star = "" if self.document.saved else " *"
        folder = f"{shown_folder(self._folder)} › " if self._folder else ""
        self.set_title(f"{folder}{self.document.name}{star}")
        self._actions.allow("save", self.tr("All is saved.") if self.document.saved else "")

    def _show_steps(self) -> None:
        undone, redone = self.document.stack.undoText(), self.document.stack.redoText()
        nothing = self.tr("There is nothing to undo."), self.tr("There is nothing to redo.")
        self._actions.allow("undo", "" if undone else nothing[0], undone)
        self._actions.allow("redo", "" if redone else nothing[1], redone)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self._actions.retranslate()
        self._show_steps()
        self._show_count()
        self.model.retranslate()
        self.table.make_room()
        self._note.setPlaceholderText(self.tr("What this trajectory is for"))
        self.table.setAccessibleName(self.tr("Points"))
        self._show_title()


def _height_of(part: QWidget, width_px: int) -> int:
    layout = part.layout()
    return 0 if layout is None else layout.totalHeightForWidth(width_px)


def _tool_shown(controller: ArmController) -> tuple[Values, str]:
    return controller.cartesian.tool, controller.cell.tool_name


def _offered(cell: Cell | None) -> object:
    return None if cell is None else (cell.all_frames, cell.held_objects)


def _named_by(points: Sequence[Waypoint], cell: Cell | None) -> object:
    """Return the frames and held objects of a cell that points refer to."""
    if cell is None:
        return [], []
    names, held = frames_in(points), {point.holds for point in points}
    frames = [frame for frame in cell.all_frames if frame.name in names]
    return frames, [each for each in cell.held_objects if each.name in held]


def _has_arcs(points: Iterable[Waypoint]) -> bool:
    return any(point.move is MoveMode.MOVE_C for point in points)
