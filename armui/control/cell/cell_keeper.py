"""Keeps cells in the library's folder, and in the settings which arm each belongs to."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Refusal
from armui.cell.cell_file import CELL_NOT_WRITTEN, read_cell, write_cell
from armui.cell.cell_folder import CellFolder
from armui.system.files import error_text

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from concurrent.futures import Executor, Future
    from pathlib import Path

    from armui.cell.cell import Cell
    from armui.settings import SettingsStore


class _Relay(QObject):
    """Carries what a file thread has done to the window's thread."""

    done = Signal(object, object)

    def __init__(self) -> None:
        super().__init__()
        self.done.connect(self._on_done)

    @staticmethod
    def _on_done(then: Callable[[object], object], result: object) -> None:
        then(result)


class CellKeeper:
    """Reads and writes cells by the file thread; nobody waits for a disk.

    Args:
        loaded: Called with the cells that are there, by name.
        not_renamed: Called with the names of a cell now and before, if its file kept its name.
        problem: Called with what could not be read or written.
        settings: Keep which arm a cell belongs to.
        folder: The folder of the files.
        files: Runs work that waits for a disk.
    """

    def __init__(
        self,
        settings: SettingsStore,
        folder: Path,
        files: Executor,
        *,
        loaded: Callable[[Mapping[str, Cell | Refusal]], object],
        not_renamed: Callable[[str, str], object],
        problem: Callable[[Refusal], object],
    ) -> None:
        self._loaded, self._not_renamed, self._problem = loaded, not_renamed, problem
        self._settings = settings
        self._folder = CellFolder(folder)
        self._files = files
        self._relay = _Relay()

    def load(self) -> None:
        """Begin to read the cells of the folder."""
        self._do(self._on_read, self._folder.read)

    def save(self, cell: Cell) -> None:
        """Write a cell to its file, unless another program has changed that meanwhile."""
        self._do(self._on_written, self._folder.save, cell)

    def rename(self, name: str, cell: Cell) -> None:
        """Give the file of a cell another name, never over another one; all its arms follow."""
        self._do(partial(self._on_renamed, name, cell), self._folder.rename, name, cell)

    def delete(self, name: str) -> None:
        """Delete the file of a cell, unless another program has changed that meanwhile."""
        self._do(self._on_written, self._folder.delete, name)

    def keep(self, arm_key: str, name: str) -> None:
        """Keep in the settings which cell an arm belongs to."""
        self._on_written(self._settings.keep("cells", {arm_key: name or None}))

    def kept(self, arm_key: str) -> str:
        """Return the name of the cell an arm belongs to, "" for none.

        An invalid name is returned unchanged, so that an unreadable cell does not count as none.
        """
        name = self._settings.settings.cells.get(arm_key)
        return name or self._settings.strange("cells", arm_key) or ""

    def write(self, path: Path, cell: Cell, then: Callable[[Refusal | None], object]) -> None:
        """Export a cell to any file; `then` gets ``None``, or why it could not be written."""
        self._do(then, write_cell, path, cell)

    def read(self, path: Path, then: Callable[[Cell | Refusal], object]) -> None:
        """Read a cell from any file; `then` gets it, or why the file is refused."""
        self._do(then, read_cell, path)

    def _on_read(self, cells: Mapping[str, Cell | Refusal] | Refusal) -> None:
        if isinstance(cells, Refusal):
            self._problem(cells)
            return
        self._loaded(cells)

    def _on_renamed(self, name: str, cell: Cell, problem: Refusal | None) -> None:
        if problem is not None:
            self._not_renamed(cell.name, name)
            self._problem(problem)
            return

        def follow(entries: dict[str, Any]) -> None:
            entries.update({key: cell.name for key, each in entries.items() if each == name})

        self._on_written(self._settings.revise("cells", follow))

    def _on_written(self, problem: Refusal | None) -> None:
        if problem is not None:
            self._problem(problem)

    def _do(self, then: Callable[..., object], work: Callable[..., object], *given: object) -> None:
        try:
            future = self._files.submit(work, *given)
        except RuntimeError:  # the thread has ended, and the program ends
            return
        future.add_done_callback(lambda done: self._relay.done.emit(then, self._result_of(done)))

    def _result_of(self, done: Future[object]) -> object:
        error = None if done.cancelled() else done.exception()
        if done.cancelled() or error is not None:
            text = "" if error is None else error_text(error)
            return CELL_NOT_WRITTEN(path=str(self._folder.path), text=text)
        return done.result()
