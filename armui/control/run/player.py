"""【发送】: runs a trajectory point by point, each followed until the arm has arrived."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import astuple, replace
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject

from armui.arm.refusal import Reason, Refusal
from armui.control.events import Notice
from armui.control.motion.joint_motion import COME_INSIDE_PERCENT
from armui.control.motion.motion_command import CommandKind
from armui.control.motion.motion_context import MotionContext
from armui.control.motion.point_frames import (
    action_frames,
    point_frames,
    point_way,
    tool_way,
    why_not_possible,
)
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import Consent, declare, operation, record_start
from armui.control.operations.started import Ending, Started
from armui.control.parameters.planning_model import planning_model
from armui.control.run.arrival import Arrival, ArrivalWatch
from armui.control.run.execution import RUN_DONE, RUN_STARTED, UNKNOWN_FOR_S, Execution
from armui.control.run.progress import (
    ENDLESS,
    Progress,
    Run,
    RunPhase,
    RunSchedule,
    capped_percent,
    sent_percent,
)
from armui.control.run.replay import RUN_EMPTY
from armui.control.safety.feedback_freshness import FEEDBACK_SILENT
from armui.control.safety.gate import MotionRequest
from armui.control.safety.interlocks import SPEED_ZERO
from armui.protocol.codes import MoveMode
from armui.telemetry.events import Asker, EventKind, Level
from armui.trajectory.points.program import GripperAction, Waypoint

if TYPE_CHECKING:
    from armui.arm.models import ArmModel

RUN_SPEED_ZERO = Reason(
    "run_speed_zero", "The speed is 0 %: raise it at the top, then hold “Continue” for 1 s."
)
NOT_PAUSED = Reason("not_paused", "No trajectory is paused: nothing to continue.")
NOT_RUNNING = Reason("not_running", "No trajectory is running: nothing to pause.")
RUN_TOO_SLOW = Reason(
    "run_too_slow", "The point was not reached within {seconds} s. See what keeps the arm."
)
RUN_NOT_ENDED = Reason(
    "run_not_ended",
    "The arm was told to end its motion and still moves. Press the emergency stop if it must not.",
)
RUN_NO_SUCH_ROW = Reason(
    "run_no_such_row", "There is no row {row}: the last one is {maximum}. Choose another row."
)
RUN_FROM_OUTSIDE = Notice(
    "run_from_outside",
    "The arm lies outside its limits: it is brought inside first, slowly.",
    Level.INFO,
    EventKind.COMMAND,
)
RUN_PAUSED = Notice("run_paused", "Run pauses in row {row}", Level.INFO, EventKind.COMMAND)
RUN_CONTINUED = Notice("run_continued", "Run continues in row {row}", Level.INFO, EventKind.COMMAND)
RUN_ENDED = Notice(
    "run_ended",
    "Run ended in row {row}; the arm is at rest.",
    Level.INFO,
    EventKind.RESULT,
    Asker.RUN,
)
RUN_FAILED = Notice(
    "run_failed", "Run ended in row {row}. {reason}", Level.FAULT, EventKind.RESULT, Asker.RUN
)


_INSIDE_WITHIN_S: Final = 60.0
"""The longest time for the slow way of an arm outside its limits back inside."""
_REST_WITHIN_S: Final = 2.0
"""An arm told to end its motion stands within this time, or the operator is warned."""


def why_not_run(now: OperatingState) -> Refusal | None:
    """Return why no trajectory may be run now, whichever it is, or ``None``."""
    zero = SPEED_ZERO() if now.speed_percent == 0 else None
    return now.occupied or now.cannot_run or now.model_fit.wrong or zero


def why_not_go_on(now: OperatingState) -> Refusal | None:
    """Return why the run that is paused cannot go on, or ``None``."""
    if now.running and now.speed_percent == 0:
        return RUN_SPEED_ZERO()
    return now.cannot_run if now.running else NOT_PAUSED()


def why_not_pause(now: OperatingState) -> Refusal | None:
    """Return why nothing can be paused, or ``None``."""
    return None if now.running else NOT_RUNNING()


class Player(Execution):
    """Carries out one run at a time; the arm's feedback triggers each step.

    Args:
        context: The context that the controller's parts share.

    Attributes:
        as_asked: Returns a point's action with what the gripper is to be asked for.
        note_held: Takes the name of what the hand holds from a point on; "" for nothing.
    """

    def __init__(self, context: MotionContext, parent: QObject | None = None) -> None:
        super().__init__(context, parent)
        self.as_asked: Callable[[GripperAction | None], GripperAction | None] = lambda same: same
        self.note_held: Callable[[str], object] = lambda _name: None
        self._run: Run | None = None
        self._schedule: RunSchedule | None = None
        self._has_lights = False
        self._paused_phase = RunPhase.IDLE
        self._paused_s = 0.0
        self._looked_s = 0.0
        self._index = 0
        self._cycle = 1
        self._watch: ArrivalWatch | None = None
        self._way_in: list[Waypoint] = []
        self._owed, self._due_s = False, 0.0

    @property
    def sets_lamps(self) -> bool:
        """True if the run under way signals by the lamps."""
        return self.running and self._has_lights

    @property
    def rows(self) -> Sequence[Waypoint]:
        """The points of the run, or of the last one, as their table had them as it began."""
        return () if self._run is None else self._run.rows or self._run.points

    # What the operator wants ------------------------------------------------------------------

    @operation("run.start", "Run a trajectory", why_not_run, moves=True, shown_first=True)
    def start(self, started: Started, run: Run) -> Refusal | None:
        """Begin a run."""
        context = self._context
        refusal = _why_empty(run) or why_not_possible(context.connection.generation, run.points)
        if refusal is not None:
            return refusal
        self._run, self._schedule = run, RunSchedule(run)
        # Determined once, because it is needed at every tick and a run may have 10,000 points.
        self._has_lights = any(point.light for point in run.points)
        self._index, self._cycle = run.first, 1
        self.speed_percent = run.speed_percent
        self._way_in = [
            Waypoint(MoveMode.MOVE_J, target_deg, speed_percent=COME_INSIDE_PERCENT)
            for target_deg in context.gate().ways_inside()
        ]
        self._started = started
        context.emit_event(RUN_STARTED, started, name=run.name)
        if self._way_in:
            context.emit_event(RUN_FROM_OUTSIDE)
        self._send_point()
        return None

    @operation("run.pause", "Pause the run", why_not_pause)
    def pause(self, started: Started) -> Refusal | None:
        """Have the arm stop where it is and keep its motion (0x150 byte 1 = 1)."""
        if self._phase not in {RunPhase.MOVING, RunPhase.DWELLING}:
            return NOT_RUNNING()
        if self._phase is RunPhase.MOVING:
            self._hold_back(sent=self._watch is not None)
        self._paused_phase, self._phase = self._phase, RunPhase.PAUSED
        self._paused_s = self._context.clock()
        self._await_hold()
        started.close(Ending.SENT)
        self._context.emit_event(RUN_PAUSED, started, row=self._index + 1)
        self._publish()
        return None

    @declare("run.go_on", "Continue the run", why_not_go_on, moves=True, consent=Consent.HELD)
    def go_on(self) -> Started | Refusal | None:
        """End a pause (0x150 byte 1 = 2), or take the next step, which has no record of its own."""
        phase = self._phase
        if phase not in {RunPhase.WAITING, RunPhase.PAUSED}:
            return self._context.refuse(NOT_PAUSED())
        refusal = why_not_go_on(self._context.refresh())
        waits = phase is RunPhase.WAITING
        if refusal is not None and not (waits and refusal.reason != RUN_SPEED_ZERO):
            return self._context.refuse(refusal)
        self._context.begun("run.go_on")
        if self._phase is not phase:  # `begun` may have ended a client's run
            return self._context.refuse(NOT_PAUSED())
        if waits:
            self._next_point()
            return None
        unsent = self._paused_phase is RunPhase.MOVING and self._watch is None
        if self._paused_phase is RunPhase.MOVING and not unsent:
            refusal = self._let_go_on(self._percent)
            if refusal is not None:
                return self._context.refuse(refusal)
        self._phase = self._paused_phase
        self._since_s += self._context.clock() - self._paused_s
        self._looked_s = self._context.clock()
        started = record_start(self.go_on)
        started.close(Ending.SENT)
        self._context.emit_event(RUN_CONTINUED, started, row=self._index + 1)
        if unsent:
            self._send_point()
        self._publish()
        return started

    def why_not_at(self, _percent: int) -> Refusal | None:
        """Return ``None``: a run was checked at 100 %."""
        return None

    def set_speed(self, percent: int) -> None:
        """Set the share of the points' speeds; the arm is told at once, even in mid-motion."""
        self._keep_time()
        self.speed_percent = percent
        if percent == 0 and self._phase in {RunPhase.MOVING, RunPhase.DWELLING}:
            self.pause()
        elif self._phase is RunPhase.MOVING:
            self.send_speed()
        if self.running:
            self._publish()

    def send_speed(self) -> None:
        """Send the speed of the point under way once more."""
        if self._phase is RunPhase.MOVING:
            self._speed_unsent = not self._context.send_percent(self._percent)

    @property
    def _percent(self) -> int:
        """The speed in % that the point under way is sent with; 0 without a run."""
        run = self._run
        if run is None:
            return 0
        if self._way_in:
            return capped_percent(COME_INSIDE_PERCENT, self.speed_percent)
        return sent_percent(self._point(run).speed_percent, self.speed_percent)

    def _point(self, run: Run) -> Waypoint:
        """Return the present target: first the way inside, if the arm lay outside its limits."""
        return self._way_in[0] if self._way_in else run.points[self._index]

    def stop(self) -> None:
        """End the run: the arm ends its motion where it is and stays powered (0x150 byte 1 = 6)."""
        if not self.running or self._phase is RunPhase.STOPPING:
            return
        self._abort_motion()
        self._publish()

    def drop(self) -> None:
        """Forget the last run, so that it cannot be continued."""
        if not self.running:
            self._run = self._schedule = None
            self._phase = RunPhase.IDLE
            self._publish()

    # The controller's tick --------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Advance the run; the controller's tick calls it."""
        if not self.running:
            return
        reason = self._reason()
        if reason is not None:
            self._fail(reason)
        elif not self._known:
            pass
        elif self._phase is RunPhase.MOVING:
            self._follow_motion()
        elif self._phase is RunPhase.DWELLING:
            self._follow_dwell()
        elif self._phase is RunPhase.STOPPING:
            self._follow_stopping()
        elif self._phase is RunPhase.PAUSED:
            self._hold.repeat()
            self._emit_hold()
        self._publish()

    def _follow_motion(self) -> None:
        run, watch, schedule = self._run, self._watch, self._schedule
        if self._owed:
            self._send_point(again=True)
        if run is None or watch is None or schedule is None:
            return
        self._keep_time()
        if self._speed_unsent:
            self.send_speed()
        now_s = self._context.clock()
        arrival = watch.check(self._context.state(), now_s)
        if isinstance(arrival, Refusal):
            self._fail(arrival)
        elif arrival is Arrival.REACHED and self._way_in:
            del self._way_in[0]
            self._send_point()
        elif arrival is Arrival.REACHED:
            self._arrive(run, now_s)
        elif now_s - self._since_s > (limit_s := self._time_limit_s(schedule)) and (
            self._context.state().in_time(now_s)
        ):
            self._fail(RUN_TOO_SLOW(seconds=round(limit_s)))

    def _time_limit_s(self, schedule: RunSchedule) -> float:
        return _INSIDE_WITHIN_S if self._way_in else schedule.time_limit_s(self._index)

    def _keep_time(self) -> None:
        """Advance the planned time of the motion at the pace of the present speed."""
        now_s = self._context.clock()
        if self._phase is RunPhase.MOVING:
            pace = self._schedule.pace(self._index, self._share) if self._schedule else 1.0
            self._since_s += (now_s - self._looked_s) * (1.0 - pace)
        self._looked_s = now_s

    def _arrive(self, run: Run, now_s: float) -> None:
        point = run.points[self._index]
        point = replace(point, gripper=self.as_asked(point.gripper))
        self._act(action_frames(self._codec, point))
        if point.gripper is not None:
            self.gripper_sent.emit(*astuple(point.gripper))
        if point.holds is not None:
            self.note_held(point.holds)
        self._since_s = now_s
        self._phase = RunPhase.DWELLING
        self._follow_dwell()

    def _follow_dwell(self) -> None:
        run = self._run
        if run is None or self._context.clock() - self._since_s < run.points[self._index].dwell_s:
            return
        if run.step_by_step and not self._at_end(run):
            self._phase = RunPhase.WAITING
        else:
            self._next_point()

    def _at_end(self, run: Run) -> bool:
        last = self._index == len(run.points) - 1
        return last and run.cycles != ENDLESS and self._cycle >= run.cycles

    def _next_point(self) -> None:
        run = self._run
        if run is None:
            return
        if self._at_end(run):
            self._phase = RunPhase.DONE
            self._context.close(self._started, Ending.DONE, RUN_DONE, name=run.name)
        else:
            self._index += 1
            if self._index == len(run.points):
                self._index = 0
                self._cycle += 1
            self._send_point()
        self._publish()

    def _send_point(self, *, again: bool = False) -> None:
        run = self._run
        if run is None:
            return
        self._due_s = self._due_s if again else self._context.clock()
        self._owed = False
        point = self._point(run)
        context = self._context
        self._since_s = self._looked_s = context.clock()
        self._watch, self._phase = None, RunPhase.MOVING
        refusal = context.gate().send(
            MotionRequest(
                started=record_start(self.start),
                kind=CommandKind.RUN,
                move_mode=point.move,
                speed_percent=lambda: self._percent,
                plan=lambda begin_deg: point_way(point, self._arm(), begin_deg),
                frames=lambda percent: point_frames(self._codec, point, context.state(), percent),
                why_not=lambda now: now.cannot_run,
                joints_deg=point.target if point.is_joint else None,
                tool_way=tool_way(point, context.state()),
                sent=lambda _command: self._on_sent(point),
                refused=self._refused,
            )
        )
        if refusal is not None:
            self._refused(refusal)
        else:
            self._publish()

    def _refused(self, refusal: Refusal) -> None:
        """End the run; where angles only come late, the point is sent once they are fresh."""
        if self._phase is not RunPhase.MOVING:
            return  # the run was ended meanwhile
        self._owed = refusal.reason == FEEDBACK_SILENT
        if not self._owed or self._context.clock() - self._due_s > UNKNOWN_FOR_S:
            self._fail(refusal)

    def _on_sent(self, point: Waypoint) -> None:
        self._since_s = self._looked_s = self._context.clock()
        self._speed_unsent = False
        self._watch = ArrivalWatch(point, self._since_s)

    def _arm(self) -> ArmModel:
        context = self._context
        return planning_model(context.state(), context.operating_state())

    def _follow_stopping(self) -> None:
        now_s = self._context.clock()
        if self._rests():
            self._phase = RunPhase.STOPPED
            row = self._index + 1
            self._context.close(self._started, Ending.CUT_OFF, RUN_ENDED, row=row)
        elif now_s - self._since_s > _REST_WITHIN_S and self._rest_shows:
            self._fail(RUN_NOT_ENDED())

    def _end(self, phase: RunPhase) -> None:
        if self._phase is RunPhase.PAUSED:
            self._since_s += self._context.clock() - self._paused_s
        super()._end(phase)

    def _emit_failed(self, reason: Refusal, ending: Ending) -> None:
        row = self._index + 1
        self._context.close(self._started, ending, RUN_FAILED, row=row, reason=reason)

    # Progress ---------------------------------------------------------------------------------

    def _snapshot(self, reason: Refusal | None) -> Progress:
        run, schedule = self._run, self._schedule
        if run is None or schedule is None:
            return Progress()
        over = self._phase is RunPhase.DONE
        elapsed_s = self._elapsed_s(run)
        command = self._context.authority.command if self._phase is RunPhase.MOVING else None
        return Progress(
            phase=self._phase,
            name=run.name,
            index=self._index,
            count=len(run.points),
            cycle=self._cycle,
            cycles=run.cycles,
            done=1.0
            if over
            else schedule.in_cycle_s(self._index, elapsed_s) / (schedule.cycle_s or 1),
            remaining_s=0.0
            if over
            else schedule.remaining_s(self._index, self._cycle, elapsed_s, self._share),
            refusal=reason,
            percent=None if command is None else command.speed_percent,
            tool_mm_s=math.inf if command is None else command.tool_mm_s,
        )

    def _elapsed_s(self, run: Run) -> float:
        """Return the time since the point under way was sent, as the schedule counts it."""
        until_s = self._paused_s if self._phase is RunPhase.PAUSED else self._context.clock()
        phase = self._paused_phase if self._phase is RunPhase.PAUSED else self._phase
        elapsed_s = max(0.0, until_s - self._since_s)
        if phase is not RunPhase.DWELLING:
            return elapsed_s
        # During the dwell the planned time of the move counts as passed, however long the move
        # took.
        point = run.points[self._index]
        return max(0.0, run.expected_s[self._index] - point.dwell_s) + elapsed_s


def _why_empty(run: Run) -> Refusal | None:
    if not run.points:
        return RUN_EMPTY(name=run.name)
    if not 0 <= run.first < len(run.points):
        return RUN_NO_SUCH_ROW(row=run.first + 1, maximum=len(run.points))
    return None
