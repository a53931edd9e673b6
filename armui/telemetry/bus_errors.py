"""The content of error frames from adapters that use Linux's format.

Source: Linux, ``linux/can/error.h``: classes in the identifier, more of the controller in byte 1.
"""

from __future__ import annotations

import enum
from typing import Final

LINUX_ERROR_FRAMES: Final = frozenset({"socketcan", "gs_usb", "candle"})
"""Back-ends of python-can whose error frames have this format."""

_CONTROLLER: Final = 0x004


class BusError(enum.StrEnum):
    """An error on the bus, or its end."""

    SEND_TIMEOUT = "send_timeout"
    ARBITRATION_LOST = "arbitration_lost"
    CONTROLLER = "controller"
    RECEIVE_OVERFLOW = "receive_overflow"
    SEND_OVERFLOW = "send_overflow"
    MANY_ERRORS = "many_errors"
    ERROR_PASSIVE = "error_passive"
    ERROR_ACTIVE = "error_active"
    PROTOCOL = "protocol"
    TRANSCEIVER = "transceiver"
    NO_ACKNOWLEDGE = "no_acknowledge"
    BUS_OFF = "bus_off"
    BUS_ERROR = "bus_error"
    RESTARTED = "restarted"


_CLASSES: Final = (
    (0x040, BusError.BUS_OFF),
    (0x020, BusError.NO_ACKNOWLEDGE),
    (0x010, BusError.TRANSCEIVER),
    (0x008, BusError.PROTOCOL),
    (0x080, BusError.BUS_ERROR),
    (0x001, BusError.SEND_TIMEOUT),
    (0x002, BusError.ARBITRATION_LOST),
    (0x100, BusError.RESTARTED),
)
_CONTROLLER_KINDS: Final = (
    (0x01, BusError.RECEIVE_OVERFLOW),
    (0x02, BusError.SEND_OVERFLOW),
    (0x30, BusError.ERROR_PASSIVE),
    (0x0C, BusError.MANY_ERRORS),
    (0x40, BusError.ERROR_ACTIVE),
)


def errors_of(arbitration_id: int, data: bytes, interface: str) -> tuple[BusError, ...]:
    """Return the errors in an error frame, the gravest first; none if the adapter gives no details.

    Args:
        arbitration_id: Its identifier.
        data: Its payload.
        interface: python-can's name of the back-end.
    """
    if interface not in LINUX_ERROR_FRAMES:
        return ()
    found = [error for bit, error in _CLASSES if arbitration_id & bit]
    if arbitration_id & _CONTROLLER:
        told = data[1] if len(data) > 1 else 0
        kinds = [error for bits, error in _CONTROLLER_KINDS if told & bits]
        found += kinds or [BusError.CONTROLLER]
    return tuple(found)
