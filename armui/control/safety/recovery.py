"""Guided recovery: the next step, its one action, and the check that the arm has done it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.cell.cell_control import CellControl
from armui.control.context import ControllerPart
from armui.control.devices.joint_errors import JointErrors
from armui.control.devices.motors import Motors
from armui.control.devices.teaching import TeachingControl
from armui.control.events import Notice
from armui.control.motion.joint_motion import Motion
from armui.control.motion.motion_context import MotionContext
from armui.control.motion.planned_motion import PlannedMotion
from armui.control.operating_state import BUSY
from armui.control.operations.operation import Operation, operation_of
from armui.control.operations.started import ARM_CHANGED, Ending, Started, refusal_of
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
    from armui.protocol.codec import Message

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
    "The arm did not react. Look at the step above the panel.",
    Level.FAULT,
    EventKind.RESULT,
)


_SHOWS_LATER_S: Final = 0.5
"""An answer's effect shows in the feedback this much later: drivers report ten times a second."""

_SETTLE_S: Final = 0.25
_MAY_BE_BRIEF: Final = frozenset(
    {StepKind.HANDSHAKE, StepKind.STATUS_UNKNOWN, StepKind.MOTORS_UNKNOWN, StepKind.MOTORS_MIXED}
)
"""The steps that may be only transitional: drivers and controller report one after the other. Such
a step is shown only if it lasts for ``_SETTLE_S``, because a flickering line leads to wrong clicks.
"""

_TEACH: Final = operation_of(TeachingControl.command)
_PLAN: Final = operation_of(PlannedMotion.command)
_OPERATIONS: Final[Mapping[Action | None, tuple[Operation, Mapping[str, object]]]] = {
    Action.RESUME: (operation_of(Motors.resume), {}),
    Action.ENABLE: (operation_of(Motors.enable), {}),
    Action.CLEAR_ERRORS: (operation_of(JointErrors.clear), {}),
    Action.STOP_RECORDING: (_TEACH, {"command": TeachingState.STOP_RECORDING}),
    Action.ABORT_REPLAY: (_TEACH, {"command": TeachingState.ABORT}),
    Action.LEAD_BY_HAND: (_TEACH, {"command": TeachingState.START_RECORDING}),
    Action.GO_ON: (_PLAN, {"command": TrajectoryCommand.CONTINUE}),
    Action.GIVE_UP: (_PLAN, {"command": TrajectoryCommand.ABORT}),
    Action.COME_INSIDE: (operation_of(Motion.come_inside), {}),
    Action.CONFIRM_CELL: (operation_of(CellControl.confirm), {}),
    Action.LEAVE_CELL: (operation_of(CellControl.choose), {}),
}
"""The operations of actions: an operation's own reason also stands against its action."""

_AT_ONCE: Final = frozenset(
    {
        Action.RESET,
        Action.WITHDRAW_STOP,
        Action.STOP,
        Action.GO_ON,
        Action.GIVE_UP,
        Action.TAKE_OVER,
        Action.LEAVE_MODE,
        Action.ALLOW,
        Action.COME_INSIDE,
        Action.CONFIRM_CELL,
        Action.LEAVE_CELL,
    }
)
"""The actions without anything to wait for: they lead to another step."""

_Handler = Callable[[Step], Started | Refusal | None]


@dataclass(slots=True)
class _PendingAction:
    """An action under way; it ends when the arm is in another state.

    Attributes:
        step: What it is to settle.
        idle_since_s: Since when nothing of it is on its way any more.
    """

    step: Step
    idle_since_s: float | None = None


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
        come_inside: Callable[[], Started | Refusal],
        cell: CellControl,
        announce: Callable[[Step], object],
    ) -> None:
        self._context = context
        self._motors = motors
        self._joint_errors = joint_errors
        self._teaching = teaching
        self._stop = stop
        self._withdraw_stop = withdraw_stop
        self._announce = announce
        self._attempt: _PendingAction | None = None
        self._in_vain: dict[StepKind, int] = {}
        self._to_clear: list[int] = []
        self._request: Request | None = None
        self._started: Started | None = None
        self._shown: Notice | None = None
        context.connection.answered.connect(self._on_answer)
        self._brief_since_s: float | None = None
        self.acts = False
        self.step = NO_DEVICE
        self._handlers: Mapping[Action, _Handler] = {
            Action.LEAVE_TEACHING_INPUT: self._leave_teaching_input,
            Action.RESUME: lambda _step: self._motors.resume(),
            Action.ENABLE: lambda _step: self._motors.enable(),
            Action.CLEAR_ERRORS: self._clear_errors,
            Action.RESET: self._reset,
            Action.STOP_RECORDING: self._teach(TeachingState.STOP_RECORDING),
            Action.ABORT_REPLAY: self._teach(TeachingState.ABORT),
            Action.LEAD_BY_HAND: self._teach(TeachingState.START_RECORDING),
            Action.STANDBY: self._take_command,
            Action.WITHDRAW_STOP: self._give_up_stop,
            Action.STOP: self._reset,
            Action.GO_ON: lambda _step: planned_motion.command(TrajectoryCommand.CONTINUE),
            Action.GIVE_UP: lambda _step: planned_motion.command(TrajectoryCommand.ABORT),
            Action.TAKE_OVER: lambda _step: take_over(),
            Action.LEAVE_MODE: lambda _step: mode_exit.send(),
            Action.ALLOW: lambda _step: allow(),
            Action.COME_INSIDE: lambda _step: come_inside(),
            Action.CONFIRM_CELL: lambda _step: cell.confirm(),
            Action.LEAVE_CELL: lambda _step: cell.choose(""),
        }
        self._mode_exit = mode_exit

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
        now = self._look()
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
            refusal = refusal_of(self._handlers[wanted](now))
        if refusal is None and wanted not in _AT_ONCE:
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
        action, now = action or step.action, self._context.operating_state()
        if action is Action.TAKE_OVER:
            return self._why_not_take_over()
        if action is Action.LEAVE_MODE:
            return self._mode_exit.why_not()
        if action in _OPERATIONS:
            operation, arguments = _OPERATIONS[action]
            return operation.why_not(now, **arguments)
        if not now.control_certain and action is Action.STANDBY:
            return CONTROL_OFFSET_UNKNOWN()
        return None

    def _why_not_take_over(self) -> Refusal | None:
        other = self._context.operating_state().other_host
        if other is None or other.may_be_taken_over:
            return None
        return OTHER_HOST_STREAMS(frames=other.frames)

    def follow_arm(self) -> None:
        """Determine the step anew; called regularly while a device is open."""
        now_s = self._context.clock()
        if self._request is not None:
            outcome = self._request.advance()
            if outcome is not RequestOutcome.WAITING:
                self._request = None
            if outcome is RequestOutcome.DONE and self._started is not None:
                self._started.close(Ending.DONE, self._outcome(self._shown))
        if self._to_clear and not self._joint_errors.busy:
            with self._acting():
                self._joint_errors.clear(self._to_clear.pop(0))
        step = self._look()
        if step.kind is not StepKind.WORKING:  # another kind is another problem
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

    def _look(self) -> Step:
        context = self._context
        return next_step(context.state(), context.operating_state(), context.clock(), self._in_vain)

    def _give_up(self) -> None:
        self._attempt = None
        self._request = None
        self._to_clear.clear()
        if self._started is not None:
            self._started.close(Ending.CUT_OFF)

    # How an action fares --------------------------------------------------------------------------

    def _follow(self, step: Step, now_s: float) -> Step:
        """Return the step with what has become of the action taken against it."""
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
            started, self._started = self._started, None
            self._give_up()
            self._in_vain[step.kind] = self._in_vain.get(step.kind, 0) + 1
            self._context.close(started, Ending.FAILED, STEP_IN_VAIN_NOTICE)
            return self._look()
        return replace(step, waiting=True)

    @property
    def _under_way(self) -> bool:
        """True if something of the action may still have an effect."""
        return (
            self._request is not None
            or bool(self._to_clear)
            or self._joint_errors.busy
            or self._teaching.pending is not None
            or self._motors.busy is not None
            or self._mode_exit.asking
        )

    def _holds(self, step: Step, now_s: float) -> bool:
        """Return whether a step is to be shown: some states are passed through in a moment.

        Where the arm sinks no line that says less may stand in its place.
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

    def _teach(self, command: TeachingState) -> _Handler:
        return lambda _step: self._teaching.command(command)

    def _reset(self, _step: Step) -> Refusal | None:
        self._stop()
        return None

    def _give_up_stop(self, _step: Step) -> Refusal | None:
        self._withdraw_stop()
        return None

    def _clear_errors(self, step: Step) -> Refusal | None:
        self._to_clear = list(step.joints) or [ALL_JOINTS]
        return None

    def _take_command(self, _step: Step) -> Refusal | None:
        """Back to standby: entering CAN control might start a target somebody left in the arm."""
        refusal = self._context.why_no_motion()
        if refusal is not None:
            return self._context.refuse(refusal)
        frames = commands.set_mode(
            self._context.connection.codec,
            control_mode=ControlMode.STANDBY,
            move_mode=MoveMode.MOVE_J,
            speed_percent=0,
        )
        return self._send(Started("recovery.standby"), STANDBY_SENT, frames)

    def _leave_teaching_input(self, _step: Step) -> Refusal | None:
        frames = commands.set_linkage(self._context.connection.codec, LinkageRole.MOTION_OUTPUT)
        self._context.connection.offsets.request(
            Addressing(), self._context.clock(), ends_input=True
        )
        started = Started("recovery.leave_teaching_input")
        return self._send(started, MOTION_OUTPUT_SENT, frames, ONLINE)

    def _send(
        self,
        started: Started,
        notice: Notice,
        frames: Sequence[Frame],
        shown: Notice | None = None,
    ) -> Refusal | None:
        """Send until the arm is in another state, or time is up; ``shown`` tells of that state."""
        context = self._context
        kind = self._look().kind
        request = Request(
            context,
            frames,
            lambda _state: self._look().kind is not kind,
            passed=context.gate().ask_no_way(),
        )
        self._request, self._started, self._shown = request, started, shown
        context.tell(notice, started)
        if self._request is request:  # a failure in who is told ends what is under way
            request.advance()
        return None

    def _outcome(self, notice: Notice | None) -> EventOutcome | None:
        if notice is None:
            return None
        return EventOutcome(notice.id, self._context.clock(), notice.level)

    def _on_answer(self, answer: Message) -> None:
        """Note that the arm has taken its role."""
        index, started = SettingIndex.LINKAGE_SETTING, self._started
        if answer.name != "SettingResponse" or answer.signals["Index"] != index:
            return
        if started is not None and self._shown is ONLINE and started.answer is None:
            started.answered(index, self._context.clock())
