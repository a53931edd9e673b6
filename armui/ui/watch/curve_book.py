"""The lines of all plots together: a series is read once for a picture, whoever shows it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Generic, TypeVar

from armui.ui.watch.curve_cache import CurveCache, Extent

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from armui.telemetry.quantities import Quantity
    from armui.telemetry.store import Telemetry

Drawn = TypeVar("Drawn")


class CurveBook(Generic[Drawn]):
    """Keeps a cache for each series that is shown.

    Args:
        telemetry: Where they are kept.
        make: Makes what is drawn of the times and figures of a line.
    """

    def __init__(
        self,
        telemetry: Telemetry,
        make: Callable[[NDArray[np.float64], NDArray[np.float64]], Drawn],
    ) -> None:
        self._telemetry = telemetry
        self._make = make
        self._caches: dict[tuple[str, bool], CurveCache[Drawn]] = {}
        self._picture = 0

    def show(self, quantities: Iterable[Quantity]) -> None:
        """What is shown from now on; the caches of series of which it is the same stay."""
        fields: dict[tuple[str, bool], dict[str, None]] = {}
        for each in quantities:
            fields.setdefault(self._place(each), {})[each.field] = None
        self._caches = {place: self._kept(place, tuple(names)) for place, names in fields.items()}

    def begin_picture(self) -> None:
        """Half of the caches are brought up to date for one picture, half for the next."""
        self._picture += 1

    def curve(
        self, what: Quantity, begin_s: float, end_s: float, width_px: int
    ) -> tuple[Sequence[Drawn], Extent]:
        """What is to be drawn of a quantity, and how far it reaches.

        Args:
            what: The quantity; it must be shown.
            begin_s: Monotonic time at the left end.
            end_s: And at the right; not in the future.
            width_px: How many pixels they are apart.
        """
        place = self._place(what)
        cache = self._caches[place]
        number = list(self._caches).index(place)
        cache.update(begin_s, end_s, width_px, turn=(self._picture + number) % 2 == 0)
        row = cache.fields.index(what.field)
        return cache.drawn[row], cache.extents[row]

    def _place(self, what: Quantity) -> tuple[str, bool]:
        return what.series, what.field in self._telemetry.series[what.series].shape.codes

    def _kept(self, place: tuple[str, bool], names: tuple[str, ...]) -> CurveCache[Drawn]:
        kept = self._caches.get(place)
        if kept is not None and kept.fields == names:
            return kept
        return CurveCache(self._telemetry.series[place[0]], names, self._make)
