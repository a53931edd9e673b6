"""Window, bus and stop go before other programs where a PC is kept busy, as far as it lets them.

A press waits until the system gives its thread a turn: on a PC whose cores are all taken that is
most of the time between press and bus. Linux lets a program go first by its nice value, which it
grants by a limit (RLIMIT_NICE) or, on a desktop, through rtkit; Windows by the priority class of a
process. macOS puts the thread of a window first by itself.

Source: setpriority(2), sched(7), rtkit's README, SetPriorityClass.
"""

from __future__ import annotations

import contextlib
import ctypes
import enum
import logging
import os
import sys
import threading
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

_LOG: Final = logging.getLogger(__name__)

NICE: Final = -10
"""Nine times the share of an ordinary thread; rtkit grants down to -15."""

_ABOVE_NORMAL: Final = 0x8000
"""ABOVE_NORMAL_PRIORITY_CLASS, which processes begun by this one don't inherit."""
_TASKS: Final = Path("/proc/self/task")
_ANSWER_S: Final = 2.0


class RaisedBy(enum.Enum):
    """Who has let the program go first."""

    SYSTEM = "system"
    """Its own rights suffice."""
    RTKIT = "rtkit"
    NOBODY = "nobody"
    NOT_NEEDED = "not needed"
    """The system puts the thread of a window first by itself."""


@dataclass(frozen=True, slots=True)
class Rise:
    """What came of asking.

    Attributes:
        by: Who has granted it.
        reason: What stood against it, in the system's words; "" if nothing did.
    """

    by: RaisedBy
    reason: str = ""


def raise_threads(thread_ids: Iterable[int] | None = None) -> Rise:
    """Let threads of this process go before those of other programs. Waits for files and D-Bus.

    Threads and processes that these begin do not inherit it: ask again once there are new ones.

    Args:
        thread_ids: As the system numbers them; every thread there is by default. Windows knows
            only the whole process.
    """
    return _raise(thread_ids)


def raise_in_background() -> None:
    """Ask for every thread there is now, in a thread that then ends; what comes of it is logged."""
    threading.Thread(target=_raise_and_tell, name="armui-priority", daemon=True).start()


def _raise_and_tell() -> None:
    rise = raise_threads()
    if rise.by is RaisedBy.NOBODY:
        _LOG.info("Threads keep the priority of other programs: %s", rise.reason)
    else:
        _LOG.info("Threads go before other programs' (%s)", rise.by.value)


if sys.platform == "linux":

    def _raise(thread_ids: Iterable[int] | None) -> Rise:
        """By the first way that is open."""
        wanted = _all_threads() if thread_ids is None else list(thread_ids)
        try:
            _by_right(wanted)
        except PermissionError:
            pass
        else:
            return Rise(RaisedBy.SYSTEM)
        try:
            _by_rtkit(wanted)
        except Exception as error:  # noqa: BLE001 - D-Bus fails in many ways; none is ours to mend
            return Rise(RaisedBy.NOBODY, str(error) or type(error).__name__)
        return Rise(RaisedBy.RTKIT)

    def _all_threads() -> list[int]:
        return [int(each.name) for each in _TASKS.iterdir()]

    def _by_right(thread_ids: list[int]) -> None:
        """As far as RLIMIT_NICE goes.

        Raises:
            PermissionError: it does not go that far.
        """
        for thread_id in thread_ids:
            with contextlib.suppress(ProcessLookupError):  # it has just ended
                if os.getpriority(os.PRIO_PROCESS, thread_id) > NICE:
                    # a browser opened from the menu is no part of this
                    ordinary = os.SCHED_OTHER | os.SCHED_RESET_ON_FORK
                    os.sched_setscheduler(thread_id, ordinary, os.sched_param(0))
                    os.setpriority(os.PRIO_PROCESS, thread_id, NICE)

    def _by_rtkit(thread_ids: list[int]) -> None:
        """Ask the service that does so for the programs of whoever sits at the PC.

        Raises:
            OSError: there is no D-Bus.
            DBusErrorResponse: there is no rtkit, or it refuses.
        """
        from jeepney import DBusAddress, new_method_call  # noqa: PLC0415 - for those who need it
        from jeepney.io.blocking import open_dbus_connection  # noqa: PLC0415 - as above
        from jeepney.wrappers import unwrap_msg  # noqa: PLC0415 - as above

        name = "org.freedesktop.RealtimeKit1"
        rtkit = DBusAddress("/org/freedesktop/RealtimeKit1", name, name)
        with open_dbus_connection(bus="SYSTEM") as connection:
            for thread_id in thread_ids:
                with contextlib.suppress(ProcessLookupError):  # it has just ended
                    if os.getpriority(os.PRIO_PROCESS, thread_id) > NICE:
                        asked = (os.getpid(), thread_id, NICE)
                        method = "MakeThreadHighPriorityWithPID"
                        call = new_method_call(rtkit, method, "tti", asked)
                        unwrap_msg(connection.send_and_get_reply(call, timeout=_ANSWER_S))

elif sys.platform == "win32":

    def _raise(_thread_ids: Iterable[int] | None) -> Rise:
        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.GetCurrentProcess.restype = ctypes.c_void_p
        process = ctypes.c_void_p(kernel.GetCurrentProcess())
        if kernel.SetPriorityClass(process, _ABOVE_NORMAL):
            return Rise(RaisedBy.SYSTEM)
        return Rise(RaisedBy.NOBODY, ctypes.FormatError(ctypes.get_last_error()))

else:

    def _raise(_thread_ids: Iterable[int] | None) -> Rise:
        return Rise(RaisedBy.NOT_NEEDED)
