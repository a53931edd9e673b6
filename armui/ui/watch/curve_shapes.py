"""Computes lines from series, with no more points than a screen can show. Pure.

A line is a pair of arrays: monotonic times in seconds, and figures. A gap of half a second splits a
line.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from armui.arm.state import FRESH_FOR_S

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.telemetry.series import Envelope, Series


Line = tuple["NDArray[np.float64]", "NDArray[np.float64]"]

_SAMPLES_PER_PX: Final = 1.5
"""Up to this density every sample is drawn; above it only the extremes."""
_BUCKETS_PER_PX: Final = 0.75
Extent = tuple[float, float]

_MARGIN: Final = 0.16
"""The share of the height left free above and below: half a figure of the axis, in the lowest plot.
"""
_LEAST: Final = {"°C": 4.0, "V": 1.0, "A": 0.2, "%": 5.0, "1/s": 10.0}
_LEAST_ELSE: Final = 0.1
"""The smallest height for other units, so that noise of the last digit does not fill a plot."""
_LEAST_SHARE: Final = 1e-5
"""The smallest height as a share of the figures themselves."""
_TOO_EMPTY: Final = 0.45
"""A plot that is used less than this is fitted again."""


def together(extents: Iterable[Extent | None]) -> Extent | None:
    """Return the common extent of several curves."""
    told = [each for each in extents if each is not None]
    return (min(low for low, _ in told), max(high for _, high in told)) if told else None


class AutoHeight:
    """The height of a plot: grows at once, and shrinks when more than half of it stays empty.

    Args:
        unit: The common unit of the curves, if they have one.
    """

    def __init__(self, unit: str = "") -> None:
        self._least = _LEAST.get(unit, _LEAST_ELSE)
        self._shown: Extent | None = None

    def fit(self, extent: Extent | None, *, codes: bool = False) -> Extent:
        """Return the extent to show; codes begin at zero."""
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


def bucket_exponent(span_s: float, width_px: int) -> int:
    """Return the exponent of 2 at which buckets are hardly wider than a pixel."""
    return math.ceil(math.log2(span_s / (_BUCKETS_PER_PX * max(width_px, 50))))


def is_dense(series: Series, begin_s: float, end_s: float, width_px: int) -> bool:
    """Return whether there are too many samples to draw each of them."""
    return series.count_between(begin_s, end_s) > _SAMPLES_PER_PX * max(width_px, 50)


def sample_lines(
    series: Series, fields: Sequence[str], begin_s: float, end_s: float
) -> list[list[Line]]:
    """Return every sample from one time to another, for each field."""
    samples = series.samples(begin_s, end_s, around=True)
    times_s = samples["time_s"].astype(np.float64)
    if series.shape.held:
        return [_steps(times_s, samples[field].astype(np.float64), end_s) for field in fields]
    breaks = np.flatnonzero(np.diff(times_s) > FRESH_FOR_S) + 1
    return [_pieces(times_s, samples[field].astype(np.float64), breaks) for field in fields]


def envelope_lines(envelope: Envelope, *, held: bool = False) -> list[list[Line]]:
    """Return the extremes of buckets, for each field, as a line that goes up and down."""
    width_s = 2.0**envelope.exponent
    lines: list[list[Line]] = []
    for low, high in zip(envelope.low, envelope.high, strict=True):
        places = np.flatnonzero(~np.isnan(low))
        if not places.size:
            lines.append([])
            continue
        silent = np.diff(places) - 1
        far = (silent > 0) & (held | (silent * width_s >= FRESH_FOR_S))
        numbers = places + envelope.begin
        times_s = np.repeat((numbers + 0.5) * width_s, 2)
        figures = np.empty(times_s.size)
        # the bucket's number says which extreme comes first: else curves would flicker on scrolling
        downwards = (numbers & 1).astype(bool)
        figures[0::2] = np.where(downwards, high[places], low[places])
        figures[1::2] = np.where(downwards, low[places], high[places])
        alone = _alone(far)
        times_s[0::2][alone] -= width_s / 2
        times_s[1::2][alone] += width_s / 2
        breaks = 2 * (np.flatnonzero(far) + 1)
        lines.append(_split(times_s, figures, breaks))
    return lines


def extent(lines: Sequence[Line]) -> tuple[float, float] | None:
    """Return the smallest and the largest figure, or ``None``."""
    ends = [(float(figures.min()), float(figures.max())) for _times, figures in lines]
    return (min(low for low, _ in ends), max(high for _, high in ends)) if ends else None


def _pieces(
    times_s: NDArray[np.float64], figures: NDArray[np.float64], breaks: NDArray[np.intp]
) -> list[Line]:
    told = ~np.isnan(figures)
    if not told.all():
        numbers = np.cumsum(np.isin(np.arange(times_s.size), breaks))
        times_s, figures, numbers = times_s[told], figures[told], numbers[told]
        breaks = np.flatnonzero((np.diff(numbers) > 0) | (np.diff(times_s) > FRESH_FOR_S)) + 1
    return _split(times_s, figures, breaks)


def _split(
    times_s: NDArray[np.float64], figures: NDArray[np.float64], breaks: NDArray[Any]
) -> list[Line]:
    if not times_s.size:
        return []
    if not breaks.size:
        return [(times_s, figures)]
    return list(zip(np.split(times_s, breaks), np.split(figures, breaks), strict=True))


def _alone(far: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which buckets have no neighbour on either side."""
    left = np.concatenate(([True], far))
    right = np.concatenate((far, [True]))
    return left & right


def _steps(times_s: NDArray[np.float64], figures: NDArray[np.float64], end_s: float) -> list[Line]:
    """Return lines that hold each figure until the next sample; NaN ends a line."""
    if not times_s.size:
        return []
    until_s = np.append(times_s[1:], max(end_s, float(times_s[-1])))
    stepped_s = np.column_stack((times_s, until_s)).ravel()
    stepped = np.repeat(figures, 2)
    told = ~np.isnan(stepped)
    ends = np.flatnonzero(np.diff(told.astype(np.int8))) + 1
    pieces = _split(stepped_s, stepped, ends)
    return [piece for piece in pieces if not np.isnan(piece[1][0])]
