"""Where a steered jog leads: several axes at once, each as fast as its rate says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.control.motion.jog_path import TOOL_DEG_S, TOOL_MM_S, HeldToolPath
from armui.kinematics.axes import LINEAR_AXES, JogFrame
from armui.kinematics.poses import moved

if TYPE_CHECKING:
    from armui.control.motion.jog_pace import Pace
    from armui.kinematics.arm_kinematics import Kinematics


@dataclass(frozen=True, slots=True)
class SteeredJog:
    """What a device with axes asks for now.

    Attributes:
        rates: Of J1–J6, or X, Y, Z, RX, RY, RZ, the share of its highest speed, −1 to 1.
        frame: Whose axes; None: the joints.
        device: The name of the device that steers.
    """

    rates: tuple[float, ...]
    frame: JogFrame | None
    device: str


class SteeredToolPath(HeldToolPath):
    """The tool centre point goes along and turns about the axes of a frame at once.

    The way is told in seconds at full speed.

    Args:
        rates: Six, −1 to 1, not all 0. The point is never faster than along one axis alone.
        frame: Whose axes; for the others see :class:`HeldToolPath`.
    """

    def __init__(
        self,
        rates: Sequence[float],
        frame: JogFrame,
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
        self._frame = frame

    def speed(self, pace: Pace) -> float:
        """Return the present share of full speed."""
        return pace.share

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """Return the solution nearest to ``near_deg``, or why there is none."""
        way_mm = [gone * each for each in self._mm_s]
        turn_deg = [gone * each for each in self._deg_s]
        return self._joints_of(moved(self._start, way_mm, turn_deg, self._frame), near_deg)


def _within_one(rates: Sequence[float]) -> tuple[float, ...]:
    """Return the same direction, no longer than 1."""
    length = sum(rate * rate for rate in rates) ** 0.5
    return tuple(rate / max(1.0, length) for rate in rates)
