"""The measurements of the six motor drivers: current, voltage, temperatures.

They are simple models with estimated constants: the feedback becomes plausible and consistent with
the motion, no more.
"""

from __future__ import annotations

from math import radians
from typing import Final

import numpy as np

from armui.sim.mechanics.joint_dynamics import JointLosses
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import JOINT_COUNT, STANDSTILL, SixValues

_INERTIA_KG_M2: Final = (0.25, 0.30, 0.12, 0.02, 0.02, 0.01)
_FRICTION_NM_S_RAD: Final = (0.8, 0.8, 0.8, 0.3, 0.3, 0.3)

_PEAK_NM: Final = JointLosses().peak_nm

SUPPLY_V: Final = 24.0
_SUPPLY_NOISE_V: Final = 0.1
_LINE_RESISTANCE_OHM: Final = 0.02
_VOLTAGE_DIGITS: Final = 1
"""The voltmeter's resolution, that of the protocol."""
_IDLE_A: Final = 0.05

_COLD_C: Final = 31.0
_SPREAD_C: Final = 2.0
_HOTTEST_C: Final = 40.0
_WARMTH_C_PER_A2: Final = 2.0
_DRIVER_SHARE: Final = 0.6
"""The rise in temperature of a driver, as a share of its motor's."""
_WARMING_TIME_S: Final = 90.0
_OVERHEATED_C: Final = 95.0
_WARMER_C: Final = 25.0
"""A joint that runs hot is warmer by this much, which is below the alarm."""


class Drivers:
    """The measurements of six drivers.

    Attributes:
        currents_a: Motor currents, positive when driving towards larger angles.
        motor_temperatures_c: Temperatures of the motors, 30–40 °C unless overheated.
        driver_temperatures_c: Temperatures of the drivers, likewise.
        supply_v: The voltage of the supply.
    """

    def __init__(self, seed: int, nm_per_ampere: SixValues) -> None:
        """Starts with cold drivers.

        Args:
            seed: The seed of the noise.
            nm_per_ampere: Torque at the output for a motor's current, joint 1 first.
        """
        self._nm_per_ampere = nm_per_ampere
        self._noise = np.random.default_rng(seed)
        self._ambient_c = [
            _COLD_C + _SPREAD_C * float(share) for share in self._noise.random(JOINT_COUNT)
        ]
        self._measured: tuple[object, ...] = ()
        self._speeds_rad_s: SixValues = STANDSTILL
        self._torques_nm: SixValues = STANDSTILL
        self.currents_a: SixValues = STANDSTILL
        self.motor_temperatures_c = list(self._ambient_c)
        self.driver_temperatures_c = list(self._ambient_c)
        self.supply_v = SUPPLY_V
        self._warmer: set[int] = set()
        self._hot_motors: set[int] = set()
        self._hot_drivers: set[int] = set()

    def measure(self, mechanics: Mechanics) -> None:
        """Computes the currents from the present motion and load."""
        powered, speeds_deg_s = mechanics.powered, mechanics.speeds_deg_s
        accelerations_deg_s2 = mechanics.accelerations_deg_s2
        driven = mechanics.driver_torques_nm
        measured = (
            mechanics.positions_deg,
            speeds_deg_s,
            accelerations_deg_s2,
            powered,
            mechanics.weight.payload_kg,
            mechanics.weight.pushes_nm,
            mechanics.drag_nm,
            driven,
        )
        if measured == self._measured:
            return
        self._measured = measured
        gravity = (
            STANDSTILL
            if len(driven) == JOINT_COUNT
            else mechanics.weight.torques_nm(mechanics.positions_deg)
        )
        self._speeds_rad_s = tuple(map(radians, speeds_deg_s))
        self._torques_nm = tuple(
            driven[i]
            if i in driven
            else (
                _INERTIA_KG_M2[i] * radians(accelerations_deg_s2[i])
                + _FRICTION_NM_S_RAD[i] * self._speeds_rad_s[i]
                + mechanics.friction_nm(i)
                - gravity[i]
                if powered[i]
                else 0.0
            )
            for i in range(JOINT_COUNT)
        )
        self.currents_a = tuple(
            min(max(torque, -most), most) / ratio
            for torque, ratio, most in zip(
                self._torques_nm, self._nm_per_ampere, _PEAK_NM, strict=True
            )
        )

    def warm(self, index: int, dt_s: float) -> None:
        """Warms or cools one motor and its driver by the present current."""
        share = min(dt_s / _WARMING_TIME_S, 1.0)
        heat_c = _WARMTH_C_PER_A2 * self.currents_a[index] ** 2
        ambient_c = self._ambient_c[index]
        for temperatures, part, overheated in (
            (self.motor_temperatures_c, 1.0, self._hot_motors),
            (self.driver_temperatures_c, _DRIVER_SHARE, self._hot_drivers),
        ):
            if index in overheated:
                temperatures[index] = _OVERHEATED_C
                continue
            goal_c = min(ambient_c + part * heat_c, _HOTTEST_C)
            goal_c += _WARMER_C if index in self._warmer else 0.0
            temperatures[index] += (goal_c - temperatures[index]) * share

    def run_hot(self, index: int, *, on: bool) -> None:
        """Makes a motor and its driver (0–5) warmer than their work explains, or as they were."""
        (self._warmer.add if on else self._warmer.discard)(index)
        for temperatures in (self.motor_temperatures_c, self.driver_temperatures_c):
            temperatures[index] += _WARMER_C if on else -_WARMER_C

    def overheat_motor(self, index: int, *, on: bool) -> None:
        """Heats a motor (0–5) far beyond its limit, or lets it cool."""
        (self._hot_motors.add if on else self._hot_motors.discard)(index)

    def overheat_driver(self, index: int, *, on: bool) -> None:
        """Heats a driver (0–5) far beyond its limit, or lets it cool."""
        (self._hot_drivers.add if on else self._hot_drivers.discard)(index)

    def voltage_v(self) -> float:
        """Return one reading of the supply, with noise and a drop that grows with the load."""
        drop_v = _LINE_RESISTANCE_OHM * sum(map(abs, self.currents_a))
        noise_v = _SUPPLY_NOISE_V * float(self._noise.uniform(-1.0, 1.0))
        return round(self.supply_v - drop_v + noise_v, _VOLTAGE_DIGITS)

    def bus_current_a(self, index: int) -> float:
        """Return the current that one driver draws from the supply."""
        power_w = abs(self._torques_nm[index] * self._speeds_rad_s[index])
        return _IDLE_A + power_w / self.supply_v
