"""What the event log says beside the notices: what was seen to begin, to go on and to end."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field
from enum import Enum, auto
from typing import ClassVar

from armui.system.sentence import Sentence
from armui.telemetry.events import Asker, EventKind, Level


@dataclass(frozen=True, slots=True)
class Observed(Sentence):
    """Something that was seen to happen; what the program tells is a `Notice`.

    Attributes:
        streams: It comes again and again, and is counted only while it does so at once.
    """

    context: ClassVar[str] = "Observed"
    streams: bool = field(default=False, compare=False, repr=False)


class EventPhase(Enum):
    """What of an event is told."""

    BEGAN = auto()
    """It goes on until it has ended."""
    ENDED = auto()
    GREW = auto()
    """It happened more often, or has other figures by now."""
    HAPPENED = auto()


@dataclass(frozen=True, slots=True)
class EventChange:
    """What was observed.

    Attributes:
        phase: Which part of it this is.
        key: What is the same in its beginning and its end.
        at_s: Monotonic time.
        observed: What it is; this and the rest are told with its beginning.
        kind: What sort it is.
        who: Whose word it is.
        level: How grave it is.
        params: The figures of its sentence.
        count: How often; of what grew, all of it.
        unheard: Of an end: it was not heard.
    """

    phase: EventPhase
    key: Hashable
    at_s: float
    observed: Observed | None = None
    kind: EventKind = EventKind.STATUS
    who: Asker = Asker.ARM
    level: Level = Level.INFO
    params: Mapping[str, object] = field(default_factory=dict)
    count: int = 1
    unheard: bool = False
