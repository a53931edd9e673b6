"""Replays a recording: a slow approach to its first sample, then targets at a fixed rate."""

from __future__ import annotations

from collections import deque
from dataclasses import replace
from typing import Final

from PySide6.QtCore import QObject, Qt, QTimer

from armui.arm.refusal import Refusal
from armui.control.events import Notice
from armui.control.motion.joint_motion import COME_INSIDE_PERCENT
from armui.control.motion.motion_command import CommandKind, MotionCommand
from armui.control.motion.motion_context import MotionContext
from armui.control.motion.requests import joint_request
from armui.control.operations.operation import Consent, operation, record_start
from armui.control.operations.started import Ending, Started
from armui.control.run.arrival import Arrival, ArrivalWatch
from armui.control.run.execution import RUN_DONE, RUN_GAP, RUN_STARTED, Execution
from armui.control.run.player import (
    NOT_PAUSED,
    NOT_RUNNING,
    RUN_FROM_OUTSIDE,
    RUN_NOT_ENDED,
    RUN_TOO_SLOW,
    why_not_go_on,
    why_not_pause,
    why_not_run,
)
from armui.control.run.progress import ENDLESS, Progress, RunPhase, capped_percent
from armui.control.run.replay import (
    FULL_PERCENT,
    LAG_MEMORY_S,
    Replay,
    most_percent,
    why_behind,
    why_not,
)
from armui.protocol import commands
from armui.protocol.codes import MoveMode
from armui.telemetry.events import Asker, EventKind, Level
from armui.trajectory.points.program import Waypoint
from armui.ways.passes import Pass

REPLAY_PAUSED = Notice("replay_paused", "Replay pauses", Level.INFO, EventKind.COMMAND)
REPLAY_CONTINUED = Notice("replay_continued", "Replay continues", Level.INFO, EventKind.COMMAND)
REPLAY_ENDED = Notice(
    "replay_ended",
    "Replay of “{name}” ended; the arm is at rest.",
    Level.INFO,
    EventKind.RESULT,
    Asker.RUN,
)
REPLAY_FAILED_NOTICE = Notice(
    "replay_failed", "Replay ended. {reason}", Level.FAULT, EventKind.RESULT, Asker.RUN
)


PERIOD_MS: Final = 20
"""The period of the targets, 50 a second; the arm plans anew at each."""

_APPROACH_PERCENT: Final = 15
"""The speed of the way to the first sample, unless the arm must come inside its limits first."""
_SAMPLES_PERCENT: Final = 100
"""The speed sent with the samples: the pace is set by when they are sent."""
_APPROACH_WITHIN_S: Final = 90.0
"""An approach that takes longer fails; time counts as slowly as the arm goes."""
_REST_WITHIN_S: Final = 3.0
"""An arm told to end its motion rests within this time, or the replay fails."""
_GRIPPER_STEP_MM: Final = 0.5
"""The gripper gets a new target only when the recorded opening has changed by this much."""
_GRIPPER_TORQUE_NM: Final = 1.0
"""Recordings hold no torque: this is the first value of the gripper's command, too."""
_GAP_S: Final = 0.08
"""After a longer pause of the program the recorded time goes on by one period only, so that the arm
is never asked to catch up; jogs end after the same time."""
_SLOWED_WITHIN_S: Final = 0.2
"""The least time in which the recorded time changes from full pace to standstill."""
_LONGEST_GAP_S: Final = 0.5
"""After a pause of the program this long, or a sleep of the computer, a replay is held."""


class Replayer(Execution):
    """Carries out one replay at a time.

    If the program stops sending, for whatever reason, the arm ends in the target sent last, which
    is never more than a period ahead of what was recorded. The operator's speed
    slows the recorded time: the path stays as checked.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: MotionContext, parent: QObject | None = None) -> None:
        super().__init__(context, parent)
        self._command: MotionCommand | None = None
        self._replay: Replay | None = None
        self._ending = RunPhase.DONE
        self._watch: ArrivalWatch | None = None
        self._way_in: list[tuple[float, ...]] = []
        self._passed: Pass | None = None
        self._at_s = 0.0
        self._pace = 0.0
        self._paces: deque[tuple[float, float]] = deque()
        self._cycle = 1
        self._looked_s = self._waited_s = 0.0
        self._gripper_mm: float | None = None
        self._most_percent = FULL_PERCENT
        self._too_fast: Refusal | None = None
        self._timer = QTimer(self, interval=PERIOD_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.follow_arm)

    # What the operator wants ------------------------------------------------------------------

    @operation("replay.start", "Replay a recording", why_not_run, moves=True, shown_first=True)
    def start(self, started: Started, replay: Replay) -> Refusal | None:
        """Begin a replay with the approach to its first angles, or return why not."""
        return self.begin(started, replay)

    def begin(self, started: Started, replay: Replay) -> Refusal | None:
        """Begin a replay for another operation, which has checked its own reasons against it."""
        context = self._context
        refusal = why_not(replay)
        most, self._too_fast = most_percent(replay, context.operating_state())
        refusal = refusal or (self._too_fast if most < 1 else None)
        if refusal is not None:
            return refusal
        self._most_percent, self.speed_percent = most, min(most, replay.speed_percent)
        self._replay, self._cycle, self._at_s = replay, 1, 0.0
        self._way_in = list(context.gate().ways_inside())
        self._gripper_mm = None
        last, self._started = self._started, started
        refusal = self._approach(replay)
        if refusal is not None:
            self._started, self._replay, self._phase = last, None, RunPhase.IDLE
            return refusal
        context.emit_event(RUN_STARTED, started, name=replay.recording.name)
        if self._way_in:
            context.emit_event(RUN_FROM_OUTSIDE)
        self._timer.start()
        self._publish()
        return None

    @operation("replay.pause", "Pause the replay", why_not_pause)
    def pause(self, started: Started) -> Refusal | None:
        """Pause: by 0x150 on the way to the first sample, afterwards by sending no targets."""
        if self._phase is not RunPhase.MOVING:
            return NOT_RUNNING()
        self._pace = 0.0
        self._pause(started)
        return None

    def _pause(self, started: Started) -> None:
        if self._watch is not None or self._passed is None:
            self._hold_back(sent=self._watch is not None)
        self._phase = RunPhase.PAUSED
        self._await_hold()
        started.close(Ending.SENT)
        self._context.emit_event(REPLAY_PAUSED, started)
        self._publish()

    @operation(
        "replay.go_on", "Continue the replay", why_not_go_on, moves=True, consent=Consent.HELD
    )
    def go_on(self, started: Started) -> Refusal | None:
        """End a pause."""
        replay, refusal = self._replay, None
        if self._phase is not RunPhase.PAUSED or replay is None:
            return NOT_PAUSED()
        if self._passed is None:  # it was paused while the gate checked its way
            refusal = self._approach(replay)
        elif self._watch is not None:
            refusal = self._let_go_on(self._approach_percent)
        if refusal is not None:
            self._phase = RunPhase.PAUSED
            return refusal
        self._phase = RunPhase.MOVING
        self._since_s = self._looked_s = self._context.clock()
        started.close(Ending.SENT)
        self._context.emit_event(REPLAY_CONTINUED, started)
        self._publish()
        return None

    def why_not_at(self, percent: int) -> Refusal | None:
        """Return the reason against a speed above the highest one that was checked, or ``None``."""
        return self._too_fast if percent > self._most_percent else None

    def set_speed(self, percent: int) -> None:
        """Let the recorded time pass at another pace; 0 % brings it to a stop, as a pause."""
        self.speed_percent = percent
        if percent == 0 and self._phase is RunPhase.MOVING:
            self._pause(record_start(self.pause))
        elif self._watch is not None:
            self.send_speed()
        if self.running:
            self._publish()

    def send_speed(self) -> None:
        """Send the speed of the approach once more; afterwards the targets set the speed."""
        if self._phase is RunPhase.MOVING and self._watch is not None:
            self._speed_unsent = not self._context.send_percent(self._approach_percent)

    @property
    def _approach_percent(self) -> int:
        return capped_percent(self._approach_cap, self.speed_percent)

    @property
    def _approach_cap(self) -> int:
        return COME_INSIDE_PERCENT if self._way_in else _APPROACH_PERCENT

    def stop(self) -> None:
        """End the replay: the arm comes to rest and stays powered."""
        if not self.running or self._phase is RunPhase.STOPPING:
            return
        self._ending = RunPhase.STOPPED
        self._abort_motion()
        self._publish()

    # The controller's tick --------------------------------------------------------------------

    def follow_arm(self) -> None:
        """Send the targets that are due; called at each tick and by a timer of its own."""
        replay = self._replay
        if replay is None or not self.running:
            return
        reason = self._reason()
        if self._known:
            reason = self._why_late() or reason
        if reason is not None:
            self._fail(reason)
        elif not self._known or (self._phase is RunPhase.MOVING and self._passed is None):
            pass  # feedback is missing, or the gate still checks the way (S35)
        elif self._phase is RunPhase.STOPPING:
            self._follow_rest(replay)
        elif self._phase is RunPhase.MOVING and self._watch is not None:
            self._follow_approach(self._watch)
        elif self._phase is RunPhase.MOVING or self._comes_to_a_stand(replay):
            self._stream(replay)
        elif self._phase is RunPhase.PAUSED:
            if self._watch is not None:
                self._hold.repeat()
            self._emit_hold()
        self._publish()

    def _comes_to_a_stand(self, replay: Replay) -> bool:
        """Return whether it was paused by 0 %, and the recorded time still slows down.

        After a long pause of the program it does not: the arm already rests at the last target.
        """
        if self._context.clock() - self._since_s >= _LONGEST_GAP_S:
            self._pace = 0.0
        paused = self._phase is RunPhase.PAUSED and self._watch is None
        return paused and self._pace > 0.0 and self._at_s < replay.duration_s

    def _approach(self, replay: Replay) -> Refusal | None:
        """Set out for the first sample, slowly: the arm may stand anywhere.

        The gate checks the way there and the whole recording, at the highest speed. Where that is
        refused, the operator's lower speed is tried, above which the replay may not go then. An arm
        that lies outside its limits is brought inside first.
        """
        refusal = self._send_off(replay)
        return None if refusal is None else self._more_slowly(refusal)

    def _more_slowly(self, refusal: Refusal) -> Refusal | None:
        replay, percent = self._replay, self.speed_percent
        if replay is None or self._way_in or not 0 < percent < self._most_percent:
            return refusal
        self._most_percent, self._too_fast = percent, refusal
        return self._send_off(replay)

    def _on_refused(self, refusal: Refusal) -> None:
        if self._phase is not RunPhase.MOVING:
            return  # the replay was ended meanwhile
        left = self._more_slowly(refusal)
        if left is not None:
            self._fail(left)

    def _send_off(self, replay: Replay) -> Refusal | None:
        self._watch = self._passed = None
        self._pace = 0.0
        self._since_s = self._looked_s = self._context.clock()
        self._phase = RunPhase.MOVING
        request = joint_request(
            self._context,
            record_start(self.start),
            self._way_in[0] if self._way_in else replay.first_deg,
            lambda: self._approach_percent,
            why_not=lambda now: now.cannot_run,
            kind=CommandKind.RUN,
        )
        request = replace(request, sent=self._on_set_out, refused=self._on_refused)
        if not self._way_in:
            most = self._most_percent
            request = replace(request, plan=lambda begin_deg: replay.way(begin_deg, most))
        return self._context.gate().send(request)

    def _on_set_out(self, command: MotionCommand) -> None:
        replay = self._replay
        if replay is None:
            return
        self._passed = self._context.gate().passed(command)
        self._since_s = self._looked_s = self._context.clock()
        self._waited_s, self._speed_unsent = 0.0, False
        target_deg = self._way_in[0] if self._way_in else replay.first_deg
        self._watch = ArrivalWatch(Waypoint(MoveMode.MOVE_J, target_deg), self._since_s)

    def _follow_approach(self, watch: ArrivalWatch) -> None:
        now_s = self._context.clock()
        # At half the speed the arm may take twice as long.
        slowed = self._approach_percent / self._approach_cap
        self._waited_s += (now_s - self._looked_s) * slowed
        self._looked_s = now_s
        if self._speed_unsent:
            self.send_speed()
        arrival = watch.check(self._context.state(), now_s)
        if isinstance(arrival, Refusal):
            self._fail(arrival)
        elif arrival is Arrival.REACHED and self._way_in and self._replay is not None:
            del self._way_in[0]
            refusal = self._approach(self._replay)
            if refusal is not None:
                self._fail(refusal)
        elif arrival is Arrival.REACHED:
            self._begin_stream(now_s)
        elif self._waited_s > _APPROACH_WITHIN_S and self._context.state().in_time(now_s):
            self._fail(RUN_TOO_SLOW(seconds=round(_APPROACH_WITHIN_S)))

    def _begin_stream(self, now_s: float) -> None:
        """Switch to streaming targets at full speed: the recording sets the pace."""
        replay = self._replay
        if replay is None:
            return
        sent = self._send_first(replay)
        if isinstance(sent, Refusal):
            self._fail(sent)
            return
        self._command, self._watch = sent, None
        self._since_s, self._at_s, self._pace = now_s, 0.0, self._share
        self._paces.clear()

    def _send_first(self, replay: Replay) -> MotionCommand | Refusal:
        """Send the first sample, at which the arm stands, at full speed."""
        passed = self._context.gate().ask_within(self._passed)
        if isinstance(passed, Refusal):
            return passed
        return self._context.send_motion(
            CommandKind.REPLAY,
            commands.move_joints(self._codec, replay.first_deg, speed_percent=_SAMPLES_PERCENT),
            passed=passed,
            started=record_start(self.start),
            move_mode=MoveMode.MOVE_J,
            speed_percent=_SAMPLES_PERCENT,
            joints_deg=replay.first_deg,
        )

    def _why_late(self) -> Refusal | None:
        """Return why a stream of targets does not go on after a long pause of the program."""
        streams = self._watch is None and self._passed is not None  # else the gate still checks it
        if self._phase is not RunPhase.MOVING or not streams:
            return None
        gap_s = self._context.clock() - self._since_s
        if gap_s < _LONGEST_GAP_S:
            return None
        return RUN_GAP(seconds=round(gap_s, 1))

    def _stream(self, replay: Replay) -> None:
        now_s = self._context.clock()
        command = self._command
        if now_s <= self._since_s or command is None:
            return
        if self._context.connection.holds(command.number):
            # The driver has not sent the last target yet; a second one would be sent right after
            # it.
            return
        gap_s, self._since_s = now_s - self._since_s, now_s
        gone_s = gap_s if gap_s <= _GAP_S else PERIOD_MS / 1e3
        self._change_pace(replay, gone_s)
        self._at_s = min(self._at_s + gone_s * self._pace, replay.duration_s)
        state = self._context.state()
        behind = why_behind(replay, self._at_s, state, self._highest_pace(now_s))
        if behind is not None and state.in_time(now_s):
            self._fail(behind)
            return
        target_deg = replay.joints_deg_at(self._at_s)
        if not self._send_target(target_deg):
            return
        self._move_gripper(replay.gripper_mm_at(self._at_s))
        if self._at_s >= replay.duration_s and self._phase is RunPhase.MOVING:
            self._end_cycle(replay)

    def _highest_pace(self, now_s: float) -> float:
        """Return the highest pace within :data:`LAG_MEMORY_S`, by which the arm may still lag."""
        self._paces.append((now_s, self._pace))
        while self._paces[0][0] < now_s - LAG_MEMORY_S:
            self._paces.popleft()
        return max(pace for _at_s, pace in self._paces)

    def _change_pace(self, replay: Replay, gone_s: float) -> None:
        """Ramp the pace of the recorded time to the operator's speed, as the joints can follow.

        What was paused comes to a stand, also when the speed was raised again meanwhile.
        """
        wanted = 0.0 if self._phase is RunPhase.PAUSED else self._share
        if self._pace == wanted:
            return
        braking_s = replay.braking_s(self._at_s, self._context.state())
        most = gone_s / max(braking_s, _SLOWED_WITHIN_S)
        self._pace += min(max(wanted - self._pace, -most), most)

    def _send_target(self, target_deg: tuple[float, ...]) -> bool:
        command = self._command
        if command is None:
            return False
        passed = self._context.gate().ask_within(self._passed)
        if isinstance(passed, Refusal):
            self._fail(passed)
            return False
        frames = commands.joint_target(self._codec, target_deg)
        sent = self._context.send_on(command, frames, passed=passed, joints_deg=target_deg)
        if isinstance(sent, Refusal):
            self._fail(sent)
            return False
        self._command = sent
        return True

    def _move_gripper(self, opening_mm: float | None) -> None:
        """Follow the recorded opening in steps; generation 1 tells none."""
        before_mm = self._gripper_mm
        if opening_mm is None or (
            before_mm is not None and abs(opening_mm - before_mm) < _GRIPPER_STEP_MM
        ):
            return
        self._gripper_mm = opening_mm
        self._act(
            commands.move_gripper_opening(
                self._codec, opening_mm=opening_mm, torque_nm=_GRIPPER_TORQUE_NM
            )
        )
        self.gripper_sent.emit(opening_mm, _GRIPPER_TORQUE_NM)

    def _end_cycle(self, replay: Replay) -> None:
        if replay.cycles != ENDLESS and self._cycle >= replay.cycles:
            self._ending = RunPhase.DONE
            self._await_rest()
            return
        self._cycle += 1
        self._at_s = 0.0
        refusal = self._approach(replay)
        if refusal is not None:
            self._fail(refusal)

    def _follow_rest(self, replay: Replay) -> None:
        now_s = self._context.clock()
        if self._rests():
            self._end(self._ending)
            if self._ending is RunPhase.DONE:
                ending, notice = Ending.DONE, RUN_DONE
            else:
                ending, notice = Ending.CUT_OFF, REPLAY_ENDED
            self._context.close(self._started, ending, notice, name=replay.recording.name)
        elif now_s - self._since_s > _REST_WITHIN_S and self._rest_shows:
            self._fail(RUN_NOT_ENDED())

    def _emit_failed(self, reason: Refusal, ending: Ending) -> None:
        self._context.close(self._started, ending, REPLAY_FAILED_NOTICE, reason=reason)

    def _end(self, phase: RunPhase) -> None:
        super()._end(phase)
        self._timer.stop()

    def _snapshot(self, reason: Refusal | None) -> Progress:
        replay = self._replay
        if replay is None:
            return Progress()
        done = 1.0 if self._phase is RunPhase.DONE else self._at_s / replay.duration_s
        cycles_left = replay.cycles - self._cycle
        rest_s = replay.duration_s * (1.0 - done + cycles_left)
        endless = replay.cycles == ENDLESS or not self.speed_percent
        # how long the way to its first angles takes is not known
        unknown = endless or (self.running and self._at_s <= 0.0)
        return Progress(
            phase=self._phase,
            name=replay.recording.name,
            cycle=self._cycle,
            cycles=replay.cycles,
            done=done,
            remaining_s=None if unknown else rest_s / self._share,
            refusal=reason,
        )
