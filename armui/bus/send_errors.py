"""Recognises the errors of python-can's back-ends: a full transmit queue, a lost device."""

from __future__ import annotations

import contextlib
import errno
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final

import can

if TYPE_CHECKING:
    from collections.abc import Mapping

_FULL_ERRNOS: Final = frozenset(
    {
        errno.EAGAIN,  # socketcan, the socket's buffer
        errno.ENOBUFS,  # socketcan, the interface's queue: nobody acknowledges
        errno.ETIMEDOUT,  # libusb 1.0: the adapter did not take the frame in time
    }
)
"""Error numbers of the operating system that mean a full queue."""

_USB_TIMEOUT: Final = "USBTimeoutError"
"""The name of pyusb's timeout, whatever number it bears; pyusb itself need not be installed."""

_FULL_CODES: Final[Mapping[str, frozenset[int]]] = {
    "can.interfaces.kvaser": frozenset({-13, -7}),  # canERR_TXBUFOFL, canERR_TIMEOUT
    "can.interfaces.vector": frozenset({11}),  # XL_ERR_QUEUE_IS_FULL
    "can.interfaces.systec": frozenset({0x0B}),  # ERR_DLL_TXFULL
}
"""Error codes of the makers' libraries, by the module of the exception that carries them."""

_FULL_WORDS: Final = (
    "transmit buffer full",  # socketcan after its time-out, without a number
    "transmit buffer in can controller is full",  # PCAN
    "transmit queue is full",  # PCAN
    "xmtfull",
    "could not send message to one or more recipients",  # virtual: a queue with a bound
    "timed out",
    "timeout",
)

_BUS_OFF_WORDS: Final = ("bus-off", "bus off", "busoff", "'heavy'")
"""Words that mean too many bus errors: the adapter itself is still there."""

_PROMPT_SENDERS: Final = frozenset(
    {
        "can.interfaces.socketcan.socketcan",
        "can.interfaces.virtual",
        "armui.bus.line_bus",
        "armui.bus.multicast",
    }
)
"""Back-ends whose ``send`` waits by ``select`` or not at all, as python-can's sources show. The
others wait inside a library for a time of its own (gs_usb 1 s, serial ports without a limit).
"""


def obeys_its_timeout(bus: can.BusABC) -> bool:
    """Return whether ``send`` of this bus returns within its timeout."""
    return getattr(bus.send, "__module__", None) in _PROMPT_SENDERS


def queue_is_full(error: BaseException) -> bool:
    """Return whether a frame could not be sent just now although the device is there."""
    chain = list(causes(error))
    if any(_names_a_full_queue(cause) for cause in chain):
        return True
    if any(_number(cause) is not None for cause in chain):
        return False
    text = str(error).lower()
    return any(words in text for words in (*_FULL_WORDS, *_BUS_OFF_WORDS))


def flush_transmit_queue(bus: can.BusABC) -> None:
    """Empty the driver's transmit queue if the back-end can: its frames would be sent late."""
    with contextlib.suppress(Exception):
        bus.flush_tx_buffer()


def _names_a_full_queue(error: BaseException) -> bool:
    if (
        isinstance(error, can.CanTimeoutError | TimeoutError)
        or type(error).__name__ == _USB_TIMEOUT
    ):
        return True
    module = type(error).__module__
    for backend, codes in _FULL_CODES.items():
        if module.startswith(backend):
            return getattr(error, "error_code", None) in codes
    return _number(error) in _FULL_ERRNOS


def _number(error: BaseException) -> int | None:
    for name in ("errno", "error_code"):
        number = getattr(error, name, None)
        if isinstance(number, int):
            return number
    return None


def causes(error: BaseException) -> Iterator[BaseException]:
    """Yield an error, its cause, that one's cause, and so on."""
    cause: BaseException | None = error
    while cause is not None:
        yield cause
        cause = cause.__cause__ or cause.__context__
