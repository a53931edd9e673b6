"""The page 轨迹库: all trajectories, and the actions on them (manual figure 1-19)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import QEvent, QModelIndex, QTimer, Signal
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import QHeaderView

from armui.arm.refusal import Reason, Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.operating_state import OperatingState
from armui.control.parameters.arm_model import arm_model
from armui.control.run.preflight import Checks, Preflight
from armui.control.run.progress import OVER, Progress
from armui.control.run.runner import ended_early
from armui.trajectory.files import Content
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.library.store import NAME_TAKEN, IndexEntry, Library, Listing, free_name
from armui.trajectory.points.program import Trajectory, check_name
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import HasActs
from armui.ui.actions.command import Command, Target
from armui.ui.actions.keys import listen_for
from armui.ui.background import Background
from armui.ui.trajectory.editor.findings_pane import FindingsPane
from armui.ui.trajectory.editor.point_edits import NO_ROWS_CHOSEN
from armui.ui.trajectory.library.bin_dialog import RecentlyDeleted
from armui.ui.trajectory.library.folder_bar import FolderBar
from armui.ui.trajectory.library.library_actions import LibraryActions
from armui.ui.trajectory.library.library_bar import LibraryBar
from armui.ui.trajectory.library.library_editors import LibraryEditors
from armui.ui.trajectory.library.library_exchange import FileDrop, LibraryExchange
from armui.ui.trajectory.library.library_model import (
    ENTRY_ROLE,
    LibraryColumn,
    LibraryFilter,
    LibraryModel,
)
from armui.ui.trajectory.library.library_presence import (
    FolderTimes,
    LibraryPresence,
    LibraryWatch,
    SharedUseBanner,
)
from armui.ui.trajectory.library.library_table import LibraryHint, LibraryTable
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.library.name_bar import NameBar, NameQuestion
from armui.ui.trajectory.recording.recording_page import RecordingPage
from armui.ui.trajectory.recording.unsaved_line import UnsavedRecordingLine
from armui.ui.trajectory.running.run_bar import RunBar, RunChoices, run_commands
from armui.ui.trajectory.table_import.columns_page import ColumnsOffer
from armui.ui.widgets.buttons import named
from armui.ui.widgets.flow import in_flow
from armui.ui.widgets.layouts import fill
from armui.ui.widgets.message_line import MessageLine, Words
from armui.ui.widgets.page import Page

SEVERAL_CHOSEN = Reason("several_chosen", "Several rows are chosen. Choose the one to run.")
_PAUSE_MS: Final = 300
"""The pause before lengths are estimated, so that requests of the operator come first."""


class LibraryPage(Page):
    """The list of the library; a double click opens the second level.

    Args:
        controller: Runs trajectories, and gives the arm's state.
        background: Runs long work.
        library: The library.

    Attributes:
        editors: The open pages of trajectories.

    Signals:
        page_made: A new :class:`Page`, before it wants to be shown.
        editor_opened: The :class:`EditorPage` of a trajectory, before it is shown: a preview must
            connect to its ``preview_wanted`` and ``selected_row_changed``.
        preview_wanted: A :class:`Preflight` whose path is to be shown in 3D; ``None``: no longer.
        found_changed: The same, with the findings that hold where the arm is now.
        finding_wanted: A :class:`Finding` whose place is to be shown in 3D.
        run_asks: The name of the trajectory that waits for confirmation; "" if none does.
    """

    leaves_at_escape = False
    commands = (
        *LibraryBar.commands,
        *RecentlyDeleted.commands,
        *FolderBar.commands,
        Command("library.find"),
        *LibraryActions.commands,
        *ColumnsOffer.commands,
        *LibraryExchange.commands,
        *run_commands("library"),
    )
    page_made = Signal(object)
    editor_opened = Signal(object)
    preview_wanted = Signal(object)
    found_changed = Signal(object)
    finding_wanted = Signal(object)
    run_asks = Signal(str)

    def __init__(self, controller: ArmController, background: Background, library: Library) -> None:
        super().__init__("library", footed=True)
        self._controller = controller
        self._checks = Checks(controller, background)
        self._checks.get_ready()
        self._library = library
        self._work = LibraryWork(library, background, self)
        self._work.do(library.tidy)
        self._presence = LibraryPresence(library.folder)
        self._shared_use = SharedUseBanner()
        self._choices = RunChoices(self)
        self.editors = LibraryEditors(
            controller, background, self._checks, self._work, choices=self._choices, parent=self
        )
        self._name_bar = NameBar()
        self._unsaved = UnsavedRecordingLine(self._work)
        self._unsaved.refresh()
        self._model = LibraryModel(self)
        self._shown = LibraryFilter(self._model, self)
        self._bar = LibraryBar()
        self._table = LibraryTable(self._shown)
        self._message = named("library_message", MessageLine(keeps_room=False))
        self._actions = LibraryActions(self._work, self._why_used, self)
        self._folder_bar = FolderBar(self._actions, self._name_bar, self.chosen, self)
        self._deleted = RecentlyDeleted(controller, self._work, self._actions, self)
        self._hint = LibraryHint(self._table)
        self._watch = LibraryWatch(library.folder, self, background)
        self._exchange = LibraryExchange(controller, self._checks, self._work, self)
        self._findings = FindingsPane(controller)
        self._found_of = ""
        """The name of the trajectory that the findings are about."""
        self._message_of = ""
        """The name of the trajectory whose refused run the message is about."""
        self._shows_end = False
        self._run_bar = RunBar(
            controller, self._checks, self._choices, self._to_run, self._to_estimate
        )
        self._estimates = QTimer(self, singleShot=True, interval=_PAUSE_MS)
        self._estimates.timeout.connect(self._estimate)
        self._estimating = False
        self._lay_out()
        self._connect()
        self.retranslate_ui()
        self._table.setFocus()

    def command_targets(self) -> Mapping[str, Target]:
        """Return the target of each command, by the command's name."""
        return {
            **super().command_targets(),
            "library.find": self._bar.search,
            **self._run_bar.command_targets("library"),
        }

    def act_parts(self) -> Iterable[HasActs]:
        """Return the bars and what else has buttons, whose acts the page offers."""
        exchange = self._exchange
        return (
            *(self._bar, self._deleted, self._folder_bar),
            *(self._actions, exchange.by_columns, exchange),
        )

    # Layout -----------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        exchange = self._exchange
        offers = (exchange.report, exchange.by_columns.button, self._actions.undo_button)
        self._below = self._message, *offers
        below = in_flow(self._message)
        for button in offers:
            below.push(button)  # keep it at the right even without a message
        self._bar.add_button(self._deleted.button)
        folders = self._folder_bar
        for part in (folders.move_button, folders.menu_button, folders.choice):
            self._bar.add_before_search(part)
        # bars that come and go take height from the list: 发送 never moves
        fill(self.body, self._bar, self._name_bar, self._shared_use, self._unsaved)
        fill(self.body, (self._table, 1))
        fill(self.body, self._findings, below)
        fill(self.footer, (self._run_bar, 1))

    def _connect(self) -> None:
        handlers: dict[str, Callable[[], object]] = {
            "import": self._exchange.choose_imports,
            "create": self._create,
            "record": self.open_recorder,
            "edit": lambda: self.open_trajectory(self._chosen_names()[0]),
            "delete": lambda: self._actions.delete(self._chosen_names()),
            "duplicate": lambda: self._actions.duplicate(self._chosen_names()[0]),
            "rename": self._table.edit_name,
        }
        self._bar.wanted.connect(lambda name: handlers[name]())
        self._bar.export_wanted.connect(self._export)
        self._bar.listen(self, self._table)
        listen_for("library.undo", self, self._actions.undo_button.click)
        self._bar.search.textChanged.connect(self._on_search)
        self._folder_bar.shown_changed.connect(self._show_folder)
        self._folder_bar.message_changed.connect(self._show_message)
        self._name_bar.closed.connect(self._table.setFocus)
        self._hint.clear_wanted.connect(self._bar.search.clear)
        self._table.doubleClicked.connect(self._on_double_click)
        self._table.clicked.connect(self._on_click)
        self._table.selectionModel().selectionChanged.connect(self._show_usable)
        self._model.modelReset.connect(self._show_usable)
        self._model.rename_wanted.connect(self._actions.rename)
        self._actions.message_changed.connect(self._show_message)
        self._actions.changed.connect(self._on_action)
        self._watch.changed.connect(self._on_folder)
        self._unsaved.kept.connect(self._on_recording_kept)
        self._unsaved.discarded.connect(self._on_recording_discarded)
        self._unsaved.refused.connect(self._on_refused)
        FileDrop(self).dropped.connect(self._exchange.import_files)
        self._exchange.message_changed.connect(self._show_message)
        self._exchange.imported.connect(self._on_imported)
        self._exchange.checked.connect(self._mark)
        self._exchange.found.connect(self.open_trajectory)
        self._exchange.by_columns.page_made.connect(self._lead_to)
        self.editors.page_made.connect(self._lead_to)
        self.editors.editor_opened.connect(self.editor_opened)
        self.editors.recorder_opened.connect(self._on_recorder)
        self.editors.changed.connect(self.refresh)
        self.editors.message_changed.connect(self._show_message)
        self.editors.refused.connect(self._on_refused)
        self._controller.operating_state_changed.connect(self._on_operating_state)
        self._run_bar.listen(self)
        self._run_bar.checked.connect(self._show_check)
        self._run_bar.withdrawn.connect(self._findings.withdraw_question)
        self._run_bar.started.connect(self._findings.note_run)
        self._findings.placed.connect(partial(self.bring_into_sight, self._findings))
        self._findings.finding_wanted.connect(self.finding_wanted)
        self._findings.found_changed.connect(self.found_changed)
        self._findings.dismissed.connect(self._run_bar.drop_check)
        self._choices.asking.connect(self.run_asks)
        self._run_bar.refused.connect(self._on_run_refused)
        self._run_bar.obstacle_gone.connect(self._on_obstacle_gone)
        self._run_bar.progressed.connect(self._on_progress)
        self._run_bar.started.connect(self._on_started)

    # The list ---------------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Read the folder again, because files may have come or gone."""
        self.refresh()
        super().showEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the chosen row in sight where there is little height: it is what runs."""
        super().resizeEvent(event)
        self._show_chosen()

    def _show_chosen(self) -> None:
        if self._table.chosen():
            self.bring_into_sight(self._table)  # Qt scrolls a table to its current row

    def event(self, event: QEvent) -> bool:
        """Read the folder again when the window is activated."""
        if event.type() == QEvent.Type.WindowActivate:
            self._on_folder()
        return super().event(event)

    def refresh(self, choose: Sequence[str] | None = None) -> None:
        """List the present content of the library.

        Args:
            choose: The names to be selected; by default those selected before.
        """
        self._work.do(
            lambda: (self._watch.times(), self._actions.listing(), self._presence.others()),
            lambda seen: self._show_listing(choose, *seen),
            lambda text: self._show_message(text, Level.FAULT),
        )

    def _show_listing(
        self,
        choose: Sequence[str] | None,
        times: FolderTimes,
        listing: Listing,
        others: Sequence[str],
    ) -> None:
        names = self._chosen_names() if choose is None else list(choose)
        self._show_marks()
        self._choices.follow(listing.entries, self.editors.__contains__)
        changed = self._model.show(listing.entries, listing.drafts)
        self._watch.on_listed(times, listing.folders)
        self._folder_bar.show_listing(listing)
        self.editors.show_folders({each.name: each.folder for each in listing.entries})
        self._shared_use.show_others(others)
        self._name_bar.refresh_suggestion()
        self._deleted.refresh()
        self._actions.show_acts()
        if choose:
            self._uncover(names)
        self._estimates.start()
        if changed or choose is not None:
            self._table.choose(names, show=choose is not None)
            if choose is not None:
                self._show_chosen()
        self._drop_unchosen()
        self._show_hint()

    def _drop_unchosen(self) -> None:
        """Drop the check of a trajectory if none is selected any more."""
        if not self.chosen():
            self._run_bar.drop_check()
            self._drop_findings()

    def _on_operating_state(self, _operating_state: OperatingState) -> None:
        if self.isVisible():
            self._show_marks()

    def _show_marks(self) -> None:
        """Show only check marks that are valid for this arm and its present limits."""
        arm = arm_model(self._controller)
        self._model.show_for(arm)

    def _uncover(self, names: Sequence[str]) -> None:
        """End the search, and list all folders, where they hide new entries."""
        if not set(self._table.names()).issuperset(names):
            self._bar.search.clear()
        if not set(self._table.names()).issuperset(names):
            self._folder_bar.show_all()

    def _on_folder(self) -> None:
        """List a changed folder again, unless a name is being typed."""
        if self.isVisible() and not self._table.is_editing:
            self.refresh()

    def _on_search(self, text: str) -> None:
        self._shown.setFilterFixedString(text)
        self._show_folder()

    def _show_folder(self) -> None:
        """List one folder, unless a text is searched for; new entries are stored in it."""
        folder = self._folder_bar.shown
        self._library.new_in = folder
        self._shown.show_folder(folder)
        self._model.show_folders(shown=not folder or bool(self._bar.search.text()))
        self._show_usable()  # Qt emits no signal when selected rows are filtered out
        self._drop_unchosen()
        self._show_hint()

    def _show_hint(self) -> None:
        searched = self._bar.search.text() if self._model.rowCount() else ""
        self._hint.show_state(self._shown.rowCount(), searched, self._folder_bar.shown)

    def _on_action(self, names: Sequence[str] | None) -> None:
        """List the result, and focus the list: the pressed button may be disabled now."""
        self.refresh(names)
        self._table.setFocus()

    def _on_recording_kept(self, name: str) -> None:
        self.refresh([name])
        self._show_message(self.tr("Saved as “{name}”.").format(name=name), Level.DONE)

    def _on_recording_discarded(self, name: str) -> None:
        self.refresh()
        self._show_message(self.tr("Deleted: {names}").format(names=name), Level.DONE)

    def _on_imported(self, names: Sequence[str]) -> None:
        self._actions.note_imported(names)
        self.refresh(names)

    def chosen(self) -> list[IndexEntry]:
        """Return the selected entries, from top to bottom."""
        return self._table.chosen()

    def _why_runs(self, names: Sequence[str]) -> str:
        """Return why these stay as they are: one of them runs, or is paused; "" if none does."""
        progress = self._run_bar.progress
        runs = progress.phase not in OVER and progress.name in names
        text = self.tr("“{name}” is running. End its run first.")
        return text.format(name=progress.name) if runs else ""

    def _why_used(self, names: Sequence[str]) -> str:
        name = next(filter(self.editors.__contains__, names), "")
        text = self.tr("“{name}” is open. Close its window first.").format(name=name)
        return self._why_runs(names) or (text if name else "")

    def _show_kept(self) -> None:
        self._bar.show_kept(self._why_runs(self._chosen_names()))

    def _show_usable(self, *_: object) -> None:
        chosen = self.chosen()
        self._show_kept()
        self._bar.show_chosen(chosen)
        self._folder_bar.show_chosen()
        one = chosen[0] if len(chosen) == 1 else None
        recording = one is not None and one.kind == "recording"
        none = SEVERAL_CHOSEN() if chosen else NO_ROWS_CHOSEN()
        nothing = none if one is None else self._model.why_empty(one)
        name, count, speeds = ("", 0, ()) if one is None else (one.name, one.count, one.speeds)
        self._run_bar.show_content(
            name,
            count,
            speeds=speeds,
            recording=recording,
            nothing=nothing,
            state=None if one is None else one.modified,
            unsaved=one is not None and self._model.has_unsaved(one.name),
        )
        self._run_bar.show_secondary(one is not None and self._model.has_errors(one))
        if chosen:  # while the list is rebuilt, nothing is selected for a moment
            self._run_bar.drop_check(but=name)
            if name != self._found_of:
                self._drop_findings()
            if self._message_of not in ("", name):
                self._show_message("")

    # Durations --------------------------------------------------------------------------------

    def _estimate(self) -> None:
        """Estimate some unknown lengths in the background, then the next ones while visible."""
        names = self._model.unestimated()
        if not names or self._estimating or not self.isVisible():
            return
        arm = self._checks.arm
        self._estimating = True

        def known(estimates: Mapping[str, float | None]) -> None:
            self._estimating = False
            self._model.note_estimates(estimates, arm)
            if estimates:  # else the files are gone, or the disk must be read again first
                self._estimate()

        def refused(_text: str) -> None:
            self._estimating = False  # the next listing tries again, and shows the reason

        self._work.do(lambda: self._library.estimate(names, arm), known, refused)

    def _to_estimate(self, then: Callable[[Content | None], object]) -> None:
        """Pass on the selected content once it is read, without any message."""
        chosen = self._chosen_names()
        if len(chosen) != 1 or self._model.is_unsaved(chosen[0]):
            then(None)
            return
        self._work.do(lambda: self._library.load(chosen[0]), then, lambda _text: then(None))

    # Opening ----------------------------------------------------------------------------------

    def _on_double_click(self, index: QModelIndex) -> None:
        self.open_trajectory(index.data(ENTRY_ROLE).name)

    def _on_click(self, index: QModelIndex) -> None:
        """List what a check finds where the mark of one that found something is clicked."""
        entry = index.data(ENTRY_ROLE)
        told = entry.name == self._found_of or self._run_bar.is_checking
        if index.column() == LibraryColumn.CHECK and self._model.has_findings(entry) and not told:
            self._run_bar.check()

    def open_trajectory(self, name: str) -> None:
        """Open the editor of a trajectory, with its unsaved changes."""
        self.editors.open(name, unsaved=self._model.is_unsaved(name))

    def open_file(self, path: Path) -> None:
        """Open the content of a file, after importing it; nothing moves."""
        self.open()
        self._exchange.open_file(path)

    def open_recorder(self) -> None:
        """Open the page that records."""
        self.editors.open_recorder()

    def _lead_to(self, page: Page) -> None:
        page.above = self
        self.page_made.emit(page)

    def _on_recorder(self, recorder: RecordingPage) -> None:
        recorder.preview_wanted.connect(self.preview_wanted)

    def keep_work(self) -> None:
        """Save all drafts and unregister from the library, because the program ends."""
        self.editors.keep_drafts()
        self._work.do(self._presence.leave)

    # Running ----------------------------------------------------------------------------------

    def _to_run(self, then: Callable[[Content | None], object]) -> None:
        """Pass on the selected content once it is read, unless the selection has changed."""
        chosen = self._chosen_names()
        if len(chosen) != 1:
            none = NO_ROWS_CHOSEN()
            self._show_message(partial(words.refusal, none), Level.WARNING)
            then(None)
        elif self._model.is_unsaved(chosen[0]):
            text = self.tr("“{name}” is not saved yet. Open it and save it first.")
            self._show_message(text.format(name=chosen[0]), Level.WARNING)
            then(None)
        else:

            def refused(text: str) -> None:
                self._on_refused(text)
                then(None)

            self._work.do(
                lambda: self._library.load(chosen[0]),
                lambda content: then(content if self._chosen_names() == chosen else None),
                refused,
            )

    def _mark(self, checked: Preflight) -> None:
        """Have the library keep how a check of all rows ended, and show it in the list."""
        name = checked.content.name
        if checked.whole:
            self._work.do(
                lambda: self._library.mark(name, check=checked.mark, arm=checked.fingerprint),
                refused=self._on_refused,
            )
        self.refresh()

    def _show_check(self, checked: Preflight, accept: Callable[[], object] | None) -> None:
        self._found_of = checked.content.name
        self._model.note_found(self._found_of if checked.findings else "")
        self._mark(checked)
        self._show_message("")
        found = self._findings.show_check(checked, accept)
        self._findings.setVisible(bool(checked.findings) or accept is not None)
        self.bring_into_sight(self._findings)
        self.preview_wanted.emit(found)

    def _drop_findings(self) -> None:
        """Drop the check, and remove its path from the picture."""
        if self._found_of:
            self.preview_wanted.emit(None)
        self._found_of = ""
        self._model.note_found("")
        self._findings.clear()

    def _on_progress(self, progress: Progress) -> None:
        self._show_kept()
        if ended_early(progress):
            text = self.tr("“{name}” ended after {done} of the recording. {reason}")
            if progress.count:
                text = self.tr("“{name}” ended at row {row}. {reason}")
            row, done = progress.index + 1, fmt.percent(100.0 * progress.done)
            reason = words.why_ended(progress.refusal)
            text = text.format(name=progress.name, row=row, done=done, reason=reason)
            self._show_message(
                text.rstrip(), Level.INFO if progress.refusal is None else Level.FAULT
            )
            self._shows_end = True
        elif self._shows_end:
            self._show_message("")  # the end of an earlier run

    def _on_run_refused(self, reason: Refusal) -> None:
        self._show_message(partial(words.refusal, reason), Level.WARNING)
        self._message_of = next(iter(self._chosen_names()), "")

    def _on_obstacle_gone(self) -> None:
        if self._message_of:
            self._show_message("")

    def _on_started(self, name: str, options: RunOptions) -> None:
        self._work.do(lambda: self._library.note_run(name, options), refused=self._on_refused)

    def _create(self) -> None:
        """Ask for the name of a new trajectory; Enter opens its editor."""
        self._name_bar.ask(
            NameQuestion(
                label=lambda: self.tr("Name of the trajectory"),
                act=lambda: self.tr("Create"),
                suggest=lambda: free_name(self.tr("Trajectory"), self._model.names),
                why_not=self._why_not_called,
                give=self._on_named,
            )
        )
        self.bring_into_sight(self._name_bar)

    def _why_not_called(self, name: str) -> Refusal | None:
        return NAME_TAKEN(name=name) if name in self._model.names else check_name(name)

    def _on_named(self, name: str) -> None:
        def made(trajectory: Trajectory) -> None:
            self._name_bar.put_away()
            self.editors.open_editor(trajectory)

        def refused(text: str) -> None:
            self._name_bar.refuse(text)
            self.refresh()  # somebody else may have taken the name

        self._actions.create(name, made, refused)

    def _chosen_names(self) -> list[str]:
        return [entry.name for entry in self.chosen()]

    def _export(self, suffix: str) -> None:
        self._exchange.export(self._chosen_names(), suffix)

    def _on_refused(self, text: str) -> None:
        """Show a refusal of the library."""
        self.refresh()  # it may be refused because somebody else has changed the library
        self._show_message(text, Level.FAULT)

    # Texts ------------------------------------------------------------------------------------

    def _show_message(self, text: Words, level: Level = Level.INFO) -> None:
        self._shows_end, self._message_of = False, ""
        self._exchange.withdraw_offers()
        self._message.show_message(text, level)
        for part in self._below:  # a message of many lines must not put its buttons out of sight
            self.bring_into_sight(part)

    def take_focus(self) -> None:
        """Focus the list."""
        self._table.setFocus()

    def headers(self) -> Mapping[str, QHeaderView]:
        """Return the list's header, whose order and columns are stored."""
        return {"library": self._table.horizontalHeader()}

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Trajectory library"))
        self._bar.retranslate()
        self._folder_bar.retranslate()
        for part in self.act_parts():
            part.show_acts()
        self._table.setAccessibleName(self.tr("Trajectory library"))
        self._model.retranslate()
        self._show_usable()
