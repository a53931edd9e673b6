"""The queue of frames from the thread that owns the bus to the one that keeps them: pure.

The bus thread puts a whole batch into the queue as a list; it never waits, and the thread that
takes the batches never holds it up.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from armui.telemetry.listener import Listener

if TYPE_CHECKING:
    from armui.session.recording.rows import RecordedFrame

MOST_WAITING: Final = 65_536
"""The most waiting frames; a full bus has some 8,000 a second."""


class FrameLane(Listener):
    """Receives all frames, from whichever sender and however decoded.

    Args:
        most: The most waiting frames; a batch beyond them is dropped whole, and counted.

    Attributes:
        dropped: The number of frames dropped since the beginning.
    """

    def __init__(self, most: int = MOST_WAITING) -> None:
        self._most = most
        self._batches: deque[Sequence[RecordedFrame]] = deque()
        self._put = self._taken = 0  # without a lock: each is written by one thread only
        self.dropped = 0

    @property
    def waiting(self) -> int:
        """The number of frames that wait to be taken."""
        return self._put - self._taken

    def take_frames(self) -> list[RecordedFrame]:
        """Return all waiting frames in the order they came, and remove them."""
        frames: list[RecordedFrame] = []
        batches = self._batches
        while batches:
            frames += batches.popleft()
        self._taken += len(frames)
        return frames

    # The bus thread ---------------------------------------------------------------------------

    def on_heard(self, batch: Sequence[RecordedFrame]) -> None:
        """Add frames that others sent."""
        if self._put - self._taken + len(batch) > self._most:
            self.dropped += len(batch)
            return
        self._put += len(batch)
        self._batches.append(batch)

    def on_sent(self, batch: Sequence[RecordedFrame]) -> None:
        """Add frames that this program sent; their flags tell so."""
        self.on_heard(batch)
