"""The times at which the arm's periodic frames are due (protocol: cycle times)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Final

from armui.protocol.generation import Generation
from armui.protocol.layout import load_database

TICK_NS: Final = 5_000_000
"""Frames leave on this grid: one burst of frames for each switch of threads."""

_NS_PER_MS: Final = 1_000_000
_PER_DRIVER: Final = ("DriverFast", "DriverSlow")
_END_MOTION: Final = tuple(f"EndMotion{joint}" for joint in range(1, 7))
_IK_SOLUTION: Final = ("IkSolution12", "IkSolution34", "IkSolution56")
_IK_SOLUTION_MS: Final = 5
"""The cycle time of the IK solution, which is assumed: the protocol text gives none."""
_DRIVERS: Final = tuple(f"{kind}{joint}" for kind in _PER_DRIVER for joint in range(1, 7))


_OPTIONS: Final = {
    **dict.fromkeys(_END_MOTION, "end_motion"),
    **dict.fromkeys(_IK_SOLUTION, "ik_solution"),
}
"""The attribute that switches on the frames that are not always sent."""


@dataclass(slots=True)
class _Slot:
    """Frames that leave together."""

    due_ns: int
    period_ns: int
    names: tuple[str, ...]
    option: str


class FeedbackSchedule:
    """The periodic feedback of one generation, with the cycle times of its DBC file.

    The controller sends all frames with the same cycle time as one burst, so that their values
    belong together. The six drivers send independently, spread over the period as far as the grid
    allows.

    Attributes:
        end_motion: True if 0x481–0x486 are on; they follow the controller's frames.
        ik_solution: True if 0x2AA–0x2AC are sent.
    """

    def __init__(self, generation: Generation) -> None:
        self.end_motion = self.ik_solution = False
        self._slots = [_Slot(*slot) for slot in _slots(generation)]
        self.next_ns = min(slot.due_ns for slot in self._slots)
        self.periods_ns: Mapping[str, int] = {
            name: slot.period_ns for slot in self._slots for name in slot.names
        }

    def pop(self) -> list[str]:
        """Return the names of the frames due at `next_ns`, in bus order, and advance."""
        now_ns = self.next_ns
        names: list[str] = []
        for slot in self._slots:
            if slot.due_ns == now_ns:
                if not slot.option or getattr(self, slot.option):
                    names += slot.names
                slot.due_ns += slot.period_ns
        self.next_ns = min(slot.due_ns for slot in self._slots)
        return names


@cache
def _slots(generation: Generation) -> tuple[tuple[int, int, tuple[str, ...], str], ...]:
    """Return when each burst is first due, its period, its frames and their option."""
    database = load_database(generation)
    groups: dict[tuple[int, int, str], list[str]] = {}

    def add(name: str, cycle_time_ms: int, part: int = 1, parts: int = 1) -> None:
        period_ns = cycle_time_ms * _NS_PER_MS
        first_ns = -(-period_ns * part // (parts * TICK_NS)) * TICK_NS
        groups.setdefault((first_ns, period_ns, _OPTIONS.get(name, "")), []).append(name)

    periodic = {each.name: each.cycle_time for each in database.messages if each.cycle_time}
    for name, cycle_time_ms in periodic.items():
        if name not in _DRIVERS:
            add(name, cycle_time_ms)
    if any(each.name in _IK_SOLUTION for each in database.messages):
        for name in _IK_SOLUTION:
            add(name, _IK_SOLUTION_MS)
    for name in _DRIVERS:
        add(name, periodic[name], int(name[-1]), 6)
    return tuple(
        (first_ns, period_ns, tuple(names), option)
        for (first_ns, period_ns, option), names in groups.items()
    )
