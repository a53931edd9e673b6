"""Brings together the library's windows, the 3D view and the bar of the preview."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from armui.trajectory.planning.findings import Severity
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.preview.finding_marks import finding_marks

if TYPE_CHECKING:
    from armui.ui.trajectory.editor.editor_page import EditorPage
    from armui.ui.trajectory.library.library_page import LibraryPage
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.ui.trajectory.running.preflight import Preflight
    from armui.viewport.path_picture import FindingMark


class PreviewLink(QObject):
    """What was checked last is previewed; a mark leads to its row, and a row to its mark.

    Args:
        library: Where trajectories are checked and opened.
        preview: Shows one path.
    """

    def __init__(self, library: LibraryPage, preview: PathPreview) -> None:
        super().__init__(library)
        self._preview = preview
        self._editor: EditorPage | None = None
        library.preview_wanted.connect(partial(self._show, None))
        library.editor_opened.connect(self._follow)
        preview.closed.connect(self._forget)

    def on_mark_picked(self, row: int) -> None:
        """A point was clicked in 3D: show its row."""
        if self._editor is not None:
            self._editor.select_row(row)

    def on_finding_picked(self, finding: FindingMark) -> None:
        """A sign of a finding was clicked in 3D: show its row."""
        if self._editor is not None and finding.row is not None:
            self._editor.select_row(finding.row)

    def _follow(self, editor: EditorPage) -> None:
        editor.preview_wanted.connect(partial(self._show, editor))
        editor.selected_row_changed.connect(partial(self._on_row, editor))
        editor.closed.connect(partial(self._on_left, editor))

    def _show(self, editor: EditorPage | None, checked: Preflight | None) -> None:
        if checked is None:
            self._on_left(editor)
            return
        self._editor = editor
        errors = (each for each in checked.findings if each.severity is Severity.ERROR)
        bad_rows = frozenset(each.row for each in errors if each.row is not None)
        content = checked.content
        self._preview.show(
            checked.path,
            bad_rows,
            finding_marks(checked),
            content.name,
            numbered=isinstance(content, Trajectory),
        )

    def _on_row(self, editor: EditorPage, row: int) -> None:
        if editor is self._editor:
            self._preview.select_row(row if row >= 0 else None)

    def _on_left(self, editor: EditorPage | None) -> None:
        """What was previewed is no longer so, or no longer open."""
        if editor is self._editor:
            self._preview.show(None)
            self._forget()

    def _forget(self) -> None:
        self._editor = None
