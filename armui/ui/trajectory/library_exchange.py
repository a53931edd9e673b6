"""Trajectories into the library from files, and out of it: what the buttons of 轨迹库 do."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from armui.control.situation import Level
from armui.trajectory import columns, files
from armui.trajectory.files import Content, TrajectoryFileError
from armui.trajectory.library import Library, LibraryError
from armui.ui import words
from armui.ui.trajectory import library_files
from armui.ui.trajectory.columns_offer import ColumnsOffer

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class LibraryExchange(QObject):
    """Imports what is whole, writes over nothing unseen, and says what came of it.

    Args:
        controller: Whom the emergency stop in the file choosers tells.
        library: Takes and gives the trajectories.
        window: The choosers belong to it.

    Attributes:
        by_columns: The button for files that are not in a format of ours.

    Signals:
        said: A text and its :class:`Level`.
        imported: The names of what was taken over.
    """

    said = Signal(str, object)
    imported = Signal(object)

    def __init__(self, controller: ArmController, library: Library, window: QWidget) -> None:
        super().__init__(window)
        self._controller = controller
        self._library = library
        self._window = window
        self.by_columns = ColumnsOffer(controller, library, window)
        self.by_columns.imported.connect(self._on_by_columns)
        self.by_columns.refused.connect(lambda text: self.said.emit(text, Level.FAULT))

    def choose_imports(self) -> None:
        """Let the operator choose files to import."""
        library_files.choose_imports(self._window, self._controller, self.import_files)

    def import_files(self, paths: Sequence[Path]) -> None:
        """Take over what is whole of some files; each of the others is told.

        Tables of another build are offered by columns.
        """
        taken: list[str] = []
        problems: list[str] = []
        tables: list[Path] = []
        for path in paths:
            contents, errors = files.import_files([path])
            for content in contents:
                self._take_over(content, taken, problems)
            for error in errors:
                told, is_table = columns.look_closer(path, error)
                problems.append(words.file_error(told))
                tables += [path] if is_table else []
        self.imported.emit(taken)
        texts = []
        if taken:
            texts.append(self.tr("Imported: {names}").format(names=", ".join(taken)))
        texts += [self.tr("Not imported. {reason}").format(reason=text) for text in problems]
        self.said.emit("\n".join(texts), Level.WARNING if problems else Level.DONE)
        self.by_columns.offer(tables)

    def _take_over(self, content: Content, taken: list[str], problems: list[str]) -> None:
        name = self._library.free_name(content.name)
        try:
            self._library.save(replace(content, name=name))
        except LibraryError as error:
            problems.append(f"{content.name}: {words.refusal(error.refusal)}")
        else:
            taken.append(name)

    def _on_by_columns(self, name: str) -> None:
        """One is done; the others are still offered."""
        left = self.by_columns.paths
        self.imported.emit([name])
        text = self.tr("Imported: {names}").format(names=name)
        if left:
            names = ", ".join(path.name for path in left)
            text += "\n" + self.tr("Not imported yet: {names}").format(names=names)
        self.said.emit(text, Level.DONE)
        self.by_columns.offer(left)

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
        written: list[str] = []
        for name in names:
            try:
                content = self._library.load(name)
            except TrajectoryFileError as error:
                self.said.emit(words.file_error(error), Level.FAULT)
                return
            except LibraryError as error:
                self.said.emit(words.refusal(error.refusal), Level.FAULT)
                return
            path = path_of(name)
            problem = library_files.write_one(content, path)
            if problem is not None:
                text = self.tr("Not exported. {file}: {text}")
                self.said.emit(text.format(file=problem[0], text=problem[1]), Level.FAULT)
                return
            written.append(path.name)
        self.said.emit(self.tr("Exported: {names}").format(names=", ".join(written)), Level.DONE)
