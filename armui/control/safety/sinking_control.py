"""Reports to the operator while the arm moves without power or without a command."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from armui.arm.limits import JOINTS
from armui.control.context import ControllerPart
from armui.control.devices.teaching_phase import TeachingPhase, is_own_replay, phase_of
from armui.control.events import Notice
from armui.control.link.link_state import LinkState
from armui.control.operating_state import Busy, StopState
from armui.control.safety.emergency_stop import is_stopped
from armui.control.safety.feedback_freshness import in_drag_teaching
from armui.control.safety.sinking import ALL_JOINTS, SinkingWatch, WatchedMotion
from armui.control.safety.uncommanded_motion import MotionKind, UncommandedMotion, Unheld
from armui.kinematics.forward import flange_rows, joint_places
from armui.protocol.codes import ControlMode
from armui.telemetry.events import Asker, EventKind, Level

if TYPE_CHECKING:
    from armui.arm.models import Rising
    from armui.arm.state import Status
    from armui.control.context import Context
    from armui.control.operating_state import OperatingState

ARM_SINKS = Notice(
    "arm_sinks",
    "The arm sinks, and no motor holds it. Hold it. Below it: {below}.",
    Level.WARNING,
    EventKind.STATUS,
)
ARM_JOINT_UNHELD = Notice(
    "arm_joint_unheld",
    "No motor holds joint {joint}, and the arm gives way there. Hold it. Below it: {below}.",
    Level.WARNING,
    EventKind.STATUS,
)
ARM_SINKS_POWERED = Notice(
    "arm_sinks_powered",
    "The arm sinks though its motors are on. Hold it. Below it: {below}.",
    Level.WARNING,
    EventKind.STATUS,
)
ARM_SINKS_ON = Notice(
    "arm_sinks_on",
    "The arm sinks on: {down} mm in {seconds} s, joint {joint} by {turned}°, now at {speed} mm/s.",
    Level.WARNING,
    EventKind.STATUS,
)
ARM_MOVES_UNHELD = Notice(
    "arm_moves_unheld",
    "The arm moves, and no motor holds it: joint {joint} by {turned}°.",
    Level.WARNING,
    EventKind.STATUS,
)
ARM_MOVES_UNTOLD = Notice(
    "arm_moves_untold",
    "The arm moves, and nothing told it to: joint {joint} by {turned}°.",
    Level.WARNING,
    EventKind.STATUS,
)
ARM_MOVES_ON = Notice(
    "arm_moves_on",
    "The arm moves on: joint {joint} by {turned}° in {seconds} s, now at {speed} mm/s.",
    Level.WARNING,
    EventKind.STATUS,
)
ARM_RESTS = Notice(
    "arm_rests",
    "The arm is measured at rest: in {seconds} s it came down by {down} mm, joint {joint} turned "
    "by {turned}°.",
    Level.INFO,
    EventKind.STATUS,
)
ARM_HELD_AGAIN = Notice(
    "arm_held_again",
    "The arm is held again: in {seconds} s it came down by {down} mm, joint {joint} turned by "
    "{turned}°.",
    Level.INFO,
    EventKind.STATUS,
)
ARM_UNHEARD_MOVING = Notice(
    "arm_unheard_moving",
    "The arm moved at {speed} mm/s when it was last heard: it may be moving.",
    Level.WARNING,
    EventKind.LINK,
    Asker.PROGRAM,
)

FURTHER_MM: Final = 50
FURTHER_DEG: Final = 10.0
"""A motion that goes on is reported again from one of these further distances on."""
FURTHER_S: Final = 2.0
"""Further distances are reported at intervals of at least this time."""

_LOOKED_BELOW_S: Final = 1.0
_UNTOLD: Final = frozenset(
    {Unheld.STOP_AWAITED, Unheld.DRAG_TEACHING, Unheld.OWN_REPLAY, Unheld.LED}
)
"""Causes that are shown without an event: the stop or the replay has one, or a hand may lead."""


class SinkingControl(ControllerPart):
    """Knows why the arm may move without a command, and tells how far it does.

    Args:
        context: The context that the controller's parts share.
        height_mm: Returns the height of the lowest of flange, fingertip and held object at six
            angles.
        rising: Returns how the base stands in the room.
        below: Returns the names of the parts of the work area below the arm; "" for none.
    """

    def __init__(
        self,
        context: Context,
        height_mm: Callable[[Sequence[float]], float],
        rising: Callable[[], Rising],
        below: Callable[[], str],
    ) -> None:
        self._context = context
        self._rising = rising
        self._look_below = below
        self._watch = SinkingWatch(height_mm, self._flange_mm, self._weight_mm, self._below)
        self._below_now = ""
        self._reset()

    def _reset(self) -> None:
        self._watch.reset()
        self._expects_motion = True
        self._reported: UncommandedMotion | None = None
        self._reported_s = self._looked_s = -math.inf

    @property
    def motion(self) -> UncommandedMotion | None:
        """The motion of an arm that nothing holds or told to move, or that is silent, if any."""
        return self._watch.motion

    # A part of the controller -----------------------------------------------------------------

    def follow_arm(self) -> None:
        """Evaluate the feedback; called at each tick while a device is open."""
        context = self._context
        device = context.connection.device
        if device is None:
            return
        now = context.operating_state()
        heard = now.link is LinkState.ONLINE and context.authority.why_silent() is None
        if not heard and device.recorded is not None:
            self._reset()  # silence in a replay: the log is paused, or another place was chosen
            return
        self._expects_motion |= not heard
        cause, joints = self._cause(now) if heard else (None, ALL_JOINTS)
        self._watch.observe(
            WatchedMotion(
                context.connection.newest,
                context.clock(),
                cause,
                joints,
                heard=heard,
                counted_anew=now.busy is Busy.ZEROING,
            )
        )
        self._emit_events()

    def forget_arm(self) -> None:
        """Forget the arm; one whose device is lost may be moving."""
        context = self._context
        device = context.connection.device
        recorded = device is None or device.recorded is not None
        if context.connection.link is not LinkState.LOST or recorded:
            self._reset()
            return
        watched = WatchedMotion(context.connection.newest, context.clock(), None, heard=False)
        self._watch.observe(watched)
        self._emit_events()

    # Causes -----------------------------------------------------------------------------------

    def _cause(self, now: OperatingState) -> tuple[Unheld | None, tuple[int, ...]]:
        """Return why the arm may move without a command, and the joints that may."""
        context = self._context
        authority, state = context.authority, context.connection.newest
        status = None if state.status is None else state.status.value
        off = tuple(joint for joint, on in zip(JOINTS, now.enabled, strict=True) if on is False)
        if is_stopped(state):
            self._expects_motion = False
            return Unheld.STOPPED, ALL_JOINTS
        if off:
            self._expects_motion = False
            return (Unheld.MOTORS_OFF if off == ALL_JOINTS else Unheld.JOINTS_OFF), off
        if in_drag_teaching(state):
            self._expects_motion = True
            replays = status is not None and phase_of(status) is TeachingPhase.REPLAYING
            coasts = self.motion is not None and self.motion.cause is Unheld.OWN_REPLAY
            own = Unheld.OWN_REPLAY if replays or coasts else Unheld.DRAG_TEACHING
            return (Unheld.LED if _is_led(status) else own), ALL_JOINTS
        if now.stop is StopState.REQUESTED and not now.stop_lapsed:
            return Unheld.STOP_AWAITED, ALL_JOINTS
        told = authority.other.drives or authority.under_way or bool(authority.holds)
        replays = status is not None and is_own_replay(status)
        if told or replays or authority.is_ending:
            self._expects_motion = True
        elif authority.at_rest:
            self._expects_motion = False
        untold = authority.cancel_unheeded or not self._expects_motion
        powered = all(now.enabled)
        return (Unheld.NOT_TOLD if untold and powered else None), ALL_JOINTS

    # Measured figures -------------------------------------------------------------------------

    def _flange_mm(self, joints_deg: Sequence[float]) -> Sequence[float]:
        rows = flange_rows(self._context.operating_state().model_fit.geometry, joints_deg)
        return rows[3::4]

    def _weight_mm(self, joints_deg: Sequence[float]) -> float:
        """Return the mean height of elbow, wrist and flange: where they come down, so does it."""
        geometry = self._context.operating_state().model_fit.geometry
        up = self._rising()[:3]
        heights_mm: list[float] = [
            sum(part * value for part, value in zip(up, place, strict=True))
            for place in joint_places(geometry, joints_deg)
        ]
        return sum(heights_mm) / len(heights_mm)

    def _below(self) -> str:
        """Return the names of what is below; found once a second, as it checks all of the area."""
        now_s = self._context.clock()
        if now_s - self._looked_s >= _LOOKED_BELOW_S:
            self._looked_s, self._below_now = now_s, self._look_below()
        return self._below_now

    # Notices ----------------------------------------------------------------------------------

    def _emit_events(self) -> None:
        """Report the beginning, each further distance worth an event, and the whole at the end."""
        watch = self._watch
        if watch.ended is not None:
            (whole, at_rest), watch.ended = watch.ended, None
            if self._reported is not None:
                self._announce(ARM_RESTS if at_rest else ARM_HELD_AGAIN, whole)
            self._reported = None
        motion, now_s, told = watch.motion, self._context.clock(), self._reported
        if motion is None or motion.kind in {MotionKind.UNMEASURED, MotionKind.LED}:
            return
        if motion.kind is MotionKind.UNHEARD:
            unheard = told is not None and told.kind is MotionKind.UNHEARD
            self._reported = motion
            if not unheard and motion.speed_mm_s:
                self._context.emit_event(ARM_UNHEARD_MOVING, speed=motion.speed_mm_s)
            return
        if motion.cause in _UNTOLD:
            return
        if told is None or told.kind is MotionKind.UNHEARD:
            self._announce(_begins(motion), motion)
        elif now_s - self._reported_s < FURTHER_S:
            return
        elif _is_further(motion, told):
            sinks = motion.kind is MotionKind.SINKS and not motion.is_level
            self._announce(ARM_SINKS_ON if sinks else ARM_MOVES_ON, motion)
        else:
            return
        self._reported, self._reported_s = motion, now_s

    def _announce(self, notice: Notice, motion: UncommandedMotion) -> None:
        self._context.emit_event(notice, **motion.figures())


def _is_led(status: Status | None) -> bool:
    """Return whether a hand is known to lead: it records, or is a teaching input."""
    if status is None:
        return False
    leads = status.control_mode == ControlMode.LINKED_TEACHING_INPUT
    return leads or phase_of(status) is TeachingPhase.RECORDING


def _begins(motion: UncommandedMotion) -> Notice:
    if motion.cause is Unheld.JOINTS_OFF:
        return ARM_JOINT_UNHELD
    powered = motion.cause is Unheld.NOT_TOLD
    if motion.kind is MotionKind.SINKS:
        return ARM_SINKS_POWERED if powered else ARM_SINKS
    return ARM_MOVES_UNTOLD if powered else ARM_MOVES_UNHELD


def _is_further(motion: UncommandedMotion, told: UncommandedMotion) -> bool:
    """Return whether the arm has moved far enough since the last report."""
    turned = abs(motion.turned_deg - told.turned_deg) >= FURTHER_DEG
    return turned or abs(motion.down_mm - told.down_mm) >= FURTHER_MM
