"""Searches by a part of a Chinese, English or pinyin name. Pure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

_EXACT, _INITIALS, _START, _WORD, _WITHIN = range(5)
"""Ranks: the whole name, the initials of its pinyin, its start, the start of a word, anywhere."""

_NONE: Final = 99
_SHORTEST_LATIN: Final = 3
"""Fewer Latin letters do not match the beginning of a synonym."""


@dataclass(frozen=True, slots=True)
class SearchText:
    """The names of a command for the search.

    Attributes:
        names: Its own names, in all known languages; lower case.
        more: The names of its place, likewise: they match as well, with a lower rank.
        pinyin: The syllables of each of its Chinese names, without tones.
        more_pinyin: The same for the names of its place.
        synonyms: Other names of it, in any language; lower case.
        synonym_pinyin: The syllables of each Chinese synonym.
    """

    names: tuple[str, ...]
    more: tuple[str, ...] = ()
    pinyin: tuple[tuple[str, ...], ...] = ()
    more_pinyin: tuple[tuple[str, ...], ...] = ()
    synonyms: tuple[str, ...] = ()
    synonym_pinyin: tuple[tuple[str, ...], ...] = ()


def rank(query: str, text: SearchText) -> tuple[int, ...] | None:
    """Return how well a query matches, the lower the better, or ``None`` if it does not.

    Every word of the query must be found in a name of the command or of its place. A word may be
    Chinese, English, pinyin in full, its initials, or the two mixed: «ydkz», «yundkz».
    """
    words = query.lower().split()
    ranks = []
    for word in words:
        own = min(
            _in_names(word, text.names),
            _in_pinyin(word, text.pinyin),
            _in_synonyms(word, text),
        )
        place = min(_in_names(word, text.more), _in_pinyin(word, text.more_pinyin))
        best = min(own, _WITHIN + 1 + place)
        if best >= _NONE:
            return None
        ranks.append(best)
    if len(words) > 1 and (whole := _in_names(" ".join(words), text.names)) <= _START:
        ranks = [whole]
    found = [name for name in text.names if any(word in name for word in words)]
    shortest = min(map(len, found or text.names), default=0)
    return (max(ranks, default=0), sum(ranks), shortest) if ranks else (0, 0, 0)


def is_named(query: str, text: SearchText) -> bool:
    """Return whether a query is a name of the command, alone or with words of its place's name."""
    words = query.lower().split()
    names = {name.partition(":")[0] for name in text.names} | {*map("".join, text.pinyin)}
    place = {word for name in text.more for word in (name, *name.split())}
    place |= {*map("".join, text.more_pinyin)}
    own = [word for word in words if word not in place]
    return not names.isdisjoint((" ".join(words), " ".join(own)))


def _in_names(word: str, names: Sequence[str]) -> int:
    best = _NONE
    for name in names:
        if word == name:
            return _EXACT
        at = name.find(word)
        if at == 0:
            best = min(best, _START)
        elif at > 0:
            begins = not name[at - 1].isalnum() and name[at].isascii()
            best = min(best, _WORD if begins else _WITHIN)
    return best


def _in_synonyms(word: str, text: SearchText) -> int:
    """Rank a whole synonym as the start of a name, and its beginning as a part of one."""
    spelled = _in_pinyin(word, text.synonym_pinyin)
    if word in text.synonyms or spelled == _INITIALS:
        return _START
    long_enough = len(word) >= (_SHORTEST_LATIN if word.isascii() else 1)
    begins = spelled == _START or any(each.startswith(word) for each in text.synonyms)
    return _WITHIN if long_enough and begins else _NONE


def _in_pinyin(word: str, names: Sequence[tuple[str, ...]]) -> int:
    best = _NONE
    if not word.isascii() or not word.isalnum():
        return best
    for syllables in names:
        for first, syllable in enumerate(syllables):
            if syllable[:1] == word[0] and _spells(word, syllables[first:]):
                whole = first == 0 and len(word) >= len(syllables)
                best = min(best, _INITIALS if whole else _START if first == 0 else _WORD)
                break
    return best


def _spells(word: str, syllables: Sequence[str]) -> bool:
    """Return whether a word consists of beginnings of the syllables, one after another."""
    if not word:
        return True
    if not syllables:
        return False
    syllable, *rest = syllables
    most = 0
    while most < min(len(syllable), len(word)) and syllable[most] == word[most]:
        most += 1
    return any(_spells(word[length:], rest) for length in range(most, 0, -1))
