"""Decides when a lower speed or a pause is sent a second time, as a frame may be lost."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from armui.control.safety import interlocks

if TYPE_CHECKING:
    from armui.control.context import Context

_AFTER_S: Final = 0.1


class Retransmission:
    """Decides when a frame is due a second time: 0.1 s after the first, and only once.

    A part that uses one drops it in `halt` and `forget_arm`. While a stop or a switching of the
    motors is under way it is never due, even if nobody has dropped it.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._due_s: float | None = None

    def schedule(self) -> None:
        """Have the frame sent again in 0.1 s."""
        self._due_s = self._context.clock() + _AFTER_S

    def drop(self) -> None:
        """Do not have it sent again."""
        self._due_s = None

    def take_due(self) -> bool:
        """Return true if the frame is to be sent now; it is not due again afterwards."""
        if self._due_s is None or self._context.clock() < self._due_s:
            return False
        self._due_s = None
        now = self._context.operating_state()
        against = interlocks.why_no_command(now.unreachable, now.stop, now.busy)
        return against is None and not self._context.authority.failed
