"""The gripper: a jaw that moves to where it is told, at a steady speed."""

from __future__ import annotations

import math
from typing import Final

_OPENING_SPEED_MM_S: Final = 80.0
_WIDEST: Final = 100.0
"""Largest opening in mm (generation 2) or angle in degrees (generation 1)."""


class Gripper:
    """Where the gripper is and where it goes.

    Its travel is an opening in mm in generation 2 and an angle in degrees in generation 1.

    Attributes:
        travel: Present opening or angle.
        speed: Present speed of the travel, per second.
        torque_nm: Torque it grips with, generation 2.
        enabled: Whether its motor has power.
    """

    def __init__(self) -> None:
        self.travel = 0.0
        self.speed = 0.0
        self.torque_nm = 0.0
        self.enabled = False
        self._target = 0.0
        self._top_speed = _OPENING_SPEED_MM_S

    def command(self, signals: dict[str, float]) -> None:
        """Obeys a 0x159 of either generation; a disabled gripper stays where it is."""
        self.enabled = bool(signals["Enable"])
        if not self.enabled:
            self.release()
            return
        target = signals["Opening"] if "Opening" in signals else signals["Angle"]
        self._target = min(max(target, 0.0), _WIDEST)
        if "Speed" in signals:
            self._top_speed = math.degrees(signals["Speed"])
        self.torque_nm = signals.get("Torque", 0.0)

    def release(self) -> None:
        """Takes its power; it stays where it is."""
        self.enabled = False
        self.speed = self.torque_nm = 0.0
        self._target = self.travel

    def advance(self, dt_s: float) -> None:
        """Lets time pass."""
        gap = self._target - self.travel
        if not gap:
            self.speed = 0.0
            return
        stride = self._top_speed * dt_s
        if stride < abs(gap):
            self.travel += math.copysign(stride, gap)
            self.speed = math.copysign(self._top_speed, gap)
        else:
            self.travel = self._target
            self.speed = 0.0
