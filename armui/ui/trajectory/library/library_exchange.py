"""Import of trajectories from files and export to files, by the buttons of 轨迹库."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import QCoreApplication, QEvent, QMimeData, QObject, QSize, Qt, Signal
from PySide6.QtGui import QDragMoveEvent, QDropEvent
from PySide6.QtWidgets import QFileDialog, QHeaderView, QTableWidgetItem, QWidget
from shiboken6 import isValid

from armui.arm.refusal import Refusal
from armui.cell.tools import Tool
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.control.run.preflight import Checks, Preflight
from armui.system.atomic import write_whole
from armui.system.files import error_text
from armui.trajectory import files
from armui.trajectory.files import Content, TrajectoryFileError
from armui.trajectory.library.file_names import file_stem
from armui.trajectory.library.importing import Imported
from armui.trajectory.library.run_options import RunOptions
from armui.trajectory.library.store import Library, LibraryError
from armui.trajectory.planning.findings import Finding
from armui.trajectory.points.program import OF_FLANGE, PosesOf
from armui.ui import format as fmt
from armui.ui import words
from armui.ui.actions.act import Act, HasActs
from armui.ui.actions.operator_view import why_taken
from armui.ui.background import Job, Steps, in_order
from armui.ui.dialogs.base import ArmDialog, CloseButton
from armui.ui.dialogs.files import FileDialog, choose_file
from armui.ui.trajectory.library.can_logs import find_or_import_but_logs, import_all_but_logs
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.table_import.columns_page import ColumnsOffer
from armui.ui.widgets.layouts import STRETCH, fill
from armui.ui.widgets.table_model import plain_table
from armui.ui.widgets.text_label import text_label
from armui.ui.words.findings import placed_finding

_PATTERNS: Final = "*.armui *.log *.csv *.json *.jsonl *.npz *.ppr *.tsv *.txt *.yaml *.yml"

Problem = tuple[str, str]
"""The name of a file or trajectory, and the system's error text."""


def choose_imports(
    parent: QWidget, controller: ArmController, on_chosen: Callable[[list[Path]], object]
) -> FileDialog:
    """Let the operator choose files to import, several at once."""
    kinds = QCoreApplication.translate("LibraryFiles", "Trajectories")
    every = QCoreApplication.translate("LibraryFiles", "All files")
    dialog = FileDialog(
        controller,
        parent,
        title=QCoreApplication.translate("LibraryFiles", "Import files"),
        name_filter=f"{kinds} ({_PATTERNS});;{every} (*)",
    )
    dialog.setFileMode(QFileDialog.FileMode.ExistingFiles)
    dialog.filesSelected.connect(lambda names: on_chosen([Path(name) for name in names]))
    dialog.show()
    return dialog


def choose_export(
    parent: QWidget,
    controller: ArmController,
    name: str,
    suffix: str,
    on_chosen: Callable[[Path], object],
) -> FileDialog:
    """Let the operator choose the file for one trajectory."""
    return choose_file(
        parent,
        controller,
        title=QCoreApplication.translate("LibraryFiles", "Export file"),
        name_filter=f"{suffix} (*{suffix})",
        on_chosen=on_chosen,
        new_file=file_stem(name) + suffix,
    )


def choose_folder(
    parent: QWidget, controller: ArmController, on_chosen: Callable[[Path], object]
) -> FileDialog:
    """Let the operator choose the folder for several trajectories."""
    dialog = FileDialog(
        controller,
        parent,
        title=QCoreApplication.translate("LibraryFiles", "Export files into a folder"),
        name_filter="*",
    )
    dialog.setFileMode(QFileDialog.FileMode.Directory)
    dialog.setOption(QFileDialog.Option.ShowDirsOnly, on=True)
    dialog.fileSelected.connect(lambda chosen: on_chosen(Path(chosen)))
    dialog.show()
    return dialog


def write_one(content: Content, path: Path, poses_of: PosesOf = OF_FLANGE) -> Problem | None:
    """Write a trajectory completely or not at all; return ``None``, or the error."""
    try:
        write_whole(path, files.to_bytes(content, path.suffix, poses_of))
    except (OSError, ValueError) as error:
        return path.name, error_text(error)
    return None


Failure = Problem | LibraryError | TrajectoryFileError
"""The reason why one of several trajectories was not written."""


def write_all(
    library: Library, names: Sequence[str], path_of: Callable[[str], Path], poses_of: PosesOf
) -> tuple[list[str], list[Failure]]:
    """Write trajectories of the library to files, each independently; see `files.to_bytes`.

    Returns:
        The names of the files written, and the failures of the others.
    """
    written: list[str] = []
    failures: list[Failure] = []
    for name in names:
        try:
            content = library.load(name)
        except (LibraryError, TrajectoryFileError) as error:
            failures.append(error)
            continue
        path = path_of(name)
        problem = write_one(content, path, poses_of)
        if problem is None:
            written.append(path.name)
        else:
            failures.append(problem)
    return written, failures


def free_path(folder: Path, name: str, suffix: str) -> Path:
    """Return a path for a trajectory in a folder that does not exist yet."""
    stem = file_stem(name)
    path, number = folder / f"{stem}{suffix}", 1
    while path.exists():
        number += 1
        path = folder / f"{stem} {number}{suffix}"
    return path


_SIZE: Final = QSize(860, 520)
_FILE_PX: Final = 260


@dataclass(frozen=True, slots=True)
class Result:
    """The result for one file.

    Attributes:
        file: Its name.
        name: The name of its content in the library; "" if it was not imported.
        requested: The name given in the file, which differs from `name` if it was taken.
        problem: The reason why it was not imported; "" if it was.
        notes: Differences of tool and frames from those that its poses were written with.
    """

    file: str
    name: str = ""
    requested: str = ""
    problem: str = ""
    notes: tuple[str, ...] = ()


class ImportReport(ArmDialog):
    """A line for each file, those that were not imported first.

    Args:
        controller: Receives the emergency stop.
        results: The results of all files.
        parent: The window it belongs to.
    """

    def __init__(
        self, controller: ArmController, results: Sequence[Result], parent: QWidget | None = None
    ) -> None:
        super().__init__(controller, parent)
        self._results = sorted(results, key=lambda result: not result.problem)
        self._summary = text_label("report_summary")
        self._table = plain_table("report_table", 2, wide=1)
        self._table.setRowCount(len(results))
        self._table.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self._table.setColumnWidth(0, _FILE_PX)
        fill(self.body, self._summary, (self._table, 1))
        fill(self.footer, STRETCH, CloseButton(self, on_enter=True))
        self.retranslate_ui()
        self.resize(_SIZE)

    def retranslate_ui(self) -> None:
        """Set all texts in the operator's language."""
        self.set_title(self.tr("Import results"))
        taken = sum(not result.problem for result in self._results)
        text = self.tr("{taken} imported, {left} not imported.")
        self._summary.setText(text.format(taken=taken, left=len(self._results) - taken))
        self._table.setHorizontalHeaderLabels([self.tr("File"), self.tr("Result")])
        self._table.setAccessibleName(self.tr("Import results"))
        for row, result in enumerate(self._results):
            for column, cell in enumerate((result.file, self._result_text(result))):
                item = QTableWidgetItem(cell)
                item.setToolTip(cell)
                self._table.setItem(row, column, item)

    def _result_text(self, result: Result) -> str:
        """A sign and a sentence."""
        if result.problem:
            return f"✕ {result.problem}"
        return "\n".join((self._name_text(result), *(f"! {note}" for note in result.notes)))

    def _name_text(self, result: Result) -> str:
        if result.name != result.requested:
            text = self.tr("✓ As “{name}”: the name “{requested}” was taken")
            return text.format(name=result.name, requested=result.requested)
        return self.tr("✓ As “{name}”").format(name=result.name)


class FileDrop(QObject):
    """Lets files be dropped on a widget; they are read, never moved.

    Args:
        target: The widget.

    Signals:
        dropped: The paths of the files.
    """

    dropped = Signal(object)

    def __init__(self, target: QWidget) -> None:
        super().__init__(target)
        target.setAcceptDrops(True)
        target.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Accept dropped files, and nothing else."""
        kinds = {QEvent.Type.DragEnter, QEvent.Type.DragMove, QEvent.Type.Drop}
        if event.type() not in kinds or not isinstance(event, QDropEvent | QDragMoveEvent):
            return super().eventFilter(watched, event)
        paths = _files(event.mimeData())
        if paths:
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
        else:
            event.ignore()
        if paths and event.type() == QEvent.Type.Drop:
            self.dropped.emit(paths)
        return True


def _files(data: QMimeData) -> list[Path]:
    """Files of this computer; a link to a page is none."""
    return [Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile()]


_MOST_PROBLEMS: Final = 3
"""The most problems shown in the message itself."""


class LibraryExchange(HasActs, QObject):
    """Imports valid files, never overwrites silently, and reports the results.

    Args:
        controller: Receives the emergency stop.
        checks: Reads files, and checks what is in them.
        work: Runs actions on the library.
        window: The parent of the choosers.

    Attributes:
        by_columns: Offers to import files that are not in a format of ours.
        report: The button that shows the result of each of several files, as long as their message.

    Signals:
        message_changed: A text, or a function that returns it, and its :class:`Level`.
        imported: The names of imported trajectories.
        checked: The :class:`Preflight` of one that was imported.
        found: The name of a trajectory to be opened, when its file has been imported.
    """

    message_changed = Signal(object, object)
    imported = Signal(object)
    checked = Signal(object)
    found = Signal(str)
    report = Act("Results…", named="library_report", key="library.report")

    def __init__(
        self, controller: ArmController, checks: Checks, work: LibraryWork, window: QWidget
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._checks = checks
        self._background = checks.background
        self._to_check: Sequence[str] = ()
        self._work = work
        self._library = work.library
        self._window = window
        self.by_columns = ColumnsOffer(work, controller, window)
        self._results: Sequence[Result] = ()
        self.by_columns.imported.connect(self._on_by_columns)
        self.by_columns.refused.connect(lambda text: self.message_changed.emit(text, Level.FAULT))

    def withdraw_offers(self) -> None:
        """Hide the offers, because another message is shown."""
        self.by_columns.show_for(())
        self._offer_report(())
        self._to_check = ()

    def _offer_report(self, results: Sequence[Result]) -> None:
        """Offer the report of these results, or none."""
        self._results = results
        self.show_acts()

    @report.there
    def _has_report(self) -> bool:
        return bool(self._results)

    @report.pressed
    def _open_report(self) -> None:
        report = ImportReport(self._controller, self._results, self._window.window())
        report.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        report.open()

    def choose_imports(self) -> None:
        """Let the operator choose files to import."""
        choose_imports(self._window, self._controller, self.import_files)

    def import_files(self, paths: Sequence[Path]) -> None:
        """Import the valid ones among some files in the background, and report the others.

        Unknown tables are offered for import by columns; where there is nothing else to tell, that
        page opens at once.
        """
        if taken := why_taken("library.import"):
            self.message_changed.emit(taken, Level.WARNING)
        elif paths:
            self._show_reading(paths)
            self._background.begin(
                Job(self._on_imported),
                import_all_but_logs,
                self._library.folder,
                list(paths),
                self._library.new_in,
            )

    def open_file(self, path: Path) -> None:
        """Find a file's content in the library, or import it: see `found`."""
        self._show_reading([path])
        self._background.begin(
            *(Job(self._on_found), find_or_import_but_logs),
            *(self._library.folder, path, self._library.new_in),
        )

    def _show_reading(self, paths: Sequence[Path]) -> None:
        names = fmt.name_list([path.name for path in paths])
        self.message_changed.emit(self.tr("Reading {names}…").format(names=names), Level.INFO)

    def _on_found(self, found: Imported | Refusal) -> None:
        if not isValid(self):
            return  # the program is ending
        if isinstance(found, Imported) and found.was_there:
            self.message_changed.emit("", Level.INFO)
        else:
            self._on_imported(found if isinstance(found, Refusal) else [found])
        if isinstance(found, Imported) and found.name:
            self.found.emit(found.name)

    def _on_imported(self, imported: list[Imported] | Refusal) -> None:
        if not isValid(self):
            return  # the program is ending
        if isinstance(imported, Refusal):
            self.imported.emit([])
            self.message_changed.emit(words.refusal(imported), Level.FAULT)
            return
        results = list(map(self._result, imported))
        names = [one.name for one in imported if one.name]
        self.imported.emit(names)
        failed = any(result.problem or result.notes for result in results)
        message = partial(self._imported_text, imported)
        tables = [one.path for one in imported if one.is_table]
        self._show_checked(message, names, Level.WARNING if failed else Level.DONE)
        self.by_columns.show_for(tables)
        self._offer_report(results if len(results) > 1 else ())
        if tables and len(tables) == len(imported):
            self.by_columns.lead()

    def _show_checked(self, message: Callable[[], str], names: Sequence[str], level: Level) -> None:
        """Say what was imported, and once it is checked, what of it this arm cannot do."""
        self.message_changed.emit(message, level)
        # the check is dropped when this changes, because another message is shown
        self._to_check = names
        in_order(self._check(names, message), lambda: isValid(self) and self._to_check is names)

    def _check(self, names: Sequence[str], message: Callable[[], str]) -> Steps:
        beyond: list[tuple[str, Finding]] = []
        # one at a time, so that other requests wait for one step at most
        for name in names:
            content = yield partial(self._work.do, partial(self._library.load, name))
            checked = yield partial(self._checks.begin, content, RunOptions())
            if not isinstance(checked, Refusal):
                self.checked.emit(checked)
                beyond += _beyond(checked)
        if beyond:
            paths, results = self.by_columns.paths, self._results
            self.message_changed.emit(partial(self._beyond_text, message, beyond), Level.WARNING)
            self.by_columns.show_for(paths)
            self._offer_report(results)

    def _beyond_text(
        self, message: Callable[[], str], beyond: Sequence[tuple[str, Finding]]
    ) -> str:
        text = self.tr("The arm cannot run “{name}”. {reason}")
        lines = [text.format(name=name, reason=placed_finding(found)) for name, found in beyond]
        rest = self.tr("And {count} more. Open it and press Check to see them.")
        return "\n".join([message(), *_problem_lines(lines, "{reason}", rest)])

    def _imported_text(self, imported: Sequence[Imported]) -> str:
        """Return what became of some files, in as few lines as an operator reads."""
        results = list(map(self._result, imported))
        taken = [result.name for result in results if not result.problem]
        moved = [
            f"{result.requested} → {result.name}"
            for result in results
            if result.name != result.requested
        ]
        lines = []
        if taken:
            lines.append(self.tr("Imported: {names}").format(names=fmt.name_list(taken)))
        if moved:
            text = self.tr("Their names were taken, so they got others: {names}")
            lines.append(text.format(names=fmt.name_list(moved)))
        notes = [note for result in results for note in result.notes]
        lines += _problem_lines(notes, "{reason}", self.tr("And {count} more. See the results."))
        tables = [each.path.name for each in imported if each.is_table]
        several = len(tables) > 1  # the text has one line for all of them
        if several:
            lines.append(self._not_imported_text(tables))
        problems = [
            result.problem
            for each, result in zip(imported, results, strict=True)
            if result.problem and not (several and each.is_table)
        ]
        asked = len(tables) == len(imported)
        one = self.tr("Not imported yet. {reason}") if asked else self.tr("Not imported. {reason}")
        rest = self.tr("Not imported either: {count} more. See the results.")
        return "\n".join([*lines, *_problem_lines(problems, one, rest)])

    def _not_imported_text(self, names: Sequence[str]) -> str:
        text = self.tr("Not imported yet: {names}. Press “Import by columns…”.")
        return text.format(names=fmt.name_list(names))

    def _result(self, imported: Imported) -> Result:
        tool, cell = self._controller.cartesian.tool, self._controller.cell.cell
        return _result(imported, tuple(map(words.refusal, imported.differences(tool, cell))))

    def _on_by_columns(self, name: str) -> None:
        """Report one imported table, and offer the others that are left."""
        left = self.by_columns.paths

        def message() -> str:
            text = self.tr("Imported: {names}").format(names=name)
            if left:
                text += "\n" + self._not_imported_text([path.name for path in left])
            return text

        self.imported.emit([name])
        self._show_checked(message, [name], Level.DONE)
        self.by_columns.show_for(left)

    def export(self, names: Sequence[str], suffix: str) -> None:
        """Let the operator choose a target, and write trajectories there in a format."""
        if len(names) == 1:
            choose_export(
                self._window,
                self._controller,
                names[0],
                suffix,
                lambda path: self._write(names, lambda _name: path),
            )
        else:
            choose_folder(
                self._window,
                self._controller,
                lambda folder: self._write(names, lambda name: free_path(folder, name, suffix)),
            )

    def _write(self, names: Sequence[str], path_of: Callable[[str], Path]) -> None:
        """Write each trajectory; failures do not keep the others from being written."""
        cell, tool = self._controller.cell.cell, self._controller.cell.holding().tool
        of = PosesOf(tool if any(tool.pose) else None, () if cell is None else cell.all_frames)
        self._work.do(
            lambda: write_all(self._library, names, path_of, of),
            partial(self._on_written, of.tool),
            lambda text: self.message_changed.emit(text, Level.FAULT),
        )

    def _on_written(self, tool: Tool | None, result: tuple[list[str], list[Failure]]) -> None:
        written, failures = result
        problems = [_problem_text(failure) for failure in failures]
        lines = []
        if written:
            lines.append(self.tr("Exported: {names}").format(names=fmt.name_list(written)))
        if tool is not None and any(not name.endswith(".armui") for name in written):
            named = self.tr("the tool “{name}”").format(name=tool.name)
            text = self.tr("Poses in it are those of {tool}, as the editor shows them.")
            lines.append(text.format(tool=named if tool.name else self.tr("the tool")))
        one, rest = self.tr("Not exported. {reason}"), self.tr("Not exported either: {count} more.")
        lines += _problem_lines(problems, one, rest)
        self.message_changed.emit("\n".join(lines), Level.FAULT if problems else Level.DONE)


def _beyond(checked: Preflight) -> Iterator[tuple[str, Finding]]:
    """Yield the errors of an imported trajectory that hold wherever the arm is, with its name."""
    for found in checked.outcome.errors:
        if not found.is_of_approach:
            yield checked.content.name, found


def _problem_lines(problems: Sequence[str], one: str, rest: str) -> list[str]:
    """Return the first problems, a line each, and how many more there are."""
    lines = [one.format(reason=problem) for problem in problems[:_MOST_PROBLEMS]]
    more = len(problems) - _MOST_PROBLEMS
    return [*lines, rest.format(count=more)] if more > 0 else lines


def _problem_text(failure: Failure) -> str:
    if isinstance(failure, LibraryError):
        return words.refusal(failure.refusal)
    if isinstance(failure, TrajectoryFileError):
        return words.file_error(failure)
    return f"{failure[0]}: {failure[1]}"


def _result(imported: Imported, notes: tuple[str, ...]) -> Result:
    error, file = imported.error, imported.path.name
    if error is None:
        return Result(file, imported.name, imported.requested, notes=notes)
    if isinstance(error, LibraryError):
        return Result(file, problem=f"{file}: {words.refusal(error.refusal)}")
    return Result(file, problem=words.file_error(error))
