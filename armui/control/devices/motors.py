"""Switches the motors' power, also after an emergency stop (manual section 1.0.4)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from armui.arm.figures import JointOrAll
from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.arm.state import ArmState
from armui.control.events import Notice
from armui.control.link.link_state import why_only_heard
from armui.control.motion.motion_command import End
from armui.control.operating_state import Busy, OperatingState, StopState
from armui.control.operations.operation import Consent, operation
from armui.control.operations.started import Started
from armui.control.requests import reports
from armui.control.requests.pending import EndNotices, RequestingPart
from armui.control.requests.request import Request
from armui.control.safety.emergency_stop import is_stopped
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN
from armui.protocol import commands
from armui.protocol.codes import ALL_JOINTS, SettingIndex
from armui.protocol.frame import Frame
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.control.motion.motion_context import MotionContext

NOT_STOPPED = Reason(
    "not_stopped", "The arm is not in emergency stop: there is nothing to release."
)
RUN_DISABLED = Reason(
    "run_disabled", "Motors were disabled while it ran: the arm was told to end its motion."
)
RESUME_SENT = Notice(
    "resume_sent",
    "Release sent. The motors no longer brake and the arm drops: hold the arm.",
    Level.INFO,
    EventKind.COMMAND,
)
ENABLE_SENT = Notice("enable_sent", "Enable sent to all six motors", Level.INFO, EventKind.COMMAND)
ENABLE_SENT_JOINT = Notice(
    "enable_sent_joint", "Enable sent to joint {joint}", Level.INFO, EventKind.COMMAND
)
DISABLE_SENT_JOINT = Notice(
    "disable_sent_joint", "Disable sent to joint {joint}", Level.INFO, EventKind.COMMAND
)
DISABLE_SENT = Notice(
    "disable_sent",
    "Disable sent to all six motors. The arm drops: hold the arm.",
    Level.INFO,
    EventKind.COMMAND,
)


def why_not_enable(now: OperatingState) -> Refusal | None:
    """Return why motors must not be enabled, or ``None``; disabling is always possible."""
    return now.cannot_enable or now.occupied


def why_not_disable(now: OperatingState) -> Refusal | None:
    """Return why motors cannot be disabled, or ``None``."""
    return now.cannot_enable


def why_not_resume(now: OperatingState) -> Refusal | None:
    """Return why the stop cannot be ended: there is none, or another arm might drop (0x150)."""
    if now.stop is not StopState.STOPPED:
        return NOT_STOPPED()
    if (refusal := why_only_heard(now.device)) is not None:
        return refusal
    return None if now.control_certain else CONTROL_OFFSET_UNKNOWN()


class Motors(RequestingPart[Busy]):
    """Switches the motors, and follows each switching until the drivers' feedback shows it.

    Args:
        context: The context that the controller's parts share.
        end_run: Called with the reason when motors are about to be disabled under a run.
    """

    def __init__(self, context: MotionContext, end_run: Callable[[Refusal], None]) -> None:
        super().__init__(context)
        self._end_run = end_run

    @property
    def busy(self) -> Busy | None:
        """The switching that was sent and that the feedback has not shown yet."""
        return self._pending.kind

    @operation("motors.enable", "Enable motors", why_not_enable)
    def enable(self, started: Started, joint: JointOrAll = ALL_JOINTS) -> None:
        """Enable a motor, or all six with 7 (0x471); repeat until the drivers report it."""
        self._switch(started, joint, on=True)

    @operation("motors.disable", "Disable motors", why_not_disable, consent=Consent.PRESS)
    def disable(self, started: Started, joint: JointOrAll = ALL_JOINTS) -> None:
        """Disable a motor, or all six with 7 (0x471): the arm DROPS.

        An activity under way is no reason to refuse it: that activity ends.
        """
        self._switch(started, joint, on=False)

    @operation("motors.resume", "Release the emergency stop", why_not_resume, consent=Consent.HELD)
    def resume(self, started: Started) -> None:
        """End the emergency stop: power is cut at once, the arm DROPS; then it must be enabled."""
        context = self._context
        context.emit_event(RESUME_SENT, started)
        self._start(
            started,
            Busy.RESUMING,
            JOINTS,
            commands.resume(context.connection.codec),
            lambda state: state.status is not None and not is_stopped(state),
        )

    def _switch(self, started: Started, joint: int, *, on: bool) -> None:
        context = self._context
        if not on:
            self._end_run(RUN_DISABLED())
            context.authority.end_command(End.DISABLED)
        joints = JOINTS if joint == ALL_JOINTS else (joint,)
        command = commands.enable_motors if on else commands.disable_motors
        if joint == ALL_JOINTS:
            context.emit_event(ENABLE_SENT if on else DISABLE_SENT, started)
        else:
            one = ENABLE_SENT_JOINT if on else DISABLE_SENT_JOINT
            context.emit_event(one, started, joint=joint)
        self._start(
            started,
            Busy.ENABLING if on else Busy.DISABLING,
            joints,
            command(context.connection.codec, joint),
            lambda state: all(state.enabled()[number - 1] is on for number in joints),
            answer=SettingIndex.MOTOR_ENABLE,  # the answer does not name the motor
        )

    def _start(
        self,
        started: Started,
        busy: Busy,
        joints: Sequence[int],
        frames: Sequence[Frame],
        seen: Callable[[ArmState], bool],
        *,
        answer: SettingIndex | None = None,
    ) -> None:
        context = self._context
        notices = EndNotices(
            reports.on_motors_done(busy, joints),
            lambda _reason: reports.on_motors_failed(
                busy, context.state(), joints, context.clock()
            ),
        )
        self._pending.begin(busy, started, Request(context, frames, seen), notices, answer=answer)
        context.refresh()
