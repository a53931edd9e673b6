"""The arm's protection against heat, low voltage, stalled joints and collisions.

The protocol names the alarms but no thresholds; those here are assumptions. So is the meaning of
the collision levels: the higher the level, the more torque is attributed to other causes.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Final

from armui.arm.limits import JOINTS
from armui.sim.condition import CUTS_POWER, Alarm, Condition
from armui.sim.mechanics.drivers import Drivers
from armui.sim.mechanics.mechanics import Mechanics
from armui.sim.mechanics.powered_joints import JOINT_COUNT
from armui.sim.mechanics.unpowered_joints import UnpoweredJoints
from armui.sim.parameters.settings import ArmSettingsRecord

_NS_PER_S: Final = 1_000_000_000
_DRIVERS: Final = tuple(f"DriverSlow{joint}" for joint in JOINTS)
LOWEST_V: Final = 20.0
HOT_C: Final = 80.0
COOL_C: Final = 75.0
"""The temperature below which an overheated driver is no longer too hot."""

COLLISION_STEP_NM: Final = (2.0, 2.0, 2.0, 0.6, 0.6, 0.6)
"""The unexplained torque that counts as a collision, for each level and joint."""


@dataclass(eq=False, repr=False)
class Protection:
    """Raises alarms by temperature, supply and torque; a test can block or push a joint.

    It watches one arm; `_brake` is called when an alarm requires it.
    """

    _mechanics: Mechanics
    _drivers: Drivers
    _condition: Condition
    _settings: ArmSettingsRecord
    _brake: Callable[[], None]
    _blocked: list[bool] = field(default_factory=lambda: [False] * JOINT_COUNT, init=False)

    def set_alarm(self, index: int, alarm: Alarm, *, present: bool) -> None:
        """Sets whether the cause of an alarm of a joint (0–5) is present."""
        is_new = self._condition.alarms.set(index, alarm, present=present)
        if present and alarm in CUTS_POWER and self._mechanics.powered[index]:
            self._mechanics.power_off((index,), UnpoweredJoints.FREE)
        if is_new:
            self._brake()

    def block(self, index: int, *, blocked: bool) -> None:
        """Blocks a joint (0–5) so that its motor cannot turn it, or frees it."""
        self._blocked[index] = blocked

    def push(self, index: int, torque_nm: float) -> None:
        """Pushes a joint (0–5) from outside with a torque, until it is set to 0."""
        pushes_nm = list(self._mechanics.weight.pushes_nm)
        pushes_nm[index] = torque_nm
        self._mechanics.weight.pushes_nm = tuple(pushes_nm)

    def may_power(self, index: int) -> bool:
        """Return whether a motor may be switched on: no alarm keeps its driver off."""
        return not self._condition.alarms.of(index) & CUTS_POWER

    def watch(self, names: Collection[str], periods_ns: Mapping[str, int]) -> None:
        """Makes the drivers measure before frames are built, and checks the measurements.

        Args:
            names: The names of the frames.
            periods_ns: The period of the frames of each name, in ns.
        """
        self.watch_torques()
        self._drivers.measure(self._mechanics)
        for index, name in enumerate(_DRIVERS):
            if name in names:
                self._drivers.warm(index, periods_ns[name] / _NS_PER_S)
                self.watch_driver(index)

    def watch_torques(self) -> None:
        """Checks for stalled joints and collisions."""
        if any(self._blocked):
            self._find_stall()
        weight = self._mechanics.weight
        if weight.payload_kg == weight.told_kg and not any(weight.pushes_nm):
            if self._condition.alarms.collision:
                self._compare((0.0,) * JOINT_COUNT)
            return
        positions_deg = self._mechanics.positions_deg
        expected = weight.expected_nm(positions_deg)
        real = weight.torques_nm(positions_deg)
        self._compare(a - b for a, b in zip(real, expected, strict=True))

    def watch_driver(self, index: int) -> None:
        """Checks the temperatures and the supply of one driver (0–5)."""
        drivers = self._drivers
        self.set_alarm(index, Alarm.UNDERVOLTAGE, present=drivers.supply_v < LOWEST_V)
        for alarm, celsius in (
            (Alarm.MOTOR_OVERTEMPERATURE, drivers.motor_temperatures_c[index]),
            (Alarm.DRIVER_OVERTEMPERATURE, drivers.driver_temperatures_c[index]),
        ):
            was_hot = alarm in self._condition.alarms.of(index)
            self.set_alarm(index, alarm, present=celsius >= (COOL_C if was_hot else HOT_C))

    def _compare(self, unexplained_nm: Iterable[float]) -> None:
        for index, torque_nm in enumerate(unexplained_nm):
            level = self._settings.collision_levels[index]
            felt = level > 0 and abs(torque_nm) >= level * COLLISION_STEP_NM[index]
            self.set_alarm(index, Alarm.COLLISION, present=felt and self._mechanics.powered[index])

    def _find_stall(self) -> None:
        """Stops all joints when one that is driven cannot turn, and raises its alarm."""
        mechanics = self._mechanics
        if not mechanics.moving:
            return
        stalled = [
            index
            for index, blocked in enumerate(self._blocked)
            if blocked and mechanics.powered[index] and mechanics.speeds_deg_s[index] != 0.0
        ]
        for index in stalled:
            self.set_alarm(index, Alarm.STALL, present=True)
            self.set_alarm(index, Alarm.STALL, present=False)
        if stalled:
            mechanics.halt()
