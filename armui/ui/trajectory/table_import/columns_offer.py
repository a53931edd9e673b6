"""The button «Import by columns…»: there when a file is none of ours but holds a table."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from armui.trajectory import columns
from armui.ui.trajectory.library.library_work import LibraryWork
from armui.ui.trajectory.table_import.columns_page import ColumnsPage
from armui.ui.widgets.translated import Translated


class ColumnsOffer(Translated, QPushButton):
    """Opens the page for one file after the other.

    Args:
        work: Reads the files; its library takes what is imported.
        owner: The page that holds it.

    Signals:
        page_made: A :class:`ColumnsPage`, before it wants to be shown.
        imported: The name of what was taken over.
        refused: Why a file cannot be opened any more, as a text.
    """

    page_made = Signal(object)
    imported = Signal(str)
    refused = Signal(str)

    def __init__(self, work: LibraryWork, owner: QWidget) -> None:
        super().__init__(owner)
        self._work = work
        self._opening = False
        self._paths: list[Path] = []
        self._page: ColumnsPage | None = None
        self.setObjectName("library_by_columns")
        self.setAutoDefault(False)
        self.hide()
        self.clicked.connect(self._open)
        self.retranslate_ui()

    @property
    def paths(self) -> Sequence[Path]:
        """The files that are offered, the next one first."""
        return tuple(self._paths)

    def show_for(self, paths: Sequence[Path]) -> None:
        """Offer some files and no others."""
        self._paths = list(paths)
        self.setVisible(bool(paths))
        self.retranslate_ui()

    def _open(self) -> None:
        if self._page is not None:
            self._page.open()
            return
        if self._opening:
            return
        path = self._paths[0]
        self._opening = True
        self._work.do(lambda: columns.open_table(path), partial(self._show, path), self._on_refused)

    def _on_refused(self, text: str) -> None:
        self._opening = False
        left = self._paths[1:]
        self.refused.emit(text)
        self.show_for(left)

    def _show(self, path: Path, table: columns.TableFile) -> None:
        self._opening = False
        page = self._page = ColumnsPage(self._work.library, table)
        page.imported.connect(partial(self._on_imported, path))
        page.closed.connect(self._on_closed)
        self.page_made.emit(page)
        page.open()

    def _on_imported(self, path: Path, name: str) -> None:
        self._paths = [other for other in self._paths if other != path]
        self.imported.emit(name)

    def _on_closed(self) -> None:
        if self._page is not None:
            self._page.deleteLater()
            self._page = None

    def retranslate_ui(self) -> None:
        """Put every word into the operator's language."""
        self.setText(self.tr("Import by columns…"))
        self.setToolTip("\n".join(path.name for path in self._paths))
