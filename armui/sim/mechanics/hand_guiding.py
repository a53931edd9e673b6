"""A person's hand that moves the arm: in drag teaching, or while it is a teaching input."""

from __future__ import annotations

from collections.abc import Sequence

from armui.arm.limits import JointLimits
from armui.sim.mechanics.powered_joints import JOINT_COUNT, STANDSTILL, SixValues


class HandGuiding:
    """Moves the joints that give way, as a person's hand would.

    Attributes:
        gripper_to: Where it holds the jaws, in the gripper's unit; None when it leaves them alone.
    """

    def __init__(self) -> None:
        self._speeds_deg_s: SixValues = STANDSTILL
        self._goal_deg: SixValues | None = None
        self._speed_deg_s = 0.0
        self.gripper_to: float | None = None

    def push(self, speeds_deg_s: Sequence[float]) -> None:
        """Turns each joint at a speed, until something else is asked for."""
        self._goal_deg = None
        self._speeds_deg_s = tuple(speeds_deg_s)

    def lead_to(self, joints_deg: Sequence[float], speed_deg_s: float = 30.0) -> None:
        """Leads all joints to six angles; the one with the longest way turns at this speed."""
        self._goal_deg = tuple(joints_deg)
        self._speed_deg_s = speed_deg_s

    def let_go(self) -> None:
        """Leaves the arm, and its jaws, where they are."""
        self._goal_deg = None
        self._speeds_deg_s = STANDSTILL
        self.gripper_to = None

    def advance(
        self, positions_deg: SixValues, stops: Sequence[JointLimits], dt_s: float
    ) -> tuple[SixValues, SixValues]:
        """Where the joints are some time later, and how fast they turned in it.

        Args:
            positions_deg: Where they are.
            stops: Where the metal ends.
            dt_s: How much time passes.
        """
        if dt_s <= 0.0:
            return positions_deg, self._speeds_deg_s
        there = self._goal_deg
        if there is None:
            there = tuple(
                positions_deg[i] + self._speeds_deg_s[i] * dt_s for i in range(JOINT_COUNT)
            )
        else:
            gaps = [there[i] - positions_deg[i] for i in range(JOINT_COUNT)]
            share = self._speed_deg_s * dt_s / max(*map(abs, gaps), 1e-9)
            if share < 1.0 - 1e-9:
                there = tuple(positions_deg[i] + share * gaps[i] for i in range(JOINT_COUNT))
        there = tuple(
            min(max(angle, stop.min_deg), stop.max_deg)
            for angle, stop in zip(there, stops, strict=True)
        )
        speeds = tuple((b - a) / dt_s for a, b in zip(positions_deg, there, strict=True))
        return there, speeds
