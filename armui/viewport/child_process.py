"""The picture's process, seen from the program: how it begins, and how it ends."""

from __future__ import annotations

import contextlib
import importlib
import multiprocessing
import pickle
import signal
import threading
from multiprocessing.connection import wait
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from armui.system.files import read_file
from armui.viewport.watch import ThreadTurns

if TYPE_CHECKING:
    from collections.abc import Callable
    from multiprocessing.connection import Connection

    from armui.viewport.messages import Answer, Draw

_END_LIMIT_S: Final = 1.0
_SMALL_BYTES: Final = 32_768
"""A message of this size fits into the pipe: sending it waits for nobody."""

_TAKEN_LIMIT_S: Final = 5.0


def run_entry(entry: str, connection: Connection) -> None:
    """In the new process: find the function and give it the pipe."""
    module, _, function = entry.partition(":")
    getattr(importlib.import_module(module), function)(connection)


class ChildProcess:
    """One process, from its start to its end; used by one thread, but for `kill`.

    Args:
        entry: See `ENTRY`.
        on_end: Called in another thread when the process has ended by itself or was killed.

    Raises:
        OSError: the system starts no more processes.
    """

    def __init__(self, entry: str, on_end: Callable[[], None]) -> None:
        # a fork would inherit Qt, its threads and every lock they hold
        context = multiprocessing.get_context("spawn")
        self._connection, theirs = context.Pipe()
        self._process = context.Process(
            target=run_entry, args=(entry, theirs), name="armui-viewport", daemon=True
        )
        try:
            self._process.start()
        except BaseException:
            self._connection.close()
            raise
        finally:
            theirs.close()  # so that the process's end is the end of the pipe
        self._watcher = threading.Thread(
            target=self._watch, args=(on_end,), name="armui-viewport-end", daemon=True
        )
        self._watcher.start()

    @property
    def pid(self) -> int | None:
        """The process's number."""
        return self._process.pid

    def send(self, message: Draw) -> None:
        """Hand over a request.

        Raises:
            OSError: the process has ended, or takes nothing any more and was killed for it.
        """
        content = pickle.dumps(message)
        if len(content) < _SMALL_BYTES:
            self._connection.send_bytes(content)
            return
        # A process that stands still does not empty the pipe: a large message would wait for ever.
        limit = threading.Timer(_TAKEN_LIMIT_S, self.kill)
        limit.daemon = True
        limit.start()
        try:
            self._connection.send_bytes(content)
        finally:
            limit.cancel()

    def receive(self, limit_s: float) -> Answer | None:
        """The next message; None: there was none within the limit.

        Raises:
            EOFError, OSError: the process has ended.
        """
        if not self._connection.poll(limit_s):
            return None
        message: Answer = self._connection.recv()
        return message

    def turns(self) -> dict[int, ThreadTurns]:
        """What its threads have had of the processors so far; nothing where that can't be read.

        Source: schedstat and stat of /proc/pid/task/tid of Linux.
        """
        turns = {}
        with contextlib.suppress(OSError, ValueError, IndexError):  # a thread may end meanwhile
            for task in Path(f"/proc/{self.pid}/task").iterdir():
                ran_ns, queued_ns = read_file(task / "schedstat").split()[:2]
                state = read_file(task / "stat").decode().rpartition(") ")[2][:1]
                turns[int(task.name)] = ThreadTurns(
                    1e-9 * int(ran_ns), 1e-9 * int(queued_ns), state == "R"
                )
        return turns

    def kill(self) -> None:
        """End the process at once; may be called from any thread, and twice."""
        with contextlib.suppress(OSError, ValueError):
            self._process.kill()

    def end(self) -> str:
        """End the process, wait for it with a limit, give everything back.

        Returns:
            How it ended: the name of a signal, or an exit code.
        """
        self._process.join(_END_LIMIT_S / 2.0)
        self.kill()
        self._process.join(_END_LIMIT_S)
        self._watcher.join(_END_LIMIT_S)
        self._connection.close()
        return _describe(self._process.exitcode)

    def _watch(self, on_end: Callable[[], None]) -> None:
        ready: list[Any] = wait([self._process.sentinel])
        if ready:
            on_end()


def _describe(exit_code: int | None) -> str:
    if exit_code is None:
        return "?"
    if exit_code < 0:
        with contextlib.suppress(ValueError):
            return signal.Signals(-exit_code).name
    return f"0x{exit_code & 0xFFFFFFFF:X}" if exit_code > 255 else str(exit_code)
