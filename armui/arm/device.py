"""A way to an arm, as the operator chooses it; nothing here touches a bus."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

from armui.protocol.generation import PiperModel

DEFAULT_BITRATE: Final = 1_000_000
"""What the maker's hardware runs at today; generation 1's text says 500 kbit/s."""

_BITRATE_SET_BY_SYSTEM: Final = frozenset({"socketcan", "virtual", "udp_multicast"})


@dataclass(frozen=True, slots=True)
class RecordedArm:
    """What a log tells of the arm in it.

    Attributes:
        generation: Which protocol it speaks.
        feedback_offset: Added to the identifiers of its feedback (0x470).
        firmware: The version it names, as ``S-V1.8-5``; "" where it names none.
        model: Which arm of the family it was connected as; ``None``: it does not tell.
        older_zeros: Its poses say that joints 2 and 3 count from the zeros before S-V1.6-3;
            ``None``: they say nothing.
    """

    generation: int
    feedback_offset: int = 0
    firmware: str = ""
    model: PiperModel | None = None
    older_zeros: bool | None = None


@dataclass(frozen=True, slots=True)
class Device:
    """One way to an arm.

    Attributes:
        interface: python-can's name of the back-end.
        channel: The back-end's name of the channel.
        bitrate: Bits per second; ``None`` where the operating system sets it.
        label: What the operator knows it by.
        serial: The adapter's serial number, where it tells one.
        simulated: An arm made of software inside this program.
        generation: Which protocol the simulated arm speaks.
        model: Which arm of the family the operator says it is; the simulated arm is that.
        model_assumed: The model is what was offered; the operator has not chosen it this time.
        listen_only: Nothing is sent on it but an operator's stop.
        recorded: It is a log that is replayed: nothing whatever can be sent.
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
    def kind(self) -> str:
        """The back-end's name, or ``simulated``."""
        return "simulated" if self.simulated else self.interface

    @property
    def name(self) -> str:
        """A short name for the top bar and messages."""
        return self.label or f"{self.interface} {self.channel}"

    def arm_key(self, node: str = "") -> str:
        """Return what the arm is remembered by: the adapter's serial number, or its place.

        Args:
            node: The arm's node number, where it is known: one adapter serves two arms in turn.
        """
        name = self.serial or f"{self.interface} {self.channel}"
        return f"{name} / {node}" if node else name

    def same(self, other: Device) -> bool:
        """Tell whether both are one device, whatever bit rate and options were chosen."""
        return (self.interface, str(self.channel), self.serial or other.serial) == (
            other.interface,
            str(other.channel),
            other.serial or self.serial,
        ) and (self.simulated, self.generation) == (other.simulated, other.generation)


def bitrate_is_ours(interface: str) -> bool:
    """Tell whether the program sets the bit rate of this back-end, or the operating system does."""
    return interface not in _BITRATE_SET_BY_SYSTEM
