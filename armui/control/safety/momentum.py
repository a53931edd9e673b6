"""The way of a moving arm to another target: straight, or astray while it brakes first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.control.safety.standstill import STILL_DEG_S

if TYPE_CHECKING:
    from armui.arm.limits import JointLimits
    from armui.arm.state import ArmState

FLUENT_DEG: Final = 1.0
"""A joint that goes astray by no more than this on its way to another target need not brake
first."""
_DELAY_S: Final = 0.02
"""A target takes effect this long after it was sent, at the latest."""


@dataclass(frozen=True, slots=True)
class Momentum:
    """The speeds of the joints, and the accelerations they can brake with.

    Attributes:
        speeds_deg_s: Their speeds; 0 of what stands.
        accelerations_deg_s2: With which they brake.
        late_s: The age of the speeds, plus the time that a target needs to take effect.
    """

    speeds_deg_s: tuple[float, ...]
    accelerations_deg_s2: tuple[float, ...]
    late_s: float

    @property
    def at_rest(self) -> bool:
        """True if no joint moves."""
        return not any(self.speeds_deg_s)

    def stops_at(
        self, measured_deg: Sequence[float], limits: Sequence[JointLimits]
    ) -> tuple[float, ...]:
        """Return about where joints measured at six angles come to rest if they brake.

        That is within their limits, however long an arm says that it brakes; a joint that is
        outside goes no further.
        """
        return tuple(
            min(
                max(
                    angle + speed * self.late_s + speed * abs(speed) / (2.0 * acceleration),
                    min(angle, each.min_deg),
                ),
                max(angle, each.max_deg),
            )
            for angle, speed, acceleration, each in zip(
                measured_deg, self.speeds_deg_s, self.accelerations_deg_s2, limits, strict=True
            )
        )

    def astray_deg(self, way_deg: Sequence[float]) -> tuple[float, ...]:
        """Return how far each joint may come off a straight way by its motion.

        What goes on in the way's direction stays on it, as long as it can brake at its end.

        Args:
            way_deg: How far each joint is to turn from where it was measured.
        """
        if self.at_rest:
            return (0.0,) * len(way_deg)
        length = sum(each * each for each in way_deg)
        along = sum(a * b for a, b in zip(self.speeds_deg_s, way_deg, strict=True))
        rate = max(along / length, 0.0) if length else 0.0
        return tuple(
            self._aside_deg(speed - rate * way, acceleration)
            + self._beyond_deg(rate * abs(way), abs(way), acceleration)
            for speed, way, acceleration in zip(
                self.speeds_deg_s, way_deg, self.accelerations_deg_s2, strict=True
            )
        )

    def _aside_deg(self, speed: float, acceleration: float) -> float:
        """Return how far, in degrees, a joint continues until this speed is braked away."""
        if abs(speed) < STILL_DEG_S:
            return 0.0
        fastest = abs(speed) + acceleration * self.late_s
        return abs(speed) * self.late_s + fastest**2 / (2.0 * acceleration)

    def _beyond_deg(self, speed: float, way: float, acceleration: float) -> float:
        """Return how far a joint overshoots a target that it turns to."""
        return max(0.0, speed * self.late_s + speed**2 / (2.0 * acceleration) - way)


def momentum(
    state: ArmState, accelerations_deg_s2: Sequence[float], now_s: float
) -> Momentum | None:
    """Return how an arm moves; ``None`` where a joint's place or speed is not known.

    Args:
        state: The arm as heard.
        accelerations_deg_s2: With which its joints brake.
        now_s: Monotonic time.
    """
    speeds, late_s = [], 0.0
    for heard, driver in zip(state.joints_deg, state.drivers_fast, strict=True):
        if heard is None or driver is None or not driver.fresh(now_s):
            return None
        speed = driver.value.speed_deg_s
        speeds.append(speed if abs(speed) >= STILL_DEG_S else 0.0)
        late_s = max(late_s, now_s - min(heard.at_s, driver.at_s))
    brakes = tuple(max(each, 1e-3) for each in accelerations_deg_s2)
    return Momentum(tuple(speeds), brakes, late_s + _DELAY_S)
