"""A connection to an arm as the operator chooses it; nothing here touches a bus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

from armui.protocol.generation import PiperModel

DEFAULT_BITRATE: Final = 1_000_000
"""The bit rate of the maker's present hardware; generation 1's text says 500 kbit/s."""

_WITHOUT_WIRE: Final = frozenset({"virtual", "udp_multicast"})
_BITRATE_SET_BY_SYSTEM: Final = _WITHOUT_WIRE | {"socketcan"}


def has_wire(interface: str, channel: int | str) -> bool:
    """Return whether an adapter and a cable are behind a device, by python-can's names for it."""
    return interface not in _WITHOUT_WIRE and not str(channel).startswith("vcan")


@dataclass(frozen=True, slots=True)
class RecordedArm:
    """The facts a log holds about the arm in it.

    Attributes:
        generation: The protocol it speaks.
        feedback_offset: Added to the identifiers of its feedback (0x470).
        firmware: The version it names, as ``S-V1.8-5``; "" if it names none.
        model: The model it was connected as; ``None`` if the log does not say.
        older_zeros: True if its poses show that joints 2 and 3 count from the zeros before
            S-V1.6-3; ``None`` if they do not show it either way.
        tool: The tool centre point that held while it was recorded, six figures; empty if the log
            does not say.
    """

    generation: int
    feedback_offset: int = 0
    firmware: str = ""
    model: PiperModel | None = None
    older_zeros: bool | None = None
    tool: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Device:
    """One connection to an arm.

    Attributes:
        interface: python-can's name of the back-end.
        channel: The back-end's name of the channel.
        bitrate: In bit/s; ``None`` if the operating system sets it.
        label: The name shown to the operator.
        serial: The adapter's serial number, if it reports one.
        simulated: True for a simulated arm of this program.
        generation: The protocol of the simulated arm.
        model: The model the operator has chosen; that of the simulated arm.
        model_assumed: True if the model was only offered, and the operator has not chosen it this
            time.
        listen_only: True if only the operator's stop may be sent.
        recorded: True for a log that is replayed: nothing at all can be sent.
        options: Further arguments of python-can's constructor.
    """

    interface: str
    channel: str | int
    bitrate: int | None = DEFAULT_BITRATE
    label: str = ""
    serial: str | None = None
    simulated: bool = False
    generation: int | None = None
    model: PiperModel = PiperModel.PIPER
    model_assumed: bool = False
    listen_only: bool = False
    recorded: RecordedArm | None = None
    options: tuple[tuple[str, Any], ...] = ()

    @property
    def name(self) -> str:
        """A short name for the top bar and messages."""
        return self.label or f"{self.interface} {self.channel}"

    def arm_key(self, node: str = "") -> str:
        """Return the key that stands for the arm: the adapter's serial number, or its channel.

        Args:
            node: The arm's node number, if known: one adapter may serve two arms in turn.
        """
        name = self.serial or f"{self.interface} {self.channel}"
        return f"{name} / {node}" if node else name

    def same(self, other: Device) -> bool:
        """Return whether both are one device, whatever their bit rates and options."""
        return (self.interface, str(self.channel), self.serial or other.serial) == (
            other.interface,
            str(other.channel),
            other.serial or self.serial,
        ) and (self.simulated, self.generation) == (other.simulated, other.generation)


def bitrate_is_ours(interface: str) -> bool:
    """Return whether the program sets the bit rate of this back-end, not the operating system."""
    return interface not in _BITRATE_SET_BY_SYSTEM
