"""The state of the connection to a device, apart from whether an arm answers on it: pure."""

from __future__ import annotations

import enum
from typing import Final, NamedTuple

from armui.arm.device import Device, has_wire
from armui.arm.refusal import Reason, Refusal
from armui.telemetry.bus_errors import LINUX_ERROR_FRAMES

BUS_OFF = Reason(
    "bus_off",
    "{device} is bus off: too many errors on the CAN bus, so its controller takes no part any "
    "more. Check CAN_H and CAN_L, both terminating resistors (120 Ω) and the bit rate, then "
    "disconnect and connect again; on socketcan run “sudo ip link set {channel} type can "
    "restart” before.",
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
BUS_DEAF = Reason(
    "bus_deaf",
    "{device} is deaf: it has sent {count} frames, heard none, and reports no error. Unplug the "
    "adapter and plug it in again. If that does not help, check CAN_H and CAN_L, the bit rate, the "
    "terminating resistors (120 Ω), a receive filter of the adapter, and the arm's power.",
)


HEARD_S: Final = 0.5
"""A frame received within this time shows that the receiving side works."""

_QUESTIONS: Final = 3
"""The frames that must have gone out into the silence, questions of ours included."""
_QUESTION_S: Final = 0.5
"""The interval of questions to a silent bus."""
_DEAF_S: Final = 2.0
"""After this silence an adapter that sends and reports no error counts as deaf."""

_BUS_OFF: Final = 0x040
_RESTARTED: Final = 0x100
"""The error classes «bus off» and «controller restarted» (linux/can/error.h)."""


class BusState(enum.Enum):
    """The state of the bus thread's device."""

    OPENING = enum.auto()
    OPEN = enum.auto()
    BLOCKED = enum.auto()
    """The device is open, but no frame can be sent; the thread goes on trying."""
    DEAF = enum.auto()
    """The device is open and sends, but nothing is heard, not even errors."""
    LOST = enum.auto()
    """The device was open and is gone; the thread keeps trying to open it again."""
    FAILED = enum.auto()
    """The device could not be opened; the thread has ended."""
    CLOSED = enum.auto()


class BusReport(NamedTuple):
    """A report of the bus thread on its device.

    Attributes:
        state: The state of the device.
        device: The device.
        problem: Why it is ``BLOCKED``, ``DEAF``, ``LOST`` or ``FAILED``.
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
        self._has_wire = device.simulated or has_wire(device.interface, device.channel)
        self._bus_off = self._erred = False
        self._heard_s: float | None = None
        self._silent = False
        self._quiet_s = self._asked_s = 0.0
        self._asked = self._sent_before = 0
        self._deaf: Refusal | None = None

    def on_frame(self, now_s: float) -> None:
        """Note that a data frame was received, so the controller is not bus-off."""
        self._bus_off = False
        self._heard_s = now_s
        self._silent = False

    def on_error_frame(self, arbitration_id: int) -> None:
        """Note an error frame from the adapter."""
        self._erred = True
        if self._device.interface not in LINUX_ERROR_FRAMES:
            return
        if arbitration_id & _BUS_OFF:
            self._bus_off = True
        elif arbitration_id & _RESTARTED:
            self._bus_off = False

    def follow_silence(self, now_s: float, sent: int) -> bool:
        """Return whether a question is to be sent, for an adapter's deafness shows only by sending.

        A silent arm answers it, without one that acknowledges it the adapter reports an error. An
        arm that was heard is not asked: its answers would look as if its silence had ended.

        Args:
            now_s: Monotonic time.
            sent: The number of frames that the device has taken so far.
        """
        if not self._silent:
            self._silent, self._quiet_s, self._asked_s = True, now_s, now_s
            self._asked, self._sent_before = 0, sent
            self._erred, self._deaf = False, None
        if not self._has_wire or self._erred or self._deaf is not None:
            return False
        count = sent - self._sent_before
        if count >= _QUESTIONS and now_s - self._quiet_s >= _DEAF_S:
            self._deaf = BUS_DEAF(device=self._device.name, count=str(count))
        heard = self._heard_s is not None
        if heard or self._asked == _QUESTIONS or now_s - self._asked_s < _QUESTION_S:
            return False
        self._asked, self._asked_s = self._asked + 1, now_s
        return True

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
            return None if self._erred else self._deaf
        heard = self._heard_s is not None and now_s - self._heard_s < HEARD_S
        return Refusal(BUS_SEND_BLOCKED if heard else BUS_UNACKNOWLEDGED, params)
