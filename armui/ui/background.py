"""Runs long work in the background; its result arrives in the window's thread."""

from __future__ import annotations

from collections.abc import Callable, Generator
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from typing import Any, Generic, TypeVar

from PySide6.QtCore import QObject, Signal

from armui.arm.refusal import Reason, Refusal
from armui.system.files import error_text
from armui.system.helper_process import FileThread

WORK_FAILED = Reason("work_failed", "The program could not finish this: {text}. Try again.")


Result = TypeVar("Result")
Then = Callable[[Any], object]
"""Receives the result of work, or a `Refusal`; see :class:`Job`."""


Steps = Generator[Callable[[Then], object], Any, None]
"""Long work as a generator: it yields functions that begin a step, and gets each step's result."""


def in_order(steps: Steps, goes_on: Callable[[], bool]) -> None:
    """Run long work step by step: each step begins with what the one before has yielded.

    Args:
        steps: The work: ``result = yield begin``, where ``begin`` gets what receives the result.
        goes_on: Returns false once it is not wanted any more; then it ends where it waits.
    """

    def go_on(result: object = None) -> None:
        if not goes_on():
            return
        try:
            begin = steps.send(result)
        except StopIteration:
            return
        begin(go_on)

    go_on()


@dataclass(slots=True, eq=False)
class Job(Generic[Result]):
    """Work with a recipient for its result.

    Attributes:
        then: Receives the result, or a :class:`Refusal` with the reason for the failure.
        wanted: False if the result is no longer wanted; it is then dropped.
    """

    then: Callable[[Result | Refusal], object]
    wanted: bool = True

    def __call__(self, result: Result | Refusal) -> None:
        """Receive the result."""
        if self.wanted:
            self.then(result)


class Background(QObject):
    """Runs pieces of work one after another.

    Args:
        workers: Runs computations, possibly in another process.
        files: Runs work that waits for a disk, in a thread of this process; by default the workers.
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
        """Call a long computation from within work of `begin_here`, and return its result."""
        if isinstance(self._files, FileThread):
            result: Result = self._files.call(function, *args)
            return result
        return function(*args)

    def begin(self, then: Then, work: Callable[..., object], /, *args: object) -> None:
        """Run a function of a module; its recipient, as a `Job`, is called in this thread."""
        self._begin(self._workers, then, work, *args)

    def begin_here(self, then: Then, work: Callable[..., object], /, *args: object) -> None:
        """Run a function in another thread of this process, otherwise like `begin`."""
        self._begin(self._files, then, work, *args)

    def _begin(
        self, executor: Executor, then: Then, work: Callable[..., object], *args: object
    ) -> None:
        # the callback runs in a thread of the executor; the signal brings the result into this one
        executor.submit(work, *args).add_done_callback(lambda done: self._arrived.emit(then, done))

    def warm_up(self, work: Callable[[], object]) -> None:
        """Run work in the background whose result is not needed."""
        self._workers.submit(work)

    def _on_arrived(self, then: Then, done: Future[object]) -> None:
        if not done.cancelled():
            error = done.exception()
            then(done.result() if error is None else WORK_FAILED(text=error_text(error)))
