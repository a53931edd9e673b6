"""Work that takes long, out of the window's way; what comes of it arrives in the same thread."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Reason, Refusal
from armui.system.files import error_text
from armui.system.helper_process import FileThread

WORK_FAILED = Reason("work_failed", "The program could not finish this: {text}. Try again.")


Result = TypeVar("Result")


@dataclass(slots=True, eq=False)
class Job(Generic[Result]):
    """Work that somebody waits for.

    Attributes:
        then: Gets what came of it, or the :class:`Refusal` that says why nothing did.
        wanted: Whether anybody waits for it still; else nothing is told of it.
    """

    then: Callable[[Result | Refusal], object]
    wanted: bool = True


class Background(QObject):
    """Has work done, one piece after another.

    Args:
        workers: Who does what computes; it may be another process.
        files: Who does what waits for a disk, in a thread of this process; the workers by default.
    """

    _arrived = Signal(object, object)

    def __init__(
        self, workers: Executor, files: Executor | None = None, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._workers = workers
        self._files = workers if files is None else files
        self._arrived.connect(self._on_arrived)

    def call(self, function: Callable[..., Result], *args: object) -> Result:
        """From within `begin_here`: call a function of a module that computes for long."""
        if isinstance(self._files, FileThread):
            result: Result = self._files.call(function, *args)
            return result
        return function(*args)

    def begin(self, job: Job[Result], work: Callable[..., Result], *args: object) -> None:
        """Have a function of a module called; :attr:`Job.then` is called in this thread."""
        self._begin(self._workers, job, work, *args)

    def begin_here(self, job: Job[Result], work: Callable[..., Result], *args: object) -> None:
        """Have something called in another thread of this process; then as `begin`."""
        self._begin(self._files, job, work, *args)

    def _begin(
        self, executor: Executor, job: Job[Result], work: Callable[..., Result], *args: object
    ) -> None:
        # the signal brings it here from whichever thread
        executor.submit(work, *args).add_done_callback(lambda done: self._arrived.emit(job, done))

    def warm_up(self, work: Callable[[], object]) -> None:
        """Have something done that nobody waits for."""
        self._workers.submit(work)

    def _on_arrived(self, job: Job[Result], done: Future[Result]) -> None:
        if not job.wanted or done.cancelled():
            return
        error = done.exception()
        if error is None:
            job.then(done.result())
        else:
            job.then(WORK_FAILED(text=error_text(error)))
