"""The link to the render process, which is started again when it is lost.

A thread of the program sends one request after another and waits for each answer. It shares nothing
with the drawing process: if that crashes, hangs or is killed, only pictures are lost. No Qt here.
The thread itself imports the modules that start processes, so that no window waits.
"""

from __future__ import annotations

import contextlib
import importlib
import logging
import multiprocessing
import pickle
import signal
import threading
import time
from dataclasses import dataclass, replace
from multiprocessing.connection import wait
from typing import TYPE_CHECKING, Any, Final, Generic, TypeVar

from armui.arm.refusal import Reason, Refusal
from armui.viewport.frame_memory import SLOTS, FrameMemory
from armui.viewport.messages import (
    BYTES_PER_PIXEL,
    DRAWING_STOPPED,
    NO_OPENGL,
    PICTURE_PROCESS_ENDED,
    PICTURE_PROCESS_HUNG,
    Draw,
    Drawn,
    Failed,
    LoadFailed,
    PictureBusy,
    PicturePhase,
    Ready,
    RobotRead,
)
from armui.viewport.view_state import BUILT_IN_ROBOT, RobotChoice
from armui.viewport.watch import LIMITS, Restarts, is_stuck

if TYPE_CHECKING:
    from collections.abc import Callable
    from multiprocessing.connection import Connection

    from armui.viewport.messages import Answer
    from armui.viewport.path_picture import PathPicture
    from armui.viewport.view_state import PickRequest, ViewState

URDF_HANGS_VIEW = Reason(
    "urdf_hangs_view",
    "Robot description: loading {path} does not come to an end. It is put aside; choose "
    "another one.",
)
URDF_ENDS_VIEW = Reason(
    "urdf_ends_view",
    "Robot description: {path} ended the 3D view while it was loaded ({text}). It is put "
    "aside; choose another one.",
)

_LOG = logging.getLogger(__name__)

A = TypeVar("A", Ready, Drawn)
T = TypeVar("T")

ENTRY: Final = "armui.viewport.process.main:run"
"""The module and function that the process runs, by name, so that the program does not load it."""
_END_LIMIT_S: Final = 1.0
_SMALL_BYTES: Final = 8_000
"""A shorter message fits into the pipe, which holds 8,192 bytes on Windows and far more elsewhere,
so that sending it never blocks.
"""
_TAKEN_LIMIT_S: Final = 5.0
MOST_UNUSED: Final = 1
"""The most results that may be unused when the next item is taken."""
_REST_S: Final = 0.15
"""The picture is at rest when nothing has changed for this long."""
_JOIN_LIMIT_S: Final = 3.0
_WITH_A_NEW_ROBOT: Final = frozenset({PicturePhase.LOADING, PicturePhase.FIRST_DRAWING})


@dataclass(frozen=True, slots=True)
class RenderRequest:
    """A state to draw, and its number."""

    sequence: int
    state: ViewState


@dataclass(frozen=True, slots=True)
class PictureFrame:
    """A finished image.

    Attributes:
        number: The frame's number, for `ProcessLink.frame_used`.
        memory, slot, size_px: The memory, the image's number in it, and its size.
        drawn: The answer of the process for it.
    """

    number: int
    memory: FrameMemory
    slot: int
    size_px: tuple[int, int]
    drawn: Drawn


@dataclass(frozen=True, slots=True)
class Lost:
    """The process is gone; unless it comes back by itself, no pictures follow."""

    refusal: Refusal
    comes_back: bool


def run_entry(entry: str, connection: Connection) -> None:
    """Import the function in the new process and call it with the pipe."""
    module, _, function = entry.partition(":")
    getattr(importlib.import_module(module), function)(connection)


class ChildProcess:
    """One process, from start to end; used by one thread, except for `kill`.

    Args:
        entry: See `ENTRY`.
        on_end: Called in another thread when the process has ended by itself or was killed.

    Raises:
        OSError: the process cannot be started.
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
        """Send a request.

        Raises:
            OSError: the process has ended, or does not read any more and was killed therefore.
        """
        content = pickle.dumps(message)
        if len(content) < _SMALL_BYTES:
            self._connection.send_bytes(content)
            return
        # a hanging process does not empty the pipe: sending a large message would block for ever
        limit = threading.Timer(_TAKEN_LIMIT_S, self.kill)
        limit.daemon = True
        limit.start()
        try:
            self._connection.send_bytes(content)
        finally:
            limit.cancel()

    def receive(self, limit_s: float) -> Answer | None:
        """Return the next message, or None if none came within the limit.

        Raises:
            EOFError, OSError: the process has ended.
        """
        if not self._connection.poll(limit_s):
            return None
        message: Answer = self._connection.recv()
        return message

    def kill(self) -> None:
        """Kill the process; may be called from any thread, and twice."""
        with contextlib.suppress(OSError, ValueError):
            self._process.kill()

    def end(self) -> str:
        """End the process, wait for it up to a limit, and free everything.

        Returns:
            The name of the signal that ended it, or its exit code.
        """
        # wait first: a process that is ending tells by its exit code why
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
    # on POSIX a negative code is the number of the signal that ended the process
    if exit_code < 0:
        with contextlib.suppress(ValueError):
            return signal.Signals(-exit_code).name
    # Windows reports a crash as a large code that is known by its hexadecimal form
    return f"0x{exit_code & 0xFFFFFFFF:X}" if exit_code > 255 else str(exit_code)


class ProcessLostError(Exception):
    """The process cannot be used any more."""

    def __init__(self, refusal: Refusal) -> None:
        self.refusal = refusal
        super().__init__(str(refusal))


class Mailbox(Generic[T]):
    """Holds only the newest item.

    Items may lead to results that the receiver uses. While more than `MOST_UNUSED` of them are
    unused no item is taken; items put in meanwhile replace each other. So a slow receiver slows the
    reader down instead of filling a queue.
    """

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._item: T | None = None
        self._results = 0
        self._used = 0
        self._is_interrupted = False
        self._is_closed = False

    def put(self, item: T) -> None:
        """Put in an item, replacing a waiting one."""
        with self._changed:
            self._item = item
            self._changed.notify_all()

    @property
    def is_closed(self) -> bool:
        """True if `close` was called."""
        with self._changed:
            return self._is_closed

    def take(self, timeout_s: float | None = None) -> T | None:
        """Wait until results were used, then until there is an item.

        Args:
            timeout_s: the longest wait for an item; by default without limit.

        Returns:
            The item; None if the box is closed, the reader interrupted, or the time over.
        """
        with self._changed:
            # first let the receiver catch up; only then take an item, which is the newest by that
            # time
            self._changed.wait_for(lambda: self._is_woken or self._has_room)
            self._changed.wait_for(lambda: self._is_woken or self._item is not None, timeout_s)
            return None if self._is_woken else self._pop()

    def take_at_once(self) -> T | None:
        """Return the item if there is one, else None; never wait."""
        with self._changed:
            return self._pop()

    def result_sent(self) -> int:
        """Count a result that the reader has sent, and return its number, from 1."""
        with self._changed:
            self._results += 1
            return self._results

    def acknowledge(self, number: int) -> None:
        """Note that the receiver has used this result, and needs none before it."""
        with self._changed:
            self._used = max(self._used, number)
            self._changed.notify_all()

    def reset_results(self) -> None:
        """Count all results so far as used."""
        with self._changed:
            self._used = self._results

    def interrupt(self) -> None:
        """Wake the reader, and keep it from waiting until `resume`."""
        with self._changed:
            self._is_interrupted = True
            self._changed.notify_all()

    def resume(self) -> None:
        """Let the reader wait again."""
        with self._changed:
            self._is_interrupted = False

    def close(self) -> None:
        """Wake the reader for the last time."""
        with self._changed:
            self._is_closed = True
            self._changed.notify_all()

    @property
    def _is_woken(self) -> bool:
        return self._is_closed or self._is_interrupted

    @property
    def _has_room(self) -> bool:
        return self._results - self._used <= MOST_UNUSED

    def _pop(self) -> T | None:
        item, self._item = self._item, None
        return item


class RenderSession:
    """The requests to one render process, and its answers.

    Attributes:
        is_new: True if nothing was drawn in it yet.
        is_rough: True if the last image needs smooth edges.
        phase: The last known phase of the process.
        robot: The robot it was last asked to show.
        proven_robot: The robot in the last picture.
        failed_robot: The last robot that could not be shown; the one before stays in the picture.
        asked_serial: The newest pick request that was sent; none is sent twice.
    """

    def __init__(
        self,
        child: ChildProcess,
        mailbox: Mailbox[RenderRequest],
        on_message: Callable[[object], None],
        asked_serial: int,
        robots: dict[RobotChoice, bytes],
    ) -> None:
        self._robots = robots
        self._child = child
        self._mailbox = mailbox
        self._on_message = on_message
        self._memory: FrameMemory | None = None
        self._path: PathPicture | None = None
        self._slot = 0
        self._sequence = 0
        self._image_bytes = 0
        self._answered_serial = asked_serial
        self.asked_serial = asked_serial
        self.is_new = True
        self.is_rough = False
        self.phase = PicturePhase.STARTING
        self.robot: RobotChoice | None = None
        self.proven_robot: RobotChoice | None = None
        self.failed_robot: RobotChoice | None = None

    def begin(self) -> None:
        """Wait until the process accepts requests; raises the same errors as `render`."""
        self._await(Ready)

    def render(self, request: RenderRequest | None) -> None:
        """Have a state drawn, or without one the last state again with smooth edges.

        Raises:
            ProcessLostError: the process hangs, or says that it can't go on.
            OSError, EOFError: it has ended.
        """
        self._send(request)
        drawn = self._await(Drawn)
        self.phase = PicturePhase.DRAWING
        self.is_new = False
        self.is_rough = drawn.is_rough
        if self.robot != self.failed_robot:
            self.proven_robot = self.robot
        memory = self._memory
        if memory is None:
            return
        # the answer proves that the process has opened the memory: its name is no longer needed
        memory.unlink_name()
        if drawn.size_px is None:
            self._on_message(drawn)  # the last image shows this state as well
            return
        number = self._mailbox.result_sent()
        self._on_message(PictureFrame(number, memory, self._slot, drawn.size_px, drawn))
        self._slot = (self._slot + 1) % SLOTS

    def check(self) -> None:
        """Check that an idle process still runs.

        Raises:
            EOFError, OSError: it has ended.
        """
        self._child.receive(0.0)

    def close(self) -> None:
        """Remove the name of the shared memory."""
        if self._memory is not None:
            self._memory.unlink_name()

    def _send(self, request: RenderRequest | None) -> None:
        if request is None:
            self._child.send(Draw(self._sequence, None, self._slot))
            return
        self._sequence = request.sequence
        state = self._unasked(request.state)
        self.robot = state.robot
        self._image_bytes = state.width_px * state.height_px * BYTES_PER_PIXEL
        memory = self._memory
        if memory is None or not memory.suits(self._image_bytes):
            try:
                memory = FrameMemory.create(self._image_bytes)
            except OSError as error:
                raise ProcessLostError(PICTURE_PROCESS_ENDED(text=str(error))) from error
        path = state.preview.path
        # a path can be large: it is sent once, and the process keeps it
        is_new_path = path is not None and path is not self._path
        message = Draw(
            request.sequence,
            replace(state, preview=replace(state.preview, path=None)),
            self._slot,
            memory=None if memory is self._memory else memory.name,
            path=path if is_new_path else None,
            keeps_path=path is not None and not is_new_path,
            robot=self._robots.get(state.robot) if self.is_new else None,
        )
        self._memory, self._path = memory, path
        self._child.send(message)

    def _keep(self, content: bytes) -> None:
        """Keep the robot that was read, and no other, for the next process."""
        self._robots.clear()
        if self.robot is not None:
            # if the wanted robot fails at the start, the process reads the built-in one in its
            # place
            read = BUILT_IN_ROBOT if self.robot == self.failed_robot else self.robot
            self._robots[read] = content

    def _unasked(self, state: ViewState) -> ViewState:
        """Return the state without questions that an earlier process was asked."""

        def fresh(question: PickRequest | None) -> PickRequest | None:
            if question is None or question.serial <= self._answered_serial:
                return None
            self.asked_serial = max(self.asked_serial, question.serial)
            return question

        return replace(state, pick=fresh(state.pick), mark_pick=fresh(state.mark_pick))

    def _await(self, kind: type[A]) -> A:
        """Return the next answer of a kind; handle the messages before it.

        Raises:
            ProcessLostError: the process is silent, makes no progress, or says that it can't go on.
            OSError, EOFError: it has ended.
        """
        since_s = time.monotonic()
        while True:
            message = self._child.receive(LIMITS[self.phase].silent_s)
            if message is None:
                raise ProcessLostError(PICTURE_PROCESS_HUNG())
            if isinstance(message, kind):
                return message
            if isinstance(message, PictureBusy):
                since_s = self._check_progress(message, since_s)
            else:
                self._handle(message)

    def _check_progress(self, busy: PictureBusy, since_s: float) -> float:
        """Note the phase of a process that works, and return when that phase began.

        Args:
            busy: Its sign of life.
            since_s: When the phase before began, or the wait, by the monotonic clock.

        Raises:
            ProcessLostError: it has been in this phase for too long.
        """
        if busy.phase is not self.phase:
            # each phase has limits of its own: loading meshes may take longer than drawing
            self.phase, since_s = busy.phase, time.monotonic()
        if is_stuck(busy, time.monotonic() - since_s):
            raise ProcessLostError(PICTURE_PROCESS_HUNG())
        return since_s

    def _handle(self, message: Answer) -> None:
        """Keep the robot that was read, or report a failure; pass other messages on.

        Raises:
            ProcessLostError: the process says that it can't go on.
        """
        if isinstance(message, RobotRead):
            self._keep(message.content)
            return
        if isinstance(message, Failed):
            _LOG.error("The 3D view stopped\n%s", message.traceback)
            raise ProcessLostError(message.refusal)
        if isinstance(message, LoadFailed):
            self.failed_robot = self.robot
        self._on_message(message)


class ProcessLink:
    """Draws states in a process of its own, the latest one first.

    Args:
        on_message: Called with messages, in the link's thread.
        entry: The function that the process runs.
    """

    def __init__(self, on_message: Callable[[object], None], entry: str = ENTRY) -> None:
        self._on_message = on_message
        self._entry = entry
        self._mailbox: Mailbox[RenderRequest] = Mailbox()
        self._lock = threading.Lock()
        self._child: ChildProcess | None = None
        self._restarts = Restarts()
        self._last: RenderRequest | None = None
        self._proven: RobotChoice = BUILT_IN_ROBOT
        self._put_aside: RobotChoice | None = None
        self._asked_serial = 0
        self._robot_read: dict[RobotChoice, bytes] = {}
        self._thread = threading.Thread(target=self._run, name="armui-viewport", daemon=True)

    @property
    def pid(self) -> int | None:
        """The number of the process, while there is one."""
        with self._lock:
            return None if self._child is None else self._child.pid

    def start(self) -> None:
        """Start the thread; to be called once."""
        self._thread.start()

    def show(self, request: RenderRequest) -> None:
        """Request a picture; it replaces a state that was not drawn yet."""
        self._mailbox.put(request)

    def frame_used(self, number: int) -> None:
        """Report that this frame is on the screen, so that another may be drawn."""
        self._mailbox.acknowledge(number)

    def stop(self) -> None:
        """End the process and the thread; may be called twice."""
        # closed before the process is killed, so that the thread takes its end for intended
        self._mailbox.close()
        with self._lock:
            if self._child is not None:
                self._child.kill()
        if self._thread.is_alive():
            self._thread.join(_JOIN_LIMIT_S)

    # In the link's thread ---------------------------------------------------------------------

    def _run(self) -> None:
        while True:
            try:
                reason = self._draw_in_one_process()
            except Exception as error:  # noqa: BLE001 - the view must learn of it, and try again
                _LOG.exception("The link to the 3D view's process failed")
                reason = DRAWING_STOPPED(text=f"{type(error).__name__}: {error}")
            if self._mailbox.is_closed:
                return
            _LOG.warning("The 3D view's process is lost: %s", reason or "a robot was put aside")
            # without OpenGL another process would fail in the same way
            comes_back = reason is None or (
                reason.reason != NO_OPENGL and self._restarts.lost(time.monotonic())
            )
            if reason is not None:
                self._on_message(Lost(reason, comes_back))
            if not comes_back:
                return

    def _draw_in_one_process(self) -> Refusal | None:
        """Draw until the process is lost; return why, or ``None`` if a robot caused it."""
        self._mailbox.resume()
        self._mailbox.reset_results()
        try:
            child = ChildProcess(self._entry, self._mailbox.interrupt)
        except OSError as error:
            return PICTURE_PROCESS_ENDED(text=str(error))
        with self._lock:
            self._child = child
            if self._mailbox.is_closed:  # `stop` was called while the process was started
                child.kill()
        session = RenderSession(
            child, self._mailbox, self._on_message, self._asked_serial, self._robot_read
        )
        reason: Refusal | None = None
        try:
            session.begin()
            while not self._mailbox.is_closed:
                self._draw_one(session)
        except ProcessLostError as error:
            reason = error.refusal
            child.kill()
        except (OSError, EOFError):
            reason = None
        finally:
            with self._lock:
                self._child = None
            how = child.end()
            session.close()
        self._asked_serial = session.asked_serial
        # the next process has no earlier robot to show in place of one that fails: put it aside
        self._put_aside = session.failed_robot or self._put_aside
        reason = reason or PICTURE_PROCESS_ENDED(text=how)
        return None if self._blames_robot(session, reason) else reason

    def _draw_one(self, session: RenderSession) -> None:
        request = self._mailbox.take_at_once() if session.is_new else None
        if request is None and session.is_new:
            request = self._last
        if request is None:
            request = self._mailbox.take(_REST_S if session.is_rough else None)
            if request is None and (self._mailbox.is_closed or not session.is_rough):
                session.check()
                return
        if request is not None:
            self._last = request
            request = RenderRequest(request.sequence, self._without_bad_robot(request.state))
        session.render(request)
        if session.proven_robot is not None:
            self._proven = session.proven_robot

    def _without_bad_robot(self, state: ViewState) -> ViewState:
        bad = state.robot == self._put_aside
        return replace(state, robot=self._proven) if bad else state

    def _blames_robot(self, session: RenderSession, reason: Refusal) -> bool:
        """Put a robot aside if the process was lost while loading or first drawing it."""
        suspect = session.robot
        if (
            suspect is None
            or suspect == self._proven
            or suspect.path == BUILT_IN_ROBOT.path
            or session.phase not in _WITH_A_NEW_ROBOT
        ):
            return False
        self._put_aside = suspect
        hung = reason.reason == PICTURE_PROCESS_HUNG
        params: dict[str, float | int | str] = {"path": str(suspect.path)}
        if not hung:
            params["text"] = str(reason.params.get("text", ""))
        self._on_message(LoadFailed(Refusal(URDF_HANGS_VIEW if hung else URDF_ENDS_VIEW, params)))
        return True
