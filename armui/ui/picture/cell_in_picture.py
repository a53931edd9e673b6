"""Shows the cell in the picture: work area, user frames, what the hand holds, the base."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject

from armui.cell.user_frames import NO_FRAME
from armui.cell.work_area import AreaBox
from armui.viewport.area_picture import AreaPicture, AreaShape
from armui.viewport.robot_shape import pose_rows
from armui.viewport.strokes import FrameMark

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Mapping

    from PySide6.QtGui import QAction

    from armui.arm.state import ArmState
    from armui.cell.held_objects import HeldObject
    from armui.cell.work_area import Area
    from armui.control.arm_controller import ArmController
    from armui.ui.picture.target_drag import ZoneTarget
    from armui.viewport.view import ArmView

_NEAR_MM: Final = 50.0
"""A plane or a box is highlighted when the arm is this near to its margin."""


class CellInPicture(QObject):
    """Shows the chosen cell; highlights what is near the arm, and the frame in force.

    Args:
        controller: Knows the cell, and how near the arm is.
        view: The picture.
        switches: Hide and show its parts: ``area`` and ``frames``. A frame that is not taken yet is
            always shown.
        parent: The parent object.
        zone: Returns where a plane or box is typed, which is shown before it is applied.
    """

    def __init__(
        self,
        controller: ArmController,
        view: ArmView,
        switches: Mapping[str, QAction],
        parent: QObject,
        zone: Callable[[], ZoneTarget | None],
    ) -> None:
        super().__init__(parent)
        self._controller = controller
        self._view = view
        self._switches = switches
        self._zone = zone
        self._makes_one = False
        for name in ("area", "frames"):
            switches[name].toggled.connect(self._show)
        controller.cell_changed.connect(self._show)
        controller.state_changed.connect(self._on_state)
        self._show()

    def _on_state(self, _state: ArmState) -> None:
        if self._controller.area_guard.area is not None or self._zone() is not None:
            self._show_area()

    def _show(self, _changed: object = None) -> None:
        self._show_area()
        cells = self._controller.cell
        cell, chosen, candidate = cells.cell, self._controller.cartesian.frame, cells.candidate
        shown = cell is not None and self._switches["frames"].isChecked()
        frames = cell.all_frames if cell is not None and shown else ()
        marks = [FrameMark(each.name, pose_rows(each.pose), each == chosen) for each in frames]
        if candidate is not None:
            marks.append(FrameMark(candidate.name, pose_rows(candidate.pose), lit=True))
        self._view.set_frames(tuple(marks))

    def _show_area(self) -> None:
        area, cell = self._controller.area_guard.area, self._controller.cell.cell
        base = NO_FRAME if cell is None else cell.placement.pose
        zone = self._zone()
        typed = None if zone is None else zone.typed_zone()
        held = held_picture(None if cell is None else cell.held_object)
        if typed is not None and (cell is None or typed not in cell.area.zones):
            size_mm = typed.size_mm if isinstance(typed, AreaBox) else None
            held = (AreaShape(pose_rows(typed.pose), size_mm, near=True), *held)
        names = () if cell is None else [each.name for each in cell.area.zones]
        made_before = self._makes_one
        self._makes_one = typed is not None and typed.name not in names
        if self._makes_one and not made_before:
            # only once: the camera must not move during typing or dragging
            self._view.bring_in(held[:1])
        pale = self._controller.cell.unconfirmed is not None
        if area is None or not self._switches["area"].isChecked():
            self._view.set_area(_as_confirmed(held, pale=pale), base)
            return
        seen = self._controller.area_guard.nearest_entries(self._controller.state)
        near = {each.zone.name for each in seen if each.gap_mm < area.margin_mm + _NEAR_MM}
        self._view.set_area(_as_confirmed((*area_picture(area, near), *held), pale=pale), base)


def _as_confirmed(shapes: AreaPicture, *, pale: bool) -> AreaPicture:
    """Return what the picture shows, pale while the cell waits for its confirmation."""
    return tuple(replace(each, pale=True) for each in shapes) if pale else shapes


def area_picture(area: Area, near: Collection[str] = ()) -> AreaPicture:
    """Return the planes and boxes that are switched on as the picture shows them.

    Args:
        area: The work area.
        near: The names of those to be highlighted.
    """
    on = area.in_force
    return (
        *(AreaShape(pose_rows(each.pose), None, each.name in near) for each in on.planes),
        *(AreaShape(pose_rows(each.pose), each.size_mm, each.name in near) for each in on.boxes),
    )


def held_picture(held: HeldObject | None) -> AreaPicture:
    """Return what the hand holds as the picture shows it."""
    if held is None:
        return ()
    return (AreaShape(pose_rows(held.pose), held.size_mm, held=True, is_rod=held.is_rod),)
