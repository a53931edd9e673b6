"""The findings of a check before a run; each kind is declared with its sentence."""

from __future__ import annotations

import enum
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, ClassVar

from armui.system.sentence import Sentence

if TYPE_CHECKING:
    from armui.arm.refusal import Contact


class Severity(enum.Enum):
    """The weight of a finding: whether the operator may run the trajectory in spite of it."""

    ERROR = "error"
    """The arm would refuse, stop or hit itself: the trajectory must not be run."""
    WARNING = "warning"
    """The operator may examine it and accept it."""


@dataclass(frozen=True, slots=True)
class FindingKind(Sentence):
    """A kind of finding.

    Attributes:
        severity: Its severity.
        remedy: What to do about it at a point, where a recording needs something else.
    """

    context: ClassVar[str] = "Finding"
    severity: Severity = field(default=Severity.ERROR, compare=False)
    remedy: str = field(default="", compare=False)

    def __call__(self, **figures: float | int | str) -> Finding:
        """Return a finding with the figures its sentence names; it has no row until placed."""
        return Finding(self, figures)


FAR_FROM_START = FindingKind(
    "far_from_start",
    "The first point is far from where the arm is: joint {joint} turns {value}°. Watch the "
    "way there in the preview, or bring the arm nearer first.",
    Severity.WARNING,
)


@dataclass(frozen=True, slots=True)
class Finding:
    """Something the operator should know before the arm moves.

    Attributes:
        kind: The kind of finding.
        params: The figures the sentence names.
        row: The index of the point (or the sample of a recording) it concerns, from 0;
            ``None`` for the whole.
        joints_deg: The joint angles there, if known.
        place_mm: The place of the tool's tip there, if known.
        approach: True if the way from the arm's present pose is at fault, and not the point in
            the row.
        cycle: The first cycle in which it happens.
        contact: The place where the arm touches something, if that was found.
        at_s: When it happens in a recording; ``None`` for a trajectory of points.
    """

    kind: FindingKind
    params: Mapping[str, float | int | str] = field(default_factory=dict)
    row: int | None = None
    joints_deg: tuple[float, ...] | None = None
    place_mm: tuple[float, ...] | None = None
    approach: bool = False
    cycle: int = 1
    contact: Contact | None = None
    at_s: float | None = None

    @property
    def code(self) -> str:
        """The id of the kind."""
        return self.kind.id

    @property
    def is_of_approach(self) -> bool:
        """True if it depends on where the arm is now."""
        return self.approach or self.kind == FAR_FROM_START

    @property
    def severity(self) -> Severity:
        """The severity of its kind."""
        return self.kind.severity
