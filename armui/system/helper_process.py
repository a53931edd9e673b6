"""A process for work that would hold up the window and the bus if it shared Python's lock."""

from __future__ import annotations

import contextlib
import errno
import logging
import mmap
import multiprocessing
import os
import pickle
import signal
import tempfile
import threading
import time
import traceback
import weakref
from collections.abc import Callable
from concurrent.futures import (
    BrokenExecutor,
    Executor,
    Future,
    InvalidStateError,
    ProcessPoolExecutor,
    ThreadPoolExecutor,
)
from concurrent.futures import wait as wait_for
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING, Any, Final

from armui.system.files import open_file
from armui.system.scratch import make_folder, remove_folder, remove_leftovers

if TYPE_CHECKING:
    from multiprocessing.process import BaseProcess

# Values between two processes: large arrays travel as a file that the receiver maps. Copying two
# hours of samples through a pipe holds Python's lock for tens of milliseconds at a stretch, in
# which no button is heard. Writing them to a file and mapping it holds it for none.

LARGE_BYTES: Final = 1 << 18
"""Arrays of this size and more go into the file."""

_ALIGNED: Final = 64


@dataclass(frozen=True, slots=True)
class Packed:
    """A value on its way.

    Attributes:
        data: Everything but its large arrays.
        path: The file that holds those; the receiver removes it. ``None`` where there are none.
        spans: Where each begins in the file, and how many bytes it has.
    """

    data: bytes
    path: Path | None = None
    spans: tuple[tuple[int, int], ...] = ()


def pack(value: object, folder: Path) -> Packed:
    """Make a value ready to be sent.

    Args:
        value: Anything that can be pickled.
        folder: Where its large arrays may be written.

    Raises:
        OSError: They were not written.
    """
    large: list[memoryview] = []

    def is_small(buffer: pickle.PickleBuffer) -> bool:
        raw = buffer.raw()
        if raw.nbytes < LARGE_BYTES:
            return True
        large.append(raw)
        return False

    data = pickle.dumps(value, protocol=5, buffer_callback=is_small)
    if not large:
        return Packed(data)
    spans: list[tuple[int, int]] = []
    with tempfile.NamedTemporaryFile(dir=folder, delete=False) as file:
        for raw in large:
            begin = -(-file.tell() // _ALIGNED) * _ALIGNED
            file.seek(begin)
            file.write(raw)
            spans.append((begin, raw.nbytes))
    return Packed(data, Path(file.name), tuple(spans))


def unpack(packed: Packed) -> Any:
    """Return the value. Changes of its arrays are seen by nobody else.

    Raises:
        OSError: The file of its large arrays is gone.
    """
    if packed.path is None:
        return pickle.loads(packed.data)  # noqa: S301 - from our own process
    with open_file(packed.path) as file:
        mapped = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_COPY)
    whole = memoryview(mapped)
    try:
        packed.path.unlink()
    except OSError:  # Windows removes no file that is mapped: there it goes with the mapping
        weakref.finalize(mapped, _remove, packed.path)
    buffers = [whole[begin : begin + length] for begin, length in packed.spans]
    return pickle.loads(packed.data, buffers=buffers)  # noqa: S301 - as above


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):  # the next program's sweep finds it
        path.unlink()


def call_packed(packed: Packed, folder: Path) -> Packed:
    """In the other process: call what was sent, send back what comes of it."""
    function, args, kwargs = unpack(packed)
    return pack(function(*args, **kwargs), folder)


_LOG: Final = logging.getLogger(__name__)

_NICER_BY: Final = 5
"""The window and the bus go before it where there are too few cores for all."""
_END_S: Final = 10.0

HANGS_S: Final = 10.0
"""A disk that spins up takes some seconds; one that takes longer does not answer."""
CALL_HANGS_S: Final = 120.0
"""Two hours of samples are read in some seconds, on a slow computer in a minute."""
_MOST_HANGING: Final = 8
"""So many threads are left to themselves; each keeps what it was given."""


class HelperProcess(Executor):
    """Does one piece of work after another; it begins with the first and ends with the program.

    A process that dies takes its work along; the next piece gets another. Starting the process and
    copying what it is given is done by a thread: whoever asks for work goes on at once.
    """

    def __init__(self) -> None:
        self._pool: ProcessPoolExecutor | None = None
        self._children: set[BaseProcess] = set()
        self._sender: ThreadPoolExecutor | None = None
        self._asked: set[Future[Any]] = set()
        self._called_off = threading.Event()
        self._folder: Path | None = None

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Have something done.

        Args:
            fn: A function of a module: the other process imports it by its name.
            *args: What it is called with; it is copied, and so is what comes back.
            **kwargs: As above.
        """
        answer: Future[Any] = Future()
        self._asked.add(answer)
        answer.add_done_callback(self._asked.discard)
        if self._sender is None:
            self._sender = ThreadPoolExecutor(1, "armui-helper")
        self._sender.submit(self._send, answer, (fn, args, kwargs))
        return answer

    def _send(self, answer: Future[Any], call: tuple[object, ...]) -> None:
        """Hand a piece of work to the process; its answer comes by a thread of the pool."""
        try:
            if self._folder is None:
                remove_leftovers()
                self._folder = make_folder("work")
            packed = pack(call, self._folder)
            try:
                sent = self._submit(packed, self._folder)
            except BrokenExecutor:
                self._end_process(wait=True)
                sent = self._submit(packed, self._folder)
        except Exception as error:  # noqa: BLE001 - whatever it is, it is in the answer
            _settle(answer, error=error)
            return
        sent.add_done_callback(partial(_answer, answer))

    def _submit(self, packed: Packed, folder: Path) -> Future[Packed]:
        before = set(multiprocessing.active_children())
        if self._pool is None:
            # a fork would inherit Qt, its threads and every lock they hold
            context = multiprocessing.get_context("spawn")
            self._pool = ProcessPoolExecutor(1, mp_context=context, initializer=configure_process)
        future = self._pool.submit(call_packed, packed, folder)
        future.add_done_callback(partial(_log_failure, self._called_off))
        self._children |= set(multiprocessing.active_children()) - before
        return future

    def _end_process(self, *, wait: bool) -> None:
        for child in self._children:
            child.kill()
        self._children.clear()
        if self._pool is not None:
            self._pool.shutdown(wait, cancel_futures=True)
            self._pool = None

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = True) -> None:
        """End the process, whatever it is doing: nobody waits for it any more."""
        if self._sender is not None:
            self._sender.shutdown(wait=True, cancel_futures=cancel_futures)
            self._sender = None
        self._called_off.set()
        self._end_process(wait=wait)
        self._called_off = threading.Event()  # whoever asks for more gets another process
        for answer in tuple(self._asked):
            answer.cancel()
        if self._folder is not None:
            remove_folder(self._folder)
            self._folder = None


@dataclass(slots=True)
class _FileJob:
    """Something to be done by the file thread, and who waits for it."""

    answer: Future[Any]
    work: Callable[[], Any]

    def do(self) -> None:
        if not self.answer.set_running_or_notify_cancel():
            return
        try:
            _settle(self.answer, self.work())
        except BaseException as error:  # noqa: BLE001 - whatever it is, it is in the answer
            _settle(self.answer, error=error)


class _Worker(threading.Thread):
    """Does what lies in a queue until it is left to itself, or finds the end, ``None``.

    Attributes:
        since_s: When what it is doing was begun; ``None``: it waits for more.
        calling: Whether it waits for the other process.
        left: Nobody counts on it any more: it hangs.
    """

    def __init__(self, jobs: SimpleQueue[_FileJob | None]) -> None:
        super().__init__(name="armui-files", daemon=True)
        self._jobs = jobs
        self.since_s: float | None = None
        self.calling = self.left = False

    def run(self) -> None:
        while not self.left and (job := self._jobs.get()) is not None:
            self.since_s = time.monotonic()
            job.do()
            del job  # what it holds is not kept until the next one
            self.since_s = None


def _taken_from(jobs: SimpleQueue[_FileJob | None]) -> list[_FileJob]:
    """Take out what nobody has begun yet."""
    found = []
    with contextlib.suppress(Empty):
        while True:
            job = jobs.get_nowait()
            if job is not None:
                found.append(job)
    return found


class FileThread(Executor):
    """One thread for what waits for a disk, with a process for what would take it long.

    A disk or network share that does not answer holds whoever asked it, and no thread can be ended:
    `replace_hung` leaves it to itself and goes on with another. What the first was doing may still
    come to its end, and is told then. Only so many are left behind; after that everything is
    refused until one of them comes back.
    """

    def __init__(self) -> None:
        self._jobs: SimpleQueue[_FileJob | None] = SimpleQueue()
        self._worker: _Worker | None = None
        self._left: list[_Worker] = []
        self._turn = threading.Lock()
        self._process = HelperProcess()
        self._last: Future[None] | None = None
        self._undone: dict[Future[Any], str] = {}

    @property
    def ended(self) -> bool:
        """Whether, after `shutdown`, everything that was asked for is done."""
        return self._last is not None and self._last.done() and not self.hanging

    @property
    def hanging(self) -> int:
        """How many threads wait for a disk that does not answer."""
        self._left = [each for each in self._left if each.is_alive()]
        return len(self._left)

    @property
    def waiting(self) -> list[str]:
        """What was asked for and is not done, by the names of its functions."""
        undone = self._undone.copy()
        return [name for answer, name in undone.items() if answer is not self._last]

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Have something done, after what was asked for before.

        Raises:
            RuntimeError: After `shutdown`.
        """
        if self._last is not None:
            raise RuntimeError("cannot schedule new futures after shutdown")
        job = _FileJob(Future(), partial(fn, *args, **kwargs))
        self._undone[job.answer] = _name_of(fn)
        job.answer.add_done_callback(self._undone.pop)
        with self._turn:
            self._add(job)
        return job.answer

    def _add(self, job: _FileJob) -> None:
        if self._worker is None and self.hanging < _MOST_HANGING:
            self._worker = _Worker(self._jobs)
            self._worker.start()
        if self._worker is None:
            _settle(job.answer, error=OSError(errno.ETIMEDOUT, os.strerror(errno.ETIMEDOUT)))
        else:
            self._jobs.put(job)

    def replace_hung(self, after_s: float = HANGS_S, call_s: float = CALL_HANGS_S) -> bool:
        """Go on without the thread if it hangs; to be called once a second.

        Args:
            after_s: So long nothing takes that a disk answers.
            call_s: So long nothing takes that the other process does for it.

        Returns:
            Whether it was found to hang.
        """
        worker = self._worker
        if worker is None or (since_s := worker.since_s) is None:
            return False
        if time.monotonic() - since_s < (call_s if worker.calling else after_s):
            return False
        with self._turn:
            self._leave(worker)
        return True

    def _leave(self, worker: _Worker) -> None:
        worker.left = True
        self._left.append(worker)
        _LOG.warning("A disk does not answer; %d threads wait for one", self.hanging)
        if worker.calling:
            # it is the process that hangs; waiting for its end could hang, too
            process, self._process = self._process, HelperProcess()
            threading.Thread(target=process.shutdown, args=(False,), daemon=True).start()
        waiting, self._jobs, self._worker = self._jobs, SimpleQueue(), None
        for job in _taken_from(waiting):
            self._add(job)
        waiting.put(None)  # it may have come back in this moment, and look for more

    def call(self, function: Callable[..., Any], *args: Any) -> Any:
        """Call something in the process, and wait for it; only this thread may.

        Raises:
            Exception: What it raises there.
        """
        worker = threading.current_thread()
        if not isinstance(worker, _Worker):
            return self._process.submit(function, *args).result()
        worker.calling = True
        try:
            return self._process.submit(function, *args).result()
        finally:
            worker.calling, worker.since_s = False, time.monotonic()

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """End it when what was asked for is done, or after ten seconds: a disk may hang."""
        if self._last is None:
            if cancel_futures:
                with self._turn:
                    for job in _taken_from(self._jobs):
                        job.answer.cancel()
            self._last = self.submit(_come_to_the_end)
            self._jobs.put(None)
        if wait:
            wait_for([self._last], _END_S)
        self._process.shutdown()


def _come_to_the_end() -> None:
    """Stands behind everything that is to be done."""


def _name_of(work: Callable[..., Any]) -> str:
    while isinstance(work, partial):
        work = work.func
    return getattr(work, "__qualname__", type(work).__name__)


def _answer(answer: Future[Any], sent: Future[Packed]) -> None:
    if sent.cancelled():
        answer.cancel()
        return
    error = sent.exception()
    if error is not None:
        _settle(answer, error=error)
        return

    try:
        _settle(answer, unpack(sent.result()))
    except Exception as problem:  # noqa: BLE001 - whatever it is, it is in the answer
        _settle(answer, error=problem)


def _settle(
    answer: Future[Any], value: object = None, *, error: BaseException | None = None
) -> None:
    """Give an answer, unless nobody waits for it any more."""
    with contextlib.suppress(InvalidStateError):
        if error is None:
            answer.set_result(value)
        else:
            answer.set_exception(error)


def _log_failure(called_off: threading.Event, future: Future[Any]) -> None:
    """Keep in the log what went wrong over there; who asked for the work tells the operator.

    Work that was called off with its process has not failed.
    """
    error = None if future.cancelled() else future.exception()
    if isinstance(error, BrokenExecutor) and called_off.is_set():
        return
    if error is not None:
        trace = "".join(traceback.format_exception(error))
        _LOG.warning("Work in the helper process has failed\n%s", trace)


def configure_process() -> None:
    """In the new process: leave Ctrl-C to the program, stand back, do not outlive it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if hasattr(os, "nice"):
        os.nice(_NICER_BY)
    threading.Thread(target=_end_with_the_program, daemon=True).start()


def _end_with_the_program() -> None:
    program = multiprocessing.parent_process()
    if program is not None:
        program.join()
        os._exit(1)
