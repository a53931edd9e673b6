"""灯光控制: the lamps on the boards of the joints (manual section 1.0.7.2, 0x121)."""

from __future__ import annotations

from typing import Annotated, Final

from armui.arm.figures import Also, JointNumber, Range
from armui.arm.refusal import Reason, Refusal
from armui.control.context import Context
from armui.control.events import Notice
from armui.control.link.link_state import LINK_LOST
from armui.control.operating_state import OperatingState
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.protocol import commands
from armui.protocol.codes import ALL_LAMPS
from armui.telemetry.events import EventKind, Level

RUN_SETS_LAMPS = Reason(
    "run_sets_lamps",
    "The run under way sets the lamps itself. Wait until it is done, or end the run first.",
)
SENT_LAMP = Notice(
    "sent_lamp",
    "Sent to lamp {lamp} of joint {joint}: {color}",
    Level.INFO,
    EventKind.COMMAND,
    streams=True,
)
SENT_LAMPS = Notice(
    "sent_lamps",
    "Sent to all lamps of joint {joint}: {color}",
    Level.INFO,
    EventKind.COMMAND,
    streams=True,
)


Lamp = Annotated[int, Range(0, ALL_LAMPS - 1), Also(ALL_LAMPS)]
"""One lamp of a joint, or :data:`ALL_LAMPS`."""
Grey = Annotated[int, Range(0, 255)]
"""The value of a colour channel."""

_COUNTS: Final = 256


def why_no_lamps(now: OperatingState) -> Refusal | None:
    """Return why no lamp may be set: lamps move nothing, but a run may signal by them."""
    if now.unreachable is None and now.run_sets_lamps:
        return RUN_SETS_LAMPS()
    return now.unreachable


class Lights:
    """Sends colours to the lamps and counts the frames.

    The arm neither answers nor reports its lamps: only what was sent is known. A lamp moves
    nothing, so it may be set whenever the arm is online, enabled or not, stopped or not; but while
    a run sets lamps itself, as signals, nobody else may set them.

    Args:
        context: The context that the controller's parts share.
    """

    def __init__(self, context: Context) -> None:
        self._context = context
        self._counter = 0

    @operation("lamps.set", "Set the lamps of a joint", why_no_lamps)
    def set_light(  # noqa: PLR0917 - a lamp and its colour as red, green, blue
        self, started: Started, joint: JointNumber, lamp: Lamp, red: Grey, green: Grey, blue: Grey
    ) -> Refusal | None:
        """Set the colour of a lamp of a joint.

        Args:
            started: The record of the command.
            joint: The joint.
            lamp: The lamp on its board.
            red: The red channel.
            green: The green channel.
            blue: The blue channel.

        Returns:
            Why nothing was sent, or ``None``.
        """
        connection, color = self._context.connection, (red, green, blue)
        frames = commands.set_light(
            connection.codec, joint, color, lamp=lamp, counter=self._counter
        )
        if not connection.send(frames):
            return LINK_LOST()
        self._counter = (self._counter + 1) % _COUNTS
        notice = SENT_LAMPS if lamp == ALL_LAMPS else SENT_LAMP
        started.close(Ending.SENT)
        told = f"#{red:02X}{green:02X}{blue:02X}"
        self._context.emit_event(notice, started, joint=joint, lamp=lamp, color=told)
        return None
