"""What happened, as a recording keeps it: read from the log of events."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from armui.control.events import EventCode, Level
from armui.session.session import MarkKind
from armui.telemetry.event_json import to_json
from armui.telemetry.events import EventKind

if TYPE_CHECKING:
    from armui.telemetry.events import EventEntry, EventLog

_STOPS: Final = frozenset(
    {
        EventCode.STOP_SENT.value,
        EventCode.STOP_CONFIRMED.value,
        EventCode.STOP_UNDONE.value,
        EventCode.STOP_UNCONFIRMED.value,
        EventCode.HALT_SENT.value,
    }
)


@dataclass(frozen=True, slots=True)
class FedEvent:
    """Something that happened.

    Attributes:
        at_s: By the program's clock.
        mark: What sort of moment it is.
        entry: JSON values, as a line of the sidecar has them.
        is_new: It has just happened; not so if only its end, or a repeat, was noted.
    """

    at_s: float
    mark: MarkKind
    entry: Mapping[str, object]
    is_new: bool


class EventFeed:
    """Follows the log of events.

    Args:
        log: What happens.
    """

    def __init__(self, log: EventLog) -> None:
        self._log = log
        self._revision = self._newest = 0

    def take_events(self) -> list[FedEvent]:
        """What has happened, or has changed, since the last call."""
        self._revision, entries = self._log.since(self._revision)
        newest = self._newest
        self._newest = self._log.newest
        return [
            FedEvent(each.at_s, _mark_of(each), json.loads(to_json(each)), each.number > newest)
            for each in entries
        ]


def _mark_of(entry: EventEntry) -> MarkKind:
    if entry.code in _STOPS:
        return MarkKind.STOP
    if entry.kind is EventKind.FAULT or entry.level is Level.FAULT:
        return MarkKind.FAULT
    return MarkKind.COMMAND if entry.kind is EventKind.COMMAND else MarkKind.NOTE
