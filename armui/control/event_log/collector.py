"""Writes the event log: what the program tells, what the arm says, what becomes of commands."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from datetime import datetime
from typing import TYPE_CHECKING, Any, Final

from armui.control.context import ControllerPart
from armui.control.event_log.commands import (
    COMMANDS,
    JOGS,
    LASTING,
    MOTION,
    STREAMS,
    kind_of,
    who_of,
)
from armui.control.event_log.followed import Followed, FollowedCommands
from armui.control.event_log.heard import StatusTap
from armui.control.event_log.observed import ObservedCode
from armui.control.event_log.observer import EventObserver
from armui.control.event_log.writer import EventWriter
from armui.control.events import Event, EventCode
from armui.control.motion.motion_command import CommandKind, End, MotionCommand
from armui.telemetry.events import (
    Asker,
    EventEntry,
    EventKind,
    EventLog,
    EventOutcome,
    Level,
)

if TYPE_CHECKING:
    from armui.arm.refusal import Refusal
    from armui.control.context import Context
    from armui.control.run.player import Player
    from armui.control.safety.recovery import Recovery
    from armui.protocol.codec import Message

_SETS_OUT_S: Final = 1.0
"""A jog that has sent nothing by then never will."""
_CUT_LEVELS: Final = {End.REPLACED: Level.INFO, End.CANCELLED: Level.INFO}


class EventCollector(ControllerPart):
    """A part of the controller; it acts after the others.

    It knows the arm by what was heard, and the time by the clocks it is given: the same log,
    played again, gives the same events.

    Args:
        context: What the parts of the controller share.
        wall: What the clock on the wall showed at a monotonic time.
        player: Knows which point of a run was sent last.
        recovery: Knows whether a command is its own.

    Attributes:
        log: What has happened.
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
        self._tap = StatusTap()
        self._observer = EventObserver()
        self._followed = FollowedCommands()
        self._lasting: dict[EventCode, int] = {}
        self._run_point = 0
        self._told: tuple[Event, int] | None = None
        context.connection.add_tap(self._tap)
        context.connection.answered.connect(self._on_answered)

    def number_of(self, event: Event) -> int | None:
        """The entry of the newest notice; ``None`` of any other."""
        return self._told[1] if self._told is not None and self._told[0] is event else None

    def on_problem(self, reason: Refusal) -> EventEntry:
        """Something stood in the program's own way."""
        return self._add(
            ObservedCode.PROBLEM,
            EventKind.PROGRAM,
            Asker.PROGRAM,
            Level.WARNING,
            params={"reason": reason},
            fold=(ObservedCode.PROBLEM, str(reason)),
        )

    def on_not_kept(self, text: str | None) -> EventEntry:
        """The events cannot be written: what the system says of it, or ``None``: no answer."""
        return self._add(
            ObservedCode.NOT_KEPT,
            EventKind.PROGRAM,
            Asker.PROGRAM,
            Level.WARNING,
            params={} if text is None else {"text": text},
            fold=ObservedCode.NOT_KEPT,
        )

    # A part of the controller -----------------------------------------------------------------

    def advance(self) -> None:
        """Take in what was heard, and see what has become of our motions."""
        self._take_in()
        self._follow_motions()

    def forget(self) -> None:
        """The arm is gone: what went on was not heard to end."""
        self._take_in()
        for change in self._observer.forget(self._context.clock()):
            self._writer.write(change)
        for followed in self._followed.motions():
            self._end_motion(followed, End.FORGOTTEN)
        self._followed.forget()

    # What is told -----------------------------------------------------------------------------

    def on_noticed(self, event: Event) -> None:
        """The operator is told an event."""
        self._take_in()  # what was heard before stands before
        code, params = event.code, dict(event.params)
        now_s = self._context.clock()
        for lasting in [each for each, ends in LASTING.items() if code in ends]:
            number = self._lasting.pop(lasting, None)
            if number is not None:
                self.log.change(number, ended_s=now_s)
        command = self._followed.on_notice(code, params)
        if command is not None:
            outcome = EventOutcome(code, now_s, event.level, params)
            self.log.change(command.number, result=outcome)
        if code in self._lasting:
            self._told = event, self._lasting[code]
            return
        fold: Hashable = None
        if code in STREAMS:
            fold = code
        elif code == EventCode.REFUSED or kind_of(code) is EventKind.PROGRAM:
            fold = (code, repr(sorted(params.items(), key=lambda each: each[0])))
        entry = self._add(
            code,
            kind_of(code),
            Asker.RECOVERY if code in COMMANDS and self._recovery.acts else who_of(code),
            event.level,
            at_s=now_s,
            wall=event.at,
            params=params,
            fold=fold,
            lasts=code in LASTING,
        )
        self._told = event, entry.number
        if code in LASTING:
            self._lasting[code] = entry.number
        if code in COMMANDS:
            rule = COMMANDS[code]
            own = self._context.authority.command if rule.moves and code not in JOGS else None
            self._followed.begin(rule, entry, None if own is None else own.number)

    def _on_answered(self, answer: Message) -> None:
        if answer.name != "SettingResponse":
            return
        now_s, index = self._context.clock(), int(answer.signals["Index"])
        followed = self._followed.on_answer(index, now_s)
        if followed is not None:
            outcome = EventOutcome(
                ObservedCode.ANSWERED, now_s, Level.DONE, {"index": f"0x{index:02X}"}
            )
            self.log.change(followed.number, answer=outcome)

    def _follow_motions(self) -> None:
        """Whether our motions have arrived, or what ended them; and the points of a run."""
        authority = self._context.authority
        own = authority.command
        for followed in self._followed.motions():
            if followed.motion is None:
                self._await_jog(followed, own)
            elif own is not None and own.number == followed.motion:
                if not authority.under_way and not authority.holds:
                    self._end_motion(followed, None)
            else:
                self._end_motion(followed, authority.ended or End.REPLACED)
        runs = own is not None and own.kind is CommandKind.RUN and self._player.running
        if own is not None and runs and own.number != self._run_point:
            self._run_point = own.number
            entry = self._add(
                ObservedCode.RUN_POINT,
                EventKind.COMMAND,
                Asker.RUN,
                Level.INFO,
                at_s=own.sent_s,
                params={"row": self._player.progress.index + 1},
                fold=ObservedCode.RUN_POINT,
            )
            self._followed.begin(MOTION, entry, own.number)

    def _await_jog(self, followed: Followed, own: MotionCommand | None) -> None:
        """A held button sends its first setpoint a moment after it was pressed."""
        if own is not None and own.kind is CommandKind.JOG and own.sent_s >= followed.sent_s:
            self._followed.set_out(followed, own.number)
        elif self._context.clock() - followed.sent_s > _SETS_OUT_S:
            self._followed.end(followed)

    def _end_motion(self, followed: Followed, end: End | None) -> None:
        """Note how a motion ended; ``None``: it came to rest by itself."""
        now_s, status = self._context.clock(), self._context.state().status
        if end is None and status is not None and status.value.reached:
            outcome = EventOutcome(ObservedCode.ARRIVED, now_s, Level.DONE)
        else:
            level = Level.WARNING if end is None else _CUT_LEVELS.get(end, Level.WARNING)
            name = "short" if end is None else end.name
            outcome = EventOutcome(ObservedCode.MOTION_CUT, now_s, level, {"end": name})
        self._followed.end(followed)
        self.log.change(followed.number, result=outcome)

    # What is heard ----------------------------------------------------------------------------

    def _take_in(self) -> None:
        connection = self._context.connection
        if connection.device is None:
            return
        changes = self._observer.observe(
            self._tap.take(), connection.newest, connection.traffic, self._context.clock()
        )
        for change in changes:
            self._writer.write(change)

    def _add(
        self,
        code: str,
        kind: EventKind,
        who: Asker,
        level: Level,
        *,
        at_s: float | None = None,
        wall: datetime | None = None,
        **more: Any,
    ) -> EventEntry:
        at_s = self._context.clock() if at_s is None else at_s
        return self._writer.add(code, kind, who, level, at_s=at_s, wall=wall, **more)
