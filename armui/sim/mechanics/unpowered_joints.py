"""The joints without power: the arm has no brakes, so gravity moves them."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Sequence
from math import exp
from typing import Final

from armui.arm.limits import JointLimits
from armui.sim.mechanics.gravity import Weight
from armui.sim.mechanics.powered_joints import JOINT_COUNT, SixValues

_LONGEST_STEP_S: Final = 0.005
_SETTLING_TIME_S: Final = 0.1
"""The time constant with which a joint approaches the speed of its torque."""

_STICTION_NM: Final = 0.4
"""A smaller torque turns no joint: the gears hold a wrist that carries nothing."""

_STANDING_DEG_S: Final = 0.05


class UnpoweredJoints(enum.Enum):
    """The manner in which a joint without power gives way."""

    DAMPED = enum.auto()
    """After an emergency stop: the motor's windings brake the joint, and it sinks slowly."""
    FREE = enum.auto()
    """After a power cut: the joint drops."""


_MOBILITY_DEG_S_NM: Final = {UnpoweredJoints.DAMPED: 1.0, UnpoweredJoints.FREE: 40.0}
_TOP_SPEED_DEG_S: Final = {UnpoweredJoints.DAMPED: 5.0, UnpoweredJoints.FREE: 120.0}


class LimpJoints:
    """The joints moved by gravity.

    A joint that was never powered is supported, and not among them.

    Attributes:
        speeds_deg_s: The joints' speeds, 0 for those that are held.
    """

    def __init__(self, weight: Weight) -> None:
        self._weight = weight
        self._limp: list[UnpoweredJoints | None] = [None] * JOINT_COUNT
        self.speeds_deg_s = [0.0] * JOINT_COUNT

    def __contains__(self, index: object) -> bool:
        return isinstance(index, int) and self._limp[index] is not None

    def __bool__(self) -> bool:
        return any(self._limp)

    def release(self, indices: Iterable[int], unpowered: UnpoweredJoints) -> None:
        """Releases joints from a standstill; one that is giving way already keeps its speed."""
        for index in indices:
            if self._limp[index] is None:
                self.speeds_deg_s[index] = 0.0
            self._limp[index] = unpowered

    def catch(self, index: int) -> None:
        """Holds a joint again: it stops instantly."""
        self._limp[index] = None
        self.speeds_deg_s[index] = 0.0

    def step(
        self, positions_deg: Sequence[float], limits: Sequence[JointLimits], dt_s: float
    ) -> SixValues:
        """Return the positions of all joints after a time; joints that are not limp keep theirs."""
        positions = list(positions_deg)
        while dt_s > 0.0:
            step_s = min(dt_s, _LONGEST_STEP_S)
            self._step(positions, limits, step_s)
            dt_s -= step_s
        return tuple(positions)

    def _step(self, positions: list[float], limits: Sequence[JointLimits], dt_s: float) -> None:
        share = 1.0 - exp(-dt_s / _SETTLING_TIME_S)
        torques = self._weight.torques_nm(positions)
        for index, unpowered in enumerate(self._limp):
            if unpowered is None:
                continue
            wanted = _free_speed_deg_s(torques[index], unpowered)
            speed = self.speeds_deg_s[index]
            speed += (wanted - speed) * share
            if wanted == 0.0 and abs(speed) < _STANDING_DEG_S:
                speed = 0.0
            here = positions[index]
            there = here + speed * dt_s
            # a joint that is beyond a limit already may only come back
            bounded = min(
                max(there, min(limits[index].min_deg, here)), max(limits[index].max_deg, here)
            )
            positions[index] = bounded
            self.speeds_deg_s[index] = speed if bounded == there else 0.0


def _free_speed_deg_s(torque_nm: float, unpowered: UnpoweredJoints) -> float:
    """Return the speed at which damping and gravity balance."""
    if abs(torque_nm) < _STICTION_NM:
        return 0.0
    top = _TOP_SPEED_DEG_S[unpowered]
    return min(max(torque_nm * _MOBILITY_DEG_S_NM[unpowered], -top), top)
