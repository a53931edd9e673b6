"""Times of a log that run backwards are put right."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from armui.session.frames import LATEST_S

if TYPE_CHECKING:
    from numpy.typing import NDArray

_CLOCK_SET_S: Final = 1.0
"""A step back by more shows that the recorder's clock was set back; a smaller one, that frames were
not written in the order in which they came."""


def straightened(
    times_s: NDArray[np.float64], channels: NDArray[np.uint8]
) -> tuple[NDArray[np.float64], int]:
    """Times that may be sorted: no clock was set back, and no single one lies in the future.

    Where a clock was set back, time goes on as if it had stood still at that moment, to the end of
    the calendar at most. Each channel is looked at by itself: they may have been written one after
    another.

    Args:
        times_s: As recorded, finite.
        channels: The channel of each frame.

    Returns:
        The times, in seconds, and how many frames had a time before that of the frame in front of
        them on their channel.
    """
    backwards = 0
    result = times_s
    for channel in np.unique(channels).tolist():
        rows = np.flatnonzero(channels == channel)
        own = times_s[rows]
        steps = np.diff(own)
        count = int((steps < 0).sum())
        if count == 0:
            continue
        backwards += count
        if result is times_s:
            result = times_s.copy()
        result[rows] = _continued(_without_strays(own, steps))
    return result, backwards


def _without_strays(own: NDArray[np.float64], steps: NDArray[np.float64]) -> NDArray[np.float64]:
    """A single time far off both its neighbours becomes that of the frame before it."""
    ahead = (steps[:-1] > _CLOCK_SET_S) & (steps[1:] < -_CLOCK_SET_S)
    behind = (steps[:-1] < -_CLOCK_SET_S) & (steps[1:] > _CLOCK_SET_S)
    places = np.flatnonzero((ahead | behind) & (own[2:] >= own[:-2])) + 1
    own[places] = own[places - 1]
    if own.size > 1 and own[0] > own[1] + _CLOCK_SET_S and np.all(own[1:] < own[0]):
        own[0] = own[1]
    return own


def _continued(own: NDArray[np.float64]) -> NDArray[np.float64]:
    """Where the clock was set back, what follows is moved up to the time of that moment."""
    steps = np.diff(own)
    moved = np.where(steps < -_CLOCK_SET_S, -steps, 0.0)
    if moved.any():
        own[1:] = np.minimum(own[1:] + np.cumsum(moved), LATEST_S)
    return own
