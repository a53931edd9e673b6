"""The common base of runs of points and replays: one at a time, followed to its end."""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import TYPE_CHECKING, Final

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Reason, Refusal
from armui.arm.state import PAUSE_S
from armui.control.context import ControllerPart
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.motion.abort import RUN_STOPPED, abort_motion, abort_motion_for
from armui.control.motion.motion_context import MotionContext
from armui.control.motion.planned_motion import PauseCommand
from armui.control.operations.started import Ending
from armui.control.run.progress import OVER, Progress, RunPhase
from armui.control.safety.interlocks import PASSING
from armui.control.safety.standstill import SETTLED_S, RestWatch
from armui.protocol import commands
from armui.protocol.codes import TrajectoryCommand
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.control.operations.started import Started
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame

RUN_GAP = Reason(
    "run_gap",
    "The program, the computer or the adapter stood still for {seconds} s, so the run was "
    "ended. Let the computer do less beside it, keep it from sleeping, and start it anew.",
)
RUN_STARTED = Notice("run_started", "Running “{name}”", Level.INFO, EventKind.COMMAND)
PAUSE_HOLDS = Notice(
    "pause_holds",
    "Paused: the arm is measured at rest, and holds.",
    Level.INFO,
    EventKind.RESULT,
    Asker.RUN,
)
RUN_DONE = Notice("run_done", "“{name}” has finished.", Level.DONE, EventKind.RESULT, Asker.RUN)

UNKNOWN_FOR_S: Final = 1.0
"""Feedback that a run needs may be missing for this time."""


class Execution(QObject, ControllerPart):
    """Moves the arm by several commands, each sent on the feedback to the one before.

    Args:
        context: The context that the controller's parts share.

    Attributes:
        speed_percent: The operator's speed, of this run or the last: the share of its own pace.

    Signals:
        progressed: A :class:`Progress`, when it differs.
        gripper_sent: The gripper was sent to a target, with an effort.
        aborted: The arm was told to end what the run moves.
    """

    progressed = Signal(object)
    gripper_sent = Signal(float, float)
    aborted = Signal()

    def __init__(self, context: MotionContext, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._context = context
        self._phase = RunPhase.IDLE
        self._progress = Progress()
        self._rest = RestWatch()
        self._since_s = 0.0
        self._started: Started | None = None
        self.speed_percent = 100
        self._known_s, self._known = 0.0, True
        self._speed_unsent = False
        """True while the present speed could not be sent to the arm yet."""
        self._hold = PauseCommand(context)
        self._hold_unreported = False

    @property
    def progress(self) -> Progress:
        """The phase, place and times of the run."""
        return self._progress

    @property
    def running(self) -> bool:
        """True if a run moves the arm, or will."""
        return self._phase not in OVER

    @property
    def number(self) -> int:
        """The number of the record of the run, or of the last one; 0 before the first."""
        return 0 if self._started is None else self._started.number

    @property
    def phase(self) -> RunPhase:
        """The phase of the run, or the way it ended."""
        return self._phase

    def carries_out(self, records: Container[Started]) -> bool:
        """Return whether the run under way carries out one of these operations."""
        return self.running and self._started is not None and self._started in records

    def stop(self) -> None:
        """End the run: the arm ends its motion where it is, with power on."""
        raise NotImplementedError

    def end_run(self, reason: Refusal) -> None:
        """End the run at once, because something else happens that excludes it."""
        if self.running:
            self._fail(reason, Ending.CUT_OFF)
            self._publish()

    def halt(self) -> None:
        """End the run: an emergency stop was asked for."""
        self.end_run(RUN_STOPPED())

    def forget_arm(self) -> None:
        """End the run: the arm is lost."""
        self.end_run(LINK_LOST())

    # What runs and replays do differently -----------------------------------------------------

    def why_not_at(self, percent: int) -> Refusal | None:
        """Return why the run under way may not go at a speed, or ``None``."""
        raise NotImplementedError

    def set_speed(self, percent: int) -> None:
        """Continue at another share of the run's own speed; 0 % pauses it.

        This does not continue a paused run.

        Args:
            percent: 0–100.
        """
        raise NotImplementedError

    def send_speed(self) -> None:
        """Send the speed of the motion under way once more, if it has one to send."""
        raise NotImplementedError

    def _snapshot(self, reason: Refusal | None) -> Progress:
        """Return the present progress.

        Args:
            reason: Why it failed, if it has.
        """
        raise NotImplementedError

    def _emit_failed(self, reason: Refusal, ending: Ending) -> None:
        """Report to the operator why it has ended early."""
        raise NotImplementedError

    def _end(self, phase: RunPhase) -> None:
        """End the run or replay; no target is sent any more."""
        self._phase = phase

    # What runs and replays have in common -----------------------------------------------------

    def _reason(self) -> Refusal | None:
        """Return why the run cannot go on, or ``None``; briefly missing feedback is waited for."""
        reason = self._context.operating_state().cannot_run
        now_s = self._context.clock()
        self._known = reason is None or reason.reason not in PASSING
        if self._known:
            self._known_s = now_s
            return reason
        return reason if now_s - self._known_s > UNKNOWN_FOR_S else None

    def _fail(self, reason: Refusal, ending: Ending = Ending.FAILED) -> None:
        gap, now_s = self._context.state().gap, self._context.clock()
        late = gap is not None and gap.value > PAUSE_S and gap.fresh(now_s)
        if gap is not None and late and reason.reason in PASSING:  # a gap, not the arm (S37)
            reason = RUN_GAP(seconds=round(gap.value, 1))
        self._hold.drop()
        abort_motion_for(self._context, reason)
        self._end(RunPhase.FAILED)
        self._progress = self._snapshot(reason)
        self._emit_failed(reason, ending)
        self.progressed.emit(self._progress)

    def _abort_motion(self) -> None:
        """End the arm's motion with power on, and wait until it rests."""
        self._hold.drop()
        abort_motion(self._context)
        self.aborted.emit()
        self._await_rest()

    def _await_rest(self) -> None:
        self._since_s = self._context.clock()
        self._rest = RestWatch()
        self._phase = RunPhase.STOPPING

    def _hold_back(self, *, sent: bool) -> None:
        """Pause a motion that was sent; one that the gate still checks is dropped."""
        if sent:
            self._hold.send()
        else:
            self._context.gate().halt()

    def _await_hold(self) -> None:
        """Begin to watch for rest after a pause was sent, as the arm still moves at first."""
        self._rest = RestWatch()
        self._hold_unreported = True

    def _emit_hold(self) -> None:
        """Report once that the arm holds, as soon as it is measured at rest after the pause."""
        if self._hold_unreported and self._rests():
            self._hold_unreported = False
            self._context.emit_event(PAUSE_HOLDS)

    def _publish(self) -> None:
        progress = self._snapshot(
            self._progress.refusal if self._phase is RunPhase.FAILED else None
        )
        if progress != self._progress:
            self._progress = progress
            self.progressed.emit(progress)

    @property
    def _share(self) -> float:
        """The operator's speed as a share of the run's own, 0 to 1."""
        return self.speed_percent / 100.0

    def _let_go_on(self, percent: int) -> Refusal | None:
        """Continue the motion held back in the arm (0x150 byte 1 = 2), no faster than shown.

        Args:
            percent: The speed, sent first if the arm has another one.

        Returns:
            ``None`` if it is on the bus, or why the motion stays held back.
        """
        context = self._context
        self._hold.drop()
        authority, holds = context.authority, context.authority.holds
        passed = context.gate().ask_on(authority.command)
        if isinstance(passed, Refusal):
            return passed
        authority.went_on(context.clock())
        if authority.arm_percent != percent and not context.send_percent(percent):
            authority.holds = holds
            return LINK_LOST()
        go_on = commands.trajectory_command(self._codec, TrajectoryCommand.CONTINUE)
        return None if context.connection.send(go_on, passed=passed) else LINK_LOST()

    def _rests(self) -> bool:
        """Return whether the arm is measured to have come to rest since the motion was ended."""
        self._rest.observe(self._context.state(), self._context.clock())
        return self._rest.at_rest

    @property
    def _rest_shows(self) -> bool:
        """True if enough angles have come since `_since_s` to tell whether the arm is at rest."""
        context = self._context
        return context.state().in_time_for_s(context.clock(), self._since_s) > SETTLED_S

    @property
    def _codec(self) -> Codec:
        return self._context.connection.codec

    def _act(self, frames: Sequence[Frame]) -> bool:
        """Send what moves the gripper or sets a lamp; return whether it is under way."""
        passed = self._context.gate().ask_no_way()
        return not frames or self._context.connection.send(frames, passed=passed)
