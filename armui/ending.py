"""Ends motion before the system ends the program or sends the computer to sleep (safety S28).

Signals (SIGTERM, SIGHUP, SIGINT; on Windows also a closed console), the end of a session
(`QGuiApplication.commitDataRequest`), and sleep or shutdown as logind announces them on Linux.
Threads of their own listen, so that a blocked window does not keep the arm moving.

Source: signal(7), ``signal.set_wakeup_fd``, systemd's inhibitor locks, SetConsoleCtrlHandler.
"""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import socket
import sys
import threading
import time
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, Any, Final, Protocol, Self

from PySide6.QtCore import QObject, Qt, Signal

from armui.system.end_signals import give_back, take_over
from armui.system.log_file import flush_log

if sys.platform == "win32":
    import ctypes

if TYPE_CHECKING:
    from PySide6.QtWidgets import QApplication

    from armui.control.arm_controller import ArmController
    from armui.ui.main_window import MainWindow

_LOG: Final = logging.getLogger(__name__)

_BUSY_S: Final = 0.25
"""A window that has not ended the motion by then is blocked: the arm is stopped from here."""
_AGAIN_S: Final = 0.1
_CLOSED_S: Final = 0.7
"""After this time the process ends, even if something keeps its bus open."""
_REST_S: Final = 0.15
"""The additional time for writing files and ending processes; a disk may hang."""
_ANSWER_S: Final = 2.0
_CONSOLE_CLOSED: Final = frozenset({2, 5, 6})  # CTRL_CLOSE_EVENT, _LOGOFF_EVENT, _SHUTDOWN_EVENT

_LOGIND: Final = "org.freedesktop.login1"
_LOGIND_PATH: Final = "/org/freedesktop/login1"
_ANNOUNCED: Final = ("PrepareForSleep", "PrepareForShutdown")


class EndingProgram(Protocol):
    """The program to end: see :class:`armui.app.Program`."""

    controller: ArmController
    window: MainWindow
    closed: threading.Event

    @property
    def unwritten(self) -> Sequence[str]:
        """The names of the functions that still wait for a disk."""

    def shutdown(self) -> None:
        """End the motion and every thread."""


class SystemEnd(QObject):
    """Ends the program when the system asks for it; a context, to be left when it has ended.

    A signal that was ignored at the start, as with ``nohup``, stays ignored.

    Args:
        app: Qt's application.
        program: The program to end.
        exit_now: Ends the process at once.
    """

    _asked = Signal(int)
    _motion_asked = Signal()

    def __init__(
        self,
        app: QApplication,
        program: EndingProgram,
        exit_now: Callable[[int], object] = os._exit,
    ) -> None:
        super().__init__()
        self._app, self._program, self._exit_now = app, program, exit_now
        self._asked.connect(self._on_asked, Qt.ConnectionType.QueuedConnection)
        self._motion_asked.connect(self._end_motion, Qt.ConnectionType.QueuedConnection)
        app.commitDataRequest.connect(self._on_session_ends)
        self._motion_ended = threading.Event()
        self._listening, self._wakes = socket.socketpair()
        self._before: dict[int, Any] = {}
        self._thread = threading.Thread(target=self._listen, name="armui-signals", daemon=True)
        self._sleep_watch = SleepWatch(self.end_motion_in_time)

    def __enter__(self) -> Self:
        self._wakes.setblocking(False)
        signal.set_wakeup_fd(self._wakes.fileno(), warn_on_full_buffer=False)
        # The handlers do nothing: the system wakes the thread below through the socket.
        self._before = take_over(lambda *_: None)
        if sys.platform == "win32":
            self._follow_console()
        self._thread.start()
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        give_back(self._before)
        signal.set_wakeup_fd(-1)
        self._wakes.close()
        self._sleep_watch.end()
        self._thread.join(_BUSY_S)
        self._listening.close()

    def watch_sleep(self) -> None:
        """Listen for sleep and shutdown, if the system announces them."""
        self._sleep_watch.start()

    # In the window's thread -------------------------------------------------------------------

    def _end_motion(self) -> None:
        self._program.controller.end_all_motion()
        self._motion_ended.set()

    def _on_asked(self, number: int) -> None:
        """End as closing the window does, but ask nobody and take nothing to pieces (S28)."""
        self._end_motion()
        self._program.window.keep_work()
        self._program.shutdown()
        self._exit(number)

    def _on_session_ends(self, _manager: object = None) -> None:
        """The operator logs out, which another program may still call off."""
        self._end_motion()
        self._program.window.keep_drafts()

    # In threads -------------------------------------------------------------------------------

    def end_motion_in_time(self) -> None:
        """Have the window end the motion, or, if it is blocked, stop the arm from this thread."""
        self._motion_ended.clear()
        self._motion_asked.emit()
        self._await_rest(time.monotonic() + _CLOSED_S)

    def _await_rest(self, until_s: float) -> None:
        self._motion_ended.wait(_BUSY_S)
        abort, closed = self._program.controller.abort_from_any_thread, self._program.closed
        while (left_s := until_s - time.monotonic()) > 0.0 and abort():
            closed.wait(min(_AGAIN_S, left_s))

    def _listen(self) -> None:
        number = self._first_signal()
        if number is None:
            return
        until_s = time.monotonic() + _CLOSED_S
        _LOG.info("The system ends the program: signal %d", number)
        self._motion_ended.clear()
        self._asked.emit(number)
        self._await_rest(until_s)
        if self._program.closed.wait(max(0.0, until_s - time.monotonic())):
            # The window's thread ends the process; this thread does so only if that one hangs.
            time.sleep(max(0.0, until_s + _REST_S - time.monotonic()))
        self._exit(number)

    def _exit(self, number: int) -> None:
        """End the process; what a disk has not taken by now is named in the log."""
        unwritten = self._program.unwritten
        if unwritten:
            _LOG.warning("Not written, the disk was too slow: %s", ", ".join(unwritten))
        flush_log()
        self._exit_now(128 + number)

    def _first_signal(self) -> int | None:
        """The number of the first signal; ``None``: there will be none."""
        try:
            received = self._listening.recv(1)
        except OSError:
            return None
        return received[0] if received else None

    if sys.platform == "win32":

        def _follow_console(self) -> None:
            """A console that is closed ends the process when this handler returns."""

            def on_event(kind: int) -> bool:
                if kind in _CONSOLE_CLOSED:
                    self._wakes.send(bytes([signal.SIGBREAK]))
                    self._program.closed.wait(_CLOSED_S)
                return kind in _CONSOLE_CLOSED

            # Kept as an attribute, because Windows does not keep the function alive.
            self._handler = ctypes.WINFUNCTYPE(ctypes.c_int, ctypes.c_uint)(on_event)
            ctypes.windll.kernel32.SetConsoleCtrlHandler(self._handler, 1)


class SleepWatch:
    """Delays sleep and shutdown until the motion has ended (logind, Linux).

    Without D-Bus or logind, as in most containers, it silently does nothing.

    Args:
        end_motion: Called in a thread; when it returns, the system goes on.
        connect: Opens a connection to the system's bus.
    """

    def __init__(
        self, end_motion: Callable[[], object], connect: Callable[[], Any] | None = None
    ) -> None:
        self._end_motion = end_motion
        self._connect = connect or _system_bus
        self._connection: Any = None
        self._thread: threading.Thread | None = None
        self._ending = False

    def start(self) -> None:
        """Start listening; does nothing on other systems than Linux."""
        if sys.platform == "linux" and self._thread is None:
            self._thread = threading.Thread(target=self._run, name="armui-sleep", daemon=True)
            self._thread.start()

    def end(self) -> None:
        """Stop listening."""
        self._ending = True
        connection = self._connection
        if connection is not None:
            with contextlib.suppress(OSError):
                connection.sock.shutdown(socket.SHUT_RDWR)  # wakes the thread
        if self._thread is not None:
            self._thread.join(_BUSY_S)

    def _run(self) -> None:
        try:
            with self._connect() as connection:
                self._connection = connection
                if not self._ending:
                    self._listen(connection)
        except Exception as error:  # noqa: BLE001 - no bus, no logind, closed: nothing is to be heard
            _LOG.debug("Sleep is not told beforehand: %s", error)

    def _listen(self, connection: Any) -> None:
        from jeepney import HeaderFields, MatchRule, message_bus  # noqa: PLC0415 - where there is a bus
        from jeepney.wrappers import unwrap_msg  # noqa: PLC0415 - as above

        for member in _ANNOUNCED:
            rule = MatchRule(
                type="signal", interface=f"{_LOGIND}.Manager", path=_LOGIND_PATH, member=member
            )
            unwrap_msg(connection.send_and_get_reply(message_bus.AddMatch(rule), timeout=_ANSWER_S))
        lock = None
        try:
            lock = self._inhibit(connection)
            while not self._ending:
                message = connection.receive()
                if message.header.fields.get(HeaderFields.member) not in _ANNOUNCED:
                    continue
                if message.body[0]:
                    self._end_motion()
                    if lock is not None:
                        lock.close()
                        lock = None
                elif lock is None:
                    lock = self._inhibit(connection)
        finally:
            if lock is not None:
                lock.close()

    def _inhibit(self, connection: Any) -> Any:
        """Take a lock that delays sleep and shutdown, by up to five seconds, until it is closed."""
        from jeepney import DBusAddress, new_method_call  # noqa: PLC0415 - as above
        from jeepney.wrappers import unwrap_msg  # noqa: PLC0415 - as above

        logind = DBusAddress(_LOGIND_PATH, _LOGIND, f"{_LOGIND}.Manager")
        asked = ("sleep:shutdown", "armui", "The arm's motion is ended first", "delay")
        call = new_method_call(logind, "Inhibit", "ssss", asked)
        return unwrap_msg(connection.send_and_get_reply(call, timeout=_ANSWER_S))[0]


def _system_bus() -> Any:
    from jeepney.io.blocking import open_dbus_connection  # noqa: PLC0415 - for those who need it

    return open_dbus_connection(bus="SYSTEM", enable_fds=True)
