"""Keeps the system from coarsening this program's timers while a device is open.

Windows 11 coarsens the timers of a covered window to 15.6 ms, macOS (App Nap) further the longer
the window is hidden; this would affect the bus. Without a device the program saves power like any
other.

Source: SetProcessInformation, PROCESS_POWER_THROTTLING_STATE; NSProcessInfo, NSActivityOptions.
"""

from __future__ import annotations

import ctypes
import logging
import sys
from collections.abc import Callable
from typing import Any, Final

_LOG: Final = logging.getLogger(__name__)

_POWER_THROTTLING: Final = 4
"""The value ProcessPowerThrottling of PROCESS_INFORMATION_CLASS."""
_EXECUTION_SPEED: Final = 0x1
_IGNORE_TIMER_RESOLUTION: Final = 0x4
_USER_INITIATED: Final = 0x00EFFFFF
"""The value NSActivityUserInitiatedAllowingIdleSystemSleep."""
_LATENCY_CRITICAL: Final = 0xFF00000000
"""The value NSActivityLatencyCritical."""
_WHY: Final = b"A robot arm is connected"

Send = Callable[..., Any]
"""Sends an object of macOS a message: the object, the message's name, its arguments."""


class PowerThrottling(ctypes.Structure):
    """PROCESS_POWER_THROTTLING_STATE: the settings that the process controls, and their values."""

    _fields_ = (
        ("version", ctypes.c_uint32),
        ("control_mask", ctypes.c_uint32),
        ("state_mask", ctypes.c_uint32),
    )


def keep_on_windows(kernel: Any, process: object, *, kept: bool) -> bool:
    """Have Windows keep the speed and timers of this process, or decide on both again.

    Args:
        kernel: The library kernel32.
        process: The handle of this process.
        kept: True to keep them.

    Returns:
        True if it was granted; Windows 10 before version 1709 lacks this.
    """
    decided = _EXECUTION_SPEED | _IGNORE_TIMER_RESOLUTION if kept else 0
    state = PowerThrottling(1, decided, 0)
    size = ctypes.sizeof(state)
    return bool(kernel.SetProcessInformation(process, _POWER_THROTTLING, ctypes.byref(state), size))


class Activity:
    """An activity that keeps macOS from napping the program.

    Args:
        send: Sends a message; a class is named by its name.
    """

    def __init__(self, send: Send) -> None:
        self._send = send
        self._begun: Any = None

    def keep(self, *, kept: bool) -> None:
        """Begin or end the activity; harmless if it is in that state already."""
        process = self._send("NSProcessInfo", "processInfo")
        if kept and self._begun is None:
            why = self._send("NSString", "stringWithUTF8String:", _WHY)
            begin = "beginActivityWithOptions:reason:"
            begun = self._send(process, begin, _USER_INITIATED | _LATENCY_CRITICAL, why)
            self._begun = self._send(begun, "retain")
        elif not kept and self._begun is not None:
            self._send(process, "endActivity:", self._begun)
            self._send(self._begun, "release")
            self._begun = None


if sys.platform == "win32":

    def keep_timers(*, kept: bool) -> None:
        """Have the system keep this program's timers, or leave them to it; from one thread."""
        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.GetCurrentProcess.restype = ctypes.c_void_p
        process = ctypes.c_void_p(kernel.GetCurrentProcess())
        if not keep_on_windows(kernel, process, kept=kept) and kept:
            _LOG.info("Windows may slow the timers of covered windows: it has no switch for it")

elif sys.platform == "darwin":

    def _sender() -> Send:
        ctypes.CDLL("/System/Library/Frameworks/Foundation.framework/Foundation")
        objc = ctypes.CDLL("/usr/lib/libobjc.dylib")
        objc.objc_getClass.restype = objc.sel_registerName.restype = ctypes.c_void_p

        def send(receiver: Any, message: str, *arguments: object) -> Any:
            if isinstance(receiver, str):
                receiver = objc.objc_getClass(receiver.encode())
            kinds = [ctypes.c_void_p] * (3 + len(arguments))
            call = ctypes.cast(objc.objc_msgSend, ctypes.CFUNCTYPE(*kinds))
            return call(receiver, objc.sel_registerName(message.encode()), *arguments)

        return send

    _ACTIVITIES: Final[list[Activity]] = []

    def keep_timers(*, kept: bool) -> None:
        """Have the system keep this program's timers, or leave them to it; from one thread."""
        try:
            if not _ACTIVITIES:
                _ACTIVITIES.append(Activity(_sender()))
            _ACTIVITIES[0].keep(kept=kept)
        except (OSError, AttributeError) as error:
            _LOG.info("macOS may slow the timers of covered windows: %s", error)

else:

    def keep_timers(*, kept: bool) -> None:
        """Linux keeps them anyway."""
