"""The loop in the joint drivers, without a planner: MIT control and high-follow.

Each driver follows its last setpoint by the law kp·(position − q) + kd·(speed − q̇) + torque at the
output; there is no watchdog. How the joints move with it is `joint_dynamics`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Final, NamedTuple

import numpy as np

from armui.arm.limits import JointLimits
from armui.sim.mechanics.gravity import Weight
from armui.sim.mechanics.joint_dynamics import DriverLaw, JointDynamics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, STANDSTILL, SixValues
from armui.sim.mechanics.rigid_body import Values


class DriverSetpoint(NamedTuple):
    """What one driver is told.

    Attributes:
        position_deg: Counted from the joint's own zero.
        speed_rad_s: Speed.
        kp: N·m for each rad that the joint is off its position.
        kd: N·m for each rad/s that it is off its speed.
        torque_nm: Torque at the output.
        carries_weight: Whether the controller adds the torque that its model of gravity asks for.
    """

    position_deg: float = 0.0
    speed_rad_s: float = 0.0
    kp: float = 0.0
    kd: float = 0.0
    torque_nm: float = 0.0
    carries_weight: bool = False


LIMP: Final = DriverSetpoint()
"""Powered, and told nothing: the joint falls."""


class DriverLoop:
    """The setpoints of the drivers that follow them, and how their joints move.

    Attributes:
        torques_nm: What the drivers gave last, joint 1 first; 0 for the others.
    """

    def __init__(self, weight: Weight) -> None:
        self._weight = weight
        self._dynamics = JointDynamics()
        self._setpoints: dict[int, DriverSetpoint] = {}
        self._law: DriverLaw | None = None
        self._speeds_rad_s: Values = np.zeros(JOINT_COUNT)
        self._resting: tuple[object, ...] = ()
        self.torques_nm: SixValues = STANDSTILL

    def __bool__(self) -> bool:
        return bool(self._setpoints)

    def __contains__(self, index: object) -> bool:
        return index in self._setpoints

    def set(self, index: int, setpoint: DriverSetpoint, speed_deg_s: float = 0.0) -> None:
        """Gives a driver (0–5) a setpoint.

        Args:
            index: The joint.
            setpoint: What it is to follow from now on.
            speed_deg_s: How fast the joint turns, if something else has moved it until now.
        """
        if self._setpoints.get(index) == setpoint:
            return  # hosts repeat themselves at 200 Hz
        if index not in self._setpoints:
            self._speeds_rad_s[index] = np.radians(speed_deg_s)
        self._setpoints[index] = setpoint
        self._law = None

    def void(self, indices: Iterable[int] = range(JOINT_COUNT)) -> None:
        """Takes joints (0–5) from the loop: something else holds or moves them now."""
        for index in indices:
            if self._setpoints.pop(index, None) is not None:
                self._law = None
            self._speeds_rad_s[index] = 0.0

    def advance(
        self, positions_deg: SixValues, stops: Sequence[JointLimits], dt_s: float
    ) -> tuple[SixValues, SixValues]:
        """Where the joints are some time later, and how fast they turn then.

        Args:
            positions_deg: Where they are; those outside the loop stay there.
            stops: Where the metal ends; joint limits do not bound a driver's setpoint.
            dt_s: How much time passes, above 0.
        """
        weight = self._weight
        law = self._law or self._new_law()
        conditions = (id(law), positions_deg, stops, weight.payload_kg, weight.told_kg, weight.down,
                      weight.pushes_nm, tuple(weight.zeros_deg))  # fmt: skip
        if conditions == self._resting:
            return positions_deg, STANDSTILL
        zeros_rad = np.radians(weight.zeros_deg)
        told = self._with_weight(law, positions_deg)
        joints, speeds = self._dynamics.advance(
            weight.body,
            DriverLaw(
                told.positions_rad + zeros_rad,
                told.speeds_rad_s,
                told.kp,
                told.kd,
                told.torques_nm,
                told.driven,
            ),
            np.radians(positions_deg) + zeros_rad,
            self._speeds_rad_s,
            stops_rad=(
                np.radians([stop.min_deg for stop in stops]) + zeros_rad,
                np.radians([stop.max_deg for stop in stops]) + zeros_rad,
            ),
            dt_s=dt_s,
            down=weight.down,
            pushes_nm=np.array(weight.pushes_nm),
        )
        self._speeds_rad_s = speeds
        self.torques_nm = tuple(self._dynamics.torques_nm.tolist())
        angles_deg = np.degrees(joints - zeros_rad).tolist()
        there = tuple(
            angles_deg[i] if i in self._setpoints else positions_deg[i] for i in range(JOINT_COUNT)
        )
        speeds_deg_s = tuple(np.degrees(speeds).tolist())
        if not any(speeds_deg_s):
            there = positions_deg if _same(there, positions_deg) else there
            self._resting = (conditions[0], there, *conditions[2:])
        return there, speeds_deg_s

    def _new_law(self) -> DriverLaw:
        law = DriverLaw()
        for index, each in self._setpoints.items():
            law.positions_rad[index] = np.radians(each.position_deg)
            law.speeds_rad_s[index] = each.speed_rad_s
            law.kp[index] = each.kp
            law.kd[index] = each.kd
            law.torques_nm[index] = each.torque_nm
            law.driven[index] = True
        self._law = law
        self._resting = ()
        return law

    def _with_weight(self, law: DriverLaw, positions_deg: SixValues) -> DriverLaw:
        """The law with the torque that carries the arm's weight, where the controller adds it."""
        carrying = [index for index, each in self._setpoints.items() if each.carries_weight]
        if not carrying:
            return law
        torques = law.torques_nm.copy()
        torques[carrying] -= np.array(self._weight.expected_nm(positions_deg))[carrying]
        return DriverLaw(law.positions_rad, law.speeds_rad_s, law.kp, law.kd, torques, law.driven)


def _same(one: SixValues, other: SixValues) -> bool:
    """Whether angles differ by less than the rounding of degrees to radians and back."""
    return all(abs(a - b) < 1e-9 for a, b in zip(one, other, strict=True))
