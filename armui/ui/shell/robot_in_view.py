"""Chooses the robot description of the 3D picture: the operator's own file, or that of the arm.

The arm's is that of its model, with the zeros of its firmware: the picture of six angles (arm,
ghost, path, handles) then agrees with the flange's pose that the arm reports.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from armui.arm.model_check import ModelFit
from armui.arm.models import robot_description
from armui.ui.freshness import is_stale

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from armui.arm.state import ArmState, GripperState
    from armui.cell.user_frames import UserFrame
    from armui.control.arm_controller import ArmController
    from armui.control.operating_state import OperatingState
    from armui.viewport.view import ArmView


def show_in_view(
    view: ArmView,
    state: ArmState,
    operating_state: OperatingState,
    tool: Sequence[float] = (),
    *,
    calibrated: Callable[[GripperState], float] | None = None,
    frame: UserFrame | None = None,
) -> None:
    """Show angles and pose in the picture; stale values are faded.

    Args:
        view: The 3D picture.
        state: The arm's state.
        operating_state: The operating state.
        tool: The tool centre point in the flange, mm and degrees, whose pose is shown; zeros or
            nothing for the flange.
        calibrated: Returns the gripper's opening by its table; by default the reported one.
        frame: The user frame in which the pose is shown; by default the base.
    """
    joints_stale, pose_stale = (
        any(is_stale(heard, state, operating_state) for heard in six)
        for six in (state.joints_deg, state.pose)
    )
    angles_deg = state.angles_deg()
    if angles_deg is None:
        view.set_joints_unknown()  # the arm is silent: the picture keeps its last pose
    else:
        gripper = None if state.gripper is None else state.gripper.value
        gripper_mm = None if gripper is None else gripper.opening_mm
        if gripper is not None and gripper_mm is not None and calibrated is not None:
            gripper_mm = calibrated(gripper)
        view.set_joints(angles_deg, gripper_mm, stale=joints_stale)
    depths = operating_state.below_base_mm, operating_state.below_lowest_mm
    too_low = any(depth is not None for depth in depths)
    pose: Sequence[float] | None = state.end_pose()
    if pose is not None and (any(tool) or frame is not None):
        from armui.kinematics import poses  # noqa: PLC0415 - numpy, loaded when needed

        pose = poses.tool_pose(pose, tool) if any(tool) else pose
        pose = pose if frame is None else poses.from_base(pose, frame.pose)
    name = "" if frame is None else frame.name
    view.set_pose(pose, stale=pose_stale, too_low=too_low, of_tool=any(tool), frame=name)


class RobotInView(QObject):
    """Shows the robot description of the connected arm in the picture.

    Args:
        view: The 3D picture.
        controller: Gives the model and its zeros.
        urdf_path: The operator's own robot description, which takes precedence.
        parent: The parent object.
    """

    def __init__(
        self,
        view: ArmView,
        controller: ArmController,
        urdf_path: str | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._view = view
        self._controller = controller
        self._urdf_path = urdf_path
        self._shown = Path(urdf_path) if urdf_path else robot_description(ModelFit().chosen)
        controller.operating_state_changed.connect(self._on_operating_state_changed)
        self._show(controller.operating_state.model_fit)

    @property
    def path(self) -> Path:
        """The robot description in use."""
        return self._shown

    def choose(self, urdf_path: str | None) -> None:
        """Set the operator's own robot description; ``None`` for the model's."""
        self._urdf_path = urdf_path
        self._show(self._controller.operating_state.model_fit)

    def _on_operating_state_changed(self, now: OperatingState) -> None:
        self._show(now.model_fit)

    def _show(self, arm: ModelFit) -> None:
        own = robot_description(arm.chosen, older_zeros=arm.older_zeros)
        path = Path(self._urdf_path) if self._urdf_path else own
        if path != self._shown:
            self._shown = path
            self._view.set_robot(path)
