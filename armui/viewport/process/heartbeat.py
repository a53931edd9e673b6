"""Tells the program that this process lives, while a request takes long."""

from __future__ import annotations

import threading
import time
from contextlib import contextmanager
from typing import TYPE_CHECKING, Final

from armui.viewport.messages import PictureBusy, PicturePhase

if TYPE_CHECKING:
    from collections.abc import Iterator
    from multiprocessing.connection import Connection

    from armui.viewport.messages import Answer

_BEAT_S: Final = 0.2


class Heartbeat:
    """Sends for two threads: the one that draws, and its own, which sleeps while nothing is drawn.

    Args:
        connection: The pipe to the program.
    """

    def __init__(self, connection: Connection) -> None:
        self._connection = connection
        self._sending = threading.Lock()
        self._awake = threading.Event()
        self._phase: PicturePhase | None = None
        self._cpu_began_s = 0.0
        self._late_s = 0.0
        self._thread = threading.Thread(target=self._beat, name="heartbeat", daemon=True)
        self._thread.start()

    @property
    def thread_id(self) -> int | None:
        """Its own thread, as the system numbers it."""
        return self._thread.native_id

    def send(self, message: Answer) -> None:
        """Tell the program something.

        Raises:
            OSError: it has ended.
        """
        with self._sending:
            self._connection.send(message)

    @contextmanager
    def beating(self, phase: PicturePhase) -> Iterator[None]:
        """Give signs of life while something is done."""
        self._cpu_began_s = time.process_time()
        self._phase = phase
        self._awake.set()
        try:
            yield
        finally:
            self._phase = None

    def enter(self, phase: PicturePhase) -> None:
        """Something else is done from now on: the program has other limits for it."""
        self._cpu_began_s = time.process_time()
        self._phase = phase
        self._tell(phase)

    def _beat(self) -> None:
        pause = threading.Event()
        while True:
            self._awake.wait()
            self._awake.clear()
            due_s = time.monotonic() + _BEAT_S
            pause.wait(_BEAT_S)
            self._late_s = time.monotonic() - due_s
            phase = self._phase
            if phase is None:
                continue
            self._awake.set()
            try:
                self._tell(phase)
            except OSError:
                return  # the program has ended; the thread that draws finds out

    def _tell(self, phase: PicturePhase) -> None:
        self.send(PictureBusy(phase, time.process_time() - self._cpu_began_s, self._late_s))
