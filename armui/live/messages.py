"""The messages between the program and the process that serves the live stream: data."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from armui.arm.refusal import Reason, Refusal
from armui.control.events import Notice
from armui.telemetry.events import EventKind, Level

if TYPE_CHECKING:
    from armui.kinematics.geometry import Geometry
    from armui.protocol.addressing import Addressing
    from armui.protocol.firmware_version import FirmwareVersion
    from armui.protocol.generation import Generation

LIVE_NOT_INSTALLED = Reason(
    "live_not_installed",
    "The live stream needs the package foxglove-sdk ({text}): pip install 'armui[foxglove]', then "
    "switch it off and on. A program that was not installed by pip cannot have it.",
)
LIVE_PORT_TAKEN = Reason(
    "live_port_taken",
    "Another program has port {port}: the live stream is not served. Choose another port in the "
    "settings, or end that program and switch the stream off and on.",
)
LIVE_NOT_OPENED = Reason(
    "live_not_opened",
    "The live stream cannot be served at port {port} ({text}). Choose another port in the "
    "settings.",
)
LIVE_ENDED = Reason(
    "live_ended", "The process of the live stream has ended by itself. Switch it off and on."
)
LIVE_NOT_SERVED = Notice(
    "live_not_served", "No live stream: {reason}", Level.WARNING, EventKind.PROGRAM
)


@dataclass(frozen=True, slots=True)
class LiveArm:
    """The arm that the frames to come are from.

    Attributes:
        name: Its name in the diagnostics.
        geometry: With the zeros of its firmware.
        gripper_turned_deg: The gripper's turn about the flange's Z axis.
        codec: The parts of the codec that decodes them; ``None`` until it is known.
    """

    name: str
    geometry: Geometry
    gripper_turned_deg: float
    codec: tuple[Generation, Addressing, FirmwareVersion | None] | None = None


@dataclass(frozen=True, slots=True)
class LiveState:
    """The state of the process.

    Attributes:
        on: True while it serves.
        problem: Why it does not.
        watched: True if a viewer has subscribed to a topic.
        behind: How often it was seen that a viewer does not keep up: for that one the oldest
            messages are dropped.
    """

    on: bool = False
    problem: Refusal | None = None
    watched: bool = False
    behind: int = 0


@dataclass(frozen=True, slots=True)
class LiveView:
    """What the window shows of the live stream.

    Attributes:
        state: The state of its process.
        address: The address of the server: host and port.
        for_others: True if other computers can watch.
        lost: The number of frames dropped because its process did not take them.
    """

    state: LiveState = LiveState()
    address: str = ""
    for_others: bool = False
    lost: int = 0
