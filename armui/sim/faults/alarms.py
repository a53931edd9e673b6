"""The alarms that the joints' drivers report."""

from __future__ import annotations

import enum
from collections.abc import Iterable
from typing import Final

from armui.sim.mechanics.powered_joints import JOINT_COUNT


class Alarm(enum.StrEnum):
    """An alarm of a driver; the value is the name of its bit in 0x261–0x266.

    Not every generation has every bit. A sensor fault is told as a driver fault where its own bit
    means something else; collision and stall then show in 0x2A1 alone.
    """

    UNDERVOLTAGE = "Undervoltage"
    MOTOR_OVERTEMPERATURE = "MotorOvertemperature"
    OVERCURRENT = "Overcurrent"
    DRIVER_OVERTEMPERATURE = "DriverOvertemperature"
    SENSOR = "SensorFault"
    DRIVER = "DriverFault"
    COLLISION = "CollisionProtection"
    STALL = "StallProtection"


KEPT: Final = frozenset({Alarm.OVERCURRENT, Alarm.DRIVER, Alarm.COLLISION, Alarm.STALL})
"""Stay after their cause has gone, until they are cleared; the others end with their cause."""

CUTS_POWER: Final = frozenset({Alarm.OVERCURRENT, Alarm.DRIVER})
"""The driver switches its own motor off; with the others it goes on holding the joint."""


class Alarms:
    """The alarms of six drivers.

    Attributes:
        any: Whether there is one.
        collision: Whether one of them is a collision.
    """

    def __init__(self) -> None:
        self._causes: list[set[Alarm]] = [set() for _ in range(JOINT_COUNT)]
        self._kept: list[set[Alarm]] = [set() for _ in range(JOINT_COUNT)]
        self.any = False
        self.collision = False

    def of(self, index: int) -> set[Alarm]:
        """The alarms that the driver of a joint (0–5) reports."""
        return self._causes[index] | self._kept[index]

    def set(self, index: int, alarm: Alarm, *, present: bool) -> bool:
        """Says whether the cause of an alarm is there; tells whether the alarm is new."""
        if present == (alarm in self._causes[index]):
            return False
        is_new = present and alarm not in self._kept[index]
        if present:
            self._causes[index].add(alarm)
            if alarm in KEPT:
                self._kept[index].add(alarm)
        else:
            self._causes[index].discard(alarm)
        self._sum_up()
        return is_new

    def clear(self, indices: Iterable[int]) -> None:
        """Clears what is kept; an alarm whose cause is still there stays."""
        for index in indices:
            self._kept[index] = self._causes[index] & KEPT
        self._sum_up()

    def _sum_up(self) -> None:
        alarms = [self.of(index) for index in range(JOINT_COUNT)]
        self.any = any(alarms)
        self.collision = any(Alarm.COLLISION in each for each in alarms)
