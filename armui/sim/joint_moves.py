"""MOVE J: from the frames of a target to a motion of the joints."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from armui.arm.limits import JOINTS, check_joint
from armui.protocol.codes import MotionState
from armui.sim.body import Body
from armui.sim.condition import Condition
from armui.sim.motion import MotionError, SixValues
from armui.sim.settings import Settings

_PARTS: Final = 3


class JointMoves:
    """Collects the three frames of a joint target and follows it to its end.

    A complete target waits until the arm is in CAN control and MOVE J; there it starts at once
    and replaces the one before. Nothing is kept for an arm that cannot move, so neither enabling
    its motors nor ending a stop ever sets it in motion.

    Attributes:
        targets_deg: The last target taken on.
    """

    def __init__(self, body: Body, condition: Condition, settings: Settings) -> None:
        self._body = body
        self._condition = condition
        self._settings = settings
        self._staged = list(body.positions_deg)
        self._fresh: set[frozenset[int]] = set()
        self._waiting: SixValues | None = None
        self._goal: SixValues | None = None
        self.targets_deg: SixValues = body.positions_deg

    def take(self, angles_deg: Mapping[int, float]) -> None:
        """Takes one frame of a target: angles by joint number."""
        if not self._may_move():
            return
        for joint, angle_deg in angles_deg.items():
            self._staged[joint - 1] = angle_deg
        self._fresh.add(frozenset(angles_deg))
        if len(self._fresh) == _PARTS:
            self._fresh.clear()
            self._waiting = tuple(self._staged)
            if self._condition.obeys_joint_targets:
                self._pursue(self._waiting)

    def mode_changed(self) -> None:
        """Starts, ends or changes the motion as the mode and speed in `condition` now ask."""
        if not self._condition.obeys_joint_targets:
            self.cut_short()
        elif self._waiting is not None:
            self._pursue(self._waiting)
        elif self._goal is not None:
            self._drive(self._goal)

    def cut_short(self) -> None:
        """Brakes; the target counts as not reached. One that waits goes on waiting."""
        self._goal = None
        self._body.brake(self._settings.accelerations_deg_s2)

    def forget(self) -> None:
        """Drops every target, whole or in parts; what moves is left to the caller."""
        self._goal = None
        self._waiting = None
        self._fresh.clear()

    def time_passed(self) -> None:
        """Notices that the target is reached."""
        if self._goal is not None and self._body.positions_deg == self._goal:
            self._arrive()

    def _may_move(self) -> bool:
        condition = self._condition
        return all(self._body.powered) and not condition.stopped and not condition.hindered

    def _pursue(self, target_deg: SixValues) -> None:
        """Takes on a complete target, or refuses it and stays."""
        condition = self._condition
        self._waiting = None
        condition.no_solution = False
        condition.beyond_limit = [
            check_joint(joint, angle_deg, limits) is not None
            for joint, angle_deg, limits in zip(
                JOINTS, target_deg, self._settings.limits, strict=True
            )
        ]
        if any(condition.beyond_limit):
            self.cut_short()
            return
        self.targets_deg = target_deg
        self._goal = target_deg
        self._drive(target_deg)

    def _drive(self, goal_deg: SixValues) -> None:
        """Plans towards the goal with the present speed percentage; at 0 % there is no motion."""
        accelerations = self._settings.accelerations_deg_s2
        share = self._condition.speed_percent / 100.0
        if not share:
            self._body.brake(accelerations)
            return
        speeds = [share * limits.max_speed_deg_s for limits in self._settings.limits]
        try:
            self._body.move_to(goal_deg, speeds, accelerations)
        except MotionError:
            self._goal = None
            self._body.halt()
            self._condition.no_solution = True
            return
        if self._body.moving:
            self._condition.motion_state = MotionState.NOT_REACHED
        else:
            self._arrive()

    def _arrive(self) -> None:
        self._goal = None
        self._condition.motion_state = MotionState.REACHED
