"""Brings together the library's pages, the 3D view and the bar of the preview."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QModelIndex, QObject

from armui.control.parameters.arm_model import arm_model
from armui.trajectory.planning.findings import Severity
from armui.trajectory.points.cells import VALUES
from armui.trajectory.points.program import Trajectory
from armui.ui.trajectory.preview.finding_marks import finding_marks
from armui.ui.trajectory.preview.point_marks import marks_of
from armui.ui.trajectory.preview.point_target import PointTarget

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.trajectory.editor.editor_page import EditorPage
    from armui.ui.trajectory.library.library_page import LibraryPage
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.ui.trajectory.running.preflight import Preflight
    from armui.viewport.path_picture import FindingMark, PathPicture

_FIRST_VALUE: Final = min(VALUES)


class PreviewLink(QObject):
    """What is edited is in the picture; a mark leads to its row, and a row to its mark.

    Before a check these are the points, and the ghost stands at the chosen one; after it the
    whole way.

    Args:
        library: Where trajectories are checked and opened.
        preview: Shows one path.
        controller: Knows the arm.
    """

    def __init__(
        self, library: LibraryPage, preview: PathPreview, controller: ArmController
    ) -> None:
        super().__init__(library)
        self._preview = preview
        self._controller = controller
        self._editor: EditorPage | None = None
        self._edited: EditorPage | None = None
        self._target: PointTarget | None = None
        self._marks: tuple[object, PathPicture | None] = (None, None)
        library.preview_wanted.connect(partial(self._show, None))
        library.editor_opened.connect(self._follow)
        preview.closed.connect(self._on_closed)

    @property
    def target(self) -> PointTarget | None:
        """The point that the operator is at, while its editor is seen."""
        target = self._target
        return target if target is not None and target.is_seen else None

    def on_mark_picked(self, row: int) -> None:
        """A point was clicked in 3D: show its row."""
        editor = self._editor or self._edited
        if editor is not None:
            editor.select_row(row)

    def on_finding_picked(self, finding: FindingMark) -> None:
        """A sign of a finding was clicked in 3D: show its row."""
        if self._editor is not None and finding.row is not None:
            self._editor.select_row(finding.row)

    def _follow(self, editor: EditorPage) -> None:
        editor.preview_wanted.connect(partial(self._show, editor))
        editor.selected_row_changed.connect(partial(self._on_row, editor))
        editor.closed.connect(partial(self._on_left, editor))
        editor.table.selectionModel().currentChanged.connect(partial(self._on_cell, editor))
        self._edit(editor)

    def _edit(self, editor: EditorPage) -> None:
        if editor is not self._edited:
            self._edited = editor
            self._target = PointTarget(editor, self._controller)
        self._show_points()

    def _show(self, editor: EditorPage | None, checked: Preflight | None) -> None:
        if checked is None:
            if editor is self._editor:
                self._preview.show(None)
                self._editor = None
            if editor is not None:
                self._edit(editor)
            return
        self._editor = editor
        errors = (each for each in checked.findings if each.severity is Severity.ERROR)
        bad_rows = frozenset(
            each.row for each in errors if each.row is not None and each.approach is None
        )
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
        else:
            self._edit(editor)

    def _on_cell(self, editor: EditorPage, cell: QModelIndex, _before: QModelIndex) -> None:
        """The range of a joint is shown while its cell is edited."""
        points, row = editor.document.points, cell.row()
        if cell.column() in VALUES and 0 <= row < len(points) and points[row].is_joint:
            number = cell.column() - _FIRST_VALUE + 1
            limits = self._controller.operating_state.limits[number - 1]
            self._preview.show_joint_range(number, (limits.min_deg, limits.max_deg))
        else:
            self._preview.show_joint_range(None)

    def _show_points(self) -> None:
        """The points as they are edited, with the ghost at the chosen one."""
        editor, target = self._edited, self._target
        if editor is None or target is None or self._editor is not None:
            return
        points = editor.document.points
        if self._marks[0] is not points:
            self._marks = (points, marks_of(points, arm_model(self._controller)))
        row = editor.table.current_row()
        self._preview.show_points(self._marks[1], row if row >= 0 else None, target.angles_deg())

    def _on_left(self, editor: EditorPage) -> None:
        """What was previewed or edited is no longer open."""
        if editor is self._edited:
            self._edited = self._target = None
            self._preview.show_joint_range(None)
            if self._editor is None:
                self._preview.show(None)
        if editor is self._editor:
            self._preview.show(None)
            self._editor = None

    def _on_closed(self) -> None:
        self._editor = None
        self._show_points()
