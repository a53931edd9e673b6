"""Gives window, bus and stop priority over other programs on a busy PC, as far as permitted.

A press waits until the system schedules its thread: on a PC whose cores are all busy that is most
of the time between press and bus. Linux prioritises a program by its nice value, which it grants by
a limit (RLIMIT_NICE) or, on a desktop, through rtkit; Windows by the priority class of a process.
macOS prioritises the thread of a window by itself.

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
"""The nice value: nine times the share of an ordinary thread; rtkit grants down to -15."""

_ABOVE_NORMAL: Final = 0x8000
"""The value ABOVE_NORMAL_PRIORITY_CLASS, which child processes don't inherit."""
_TASKS: Final = Path("/proc/self/task")
_ANSWER_S: Final = 2.0


class RaisedBy(enum.Enum):
    """The party that granted the priority."""

    SYSTEM = "system"
    """The program's own rights suffice."""
    RTKIT = "rtkit"
    NOBODY = "nobody"
    NOT_NEEDED = "not needed"
    """The system prioritises the thread of a window by itself."""


@dataclass(frozen=True, slots=True)
class Rise:
    """The result of requesting a priority.

    Attributes:
        by: The party that granted it.
        reason: The system's reason for a refusal; "" if there was none.
    """

    by: RaisedBy
    reason: str = ""


def raise_threads(thread_ids: Iterable[int] | None = None) -> Rise:
    """Raise threads of this process above other programs.

    Waits for files and D-Bus.

    Threads and processes started by these do not inherit it: call this again for new ones.

    Args:
        thread_ids: The system's thread numbers; by default all threads. Windows has only a priority
            of the whole process.
    """
    return _raise(thread_ids)


def raise_in_background() -> None:
    """Raise all present threads in a short-lived thread, which logs the result."""
    threading.Thread(target=_raise_and_tell, name="armui-priority", daemon=True).start()


def _raise_and_tell() -> None:
    rise = raise_threads()
    if rise.by is RaisedBy.NOBODY:
        _LOG.info("Threads keep the priority of other programs: %s", rise.reason)
    else:
        _LOG.info("Threads go before other programs' (%s)", rise.by.value)


if sys.platform == "linux":

    def _raise(thread_ids: Iterable[int] | None) -> Rise:
        """Raise threads by the first way that the system permits."""
        wanted = _all_threads() if thread_ids is None else list(thread_ids)
        try:
            _by_right(wanted)
        except PermissionError:
            pass
        else:
            return Rise(RaisedBy.SYSTEM)
        try:
            _by_rtkit(wanted)
        except Exception as error:  # noqa: BLE001 - D-Bus fails in many ways beyond our control
            return Rise(RaisedBy.NOBODY, str(error) or type(error).__name__)
        return Rise(RaisedBy.RTKIT)

    def _all_threads() -> list[int]:
        return [int(each.name) for each in _TASKS.iterdir()]

    def _by_right(thread_ids: list[int]) -> None:
        """Raise threads as far as RLIMIT_NICE lets this user.

        Raises:
            PermissionError: it does not go that far.
        """
        for thread_id in thread_ids:
            with contextlib.suppress(ProcessLookupError):  # the thread has just ended
                if os.getpriority(os.PRIO_PROCESS, thread_id) > NICE:
                    # processes started by this thread, such as a browser, get the ordinary priority
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
                with contextlib.suppress(ProcessLookupError):  # the thread has just ended
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
