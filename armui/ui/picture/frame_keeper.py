"""Keeps the user frames in the picture: the one in force with its axes, the others faint."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from armui.viewport.robot_shape import pose_rows
from armui.viewport.strokes import FrameMark

if TYPE_CHECKING:
    from PySide6.QtGui import QAction

    from armui.control.arm_controller import ArmController
    from armui.viewport.view import ArmView


class FrameKeeper(QObject):
    """Shows the user frames of the cell, as long as a switch is on.

    Args:
        controller: Knows the cell, and a frame that is not taken yet.
        view: The picture.
        switch: Hides and shows them; one that is not taken yet is always shown.
        parent: The parent object.
    """

    def __init__(
        self, controller: ArmController, view: ArmView, switch: QAction, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._view = view
        self._switch = switch
        switch.toggled.connect(self._show)
        controller.cell_changed.connect(self._show)
        self._show()

    def _show(self, _changed: object = None) -> None:
        cells = self._controller.cell
        cell, chosen, candidate = cells.cell, self._controller.cartesian.frame, cells.candidate
        frames = cell.all_frames if cell is not None and self._switch.isChecked() else ()
        marks = [FrameMark(each.name, pose_rows(each.pose), each == chosen) for each in frames]
        if candidate is not None:
            marks.append(FrameMark(candidate.name, pose_rows(candidate.pose), lit=True))
        self._view.set_frames(tuple(marks))
