"""Searches marks of a log, and places them, at most one for each pixel and kind: pure."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.session.session import MarkKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from armui.session.frames import Channel
    from armui.session.session import SessionMark


TROUBLE: Final = frozenset({MarkKind.FAULT, MarkKind.STOP})
"""The kinds of marks for «next fault»."""
_LASTING: Final = TROUBLE | {MarkKind.EPISODE, MarkKind.DISCARDED}
_HERE_S: Final = 1e-4
"""A mark this near to the present time is the one the operator has gone to."""


class MarkSearch:
    """Marks in the order of time.

    Args:
        marks: The marks of a log.
        channel: The channel; marks of others are left out, those without a channel belong to all.
    """

    def __init__(self, marks: Sequence[SessionMark], channel: Channel) -> None:
        own = [each for each in marks if each.entry.get("channel", channel) == channel]
        self.marks = tuple(sorted(own, key=lambda each: each.at_s))
        self._trouble = [each for each in self.marks if each.kind in TROUBLE]
        self._times_s = [each.at_s for each in self._trouble]

    def next_trouble(self, at_s: float) -> SessionMark | None:
        """Return the first fault or stop after a time, or ``None``."""
        place = bisect_right(self._times_s, at_s + _HERE_S)
        return self._trouble[place] if place < len(self._trouble) else None

    def trouble_before(self, at_s: float) -> SessionMark | None:
        """Return the last fault or stop before a time, or ``None``."""
        place = bisect_left(self._times_s, at_s - _HERE_S)
        return self._trouble[place - 1] if place else None


def end_of(mark: SessionMark, log_end_s: float) -> float | None:
    """Return the log time of the end of a lasting mark; ``None`` for a moment.

    Args:
        mark: The mark.
        log_end_s: The end of the log, where marks without an end stop.
    """
    if mark.kind not in _LASTING or "ended_s" not in mark.entry:
        return None
    ended_s = mark.entry["ended_s"]
    if ended_s is None:
        return log_end_s
    # an end before the beginning was taken from another clock
    return float(ended_s) if isinstance(ended_s, int | float) and ended_s >= mark.at_s else None


class MarkPlaces:
    """The marks as arrays: thousands are placed in a millisecond.

    Args:
        marks: The marks of a log.
        log_end_s: The end of the log, where marks without an end stop.
    """

    def __init__(self, marks: Sequence[SessionMark], log_end_s: float) -> None:
        self._times_s = {
            kind: np.array(
                [
                    (each.at_s, end_of(each, log_end_s) or each.at_s)
                    for each in marks
                    if each.kind is kind
                ]
            ).reshape(-1, 2)
            for kind in MarkKind
        }

    def within(
        self, kind: MarkKind, from_s: float, to_s: float, width_px: float
    ) -> NDArray[np.float64]:
        """Return the places of the marks of one kind.

        Args:
            kind: The kind.
            from_s: Log time at the left end.
            to_s: At the right end, later than that.
            width_px: The width between the ends.

        Returns:
            Beginnings and ends in pixels from the left end, N×2, none beyond the ends. Of several
            marks within the same pixel only the first is included.
        """
        times_s = self._times_s[kind]
        seen_s = times_s[(times_s[:, 1] >= from_s) & (times_s[:, 0] <= to_s)]
        places = np.clip((seen_s - from_s) * (width_px / (to_s - from_s)), 0.0, width_px)
        pixels = np.rint(places[:, 0])
        _pixels, first = np.unique(pixels, return_index=True)
        kept = places[:, 1] - places[:, 0] >= 1.0
        kept[first] = True
        return places[kept]
