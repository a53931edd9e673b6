"""A 3D view that draws nothing."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from armui.viewport.fitting import Box, Room
from armui.viewport.viewpoint import ViewMode


class FakeView(QWidget):
    """Stands for the 3D view; remembers what it was last given."""

    joint_picked = Signal(int)
    mark_picked = Signal(int)
    load_failed = Signal(object)
    finding_picked = Signal(object)
    view_changed = Signal()
    handle_taken = Signal()
    handle_moved = Signal(object, bool, bool)
    handle_left = Signal(bool)

    def __init__(self) -> None:
        super().__init__()
        self.joints: Any = None
        self.pose: tuple[Any, ...] | None = None
        self.palette_shown: Any = None
        self.robot: Any = None
        self.resets = 0
        self.shape: Any = None
        self.area: Any = ()
        self.base: Any = ()
        self.frames: Any = ()
        self.mode = ViewMode.FIT
        self.looked_from: list[Any] = []
        self.is_current = False
        self.has_given_up = False
        self.joint_range: tuple[Any, ...] | None = None

    def set_area(self, area: Any, base: Any = ()) -> None:
        self.area = area
        self.base = base

    def bring_in(self, area: Any) -> None: ...

    def set_joints(self, angles_deg: Any, gripper_mm: Any, stale: bool = False) -> None:
        self.joints = (angles_deg, gripper_mm, stale)

    def set_joints_unknown(self) -> None:
        self.joints = None

    def set_frames(self, marks: Any) -> None:
        self.frames = marks

    def set_pose(self, pose: Any, stale: bool = False, **_more: Any) -> None:
        self.pose = (pose, stale)

    def set_theme(self, palette: Any) -> None:
        self.palette_shown = palette

    def set_robot(self, path: Any) -> None:
        self.robot = path

    def set_preview(self, preview: Any) -> None:
        self.preview = preview

    @property
    def room(self) -> Room:
        return Room(float(self.width()), float(self.height()))

    def arm_boxes(self) -> list[Box]:
        return []

    def reset_view(self) -> None:
        self.resets += 1

    def look_from(self, direction: Any) -> None:
        self.looked_from.append(direction)

    def fit(self) -> None:
        self.mode = ViewMode.FIT

    def follow_tool(self, *, wanted: bool) -> None:
        self.mode = ViewMode.FOLLOW if wanted else ViewMode.FIT

    def set_orthographic(self, *, wanted: bool) -> None:
        self.orthographic = wanted

    def show_tool_frame(self, *, wanted: bool) -> None:
        self.tool_frame = wanted

    def show_joint_range(self, number: Any, limits_deg: Any = None) -> None:
        self.joint_range = None if number is None else (number, limits_deg)

    def set_tool(self, tool: Any) -> None:
        self.tool = tool

    def set_reach(self, reach: Any) -> None:
        self.reach = reach

    def set_handles(self, place: Any) -> None:
        self.handles = place

    def set_trail(self, trail: Any) -> None:
        self.trail = trail

    def set_covered(self, strip_px: float) -> None:
        self.covered = strip_px
