"""Where the marks of a log stand on its time line, no more than one a pixel of each kind: pure."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from armui.session.session import MarkKind
from armui.ui.watch.replay.mark_search import end_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from armui.session.session import SessionMark


class MarkPlaces:
    """Marks by columns: thousands are laid out in a millisecond.

    Args:
        marks: Of a log.
        log_end_s: When the log ends, and with it what has no other end.
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
        """The places of one kind.

        Args:
            kind: Of which kind.
            from_s: Log time at the left end.
            to_s: At the right end, later than that.
            width_px: From end to end.

        Returns:
            Beginnings and ends in pixels from the left end, N×2, none beyond the ends. Of those
            that begin on one pixel and end on it, too, the first alone.
        """
        times_s = self._times_s[kind]
        seen_s = times_s[(times_s[:, 1] >= from_s) & (times_s[:, 0] <= to_s)]
        places = np.clip((seen_s - from_s) * (width_px / (to_s - from_s)), 0.0, width_px)
        pixels = np.rint(places[:, 0])
        _pixels, first = np.unique(pixels, return_index=True)
        kept = places[:, 1] - places[:, 0] >= 1.0
        kept[first] = True
        return places[kept]
