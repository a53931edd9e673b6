"""The render process: it answers one request after another with a picture."""

from __future__ import annotations

import contextlib
import ctypes
import faulthandler
import os
import pickle
import signal
import sys
import threading
import time
import traceback
from contextlib import contextmanager
from dataclasses import replace
from multiprocessing import parent_process
from pathlib import Path
from typing import TYPE_CHECKING, Final

from armui.system.clock import steady_s
from armui.system.files import open_file
from armui.viewport.frame_memory import FrameMemory
from armui.viewport.messages import (
    DRAWING_STOPPED,
    Drawn,
    Failed,
    JointPicked,
    LoadFailed,
    MarkPicked,
    PictureBusy,
    PicturePhase,
    Ready,
    RobotRead,
    RobotShown,
    SceneError,
)
from armui.viewport.process.frame_painter import FramePainter
from armui.viewport.process.robot import shape_of

if TYPE_CHECKING:
    from collections.abc import Iterator
    from multiprocessing.connection import Connection

    from armui.viewport.messages import Answer, Draw
    from armui.viewport.path_picture import PathPicture


_NICER_BY: Final = 5
"""The nice value's increase, so that window, bus and stop come first if there are too few cores."""

_FIRST_TO_GO: Final = b"800"
_PR_SET_PDEATHSIG: Final = 1
_BEAT_S: Final = 0.2
_MOST_KEPT_BYTES: Final = 64_000_000


def configure_process() -> None:
    """Set up the process: ignore Ctrl-C, end with the program, report the place of a crash."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if sys.stderr is not None:
        faulthandler.enable()
    if sys.platform == "linux":
        # when memory runs out, Linux shall end this process and not the program with the window
        adjusted = Path("/proc/self/oom_score_adj")
        with contextlib.suppress(OSError), open_file(adjusted, "r+b") as file:
            file.write(_FIRST_TO_GO)
        # the kernel ends this process with the program, even if a driver holds Python's lock and
        # the thread below never runs
        with contextlib.suppress(OSError):
            ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    threading.Thread(target=_end_with_the_program, daemon=True).start()


def lower_priority() -> None:
    """Lower the priority once the first picture is drawn, which is waited for.

    Linux has a priority for each thread, and the driver's own threads, which do most of the drawing
    in software, are not threads of Python.
    """
    if sys.platform == "linux":
        for thread in Path("/proc/self/task").iterdir():
            with contextlib.suppress(OSError):  # the thread has just ended
                if os.getpriority(os.PRIO_PROCESS, int(thread.name)) < _NICER_BY:
                    os.setpriority(os.PRIO_PROCESS, int(thread.name), _NICER_BY)
    elif hasattr(os, "nice"):
        os.nice(_NICER_BY)


def _end_with_the_program() -> None:
    program = parent_process()
    if program is not None:
        program.join()
        os._exit(1)  # sys.exit would only end this thread


class Heartbeat:
    """Sends messages for two threads: the one that draws, and its own, which sends signs of life.

    Args:
        connection: The pipe to the program.
    """

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        # two threads send through one pipe, and their messages must not mix
        self._sending = threading.Lock()
        self._awake = threading.Event()
        self._phase: PicturePhase | None = None
        self._cpu_began_s = 0.0
        self._late_s = 0.0
        self._thread = threading.Thread(target=self._beat, name="heartbeat", daemon=True)
        self._thread.start()

    def send(self, message: Answer) -> None:
        """Send a message to the program.

        Raises:
            OSError: it has ended.
        """
        with self._sending:
            self._connection.send(message)

    @contextmanager
    def beating(self, phase: PicturePhase) -> Iterator[None]:
        """Send signs of life within a ``with`` block."""
        self._cpu_began_s = time.process_time()
        self._phase = phase
        self._awake.set()
        try:
            yield
        finally:
            self._phase = None

    def enter(self, phase: PicturePhase) -> None:
        """Change the phase, which has other time limits in the program."""
        self._cpu_began_s = time.process_time()
        self._phase = phase
        self._send_phase(phase)

    def _beat(self) -> None:
        pause = threading.Event()
        while True:
            self._awake.wait()
            self._awake.clear()
            due_s = steady_s() + _BEAT_S
            pause.wait(_BEAT_S)
            self._late_s = steady_s() - due_s
            phase = self._phase
            # no request is being worked on: wait until the next one wakes this thread
            if phase is None:
                continue
            self._awake.set()
            try:
                self._send_phase(phase)
            except OSError:
                return  # the program has ended; the drawing thread finds out by itself

    def _send_phase(self, phase: PicturePhase) -> None:
        self.send(PictureBusy(phase, time.process_time() - self._cpu_began_s, self._late_s))


def run(connection: Connection) -> None:
    """Draw for the program at the other end of the pipe, until one of the two ends."""
    configure_process()
    heart = Heartbeat(connection)
    try:
        _Drawing(heart).serve(connection)
    except SceneError as error:
        heart.send(Failed(error.refusal))
    except (EOFError, ConnectionError):
        pass  # the program has ended
    except Exception as error:  # noqa: BLE001 - the program says it, and starts another process
        text = f"{type(error).__name__}: {error}"
        with contextlib.suppress(OSError):
            heart.send(Failed(DRAWING_STOPPED(text=text), traceback.format_exc()))
    # Drivers that are asked to clean up may crash or hang; the system does it all.
    os._exit(0)


class _Drawing:
    """Draws on request, and keeps the memory and the path, which are sent only once."""

    def __init__(self, heart: Heartbeat) -> None:
        self._heart = heart
        self._memory: FrameMemory | None = None
        self._path: PathPicture | None = None
        self._painter = FramePainter(
            on_load_failed=lambda reason: self._send(LoadFailed(reason)),
            on_picked=lambda number: self._send(JointPicked(number)),
            on_mark_picked=lambda row: self._send(MarkPicked(row)),
            on_phase=heart.enter,
        )

    def serve(self, connection: Connection) -> None:
        with self._heart.beating(PicturePhase.STARTING):
            self._painter.open()
        self._send(Ready())
        priority_lowered = False
        while True:
            request: Draw = connection.recv()
            with self._heart.beating(PicturePhase.DRAWING):
                answer = self._answer(request)
            self._send(answer)
            if not priority_lowered:
                priority_lowered = True
                lower_priority()

    def _send(self, answer: Answer) -> None:
        self._heart.send(answer)

    def _answer(self, request: Draw) -> Drawn:
        began_s = time.monotonic()
        if request.memory is not None:
            # a name is sent only with new memory, which the program makes for another size
            self._memory = FrameMemory.attach(request.memory)
        painter = self._painter
        if request.state is None:
            pixels = painter.refine()
        else:
            if not request.keeps_path:
                self._path = request.path
            preview = replace(request.state.preview, path=self._path)
            before = painter.robot
            known = None if request.robot is None else pickle.loads(request.robot)  # noqa: S301 - our own
            pixels = painter.paint(replace(request.state, preview=preview), known)
            if painter.robot is not before and painter.robot is not known:
                content = pickle.dumps(painter.robot)
                if len(content) < _MOST_KEPT_BYTES:  # in the memory of the window's process
                    self._send(RobotRead(content))
            if painter.robot is not before and painter.robot is not None:
                self._send(RobotShown(shape_of(painter.robot)))
        size_px = None
        if pixels is not None and self._memory is not None:
            target = self._memory.slot(request.slot, pixels.nbytes)
            size_px = pixels.copy_to(target)
            # shared memory cannot be closed while a view of it exists
            target.release()
        return Drawn(
            request.sequence,
            size_px,
            painter.pixel_ratio,
            painter.is_rough,
            began_s,
            time.monotonic(),
        )
