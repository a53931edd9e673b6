"""Sentences for the operator, declared in English beside the code that uses them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar


@dataclass(frozen=True, slots=True)
class Sentence:
    """A sentence for the operator, a constant ``NAME`` of the module that uses it.

    ``python -m tests.translations`` collects them: id and sentence are literals. The user interface
    translates them. Two are equal if their ids are.

    Attributes:
        context: The context of the translation; each class has its own, and an id is unique in it.
        id: ``name``. It is kept in files and by clients, and never changes.
        source: The sentence in English: the thing, its value and limit, and the remedy; ``{name}``
            is a figure. It is empty if only the id was read from a file.
    """

    context: ClassVar[str]
    id: str
    source: str = field(default="", compare=False, repr=False)

    def __str__(self) -> str:
        return self.id
