"""Finds readings of the gripper that no gripper can have reached since the one before.

Either an angle has wrapped, or the zero was set, or a second arm answers.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, NamedTuple

import numpy as np

from armui.protocol.signal_columns import payload_words, signal_column

if TYPE_CHECKING:
    from collections.abc import Hashable

    from numpy.typing import NDArray

    from armui.protocol.layout import MessageLayout

GRIPPER: Final = "GripperFeedback"
_TRAVELS: Final = ("Opening", "Angle")
_FASTEST: Final = 2_000.0
"""The fastest travel believed, in mm/s or °/s: 30 rad/s, as fast as small drives turn unloaded,
with some to spare. The whole 100 mm or 100° would take 50 ms; a gripper takes a second.
"""
_LEAST: Final = 20.0
"""The smallest jump in mm or degrees. Of frames that an adapter hands over together the times tell
little: within 16 ms a gripper at 1,000 mm/s goes 16 mm.
"""


class GripperJump(NamedTuple):
    """A jump of the reading.

    Attributes:
        before, after: The readings.
        unit: Their unit.
        within_ms: The time between them in ms.
    """

    before: float
    after: float
    unit: str
    within_ms: float


class GripperJumps:
    """Looks through the readings of a log, a part after the other."""

    def __init__(self) -> None:
        self._last: dict[tuple[Hashable, str], tuple[float, float]] = {}

    def found(
        self,
        layout: MessageLayout,
        times_s: NDArray[np.float64],
        payloads: NDArray[np.uint8],
        arm: Hashable = None,
    ) -> list[tuple[int, GripperJump]]:
        """Return the rows of jumps in the next readings, in their order.

        Args:
            layout: The layout of 0x2A8.
            times_s: The times of the readings, measured.
            payloads: The payloads of the frames, shape (rows, 8).
            arm: The arm of the readings; arms are kept apart.
        """
        jumps = []
        for signal in filter(None, map(layout.signals.get, _TRAVELS)):
            values = signal_column(payload_words(payloads), signal)
            rows = np.flatnonzero(np.isfinite(values))
            last_s, last = self._last.get((arm, signal.name), (np.nan, np.nan))
            moments = np.concatenate([[last_s], times_s[rows]])
            travels = np.concatenate([[last], values[rows]])
            self._last[arm, signal.name] = float(moments[-1]), float(travels[-1])
            within_s = np.diff(moments)
            odd = np.abs(np.diff(travels)) > np.maximum(_LEAST, _FASTEST * within_s)
            for place in np.flatnonzero(odd & (within_s >= 0.0)).tolist():
                before, after = (round(float(each), 3) for each in travels[place : place + 2])
                within_ms = round(float(within_s[place]) * 1e3, 3)
                jump = GripperJump(before, after, signal.unit, within_ms)
                jumps.append((int(rows[place]), jump))
        return sorted(jumps)
