"""The loop in the joint drivers, without a planner: MIT control and high-follow.

Each driver follows its last setpoint by the law kp·(position − q) + kd·(speed − q̇) + torque at the
output; there is no watchdog. `joint_dynamics` computes the motion of the joints.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import radians
from operator import is_
from typing import Final

import numpy as np

from armui.arm.limits import JointLimits
from armui.sim.mechanics.gravity import Weight
from armui.sim.mechanics.joint_dynamics import DriverLaw, JointDynamics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, STANDSTILL, SixValues
from armui.sim.mechanics.rigid_body import Values


@dataclass(frozen=True, slots=True)
class DriverSetpoint:
    """The setpoint of one driver.

    Attributes:
        position_deg: The position, counted from the joint's own zero.
        speed_rad_s: Speed.
        kp: N·m for each rad of position error.
        kd: N·m for each rad/s of speed error.
        torque_nm: Torque at the output.
        carries_weight: True if the controller adds the torque of its gravity model.
    """

    position_deg: float = 0.0
    speed_rad_s: float = 0.0
    kp: float = 0.0
    kd: float = 0.0
    torque_nm: float = 0.0
    carries_weight: bool = False


LIMP: Final = DriverSetpoint()
"""The setpoint of a powered joint that was given none: the joint falls."""


class DriverLoop:
    """The setpoints of the drivers that follow them, and the motion of their joints.

    Attributes:
        torques_nm: The last torques of the drivers in the loop, by joint (0–5).
    """

    def __init__(self, weight: Weight) -> None:
        self._weight = weight
        self._dynamics = JointDynamics()
        self._setpoints: dict[int, DriverSetpoint] = {}
        self._law: DriverLaw | None = None
        self._frame: tuple[object, ...] = ()
        self._zeros_rad: Values = np.zeros(JOINT_COUNT)
        self._stops_rad: tuple[Values, Values] = (self._zeros_rad, self._zeros_rad)
        self._speeds_rad_s: Values = np.zeros(JOINT_COUNT)
        self._resting: tuple[object, ...] = ()
        self.torques_nm: dict[int, float] = {}

    def __bool__(self) -> bool:
        return bool(self._setpoints)

    def __contains__(self, index: object) -> bool:
        return index in self._setpoints

    def set(self, index: int, setpoint: DriverSetpoint, speed_deg_s: float = 0.0) -> None:
        """Gives a driver (0–5) a setpoint.

        Args:
            index: The joint.
            setpoint: The setpoint to follow from now on.
            speed_deg_s: The joint's speed, if something else has moved it until now.
        """
        before = self._setpoints.get(index)
        if before == setpoint:
            return  # hosts repeat a target at 200 Hz: it is in force already
        if before is None:
            self._speeds_rad_s[index] = radians(speed_deg_s)
            self.torques_nm = {**self.torques_nm, index: 0.0}
        self._setpoints[index] = setpoint
        self._law = None

    def void(self, indices: Iterable[int] = range(JOINT_COUNT)) -> None:
        """Removes joints (0–5) from the loop: something else holds or moves them now."""
        for index in indices:
            if self._setpoints.pop(index, None) is not None:
                self._law = None
            self._speeds_rad_s[index] = 0.0
        self.torques_nm = {i: self.torques_nm[i] for i in self._setpoints}

    def step(
        self, positions_deg: SixValues, stops: Sequence[JointLimits], dt_s: float
    ) -> tuple[SixValues, SixValues]:
        """Return the joints' positions and speeds after a time.

        Args:
            positions_deg: The present positions; joints outside the loop keep theirs.
            stops: The mechanical stops; joint limits do not bound a driver's setpoint.
            dt_s: The time to advance, above 0.
        """
        weight = self._weight
        self._look_at_frame(stops)
        law = self._law or self._new_law()
        loads = weight.payload_kg, weight.told_kg, weight.down, weight.pushes_nm
        conditions = (law, positions_deg, self._frame, loads)
        resting = self._resting
        if resting and all(map(is_, resting[:3], conditions)) and resting[3] == loads:
            return positions_deg, STANDSTILL
        zeros_rad = self._zeros_rad
        joints, speeds = self._dynamics.step(
            weight.body,
            self._with_weight(law, positions_deg),
            np.radians(positions_deg) + zeros_rad,
            self._speeds_rad_s,
            stops_rad=self._stops_rad,
            dt_s=dt_s,
            down=weight.down,
            pushes_nm=np.array(weight.pushes_nm) if any(weight.pushes_nm) else None,
        )
        self._speeds_rad_s = speeds
        torques_nm = self._dynamics.torques_nm.tolist()
        self.torques_nm = {index: torques_nm[index] for index in self._setpoints}
        angles_deg = np.degrees(joints - zeros_rad).tolist()
        there = tuple(
            angles_deg[i] if i in self._setpoints else positions_deg[i] for i in range(JOINT_COUNT)
        )
        speeds_deg_s = tuple(np.degrees(speeds).tolist())
        if not any(speeds_deg_s):
            there = positions_deg if _same(there, positions_deg) else there
            self._resting = (law, there, self._frame, loads)
        return there, speeds_deg_s

    def _look_at_frame(self, stops: Sequence[JointLimits]) -> None:
        """Converts zeros and stops to radians if they have changed."""
        zeros_deg = tuple(self._weight.zeros_deg)
        if self._frame and self._frame[0] == zeros_deg and self._frame[1] is stops:
            return
        self._frame = (zeros_deg, stops)
        self._zeros_rad = np.radians(zeros_deg)
        low, high = (
            np.radians([getattr(stop, name) for stop in stops]) + self._zeros_rad
            for name in ("min_deg", "max_deg")
        )
        self._stops_rad = low, high
        self._law = None

    def _new_law(self) -> DriverLaw:
        law = DriverLaw()
        for index, each in self._setpoints.items():
            law.positions_rad[index] = radians(each.position_deg)
            law.speeds_rad_s[index] = each.speed_rad_s
            law.kp[index] = each.kp
            law.kd[index] = each.kd
            law.torques_nm[index] = each.torque_nm
            law.driven[index] = True
        law.positions_rad += self._zeros_rad
        self._law = law
        return law

    def _with_weight(self, law: DriverLaw, positions_deg: SixValues) -> DriverLaw:
        """Return the law with the torque that carries the weight, where it is added."""
        carrying = [index for index, each in self._setpoints.items() if each.carries_weight]
        if not carrying:
            return law
        torques = law.torques_nm.copy()
        torques[carrying] -= np.array(self._weight.expected_nm(positions_deg))[carrying]
        return DriverLaw(law.positions_rad, law.speeds_rad_s, law.kp, law.kd, torques, law.driven)


def _same(one: SixValues, other: SixValues) -> bool:
    """Return whether angles differ by less than the rounding of degrees to radians and back."""
    return all(abs(a - b) < 1e-9 for a, b in zip(one, other, strict=True))
