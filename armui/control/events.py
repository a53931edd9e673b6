"""What the program tells the operator, as data: each sentence stands beside what tells it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import TYPE_CHECKING, ClassVar, Final

from armui.system.sentence import Sentence
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.control.operations.started import Started

__all__ = ["Event", "Level", "Notice"]


_WHO: Final = {
    EventKind.COMMAND: Asker.OPERATOR,
    EventKind.RESULT: Asker.ARM,
    EventKind.STATUS: Asker.ARM,
    EventKind.LINK: Asker.PROGRAM,
    EventKind.OTHER_HOST: Asker.OTHER_HOST,
    EventKind.ODDITY: Asker.PROGRAM,
    EventKind.PROGRAM: Asker.PROGRAM,
}
"""Who says an event of a kind; that something has failed the program says."""


@dataclass(frozen=True, slots=True)
class Notice(Sentence):
    """Something that happened and is told; ``NAME_NOTICE`` where another sentence has its id.

    Attributes:
        level: How grave it is.
        kind: What sort of event it is.
        asker: Who asked for it, or says it, where the kind does not tell that.
        streams: It comes one after the other while something is dragged or held: it is counted, and
            the newest figures stand.
    """

    context: ClassVar[str] = "Notice"
    level: Level = field(default=Level.INFO, compare=False, repr=False)
    kind: EventKind = field(default=EventKind.PROGRAM, compare=False, repr=False)
    asker: Asker | None = field(default=None, compare=False, repr=False)
    streams: bool = field(default=False, compare=False, repr=False)

    @property
    def who(self) -> Asker:
        """Who asked for it, or says it."""
        failed = self.kind is EventKind.RESULT and self.level is Level.FAULT
        return self.asker or (Asker.PROGRAM if failed else _WHO[self.kind])


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened, with its time and its figures.

    Attributes:
        at: Local time.
        notice: What happened.
        params: The figures of the sentence.
        started: The command that it tells the beginning of.
    """

    at: datetime
    notice: Notice
    params: Mapping[str, object] = field(default_factory=dict)
    started: Started | None = None

    @property
    def level(self) -> Level:
        """How grave it is."""
        return self.notice.level

    @property
    def code(self) -> str:
        """The notice's id, as the event log and its files keep it."""
        return self.notice.id
