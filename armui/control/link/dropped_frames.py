"""Tells the operator that frames were lost before the program could read them."""

from __future__ import annotations

from typing import Final

from armui.control.context import Context, ControllerPart
from armui.control.events import EventCode

_EVERY_S: Final = 10.0


class DroppedFrames(ControllerPart):
    """Tells the first loss at once, and of those that follow no more often than every 10 s.

    Args:
        context: What the parts of the controller share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._told = 0
        self._told_s: float | None = None

    def follow_arm(self) -> None:
        """Look at the count; called regularly while a device is open."""
        dropped = self._context.connection.frames_dropped
        if dropped <= self._told:
            return
        now_s = self._context.clock()
        if self._told_s is None or now_s - self._told_s >= _EVERY_S:
            self._context.tell(EventCode.FRAMES_DROPPED, count=dropped - self._told, total=dropped)
            self._told, self._told_s = dropped, now_s

    def forget_arm(self) -> None:
        """The next device counts anew."""
        self._told, self._told_s = 0, None
