"""Sentences for the operator, declared in English beside the code that uses them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
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


class Told(str):
    """A text in English that remembers its sentence and figures, to be said in another language.

    ``Told("row {row}", row=3)``; ``python -m tests.translations`` collects the sentences.

    Attributes:
        source: The sentence; ``{name}`` is a figure.
        figures: The figures, among them further texts.
    """

    __slots__ = ("figures", "source")
    source: str
    figures: Mapping[str, object]
    context: ClassVar[str] = "CommandLine"

    def __new__(cls, source: str, /, **figures: object) -> Told:
        """Create the English text of a sentence with its figures."""
        told = super().__new__(cls, source.format_map(figures) if figures else source)
        told.source, told.figures = source, figures
        return told

    def translated(self, translate: Callable[[str, str], str]) -> str:
        """Return the text in the language of a function that translates a text of a context."""
        return filled(translate(self.context, self.source), self.figures, translate)


def filled(text: str, figures: Mapping[str, object], translate: Callable[[str, str], str]) -> str:
    """Return a translated sentence with its figures; those that are texts are translated, too."""
    if not figures:
        return text
    each = {
        name: figure.translated(translate) if isinstance(figure, Told) else figure
        for name, figure in figures.items()
    }
    return text.format_map(each)
