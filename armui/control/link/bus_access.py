"""The bus access of the bus monitor: listeners, lost frames, and frames sent by hand."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.arm.refusal import Reason, Refusal
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST, LISTEN_ONLY, NOT_CONNECTED, LinkState
from armui.control.operating_state import BUSY, StopState
from armui.control.safety.hand_frame import (
    MOVING,
    NEVER_REFUSED,
    FrameEffect,
    effect_of,
    sets_mode,
    why_never,
)
from armui.control.safety.interlocks import STOP_REQUESTED, STOPPED
from armui.control.safety.other_command import OTHER_HOST, OTHER_MODE
from armui.protocol.addressing import OFFSETS
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.control.motion.motion_context import MotionContext
    from armui.protocol.frame import Frame
    from armui.telemetry.listener import Listener

FRAME_NOT_HELD = Reason(
    "frame_not_held", "This frame acts on the arm: hold the button for a second to send it."
)
FRAME_SENT_BY_HAND = Notice(
    "frame_sent_by_hand",
    "Sent by hand: {frame}. It counts as another program's command.",
    Level.WARNING,
    EventKind.COMMAND,
)


_KEEP_S: Final = 0.2
"""A frame that could not be sent within this time is dropped: its reason may be over."""
_PAUSE_S: Final = 2.0
"""Another host is not interfered with until this long after its last motion frame."""


class BusAccess:
    """Gives the bus monitor access to the connection.

    A frame sent by hand counts as another host's, not as a command of this program: it ends
    whatever was under way here, and no motion of ours follows before the arm rests.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: MotionContext) -> None:
        self._context = context

    @property
    def frames_dropped(self) -> int:
        """The number of frames lost by the system or the adapter before they could be read."""
        return self._context.connection.frames_dropped

    def add_listener(self, listener: Listener) -> None:
        """Add a listener that gets every frame."""
        self._context.connection.add_listener(listener)

    def remove_listener(self, listener: Listener) -> None:
        """Remove a listener; frames on their way may still reach it."""
        self._context.connection.remove_listener(listener)

    def why_not_send(self, frame: Frame | None = None) -> Refusal | None:
        """Return the reason against sending a frame by hand now, or ``None``.

        Args:
            frame: The frame; ``None`` for any at all.
        """
        link = self._context.connection.link
        device = self._context.connection.device
        if device is None or link in {LinkState.NO_DEVICE, LinkState.OPENING}:
            return NOT_CONNECTED()
        if device.listen_only:
            return LISTEN_ONLY()
        if link is LinkState.LOST:
            return LINK_LOST()
        operating_state = self._context.operating_state()
        if operating_state.stop is StopState.REQUESTED:
            return STOP_REQUESTED()
        return None if frame is None else why_never(frame) or self._why_not_now(frame)

    def send(self, frame: Frame, *, held: bool) -> Refusal | None:
        """Send a frame by hand, in its turn; return ``None``, or why it was not sent.

        Args:
            frame: The frame.
            held: True if the operator has held the button for it; all but harmless frames need
                that.
        """
        context, connection = self._context, self._context.connection
        context.refresh()
        refusal = self.why_not_send(frame)
        if refusal is None and effect_of(frame) is not FrameEffect.HARMLESS and not held:
            refusal = FRAME_NOT_HELD()
        if refusal is not None:
            return context.refuse(refusal)
        connection.note_by_hand(frame)
        # our own motion ends before the frame leaves, and what waits of it is dropped
        context.observe()
        passed = context.gate().ask_held() if held else None
        if not connection.send([frame], _KEEP_S, passed=passed):
            return context.refuse(LINK_LOST())
        context.emit_event(FRAME_SENT_BY_HAND, frame=str(frame))
        context.refresh()
        return None

    def _why_not_now(self, frame: Frame) -> Refusal | None:
        effect = effect_of(frame)
        if effect is FrameEffect.HARMLESS or effect in NEVER_REFUSED:
            return None
        context = self._context
        operating_state = context.operating_state()
        refusal = operating_state.unreachable
        if refusal is None and operating_state.busy is not None:
            refusal = BUSY(what=operating_state.busy.value)
        if refusal is not None:
            return refusal
        if effect not in MOVING:
            return operating_state.occupied
        if operating_state.stop is not StopState.RUNNING:
            return STOPPED()
        return context.authority.why_silent() or self._why_others(frame)

    def _why_others(self, frame: Frame) -> Refusal | None:
        """Return why not to send by hand while another host moves the arm or set its mode."""
        connection = self._context.connection
        mode = self._context.authority.other.mode
        if mode is not None and sets_mode(frame):
            return OTHER_MODE(other_mode=mode.value)
        offsets = connection.offsets
        concerned = (offsets.addressing.control_offset,) if offsets.certain else OFFSETS
        since_s = self._context.clock() - _PAUSE_S
        others = [
            each for each in connection.heard_traffic.motion(concerned) if each.last_s > since_s
        ]
        if not others:
            return None
        names = ", ".join(f"0x{each.arbitration_id:03X}" for each in others)
        return OTHER_HOST(frames=names)
