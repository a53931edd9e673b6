"""Follows what another host does to the arm, and when this program may move it again: pure."""

from __future__ import annotations

import enum
import math
from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.protocol.addressing import OFFSETS
from armui.protocol.codes import MOVE_UNCHANGED, ArmStatusCode, ControlMode, MitMode, MoveMode

if TYPE_CHECKING:
    from armui.arm.other_hosts import FrameSeries, OtherTraffic
    from armui.arm.state import ArmState, Status

NOBODY_ELSE = Reason("nobody_else", "No other program moves the arm.")
OTHER_HOST_STREAMS = Reason(
    "other_host_streams",
    "The other program is still sending ({frames}): it can be taken over half a second after "
    "its last frame. Against a stream only the stop wins.",
)
OTHER_HOST = Reason(
    "other_host",
    "Another program controls the arm ({frames}). Wait until it has been quiet for 2 s and the "
    "arm rests, or take over when it pauses. The stop works at any time.",
)
OTHER_MODE = Reason(
    "other_mode",
    "Another program drives the arm in {other_mode} mode: a mode word of ours would leave its "
    "joints limp. End that program, hold the arm, and take the way back that the line above "
    "the panels offers.",
)
LEADER_ARM = Reason(
    "leader_arm",
    "A leader arm moves this arm ({frames}). Switch the leader off, or make it a motion "
    "output. The stop works at any time.",
)


_GONE_AFTER_S: Final = 2.0
"""Another host counts as moving the arm until this long after its last motion frame."""
_TAKE_OVER_AFTER_S: Final = 0.5
"""The operator may take over this long after the other host's last motion frame (S13)."""
_TAKEN_IN_S: Final = 0.3
"""A status received this long after a mode word already reflects it."""
_GRIPPER: Final = 0x159
_MODE_BYTE: Final = 1
_MIT_BYTE: Final = 3
"""The bytes of the mode word 0x151 with the move mode and with MIT."""
_LEAVING_S: Final = 0.5
"""The arm may still report the mode it leaves this long after our own mode word."""


class OtherMode(enum.Enum):
    """The modes in which any new mode word leaves the joints limp until their next setpoint."""

    MIT = "mit"
    CPV = "cpv"
    HIGH_FOLLOW = "high_follow"


_MODES: Final = {
    int(MoveMode.MOVE_M): OtherMode.MIT,
    int(MoveMode.MOVE_CPV): OtherMode.CPV,
    int(MoveMode.MOVE_M_FROM_1_8_8): OtherMode.MIT,
}


class OtherCommand:
    """Follows the motion frames of other hosts.

    Attributes:
        commands: True while another host moves the arm: until two seconds after its last motion
            frame and until the arm is at rest, unless the operator has taken over.
        is_leader: True if it is a leader arm, or streams like one.
        last_s: The time of its last motion frame.
        since_s: The time at which it began.
        series: Its recent motion frames; none while it pauses.
        mode: The mode it has left the arm in, if a mode word of ours would make the arm fall.
    """

    def __init__(self) -> None:
        self.commands = False
        self.is_leader = False
        self.last_s: float | None = None
        self.since_s: float | None = None
        self.series: tuple[FrameSeries, ...] = ()
        self._last_series: tuple[FrameSeries, ...] = ()
        self.mode: OtherMode | None = None
        self._now_s = 0.0
        self._sorted: tuple[OtherTraffic | None, tuple[int, ...]] = (None, ())
        self._motion: tuple[FrameSeries, ...] = ()
        self._void_before_s = self._left_s = -math.inf

    def observe(
        self,
        traffic: OtherTraffic,
        offsets: tuple[int, ...],
        state: ArmState,
        now_s: float,
        *,
        at_rest: bool,
    ) -> bool:
        """Take in what was heard and return whether another host has sent a motion frame since.

        Args:
            traffic: The frames of other hosts.
            offsets: The control offsets under which the arm may listen (0x470).
            state: The arm as heard.
            now_s: Monotonic time.
            at_rest: True if the arm is measured to stand still.
        """
        self._now_s = now_s
        if traffic is not self._sorted[0] or offsets != self._sorted[1]:
            self._sorted = (traffic, offsets)
            self._motion = traffic.motion(offsets)
            self.is_leader = traffic.leads(offsets)
        motion = self._motion
        last_s = max((each.last_s for each in motion), default=None)
        new = last_s is not None and (self.last_s is None or last_s > self.last_s)
        if new:
            self.last_s = last_s
            if not self.commands:
                self.commands, self.since_s = True, last_s
        elif self.last_s is not None and now_s - self.last_s >= _GONE_AFTER_S and at_rest:
            self.commands = False
        self.series = tuple(each for each in motion if now_s - each.last_s < _GONE_AFTER_S)
        # If the program reads late, its first frames are outdated already, but still identify it.
        self._last_series = self.series or self._last_series or motion
        self.mode = self._mode_of(traffic, offsets, state)
        return new

    def reconnected(self) -> None:
        """Note another connection; a host that moved the arm just before may still do so."""
        self.mode = None
        self._void_before_s = self._left_s = -math.inf

    def leave_mode(self, now_s: float) -> None:
        """Note that a mode word of the operator takes the arm out of the mode now.

        If the arm stays in it, the mode soon counts again.
        """
        self.commands, self.mode = False, None
        self._left_s = now_s

    @property
    def drives(self) -> bool:
        """True if another host commands the arm, or has left it in a mode."""
        return self.commands or self.mode is not None

    def _mode_of(
        self, traffic: OtherTraffic, offsets: tuple[int, ...], state: ArmState
    ) -> OtherMode | None:
        """Return the mode in 0x2A1 byte 2, or in a mode word the arm has not reported.

        0x2A1 shows high-follow as MOVE J: it lasts until the arm is seen to have left it. A stop
        ends any of them, though 0x2A1 goes on showing the mode that was asked for last.
        """
        status = state.status
        if status is not None and status.value.arm_status == ArmStatusCode.EMERGENCY_STOP:
            self._void_before_s = self._now_s
        asked = (traffic.mode_word(offsets), traffic.mit_frames(offsets), traffic.cpv_frames())
        newest_s = max((each.last_s for each in asked if each is not None), default=-math.inf)
        leaves = self._left_s > newest_s and self._now_s < self._left_s + _LEAVING_S
        ended = leaves or self._void_before_s > newest_s
        shown = None if ended else _shown(state, self._now_s)
        word = asked[0]
        if word is None or len(word.data) <= _MIT_BYTE:
            return shown
        if word.last_s <= max(self._void_before_s, self._left_s):
            return shown
        move_mode, mit = word.data[_MODE_BYTE], word.data[_MIT_BYTE]
        follows = move_mode == MoveMode.MOVE_J and mit == MitMode.MIT
        if move_mode == MOVE_UNCHANGED:  # speed or mounting only
            left = status is not None and _has_left(status.value)
            return self.mode if self.mode is OtherMode.HIGH_FOLLOW and not left else shown
        if status is None or status.at_s < word.last_s + _TAKEN_IN_S:
            return _MODES.get(move_mode) or (OtherMode.HIGH_FOLLOW if follows else shown)
        if follows and _has_left(status.value):
            self._void_before_s = word.last_s
            return shown
        return OtherMode.HIGH_FOLLOW if follows else shown

    @property
    def may_be_taken_over(self) -> bool:
        """True if the operator may take the arm over; during a stream of commands never."""
        if not self.commands or self.last_s is None:
            return False
        return self._now_s - self.last_s >= _TAKE_OVER_AFTER_S

    def take_over(self) -> Refusal | None:
        """Take the arm over for the operator; return ``None``, or why not."""
        if not self.commands:
            return NOBODY_ELSE()
        if not self.may_be_taken_over:
            return OTHER_HOST_STREAMS(frames=self.frames)
        self.commands = False
        return None

    @property
    def frames(self) -> str:
        """The identifiers of its last motion frames, for a sentence."""
        return ", ".join(f"0x{each.arbitration_id:03X}" for each in self._last_series)

    @property
    def rate_hz(self) -> int:
        """The rate of its most frequent motion frame, rounded to two digits."""
        rate_hz = max((each.rate_hz for each in self.series), default=0.0)
        return 10 * round(rate_hz / 10.0) if rate_hz >= 20.0 else round(rate_hz)

    def has_commanded_gripper(self, since_s: float) -> bool:
        """Return whether another host has sent the gripper a command (0x159) after a time."""
        grippers = [each for each in self._motion if each.arbitration_id - _GRIPPER in OFFSETS]
        return any(each.last_s > since_s for each in grippers)

    def why_not(self) -> Refusal | None:
        """Return the reason against a motion of ours, or ``None``."""
        if self.mode is not None:
            return OTHER_MODE(other_mode=self.mode.value)
        if not self.commands:
            return None
        code = LEADER_ARM if self.is_leader else OTHER_HOST
        return Refusal(code, {"frames": self.frames})


def _shown(state: ArmState, now_s: float) -> OtherMode | None:
    status = state.status
    if status is None or not status.fresh(now_s):
        return None
    return _MODES.get(status.value.move_mode)


def _has_left(status: Status) -> bool:
    """Return whether the arm reports to have left the mode that a mode word with MOVE J set."""
    return status.control_mode != ControlMode.CAN_CONTROL or status.move_mode != MoveMode.MOVE_J
