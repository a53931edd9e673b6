"""Guided recovery: the next step, its one action, and the check that the arm has done it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.cell.cell_control import CellControl
from armui.control.context import ControllerPart
from armui.control.devices.joint_errors import JointErrors
from armui.control.devices.motors import Motors
from armui.control.devices.teaching import TeachingControl
from armui.control.events import Notice
from armui.control.motion.motion_context import MotionContext
from armui.control.motion.planned_motion import PlannedMotion
from armui.control.operating_state import BUSY, OperatingState
from armui.control.operations.operation import operation_of
from armui.control.operations.started import ARM_CHANGED, Ending, Started, refusal_of
from armui.control.requests.pending import PendingRequest
from armui.control.requests.reports import ONLINE
from armui.control.requests.request import Request, RequestOutcome
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN
from armui.control.safety.other_command import OTHER_HOST_STREAMS
from armui.control.safety.recovery_rules import next_step
from armui.control.safety.recovery_steps import NO_DEVICE, Action, Step, StepKind
from armui.protocol import commands
from armui.protocol.addressing import Addressing
from armui.protocol.codes import (
    ALL_JOINTS,
    ControlMode,
    LinkageRole,
    MoveMode,
    SettingIndex,
    TeachingState,
    TrajectoryCommand,
)
from armui.protocol.frame import Frame
from armui.telemetry.events import EventKind, EventOutcome, Level

if TYPE_CHECKING:
    from armui.control.link.arm_mark import ArmMark
    from armui.control.safety.mode_exit import ModeExitCommand

STEP_GONE = Reason(
    "step_gone",
    "The arm's state has changed: nothing was sent. Look at the step that is shown now.",
)
STANDBY_SENT = Notice("standby_sent", "Standby sent", Level.INFO, EventKind.COMMAND)
MOTION_OUTPUT_SENT = Notice(
    "motion_output_sent", "Sent: motion output (0xFC)", Level.INFO, EventKind.COMMAND
)
STEP_IN_VAIN_NOTICE = Notice(
    "step_in_vain",
    "The arm did not react. Look at the line above the panels.",
    Level.FAULT,
    EventKind.RESULT,
)


_SHOWS_LATER_S: Final = 0.5
"""The effect shows in the feedback within this time of an answer: drivers report at 10 Hz."""

_SETTLE_S: Final = 0.25
_MAY_BE_BRIEF: Final = frozenset(
    {
        StepKind.HANDSHAKE,
        StepKind.STATUS_UNKNOWN,
        StepKind.MOTORS_UNKNOWN,
        StepKind.MOTORS_MIXED,
        StepKind.NO_MOTION,
    }
)
"""The steps that may be only transitional: drivers and controller report one after the other. Such
a step is shown only if it lasts for ``_SETTLE_S``, because a flickering line leads to wrong clicks.
"""


@dataclass(frozen=True, slots=True)
class _Act:
    """The functions behind an action.

    Attributes:
        carry_out: Takes the action against a step; returns why not, if it fails at once.
        why_not: Returns the reason against it, besides the step's own.
        awaited: True if the arm is to show its effect; otherwise it leads to another step at once.
    """

    carry_out: Callable[[Step], Started | Refusal | None]
    why_not: Callable[[OperatingState], Refusal | None] = lambda _now: None
    awaited: bool = True


def _operation(
    method: Callable[..., Started | Refusal], *given: object, awaited: bool = True, **asked: object
) -> _Act:
    """Return the act of an operation: the reason against the operation stands against it too.

    Args:
        method: The operation.
        *given: Arguments of it on which its reason does not depend.
        awaited: As in :class:`_Act`.
        **asked: The arguments on which its reason depends.
    """
    return _Act(
        lambda _step: method(*given, **asked),
        partial(operation_of(method).why_not, **asked),
        awaited,
    )


@dataclass(slots=True)
class _PendingAction:
    """An action under way; it ends when the arm is in another state.

    Attributes:
        step: The step that it is to settle.
        idle_since_s: The time since when nothing of it is under way any more.
        cleared: The clearing of errors that it last began.
    """

    step: Step
    idle_since_s: float | None = None
    cleared: Started | Refusal | None = None

    @property
    def answered(self) -> bool:
        """True if the arm has answered the clearing of errors."""
        return isinstance(self.cleared, Started) and self.cleared.ending is Ending.ANSWERED


class Recovery(ControllerPart):
    """Determines the next step of recovery and carries it out on request.

    Args:
        context: The context that the controller's parts share.
        motors: Switches the motors.
        joint_errors: Clears the errors of the drivers.
        teaching: Commands drag teaching.
        stop: The emergency stop.
        withdraw_stop: Gives up a stop that is outstanding.
        planned_motion: Continues a motion held back, or drops it.
        take_over: Takes the arm from another host.
        mode_exit: Takes the arm out of another host's mode.
        allow: Agrees to motions with a reference in doubt.
        note_slip: Leaves it at what has slipped at a resume.
        cell: Confirms the cell of the arm.
        announce: Called with each new step.

    Attributes:
        step: The next step.
        acts: True while it gives a command itself.
    """

    def __init__(
        self,
        context: MotionContext,
        *,
        motors: Motors,
        joint_errors: JointErrors,
        teaching: TeachingControl,
        stop: Callable[[], None],
        withdraw_stop: Callable[[], None],
        planned_motion: PlannedMotion,
        take_over: Callable[[], Refusal | None],
        mode_exit: ModeExitCommand,
        allow: Callable[[], Started | Refusal],
        note_slip: Callable[[], None],
        come_inside: Callable[[], Started | Refusal],
        cell: CellControl,
        announce: Callable[[Step], object],
    ) -> None:
        self._context = context
        self._motors = motors
        self._joint_errors = joint_errors
        self._teaching = teaching
        self._mode_exit = mode_exit
        self._announce = announce
        self._attempt: _PendingAction | None = None
        self._in_vain: dict[StepKind, int] = {}
        self._to_clear: list[int] = []
        self._pending: PendingRequest[Notice] = PendingRequest(context)
        self._shown: Notice | None = None
        self._brief_since_s: float | None = None
        self.acts = False
        self.step = NO_DEVICE
        self._acts: Mapping[Action, _Act] = {
            Action.LEAVE_TEACHING_INPUT: _Act(self._leave_teaching_input),
            Action.RESUME: _operation(motors.resume),
            Action.ENABLE: _operation(motors.enable),
            Action.CLEAR_ERRORS: _Act(self._clear_errors, operation_of(joint_errors.clear).why_not),
            Action.RESET: _Act(lambda _step: stop(), awaited=False),
            Action.STOP_RECORDING: _operation(
                teaching.command, command=TeachingState.STOP_RECORDING
            ),
            Action.ABORT_REPLAY: _operation(teaching.command, command=TeachingState.ABORT),
            Action.LEAD_BY_HAND: _operation(
                teaching.command, command=TeachingState.START_RECORDING
            ),
            Action.STANDBY: _Act(self._take_command, _why_not_standby),
            Action.WITHDRAW_STOP: _Act(lambda _step: withdraw_stop(), awaited=False),
            Action.STOP: _Act(lambda _step: stop(), awaited=False),
            Action.GO_ON: _operation(
                planned_motion.command, command=TrajectoryCommand.CONTINUE, awaited=False
            ),
            Action.GIVE_UP: _operation(
                planned_motion.command, command=TrajectoryCommand.ABORT, awaited=False
            ),
            Action.TAKE_OVER: _Act(lambda _step: take_over(), _why_not_take_over, awaited=False),
            Action.LEAVE_MODE: _Act(
                lambda _step: mode_exit.send(), lambda _now: mode_exit.why_not(), awaited=False
            ),
            Action.ALLOW: _Act(lambda _step: allow(), awaited=False),
            Action.NOTED: _Act(lambda _step: note_slip(), awaited=False),
            Action.COME_INSIDE: _operation(come_inside, awaited=False),
            Action.CONFIRM_CELL: _operation(cell.confirm, awaited=False),
            Action.LEAVE_CELL: _operation(cell.choose, "", awaited=False),
        }

    def act(
        self, step: Step, action: Action | None = None, mark: ArmMark | None = None
    ) -> Refusal | None:
        """Take a step that was shown; return ``None`` if it is under way, or why not.

        Args:
            step: The step that the operator agreed to. If the arm is in another state by now, the
                step is not taken: its action may mean something else there.
            action: Its alternative, if that is meant.
            mark: The arm it was shown for, if the caller has not checked that itself.

        Raises:
            KeyError: The action is not the controller's: the window does the connecting.
        """
        self._context.refresh()
        if mark is not None and not mark.is_still(self._context.connection.mark):
            return self._context.refuse(ARM_CHANGED())
        now = self._find_step()
        wanted = step.action if action is None else action
        if now.kind is not step.kind or wanted is None or wanted not in now.actions:
            return self._context.refuse(STEP_GONE())
        if self._attempt is not None:
            return self._context.refuse(BUSY(what="recovery"))
        refusal = self.why_not(now, wanted)
        if refusal is not None:
            return self._context.refuse(refusal)
        self._give_up()
        with self._acting():
            refusal = refusal_of(self._acts[wanted].carry_out(now))
        if refusal is None and self._acts[wanted].awaited:
            self._attempt = _PendingAction(now)
        self._context.refresh()
        self.follow_arm()
        return refusal

    def why_not(self, step: Step, action: Action | None = None) -> Refusal | None:
        """Return the reason against taking a step now beside the step's own, or ``None``.

        Args:
            step: The step shown.
            action: Its alternative, if that is meant.
        """
        action = action or step.action
        act = None if action is None else self._acts.get(action)
        return None if act is None else act.why_not(self._context.operating_state())

    def follow_arm(self) -> None:
        """Determine the step anew; called regularly while a device is open."""
        now_s = self._context.clock()
        outcome, started = self._pending.advance(), self._pending.started
        if outcome is RequestOutcome.DONE and started is not None:
            started.close(Ending.DONE, self._outcome(self._shown))
        if self._attempt is not None and self._to_clear and not self._joint_errors.busy:
            with self._acting():
                self._attempt.cleared = self._joint_errors.clear(self._to_clear.pop(0))
        step = self._find_step()
        # A step of another kind is another problem: attempts in vain count from 0 again. WORKING
        # only stands in between.
        if step.kind is not StepKind.WORKING:
            self._in_vain = {kind: n for kind, n in self._in_vain.items() if kind is step.kind}
        step = self._follow(step, now_s)
        if self._holds(step, now_s) and step != self.step:
            self.step = step
            self._announce(step)

    def halt(self) -> None:
        """Drop the action under way, because a stop was asked for."""
        self._give_up()

    def forget_arm(self) -> None:
        """Drop the action under way, because the arm is gone."""
        self._give_up()

    def _find_step(self) -> Step:
        context = self._context
        return next_step(context.state(), context.operating_state(), context.clock(), self._in_vain)

    def _give_up(self) -> None:
        self._attempt = None
        self._pending.drop()
        self._to_clear.clear()

    # The outcome of an action ---------------------------------------------------------------------

    def _follow(self, step: Step, now_s: float) -> Step:
        """Return the step with the outcome so far of the action taken against it."""
        attempt = self._attempt
        if attempt is None:
            return step
        if step.kind is StepKind.WORKING:
            return replace(attempt.step, waiting=True, motion=step.motion)
        if step.kind is not attempt.step.kind or step.joints != attempt.step.joints:
            self._give_up()
            return step
        if self._under_way:
            attempt.idle_since_s = None
        elif attempt.idle_since_s is None:
            attempt.idle_since_s = now_s
        elif now_s - attempt.idle_since_s >= _SHOWS_LATER_S:
            started = self._pending.release()
            self._give_up()
            if attempt.answered:  # a stronger action would not help either
                self._in_vain[step.kind] = 0
            else:
                self._in_vain[step.kind] = self._in_vain.get(step.kind, 0) + 1
                self._context.close(started, Ending.FAILED, STEP_IN_VAIN_NOTICE)
            return self._find_step()
        return replace(step, waiting=True)

    @property
    def _under_way(self) -> bool:
        """True if something of the action may still have an effect."""
        return (
            self._pending.kind is not None
            or bool(self._to_clear)
            or self._joint_errors.busy
            or self._teaching.pending is not None
            or self._motors.busy is not None
            or self._mode_exit.asking
        )

    def _holds(self, step: Step, now_s: float) -> bool:
        """Return whether a step is to be shown: some states are passed through in a moment.

        While the arm sinks, no lesser step is shown instead of that.
        """
        sinks = step.motion is not None and step.motion.is_danger
        if step.kind not in _MAY_BE_BRIEF or step.kind is self.step.kind or sinks:
            self._brief_since_s = None
            return True
        if self._brief_since_s is None:
            self._brief_since_s = now_s
        return now_s - self._brief_since_s >= _SETTLE_S

    # What the actions do --------------------------------------------------------------------------

    @contextmanager
    def _acting(self) -> Iterator[None]:
        self.acts = True
        try:
            yield
        finally:
            self.acts = False

    def _clear_errors(self, step: Step) -> Refusal | None:
        self._to_clear = list(step.joints) or [ALL_JOINTS]
        return None

    def _take_command(self, _step: Step) -> Refusal | None:
        """Return to standby; entering CAN control might start a target somebody left in the arm."""
        refusal = self._context.why_no_motion()
        if refusal is not None:
            return self._context.refuse(refusal)
        frames = commands.set_mode(
            self._context.connection.codec,
            control_mode=ControlMode.STANDBY,
            move_mode=MoveMode.MOVE_J,
            speed_percent=0,
        )
        self._send(Started("recovery.standby"), STANDBY_SENT, frames)
        return None

    def _leave_teaching_input(self, _step: Step) -> None:
        frames = commands.set_linkage(self._context.connection.codec, LinkageRole.MOTION_OUTPUT)
        self._context.connection.offsets.request(
            Addressing(), self._context.clock(), ends_input=True
        )
        started = Started("recovery.leave_teaching_input")
        answer = SettingIndex.LINKAGE_SETTING
        self._send(started, MOTION_OUTPUT_SENT, frames, shown=ONLINE, answer=answer)

    def _send(
        self,
        started: Started,
        notice: Notice,
        frames: Sequence[Frame],
        *,
        shown: Notice | None = None,
        answer: SettingIndex | None = None,
    ) -> None:
        """Send until the arm is in another state, or time is up; ``shown`` tells of that state."""
        context = self._context
        kind = self._find_step().kind
        request = Request(
            context,
            frames,
            lambda _state: self._find_step().kind is not kind,
            passed=context.gate().ask_no_way(),
        )
        self._shown = shown
        self._pending.begin(notice, started, request, None, sent=(notice, {}), answer=answer)

    def _outcome(self, notice: Notice | None) -> EventOutcome | None:
        if notice is None:
            return None
        return EventOutcome(notice.id, self._context.clock(), notice.level)


def _why_not_standby(now: OperatingState) -> Refusal | None:
    return None if now.control_certain else CONTROL_OFFSET_UNKNOWN()


def _why_not_take_over(now: OperatingState) -> Refusal | None:
    other = now.other_host
    if other is None or other.may_be_taken_over:
        return None
    return OTHER_HOST_STREAMS(frames=other.frames)
