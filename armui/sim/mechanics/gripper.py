"""The gripper: its jaws move to a commanded place, and grip an object between them."""

from __future__ import annotations

import math
from typing import Final

from armui.arm.state import GripperFault
from armui.protocol.codes import GripperMeasure
from armui.protocol.generation import Generation
from armui.sim.parameters.settings import ArmSettingsRecord

_OPENING_SPEED_MM_S: Final = 80.0
_WIDEST_MM: Final = 100.0
_WIDEST_DEG: Final = 100.0
_MM_PER_DEG: Final = 1.0
"""The opening for each degree. The relation isn't published; 1 mm for 1° is assumed."""


class SimulatedGripper:
    """The gripper's position, its target and the object it holds.

    Its travel is an opening in mm in generation 2 and an angle in degrees in generation 1. It grows
    as the jaws open. From S-V1.8-8 generation 2 accepts angles as well, and reports the quantity
    that was last commanded.

    Attributes:
        travel: Present opening or angle.
        speed: Present speed of the travel, per second.
        torque_nm: Torque it grips with; 0 while nothing is between the jaws. Generation 2.
        enabled: True if its motor has power.
        errors: The faults; it has no power until they are cleared.
        measure: Whether generation 2 reports an opening or an angle.
        object_width: The size of the object between the jaws, in the unit of the travel, or None.
    """

    def __init__(self, generation: Generation, settings: ArmSettingsRecord) -> None:
        self._generation = generation
        self._settings = settings
        self.travel = 0.0
        self.speed = 0.0
        self.torque_nm = 0.0
        self.enabled = False
        self.errors: set[GripperFault] = set()
        self.measure = GripperMeasure.OPENING
        self.object_width: float | None = None
        self._target = 0.0
        self._top_speed = _OPENING_SPEED_MM_S
        self._wanted_nm = 0.0

    def command(self, signals: dict[str, float], *, knows_angles: bool = True) -> None:
        """Obeys a 0x159 of either generation; a disabled gripper does not move.

        Args:
            signals: The signals of the message.
            knows_angles: True if its firmware accepts angles; an older one takes an angle for an
                opening.
        """
        if signals["ClearError"]:
            self.errors.clear()
        self.enabled = bool(signals["Enable"]) and not self.errors
        if not self.enabled:
            self.release()
            if signals.get("SetZero") and not signals["Enable"]:
                self.travel = self._target = 0.0
            return
        target = signals["Opening"] if "Opening" in signals else signals["Angle"]
        if knows_angles and self._generation is Generation.TWO:
            self.measure = GripperMeasure(int(signals["Measure"]))
            if self.measure is GripperMeasure.ANGLE:
                target *= _MM_PER_DEG
        self._target = min(max(target, 0.0), self.widest)
        if "Speed" in signals:
            self._top_speed = math.degrees(signals["Speed"])
        self._wanted_nm = signals.get("Torque", 0.0)

    @property
    def place(self) -> dict[str, float]:
        """The position, as the signals of 0x2A8 in its generation."""
        if self._generation is Generation.ONE:
            return {"Angle": self.travel}
        if self.measure is GripperMeasure.ANGLE:
            return {"Angle": self.travel / _MM_PER_DEG, "Measure": self.measure}
        return {"Opening": self.travel}

    @property
    def widest(self) -> float:
        """The largest opening: generation 2 sets a stroke limit with 0x47D, 0 for none."""
        if self._generation is Generation.ONE:
            return _WIDEST_DEG
        return self._settings.teaching.stroke_limit_mm or _WIDEST_MM

    def release(self) -> None:
        """Switches its motor off; the jaws do not move."""
        self.enabled = False
        self.speed = self.torque_nm = 0.0
        self._target = self.travel

    def fail(self, error: GripperFault) -> None:
        """Sets an error of its driver, which switches its motor off."""
        self.errors.add(error)
        self.release()

    def lead_to(self, travel: float) -> None:
        """Moves the jaws as a hand would."""
        self.travel = self._target = min(max(travel, 0.0), self.widest)

    def step(self, dt_s: float) -> None:
        """Advances by `dt_s` seconds."""
        self.speed = self.torque_nm = 0.0
        if not self.enabled:
            return
        goal = self._target
        thing = self.object_width
        if thing is not None and goal < thing <= self.travel:
            goal = thing
        gap = goal - self.travel
        stride = self._top_speed * dt_s
        if stride < abs(gap):
            self.travel += math.copysign(stride, gap)
            self.speed = math.copysign(self._top_speed, gap)
        else:
            self.travel = goal
            if goal != self._target:
                self.torque_nm = self._wanted_nm
