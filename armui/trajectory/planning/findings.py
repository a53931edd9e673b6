"""What a check before running has found, as data; the user interface has a sentence for each."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum, unique
from typing import Final


class Severity(enum.Enum):
    """Whether the operator may run the trajectory all the same."""

    ERROR = "error"
    """The arm would refuse, stop or hit itself: not to be run."""
    WARNING = "warning"
    """The operator may look at it and accept it."""


@unique
class FindingCode(StrEnum):
    """What a check can find."""

    TARGET_BEYOND_LIMIT = "target_beyond_limit"
    PATH_BEYOND_LIMIT = "path_beyond_limit"
    OUT_OF_REACH = "out_of_reach"
    PATH_OUT_OF_REACH = "path_out_of_reach"
    PATH_SINGULAR = "path_singular"
    ARC_NO_CIRCLE = "arc_no_circle"
    START_UNKNOWN = "start_unknown"
    NEVER_REPEATS = "never_repeats"
    ARC_AT_LIMIT = "arc_at_limit"
    LINKS_COLLIDE = "links_collide"
    JOINT_TOO_FAST = "joint_too_fast"
    GRIPPER_BEYOND_STROKE = "gripper_beyond_stroke"
    EMPTY = "empty"
    NEAR_SINGULAR = "near_singular"
    FAR_FROM_START = "far_from_start"
    LARGE_TURN = "large_turn"
    EITHER_WAY = "either_way"
    SAMPLE_JUMP = "sample_jump"
    TOOL_TOO_FAST = "tool_too_fast"
    BELOW_FLOOR = "below_floor"
    OTHER_ARM = "other_arm"


SEVERITIES: Final[Mapping[FindingCode, Severity]] = {
    FindingCode.TARGET_BEYOND_LIMIT: Severity.ERROR,
    FindingCode.PATH_BEYOND_LIMIT: Severity.ERROR,
    FindingCode.OUT_OF_REACH: Severity.ERROR,
    FindingCode.PATH_OUT_OF_REACH: Severity.ERROR,
    FindingCode.PATH_SINGULAR: Severity.ERROR,
    FindingCode.ARC_NO_CIRCLE: Severity.ERROR,
    FindingCode.START_UNKNOWN: Severity.ERROR,
    FindingCode.NEVER_REPEATS: Severity.ERROR,
    FindingCode.ARC_AT_LIMIT: Severity.ERROR,
    FindingCode.LINKS_COLLIDE: Severity.ERROR,
    FindingCode.JOINT_TOO_FAST: Severity.ERROR,
    FindingCode.GRIPPER_BEYOND_STROKE: Severity.ERROR,
    FindingCode.EMPTY: Severity.ERROR,
    FindingCode.NEAR_SINGULAR: Severity.WARNING,
    FindingCode.FAR_FROM_START: Severity.WARNING,
    FindingCode.LARGE_TURN: Severity.WARNING,
    FindingCode.EITHER_WAY: Severity.WARNING,
    FindingCode.SAMPLE_JUMP: Severity.WARNING,
    FindingCode.TOOL_TOO_FAST: Severity.WARNING,
    FindingCode.BELOW_FLOOR: Severity.WARNING,
    FindingCode.OTHER_ARM: Severity.WARNING,
}
"""Every code of a finding. A finding names the figures its sentence shows, in their units."""


class Approach(enum.Enum):
    """What of a trajectory is not in its points: how the arm comes to the first of them."""

    HERE = "here"
    """The pose in which the arm is."""
    WAY = "way"
    """The way from there to the first point."""


@dataclass(frozen=True, slots=True)
class Finding:
    """Something the operator should know before the arm moves.

    Attributes:
        code: What was found.
        params: The figures the sentence names.
        row: The index of the point (or the sample of a recording) it concerns, from 0;
            ``None`` for the whole.
        joints_deg: Where the arm would be, if that is known.
        place_mm: Where the tip of the tool would be, if that is known.
        approach: Set where the arm's present pose, or the way from it, is at fault and not the
            point in the row.
        cycle: In which cycle it happens first.
    """

    code: FindingCode
    params: Mapping[str, float | int | str] = field(default_factory=dict)
    row: int | None = None
    joints_deg: tuple[float, ...] | None = None
    place_mm: tuple[float, ...] | None = None
    approach: Approach | None = None
    cycle: int = 1

    @property
    def is_of_approach(self) -> bool:
        """Tell whether it depends on where the arm is now."""
        return self.approach is not None or self.code is FindingCode.FAR_FROM_START

    @property
    def severity(self) -> Severity:
        """Whether it can be accepted."""
        return SEVERITIES[self.code]
