"""The axes of a plot: times in steps of a clock, and round figures."""

from __future__ import annotations

from typing import Any, Final

import pyqtgraph as pg

from armui.ui.format import append_unit
from armui.ui.watch.round_figures import round_step

_STEPS_S: Final = (
    *(0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5),
    *(1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0),
)
_TICK_PX: Final = 90.0
_FIGURE_PX: Final = 19.0
_MINUTES_FROM_S: Final = 10.0


def tick_step_s(span_s: float, width_px: float) -> float:
    """How far apart the labels are."""
    wanted_s = span_s * _TICK_PX / max(width_px, _TICK_PX)
    return next((step_s for step_s in _STEPS_S if step_s >= wanted_s), _STEPS_S[-1])


def time_label(time_s: float, step_s: float) -> str:
    """A time on the axis: ``-2.5 s``, ``-12:30``."""
    time_s = round(time_s, 6) + 0.0
    if step_s >= _MINUTES_FROM_S and abs(time_s) >= 60.0:
        minutes, seconds = divmod(round(abs(time_s)), 60)
        return f"{'−' if time_s < 0 else ''}{minutes}:{seconds:02d}"
    decimals = max(0, len(f"{step_s:.3f}".rstrip("0")) - 2) if step_s < 1.0 else 0
    text = f"{abs(time_s):.{decimals}f} s"
    return f"−{text}" if time_s < 0 else text


class TimeAxis(pg.AxisItem):  # type: ignore[misc]
    """Ticks in steps of a clock; their labels stand below all plots."""

    def __init__(self) -> None:
        super().__init__("bottom", maxTickLength=-4, showValues=False)
        self.enableAutoSIPrefix(False)

    def tickSpacing(self, *span_and_length: float) -> list[tuple[float, float]]:  # noqa: N802
        """One kind of tick: of the smallest and the largest time, and the length in pixels."""
        first_s, last_s, length_px = span_and_length
        return [(tick_step_s(last_s - first_s, length_px), 0.0)]


class FigureAxis(pg.AxisItem):  # type: ignore[misc]
    """Round figures with their unit, and room between them.

    Args:
        unit: Of the figures; "": codes, with no figures between the whole ones.
    """

    def __init__(self, unit: str) -> None:
        super().__init__("left", maxTickLength=-4)
        self.enableAutoSIPrefix(False)
        self._unit = unit

    def tickSpacing(self, *span_and_length: float) -> list[tuple[float, float]]:  # noqa: N802
        """One kind of tick: of the smallest and the largest figure, and the length in pixels."""
        low, high, length_px = span_and_length
        step = round_step(low, high, max(1, round(length_px / _FIGURE_PX)))
        return [(step or 1.0 if self._unit else max(step, 1.0), 0.0)]

    def tickStrings(self, *values_scale_spacing: Any) -> list[str]:  # noqa: N802
        """Figures with their unit, as everywhere else."""
        return [
            append_unit(each, self._unit) for each in super().tickStrings(*values_scale_spacing)
        ]
