"""A process for work that would hold up the window and the bus if it shared Python's lock."""

from __future__ import annotations

import logging
import os
import signal
import threading
import traceback
from collections.abc import Callable
from concurrent.futures import BrokenExecutor, Executor, Future
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing.process import BaseProcess

_LOG: Final = logging.getLogger(__name__)

_NICER_BY: Final = 5
"""The window and the bus go before it where there are too few cores for all."""


class HelperProcess(Executor):
    """Does one piece of work after another; it begins with the first and ends with the program.

    A process that dies takes its work along; the next piece gets another.
    """

    def __init__(self) -> None:
        self._pool: ProcessPoolExecutor | None = None
        self._children: set[BaseProcess] = set()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Have something done.

        Args:
            fn: A function of a module: the other process imports it by its name.
            *args: What it is called with; it is copied, and so is what comes back.
            **kwargs: As above.
        """
        try:
            return self._submit(fn, *args, **kwargs)
        except BrokenExecutor:
            self.shutdown()
            return self._submit(fn, *args, **kwargs)

    def _submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        import multiprocessing  # noqa: PLC0415 - 50 ms of the start, for those who never use it
        from concurrent.futures import ProcessPoolExecutor  # noqa: PLC0415 - as above

        before = set(multiprocessing.active_children())
        if self._pool is None:
            # a fork would inherit Qt, its threads and every lock they hold
            context = multiprocessing.get_context("spawn")
            self._pool = ProcessPoolExecutor(1, mp_context=context, initializer=_settle_in)
        future = self._pool.submit(fn, *args, **kwargs)
        future.add_done_callback(_log_failure)
        self._children |= set(multiprocessing.active_children()) - before
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = True) -> None:
        """End the process, whatever it is doing: nobody waits for it any more."""
        for child in self._children:
            child.kill()
        self._children.clear()
        if self._pool is not None:
            self._pool.shutdown(wait, cancel_futures=cancel_futures)
            self._pool = None


def _log_failure(future: Future[Any]) -> None:
    """Keep in the log what went wrong over there; who asked for the work tells the operator."""
    error = None if future.cancelled() else future.exception()
    if error is not None:
        trace = "".join(traceback.format_exception(error))
        _LOG.warning("Work in the helper process has failed\n%s", trace)


def _settle_in() -> None:
    """In the new process: leave Ctrl-C to the program, stand back, do not outlive it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(os, "nice"):
        os.nice(_NICER_BY)
    threading.Thread(target=_end_with_the_program, daemon=True).start()


def _end_with_the_program() -> None:
    from multiprocessing import parent_process  # noqa: PLC0415 - there already, in that process

    program = parent_process()
    if program is not None:
        program.join()
        os._exit(1)
