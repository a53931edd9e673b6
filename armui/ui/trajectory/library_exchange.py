"""Trajectories into the library from files, and out of it: what the buttons of 轨迹库 do."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from armui.control.situation import Level
from armui.trajectory import files
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library import Library, LibraryError
from armui.ui import words
from armui.ui.trajectory import library_files

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController


class LibraryExchange(QObject):
    """Imports what is whole, writes over nothing unseen, and says what came of it.

    Args:
        controller: Whom the emergency stop in the file choosers tells.
        library: Takes and gives the trajectories.
        window: The choosers belong to it.

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

    def choose_imports(self) -> None:
        """Let the operator choose files to import."""
        library_files.choose_imports(self._window, self._controller, self.import_files)

    def import_files(self, paths: Sequence[Path]) -> None:
        """Take over what is whole of some files; each of the others is told."""
        contents, errors = files.import_files(paths)
        taken: list[str] = []
        problems = [words.file_error(error) for error in errors]
        for content in contents:
            name = self._library.free_name(content.name)
            try:
                self._library.save(replace(content, name=name))
            except LibraryError as error:
                problems.append(f"{content.name}: {words.refusal(error.refusal)}")
            else:
                taken.append(name)
        self.imported.emit(taken)
        texts = []
        if taken:
            texts.append(self.tr("Imported: {names}").format(names=", ".join(taken)))
        texts += [self.tr("Not imported. {reason}").format(reason=text) for text in problems]
        self.said.emit("\n".join(texts), Level.WARNING if problems else Level.DONE)

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
