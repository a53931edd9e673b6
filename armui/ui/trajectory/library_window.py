"""The window 轨迹库: all trajectories, and what can be done with them (manual figure 1-19)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QModelIndex, QSize, Qt, Signal
from PySide6.QtGui import QAction, QKeySequence, QShowEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLineEdit,
    QMenu,
    QPushButton,
    QWidget,
)

from armui.control.run import Progress
from armui.control.situation import Level
from armui.trajectory.files import SUFFIXES, Content, TrajectoryFileError
from armui.trajectory.library import Deleted, Entry, Library, LibraryError
from armui.trajectory.program import Trajectory
from armui.trajectory.recording import Recording
from armui.ui import words
from armui.ui.dialogs.base import ArmDialog
from armui.ui.trajectory.editor_window import EditorWindow
from armui.ui.trajectory.findings_pane import FindingsPane
from armui.ui.trajectory.library_exchange import LibraryExchange
from armui.ui.trajectory.library_model import (
    ENTRY_ROLE,
    LibraryFilter,
    LibraryModel,
)
from armui.ui.trajectory.library_table import LibraryTable
from armui.ui.trajectory.preflight import Checks, Preflight
from armui.ui.trajectory.recording_window import RecordingWindow
from armui.ui.trajectory.run_strip import RunStrip
from armui.ui.widgets.message_line import MessageLine

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController

_SIZE: Final = QSize(1040, 640)
_BUTTONS: Final = ("import", "create", "record", "delete", "duplicate", "rename", "export")


class LibraryWindow(ArmDialog):
    """The list of the library; a double click opens the second level.

    Args:
        controller: Runs trajectories, and knows where the arm is.
        checks: Checks what is to be run.
        library: What is listed.
        parent: The main window.

    Signals:
        editor_opened: The :class:`EditorWindow` of a trajectory, before it is shown: whoever shows
            previews follows its ``preview_wanted`` and ``selected_row_changed``.
        preview_wanted: A :class:`Preflight` whose path is to be shown in 3D.
    """

    editor_opened = Signal(object)
    preview_wanted = Signal(object)

    def __init__(
        self,
        controller: ArmController,
        checks: Checks,
        library: Library,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(controller, parent)
        self._controller = controller
        self._checks = checks
        self._library = library
        self._editors: dict[str, EditorWindow] = {}
        self._recorder: RecordingWindow | None = None
        self._deleted: Deleted | None = None
        self._model = LibraryModel(self)
        self._shown = LibraryFilter(self._model, self)
        self._search = QLineEdit()
        self._search.setObjectName("library_search")
        self._search.setClearButtonEnabled(True)
        self._search.textChanged.connect(self._shown.setFilterFixedString)
        self._buttons = {name: QPushButton() for name in _BUTTONS}
        self._table = LibraryTable(self._shown)
        self._message = MessageLine()
        self._message.setObjectName("library_message")
        self._undo_button = QPushButton()
        self._undo_button.setObjectName("library_undo")
        self._undo_button.setAutoDefault(False)
        self._undo_button.hide()
        self._undo_button.clicked.connect(self._restore)
        self._exchange = LibraryExchange(controller, library, self)
        self._export_menu = QMenu(self)
        self._findings = FindingsPane()
        self._strip = RunStrip(controller, checks, self._to_run)
        self._lay_out()
        self._connect()
        self.retranslate_ui()
        self.resize(_SIZE)
        self._table.setFocus()

    # Layout -----------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        bar = QHBoxLayout()
        bar.setSpacing(6)
        for name, button in self._buttons.items():
            button.setObjectName(f"library_{name}")
            button.setAutoDefault(False)
            bar.addWidget(button)
        self._buttons["export"].setMenu(self._export_menu)
        bar.addStretch(1)
        bar.addWidget(self._search, 2)
        below = QHBoxLayout()
        below.addWidget(self._message, 1)
        below.addWidget(self._exchange.by_columns)
        below.addWidget(self._undo_button)
        self.body.addLayout(bar)
        self.body.addWidget(self._table, 1)
        self.body.addWidget(self._findings)
        self.body.addWidget(self._strip)
        self.body.addLayout(below)

    def _connect(self) -> None:
        handlers: dict[str, Callable[[], object]] = {
            "import": self._exchange.choose_imports,
            "create": self._create,
            "record": self.open_recorder,
            "delete": self._delete,
            "duplicate": self._duplicate,
            "rename": self._edit_name,
        }
        for name, do in handlers.items():
            self._buttons[name].clicked.connect(lambda _checked=False, do=do: do())
        for suffix in SUFFIXES:
            action = self._export_menu.addAction(suffix)
            action.triggered.connect(partial(self._export, suffix))
        delete = QAction(self._table)
        delete.setShortcut(QKeySequence.StandardKey.Delete)
        delete.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        delete.triggered.connect(self._delete)
        self._table.addAction(delete)
        self._table.doubleClicked.connect(self._on_double_click)
        self._table.selectionModel().selectionChanged.connect(self._show_usable)
        self._model.modelReset.connect(self._show_usable)
        self._model.rename_wanted.connect(self._rename)
        self._exchange.said.connect(self._say)
        self._exchange.imported.connect(self.refresh)
        self._strip.checked.connect(self._show_check)
        self._strip.refused.connect(lambda reason: self._say(words.refusal(reason), Level.WARNING))
        self._strip.progressed.connect(self._on_progress)

    # The list ---------------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        """Look at the folder anew: files may have come or gone."""
        self.refresh()
        super().showEvent(event)

    def refresh(self, choose: Sequence[str] | None = None) -> None:
        """List the library as it is now.

        Args:
            choose: The names to be chosen; those chosen before by default.
        """
        names = list(choose) if choose is not None else [one.name for one in self.chosen()]
        try:
            self._model.show(self._library.entries(), self._library.drafts())
        except LibraryError as error:
            self._say(words.refusal(error.refusal), Level.FAULT)
            return
        self._table.choose(names)
        if not self.chosen():
            self._strip.drop_check()

    def chosen(self) -> list[Entry]:
        """The chosen entries, from top to bottom."""
        return self._table.chosen()

    def _show_usable(self, *_: object) -> None:
        count = len(self.chosen())
        self._buttons["delete"].setEnabled(count > 0)
        self._buttons["export"].setEnabled(count > 0)
        self._buttons["duplicate"].setEnabled(count == 1)
        self._buttons["rename"].setEnabled(count == 1)
        one = self.chosen()[0] if count == 1 else None
        recording = one is not None and one.kind == "recording"
        self._strip.show_content(0 if one is None else one.count, recording=recording)
        if count:  # while the list is made anew, nothing is chosen for a moment
            self._strip.drop_check(but="" if one is None else one.name)
        self._findings.clear()
        missing = self.tr("Choose a trajectory in the list first")
        for name in ("delete", "export", "duplicate", "rename"):
            button = self._buttons[name]
            button.setToolTip("" if button.isEnabled() else missing)

    # Opening ----------------------------------------------------------------------------------

    def _on_double_click(self, index: QModelIndex) -> None:
        self.open_trajectory(index.data(ENTRY_ROLE).name)

    def open_trajectory(self, name: str) -> None:
        """Open the second level of a trajectory, with what was not saved of it."""
        if name in self._editors:
            self._editors[name].open()
            return
        content = self._load(name)
        if isinstance(content, Trajectory):
            self._open_editor(content)
        elif content is not None:
            self.open_recorder(content)

    def open_recorder(self, recording: Recording | None = None) -> None:
        """Open the window that records, or one that trims and thins what was recorded."""
        if self._recorder is not None and self._recorder.isVisible():
            self._recorder.open()
            return
        if self._recorder is not None:
            self._recorder.deleteLater()
        self._recorder = RecordingWindow(
            self._controller, self._library, recording, self.parentWidget()
        )
        self._recorder.saved.connect(lambda name: self.refresh([name]))
        self._recorder.open()

    def _load(self, name: str) -> Content | None:
        try:
            return self._library.load(name)
        except TrajectoryFileError as error:
            self._say(words.file_error(error), Level.FAULT)
        except LibraryError as error:
            self._say(words.refusal(error.refusal), Level.FAULT)
        return None

    def _open_editor(self, trajectory: Trajectory) -> None:
        try:
            draft = self._library.draft(trajectory.name)
        except TrajectoryFileError as error:
            draft = None
            self._say(words.file_error(error), Level.WARNING)
        editor = EditorWindow(
            self._controller,
            self._checks,
            self._library,
            trajectory,
            draft=draft,
            parent=self.parentWidget(),
        )
        self._editors[trajectory.name] = editor
        self.editor_opened.emit(editor)
        editor.saved.connect(self.refresh)
        editor.left.connect(partial(self._on_left, trajectory.name))
        editor.open()

    def _on_left(self, name: str) -> None:
        self._editors.pop(name).deleteLater()
        self.refresh()

    def keep_work(self) -> None:
        """The program ends: what is not saved in an editor is offered the next time."""
        for editor in self._editors.values():
            editor.keep_draft()

    # Running ----------------------------------------------------------------------------------

    def _to_run(self) -> Content | None:
        chosen = self.chosen()
        return self._load(chosen[0].name) if len(chosen) == 1 else None

    def _show_check(self, checked: Preflight, accept: Callable[[], object] | None) -> None:
        name = checked.content.name
        length_s = checked.path.duration_s if checked.order.speed_factor == 1.0 else None
        if not self._attempt(
            lambda: self._library.mark(name, check=checked.mark, length_s=length_s)
        ):
            return
        self.refresh()
        self._say("")
        self._findings.show_check(checked, accept)
        self._findings.setVisible(bool(checked.findings) or accept is not None)
        self.preview_wanted.emit(checked)

    def _on_progress(self, progress: Progress) -> None:
        if progress.reason is not None:
            text = self.tr("“{name}” ended at row {row}. {reason}").format(
                name=progress.name,
                row=progress.index + 1,
                reason=words.refusal(progress.reason),
            )
            self._say(text, Level.FAULT)

    # What the buttons do ----------------------------------------------------------------------

    def _create(self) -> None:
        name = self._library.free_name(self.tr("Trajectory"))
        trajectory = Trajectory(name, modified=datetime.now().astimezone())
        if self._attempt(lambda: self._library.save(trajectory)):
            self.refresh([name])
            self._open_editor(trajectory)

    def _delete(self) -> None:
        names = [entry.name for entry in self.chosen()]
        busy = [name for name in names if name in self._editors]
        if busy:
            self._say(
                self.tr("“{name}” is open. Close its window first.").format(name=busy[0]),
                Level.WARNING,
            )
            return
        if names and self._attempt(lambda: self._take_away(names)):
            self.refresh([])
            text = self.tr("Deleted: {names}").format(names=", ".join(names))
            self._say(text, Level.DONE)
            self._undo_button.show()

    def _take_away(self, names: Sequence[str]) -> None:
        self._deleted = self._library.delete(names)

    def _restore(self) -> None:
        deleted = self._deleted
        if deleted is not None and self._attempt(lambda: self._library.restore(deleted)):
            self._deleted = None
            self.refresh(deleted.names)
            text = self.tr("Brought back: {names}").format(names=", ".join(deleted.names))
            self._say(text, Level.DONE)

    def _duplicate(self) -> None:
        name = self.chosen()[0].name
        new = self._library.free_name(name)
        if self._attempt(lambda: self._library.duplicate(name, new)):
            self.refresh([new])
            self._say("")

    def _edit_name(self) -> None:
        self._table.edit_name()

    def _rename(self, name: str, new: str) -> None:
        if name in self._editors:
            self._say(
                self.tr("“{name}” is open. Close its window first.").format(name=name),
                Level.WARNING,
            )
        elif self._attempt(lambda: self._library.rename(name, new)):
            self.refresh([new])
            self._say("")

    def _export(self, suffix: str) -> None:
        self._exchange.export([entry.name for entry in self.chosen()], suffix)

    def _attempt(self, action: Callable[[], object]) -> bool:
        """Do something with the library; what it refuses is said."""
        try:
            action()
        except LibraryError as error:
            self._say(words.refusal(error.refusal), Level.FAULT)
        except TrajectoryFileError as error:
            self._say(words.file_error(error), Level.FAULT)
        else:
            return True
        return False

    # Words ------------------------------------------------------------------------------------

    def _say(self, text: str, level: Level = Level.INFO) -> None:
        self._undo_button.hide()
        self._exchange.by_columns.offer(())
        self._message.show_message(text, level)

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.set_title(self.tr("Trajectory library"))
        texts = {
            "import": self.tr("Import files"),
            "create": self.tr("Create"),
            "record": self.tr("Record"),
            "delete": self.tr("Delete"),
            "duplicate": self.tr("Duplicate"),
            "rename": self.tr("Rename"),
            "export": self.tr("Export files"),
        }
        for name, text in texts.items():
            self._buttons[name].setText(text)
        self._undo_button.setText(self.tr("Undo"))
        self._search.setPlaceholderText(self.tr("Search"))
        self._table.setAccessibleName(self.tr("Trajectory library"))
        self._model.retranslate()
        self._show_usable()
