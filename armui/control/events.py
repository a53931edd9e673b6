"""The notices that the program gives to the operator, as data."""

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
"""The source of the events of each kind; for failures it is the program."""


@dataclass(frozen=True, slots=True)
class Notice(Sentence):
    """A sentence for an event; the constant is called ``NAME_NOTICE`` if its id is taken.

    Attributes:
        level: The severity.
        kind: The kind of event.
        asker: The party that asked for it or reports it, where the kind does not determine that.
        streams: True if it repeats while something is dragged or held: it is counted, and the
            newest figures are kept.
    """

    context: ClassVar[str] = "Notice"
    level: Level = field(default=Level.INFO, compare=False, repr=False)
    kind: EventKind = field(default=EventKind.PROGRAM, compare=False, repr=False)
    asker: Asker | None = field(default=None, compare=False, repr=False)
    streams: bool = field(default=False, compare=False, repr=False)

    @property
    def who(self) -> Asker:
        """The party that asked for the event, or reports it."""
        failed = self.kind is EventKind.RESULT and self.level is Level.FAULT
        return self.asker or (Asker.PROGRAM if failed else _WHO[self.kind])


@dataclass(frozen=True, slots=True)
class Event:
    """An event with its time and its figures.

    Attributes:
        at: The local time.
        notice: The sentence of the event.
        params: The figures of the sentence.
        started: The command whose beginning it is.
    """

    at: datetime
    notice: Notice
    params: Mapping[str, object] = field(default_factory=dict)
    started: Started | None = None

    @property
    def level(self) -> Level:
        """The severity, which its notice sets."""
        return self.notice.level

    @property
    def code(self) -> str:
        """The notice's id, as the event log and its files keep it."""
        return self.notice.id
