"""灯光控制: the lamps on the boards of the joints (manual section 1.0.7.2, 0x121)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from armui.arm.limits import JOINTS
from armui.arm.refusal import Reason, Refusal
from armui.control.context import Context
from armui.control.events import Notice
from armui.control.operating_state import LINK_LOST, OperatingState
from armui.control.operations.operation import operation
from armui.control.operations.started import Ending, Started
from armui.protocol import commands
from armui.protocol.codes import ALL_LAMPS
from armui.telemetry.events import EventKind, Level

RUN_SETS_LAMPS = Reason(
    "run_sets_lamps",
    "The run under way sets the lamps itself. Wait until it is done, or end the run first.",
)
LIGHT_OUT_OF_RANGE = Reason(
    "light_out_of_range",
    "{light}: {value} is out of range. Enter a whole number from {minimum} to {maximum}.",
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


RANGES: Final[Mapping[str, range]] = {
    "joint": JOINTS,
    "lamp": range(ALL_LAMPS),
    "red": range(256),
    "green": range(256),
    "blue": range(256),
}
"""The range of each figure of the command; a lamp may be :data:`ALL_LAMPS` as well."""

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
    def set_light(  # noqa: PLR0917 - a lamp, and its colour as everybody writes one
        self, started: Started, joint: int, lamp: int, red: int, green: int, blue: int
    ) -> Refusal | None:
        """Set the colour of a lamp of a joint.

        Args:
            started: The record of the command.
            joint: 1–6.
            lamp: 0–254, or :data:`ALL_LAMPS`.
            red: Grey value of the red channel, 0–255.
            green: Grey value of the green channel, 0–255.
            blue: Grey value of the blue channel, 0–255.

        Returns:
            Why nothing was sent, or ``None``.
        """
        refusal = check_light(joint=joint, lamp=lamp, red=red, green=green, blue=blue)
        if refusal is not None:
            return refusal
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
        self._context.tell(notice, started, joint=joint, lamp=lamp, color=told)
        return None


def check_light(**figures: int) -> Refusal | None:
    """Return why figures may not be sent to a lamp; ``None``: they may.

    Args:
        **figures: Values by their names in :data:`RANGES`.
    """
    for name, value in figures.items():
        allowed = RANGES[name]
        if value in allowed or (name == "lamp" and value == ALL_LAMPS):
            continue
        return LIGHT_OUT_OF_RANGE(light=name, value=value, minimum=allowed[0], maximum=allowed[-1])
    return None
