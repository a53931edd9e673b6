"""Writes observed events into an event log: beginning, growth and end: pure."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from datetime import datetime
from typing import Any, Final

from armui.control.event_log.observed import EventChange, EventPhase, Observed
from armui.control.events import Notice
from armui.telemetry.events import REPEAT_S, Asker, EventEntry, EventKind, EventLog, Level

_MOST_KEYS: Final = 1_000
_FLOWS_S: Final = 1.0
"""Commands of a held button or a slider follow each other faster than this."""


class EventWriter:
    """Writes into an event log and knows the entry of each lasting event.

    Args:
        log: The event log.
        wall: Returns the local time of a time of the log.
    """

    def __init__(self, log: EventLog, wall: Callable[[float], datetime]) -> None:
        self._log = log
        self._wall = wall
        self._numbers: dict[Hashable, tuple[int, int]] = {}

    def add(
        self,
        what: Notice | Observed,
        kind: EventKind,
        who: Asker,
        level: Level,
        *,
        at_s: float,
        wall: datetime | None = None,
        **more: Any,
    ) -> EventEntry:
        """Add an event and return its entry.

        ``more`` are further fields of `EventEntry`, and ``repeat_key`` of `EventLog.add`.
        """
        wall = self._wall(at_s) if wall is None else wall
        return self._log.add(
            within_s=_FLOWS_S if what.streams else REPEAT_S,
            at_s=at_s,
            wall=wall,
            level=level,
            kind=kind,
            who=who,
            code=what.id,
            **more,
        )

    def write(self, change: EventChange) -> None:
        """Write a change of an observed event."""
        if change.observed is None:
            self._go_on(change)
            return
        entry = self.add(
            change.observed,
            change.kind,
            change.who,
            change.level,
            at_s=change.at_s,
            params=change.params,
            count=change.count,
            lasts=change.phase is EventPhase.BEGAN,
            repeat_key=None
            if change.phase is EventPhase.HAPPENED
            else (change.observed, change.key),
        )
        self._numbers.pop(change.key, None)
        self._numbers[change.key] = entry.number, entry.count - change.count
        if len(self._numbers) > _MOST_KEYS:
            del self._numbers[next(iter(self._numbers))]

    def _go_on(self, change: EventChange) -> None:
        known = self._numbers.get(change.key)
        if known is None:
            return
        number, counted_before = known
        changes: dict[str, Any] = {"count": counted_before + change.count}
        if change.phase is EventPhase.ENDED:
            del self._numbers[change.key]
            changes |= {"ended_s": change.at_s, "unheard": change.unheard}
        if change.params:
            changes["params"] = change.params
        if change.count > 1:
            changes["last_s"] = change.at_s
        self._log.change(number, **changes)
