"""How far a command has come, in one line of the terminal."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Final, TextIO

_WIDTH: Final = 30
_EVERY_S: Final = 0.1


class ProgressBar:
    """Draws over itself; on anything but a terminal it draws nothing.

    Args:
        stream: Where to, commonly the error output.
        clock: Monotonic time in seconds.
    """

    def __init__(self, stream: TextIO, clock: Callable[[], float] = time.monotonic) -> None:
        self._stream = stream
        self._clock = clock
        self._shown = 0
        self._began_s = clock()
        self._drawn_s = -math.inf
        self._wanted = stream.isatty()

    def show(self, done: float | None, words: str) -> None:
        """Draw it anew, unless it has just been drawn.

        Args:
            done: 0 to 1; ``None`` where nobody knows.
            words: Behind it.
        """
        now_s = self._clock()
        if not self._wanted or now_s - self._drawn_s < _EVERY_S:
            return
        self._drawn_s = now_s
        line = words
        if done is not None:
            full = round(done * _WIDTH)
            line = f"[{'#' * full}{'.' * (_WIDTH - full)}] {done:4.0%}  {words}"
            if done > 0:
                left_s = (now_s - self._began_s) * (1.0 - done) / done
                line += f"  {left_s:.0f} s left"
        self._stream.write("\r" + line.ljust(self._shown))
        self._stream.flush()
        self._shown = len(line)

    def clear(self) -> None:
        """Leave the line as if nothing had been drawn."""
        if self._shown:
            self._stream.write("\r" + " " * self._shown + "\r")
            self._stream.flush()
            self._shown = 0
