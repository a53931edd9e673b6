"""Brings together the library's pages, the 3D view and the bar of the preview."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

import numpy as np
from PySide6.QtCore import QCoreApplication, QModelIndex, QObject

from armui.arm.refusal import Refusal
from armui.control.parameters.arm_model import arm_model
from armui.kinematics.forward import flange_transforms
from armui.kinematics.poses import pose_to_matrix
from armui.trajectory.planning.convert import comes_from, to_joints
from armui.trajectory.planning.findings import Severity
from armui.trajectory.points import edits
from armui.trajectory.points.cells import VALUES
from armui.trajectory.points.program import VALUE_COUNT, Trajectory, check_point
from armui.ui.words.findings import finding as finding_text
from armui.viewport.path_picture import FindingMark, PathPicture

if TYPE_CHECKING:
    from collections.abc import Mapping

    from armui.arm.models import ArmModel
    from armui.control.arm_controller import ArmController
    from armui.trajectory.planning.findings import Finding
    from armui.trajectory.points.program import Waypoint
    from armui.ui.trajectory.editor.editor_page import EditorPage
    from armui.ui.trajectory.library.library_page import LibraryPage
    from armui.ui.trajectory.preview.path_preview import PathPreview
    from armui.ui.trajectory.running.run_request import Preflight


_MOST = 200
"""More signs than anybody looks at would hide the path."""


def finding_marks(checked: Preflight) -> tuple[FindingMark, ...]:
    """The findings that happen at a place, errors first."""
    path = checked.path
    ends = path.ends()
    marks = []
    for found in checked.findings[:_MOST]:
        place_mm = _place_mm(checked, found, ends)
        if place_mm is not None:
            error = found.severity is Severity.ERROR
            marks.append(FindingMark(place_mm, error, found.row, finding_text(found)))
    return tuple(marks)


def _place_mm(
    checked: Preflight, found: Finding, ends: Mapping[int, int]
) -> tuple[float, float, float] | None:
    """Where it happens: as the check says, else where the arm would stand, else at its point."""
    if found.place_mm is not None:
        x, y, z = found.place_mm
        return x, y, z
    if found.joints_deg is not None:
        arm = checked.order.arm
        flange = arm.kinematics.matrix(found.joints_deg)
        x, y, z = (flange[:3, 3] + arm.tool_mm * flange[:3, 2]).tolist()
        return x, y, z
    if found.row is not None and found.row in ends:
        x, y, z = checked.path.places_mm[ends[found.row]].tolist()
        return x, y, z
    return None


MOST_POINTS: Final = 3000
"""A few milliseconds in the window's thread; of longer ones a check shows the points."""


def marks_of(points: Sequence[Waypoint], arm: ArmModel) -> PathPicture | None:
    """Where the tip of the tool is at each point; None for more than `MOST_POINTS`, and none."""
    if not 0 < len(points) <= MOST_POINTS:
        return None
    targets = np.array([point.target for point in points], dtype=np.float64)
    joint = np.array([point.is_joint for point in points])
    flanges = np.empty((len(points), 4, 4))
    flanges[joint] = flange_transforms(arm.kinematics.geometry, targets[joint])
    flanges[~joint] = pose_to_matrix(targets[~joint])
    tips = flanges[:, :3, 3] + arm.tool_mm * flanges[:, :3, 2]
    nothing = np.empty((0, 3))
    return PathPicture(nothing, np.empty(0), tips, tuple(range(len(points))))


_ZERO: Final = (0.0,) * VALUE_COUNT
_DECIMALS: Final = 3
"""Of what is sent, and of what stands in the table."""


class PointTarget:
    """Stands for the current row of an editor.

    Args:
        editor: Whose row.
        controller: Knows the arm and its kinematics.
    """

    def __init__(self, editor: EditorPage, controller: ArmController) -> None:
        self._editor = editor
        self._controller = controller
        self._solved: tuple[object, int, tuple[float, ...] | None] | None = None
        self._begun = self._at()

    @property
    def is_seen(self) -> bool:
        """Whether the operator is at it."""
        return self._editor.isVisible()

    def angles_deg(self) -> tuple[float, ...] | None:
        """The angles of the current row's point; None: there is none, or it can't be reached."""
        points, row = self._editor.document.points, self._editor.table.current_row()
        if not 0 <= row < len(points):
            return None
        solved = self._solved
        if solved is None or solved[0] is not points or solved[1] != row:
            solved = self._solved = (points, row, self._solve(points, row))
        return solved[2]

    def begin(self) -> None:
        """Note which point is taken hold of; it stays as it is until the drag ends."""
        self._begun = self._at()

    def is_as_begun(self) -> bool:
        """Tell whether the same row of the same points is still the current one."""
        points, row = self._at()
        return points is self._begun[0] and row == self._begun[1]

    def _at(self) -> tuple[Sequence[Waypoint], int]:
        return self._editor.document.points, self._editor.table.current_row()

    def carry(self, _angles_deg: tuple[float, ...]) -> None:
        """The ghost shows it; the point is changed when it is let go, in one step of undo."""

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """Give the point this place; its motion, speed and actions stay."""
        points, row = self._editor.document.points, self._editor.table.current_row()
        point = points[row]
        if point.is_joint:
            values: Sequence[float] = angles_deg
        else:
            values = self._controller.cartesian.kinematics().forward(angles_deg)
        changed = replace(point, target=tuple(round(value, _DECIMALS) for value in values))
        refusal = check_point(changed)
        if refusal is None:
            label = QCoreApplication.translate("PointTarget", "Drag in the picture")
            self._editor.document.edit(edits.change(points, {row: changed}), label)
            # what leads there is known: it was dragged there
            self._solved = (self._editor.document.points, row, angles_deg)
        return refusal

    def give_up(self, _angles_deg: tuple[float, ...]) -> None:
        """The point was not changed."""

    def _solve(self, points: Sequence[Waypoint], row: int) -> tuple[float, ...] | None:
        model = self._controller.cartesian.kinematics()
        measured_deg = self._controller.state.angles_deg() or _ZERO
        near_deg, _ = comes_from(points, row, model, measured_deg)
        limits = self._controller.operating_state.limits
        point = to_joints(points[row], model, near_deg, limits)
        return None if isinstance(point, Refusal) else point.target


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
