"""Measures jumps of a reported angle that no motion explains, as when a reference is found anew."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

_FASTEST_DEG_S: Final = 400.0
"""No joint turns faster, not even one that drops."""
_LONGEST_S: Final = 0.06
"""After a longer silence a change of angle may be a fall, and is no evidence of a jump."""
_PERIOD_S: Final = 0.005
"""Angles are reported 200 times a second."""
_LEAST: Final = 3
_WORTH_DEG: Final = 0.3
"""Smaller jumps are noise where a fall begins or ends: only the largest of them is returned."""


def jump_deg(
    times_s: NDArray[np.float64], angles_deg: NDArray[np.floating], from_s: float
) -> float | None:
    """Return by how much an angle jumped after a moment; ``None`` if too little was heard.

    A joint that drops turns fast, but no step of its feedback differs much from both its
    neighbours. A step that does is a jump.

    Args:
        times_s: When each angle was heard, from shortly before that moment on.
        angles_deg: The angles.
        from_s: The moment.
    """
    after = int(np.searchsorted(times_s, from_s, side="right"))
    if after < _LEAST or len(times_s) - after < _LEAST:
        return None
    gaps_s = np.diff(times_s)
    if gaps_s.max() > _LONGEST_S:
        return None
    steps_deg = np.diff(angles_deg.astype(float))
    # Both measures are taken: frames in a burst have useless times, lost frames make wide steps.
    spans_s = np.maximum(gaps_s, _PERIOD_S)
    by_time = _unusual(steps_deg / spans_s) * spans_s[1:-1]
    least = _nearer_0(_unusual(steps_deg), by_time)
    fastest_deg = _FASTEST_DEG_S * spans_s
    too_far = (steps_deg - np.clip(steps_deg, -fastest_deg, fastest_deg))[1:-1]
    jumps = np.where(np.abs(too_far) > np.abs(least), too_far, least)[after - 2 :]
    worth = jumps[np.abs(jumps) >= _WORTH_DEG]
    total = worth.sum() if len(worth) else jumps[np.abs(jumps).argmax()]
    return round(float(total), 2)


def _unusual(steps: Array) -> Array:
    """Return (n - 2,) by how much each step differs from both neighbours and their mean."""
    here, before, behind = steps[1:-1], steps[:-2], steps[2:]
    least = _nearer_0(here - before, here - behind)
    return _nearer_0(least, here - (before + behind) / 2.0)


def _nearer_0(one: Array, other: Array) -> Array:
    nearer: Array = np.where(np.abs(one) <= np.abs(other), one, other)
    return nearer
