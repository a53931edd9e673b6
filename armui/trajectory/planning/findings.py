"""What a check before running has found, as data; the user interface has a sentence for each."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final


class Severity(enum.Enum):
    """Whether the operator may run the trajectory all the same."""

    ERROR = "error"
    """The arm would refuse, stop or hit itself: not to be run."""
    WARNING = "warning"
    """The operator may look at it and accept it."""


SEVERITIES: Final[Mapping[str, Severity]] = {
    "target_beyond_limit": Severity.ERROR,
    "path_beyond_limit": Severity.ERROR,
    "out_of_reach": Severity.ERROR,
    "path_out_of_reach": Severity.ERROR,
    "path_singular": Severity.ERROR,
    "arc_no_circle": Severity.ERROR,
    "start_unknown": Severity.ERROR,
    "links_collide": Severity.ERROR,
    "joint_too_fast": Severity.ERROR,
    "gripper_beyond_stroke": Severity.ERROR,
    "empty": Severity.ERROR,
    "near_singular": Severity.WARNING,
    "far_from_start": Severity.WARNING,
    "large_turn": Severity.WARNING,
    "sample_jump": Severity.WARNING,
    "tool_too_fast": Severity.WARNING,
    "below_floor": Severity.WARNING,
}
"""Every code of a finding. A finding names the figures its sentence shows, in their units."""


@dataclass(frozen=True, slots=True)
class Finding:
    """Something the operator should know before the arm moves.

    Attributes:
        code: A key of :data:`SEVERITIES`.
        params: The figures the sentence names.
        row: The index of the point (or the sample of a recording) it concerns, from 0;
            ``None`` for the whole.
        joints_deg: Where the arm would be, if that is known.
        place_mm: Where the tip of the tool would be, if that is known.
    """

    code: str
    params: Mapping[str, float | int | str] = field(default_factory=dict)
    row: int | None = None
    joints_deg: tuple[float, ...] | None = None
    place_mm: tuple[float, ...] | None = None

    @property
    def severity(self) -> Severity:
        """Whether it can be accepted."""
        return SEVERITIES[self.code]
