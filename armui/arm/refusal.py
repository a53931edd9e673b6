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
class Refusal:
    """A reason against an action, with its figures.

    Attributes:
        reason: The reason.
        params: The figures the sentence names, in the units the sentence shows.
    """

    reason: Reason
    params: Mapping[str, float | int | str] = field(default_factory=dict)

    @property
    def code(self) -> str:
        """The reason's id, for JSON files and records."""
        return self.reason.id

    def __str__(self) -> str:
        figures = ", ".join(f"{key}={value}" for key, value in self.params.items())
        return f"{self.reason}({figures})"
