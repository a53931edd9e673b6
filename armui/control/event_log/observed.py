"""Observations in the event log beside the notices: each begins, may grow, and ends."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, field
from enum import Enum, auto
from typing import ClassVar

from armui.system.sentence import Sentence
from armui.telemetry.events import Asker, EventKind, Level


@dataclass(frozen=True, slots=True)
class Observed(Sentence):
    """An observed event's sentence; for messages of the program there is `Notice`.

    Attributes:
        streams: True if it repeats in quick succession and is only counted while it does.
    """

    context: ClassVar[str] = "Observed"
    streams: bool = field(default=False, compare=False, repr=False)


class EventPhase(Enum):
    """The phase of an observed event."""

    BEGAN = auto()
    """The event has begun and goes on until it has ended."""
    ENDED = auto()
    GREW = auto()
    """The event has happened more often, or its figures have changed."""
    HAPPENED = auto()


@dataclass(frozen=True, slots=True)
class EventChange:
    """A change of an observed event.

    Attributes:
        phase: The phase that has begun.
        key: The key that its beginning and its end share.
        at_s: Monotonic time.
        observed: The event's sentence; this and the following are given with the beginning.
        kind: The kind of event.
        who: The source of the report.
        level: The severity.
        params: The figures of its sentence.
        count: The number of times; for growth, the total.
        unheard: True if the end was not heard.
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
