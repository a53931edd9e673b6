"""The state of the connection to a device, apart from whether an arm answers on it: pure."""

from __future__ import annotations

import enum
from typing import Final, NamedTuple

from armui.arm.device import Device
from armui.arm.refusal import Reason, Refusal
from armui.telemetry.bus_errors import LINUX_ERROR_FRAMES

BUS_OFF = Reason(
    "bus_off",
    "{device} is bus off: too many errors on the CAN bus, so its controller takes no part any "
    "more. Check CAN_H and CAN_L, both terminating resistors (120 Ω) and the bit rate, then "
    "disconnect and connect again; on socketcan run «sudo ip link set {channel} type can "
    "restart» before.",
)
BUS_SEND_BLOCKED = Reason(
    "bus_send_blocked",
    "For half a second {device} has taken no frame to send, though frames are heard. "
    "Unplug the adapter and plug it in again; if that does not help, check its driver.",
)
BUS_UNACKNOWLEDGED = Reason(
    "bus_unacknowledged",
    "For half a second {device} could send nothing, because nobody on the bus acknowledges. "
    "Check the arm's power, the CAN cable, the terminating resistors and the bit rate "
    "(1 Mbit/s).",
)


HEARD_S: Final = 0.5
"""A frame received within this time shows that the receiving side works."""

_BUS_OFF: Final = 0x040
_RESTARTED: Final = 0x100
"""The error classes «bus off» and «controller restarted» (linux/can/error.h)."""


class BusState(enum.Enum):
    """The state of the bus thread's device."""

    OPENING = enum.auto()
    OPEN = enum.auto()
    BLOCKED = enum.auto()
    """The device is open, but no frame can be sent; the thread goes on trying."""
    LOST = enum.auto()
    """The device was open and is gone; the thread keeps trying to open it again."""
    FAILED = enum.auto()
    """The device could not be opened; the thread has ended."""
    CLOSED = enum.auto()


class BusReport(NamedTuple):
    """A report of the bus thread on its device.

    Attributes:
        state: What it is doing.
        device: The device.
        problem: Why it is ``BLOCKED``, ``LOST`` or ``FAILED``.
        worker: The number of the thread that says so.
    """

    state: BusState
    device: Device
    problem: Refusal | None = None
    worker: int = 0


class BusHealth:
    """Judges from error frames and the outbox whether frames get through on an open bus.

    Args:
        device: The device of this bus.
    """

    def __init__(self, device: Device) -> None:
        self._device = device
        self._bus_off = False
        self._heard_s: float | None = None

    def on_frame(self, now_s: float) -> None:
        """Note that a data frame was received, so the controller is not bus-off."""
        self._bus_off = False
        self._heard_s = now_s

    def on_error_frame(self, arbitration_id: int) -> None:
        """Note an error frame from the adapter."""
        if self._device.interface not in LINUX_ERROR_FRAMES:
            return
        if arbitration_id & _BUS_OFF:
            self._bus_off = True
        elif arbitration_id & _RESTARTED:
            self._bus_off = False

    def problem(self, now_s: float, *, blocked: bool) -> Refusal | None:
        """Return what is wrong with the bus, or ``None`` if nothing is known to be wrong.

        Args:
            now_s: Monotonic time.
            blocked: Nothing has gone out for half a second, though something should have.
        """
        device = self._device
        params = {
            "device": device.name,
            "interface": device.interface,
            "channel": str(device.channel),
        }
        if self._bus_off:
            return BUS_OFF(**params)
        if not blocked:
            return None
        heard = self._heard_s is not None and now_s - self._heard_s < HEARD_S
        return Refusal(BUS_SEND_BLOCKED if heard else BUS_UNACKNOWLEDGED, params)
