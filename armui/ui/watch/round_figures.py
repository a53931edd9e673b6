"""Round figures for an axis: pure."""

from __future__ import annotations

import math


def round_step(low: float, high: float, most: int) -> float:
    """Return the step of round figures of which at most `most` fit; 0 for none."""
    span = high - low
    if not (math.isfinite(span) and span > 0.0 and most > 0):
        return 0.0
    decade: float = 10.0 ** math.floor(math.log10(span / most))
    return next(decade * each for each in (1, 2, 5, 10) if decade * each * most >= span)


def ticks(low: float, high: float, most: int) -> list[float]:
    """Return round figures between two others, at most `most`."""
    step = round_step(low, high, most)
    if step == 0.0:
        return []
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [number * step for number in range(first, last + 1)]
