"""The program's texts in the other language, and the pinyin of the Chinese ones.

``python -m tests.translations`` writes the file, so that the program needs no dictionary of pinyin.
Pure.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Final

from armui.system import paths
from armui.system.files import read_file
from armui.ui.actions.search import SearchText

_FILE: Final = paths.RESOURCES / "i18n" / "names.json"


class Names:
    """Finds the names of a text in both languages, and in pinyin.

    Args:
        rows: Chinese, English ("": a synonym, which has none), and the pinyin of the Chinese with a
            space between two syllables.
    """

    def __init__(self, rows: Iterable[tuple[str, str, str]] = ()) -> None:
        self._pinyin: dict[str, tuple[str, ...]] = {}
        self._others: dict[str, set[str]] = {}
        for chinese, english, pinyin in rows:
            self._pinyin[chinese] = tuple(pinyin.split())
            if english:  # a synonym has only a Chinese name
                self._others.setdefault(chinese, set()).add(english)
                self._others.setdefault(english, set()).add(chinese)

    @property
    def known(self) -> bool:
        """True if the names have been read."""
        return bool(self._pinyin)

    def search_text(
        self, titles: Sequence[str], place: str, synonyms: Sequence[str] = ()
    ) -> SearchText:
        """Return all texts by which a command can be found.

        Args:
            titles: Its titles in the present language.
            place: The title of its place, likewise.
            synonyms: Other names, in any language; lower case.
        """
        names = [name for title in titles for name in self._called(title)]
        more = self._called(place)
        return SearchText(
            names=tuple(name.lower() for name in names),
            more=tuple(name.lower() for name in more),
            pinyin=self._spelled(names),
            more_pinyin=self._spelled(more),
            synonyms=tuple(synonyms),
            synonym_pinyin=self._spelled(synonyms),
        )

    def _called(self, text: str) -> list[str]:
        """Return a text and its translations; a suffix like J3 stays with each."""
        if text in self._others or not text:
            return [text, *sorted(self._others.get(text, ()))] if text else []
        stem, _, suffix = text.rpartition(" ")
        return [text, *(f"{other} {suffix}" for other in sorted(self._others.get(stem, ())))]

    def _spelled(self, names: Iterable[str]) -> tuple[tuple[str, ...], ...]:
        found = []
        for name in names:
            stem, _, suffix = name.rpartition(" ")
            if name in self._pinyin:
                found.append(self._pinyin[name])
            elif stem in self._pinyin:
                found.append((*self._pinyin[stem], suffix.lower()))
        return tuple(found)


def read_names() -> Names:
    """Read the names from their file; not in the GUI thread.

    Raises:
        OSError: It cannot be read.
    """
    known: Mapping[str, tuple[str, list[str]]] = json.loads(read_file(_FILE))
    return Names(
        (chinese, english, pinyin)
        for chinese, (pinyin, sources) in known.items()
        for english in sources or [""]
    )
