"""How far a moving arm goes on before it could follow another target: pure."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from armui.control.safety.standstill import STILL_DEG_S

if TYPE_CHECKING:
    from armui.arm.state import ArmState

FLUENT_DEG: Final = 1.0
"""A joint that goes astray by no more than this on its way to another target need not brake
first."""
_DELAY_S: Final = 0.02
"""A target takes effect this long after it was sent, at the latest."""


def braking_deg(
    state: ArmState, accelerations_deg_s2: Sequence[float], now_s: float
) -> tuple[float, ...] | None:
    """Return how far each joint goes on from where it was measured if it brakes, with its sign.

    Args:
        state: The arm as heard.
        accelerations_deg_s2: With which the joints brake.
        now_s: Monotonic time.

    Returns:
        Degrees; all 0 for an arm that stands still; ``None`` where a joint's place or speed is not
        known.
    """
    found = []
    for heard, driver, acceleration in zip(
        state.joints_deg, state.drivers_fast, accelerations_deg_s2, strict=True
    ):
        if heard is None or driver is None or not driver.fresh(now_s):
            return None
        speed = driver.value.speed_deg_s
        if abs(speed) < STILL_DEG_S:
            found.append(0.0)
            continue
        late_s = max(0.0, now_s - min(heard.at_s, driver.at_s)) + _DELAY_S
        fastest = abs(speed) + acceleration * late_s
        way = abs(speed) * late_s + fastest**2 / (2.0 * max(acceleration, 1e-3))
        found.append(math.copysign(way, speed))
    return tuple(found)


def astray_deg(braking: Sequence[float], way_deg: Sequence[float]) -> tuple[float, ...]:
    """Return how far off a straight way each joint comes by what it goes on.

    Args:
        braking: What each joint goes on; see :func:`braking_deg`.
        way_deg: How far each joint is to turn, from where it was measured.
    """
    length = sum(each * each for each in way_deg)
    along = sum(a * b for a, b in zip(braking, way_deg, strict=True))
    share = min(max(along / length, 0.0), 1.0) if length else 0.0
    return tuple(abs(a - share * b) for a, b in zip(braking, way_deg, strict=True))
