"""How high a plot must reach for its curves, without its axis dancing: pure."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

Extent = tuple[float, float]

_MARGIN: Final = 0.16
"""Of the height, above and below: half a figure of the axis, in the lowest plot there is."""
_LEAST: Final = {"°C": 4.0, "V": 1.0, "A": 0.2, "%": 5.0, "1/s": 10.0}
_LEAST_ELSE: Final = 0.1
"""The smallest height, by unit: noise of the last digit is not to fill a plot."""
_LEAST_SHARE: Final = 1e-5
"""And as a share of the figures themselves."""
_TOO_EMPTY: Final = 0.45
"""A plot of which less is used is fitted anew."""


def together(extents: Iterable[Extent | None]) -> Extent | None:
    """The extent of several curves."""
    told = [each for each in extents if each is not None]
    return (min(low for low, _ in told), max(high for _, high in told)) if told else None


class AutoHeight:
    """Grows at once, and shrinks when more than half of it stays empty.

    Args:
        unit: Of the curves, where they have one in common.
    """

    def __init__(self, unit: str = "") -> None:
        self._least = _LEAST.get(unit, _LEAST_ELSE)
        self._shown: Extent | None = None

    def fit(self, extent: Extent | None, *, codes: bool = False) -> Extent:
        """What to show; codes begin at zero."""
        if extent is None:
            return self._shown or (0.0, 1.0)
        low, high = (min(extent[0], 0.0), max(extent[1], 1.0)) if codes else extent
        least = max(self._least, _LEAST_SHARE * max(abs(low), abs(high)))
        if high - low < least:
            middle = (low + high) / 2
            low, high = middle - least / 2, middle + least / 2
        shown = self._shown
        if shown is not None and shown[0] <= low and high <= shown[1]:
            used = (high - low) / (shown[1] - shown[0])
            if used >= _TOO_EMPTY:
                return shown
        margin = _MARGIN * (high - low)
        self._shown = (low - margin, high + margin)
        return self._shown
