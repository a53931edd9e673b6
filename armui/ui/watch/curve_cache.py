"""Keeps the lines of one series' curves between pictures, so that only new ends are drawn."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Final, Generic, TypeVar

from armui.arm.state import FRESH_FOR_S
from armui.ui.watch.curve_shapes import (
    Line,
    bucket_exponent,
    envelope_lines,
    extent,
    is_dense,
    sample_lines,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from armui.telemetry.quantities import Quantity
    from armui.telemetry.series import Series
    from armui.telemetry.store import Telemetry


Drawn = TypeVar("Drawn")

_LONGEST_TAIL: Final = 96
"""The most buckets computed again for each picture."""

_BEHIND_PX: Final = 4.0
_BEHIND_S: Final = 0.3
"""The most that the newest end may be late: each picture updates half of the curves."""

Extent = tuple[float, float] | None


class CurveCache(Generic[Drawn]):
    """The lines of one series in one plot.

    Args:
        series: The series.
        fields: The figures or codes drawn; all of one kind.
        make: Makes the drawable object from the times and figures of a line.

    Attributes:
        drawn: For each field its drawable pieces, in any order.
        extents: For each field its smallest and largest figure; ``None`` if there is none.
    """

    def __init__(
        self,
        series: Series,
        fields: Sequence[str],
        make: Callable[[NDArray[np.float64], NDArray[np.float64]], Drawn],
    ) -> None:
        self.series = series
        self.fields = tuple(fields)
        self._make = make
        self._scale = (0.0, 0)
        self._begin_s = self._end_s = 0.0
        self._exponent = self._replaced = self._samples = 0
        self._body_begin = self._body_end = 0
        self._body: list[list[Drawn]] = []
        self._body_extents: list[Extent] = []
        self.drawn: list[list[Drawn]] = [[] for _ in fields]
        self.extents: list[Extent] = [None] * len(self.fields)

    def update(self, begin_s: float, end_s: float, width_px: int, *, turn: bool = True) -> None:
        """Compute the lines of a stretch of time, which must not end in the future.

        Args:
            begin_s: Monotonic time at the left end.
            end_s: And at the right.
            width_px: How many pixels they are apart.
            turn: If false, the present lines stay while only some pixels are missing.
        """
        px_s = (end_s - begin_s) / max(width_px, 1)
        same = (px_s, width_px) == self._scale and begin_s >= self._begin_s
        if self._replaced != self.series.replaced:
            self._replaced, same, self._body = self.series.replaced, False, []
        behind_s = end_s - self._end_s
        samples = self.series.count_between(begin_s, end_s)
        if same and behind_s == 0.0 and samples != self._samples:
            same, self._body = False, []  # earlier samples of a standing log were loaded
        self._samples = samples
        if same and 0.0 <= behind_s < _BEHIND_PX * px_s and behind_s < _BEHIND_S and not turn:
            return
        if same and 0.0 <= behind_s < px_s and behind_s < _BEHIND_S:
            return
        if not same:
            self._begin_s = begin_s
        self._scale, self._end_s = (px_s, width_px), end_s
        if not is_dense(self.series, begin_s, end_s, width_px):
            self._body = []
            self._show(sample_lines(self.series, self.fields, begin_s, end_s))
            return
        exponent = bucket_exponent(end_s - begin_s, width_px)
        width_s = 2.0**exponent
        begin, end = math.floor(begin_s / width_s), math.floor(end_s / width_s) + 1
        slack = max(8, (end - begin) // 4)
        fits = (
            self._body
            and exponent == self._exponent
            and begin - slack <= self._body_begin <= begin
            and self._body_end < end
            and end - self._body_end <= _LONGEST_TAIL
        )
        if not fits:
            self._make_body(exponent, begin, end - 2)
        # so far back that a pause shorter than half a second is bridged
        bridge = math.ceil(FRESH_FOR_S / width_s) + 1
        tail_begin = max(self._body_end - bridge, begin)
        envelope = self.series.envelope(exponent, tail_begin, end, self.fields)
        self._show(envelope_lines(envelope, held=self.series.shape.held))

    def _make_body(self, exponent: int, begin: int, end: int) -> None:
        """Compute everything but the newest end, which changes with each sample."""
        envelope = self.series.envelope(exponent, begin, end, self.fields)
        lines = envelope_lines(envelope, held=self.series.shape.held)
        self._exponent, self._body_begin, self._body_end = exponent, begin, end
        self._body = [self._pieces(each) for each in lines]
        self._body_extents = [extent(each) for each in lines]

    def _show(self, tails: list[list[Line]]) -> None:
        bodies = self._body or [[] for _ in self.fields]
        extents = self._body_extents if self._body else [None] * len(self.fields)
        self.drawn = [
            [*body, *self._pieces(tail)] for body, tail in zip(bodies, tails, strict=True)
        ]
        self.extents = [
            _both(before, extent(tail)) for before, tail in zip(extents, tails, strict=True)
        ]

    def _pieces(self, lines: list[Line]) -> list[Drawn]:
        return [self._make(times_s, figures) for times_s, figures in lines]


def _both(one: Extent, other: Extent) -> Extent:
    if one is None or other is None:
        return one or other
    return min(one[0], other[0]), max(one[1], other[1])


class CurveBook(Generic[Drawn]):
    """A cache for each series that is shown.

    Args:
        telemetry: The series.
        make: Makes the drawable object from the times and figures of a line.
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
        """Set the quantities shown; caches of unchanged series are kept."""
        fields: dict[tuple[str, bool], dict[str, None]] = {}
        for each in quantities:
            fields.setdefault(self._place(each), {})[each.field] = None
        self._caches = {place: self._kept(place, tuple(names)) for place, names in fields.items()}

    def begin_picture(self) -> None:
        """Begin a picture, for which half of the caches are updated in turn."""
        self._picture += 1

    def curve(
        self, what: Quantity, begin_s: float, end_s: float, width_px: int
    ) -> tuple[Sequence[Drawn], Extent]:
        """Return the drawable pieces of a quantity, and its extent.

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
