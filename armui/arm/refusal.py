"""Reasons why something was not done: a sentence, and the figures it names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from armui.system.sentence import Sentence


@dataclass(frozen=True, slots=True)
class Reason(Sentence):
    """A reason against an action."""

    context: ClassVar[str] = "Refusal"

    def __call__(self, **figures: float | int | str) -> Refusal:
        """Return a refusal: this reason with the figures that its sentence names, in its units."""
        return Refusal(self, figures)


@dataclass(frozen=True, slots=True)
class Contact:
    """Where an arm would touch itself, or come too near to something.

    Attributes:
        joints_deg: The six angles there.
        links: The links that touch, 0 for the base, 1–6 for what the joint of that number turns.
        place_mm: The place in the base frame, midway between what touches.
    """

    joints_deg: tuple[float, ...]
    links: tuple[int, ...]
    place_mm: tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Refusal:
    """A reason against an action, with its figures.

    Attributes:
        reason: The reason.
        params: The figures the sentence names, in the units the sentence shows.
        contact: Where the arm would first touch, if that is the reason.
    """

    reason: Reason
    params: Mapping[str, float | int | str] = field(default_factory=dict)
    contact: Contact | None = field(default=None, compare=False, repr=False)

    @property
    def code(self) -> str:
        """The reason's id, for JSON files and records."""
        return self.reason.id

    def __str__(self) -> str:
        figures = ", ".join(f"{key}={value}" for key, value in self.params.items())
        return f"{self.reason}({figures})"
