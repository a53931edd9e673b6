"""Evaluates a joint's swing: how far it lags, the current it needs, its temperatures.

It swings evenly to and fro. The part of a figure that changes sign with the direction belongs to
the joint: its lag, and the current against friction. The part that is the same both ways is
gravity. So half of the difference between both ways is compared, and half of the sum is only shown.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.arm.inspection_record import JointFigures

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.telemetry.store import Telemetry

    Curve = tuple[NDArray[np.float64], NDArray[np.float64]]

_EVEN: Final = 0.8
"""A joint turns evenly where its setpoint has this share of the full speed at least."""
_SETTLES_S: Final = 0.25
"""The setpoint must have turned evenly for this long before, as the joint lags behind it."""
_LEAST: Final = 10
"""Fewer samples to either side are no measurement."""
_LEAST_DEG: Final = 1.0
"""A joint that passed fewer degrees both ways did not swing."""
CURVES: Final = ("target", "angle", "current")


def curves_of(telemetry: Telemetry, joint: int, begin_s: float, end_s: float) -> dict[str, Curve]:
    """Return the commanded and measured curves of a joint (1–6) in a time span."""
    keys = {
        "target": f"own.joint_angle.{joint}",
        "angle": f"arm.joint_angle.{joint}",
        "current": f"arm.motor_current.{joint}",
        "motor": f"arm.motor_temperature.{joint}",
        "driver": f"arm.driver_temperature.{joint}",
    }
    found: dict[str, Curve] = {}
    for name, key in keys.items():
        quantity, series = telemetry.find(key)
        samples: NDArray[Any] = series.samples(begin_s, end_s)
        values = samples[quantity.field].astype(float)
        known = np.isfinite(values)
        found[name] = samples["time_s"][known], values[known]
    return found


def figures_of(
    curves: Mapping[str, Curve], speed_deg_s: float, *, signed: bool
) -> JointFigures | None:
    """Return the figures of a swing; ``None`` if too little of it was heard or commanded.

    Args:
        curves: As `curves_of` has them.
        speed_deg_s: The speed that it swings at.
        signed: False of an arm that tells no sign of its currents (generation 1).
    """
    times_s, targets_deg = curves["target"]
    if len(times_s) < _LEAST:
        return None
    heard_s, angles_deg = curves["angle"]
    errors = np.interp(heard_s, times_s, targets_deg) - angles_deg
    behind = _to_and_fro(curves["target"], curves["angle"], (heard_s, errors), speed_deg_s)
    current = _to_and_fro(curves["target"], curves["angle"], curves["current"], speed_deg_s)
    if behind is None or current is None:
        return None
    return JointFigures(
        behind_deg=behind[0],
        current_a=current[0] if signed else None,
        bears_a=current[1],
        motor_c=float(curves["motor"][1].max(initial=-np.inf)) if len(curves["motor"][1]) else None,
        driver_c=float(curves["driver"][1].max()) if len(curves["driver"][1]) else None,
    )


def _to_and_fro(
    targets: Curve, angles: Curve, curve: Curve, speed_deg_s: float
) -> tuple[float, float] | None:
    """Return half the difference and half the sum of a curve's means to and fro.

    The means are taken over the angles that were passed both ways, so that gravity is the same in
    them.
    """
    at_s, values = curve
    if not len(at_s):
        return None
    here_deg = np.interp(at_s, *angles)
    now, before, after = (
        np.interp(at_s + shift_s, *targets) for shift_s in (0.0, -_SETTLES_S, 0.05)
    )
    least = _EVEN * speed_deg_s
    of_late = (now - before) / _SETTLES_S
    goes_on = (after - now) / 0.05
    ways = []
    for sign in (1.0, -1.0):
        even = (sign * of_late >= least) & (sign * goes_on >= least)
        ways.append((here_deg[even], values[even]))
    if min(len(each[0]) for each in ways) < _LEAST:
        return None
    low = max(float(place.min()) for place, _ in ways)
    high = min(float(place.max()) for place, _ in ways)
    if high - low < _LEAST_DEG:
        return None
    means = []
    for place, value in ways:
        common = (place >= low) & (place <= high)
        if common.sum() < _LEAST:
            return None
        means.append(float(value[common].mean()))
    return (means[0] - means[1]) / 2.0, (means[0] + means[1]) / 2.0
