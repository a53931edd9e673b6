"""Keeps the work area in the picture: planes and boxes that are on, those near the arm lit."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject

from armui.viewport.area_picture import AreaPicture, AreaShape
from armui.viewport.robot_shape import pose_rows

if TYPE_CHECKING:
    from PySide6.QtGui import QAction

    from armui.arm.state import ArmState
    from armui.control.arm_controller import ArmController
    from armui.viewport.view import ArmView

_NEAR_MM: Final = 50.0
"""A plane or a box is lit when the arm is this near to its margin."""


class AreaKeeper(QObject):
    """Shows the work area of the chosen cell, as long as a switch is on.

    Args:
        controller: Knows the cell, and how near the arm is.
        view: The picture.
        switch: Hides and shows it.
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
        controller.state_changed.connect(self._on_state)
        self._show()

    def _on_state(self, _state: ArmState) -> None:
        if self._controller.area_guard.area is not None:
            self._show()

    def _show(self, _changed: object = None) -> None:
        area = self._controller.area_guard.area
        if area is None or not self._switch.isChecked():
            self._view.set_area(())
            return
        seen = self._controller.area_guard.look(self._controller.state)
        near = {each.zone.name for each in seen if each.gap_mm < area.margin_mm + _NEAR_MM}
        on = area.in_force
        shapes: AreaPicture = (
            *(AreaShape(pose_rows(each.pose), None, each.name in near) for each in on.planes),
            *(
                AreaShape(pose_rows(each.pose), each.size_mm, each.name in near)
                for each in on.boxes
            ),
        )
        self._view.set_area(shapes)
