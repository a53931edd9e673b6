"""Events as data: one entry each, in a bounded log that never blocks."""

from __future__ import annotations

import enum
import threading
from collections import OrderedDict
from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime, timedelta
from enum import StrEnum, unique
from typing import Any, Final

__all__ = [
    "MOST_ENTRIES",
    "REPEATS_SPAN_S",
    "REPEAT_S",
    "Asker",
    "EventEntry",
    "EventKind",
    "EventLog",
    "EventOutcome",
    "Level",
]

MOST_ENTRIES: Final = 10_000
"""Some 20 MB if each is a motion with its figures and its end; the oldest are dropped."""
REPEAT_S: Final = 10.0
"""An event that happens again within this time is counted instead of listed again."""
REPEATS_SPAN_S: Final = 60.0
"""Repeats are counted for this long, then listed again; otherwise one line could cover a day."""


class Level(enum.Enum):
    """The severity of an event."""

    INFO = enum.auto()
    DONE = enum.auto()
    WARNING = enum.auto()
    FAULT = enum.auto()


@unique
class Asker(StrEnum):
    """The source of a command or of an event."""

    OPERATOR = "operator"
    RUN = "run"
    JOG = "jog"
    RECOVERY = "recovery"
    """The operator, by the button of the recovery line."""
    ARM = "arm"
    OTHER_HOST = "other_host"
    CLIENT = "client"
    """Another program, through the local interface."""
    PROGRAM = "program"


@unique
class EventKind(StrEnum):
    """The kind of an event."""

    COMMAND = "command"
    RESULT = "result"
    """The result of a command."""
    STATUS = "status"
    FAULT = "fault"
    LINK = "link"
    OTHER_HOST = "other_host"
    ODDITY = "oddity"
    """Frames on the bus that are unknown, malformed, missing or lost."""
    PROGRAM = "program"


@dataclass(frozen=True, slots=True)
class EventOutcome:
    """The outcome of a command.

    Attributes:
        code: The id of its sentence, as in `EventEntry`.
        at_s: Monotonic time.
        level: DONE, or its severity.
        params: The figures of its sentence.
    """

    code: str
    at_s: float
    level: Level
    params: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class EventEntry:
    """One event.

    The user interface has the sentence for it, in the operator's language.

    Attributes:
        number: Its number in the log, rising.
        at_s: Monotonic time of its beginning.
        wall: The time of day then, with its time zone.
        level: Its severity.
        kind: Its kind.
        who: Its source.
        code: The id of its sentence.
        params: The figures of its sentence.
        lasts: True if it has a beginning and an end; it goes on while ``ended_s`` is ``None``.
        ended_s: The time at which it ended.
        unheard: True if its end was not heard, because its source fell silent or was disconnected.
        count: The number of times it happened; for frames, their number.
        last_s: Monotonic time of the last repeat.
        answer: For a command, the arm's answer (0x476); ``None`` if there is none so far.
        result: For a command, its end by the values read back from the arm.
    """

    number: int
    at_s: float
    wall: datetime
    level: Level
    kind: EventKind
    who: Asker
    code: str
    params: Mapping[str, object] = field(default_factory=dict)
    lasts: bool = False
    ended_s: float | None = None
    unheard: bool = False
    count: int = 1
    last_s: float | None = None
    answer: EventOutcome | None = None
    result: EventOutcome | None = None

    @property
    def goes_on(self) -> bool:
        """True if it has not ended yet."""
        return self.lasts and self.ended_s is None

    @property
    def newest_s(self) -> float:
        """The time at which it happened last."""
        return self.at_s if self.last_s is None else self.last_s

    def wall_at(self, at_s: float) -> datetime:
        """Return the time of day at another moment, if it was not set since."""
        return self.wall + timedelta(seconds=at_s - self.at_s)


class EventLog:
    """The newest entries; a changed entry keeps its number.

    One thread writes, any thread reads. Each addition and each change has a revision; a reader asks
    for everything newer than the last revision it has seen.

    Args:
        most: The most entries kept.
    """

    def __init__(self, most: int = MOST_ENTRIES) -> None:
        self._most = most
        self._lock = threading.Lock()
        self._entries: OrderedDict[int, EventEntry] = OrderedDict()
        self._revisions: OrderedDict[int, int] = OrderedDict()
        self._revision = 0
        self._number = 0
        self._repeats: OrderedDict[Hashable, int] = OrderedDict()

    @property
    def revision(self) -> int:
        """The revision of the newest change."""
        return self._revision

    @property
    def newest(self) -> int:
        """The number of the newest entry; 0 if there is none."""
        return self._number

    @property
    def oldest(self) -> int:
        """The number of the oldest kept entry; 1 if there is none."""
        with self._lock:
            return next(iter(self._entries), 1)

    def entries(self) -> list[EventEntry]:
        """Return all kept entries, the oldest first."""
        with self._lock:
            return list(self._entries.values())

    def snapshot(self) -> tuple[int, list[EventEntry]]:
        """Return the same as `since` from the beginning, with less work."""
        with self._lock:
            return self._revision, list(self._entries.values())

    def get(self, number: int) -> EventEntry | None:
        """Return an entry by its number, or ``None`` if it was dropped or never existed."""
        with self._lock:
            return self._entries.get(number)

    def since(self, revision: int) -> tuple[int, list[EventEntry]]:
        """Return the entries added or changed after a revision.

        Returns:
            The revision to pass the next time, and the present entries, by number.
        """
        with self._lock:
            numbers: list[int] = []
            for number, changed in reversed(self._revisions.items()):
                if changed <= revision:
                    break
                numbers.append(number)
            return self._revision, [self._entries[number] for number in sorted(numbers)]

    # The writing thread -----------------------------------------------------------------------

    def add(
        self, *, repeat_key: Hashable = None, within_s: float = REPEAT_S, **what: Any
    ) -> EventEntry:
        """Add an event, or count it if it repeats a recent one.

        Args:
            repeat_key: Equal for an event and its repeats; with ``None`` it is never a repeat.
            within_s: A later event is no repeat.
            **what: The fields of `EventEntry`, but for its number.
        """
        with self._lock:
            at_s: float = what["at_s"]
            before = self._repeated(repeat_key, at_s, within_s)
            if before is not None:
                count = before.count + int(what.get("count", 1))
                entry = replace(
                    before,
                    count=count,
                    last_s=at_s,
                    params=what.get("params", before.params),
                    level=what["level"],
                    ended_s=what.get("ended_s"),
                    unheard=False,
                    answer=None,
                    result=None,
                )
            else:
                self._number += 1
                entry = EventEntry(number=self._number, **what)
                if repeat_key is not None:
                    self._repeats[repeat_key] = entry.number
                    if len(self._repeats) > self._most:
                        self._repeats.popitem(last=False)
            self._put(entry)
            return entry

    def _repeated(self, repeat_key: Hashable, at_s: float, within_s: float) -> EventEntry | None:
        if repeat_key is None:
            return None
        before = self._entries.get(self._repeats.get(repeat_key, 0))
        if before is None or before.goes_on or before.unheard:
            return None
        ended_s = before.newest_s if before.ended_s is None else before.ended_s
        again = at_s - ended_s <= within_s and at_s - before.at_s <= REPEATS_SPAN_S
        return before if again else None

    def change(self, number: int, **changes: Any) -> EventEntry | None:
        """Change an entry, and return it; ``None`` if it is not kept any more.

        Args:
            number: Its number.
            **changes: Fields of `EventEntry` and their new values.
        """
        with self._lock:
            before = self._entries.get(number)
            if before is None:
                return None
            entry = replace(before, **changes)
            if entry != before:
                self._put(entry)
            return entry

    def _put(self, entry: EventEntry) -> None:
        self._revision += 1
        self._entries[entry.number] = entry
        self._revisions[entry.number] = self._revision
        self._revisions.move_to_end(entry.number)
        while len(self._entries) > self._most:
            oldest, _entry = self._entries.popitem(last=False)
            del self._revisions[oldest]
