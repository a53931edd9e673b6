"""By how much a reported angle jumped, as no joint can move: its reference was found anew."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

_FASTEST_DEG_S: Final = 400.0
"""No joint turns faster, not even one that drops."""
_LONGEST_S: Final = 0.06
"""What came in a longer silence may be a fall: it tells nothing of a jump."""
_LEAST: Final = 3
_WORTH_DEG: Final = 0.3
"""Lesser jumps are the noise of a fall that begins or ends; only the largest is told of them."""


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
    speeds = steps_deg / np.maximum(gaps_s, 1e-4)
    before, behind = speeds[:-2], speeds[2:]
    usual = np.stack((before, behind, (before + behind) / 2.0))
    off = steps_deg[1:-1] - usual * gaps_s[1:-1]
    least = off[np.abs(off).argmin(axis=0), np.arange(off.shape[1])]
    fastest_deg = _FASTEST_DEG_S * gaps_s[1:-1]
    too_far = steps_deg[1:-1] - np.clip(steps_deg[1:-1], -fastest_deg, fastest_deg)
    jumps = np.where(np.abs(too_far) > np.abs(least), too_far, least)[after - 2 :]
    worth = jumps[np.abs(jumps) >= _WORTH_DEG]
    total = worth.sum() if len(worth) else jumps[np.abs(jumps).argmax()]
    return round(float(total), 2)
