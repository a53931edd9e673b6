"""Tables of texts in the language chosen, and sentences with their figures filled in."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final, TypeVar

from PySide6.QtCore import QCoreApplication

from armui.system import paths
from armui.system.files import read_file
from armui.system.sentence import Sentence

Key = TypeVar("Key")
Other = TypeVar("Other")

NOT_KNOWN = "—"
"""Stands where a figure is missing, as it does in the rest of the window."""


_BY_ID: Final[Mapping[str, Mapping[str, str]]] = json.loads(
    read_file(paths.RESOURCES / "i18n" / "sentences.json")
)
"""Sentences by their context and the ids that files keep, made by ``python -m tests.translations``.
Read with the program: later the window's thread opens no file."""

_LIST: Final = re.compile(r"(?:J?\d|0x[0-9A-F]{3})(?:, (?:J?\d|0x[0-9A-F]{3}))+")
"""Joints or identifiers, as those who know no language have listed them."""


def listed(items: Iterable[str]) -> str:
    """Items of a list in a sentence, parted as the operator's language does it."""
    # Translators: between two items of a list
    return QCoreApplication.translate("List", ", ").join(items)


class _Figures(dict[str, str]):
    """The figures of one sentence as text; one that is missing shows as not known."""

    def __missing__(self, key: str) -> str:
        return NOT_KNOWN


def _figure(value: object) -> str:
    """A figure as the operator reads it: angles and lengths with three decimals."""
    text = f"{value:.3f}" if isinstance(value, float) else str(value)
    return listed(text.split(", ")) if _LIST.fullmatch(text) else text


def sentence(context: str, source: object, params: Mapping[str, object]) -> str:
    """A sentence in the operator's language with its figures filled in.

    Args:
        context: The translation context the sentence was marked with.
        source: The English sentence as marked by ``QT_TRANSLATE_NOOP``; ``{name}`` is a figure.
        params: The figures by name; floats are shown with three decimals.

    Returns:
        The sentence; a figure that is not in ``params`` shows as «—».
    """
    figures = _Figures({key: _figure(value) for key, value in params.items()})
    return QCoreApplication.translate(context, str(source)).format_map(figures)


def source_of(what: Sentence) -> str:
    """The English of a sentence, also of one that a file names by its id; "" if there is none."""
    return what.source or _BY_ID.get(what.context, {}).get(what.id, "")


def said(what: Sentence, params: Mapping[str, object]) -> str:
    """A sentence of the code in the operator's language; for the figures see :func:`sentence`."""
    return sentence(what.context, what.source, params)


@dataclass(frozen=True, slots=True)
class Text:
    """A text that is looked up when it is shown: ``Text("ViewBar", "Fit")`` marks it, too.

    Attributes:
        context: Of the translation.
        source: The English text.
        suffix: What follows it in every language: ``J3``, ``X``.
    """

    context: str
    source: str
    suffix: str = ""

    def text(self) -> str:
        """It in the language of now."""
        said = QCoreApplication.translate(self.context, self.source)
        return f"{said} {self.suffix}".rstrip()


class Texts(Mapping[Key, str]):
    """The English texts of a table by what each stands for, and how they read in any language.

    A table is written out as ``Texts("Refusal") | {…}``, which ``python -m tests.translations``
    finds: its texts need no mark of their own.

    Args:
        context: Of their translations.
        sources: The texts; ``{name}`` is a figure.
    """

    def __init__(self, context: str, sources: Mapping[Key, str] | None = None) -> None:
        self._context = context
        self._sources = dict(sources or {})

    def __or__(self, more: Mapping[Other, str]) -> Texts[Key | Other]:
        """The texts of both, in this context."""
        return Texts(self._context, {**self._sources, **more})

    def __getitem__(self, key: Key) -> str:
        """The English text."""
        return self._sources[key]

    def __iter__(self) -> Iterator[Key]:
        return iter(self._sources)

    def __len__(self) -> int:
        return len(self._sources)

    def text(self, key: Key, params: Mapping[str, object] | None = None) -> str:
        """A text in the operator's language, with its figures as in :func:`sentence`."""
        return sentence(self._context, self._sources[key], params or {})

    def word(self, name: Key) -> str:
        """The same without figures; a name there is no text for stands for itself."""
        return self.text(name) if name in self._sources else str(name)
