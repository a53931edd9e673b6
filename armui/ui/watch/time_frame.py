"""The stretch of time that the plots show, with its history of zooms: pure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Final

from armui.telemetry.series import KEPT_S

SPANS_S: Final = (5.0, 10.0, 30.0, 60.0, 300.0, 1800.0)
"""The spans offered to the operator."""
FIRST_SPAN_S: Final = 30.0

_SHORTEST_S: Final = 0.02
"""The shortest time that can be shown: four samples at 200 Hz."""
_MOST_UNDONE: Final = 100

Range = tuple[float, float]
Axis = tuple[int, str]
"""The axis of one unit in one plot: the index of the plot, and the unit."""


@dataclass(frozen=True, slots=True)
class Shown:
    """The time and the ranges shown.

    Attributes:
        edge_s: The moment that is zero on the time axis; ``None`` for the present.
        begin_s, end_s: The ends of the axis, in seconds from that moment.
        ranges: The zoomed range of figures for an axis.
    """

    edge_s: float | None = None
    begin_s: float = -FIRST_SPAN_S
    end_s: float = 0.0
    ranges: Mapping[Axis, Range] = field(default_factory=dict)

    @property
    def span_s(self) -> float:
        """The length of time shown."""
        return self.end_s - self.begin_s


class TimeFrame:
    """Zoom, pause and undo; every plot shows the same time.

    Times are those of the axis: seconds from the edge, negative before it. While it is live the
    edge is the present, and the curves move along a fixed axis.

    Attributes:
        kept_s: The longest time that can be shown.
    """

    def __init__(self) -> None:
        self.kept_s = KEPT_S
        self._shown = Shown()
        self._before: list[Shown] = []
        self._stepping = False

    @property
    def shown(self) -> Shown:
        """The time and the ranges shown."""
        return self._shown

    @property
    def live(self) -> bool:
        """True if it follows the present."""
        return self._shown.edge_s is None

    @property
    def can_undo(self) -> bool:
        """True if there is a zoom to be undone."""
        return bool(self._before)

    def edge_s(self, now_s: float) -> float:
        """Return the moment that is zero on the axis."""
        return now_s if self._shown.edge_s is None else self._shown.edge_s

    def pause(self, now_s: float) -> None:
        """Stop following the present."""
        if self.live:
            self._shown = replace(self._shown, edge_s=now_s)

    def stand(self, edge_s: float, span_s: float) -> None:
        """Show the time before a fixed moment; the history is cleared."""
        self.kept_s = span_s
        self._shown = Shown(edge_s, -span_s, 0.0)
        self._before.clear()

    def resume(self) -> None:
        """Follow the present again, with the same length of time; the history is cleared."""
        self._shown = Shown(begin_s=-max(self._shown.span_s, SPANS_S[0]))
        self._before.clear()

    def set_span(self, span_s: float) -> None:
        """Set the length of time, keeping its end."""
        span_s = min(max(span_s, _SHORTEST_S), self.kept_s)
        self._go(replace(self._shown, begin_s=self._shown.end_s - span_s))

    def zoom(
        self,
        now_s: float,
        begin_s: float,
        end_s: float,
        axis: Axis = (0, ""),
        heights: Range | None = None,
    ) -> None:
        """Zoom into a part of the time, and of one axis's figures; the curves stand still."""
        begin_s, end_s = min(begin_s, end_s), min(max(begin_s, end_s), 0.0)
        if end_s - begin_s < _SHORTEST_S:
            return
        ranges = dict(self._shown.ranges)
        if heights is not None and heights[0] < heights[1]:
            ranges[axis] = heights
        self._go(Shown(self.edge_s(now_s), begin_s, end_s, ranges))

    def zoom_height(self, axis: Axis, heights: Range | None) -> None:
        """Zoom into a part of the figures of one axis; ``None`` shows all of them."""
        ranges = {key: each for key, each in self._shown.ranges.items() if key != axis}
        if heights is not None and heights[0] < heights[1]:
            ranges[axis] = heights
        self._go(replace(self._shown, ranges=ranges), stepping=True)

    def wheel(self, factor: float, at_s: float) -> None:
        """Lengthen or shorten the time.

        Args:
            factor: The factor on the length.
            at_s: The time that stays in place; while it is live, that is the present.
        """
        shown = self._shown
        shortest_s = SPANS_S[0] if self.live else _SHORTEST_S
        span_s = min(max(shown.span_s * factor, shortest_s), self.kept_s)
        if self.live:
            begin_s, end_s = -span_s, 0.0
        else:
            factor = span_s / shown.span_s
            begin_s = at_s - (at_s - shown.begin_s) * factor
            end_s = min(begin_s + span_s, 0.0)
            begin_s = end_s - span_s
        self._go(replace(shown, begin_s=begin_s, end_s=end_s), stepping=True)

    def pan(self, now_s: float, by_s: float) -> None:
        """Shift the time; stops following the present."""
        shown = self._shown
        end_s = min(max(shown.end_s + by_s, shown.span_s - self.kept_s), 0.0)
        moved = Shown(self.edge_s(now_s), end_s - shown.span_s, end_s, shown.ranges)
        self._go(moved, stepping=True)

    def show_moment(self, now_s: float, at_s: float) -> None:
        """Show a moment, by the samples' clock, in the middle."""
        edge_s = self.edge_s(now_s)
        if not self._shown.begin_s <= at_s - edge_s <= self._shown.end_s:
            span_s = self._shown.span_s
            end_s = min(at_s - edge_s + span_s / 2, 0.0)
            self._go(Shown(edge_s, end_s - span_s, end_s, self._shown.ranges))

    def undo(self) -> None:
        """Undo the last zoom."""
        if self._before:
            self._shown = self._before.pop()
            self._stepping = False

    def forget_plots(self) -> None:
        """Drop the zoomed ranges, because the plots have changed."""
        self._shown = replace(self._shown, ranges={})
        self._before.clear()

    def settle(self) -> None:
        """End a gesture of several steps, so that the next one is undone separately."""
        self._stepping = False

    def _go(self, shown: Shown, *, stepping: bool = False) -> None:
        if shown == self._shown:
            return
        if not (stepping and self._stepping):
            self._before.append(self._shown)
            del self._before[:-_MOST_UNDONE]
        self._stepping = stepping
        self._shown = shown
