"""What a handle in the picture changes: the target of a panel, or a point of a trajectory."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Protocol

from armui.arm.refusal import Refusal

if TYPE_CHECKING:
    from armui.control.arm_controller import ArmController
    from armui.ui.panels.jogging.cartesian_panel import CartesianPanel
    from armui.ui.panels.jogging.motion_panel import MotionPanel


class DragTarget(Protocol):
    """Something that stands for a pose of the arm, and can be given another one."""

    def angles_deg(self) -> tuple[float, ...] | None:
        """The six angles it stands for now; None: it stands for none."""

    def begin(self) -> None:
        """It is taken hold of."""

    def is_as_begun(self) -> bool:
        """Tell whether it still is what was taken hold of."""

    def carry(self, angles_deg: tuple[float, ...]) -> None:
        """Show that it is being dragged there; nothing is sent."""

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """The drag has ended there: keep it; or why it can't be kept."""

    def give_up(self, angles_deg: tuple[float, ...]) -> None:
        """The drag was given up: stand where it stood before."""


class MotionTarget:
    """The target fields of 运动控制; 发送 sends them.

    Args:
        panel: The panel.
    """

    def __init__(self, panel: MotionPanel) -> None:
        self._panel = panel
        self._given = panel.given()

    def begin(self) -> None:
        """Note which fields follow the arm."""
        self._given = self._panel.given()

    def is_as_begun(self) -> bool:
        """Tell that the fields are the same; see `DragTarget`."""
        return True

    def angles_deg(self) -> tuple[float, ...] | None:
        """What stands in the six fields."""
        return self._panel.targets()

    def carry(self, angles_deg: tuple[float, ...]) -> None:
        """Into the fields."""
        self._panel.take_targets(angles_deg)

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """It stands there already."""
        self._panel.take_targets(angles_deg)
        return None

    def give_up(self, angles_deg: tuple[float, ...]) -> None:
        """Back into the fields; those that followed the arm go on."""
        self._panel.take_targets(angles_deg, self._given)


class CartesianTarget:
    """The target fields of 末端控制; MOVE P and MOVE L send them.

    Args:
        panel: The panel.
        controller: Knows the arm and its kinematics.
    """

    def __init__(self, panel: CartesianPanel, controller: ArmController) -> None:
        self._panel = panel
        self._controller = controller
        self._solved: tuple[tuple[float, ...], tuple[float, ...] | None] | None = None
        self._given = panel.given()
        self._pose = panel.targets()

    def begin(self) -> None:
        """Note which fields follow the arm, and what stands in them."""
        self._given = self._panel.given()
        self._pose = self._panel.targets()

    def is_as_begun(self) -> bool:
        """Tell that the fields are the same; see `DragTarget`."""
        return True

    def angles_deg(self) -> tuple[float, ...] | None:
        """Angles for what stands in the six fields, near to where the arm is, if there are any."""
        pose = self._panel.targets()
        measured_deg = self._controller.state.angles_deg()
        if pose is None or measured_deg is None:
            return None
        if self._solved is None or self._solved[0] != pose:
            self._solved = (pose, self._solve(pose, measured_deg))
        return self._solved[1]

    def carry(self, angles_deg: tuple[float, ...]) -> None:
        """Into the fields, as the pose of the tool centre point."""
        from armui.kinematics import poses  # noqa: PLC0415 - numpy, loaded when needed

        cartesian = self._controller.cartesian
        tool_point = poses.tool_matrix(cartesian.kinematics().matrix(angles_deg), cartesian.tool)
        self._panel.take_targets(poses.matrix_to_pose(tool_point))
        pose = self._panel.targets()
        if pose is not None:
            self._solved = (pose, angles_deg)  # what leads there is known: it was dragged there

    def drop(self, angles_deg: tuple[float, ...]) -> Refusal | None:
        """It stands there already."""
        self.carry(angles_deg)
        return None

    def give_up(self, _angles_deg: tuple[float, ...]) -> None:
        """Back into the fields; those that followed the arm go on."""
        if self._pose is not None:
            self._panel.take_targets(self._pose, self._given)

    def _solve(
        self, pose: tuple[float, ...], near_deg: Sequence[float]
    ) -> tuple[float, ...] | None:
        from armui.arm.reach import check_pose  # noqa: PLC0415 - numpy, loaded when needed
        from armui.kinematics.poses import flange_pose  # noqa: PLC0415 - as above

        cartesian = self._controller.cartesian
        limits = self._controller.operating_state.limits
        flange = flange_pose(pose, cartesian.tool)
        answer = check_pose(cartesian.kinematics(), flange, near_deg, limits)
        return None if isinstance(answer, Refusal) else tuple(answer)
