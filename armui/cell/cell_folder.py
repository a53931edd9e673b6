"""The folder of cells: each a file of its name, which another program may change meanwhile."""

from __future__ import annotations

import contextlib
import errno
import os
import threading
from collections.abc import Callable, Mapping
from pathlib import Path

from filelock import Timeout

from armui.arm.refusal import Reason, Refusal
from armui.cell.cell import Cell
from armui.cell.cell_file import (
    CELL_NOT_WRITTEN,
    SUFFIX,
    delete_cell,
    from_text,
    read_cell,
    to_text,
    write_cell,
)
from armui.system.alone import alone_with
from armui.system.atomic import aside_name, replace_file
from armui.system.files import error_text

CELL_CHANGED_ELSEWHERE = Reason(
    "cell_changed_elsewhere",
    "Another program has changed the file {path} meanwhile; it was not overwritten. Export your "
    "cell under another name, then start the program again.",
)


class CellFolder:
    """Reads and writes the cells of a folder, and knows what was really read and written.

    Every function waits for the disk, and may be called from any thread. A file that differs from
    what is known to be in it was changed by another program, and is left alone. One that could not
    be read is put aside where another takes its place or it is deleted: a newer program may read
    it.

    Args:
        path: The folder; it need not exist.

    Attributes:
        path: The folder.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._turn = threading.Lock()
        self._known: dict[str, Cell | Refusal] = {}

    def read(self) -> Mapping[str, Cell | Refusal]:
        """Return all cells by name, with the reasons against those that are broken."""
        with self._turn:
            try:
                paths = sorted(self.path.glob(f"[!.]*{SUFFIX}"))
            except OSError:
                return {}
            found = {path.stem: read_cell(path) for path in paths}
            self._known |= found
            return found

    def save(self, cell: Cell) -> Refusal | None:
        """Write a cell to its file; return ``None``, or why it was not written."""
        return self._alone(lambda: self._why_changed(cell.name) or self._write(cell), cell.name)

    def delete(self, name: str) -> Refusal | None:
        """Delete the file of a cell; return ``None``, or why it was not deleted."""
        return self._alone(lambda: self._why_changed(name) or self._delete(name), name)

    def rename(self, name: str, cell: Cell) -> Refusal | None:
        """Move a cell to the file of its name, which must be free, from that of another name.

        Returns:
            ``None``, or why the first file is still the one that counts.
        """

        def move() -> Refusal | None:
            new = self._file(cell.name)
            if new.exists():
                return CELL_CHANGED_ELSEWHERE(path=str(new))
            problem = self._why_changed(name) or self._write(cell)
            if problem is not None:
                return problem
            problem = self._delete(name)
            if problem is not None:
                self._delete(cell.name)
            return problem

        return self._alone(move, name, cell.name)

    def _alone(self, work: Callable[[], Refusal | None], *names: str) -> Refusal | None:
        if not self._turn.acquire(blocking=False):
            # Another thread has the turn and waits for a disk that does not answer: waiting for it
            # would hang, too.
            return self._why_not(errno.ETIMEDOUT)
        try:
            with contextlib.ExitStack() as locked:
                for name in sorted(names):
                    locked.enter_context(alone_with(self._file(name)))
                return work()
        except Timeout:
            return self._why_not(errno.EBUSY)
        finally:
            self._turn.release()

    def _why_not(self, number: int) -> Refusal:
        return CELL_NOT_WRITTEN(path=str(self.path), text=os.strerror(number))

    def _file(self, name: str) -> Path:
        return self.path / f"{name}{SUFFIX}"

    def _why_changed(self, name: str) -> Refusal | None:
        path = self._file(name)
        if path.exists() and read_cell(path) != self._known.get(name):
            return CELL_CHANGED_ELSEWHERE(path=str(path))
        return None

    def _write(self, cell: Cell) -> Refusal | None:
        path = self._file(cell.name)
        problem = self._put_aside(cell.name) or write_cell(path, cell)
        if problem is None:
            self._known[cell.name] = from_text(to_text(cell), cell.name)
        return problem

    def _delete(self, name: str) -> Refusal | None:
        problem = self._put_aside(name) or delete_cell(self._file(name))
        if problem is None:
            self._known.pop(name, None)
        return problem

    def _put_aside(self, name: str) -> Refusal | None:
        path = self._file(name)
        if not isinstance(self._known.get(name), Refusal) or not path.exists():
            return None
        try:
            replace_file(path, aside_name(path))
        except OSError as error:
            return CELL_NOT_WRITTEN(path=str(path), text=error_text(error))
        del self._known[name]
        return None
