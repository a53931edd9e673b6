"""From how far an axis is pushed to how fast the arm goes: dead zone, curve, speed; pure."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Final

from armui.gamepad.device_state import DeviceKind, DeviceState
from armui.gamepad.layout import SPEED_AXIS

DEAD_ZONES: Final[Mapping[DeviceKind, float]] = {
    DeviceKind.GAMEPAD: 0.18,
    DeviceKind.SPACE_MOUSE: 0.10,
}
"""Nearer to its centre than this an axis is at rest: worn sticks stay up to 0.15 away from it."""

SLOWEST: Final = 0.02
"""Just outside the dead zone."""

WITHOUT_TRIGGER: Final = 0.2
"""The share of the operator's speed while the trigger of a gamepad is not pulled."""


def shaped(deflection: float, dead_zone: float) -> float:
    """The share of the highest speed, −1 to 1: 0 in the dead zone, then slowly more.

    What is not a number counts as 0: no speed comes of a broken device.
    """
    size = abs(deflection)
    if not math.isfinite(size) or size <= dead_zone:
        return 0.0
    out = min(1.0, (size - dead_zone) / (1.0 - dead_zone))
    return math.copysign(SLOWEST + (1.0 - SLOWEST) * out * out, deflection)


def centred(deflections: Sequence[float], dead_zone: float) -> bool:
    """Whether every axis is at rest; one that is not a number is not."""
    return all(abs(each) <= dead_zone for each in deflections)


def speed_share(state: DeviceState) -> float:
    """What the trigger leaves of the operator's speed; a SpaceMouse has none and leaves all."""
    if state.info.kind is DeviceKind.SPACE_MOUSE:
        return 1.0
    pulled = state.axes.get(SPEED_AXIS, 0.0)
    pulled = min(1.0, max(0.0, pulled)) if math.isfinite(pulled) else 0.0
    return WITHOUT_TRIGGER + (1.0 - WITHOUT_TRIGGER) * pulled


def strongest(rates: Sequence[float]) -> int:
    """The place of the axis that is pushed furthest."""
    return max(range(len(rates)), key=lambda place: abs(rates[place]))
