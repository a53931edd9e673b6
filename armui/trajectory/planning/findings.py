"""What a check before running has found: the sentence stands where it is found."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from armui.system.sentence import Sentence


class Severity(enum.Enum):
    """Whether the operator may run the trajectory all the same."""

    ERROR = "error"
    """The arm would refuse, stop or hit itself: not to be run."""
    WARNING = "warning"
    """The operator may look at it and accept it."""


@dataclass(frozen=True, slots=True)
class FindingKind(Sentence):
    """Something a check can find.

    Attributes:
        severity: Whether it can be accepted.
    """

    context: ClassVar[str] = "Finding"
    severity: Severity = field(default=Severity.ERROR, compare=False)

    def __call__(self, **figures: float | int | str) -> Finding:
        """It with the figures its sentence names, in their units; of the whole, until placed."""
        return Finding(self, figures)


FAR_FROM_START = FindingKind(
    "far_from_start",
    "The first point is far from where the arm is: joint {joint} turns {value}°. Watch the "
    "way there in the preview, or bring the arm nearer first.",
    Severity.WARNING,
)


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
        kind: What was found.
        params: The figures the sentence names.
        row: The index of the point (or the sample of a recording) it concerns, from 0;
            ``None`` for the whole.
        joints_deg: Where the arm would be, if that is known.
        place_mm: Where the tip of the tool would be, if that is known.
        approach: Set where the arm's present pose, or the way from it, is at fault and not the
            point in the row.
        cycle: In which cycle it happens first.
    """

    kind: FindingKind
    params: Mapping[str, float | int | str] = field(default_factory=dict)
    row: int | None = None
    joints_deg: tuple[float, ...] | None = None
    place_mm: tuple[float, ...] | None = None
    approach: Approach | None = None
    cycle: int = 1

    @property
    def code(self) -> str:
        """The id of what was found."""
        return self.kind.id

    @property
    def is_of_approach(self) -> bool:
        """Return whether it depends on where the arm is now."""
        return self.approach is not None or self.kind == FAR_FROM_START

    @property
    def severity(self) -> Severity:
        """True if it can be accepted."""
        return self.kind.severity
