"""A table read by a mapping and put into the library, behind the window's back."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, QThread

from armui.trajectory import columns
from armui.trajectory.columns import ColumnMapping, TableFile
from armui.trajectory.files import TrajectoryFileError
from armui.trajectory.library.store import Library, LibraryError


class TableImport(QThread):
    """Reads one table: 180,000 rows take seconds, in which the window must answer.

    The library is opened anew here, as another program would: it is for one thread.

    Args:
        table: The file.
        mapping: Which column is what.
        name: What the result is called.
        folder: Of the library.
        parent: Whoever waits for it.

    Attributes:
        name: As given.
        error: What spoke against it, once it has finished; nothing of the library has changed
            then.
        done: Whether it is in the library; neither this nor an error where it was interrupted.
    """

    def __init__(
        self, table: TableFile, mapping: ColumnMapping, name: str, folder: Path, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._table = table
        self._mapping = mapping
        self.name = name
        self._folder = folder
        self.error: TrajectoryFileError | LibraryError | None = None
        self.done = False
        if (app := QCoreApplication.instance()) is not None:
            app.aboutToQuit.connect(self._end)

    def run(self) -> None:
        """Do it; what came of it stands in the attributes when this has finished."""
        table, name = self._table, self.name
        try:
            content = columns.apply(table.text, table.sheet, self._mapping, name)
            if self.isInterruptionRequested():
                return
            Library(self._folder).save(content)
            self.done = True
        except (TrajectoryFileError, LibraryError) as error:
            self.error = error

    def _end(self) -> None:
        """The program ends: what is being saved is saved, what is not is not."""
        self.requestInterruption()
        self.wait()
