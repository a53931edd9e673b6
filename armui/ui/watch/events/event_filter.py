"""Which events are shown: pure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from armui.telemetry.events import Asker, EventEntry, EventKind, Level

_GRAVITY: Final = {Level.INFO: 0, Level.DONE: 0, Level.WARNING: 1, Level.FAULT: 2}


def gravity(entry: EventEntry) -> Level:
    """How grave an event is by now, with what became of it."""
    result = entry.result
    if result is not None and _GRAVITY[result.level] > _GRAVITY[entry.level]:
        return result.level
    return entry.level


@dataclass(frozen=True, slots=True)
class EventFilter:
    """What the operator wants to see.

    Attributes:
        kinds: Of these sorts.
        who: Of this one alone; ``None``: of everybody.
        least: At least so grave.
        words: All of these in the text of the event, in small letters.
    """

    kinds: frozenset[EventKind] = frozenset(EventKind)
    who: Asker | None = None
    least: Level = Level.INFO
    words: tuple[str, ...] = ()

    @property
    def everything(self) -> bool:
        """True if nothing is kept out."""
        return self == _EVERYTHING

    def passes(self, entry: EventEntry, text: Callable[[EventEntry], str]) -> bool:
        """Return whether an event is shown.

        Args:
            entry: It.
            text: Its text in small letters; asked for only where words are wanted.
        """
        if entry.kind not in self.kinds or self.who not in {None, entry.who}:
            return False
        if _GRAVITY[gravity(entry)] < _GRAVITY[self.least]:
            return False
        if not self.words:
            return True
        written = text(entry)
        return all(word in written for word in self.words)


_EVERYTHING: Final = EventFilter()
