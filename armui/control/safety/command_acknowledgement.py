"""Watches whether the arm takes up the motions sent, so that a lost one is noticed: pure.

A frame may be lost, or the arm may listen under other identifiers than the program speaks under: a
control offset it has kept (0x470) can be neither heard nor asked for.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.control.motion.motion_command import CommandKind, End
from armui.kinematics.poses import Pose, apart
from armui.protocol.codes import ArmStatusCode

if TYPE_CHECKING:
    from armui.arm.state import ArmState
    from armui.control.motion.motion_command import MotionCommand

_SHOWS_DEG: Final = 0.2
"""A joint that has turned by this much since sending is on its way."""
_SHOWS_MM: Final = 0.5
"""A flange sent to a pose that has come this far is, too: 1 mm hardly turns the joints."""
_AWAY_DEG: Final = 0.5
"""A nearer target may be where the arm stands already, sagging under its load."""
_WITHIN_S: Final = 1.0
"""Within this time even the slowest motion shows, at 1 % of 180°/s."""
_IN_TIME_S: Final = 0.5
"""The angles must have arrived without a gap for at least this last part of that time."""

_SINGLE: Final = frozenset({CommandKind.JOINTS, CommandKind.POSE, CommandKind.JOG})
"""The kinds that are watched; runs and replays notice by themselves an arm that is elsewhere."""


class AcknowledgementMonitor:
    """Follows each single motion of ours until the arm has taken it up, or has not."""

    def __init__(self) -> None:
        self._number = 0
        self._command: MotionCommand | None = None
        self._from_deg: tuple[float, ...] | None = None
        self._from_pose: tuple[float, ...] | None = None
        self._since_s = 0.0

    @property
    def waits(self) -> bool:
        """True if the arm has yet to show that it has taken a motion that leads it away."""
        return self._command is not None and self._leads_away(self._command)

    def observe(
        self, command: MotionCommand | None, ended: End | None, state: ArmState, now_s: float
    ) -> bool:
        """Return whether it has just turned out that the arm did not take up the last motion.

        Args:
            command: Our command, as long as a step may start from its target.
            ended: The cause that ended the last command.
            state: The arm as heard.
            now_s: Monotonic time.
        """
        angles_deg = state.angles_deg()
        if command is not None and command.number != self._number:
            single = command.kind in _SINGLE and angles_deg is not None
            self._number, self._command = command.number, command if single else None
            self._from_deg, self._since_s = angles_deg, now_s
            self._from_pose = state.end_pose()
        watched = self._command
        if watched is None:
            return False
        if self._shows(state, angles_deg) or self._shows_by_pose(state):
            self._command = None
            return False
        if command is None:
            self._command = None
            # That the arm did not take up the command's mode word is proof enough, whatever its
            # target was.
            return ended is End.OTHER_MODE or (
                ended is End.MOVED_AWAY and self._leads_away(watched)
            )
        self._command = command
        # a jog is a stream of setpoints: its first counts
        sent_s = self._since_s if command.kind is CommandKind.JOG else command.sent_s
        since_s = max(self._since_s, sent_s)
        early = now_s - since_s < _WITHIN_S or state.in_time_for_s(now_s, since_s) < _IN_TIME_S
        if early or not self._leads_away(command):
            return False
        self._command = None
        return True

    def reset(self) -> None:
        """Stop watching: another connection begins, or a motion is held back."""
        self._command = None

    def _shows(self, state: ArmState, angles_deg: tuple[float, ...] | None) -> bool:
        """Return whether the arm has begun to move, or has said why it does not."""
        status = state.status
        if status is not None and status.value.arm_status != ArmStatusCode.NORMAL:
            return True
        begin_deg = self._from_deg
        if angles_deg is None or begin_deg is None:
            return False
        return max(abs(a - b) for a, b in zip(angles_deg, begin_deg, strict=True)) > _SHOWS_DEG

    def _shows_by_pose(self, state: ArmState) -> bool:
        """Return whether an arm that was sent to a pose reports that its flange is on the way."""
        begin, pose, command = self._from_pose, state.end_pose(), self._command
        if command is None or command.kind is not CommandKind.POSE or not (begin and pose):
            return False
        off_mm, off_deg = apart(Pose(*begin), Pose(*pose))
        return off_mm > _SHOWS_MM or off_deg > _SHOWS_DEG

    def _leads_away(self, command: MotionCommand) -> bool:
        if command.kind is CommandKind.POSE or command.joints_deg is None:
            return command.leads_away
        begin_deg = self._from_deg or command.joints_deg
        away = max(abs(a - b) for a, b in zip(command.joints_deg, begin_deg, strict=True))
        return away > _AWAY_DEG
