"""The filter of events: pure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from armui.telemetry.events import Asker, EventEntry, EventKind, Level

_GRAVITY: Final = {Level.INFO: 0, Level.DONE: 0, Level.WARNING: 1, Level.FAULT: 2}


def gravity(entry: EventEntry) -> Level:
    """Return the severity of an event, raised by its result."""
    result = entry.result
    if result is not None and _GRAVITY[result.level] > _GRAVITY[entry.level]:
        return result.level
    return entry.level


@dataclass(frozen=True, slots=True)
class EventFilter:
    """The filter chosen by the operator.

    Attributes:
        kinds: The kinds.
        who: The source; ``None`` for all.
        least: The least severity.
        words: Words that must all be in the text of the event, in lower case.
    """

    kinds: frozenset[EventKind] = frozenset(EventKind)
    who: Asker | None = None
    least: Level = Level.INFO
    words: tuple[str, ...] = ()

    @property
    def everything(self) -> bool:
        """True if no event is filtered out."""
        return self == _EVERYTHING

    def passes(self, entry: EventEntry, text: Callable[[EventEntry], str]) -> bool:
        """Return whether an event is shown.

        Args:
            entry: The event.
            text: Returns its text in lower case; called only if there are words.
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
