"""Writes the event log from the program's notices, the arm's reports and command outcomes."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final

from armui.control.authority_watch import LEADER_ARM_MOVES, OTHER_HOST_GONE, OTHER_HOST_MOVES
from armui.control.context import REFUSED, ControllerPart
from armui.control.event_log.observed import Observed
from armui.control.event_log.observer import EventObserver
from armui.control.event_log.status_listener import StatusListener
from armui.control.event_log.writer import EventWriter
from armui.control.events import Event, Notice
from armui.control.link.connection import (
    BUS_BLOCKED,
    BUS_DEAF_NOTICE,
    BUS_HEARS,
    BUS_UNBLOCKED,
    DISCONNECTED,
    LINK_LOST_NOTICE,
    RECONNECTED,
)
from armui.control.link.link_watch import OFFLINE_BUSY
from armui.control.link.model_watch import MODEL_NONE, MODEL_OTHER_NOTICE
from armui.control.motion.motion_command import CommandKind
from armui.control.requests.reports import OFFLINE_NOTICE, ONLINE
from armui.telemetry.events import Asker, EventEntry, EventKind, EventLog, Level

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.control.context import Context
    from armui.control.operations.started import Started
    from armui.control.run.player import Player
    from armui.control.safety.recovery import Recovery

RUN_POINT = Observed("run_point", "Sent the point of row {row}")
PROBLEM = Observed("problem", "{reason}")
NOT_KEPT = Observed(
    "not_kept", "The events cannot be written to the disk; the newest are kept in memory. {text}"
)

_GONE: Final = frozenset({LINK_LOST_NOTICE, DISCONNECTED})
_LASTING: Final[Mapping[Notice, frozenset[Notice]]] = {
    OFFLINE_NOTICE: _GONE | {ONLINE},
    OFFLINE_BUSY: _GONE | {ONLINE},
    LINK_LOST_NOTICE: frozenset({RECONNECTED, DISCONNECTED}),
    BUS_BLOCKED: _GONE | {BUS_UNBLOCKED, BUS_DEAF_NOTICE},
    BUS_DEAF_NOTICE: _GONE | {BUS_HEARS, BUS_BLOCKED},
    MODEL_OTHER_NOTICE: _GONE,
    MODEL_NONE: _GONE,
    OTHER_HOST_MOVES: _GONE | {OTHER_HOST_GONE},
    LEADER_ARM_MOVES: _GONE | {OTHER_HOST_GONE},
}
"""The notices that begin something lasting, each with the notices that end it."""
_MOST_ENDED: Final = 8
"""The ended commands that are kept; the arm may answer after its feedback shows the effect."""


class EventCollector(ControllerPart):
    """Collects the events; a part of the controller that acts after the others.

    It knows the arm by what was heard, and the time by the clocks it is given: the same log,
    played again, gives the same events.

    Args:
        context: The context that the controller's parts share.
        wall: Returns the local time of a monotonic time.
        player: Knows the point of a run that was sent last.
        recovery: Knows whether a command is its own.

    Attributes:
        log: The events.
    """

    def __init__(
        self,
        context: Context,
        wall: Callable[[float], datetime],
        player: Player,
        recovery: Recovery,
    ) -> None:
        self.log = EventLog()
        self._context = context
        self._writer = EventWriter(self.log, wall)
        self._player = player
        self._recovery = recovery
        self._listener = StatusListener()
        self._observer = EventObserver()
        self._followed: dict[int, Started] = {}
        self._lasting: dict[Notice, int] = {}
        self._run_point = 0
        self._newest: tuple[Event, int] | None = None
        context.connection.add_listener(self._listener)

    def number_of(self, event: Event) -> int | None:
        """Return the number of the newest notice's entry; ``None`` for any other event."""
        return self._newest[1] if self._newest is not None and self._newest[0] is event else None

    def on_problem(self, reason: Refusal) -> EventEntry:
        """Add an event for a problem of the program itself, and return its entry."""
        return self._warn(PROBLEM, (PROBLEM, str(reason)), {"reason": reason})

    def on_not_kept(self, text: str | None) -> EventEntry:
        """Add an event for a failed write of the events, with the system's text, if any."""
        return self._warn(NOT_KEPT, NOT_KEPT, {} if text is None else {"text": text})

    def _warn(self, what: Observed, key: Hashable, params: Mapping[str, object]) -> EventEntry:
        kind, who = EventKind.PROGRAM, Asker.PROGRAM
        return self._add(what, kind, who, Level.WARNING, params=params, repeat_key=key)

    # A part of the controller -----------------------------------------------------------------

    def follow_arm(self) -> None:
        """Take in the feedback and the outcomes of commands."""
        self._take_in()
        self._take_results()
        self._note_point()

    def forget_arm(self) -> None:
        """Close what was going on as not heard to end, because the arm is gone."""
        self._take_in()
        for change in self._observer.forget(self._context.clock()):
            self._writer.write(change)

    # Notices ----------------------------------------------------------------------------------

    def on_noticed(self, event: Event) -> None:
        """Add a notice that the operator is told."""
        self._take_in()  # keep the order of time: earlier feedback first
        self._take_results()
        notice, params = event.notice, dict(event.params)
        now_s = self._context.clock()
        for lasting in [each for each, ends in _LASTING.items() if notice in ends]:
            number = self._lasting.pop(lasting, None)
            if number is not None:
                self.log.change(number, ended_s=now_s)
        if notice in self._lasting:
            self._newest = event, self._lasting[notice]
            return
        repeat_key: Hashable = None
        if notice.streams:
            repeat_key = notice
        elif notice == REFUSED or notice.kind is EventKind.PROGRAM:
            repeat_key = (notice, repr(sorted(params.items(), key=lambda each: each[0])))
        by_recovery = notice.kind is EventKind.COMMAND and self._recovery.acts
        entry = self._add(
            notice,
            notice.kind,
            Asker.RECOVERY if by_recovery else notice.who,
            event.level,
            at_s=now_s,
            wall=event.at,
            params=params,
            repeat_key=repeat_key,
            lasts=notice in _LASTING,
        )
        self._newest = event, entry.number
        if notice in _LASTING:
            self._lasting[notice] = entry.number
        if event.started is not None:
            self._followed[entry.number] = event.started

    def _take_results(self) -> None:
        """Write down the outcomes of commands since the last call."""
        for number, started in self._followed.items():
            self.log.change(number, answer=started.answer, result=started.result)
        ended = [number for number, each in self._followed.items() if each.ending is not None]
        for number in ended[:-_MOST_ENDED]:
            del self._followed[number]

    def _note_point(self) -> None:
        """Write down the point of a run that was sent."""
        own = self._context.authority.command
        runs = own is not None and own.kind is CommandKind.RUN and self._player.running
        if own is None or not runs or own.number == self._run_point:
            return
        self._run_point = own.number
        entry = self._add(
            RUN_POINT,
            EventKind.COMMAND,
            Asker.RUN,
            Level.INFO,
            at_s=own.sent_s,
            params={"row": self._player.progress.index + 1},
            repeat_key=RUN_POINT,
        )
        if own.started is not None:
            self._followed[entry.number] = own.started

    # Feedback ---------------------------------------------------------------------------------

    def _take_in(self) -> None:
        connection = self._context.connection
        if connection.device is None:
            return
        changes = self._observer.observe(
            self._listener.take_changes(),
            connection.newest,
            connection.traffic,
            self._context.clock(),
        )
        for change in changes:
            self._writer.write(change)

    def _add(
        self, what: Notice | Observed, kind: EventKind, who: Asker, level: Level, **more: Any
    ) -> EventEntry:
        """Add what happens now, unless ``more`` says when; see `EventWriter.add`."""
        more.setdefault("at_s", self._context.clock())
        return self._writer.add(what, kind, who, level, **more)
