"""The path of a steered jog: several axes at once, each at its own rate."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.control.motion.jog_path import TOOL_DEG_S, TOOL_MM_S, HeldToolPath, MotionFrame, axes_of
from armui.kinematics.axes import LINEAR_AXES
from armui.kinematics.poses import moved

if TYPE_CHECKING:
    from armui.control.motion.jog_pace import Pace
    from armui.kinematics.arm_kinematics import Kinematics


@dataclass(frozen=True, slots=True)
class SteeredJog:
    """The jog that a device with axes asks for now.

    Attributes:
        rates: The share of its highest speed, −1 to 1, for each of J1–J6, or X, Y, Z, RX, RY, RZ.
        frame: The frame of the axes, or ``None`` for the joints.
        device: The name of the device that steers.
    """

    rates: tuple[float, ...]
    frame: MotionFrame | None
    device: str


class SteeredToolPath(HeldToolPath):
    """The path of the tool centre point along and about several axes of a frame at once.

    Distances along the path are in seconds at full speed.

    Args:
        rates: Six, −1 to 1, not all 0. The point is never faster than along one axis alone.
        frame: The frame of the axes; for the others see :class:`HeldToolPath`.
    """

    def __init__(
        self,
        rates: Sequence[float],
        frame: MotionFrame,
        kinematics: Kinematics,
        base_deg: Sequence[float],
        *,
        tool: Sequence[float],
        limits: Sequence[JointLimits],
    ) -> None:
        super().__init__(kinematics, base_deg, tool, limits)
        linear, turning = rates[:LINEAR_AXES], rates[LINEAR_AXES:]
        self._mm_s = tuple(TOOL_MM_S * rate for rate in _within_one(linear))
        self._deg_s = tuple(TOOL_DEG_S * rate for rate in _within_one(turning))
        self._axes = axes_of(frame)

    def speed(self, pace: Pace) -> float:
        """Return the present share of full speed, 0–1."""
        return pace.share

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """Return the solution nearest to ``near_deg``, or why there is none."""
        way_mm = [gone * each for each in self._mm_s]
        turn_deg = [gone * each for each in self._deg_s]
        return self._joints_of(moved(self._start, way_mm, turn_deg, self._axes), near_deg)


def _within_one(rates: Sequence[float]) -> tuple[float, ...]:
    """Return the same direction, no longer than 1."""
    length = sum(rate * rate for rate in rates) ** 0.5
    return tuple(rate / max(1.0, length) for rate in rates)
