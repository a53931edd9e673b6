"""Keeps cells in the library's folder, and in the settings which arm each belongs to."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Refusal
from armui.cell.cell_file import (
    CELL_NOT_WRITTEN,
    SUFFIX,
    delete_cell,
    read_cell,
    read_cells,
    rename_cell,
    save_cell,
    write_cell,
)
from armui.system.files import error_text

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping
    from concurrent.futures import Executor, Future
    from pathlib import Path

    from armui.cell.cell import Cell
    from armui.control.cell.cell_control import CellControl
    from armui.settings import SettingsStore

MOST: Final = 200
"""The most arms remembered; those chosen longest ago are dropped."""


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
        control: Gets the cells that are there, and is told what could not be written.
        settings: Keep which arm a cell belongs to.
        folder: The folder of the files.
        files: Runs work that waits for a disk.
    """

    def __init__(
        self, control: CellControl, settings: SettingsStore, folder: Path, files: Executor
    ) -> None:
        self._control = control
        self._settings = settings
        self._folder = folder
        self._files = files
        self._written: dict[str, Cell] = {}
        self._relay = _Relay()
        control.store = self
        self._do(self._on_read, read_cells, folder)

    def save(self, cell: Cell) -> None:
        """Write a cell to its file, unless another program has changed that meanwhile."""
        expected, self._written[cell.name] = self._written.get(cell.name), cell
        self._do(self._on_written, save_cell, self._path(cell.name), cell, expected)

    def rename(self, name: str, cell: Cell) -> None:
        """Give the file of a cell another name, never over another one; all its arms follow."""
        expected, self._written[cell.name] = self._written.pop(name, None), cell
        paths = self._path(name), self._path(cell.name)
        then = partial(self._on_renamed, name, cell, expected)
        self._do(then, rename_cell, *paths, cell, expected)

    def delete(self, name: str) -> None:
        """Delete the file of a cell."""
        self._written.pop(name, None)
        self._do(self._on_written, delete_cell, self._path(name))

    def keep(self, arm_key: str, name: str) -> None:
        """Keep in the settings which cell an arm belongs to."""
        kept = {key: each for key, each in self._settings.settings.cells.items() if key != arm_key}
        if name:
            kept[arm_key] = name
        self._keep(kept)

    def _keep(self, kept: Mapping[str, str]) -> None:
        refusal = self._settings.change(cells=dict(list(kept.items())[-MOST:]))
        if refusal is not None:
            self._control.tell_problem(refusal)

    def kept(self, arm_key: str) -> str:
        """Return the name of the cell an arm belongs to."""
        return self._settings.settings.cells.get(arm_key, "")

    def write(self, path: Path, cell: Cell, then: Callable[[Refusal | None], object]) -> None:
        """Export a cell to any file; `then` gets ``None``, or why it could not be written."""
        self._do(then, write_cell, path, cell)

    def read(self, path: Path, then: Callable[[Cell | Refusal], object]) -> None:
        """Read a cell from any file; `then` gets it, or why the file is refused."""
        self._do(then, read_cell, path)

    def _path(self, name: str) -> Path:
        return self._folder / f"{name}{SUFFIX}"

    def _on_read(self, cells: Mapping[str, Cell | Refusal] | Refusal) -> None:
        if isinstance(cells, Refusal):
            self._control.tell_problem(cells)
            return
        for name, cell in cells.items():
            if not isinstance(cell, Refusal):
                self._written.setdefault(name, cell)
        self._control.take_loaded(cells)

    def _on_renamed(
        self, name: str, cell: Cell, expected: Cell | None, problem: Refusal | None
    ) -> None:
        if problem is None:
            kept = self._settings.settings.cells
            self._keep({key: cell.name if each == name else each for key, each in kept.items()})
            return
        del self._written[cell.name]
        if expected is not None:
            self._written[name] = expected
        self._control.give_name(cell.name, name)
        self._control.tell_problem(problem)

    def _on_written(self, problem: Refusal | None) -> None:
        if problem is not None:
            self._control.tell_problem(problem)

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
            return CELL_NOT_WRITTEN(path=str(self._folder), text=text)
        return done.result()
