"""The position loop in the joint drivers, without a planner: MIT control and high-follow.

The law is a simple one: a joint with a setpoint approaches it with the lag seen on real arms and
no faster than its motor turns; gains only decide whether it is held at all, and a feed-forward
torque does nothing.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import exp
from typing import Final

from armui.arm.limits import FACTORY_LIMITS, JointLimits
from armui.sim.mechanics.powered_joints import JOINT_COUNT, SixValues

_LAG_S: Final = 0.09
"""Time constant with which a joint follows its setpoint."""

_THERE_DEG: Final = 0.001
"""Nearer than this a joint is at its setpoint."""


class JointServo:
    """The setpoints of six drivers, and how the joints follow them.

    There is no watchdog: a driver holds its last setpoint until it gets another or loses it.
    """

    def __init__(self) -> None:
        self._setpoints_deg: dict[int, float] = {}

    def __bool__(self) -> bool:
        return bool(self._setpoints_deg)

    def set(self, index: int, angle_deg: float) -> None:
        """Gives a joint (0–5) a setpoint."""
        self._setpoints_deg[index] = angle_deg

    def void(self, indices: Iterable[int] = range(JOINT_COUNT)) -> None:
        """Takes the setpoints of joints (0–5)."""
        for index in indices:
            self._setpoints_deg.pop(index, None)

    def advance(
        self, positions_deg: SixValues, stops: Sequence[JointLimits], dt_s: float
    ) -> tuple[SixValues, SixValues]:
        """Where the joints are some time later, and how fast they turned in it.

        Args:
            positions_deg: Where they are; those without a setpoint stay there.
            stops: Where the metal ends; joint limits do not bound a driver's setpoint.
            dt_s: How much time passes, above 0.
        """
        share = 1.0 - exp(-dt_s / _LAG_S)
        positions, speeds = list(positions_deg), [0.0] * JOINT_COUNT
        for index, setpoint_deg in self._setpoints_deg.items():
            here = positions[index]
            goal = min(max(setpoint_deg, stops[index].min_deg), stops[index].max_deg)
            stride = FACTORY_LIMITS[index].max_speed_deg_s * dt_s
            way = goal - here
            if abs(way) > _THERE_DEG:
                way = min(max(way * share, -stride), stride)
            positions[index] = here + way
            speeds[index] = way / dt_s
        return tuple(positions), tuple(speeds)
