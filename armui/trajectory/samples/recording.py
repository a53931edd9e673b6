"""What was recorded while the arm moved: samples of its joints and its gripper over time."""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Final

import numpy as np
import numpy.typing as npt

from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.trajectory.points.program import ANGLE, RANGES, check_name, check_text

Array = npt.NDArray[np.float64]

COLUMN_NAMES: Final = ("t", "J1", "J2", "J3", "J4", "J5", "J6", "gripper")
COLUMN_COUNT: Final = len(COLUMN_NAMES)
GRIPPER: Final = 7
"""The column of the gripper's opening."""

LONGEST_S: Final = 24 * 3600.0


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """Samples over time.

    Attributes:
        name: What the operator calls it.
        note: What it is for.
        samples: (n, 8): time in s, from 0 up and never back; six joint angles in degrees; the
            gripper's opening in mm, NaN where it was not recorded.
        modified: When it was last changed, with its time zone.
        taught_on: The arm it was taught on, as `ModelFit.kind` tells; "": not known.
    """

    name: str
    note: str = ""
    samples: Array = field(default_factory=lambda: np.empty((0, COLUMN_COUNT)))
    modified: datetime = datetime(1970, 1, 1, tzinfo=UTC)
    taught_on: str = ""

    @property
    def times_s(self) -> Array:
        """(n,) when the samples were taken."""
        return self.samples[:, 0]

    @property
    def joints_deg(self) -> Array:
        """(n, 6) joint angles."""
        return self.samples[:, 1:GRIPPER]

    @property
    def gripper_mm(self) -> Array:
        """(n,) openings, NaN where none was recorded."""
        return self.samples[:, GRIPPER]

    @property
    def duration_s(self) -> float:
        """From the first sample to the last."""
        return float(self.samples[-1, 0] - self.samples[0, 0]) if len(self.samples) else 0.0

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Recording):
            return NotImplemented
        return (self.name, self.note, self.modified) == (
            other.name,
            other.note,
            other.modified,
        ) and np.array_equal(self.samples, other.samples, equal_nan=True)

    __hash__ = None  # type: ignore[assignment]  # holds an array


def check_samples(samples: Array) -> tuple[int, Refusal] | None:
    """The first sample that cannot be: its row, from 1, and the reason.

    Args:
        samples: (n, 8), as in `Recording`.
    """
    opening = RANGES["opening"]
    low = np.array([0.0, *[ANGLE.minimum] * 6, opening.minimum])
    high = np.array([LONGEST_S, *[ANGLE.maximum] * 6, opening.maximum])
    inside = (samples >= low) & (samples <= high)
    inside[:, GRIPPER] |= np.isnan(samples[:, GRIPPER])
    forward = np.ones(len(samples), dtype=bool)
    forward[1:] = np.diff(samples[:, 0]) >= 0.0
    good = inside.all(axis=1) & forward
    if good.all():
        return None
    row = int(np.argmin(good))
    if inside[row].all():
        params = {"value": float(samples[row, 0]), "minimum": float(samples[row - 1, 0])}
        return row + 1, Refusal(RefusalCode.SAMPLE_BACK_IN_TIME, params)
    column = int(np.argmin(inside[row]))
    name, value = COLUMN_NAMES[column], float(samples[row, column])
    if not np.isfinite(value):
        return row + 1, Refusal(RefusalCode.POINT_NOT_A_NUMBER, {"field": name, "value": value})
    unit = ("s", *["°"] * 6, "mm")[column]
    limits: dict[str, float | str] = {
        "minimum": float(low[column]),
        "maximum": float(high[column]),
        "unit": unit,
    }
    return row + 1, Refusal(
        RefusalCode.POINT_OUT_OF_RANGE, {**limits, "field": name, "value": value}
    )


def check_recording(recording: Recording) -> tuple[int, Refusal] | None:
    """The first thing that keeps a recording from being saved: row (0: itself), reason."""
    refusal = check_name(recording.name) or check_text("note", recording.note)
    return (0, refusal) if refusal is not None else check_samples(recording.samples)
