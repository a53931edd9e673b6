"""The curves of each plot, and predefined sets of plots: pure."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, Final

from armui.arm.limits import JOINTS
from armui.telemetry.quantities import QUANTITIES

MOST_PLOTS: Final = 12
MOST_CURVES: Final = 12
"""The most curves in one plot: more can't be told apart."""
_MOST_SPAN_S: Final = 1e6

Plots = tuple[tuple[str, ...], ...]
"""The keys of each plot's quantities."""


def _each_joint(*kinds: str) -> tuple[str, ...]:
    return tuple(f"arm.{kind}.{joint}" for kind in kinds for joint in JOINTS)


_STATUS: Final = (
    *("arm_status", "control_mode", "not_reached", "no_communication", "beyond_limit"),
)

SETS: Final[Mapping[str, Plots]] = {
    "follow": tuple(
        tuple(f"{source}.joint_angle.{joint}" for source in ("arm", "own", "other"))
        for joint in JOINTS
    ),
    "hot": (
        _each_joint("motor_temperature"),
        _each_joint("driver_temperature"),
        _each_joint("motor_current"),
        _each_joint("voltage"),
    ),
    "stop": (
        tuple(f"arm.{kind}" for kind in _STATUS),
        _each_joint("driver_faults"),
        _each_joint("motor_current"),
        _each_joint("motor_speed"),
        _each_joint("voltage"),
        ("bus.frames_per_s",),
    ),
    "tool": (
        *(
            tuple(f"{source}.pose_{axis}" for source in ("arm", "own", "other"))
            for axis in ("x", "y", "z")
        ),
        ("arm.pose_rx", "arm.pose_ry", "arm.pose_rz"),
        ("arm.gripper_opening", "own.gripper_opening", "arm.gripper_torque"),
    ),
    "bus": (("bus.frames_per_s",), ("bus.bus_load",), ("bus.error_frames_per_s",)),
}
"""The predefined sets, each for a question: did it follow, what got hot, why did it stop, and so
on.
"""

FIRST_SET: Final = "follow"


def tidy(plots: Iterable[Iterable[str]]) -> Plots:
    """Return existing keys, each once in a plot, without empty plots, up to the limits."""
    known = (
        tuple(dict.fromkeys(key for key in plot if key in QUANTITIES))[:MOST_CURVES]
        for plot in plots
    )
    return tuple(plot for plot in known if plot)[:MOST_PLOTS]


class PlotLayout:
    """The operator's arrangement of plots."""

    def __init__(self, plots: Plots = SETS[FIRST_SET]) -> None:
        self._plots = tidy(plots)

    @property
    def plots(self) -> Plots:
        """The keys of each plot's quantities."""
        return self._plots

    @property
    def name(self) -> str | None:
        """The name of the predefined set, or ``None`` for the operator's own."""
        return next((name for name, plots in SETS.items() if plots == self._plots), None)

    def show(self, plots: Plots) -> None:
        """Set the plots, after `tidy`."""
        self._plots = tidy(plots)

    def find(self, key: str) -> int | None:
        """Return the first plot with a quantity, or ``None``."""
        return next((place for place, plot in enumerate(self._plots) if key in plot), None)

    def why_not(self, keys: Sequence[str], place: int | None) -> str | None:
        """Return what is full, ``"plots"`` or ``"curves"``, or ``None`` if there is room."""
        if place is None:
            return "plots" if len(self._plots) >= MOST_PLOTS else None
        room = MOST_CURVES - len(self._plots[place])
        return "curves" if sum(key not in self._plots[place] for key in keys) > room else None

    def add(self, keys: Sequence[str], place: int | None = None) -> None:
        """Add quantities to a plot, or to a new last one with ``None``."""
        plots = [list(plot) for plot in self._plots]
        if place is None:
            plots.append(list(keys))
        else:
            plots[place] += keys
        self._plots = tidy(plots)

    def remove(self, place: int, key: str) -> None:
        """Remove a quantity from a plot; an empty plot is removed as well."""
        self._plots = tidy(
            [each for each in plot if (at, each) != (place, key)]
            for at, plot in enumerate(self._plots)
        )

    def move(self, key: str, source: int, place: int | None) -> None:
        """Move a quantity from one plot to another, or to a new one with ``None``."""
        if source != place:
            plots = [list(plot) for plot in self._plots]
            plots[source].remove(key)
            if place is None:
                plots.append([key])
            else:
                plots[place].append(key)
            self._plots = tidy(plots)

    def remove_plot(self, place: int) -> None:
        """Remove a plot with all its curves."""
        self._plots = tuple(plot for at, plot in enumerate(self._plots) if at != place)


def to_text(plots: Plots, span_s: float) -> str:
    """Return the text of a layout's file."""
    return json.dumps({"plots": plots, "span_s": span_s}, indent=1) + "\n"


def from_text(text: str) -> tuple[Plots, float] | None:
    """Return the layout in a text, or ``None`` if it holds none."""
    try:
        entries = json.loads(text)
    except (ValueError, RecursionError):
        return None
    if not isinstance(entries, dict):
        return None
    plots = tidy(_keys(entries.get("plots")))
    span_s = entries.get("span_s")
    if not plots or isinstance(span_s, bool) or not isinstance(span_s, int | float):
        return None
    return (plots, float(span_s)) if 0 < span_s < _MOST_SPAN_S else None


def _keys(plots: Any) -> Iterator[list[str]]:
    for plot in plots if isinstance(plots, list) else ():
        yield [key for key in plot if isinstance(key, str)] if isinstance(plot, list) else []
