"""The gripper as 0x2A8 tells it."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from typing import NamedTuple


class GripperFault(enum.StrEnum):
    """What the gripper's driver complains of, by the signal that says so (generation 2)."""

    UNDERVOLTAGE = "Undervoltage"
    MOTOR_OVERTEMPERATURE = "MotorOvertemperature"
    OVERCURRENT = "Overcurrent"
    DRIVER_OVERTEMPERATURE = "DriverOvertemperature"
    SENSOR = "SensorFault"
    DRIVER = "DriverFault"


class GripperState(NamedTuple):
    """What 0x2A8 says.

    Attributes:
        opening_mm: Generation 2; ``None`` in generation 1, and while it tells an angle.
        angle_deg: Generation 1, and generation 2 once it was told an angle (from S-V1.8-8).
        enabled: Whether its motor holds.
        torque_nm: Generation 2; ``None`` in generation 1.
        speed_rad_s: Generation 1; ``None`` in generation 2.
        homed: Whether it knows its zero; ``None`` in generation 1, which does not say.
        faults: What is wrong; always empty in generation 1, which has no bits for it.
    """

    opening_mm: float | None
    angle_deg: float | None
    enabled: bool
    torque_nm: float | None = None
    speed_rad_s: float | None = None
    homed: bool | None = None
    faults: frozenset[GripperFault] = frozenset()

    @property
    def travel(self) -> float:
        """How far it is open, in the unit that `unit` says."""
        return (self.angle_deg if self.opening_mm is None else self.opening_mm) or 0.0

    @property
    def unit(self) -> str:
        """Of `travel`: mm or degrees."""
        return "°" if self.opening_mm is None else "mm"


def gripper_of(signals: Mapping[str, float]) -> GripperState:
    """The gripper by the signals of 0x2A8 of either generation."""
    homed = signals.get("Homed")
    return GripperState(
        opening_mm=signals.get("Opening"),
        angle_deg=signals.get("Angle"),
        enabled=signals["Enabled"] == 1,
        torque_nm=signals.get("Torque"),
        speed_rad_s=signals.get("Speed"),
        homed=None if homed is None else homed == 1,
        faults=frozenset(fault for fault in GripperFault if signals.get(fault) == 1),
    )
