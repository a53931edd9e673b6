"""Tells the arm how it is mounted, by 0x151 byte 5 (generation 2); it cannot be read back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from armui.arm.quirks import why_not_by_firmware
from armui.arm.refusal import Reason, Refusal
from armui.control.context import why_not_asked
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.control.parameters.arm_settings import SETTING_NOT_KEPT
from armui.control.safety.interlocks import CONTROL_OFFSET_UNKNOWN
from armui.protocol import commands
from armui.protocol.codes import Mounting
from armui.protocol.generation import Generation
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from collections.abc import Callable

    from armui.control.motion.motion_context import MotionContext
    from armui.control.operating_state import OperatingState

MODE_UNKNOWN = Reason(
    "mode_unknown",
    "The arm's control mode is not known, or another one has the command: it would be changed "
    "along with this. Bring the arm to standby or CAN control first.",
)
MOUNTING_SENT = Notice(
    "mounting_sent",
    "Mounting sent: {mounting}. The arm does not report it back.",
    Level.INFO,
    EventKind.COMMAND,
)


def why_not_mount(now: OperatingState) -> Refusal | None:
    """Return why the arm may not be told its mounting, apart from its firmware and motion."""
    if (refusal := why_not_asked(now)) is not None:
        return refusal
    if now.generation is Generation.ONE:
        return SETTING_NOT_KEPT(generation=1)
    if now.occupied is not None:
        return now.occupied
    if not now.control_certain:
        return CONTROL_OFFSET_UNKNOWN()
    return now.cannot_send_motion or now.held


class MountingControl:
    """Tells the arm how it is mounted, in the modes it is in.

    Args:
        context: The context that the controller's parts share.
        speed_percent: Returns the speed shown in the window; the mode word carries it.
    """

    def __init__(self, context: MotionContext, speed_percent: Callable[[], int]) -> None:
        self._context = context
        self._speed_percent = speed_percent

    @operation("mounting.tell", "Set the mounting", why_not_mount, moves=True)
    def tell(self, started: Started, mounting: Mounting) -> Refusal | None:
        """Send the mounting. The arm does not confirm it."""
        context = self._context
        refusal = self.why_not(mounting) or context.why_no_motion()
        mode = context.authority.mode_in_force()
        if refusal is not None or mode is None:
            return refusal or MODE_UNKNOWN()
        percent = self._speed_percent()
        frames = commands.set_mode(
            context.connection.codec,
            control_mode=mode[0],
            move_mode=mode[1],
            speed_percent=percent,
            mounting=mounting,
        )
        passed = context.gate().ask_no_way()
        if not context.connection.send([*context.cancel_frames(), *frames], passed=passed):
            return LINK_LOST()
        context.authority.told_percent(percent)
        started.close(Ending.SENT)
        context.emit_event(MOUNTING_SENT, started, mounting=int(mounting))
        context.refresh()
        return None

    def why_not(self, mounting: Mounting) -> Refusal | None:
        """Return the reason against telling it now, or ``None``."""
        context = self._context
        return (
            why_not_mount(context.operating_state())
            or self.why_not_by_firmware(mounting)
            or context.why_moving()
        )

    def why_not_by_firmware(self, mounting: Mounting) -> Refusal | None:
        """Return the reason that lies in the arm's firmware against a mounting, or ``None``."""
        if mounting is not Mounting.UPSIDE_DOWN:
            return None
        return why_not_by_firmware(self._context.state(), "has_upside_down")
