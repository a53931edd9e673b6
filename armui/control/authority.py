"""Knows who moves the arm and what our own command is: pure, fed by frames heard and sent.

Every part that moves the arm asks here first, and reports here what it has sent. The next step
starts from the target of our command while that is the last one the arm received; `End` lists what
ends a command.
"""

from __future__ import annotations

import math
from collections.abc import Container, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.devices.teaching_phase import is_own_replay
from armui.control.link.link_state import NOT_CONNECTED
from armui.control.motion.motion_command import (
    CommandKind,
    End,
    Hold,
    MotionCommand,
    Mover,
    Observation,
    why_held,
)
from armui.control.safety.feedback_freshness import (
    FEEDBACK_SILENT,
    any_motor_off,
    in_drag_teaching,
    late_angles,
    why_silent,
)
from armui.control.safety.interlocks import JOINTS_UNKNOWN, MOVABLE_STATUSES
from armui.control.safety.other_command import OtherCommand
from armui.control.safety.overspeed import OverspeedWatch
from armui.control.safety.standstill import RestWatch, why_moving
from armui.protocol.codes import ArmStatusCode, ControlMode, MoveMode

if TYPE_CHECKING:
    from armui.arm.limits import JointLimits
    from armui.arm.state import ArmState
    from armui.control.operations.started import Started
    from armui.control.safety.overspeed import ToolPace
    from armui.kinematics.poses import Matrix
    from armui.ways.way import Way

PART_FAILED = Reason(
    "part_failed",
    "A part of the program has failed: every motion of this program ends, and none begins "
    "while it fails. Copy the details of the error, then start the program again.",
)


MET_MOVING = Reason(
    "met_moving",
    "The arm was moving when it was first heard, and not by a command of this connection. Wait "
    "until it rests, or press Halt (F9).",
)

ARRIVED_DEG: Final = 0.5
"""A joint this close to its target has arrived: under load it may sag by this angle."""

_TAKEN_IN_S: Final = 0.3
"""For this long after a frame was sent, the status last heard may be older than the frame."""
_BEGINS_S: Final = 0.1
"""An arm that was given a target says within this time that it has not reached it."""
_SHOWN_S: Final = 0.05
"""A status received this long after a mode word was sent already shows the new mode."""
_REST_SHOWS_S: Final = 0.4
"""If the arm begins to move only as a cancel arrives, the motion is measured within this time."""
_CANCEL_WITHIN_S: Final = 1.0
"""After a cancel the arm is measured at rest within this time."""
_REPLAY_SHOWS_S: Final = 1.5
"""An arm that was told to follow its own recording reports that within this time."""
_OURS: Final = frozenset({ControlMode.STANDBY, ControlMode.CAN_CONTROL})
_PLANNED: Final = frozenset({MoveMode.MOVE_P, MoveMode.MOVE_J, MoveMode.MOVE_L, MoveMode.MOVE_C})
_CANCEL_AGAIN_S: Final = 0.3
"""If the arm still moves this long after a cancel, the cancel is sent again: it may be lost."""
_MOVING_FRESH_S: Final = 0.05
"""The angles of a moving arm are too old to set out from after this time."""


class Authority:
    """Knows who moves the arm, and whether this program may move it.

    Attributes:
        command: Our own command, as long as a step may start from its target.
        ended: The cause that ended our last command.
        over: The commands that have ended, each with its cause, until somebody takes them from
            here.
        holds: The causes that hold back a motion in the arm; it stays there until it is cancelled.
        arm_percent: The speed percentage this program gave the arm last; ``None`` if another host
            may have changed it since.
        cancel_unheeded: A cancel was sent, and the arm is not at rest a second later.
        other: Follows what another host does to the arm.
        overspeed: The measured speed and the speed shown, where our motion is far too fast.
        failed: A part of the program fails at each look: no motion of ours may begin.
        revision: Counts up with each command of ours and with each end: what waited to be checked
            before is void.
        unconfirmed_cell: The reason against a motion while the cell kept for the adapter is not
            confirmed, or ``None``.
    """

    def __init__(self) -> None:
        self._number = 0
        self._rest = RestWatch()
        self._overspeed = OverspeedWatch()
        self._seen: Observation | None = None
        self._silent: Refusal | None = NOT_CONNECTED()
        self._cancelled_s: float | None = None
        self._replay_s: float | None = None
        """When the arm was told to follow its own recording; ``None`` once that is over."""
        self._held_since_s = 0.0
        self._mode_sent: tuple[MoveMode, float] | None = None
        self._mode_left_s = -math.inf
        """The earliest time at which the last mode word can have left; it may wait in the queue."""
        self._limits: tuple[JointLimits | None, ...] = ()
        self._taken_in_s = -math.inf
        """When the newest command was sent that the arm, by its feedback, had time to take in."""
        self._given_s = -math.inf
        """When the arm was last sent a target, or told to continue to one."""
        self._braking: tuple[float, int] | None = None
        self._stood = False
        self._left_by_another = True
        self._cut_short = False
        self._met_moving = True
        self._goes_on = False
        self._last: MotionCommand | None = None
        """The command that ended last: the arm may go on to its target."""
        self._cancel_repeated = False
        self.other = OtherCommand()
        self.command: MotionCommand | None = None
        self.ended: End | None = None
        self.over: list[tuple[MotionCommand, End]] = []
        self.holds: frozenset[Hold] = frozenset()
        self.arm_percent: int | None = None
        self.cancel_unheeded = False
        self.overspeed: Refusal | None = None
        self.failed = False
        self.revision = 0
        self.unconfirmed_cell: Refusal | None = None

    # Observation --------------------------------------------------------------------------------

    def observe(self, seen: Observation) -> None:
        """Take in an observation; end our command if something has ended it."""
        self._seen, self._silent = seen, why_silent(seen.state, seen.now_s)
        state, now_s = seen.state, seen.now_s
        command = self.command
        if command is not None and state.in_time_for_s(now_s, command.sent_s) >= _TAKEN_IN_S:
            self._taken_in_s = command.sent_s
        self._rest.observe(state, now_s)
        if self.other.observe(seen.traffic, seen.offsets, state, now_s, at_rest=self.at_rest):
            self.arm_percent = self._mode_sent = None
            self.holds = frozenset()
            self._left_by_another, self._goes_on, self._cut_short = True, False, False
            self._replay_s = None
        self._follow_replay(state)
        end = self._what_ends(seen)
        if end is not None:
            self._end(end)
        if seen.waiting and self.command is not None:
            # The feedback cannot show the mode or the end of a command that still waits in the
            # queue.
            self.command, self._held_since_s = replace(self.command, sent_s=now_s), now_s
            if self._mode_left_s > self._taken_in_s:
                self._mode_left_s = now_s
        self._follow_hold(seen)
        self._stood = self._stood or self.at_rest
        status = state.status
        arrived = status is not None and status.fresh(now_s) and status.value.reached
        self._met_moving = self._met_moving and not self.at_rest and not arrived
        self._follow_cancel(now_s)
        pace = None if self.command is None else self.command.pace
        shown, braking = self._percent_shown, self._braking
        if shown is not None and braking is not None and now_s < braking[0]:
            shown = max(shown, braking[1])
        self.overspeed = self._overspeed.observe(
            state, shown, seen.factory_limits, seen.accelerations_deg_s2, pace
        )

    @property
    def at_rest(self) -> bool:
        """True if the measured angles show that the joints stand still."""
        return self._rest.at_rest

    @property
    def under_way(self) -> bool:
        """True if our command moves the arm, or may be about to."""
        seen, command = self._seen, self.command
        if seen is None or command is None:
            return False
        return command.sent_s > self._taken_in_s or self.moves

    @property
    def about_to_move(self) -> bool:
        """True from sending a target or «continue» until the arm has had the time to react.

        In that time it is not measured to move yet, and the frames may wait for the adapter.
        """
        status = None if self._seen is None else self._seen.state.status
        given_s = max(self._given_s, self._mode_left_s)
        told = status is not None and status.at_s >= given_s + _BEGINS_S
        return self.command is not None and not told

    @property
    def moves(self) -> bool:
        """True if the arm says that it has not reached its target, and is measured to move."""
        seen = self._seen
        status = None if seen is None else seen.state.status
        return status is not None and not status.value.reached and not self.at_rest

    @property
    def may_be_ours(self) -> bool:
        """True if a motion is under way, or held back, that this program may have begun.

        An arm that goes on to a target of ours moves by our doing, also when that target has ended
        to be one to start from, as after other limits were read; unless somebody else is known to
        move it. So does one that follows its own recording by our word.
        """
        if self.under_way or self.holds or self._replay_s is not None:
            return True
        nobody_else = self.mover in {Mover.OURS, Mover.UNKNOWN}
        return self.moves and nobody_else and not self.is_ending

    def carries_out(self, records: Container[Started]) -> bool:
        """Return whether what moves the arm, or is about to, carries out one of these operations.

        A command of ours that has ended, as by a silence, may go on in the arm.
        """
        command = self.command or self._last
        return command is not None and command.started in records and self.may_be_ours

    @property
    def is_ending(self) -> bool:
        """True if the arm was told to end its motion and is not measured at rest since."""
        return self._cancelled_s is not None

    @property
    def is_braking(self) -> bool:
        """True if the arm comes to rest at a cancel: no motion is left that could be held back."""
        return self.is_ending and not self.cancel_unheeded

    @property
    def mover(self) -> Mover:
        """The party that moves the arm now."""
        seen = self._seen
        if seen is None or not seen.online or self._silent is not None:
            return Mover.UNKNOWN
        no_power = any_motor_off(seen.state, seen.now_s)
        if no_power is not False:
            return Mover.GRAVITY if no_power else Mover.UNKNOWN
        if in_drag_teaching(seen.state):
            return Mover.HAND
        if self.other.drives:
            return Mover.LEADER if self.other.is_leader else Mover.OTHER_HOST
        if self.under_way or self.holds:
            return Mover.OURS
        return Mover.NOBODY if self.at_rest else Mover.UNKNOWN

    def why_not(self) -> Refusal | None:
        """Return the reason against sending any motion frame now, or ``None``."""
        return self.why_not_ours() or self.unconfirmed_cell or self.why_held()

    def why_not_ours(self) -> Refusal | None:
        """Return the reason against going on with our motion that is held back, or ``None``."""
        met = self._met_moving and self.moves and not self.holds
        return self._why_nothing() or (MET_MOVING() if met else None)

    def why_no_speed(self, percent: float) -> Refusal | None:
        """Return the reason against another speed of what the arm does, or ``None``.

        What somebody else may have left in the arm waits for a motion of ours; where it was ours
        that went on while nothing was heard, it may be slowed.

        Args:
            percent: The speed; 0 holds back whatever moves.
        """
        refusal = self._why_nothing()
        if refusal is not None or not percent:
            return refusal
        slows = self._goes_on and self.moves and self.lowers_speed(percent)
        left = MET_MOVING() if self.may_hold_another and not slows else None
        return left or self.unconfirmed_cell or self.why_held()

    def _why_nothing(self) -> Refusal | None:
        """Return the reason against any frame about motion, or ``None``."""
        failed = PART_FAILED() if self.failed else None
        return failed or self.why_silent() or self.other.why_not()

    def take_over(self) -> Refusal | None:
        """Take the arm over from another host, deliberately; return ``None``, or why not."""
        refusal = self.other.take_over()
        if refusal is None:
            self._met_moving = False
        return refusal

    def why_silent(self) -> Refusal | None:
        """Return the missing feedback that a motion relies on, as a reason, or ``None``."""
        return self._silent

    def why_held(self) -> Refusal | None:
        """Return the motion held back in the arm as a reason against another one, or ``None``."""
        return why_held(self.holds)

    @property
    def held_target_deg(self) -> tuple[float, ...] | None:
        """The six target angles of the motion held back; ``None`` if none is, or if unknown."""
        return self.command.joints_deg if self.holds and self.command is not None else None

    @property
    def may_hold_another(self) -> bool:
        """True if the arm stands short of a target that is not ours: 0x151 may set it going.

        Another host has paused it, or its word to go on, which was heard here, has not reached the
        arm; or it was held back before this program came.
        """
        status = None if self._seen is None else self._seen.state.status
        short = status is None or not status.value.reached
        return self._left_by_another and self.command is None and short

    @property
    def seems_to_hold_another(self) -> bool:
        """True as :attr:`may_hold_another`, unless our own cancel left the arm short of its target.

        What another host sent during a silence is not known, so a held motion is dropped before the
        next one; but an arm whose feedback was merely late is not reported to hold one back.
        """
        return self.may_hold_another and not self._cut_short

    def joint_base_deg(self) -> tuple[float, ...] | None:
        """Return the six angles that a step or jog of a joint starts from; ``None``: unknown.

        Our own target while it is the last command and the arm is on its way or there, so that
        steps add up and a sagging arm does not creep; otherwise where the arm is measured.
        """
        command = self.command
        if command is None or command.joints_deg is None:
            return self.measured_deg()
        return command.joints_deg

    def measured_deg(self) -> tuple[float, ...] | None:
        """Return six measured angles fresh enough to start from, or ``None``.

        Of an arm that moves, or was given a target since, angles that are no longer the newest tell
        where it was.
        """
        seen = self._seen
        if seen is None:
            return None
        late = late_angles(seen.state, seen.now_s, _MOVING_FRESH_S)
        given_since = late_angles(seen.state, self._given_s, 0.0)
        rests = self.at_rest and not given_since
        return None if late and not rests else seen.state.angles_deg()

    def why_unmeasured(self) -> Refusal:
        """Return why there are no angles to start from: some were never heard, or come late."""
        seen = self._seen
        if seen is None or seen.state.angles_deg() is None:
            return JOINTS_UNKNOWN()
        late = late_angles(seen.state, seen.now_s, _MOVING_FRESH_S)
        return FEEDBACK_SILENT(frames=", ".join(late), seconds=_MOVING_FRESH_S)

    def tool_base(self) -> Matrix | None:
        """Return the tool's last target while it is ours, even if the tool has not reached it."""
        return None if self.command is None else self.command.tool

    def lowers_speed(self, percent: float) -> bool:
        """Return whether a percentage is below the arm's, so that it must precede the target."""
        seen = self._seen
        status = None if seen is None else seen.state.status
        told = None if status is None else status.value.speed_percent
        known = [each for each in (told, self.arm_percent) if each is not None]
        return not known or percent < max(known)

    @property
    def most_percent(self) -> int:
        """The highest speed, in %, that the present motion may be given; some are capped."""
        command, seen = self.command, self._seen
        status = None if seen is None else seen.state.status
        arrived = not self.under_way and status is not None and status.value.reached
        return 100 if command is None or arrived else command.most_percent

    def mode_in_force(self) -> tuple[ControlMode, MoveMode] | None:
        """Return the arm's modes: as reported, or as sent if it had no time to report them.

        ``None`` where a mode word with them cannot be sent: they are unknown, or another host has
        the command.
        """
        seen = self._seen
        status = None if seen is None else seen.state.status
        if status is None:
            return None
        if self._mode_sent is not None and status.at_s < self._mode_left_s + _SHOWN_S:
            return ControlMode.CAN_CONTROL, self._mode_sent[0]
        told = status.value
        if told.control_mode not in _OURS or told.move_mode not in _PLANNED:
            return None
        return ControlMode(told.control_mode), MoveMode(told.move_mode)

    @property
    def mode_unproven(self) -> bool:
        """True if the last mode word of ours may be lost: the arm had no time to report its mode.

        The target before it would then wait in the arm for the next mode word, whatever that is.
        """
        sent, status = self._mode_sent, None if self._seen is None else self._seen.state.status
        return sent is not None and (status is None or status.at_s < sent[1] + _SHOWN_S)

    # Commands sent ------------------------------------------------------------------------------

    def begin(
        self,
        kind: CommandKind,
        *,
        now_s: float,
        move_mode: MoveMode,
        speed_percent: int,
        joints_deg: Sequence[float] | None = None,
        tool: Matrix | None = None,
        leads_away: bool = False,
        pace: ToolPace | None = None,
        started: Started | None = None,
        way: Way | None = None,
        most_percent: int = 100,
    ) -> MotionCommand:
        """Make a new command of ours the current one, in the place of the last.

        Args:
            kind: Its kind.
            now_s: Monotonic time.
            move_mode: The kind of motion in its mode word.
            speed_percent: The speed percentage it is sent with.
            joints_deg: Six target angles, where it names them.
            tool: The target of the tool centre point, where it names it.
            leads_away: True if the tool was measured elsewhere than its target.
            pace: The tool's speed at 100 % along a line or an arc.
            started: The operation that it carries out.
            way: The way that the gate has passed.
            most_percent: The highest speed that it may be given on its way.
        """
        if self.moves:
            self._slow_down(0, now_s)
        else:
            self._braking = None
        self._end(End.REPLACED)
        self._number += 1
        self.revision += 1
        target_deg = None if joints_deg is None else tuple(joints_deg)
        self.command = MotionCommand(
            *(self._number, kind, now_s, speed_percent, target_deg, tool, leads_away, pace),
            started,
            way,
            most_percent,
        )
        self.arm_percent, self._mode_sent = speed_percent, (move_mode, now_s)
        self._mode_left_s = now_s
        self._given_s = now_s
        self._cancelled_s, self.cancel_unheeded = None, False
        self._left_by_another = self._met_moving = self._cancel_repeated = False
        self._cut_short = False
        self._limits = (None,) * 6
        self._overspeed.change_speed()
        return self.command

    def is_current(self, command: MotionCommand) -> bool:
        """Return whether a command is still the last one given to the arm."""
        return self.command is not None and self.command.number == command.number

    def extend(
        self, command: MotionCommand, joints_deg: Sequence[float], now_s: float
    ) -> MotionCommand | None:
        """Note the next setpoint of a stream; return ``None`` if its command is no longer ours."""
        if not self.is_current(command):
            return None
        self.command = replace(command, joints_deg=tuple(joints_deg), sent_s=now_s)
        self._given_s = now_s
        return self.command

    def replay_told(self, now_s: float) -> None:
        """Note that the arm is told to follow its own recording, or to go to its start."""
        self._replay_s = now_s

    def told_percent(self, percent: int) -> None:
        """Note that another speed percentage was sent."""
        self.arm_percent = percent
        seen = self._seen
        if percent > 0:
            command = self.command
            if command is not None:
                if seen is not None:
                    self._slow_down(percent, seen.now_s)
                self.command = replace(command, speed_percent=percent)
                self._overspeed.change_speed()
        elif seen is not None and (self.under_way or self.moves) and not self.is_braking:
            self._hold(Hold.SPEED_ZERO, seen.now_s)

    def paused(self) -> None:
        """Note that a pause was sent (0x150 byte 1 = 1)."""
        if self._seen is None:
            self.holds |= {Hold.PAUSE}
        else:
            self._hold(Hold.PAUSE, self._seen.now_s)

    def _hold(self, hold: Hold, now_s: float) -> None:
        """Note what holds the motion back: from now on the arm is shown to stand."""
        self._held_since_s = self._held_since_s if self.holds else now_s
        self.holds |= {hold}
        self._slow_down(0, now_s)
        self._overspeed.change_speed()
        self._stood = False

    def went_on(self, now_s: float) -> None:
        """Note that the arm was told to continue a motion that was held back."""
        self.holds = frozenset()
        self._left_by_another = self._met_moving = False
        self._given_s = now_s
        self._overspeed.change_speed()
        if self.command is not None:
            self.command = replace(self.command, sent_s=now_s)

    def cancelled(self, now_s: float, end: End = End.CANCELLED) -> None:
        """Note that the arm was told to end its motion: an earlier command never comes back.

        Args:
            now_s: Monotonic time.
            end: The cause by which our command ends.
        """
        self._end(end)
        self.revision += 1
        self.holds = frozenset()
        self._replay_s = None
        self._left_by_another = self._met_moving = self._cancel_repeated = False
        self._cut_short = True
        self._cancelled_s, self.cancel_unheeded = now_s, False

    def cancel_is_due(self, now_s: float) -> bool:
        """Return whether the cancel is to be sent once more; true once for each cancel.

        Its frame may be lost: the joints still move when they could have begun to brake.
        """
        seen, cancelled_s = self._seen, self._cancelled_s
        if seen is None or cancelled_s is None or self._cancel_repeated:
            return False
        self._cancel_repeated = now_s - cancelled_s >= _CANCEL_AGAIN_S
        return self._cancel_repeated and why_moving(seen.state) is not None

    def end_command(self, reason: End) -> None:
        """End our command: no step starts from its target any more."""
        self._end(reason)
        self.revision += 1
        if reason in {End.STOPPED, End.DISABLED, End.FORGOTTEN}:
            self.holds = frozenset()
            self._replay_s = None
            self._cancelled_s, self.cancel_unheeded = None, False
        if reason in {End.SILENT, End.FORGOTTEN}:
            self._left_by_another = self._met_moving = True
        if reason is End.FORGOTTEN:
            self._cut_short = False
            self._forget()

    @property
    def number(self) -> int:
        """The number of the newest command; frames of lower numbers are outdated."""
        return self._number

    # Evaluation ---------------------------------------------------------------------------------

    def _end(self, reason: End) -> None:
        if self.command is None:
            return
        self.over.append((self.command, reason))
        self._last = self.command
        self._goes_on = reason is End.SILENT and self.under_way
        self.command = None
        self.ended = reason
        self._number += 1

    def _slow_down(self, percent: int, now_s: float) -> None:
        """Allow a line or an arc its former speed for the time that it takes to brake."""
        command = self.command
        if command is None or command.pace is None:
            return
        before = command.speed_percent
        if self._braking is not None and now_s < self._braking[0]:
            before = max(before, self._braking[1])
        if percent < before:
            self._braking = now_s + command.pace.slowed_within_s(before - percent), before

    def _forget(self) -> None:
        self.other.reconnected()
        self.arm_percent = self._mode_sent = None
        self._rest.reset()
        self._seen, self._silent = None, NOT_CONNECTED()

    @property
    def _percent_shown(self) -> int | None:
        """The speed, in %, to compare our motion with; ``None`` for replays, watched by their lag.

        One that is held back comes to a stand; once it has, a hand may move it.
        """
        command = self.command
        if command is None or command.kind is CommandKind.REPLAY or not self.under_way:
            return None
        if not self.holds:
            return command.speed_percent
        return None if self._stood else 0

    def _what_ends(self, seen: Observation) -> End | None:
        command = self.command
        if command is None:
            return None
        if self.other.last_s is not None and self.other.last_s >= command.sent_s:
            return End.OTHER_HOST
        if self._silent is not None:
            return End.SILENT
        return (
            self._what_arm_says(seen.state, command, seen.now_s)
            or self._whether_limits_changed(seen.state)
            or self._whether_moved(seen.state, command)
        )

    def _whether_limits_changed(self, state: ArmState) -> End | None:
        known = tuple(None if each is None else each.value for each in state.limits)
        before, self._limits = self._limits, known
        changed = any(
            a is not None and b is not None and a != b for a, b in zip(before, known, strict=True)
        )
        return End.LIMITS_CHANGED if changed else None

    def _what_arm_says(self, state: ArmState, command: MotionCommand, now_s: float) -> End | None:
        status = state.status
        if status is None:
            return End.SILENT
        if status.value.arm_status == ArmStatusCode.EMERGENCY_STOP:
            return End.STOPPED
        if any_motor_off(state, now_s):
            return End.DISABLED
        if in_drag_teaching(state):
            return End.TAUGHT
        # In this status the arm may still move, but not to our target: no step starts from that
        # (S8).
        if status.value.arm_status not in MOVABLE_STATUSES:
            self.command = replace(command, joints_deg=None, tool=None)
        taken_in = command.sent_s <= self._taken_in_s
        late = taken_in and status.at_s - command.sent_s > _TAKEN_IN_S
        if late and status.value.control_mode != ControlMode.CAN_CONTROL:
            return End.OTHER_MODE
        return None

    def _whether_moved(self, state: ArmState, command: MotionCommand) -> End | None:
        measured_deg = state.angles_deg()
        seen = self._seen
        if seen is None or not state.in_time(seen.now_s):
            return None  # late angles do not show whether it moved
        if self.under_way or self.holds or measured_deg is None:
            return None
        if command.joints_deg is None:
            # The target was a pose, for which the arm chose the angles: those it rests at become
            # the target.
            self.command = replace(command, joints_deg=measured_deg)
            return None
        away_deg = max(
            abs(asked - measured)
            for asked, measured in zip(command.joints_deg, measured_deg, strict=True)
        )
        return End.MOVED_AWAY if away_deg > ARRIVED_DEG else None

    def _follow_hold(self, seen: Observation) -> None:
        """Clear the holds of a motion that the arm itself has finished or dropped."""
        status = seen.state.status
        if not self.holds or status is None or not status.fresh(seen.now_s):
            return
        in_time = seen.state.in_time_for_s(seen.now_s, self._held_since_s) > _TAKEN_IN_S
        taken_in = in_time and status.at_s - self._held_since_s > _TAKEN_IN_S
        if status.value.reached and taken_in:
            self.holds -= {Hold.SPEED_ZERO}  # it had arrived already
        left = taken_in and status.value.control_mode != ControlMode.CAN_CONTROL
        stopped = status.value.arm_status == ArmStatusCode.EMERGENCY_STOP
        if left or stopped or any_motor_off(seen.state, seen.now_s):
            self.holds = frozenset()

    def _follow_replay(self, state: ArmState) -> None:
        told_s, status = self._replay_s, state.status
        if told_s is None or status is None or is_own_replay(status.value):
            return
        if status.at_s - told_s > _REPLAY_SHOWS_S:
            self._replay_s = None

    def _follow_cancel(self, now_s: float) -> None:
        if self._cancelled_s is None:
            return
        since_s = now_s - self._cancelled_s
        state = None if self._seen is None else self._seen.state
        status = None if state is None else state.status
        # Feedback that arrives late shows neither rest nor motion.
        in_time_s = 0.0 if state is None else state.in_time_for_s(now_s, self._cancelled_s)
        shows = in_time_s >= _REST_SHOWS_S
        stopped = status is not None and status.value.arm_status == ArmStatusCode.EMERGENCY_STOP
        replays = status is not None and is_own_replay(status.value)
        led = state is not None and in_drag_teaching(state) and not replays
        # Another host, a stop or a hand controls the arm now: our cancel has nothing left to end.
        moved = self.other.commands or stopped or led
        if moved or (self.at_rest and shows):
            self._cancelled_s, self.cancel_unheeded = None, False
        elif since_s > _CANCEL_WITHIN_S and shows:
            self.cancel_unheeded = True
