"""A 3D view that draws nothing."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget


class FakeView(QWidget):
    """Stands for the 3D view; remembers what it was last given."""

    joint_picked = Signal(int)
    mark_picked = Signal(int)
    load_failed = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self.joints: tuple[Any, ...] | None = None
        self.pose: tuple[Any, ...] | None = None
        self.palette_shown: Any = None
        self.robot: Any = None
        self.resets = 0

    def set_joints(self, angles_deg: Any, gripper_mm: Any, stale: bool = False) -> None:
        self.joints = (angles_deg, gripper_mm, stale)

    def set_pose(self, pose: Any, stale: bool = False) -> None:
        self.pose = (pose, stale)

    def set_theme(self, palette: Any) -> None:
        self.palette_shown = palette

    def set_robot(self, path: Any) -> None:
        self.robot = path

    def set_preview(self, preview: Any) -> None:
        self.preview = preview

    def reset_view(self) -> None:
        self.resets += 1
