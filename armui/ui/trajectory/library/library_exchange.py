"""Trajectories into the library from files, and out of it: what the buttons of 轨迹库 do."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Final

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget
from shiboken6 import isValid

from armui.arm.refusal import Refusal
from armui.control.arm_controller import ArmController
from armui.control.events import Level
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import Imported, LibraryError, import_files
from armui.ui import words
from armui.ui.background import Background, Job
from armui.ui.trajectory.library import library_files
from armui.ui.trajectory.library.import_report import ReportButton, Result
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.table_import.columns_offer import ColumnsOffer
from armui.ui.trajectory.text import name_list

_MOST_PROBLEMS: Final = 3
"""That are told in the message itself."""


class LibraryExchange(QObject):
    """Imports what is whole, writes over nothing unseen, and says what came of it.

    Args:
        controller: Whom the emergency stop in the file choosers tells.
        background: Where files are read.
        work: Has the library take and give the trajectories.
        window: The choosers belong to it.

    Attributes:
        by_columns: The button for files that are not in a format of ours.
        report: The button that shows what became of each of several files.

    Signals:
        said: A text, or what makes it in any language, and its :class:`Level`.
        imported: The names of what was taken over.
    """

    said = Signal(object, object)
    imported = Signal(object)

    def __init__(
        self, controller: ArmController, background: Background, work: LibraryWork, window: QWidget
    ) -> None:
        super().__init__(window)
        self._controller = controller
        self._background = background
        self._work = work
        self._library = work.library
        self._window = window
        self.by_columns = ColumnsOffer(work, window)
        self.report = ReportButton(controller, window)
        self.by_columns.imported.connect(self._on_by_columns)
        self.by_columns.refused.connect(lambda text: self.said.emit(text, Level.FAULT))

    def withdraw_offers(self) -> None:
        """Something else is said by now."""
        self.by_columns.show_for(())
        self.report.show_for(())

    def choose_imports(self) -> None:
        """Let the operator choose files to import."""
        library_files.choose_imports(self._window, self._controller, self.import_files)

    def import_files(self, paths: Sequence[Path]) -> None:
        """Take over what is whole of some files, beside the window; each of the others is told.

        Tables of another build are offered by columns.
        """
        if paths:
            text = self.tr("Reading {names}…").format(
                names=name_list([path.name for path in paths])
            )
            self.said.emit(text, Level.INFO)
            self._background.begin(
                Job(self._on_imported), import_files, self._library.folder, list(paths)
            )

    def _on_imported(self, imported: list[Imported] | Refusal) -> None:
        if not isValid(self):
            return  # the program is ending
        if isinstance(imported, Refusal):
            self.imported.emit([])
            self.said.emit(words.refusal(imported), Level.FAULT)
            return
        results = [_result(one) for one in imported]
        self.imported.emit([one.name for one in imported if one.name])
        failed = any(result.problem for result in results)
        told = partial(self._tell_of, imported)
        self.said.emit(told, Level.WARNING if failed else Level.DONE)
        self.by_columns.show_for([one.path for one in imported if one.is_table])
        self.report.show_for(results if len(results) > 1 else ())

    def _tell_of(self, imported: Sequence[Imported]) -> str:
        """What became of some files, in as few lines as an operator reads."""
        results = [_result(one) for one in imported]
        taken = [result.name for result in results if not result.problem]
        moved = [
            f"{result.requested} → {result.name}"
            for result in results
            if result.name != result.requested
        ]
        lines = []
        if taken:
            lines.append(self.tr("Imported: {names}").format(names=name_list(taken)))
        if moved:
            text = self.tr("Their names were taken, so they got others: {names}")
            lines.append(text.format(names=name_list(moved)))
        problems = [result.problem for result in results if result.problem]
        one = self.tr("Not imported. {reason}")
        rest = self.tr("Not imported either: {count} more. See the results.")
        return "\n".join([*lines, *_problem_lines(problems, one, rest)])

    def _on_by_columns(self, name: str) -> None:
        """One is done; the others are still offered."""
        left = self.by_columns.paths
        self.imported.emit([name])
        text = self.tr("Imported: {names}").format(names=name)
        if left:
            names = ", ".join(path.name for path in left)
            text += "\n" + self.tr("Not imported yet: {names}").format(names=names)
        self.said.emit(text, Level.DONE)
        self.by_columns.show_for(left)

    def export(self, names: Sequence[str], suffix: str) -> None:
        """Let the operator say where to, and write trajectories there in a format."""
        if len(names) == 1:
            library_files.choose_export(
                self._window,
                self._controller,
                names[0],
                suffix,
                lambda path: self._write(names, lambda _name: path),
            )
        else:
            library_files.choose_folder(
                self._window,
                self._controller,
                lambda folder: self._write(
                    names, lambda name: library_files.free_path(folder, name, suffix)
                ),
            )

    def _write(self, names: Sequence[str], path_of: Callable[[str], Path]) -> None:
        """Write each; one that cannot be written keeps none of the others back."""
        self._work.do(
            lambda: library_files.write_all(self._library, names, path_of),
            self._on_written,
            lambda text: self.said.emit(text, Level.FAULT),
        )

    def _on_written(self, result: tuple[list[str], list[library_files.Failure]]) -> None:
        written, failures = result
        problems = [_problem_text(failure) for failure in failures]
        lines = []
        if written:
            lines.append(self.tr("Exported: {names}").format(names=name_list(written)))
        one, rest = self.tr("Not exported. {reason}"), self.tr("Not exported either: {count} more.")
        lines += _problem_lines(problems, one, rest)
        self.said.emit("\n".join(lines), Level.FAULT if problems else Level.DONE)


def _problem_lines(problems: Sequence[str], one: str, rest: str) -> list[str]:
    """The first problems, a line each, and how many more there are."""
    lines = [one.format(reason=problem) for problem in problems[:_MOST_PROBLEMS]]
    more = len(problems) - _MOST_PROBLEMS
    return [*lines, rest.format(count=more)] if more > 0 else lines


def _problem_text(failure: library_files.Failure) -> str:
    if isinstance(failure, LibraryError):
        return words.refusal(failure.refusal)
    if isinstance(failure, TrajectoryFileError):
        return words.file_error(failure)
    return f"{failure[0]}: {failure[1]}"


def _result(imported: Imported) -> Result:
    error, file = imported.error, imported.path.name
    if error is None:
        return Result(file, imported.name, imported.requested)
    if isinstance(error, LibraryError):
        return Result(file, problem=f"{file}: {words.refusal(error.refusal)}")
    return Result(file, problem=words.file_error(error))
