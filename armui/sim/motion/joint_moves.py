"""MOVE J: from the frames of a target to a motion of the joints."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Final

from armui.arm.limits import JOINTS, check_joint
from armui.protocol.codes import ArmStatusCode, MoveMode
from armui.sim.condition import Condition
from armui.sim.mechanics.powered_joints import SixValues
from armui.sim.motion.motion_executor import MotionExecutor
from armui.sim.motion.tool_plan import PlanningError
from armui.sim.parameters.settings import ArmSettingsRecord

_PARTS: Final = 3


class JointMoves:
    """Collects the three frames of a joint target and has it followed.

    A complete target waits until the arm is in CAN control and MOVE J; there it starts at once
    and replaces the one before. Nothing is kept for an arm that cannot move, so neither enabling
    its motors nor ending a stop ever sets it in motion.
    """

    def __init__(
        self,
        executor: MotionExecutor,
        condition: Condition,
        settings: ArmSettingsRecord,
        follow: Callable[[SixValues], None],
    ) -> None:
        """Moves one arm; `follow` takes the targets that are not planned (high-follow)."""
        self._executor = executor
        self._condition = condition
        self._settings = settings
        self._follow = follow
        self._staged = list(executor.targets_deg)
        self._fresh: set[frozenset[int]] = set()
        self._waiting: SixValues | None = None

    def take(self, angles_deg: Mapping[int, float]) -> None:
        """Takes one frame of a target: angles by joint number."""
        if not self._executor.may_move:
            return
        for joint, angle_deg in angles_deg.items():
            self._staged[joint - 1] = angle_deg
        self._fresh.add(frozenset(angles_deg))
        if len(self._fresh) == _PARTS:
            self._fresh.clear()
            self._waiting = tuple(self._staged)
            self.mode_changed()

    def mode_changed(self) -> None:
        """Starts a target that waits, if the mode is right."""
        if self._waiting is not None and self._condition.obeys(MoveMode.MOVE_J):
            target_deg, self._waiting = self._waiting, None
            self._pursue(target_deg)

    def forget(self) -> None:
        """Drops every target, whole or in parts."""
        self._waiting = None
        self.drop_parts()

    def drop_parts(self) -> None:
        """Drops what has come of a target that is not complete."""
        self._fresh.clear()

    def _pursue(self, target_deg: SixValues) -> None:
        """Takes on a complete target, or refuses it and stays."""
        beyond = beyond_limits(target_deg, self._settings)
        if any(beyond):
            planning_error = PlanningError(ArmStatusCode.TARGET_BEYOND_LIMIT, beyond)
            self._executor.refuse(target_deg, planning_error)
        elif self._condition.direct:
            self._executor.forget()
            self._condition.accept_target()
            self._follow(target_deg)
        else:
            self._executor.begin(target_deg, [target_deg], MoveMode.MOVE_J, target_deg)


def beyond_limits(joints_deg: SixValues, settings: ArmSettingsRecord) -> list[bool]:
    """Which joints would leave their range at these angles."""
    return [
        check_joint(joint, angle_deg, limits) is not None
        for joint, angle_deg, limits in zip(JOINTS, joints_deg, settings.limits, strict=True)
    ]
