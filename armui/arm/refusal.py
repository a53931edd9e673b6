"""Why something was not done: the sentence stands where it is said, its figures come with it.

The user interface puts it into the operator's language, in the translation context ``Refusal``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, slots=True)
class Reason:
    """A reason against an action, as a constant of the module that raises it.

    ``python -m tests.translations`` collects the sentences: both arguments are literals.

    Attributes:
        id: What recordings, event files and clients keep; it never changes.
        source: The sentence in English: what, its value and limit, and the remedy; ``{name}`` is a
            figure. It is empty where only the id was read from a file.
    """

    id: str
    source: str = field(default="", compare=False, repr=False)

    def __call__(self, **figures: float | int | str) -> Refusal:
        """This reason with the figures its sentence names, in the units it shows."""
        return Refusal(self, figures)

    def __str__(self) -> str:
        return self.id


@dataclass(frozen=True, slots=True)
class Refusal:
    """A reason against an action, with its figures.

    Attributes:
        reason: What it is.
        params: The figures the sentence names, in the units the sentence shows.
    """

    reason: Reason
    params: Mapping[str, float | int | str] = field(default_factory=dict)

    @property
    def code(self) -> str:
        """The reason's id, for what is kept or handed on as JSON."""
        return self.reason.id

    def __str__(self) -> str:
        figures = ", ".join(f"{key}={value}" for key, value in self.params.items())
        return f"{self.reason}({figures})"
