"""Whether the joints stand still, judged by the angles the arm reports."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

_STILL_DEG: Final = 0.03
_STILL_S: Final = 0.03
"""Together 1 °/s: above the last digit's trembling, far below any motion that matters."""


class RestWatch:
    """Looks at the measured angles again and again."""

    def __init__(self) -> None:
        self._angles_deg: Sequence[float] | None = None
        self._since_s = 0.0

    def observe(self, angles_deg: Sequence[float] | None, now_s: float) -> None:
        """Take in what is measured now; ``None`` while nothing is."""
        last_deg = self._angles_deg
        if angles_deg is None or last_deg is None or _apart(angles_deg, last_deg):
            self._angles_deg, self._since_s = angles_deg, now_s

    def at_rest(self, now_s: float) -> bool:
        """Whether no joint has moved of late."""
        return self._angles_deg is not None and now_s - self._since_s >= _STILL_S

    def forget(self) -> None:
        """Nothing is known any more."""
        self._angles_deg = None


def _apart(angles_deg: Sequence[float], others_deg: Sequence[float]) -> bool:
    return any(abs(a - b) > _STILL_DEG for a, b in zip(angles_deg, others_deg, strict=True))
