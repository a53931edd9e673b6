"""Keeps the arrangement of the window in a small file beside the settings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Qt, QTimer
from PySide6.QtWidgets import QHeaderView
from shiboken6 import isValid

from armui.ui.background import Job
from armui.ui.shell.workspace_layout import ColumnLayout, WorkspaceLayout, from_text, to_text
from armui.ui.watch.layout_file import read_text, write_text

if TYPE_CHECKING:
    from armui.ui.background import Background

_AFTER_MS: Final = 1000
"""The delay of writing, so that nothing is written while a border is being dragged."""


class LayoutKeeper(QObject):
    """Reads the arrangement once, and writes it a moment after a change.

    If the file cannot be written, no message is shown: the next start only has an older
    arrangement, or the default one.

    Args:
        settings: The file of the operator's settings.
        background: Writes the file.
        parent: The main window.

    Attributes:
        layout: The arrangement as read, with the changes since.
    """

    def __init__(self, settings: Path, background: Background, parent: QObject) -> None:
        super().__init__(parent)
        self._file = settings.with_name("workspace.json")
        self._background = background
        # read at once, not in the background: a window must not change its size once it is seen
        self.layout: WorkspaceLayout = from_text(read_text(self._file))
        self._written = self.layout
        self._collect: Callable[[WorkspaceLayout], WorkspaceLayout] = lambda layout: layout
        self._timer = QTimer(self, singleShot=True, interval=_AFTER_MS)
        self._timer.timeout.connect(self.keep)

    def collect_by(self, collect: Callable[[WorkspaceLayout], WorkspaceLayout]) -> None:
        """Set a function that adds frequently changing values before writing."""
        self._collect = collect

    def note(self, *_: object) -> None:
        """Write the arrangement soon, because something was moved."""
        self._timer.start()

    def keep(self) -> None:
        """Write the arrangement now, if it has changed."""
        self._timer.stop()
        self.layout = self._collect(self.layout)
        if self.layout == self._written:
            return
        self._written = self.layout
        job: Job[None] = Job(lambda _result: None)
        self._background.begin_here(job, write_text, self._file, to_text(self.layout))

    def follow(self, name: str, header: QHeaderView) -> None:
        """Restore the columns of a table, and store their changes.

        Args:
            name: The name of the table.
            header: The titles of its columns.
        """
        kept = self.layout.columns.get(name)
        if kept is not None and len(kept.widths_px) == header.count():
            for place, width_px in enumerate(kept.widths_px):
                if header.sectionResizeMode(place) == QHeaderView.ResizeMode.Interactive:
                    header.resizeSection(place, width_px)
            if kept.sorted_by >= 0 and header.isSortIndicatorShown():
                order = Qt.SortOrder.AscendingOrder
                if not kept.ascending:
                    order = Qt.SortOrder.DescendingOrder
                header.setSortIndicator(kept.sorted_by, order)
        changed = partial(self._note_columns, name, header)
        header.sectionResized.connect(lambda *_: changed())
        header.sortIndicatorChanged.connect(lambda *_: changed())

    def _note_columns(self, name: str, header: QHeaderView) -> None:
        if not isValid(header):
            return  # the header emits signals even while it is deleted
        kept = self.layout.columns.get(name)
        known = () if kept is None else kept.widths_px
        shown = header.isSortIndicatorShown()
        columns = ColumnLayout(
            tuple(_width_px(header, place, known) for place in range(header.count())),
            header.sortIndicatorSection() if shown else -1,
            header.sortIndicatorOrder() == Qt.SortOrder.AscendingOrder,
        )
        if kept != columns:
            self.layout = replace(self.layout, columns={**self.layout.columns, name: columns})
            self.note()


def _width_px(header: QHeaderView, place: int, known: Sequence[int]) -> int:
    """Return the width of a column; a column that is hidden keeps the one it had."""
    if not header.isSectionHidden(place):
        return header.sectionSize(place)
    return known[place] if place < len(known) else header.defaultSectionSize()
