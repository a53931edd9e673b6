"""Sentences for the operator: each stands, in English, beside what says it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar


@dataclass(frozen=True, slots=True)
class Sentence:
    """A sentence for the operator, as a constant ``NAME`` of the module that says it.

    ``python -m tests.translations`` collects them: id and sentence are literals. The user
    interface puts them into the operator's language. Two are equal if their ids are.

    Attributes:
        context: Of the translation; each class has its own, and in it each id is there once.
        id: ``name``. What files and clients keep; it never changes.
        source: The sentence in English: what, its value and limit, and the remedy; ``{name}`` is a
            figure. It is empty where only the id was read from a file.
    """

    context: ClassVar[str]
    id: str
    source: str = field(default="", compare=False, repr=False)

    def __str__(self) -> str:
        return self.id
