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
from armui.system.scratch import ScratchFolder, make_folder, remove_leftovers

if TYPE_CHECKING:
    from multiprocessing.process import BaseProcess

# Values between two processes: large arrays travel as a file that the receiver maps. Copying two
# hours of samples through a pipe holds Python's lock for tens of milliseconds at a stretch, in
# which no button is heard. Writing them to a file and mapping it holds it for none.

LARGE_BYTES: Final = 1 << 18
"""Arrays of at least this size are passed through a file."""

_ALIGNED: Final = 64

_LOG: Final = logging.getLogger(__name__)

OURS: Final = "armui-"
"""The prefix of the names of processes that were not started by a pool."""

_NICER_BY: Final = 5
"""The nice value's increase, so that window and bus come first if there are too few cores."""

HANGS_S: Final = 10.0
"""A disk that spins up takes some seconds; after this time it counts as hanging."""
CALL_HANGS_S: Final = 120.0
"""Reading two hours of samples takes some seconds, on a slow computer a minute; after this time a
call counts as hanging.
"""


@dataclass(frozen=True, slots=True)
class Packed:
    """A value packed for another process.

    Attributes:
        data: Everything but its large arrays.
        path: The file that holds these; the receiver removes it. ``None`` if there are none.
        spans: The place of each in the file, and its size in bytes.
    """

    data: bytes
    path: Path | None = None
    spans: tuple[tuple[int, int], ...] = ()


def pack(value: object, folder: Path) -> Packed:
    """Return a value packed for another process.

    Args:
        value: Anything that can be pickled.
        folder: The folder for its large arrays.

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
    """Return the value of a packed one. Changes of its arrays do not reach the sender.

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
    except OSError:  # Windows does not remove a mapped file: remove it when it is unmapped
        weakref.finalize(mapped, _remove, packed.path)
    buffers = [whole[begin : begin + length] for begin, length in packed.spans]
    return pickle.loads(packed.data, buffers=buffers)  # noqa: S301 - as above


def _remove(path: Path) -> None:
    with contextlib.suppress(OSError):  # the next start of the program removes it
        path.unlink()


def call_packed(packed: Packed, folder: Path) -> Packed:
    """Call the packed function in the other process, and return its packed result."""
    function, args, kwargs = unpack(packed)
    return pack(function(*args, **kwargs), folder)


class HelperProcess(Executor):
    """Runs one function after another in a process, from the first call to the program's end.

    If the process dies, its work is lost, and the next call starts another. A thread starts the
    process and copies the arguments, so that the caller never waits.
    """

    def __init__(self) -> None:
        self._pool: ProcessPoolExecutor | None = None
        self._children: set[BaseProcess] = set()
        self._sender: ThreadPoolExecutor | None = None
        self._asked: set[Future[Any]] = set()
        self._called_off = threading.Event()
        self._folder: ScratchFolder | None = None

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Run a function in the process, and return its future.

        Args:
            fn: A function of a module: the other process imports it by its name.
            *args: Its arguments; they are copied, and so is the result.
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
        """Pack a call and pass it to the process; the answer is set in a thread of the pool."""
        try:
            if self._folder is None:
                remove_leftovers()
                self._folder = make_folder("work")
            folder = self._folder.path
            packed = pack(call, folder)
            try:
                sent = self._submit(packed, folder)
            except BrokenExecutor:
                self._end_process(wait=True)
                sent = self._submit(packed, folder)
        except Exception as error:  # noqa: BLE001 - any error is passed on in the answer
            _settle(answer, error=error)
            return
        sent.add_done_callback(partial(_answer, answer))

    def _submit(self, packed: Packed, folder: Path) -> Future[Packed]:
        before = set(multiprocessing.active_children())
        if self._pool is None:
            # a fork would inherit Qt, its threads and every lock they hold
            context = multiprocessing.get_context("spawn")
            self._pool = ProcessPoolExecutor(1, mp_context=context, initializer=_configure_process)
        future = self._pool.submit(call_packed, packed, folder)
        future.add_done_callback(partial(_log_failure, self._called_off))
        begun = set(multiprocessing.active_children()) - before
        # another thread may have started another kind of process just now; its name has the prefix
        self._children |= {child for child in begun if not child.name.startswith(OURS)}
        return future

    def _end_process(self, *, wait: bool) -> None:
        for child in self._children:
            child.kill()
        self._children.clear()
        if self._pool is not None:
            self._pool.shutdown(wait, cancel_futures=True)
            self._pool = None

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = True) -> None:
        """End the process, whatever it is doing."""
        if self._sender is not None:
            self._sender.shutdown(wait=True, cancel_futures=cancel_futures)
            self._sender = None
        self._called_off.set()
        self._end_process(wait=wait)
        self._called_off = threading.Event()  # a later call starts another process
        for answer in tuple(self._asked):
            answer.cancel()
        if self._folder is not None:
            self._folder.remove()
            self._folder = None


@dataclass(slots=True)
class _FileJob:
    """A call for the file thread, with the future that its caller waits for."""

    answer: Future[Any]
    work: Callable[[], Any]

    def do(self) -> None:
        if not self.answer.set_running_or_notify_cancel():
            return
        try:
            _settle(self.answer, self.work())
        except BaseException as error:  # noqa: BLE001 - any error is passed on in the answer
            _settle(self.answer, error=error)


class _Worker(threading.Thread):
    """Carries out jobs from a queue until it is abandoned, or takes the end mark ``None``.

    Attributes:
        since_s: The start of the present job, by `time.monotonic`; ``None`` while idle.
        calling: True while it waits for the helper process.
        left: True if it was abandoned because it hangs.
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
            del job  # or its arguments would stay in memory until the next job
            self.since_s = None


def _taken_from(jobs: SimpleQueue[_FileJob | None]) -> list[_FileJob]:
    """Take the jobs that have not begun out of a queue."""
    found = []
    with contextlib.suppress(Empty):
        while True:
            job = jobs.get_nowait()
            if job is not None:
                found.append(job)
    return found


_END_S: Final = 10.0

_MOST_HANGING: Final = 8
"""The most hanging threads that are abandoned; each keeps its arguments in memory."""


class FileThread(Executor):
    """One thread for work that waits for a disk, with a process for what would take it long.

    A disk or network share that does not answer blocks the thread, and no thread can be ended:
    `replace_hung` abandons it and continues with another. The first one's work may still finish,
    and its result is delivered then. Only a few threads are abandoned; after that everything is
    refused until one of them returns.
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
        """True if, after `shutdown`, all submitted work is done."""
        return self._last is not None and self._last.done() and not self.hanging

    @property
    def hanging(self) -> int:
        """The number of threads that wait for a disk that does not answer."""
        self._left = [each for each in self._left if each.is_alive()]
        return len(self._left)

    @property
    def waiting(self) -> list[str]:
        """The names of the submitted functions that are not done yet."""
        undone = self._undone.copy()
        return [name for answer, name in undone.items() if answer is not self._last]

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Run a function after those submitted before, and return its future.

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
        """Replace the thread if it hangs; to be called once a second.

        Args:
            after_s: The time after which a disk counts as hanging.
            call_s: The time after which a call to the process counts as hanging.

        Returns:
            True if it was found to hang.
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
        # The thread may have come back just now and wait at its old queue: None ends it.
        waiting.put(None)

    def call(self, function: Callable[..., Any], *args: Any) -> Any:
        """Call a function in the process and wait for its result; only from this thread.

        Raises:
            Exception: Any exception of the function.
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
        """End the thread when all submitted work is done, or after ten seconds: a disk may hang."""
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
    """Do nothing: its result shows that all jobs queued before it are done."""


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
    except Exception as problem:  # noqa: BLE001 - any error is passed on in the answer
        _settle(answer, error=problem)


def _settle(
    answer: Future[Any], value: object = None, *, error: BaseException | None = None
) -> None:
    """Set the result of a future, unless it was cancelled."""
    with contextlib.suppress(InvalidStateError):
        if error is None:
            answer.set_result(value)
        else:
            answer.set_exception(error)


def _log_failure(called_off: threading.Event, future: Future[Any]) -> None:
    """Log an error in the process; the caller that asked for the work tells the operator.

    Work that was called off with its process has not failed.
    """
    error = None if future.cancelled() else future.exception()
    if isinstance(error, BrokenExecutor) and called_off.is_set():
        return
    if error is not None:
        trace = "".join(traceback.format_exception(error))
        _LOG.warning("Work in the helper process has failed\n%s", trace)


def _configure_process() -> None:
    """Set up the new process: ignore Ctrl-C, lower its priority, end with the program."""
    end_with_the_program()
    if hasattr(os, "nice"):
        os.nice(_NICER_BY)


def end_with_the_program() -> None:
    """Have a process that this program has started end with it, and not by Ctrl-C before it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_await_the_program, daemon=True).start()


def _await_the_program() -> None:
    program = multiprocessing.parent_process()
    if program is not None:
        program.join()
        os._exit(1)  # sys.exit would only end this thread
