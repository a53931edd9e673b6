"""The chosen point of an editor, as something that can be dragged in the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QCoreApplication

from armui.arm.refusal import Refusal
from armui.trajectory.planning.convert import comes_from, to_joints
from armui.trajectory.points import edits
from armui.trajectory.points.program import VALUE_COUNT, check_point

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.trajectory.points.program import Waypoint
    from armui.ui.trajectory.editor.editor_page import EditorPage

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
