"""Where a steered jog leads: several axes at once, each as fast as its rate says."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JointLimits
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.motion.jog_path import TOOL_DEG_S, TOOL_MM_S, HeldToolPath
from armui.kinematics.axes import LINEAR_AXES, JogFrame

if TYPE_CHECKING:
    from armui.control.motion.jog_pace import Pace
    from armui.kinematics.arm_kinematics import Kinematics

_NOWHERE_DEG: Final = float("inf")


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


class SteeredJointPath:
    """The joints turn together, each at its rate, until one is at its limit.

    Args:
        rates: Six, −1 to 1, not all 0.
        base_deg: Six angles to begin with.
        limits: Of the six joints.
    """

    def __init__(
        self, rates: Sequence[float], base_deg: Sequence[float], limits: Sequence[JointLimits]
    ) -> None:
        self._base_deg = tuple(base_deg)
        self._limits = tuple(limits)
        self._most = max(map(abs, rates))
        self._ways = tuple(rate / self._most for rate in rates)

    def speed(self, pace: Pace) -> float:
        """That of the joint with the highest rate; the others keep their share of it."""
        speeds = zip(pace.speeds_deg_s, self._ways, strict=True)
        return self._most * min(speed for speed, way in speeds if way)

    def room(self) -> float:
        """To the first limit."""
        return min(self._room_of(place) for place in range(len(self._ways)))

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...]:  # noqa: ARG002 - one way only
        """The joints turned so far."""
        return tuple(
            base + way * gone for base, way in zip(self._base_deg, self._ways, strict=True)
        )

    def end(self) -> Refusal:
        """The limit that is nearest."""
        place = min(range(len(self._ways)), key=self._room_of)
        return Refusal(
            RefusalCode.JOG_AT_LIMIT, {"joint": place + 1, "limit": self._bound_deg(place)}
        )

    def _room_of(self, place: int) -> float:
        way = self._ways[place]
        if not way:
            return _NOWHERE_DEG
        return (self._bound_deg(place) - self._base_deg[place]) / way

    def _bound_deg(self, place: int) -> float:
        bounds = self._limits[place]
        return bounds.max_deg if self._ways[place] > 0 else bounds.min_deg


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
        """The present share of full speed."""
        return pace.share

    def joints_at(self, gone: float, near_deg: Sequence[float]) -> tuple[float, ...] | Refusal:
        """The solution nearest to ``near_deg``, or why there is none."""
        from armui.kinematics.poses import moved  # noqa: PLC0415 - numpy, loaded when asked for

        way_mm = [gone * each for each in self._mm_s]
        turn_deg = [gone * each for each in self._deg_s]
        return self._joints_of(moved(self._start, way_mm, turn_deg, self._frame), near_deg)


def _within_one(rates: Sequence[float]) -> tuple[float, ...]:
    """The same direction, no longer than 1."""
    length = sum(rate * rate for rate in rates) ** 0.5
    return tuple(rate / max(1.0, length) for rate in rates)
