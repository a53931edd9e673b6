"""The way back from MIT, CPV or high-follow without a reset, where the firmware has one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.quirks import exits_by_mode_word
from armui.arm.refusal import Refusal
from armui.arm.refusal_codes import RefusalCode
from armui.control.events import EventCode
from armui.control.motion.motion_command import CommandKind
from armui.protocol import commands
from armui.protocol.codes import ControlMode, MoveMode

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.control.context import Context


class ModeExitCommand:
    """Takes the arm out of another host's mode: a mode word, and targets where it stands.

    The word voids what the joints were told, so the targets follow it at once: until they have
    arrived the joints may give way.

    Args:
        context: What the parts of the controller share.
        speed_percent: What the window shows; the mode word carries it.
    """

    def __init__(self, context: Context, speed_percent: Callable[[], int]) -> None:
        self._context = context
        self._speed_percent = speed_percent

    def send(self) -> Refusal | None:
        """Do it now: ``None``, or why nothing was sent."""
        context = self._context
        context.refresh()
        refusal = self.why_not()
        angles_deg = context.authority.measured_deg()
        if refusal is None and angles_deg is None:
            refusal = Refusal(RefusalCode.JOINTS_UNKNOWN)
        if refusal is not None or angles_deg is None:
            return context.refuse(refusal or Refusal(RefusalCode.JOINTS_UNKNOWN))
        percent, codec = self._speed_percent(), context.connection.codec
        frames = commands.set_mode(
            codec,
            control_mode=ControlMode.CAN_CONTROL,
            move_mode=MoveMode.MOVE_J,
            speed_percent=percent,
        )
        context.authority.other.leave_mode(context.clock())
        sent = context.send_motion(
            CommandKind.JOINTS,
            [*frames, *commands.joint_target(codec, angles_deg)],
            move_mode=MoveMode.MOVE_J,
            speed_percent=percent,
            joints_deg=angles_deg,
        )
        if isinstance(sent, Refusal):
            return context.refuse(sent)
        context.tell(EventCode.MODE_LEFT)
        return None

    def why_not(self) -> Refusal | None:
        """The reason against it now, or ``None``; against a stream only the stop wins."""
        authority = self._context.authority
        if (silent := authority.why_silent()) is not None:
            return silent
        other = authority.other
        if other.commands and not other.may_be_taken_over:
            return Refusal(RefusalCode.OTHER_HOST_STREAMS, {"frames": other.frames})
        if not exits_by_mode_word(self._context.state()):
            return other.why_not()
        if not self._context.operating_state().control_certain:
            return Refusal(RefusalCode.CONTROL_OFFSET_UNKNOWN)
        return Refusal(RefusalCode.SPEED_ZERO) if self._speed_percent() <= 0 else None
