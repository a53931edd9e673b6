"""Tables of texts in the present language, and sentences with their figures filled in."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final, TypeVar

from PySide6.QtCore import QCoreApplication

from armui.arm.limits import JOINTS
from armui.protocol.codes import ALL_JOINTS
from armui.system import paths
from armui.system.files import read_file
from armui.system.sentence import Sentence, Told
from armui.ui import format as fmt

Key = TypeVar("Key")
Other = TypeVar("Other")

NOT_KNOWN = "—"
"""The text for a missing figure, as in the rest of the window."""


_BY_ID: Final[Mapping[str, Mapping[str, str]]] = json.loads(
    read_file(paths.RESOURCES / "i18n" / "sentences.json")
)
"""Sentences by their context and the ids in files, written by ``python -m tests.translations``.
They are read at the import, so that the GUI thread opens no file later.
"""

_LIST: Final = re.compile(r"(?:J?\d|0x[0-9A-F]{3})(?:, (?:J?\d|0x[0-9A-F]{3}))+")
"""Lists of joints or identifiers that were joined by code without a language."""


def listed(items: Iterable[str]) -> str:
    """Return items as a list with the separator of the operator's language."""
    # Translators: between two items of a list
    return QCoreApplication.translate("List", ", ").join(items)


def joined(*sentences: str) -> str:
    """Return sentences one after another; there is no space after the wide full stop of Chinese."""
    return " ".join(filter(None, sentences)).replace("。 ", "。")


class _Figures(dict[str, str]):
    """The figures of one sentence as text; one that is missing shows as not known."""

    def __missing__(self, key: str) -> str:
        return NOT_KNOWN


def _figure(name: str, value: object) -> str:
    """Return a figure as text in the operator's language."""
    if name == "joint" and value == ALL_JOINTS:
        return f"{JOINTS[0]}–{JOINTS[-1]}"
    if isinstance(value, Told):
        return localized(value)
    text = str(value)
    return listed(text.split(", ")) if _LIST.fullmatch(text) else text


def sentence(context: str, source: object, params: Mapping[str, object]) -> str:
    """Return a sentence in the operator's language with its figures filled in.

    Args:
        context: The translation context the sentence was marked with.
        source: The English sentence as marked by ``QT_TRANSLATE_NOOP``; ``{name}`` is a figure.
        params: The figures by name; floats are shown as `fmt.spoken` has them.

    Returns:
        The sentence; a figure that is not in ``params`` shows as «—».
    """
    floats = {key: value for key, value in params.items() if isinstance(value, float)}
    spoken = dict(zip(floats, fmt.spoken([*floats.values()]), strict=True))
    figures = _Figures({key: _figure(key, value) for key, value in {**params, **spoken}.items()})
    text = QCoreApplication.translate(context, str(source))
    if _LIST.fullmatch(str(params.get("joints", ""))):
        text = text.replace("oint {joints}", "oints {joints}")  # the English plural
    return text.format_map(figures)


def source_of(what: Sentence) -> str:
    """Return the English of a sentence, also of one known only by its id; "" if there is none."""
    return what.source or _BY_ID.get(what.context, {}).get(what.id, "")


def localized(text: str) -> str:
    """Return a text in the operator's language; one that is no `Told` is returned as it is."""
    return text.translated(QCoreApplication.translate) if isinstance(text, Told) else text


def said(what: Sentence, params: Mapping[str, object]) -> str:
    """Return a declared sentence in the operator's language; see :func:`sentence` for figures."""
    return sentence(what.context, what.source, params)


@dataclass(frozen=True, slots=True)
class Text:
    """A text that is translated when it is shown: ``Text("ViewBar", "Fit")`` also marks it.

    Attributes:
        context: The context of the translation.
        source: The English text.
        suffix: A suffix in every language: ``J3``, ``X``.
    """

    context: str
    source: str
    suffix: str = ""

    def text(self) -> str:
        """Return the text in the present language."""
        said = QCoreApplication.translate(self.context, self.source)
        return f"{said} {self.suffix}".rstrip()


class Texts(Mapping[Key, str]):
    """The English texts of a table by their keys, and their translations.

    A table is written out as ``Texts("Refusal") | {…}``, which ``python -m tests.translations``
    finds, so that its texts need no marks.

    Args:
        context: The context of their translations.
        sources: The texts; ``{name}`` is a figure.
    """

    def __init__(self, context: str, sources: Mapping[Key, str] | None = None) -> None:
        self._context = context
        self._sources = dict(sources or {})

    def __or__(self, more: Mapping[Other, str]) -> Texts[Key | Other]:
        """Return a table of both, in this context."""
        return Texts(self._context, {**self._sources, **more})

    def __getitem__(self, key: Key) -> str:
        """Return the English text."""
        return self._sources[key]

    def __iter__(self) -> Iterator[Key]:
        return iter(self._sources)

    def __len__(self) -> int:
        return len(self._sources)

    def entry(self, key: Key) -> Text:
        """Return a text of the table, to be translated when it is shown."""
        return Text(self._context, self._sources[key])

    def text(self, key: Key, params: Mapping[str, object] | None = None) -> str:
        """Return a text in the operator's language, with its figures as in :func:`sentence`."""
        return sentence(self._context, self._sources[key], params or {})

    def word(self, name: Key) -> str:
        """Return a text without figures; an unknown name is returned as it is."""
        return self.text(name) if name in self._sources else str(name)
