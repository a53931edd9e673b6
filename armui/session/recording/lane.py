"""The way of frames from the thread that owns the bus to the one that keeps them: pure.

The bus thread hands over a whole batch by putting a list into a queue; it never waits, and whoever
takes the batches out never holds it up.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from armui.telemetry.listener import Listener

if TYPE_CHECKING:
    from armui.session.recording.rows import RecordedFrame

MOST_WAITING: Final = 65_536
"""Frames that may wait; a bus that is full has some 8,000 a second."""


class FrameLane(Listener):
    """Takes frames as they are, whoever sent them and however they are decoded.

    Args:
        most: Frames that may wait; a batch beyond them is dropped whole, and counted.

    Attributes:
        dropped: Frames that nobody took out in time, since the beginning.
    """

    def __init__(self, most: int = MOST_WAITING) -> None:
        self._most = most
        self._batches: deque[Sequence[RecordedFrame]] = deque()
        self._put = self._taken = 0  # each is written by one thread only
        self.dropped = 0

    @property
    def waiting(self) -> int:
        """Frames that wait to be taken out."""
        return self._put - self._taken

    def take_frames(self) -> list[RecordedFrame]:
        """Return all frames that wait, in the order they came; they wait no longer."""
        frames: list[RecordedFrame] = []
        batches = self._batches
        while batches:
            frames += batches.popleft()
        self._taken += len(frames)
        return frames

    # The bus thread ---------------------------------------------------------------------------

    def on_heard(self, batch: Sequence[RecordedFrame]) -> None:
        """Frames that others sent."""
        if self._put - self._taken + len(batch) > self._most:
            self.dropped += len(batch)
            return
        self._put += len(batch)
        self._batches.append(batch)

    def on_sent(self, batch: Sequence[RecordedFrame]) -> None:
        """Frames that this program sent; their flags say so."""
        self.on_heard(batch)
