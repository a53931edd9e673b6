"""A gamepad made by the Linux kernel (uinput): it comes the way a real one does."""

from __future__ import annotations

import os
import struct
import sys
from pathlib import Path
from typing import Self

from tests.posix import of_system

_UINPUT = Path("/dev/uinput")
_SET_EVENTS, _SET_KEYS, _SET_AXES = 0x40045564, 0x40045565, 0x40045567
_CREATE, _DESTROY = 0x5501, 0x5502
_SYN, _KEY, _ABS = 0, 1, 3
_LEFT_X, _LEFT_SHOULDER = 0, 0x136
_AXES = (0, 1, 2, 3, 4, 5, 16, 17)
_KEYS = (0x130, 0x131, 0x133, 0x134, 0x136, 0x137, 0x13A, 0x13B, 0x13C, 0x13D, 0x13E)
_XBOX = (3, 0x045E, 0x028E, 0x0114)
"""Bus, vendor, product and version of a wired Xbox 360 gamepad, which SDL knows."""
_PLACES = 64


def why_no_uinput() -> str:
    """Why this computer cannot make one; empty: it can."""
    system: str = sys.platform
    if system != "linux":
        return "uinput is Linux's"
    if not _UINPUT.exists():
        return "there is no /dev/uinput"
    if not os.access(_UINPUT, os.W_OK):
        return "/dev/uinput may not be written"
    return "" if Path("/dev/input").exists() else "there is no /dev/input"


class UinputPad:
    """Exists inside its ``with``."""

    def __enter__(self) -> Self:
        import fcntl  # noqa: PLC0415 - there is none on Windows

        ioctl = of_system("ioctl", fcntl)

        self._file = os.open(_UINPUT, os.O_WRONLY | of_system("O_NONBLOCK"))
        for kind in (_KEY, _ABS):
            ioctl(self._file, _SET_EVENTS, kind)
        for key in _KEYS:
            ioctl(self._file, _SET_KEYS, key)
        for axis in _AXES:
            ioctl(self._file, _SET_AXES, axis)
        most, least = [0] * _PLACES, [0] * _PLACES
        for axis in _AXES:
            stick = axis in {0, 1, 3, 4}
            most[axis] = 32767 if stick else 255 if axis in {2, 5} else 1
            least[axis] = -32768 if stick else 0 if axis in {2, 5} else -1
        flat = [0] * (2 * _PLACES)
        head = struct.pack("80s4HI", b"Microsoft X-Box 360 pad", *_XBOX, 0)
        os.write(self._file, head + struct.pack(f"{4 * _PLACES}i", *most, *least, *flat))
        ioctl(self._file, _CREATE)
        return self

    def __exit__(self, *_error: object) -> None:
        import fcntl  # noqa: PLC0415 - there is none on Windows

        ioctl = of_system("ioctl", fcntl)

        ioctl(self._file, _DESTROY)
        os.close(self._file)

    def push_left(self, value: int) -> None:
        """Push the left stick sideways."""
        self._tell(_ABS, _LEFT_X, value)

    def press_left_shoulder(self) -> None:
        """Press the button, and keep it down."""
        self._tell(_KEY, _LEFT_SHOULDER, 1)

    def _tell(self, kind: int, code: int, value: int) -> None:
        for each in ((kind, code, value), (_SYN, 0, 0)):
            os.write(self._file, struct.pack("llHHi", 0, 0, *each))
