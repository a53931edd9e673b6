"""Who else is told of every frame on the bus, in batches, by the thread that owns it."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final, Protocol

from armui.protocol.codec import Codec, InvalidFrame, Message

if TYPE_CHECKING:
    from armui.protocol.frame import Frame
    from armui.protocol.generation import Generation

_LOG: Final = logging.getLogger(__name__)

Taken = tuple[Message | InvalidFrame, float, int]
"""A frame as decoded, its monotonic time in seconds, and the length of its payload."""

SENT_KEPT: Final = 4096
"""So many frames that were sent may wait for the bus thread, which looks every few milliseconds."""


class Tap(Protocol):
    """Hears everything. All but `know_generation` is called by the bus thread."""

    def know_generation(self, generation: Generation | None) -> None:
        """Which protocol the arm was found to speak; ``None``: not known, or not any more."""

    def on_open(self, bitrate: int | None) -> None:
        """A device was opened."""

    def on_codec(self, codec: Codec) -> None:
        """How frames are decoded from now on."""

    def on_heard(self, batch: Sequence[Taken]) -> None:
        """Frames that others sent."""

    def on_sent(self, batch: Sequence[Taken]) -> None:
        """Frames that this program sent."""

    def on_error_frame(self) -> None:
        """The adapter has reported an error on the bus."""

    def on_look(self, now_s: float) -> None:
        """Called every few milliseconds."""


class NoTap:
    """Nobody else."""

    def know_generation(self, generation: Generation | None) -> None:
        """Nobody listens."""

    def on_open(self, bitrate: int | None) -> None:
        """Nobody listens."""

    def on_codec(self, codec: Codec) -> None:
        """Nobody listens."""

    def on_heard(self, batch: Sequence[Taken]) -> None:
        """Nobody listens."""

    def on_sent(self, batch: Sequence[Taken]) -> None:
        """Nobody listens."""

    def on_error_frame(self) -> None:
        """Nobody listens."""

    def on_look(self, now_s: float) -> None:
        """Nobody listens."""


class TapLine:
    """Collects what a tap is told, on the bus thread's side.

    A tap that fails is told no more: receiving goes on.

    Attributes:
        sent: Frames as they went out and when, put in by the threads that send.
        heard: Frames as they came in.
    """

    def __init__(self, tap: Tap) -> None:
        self._tap = tap
        self.heard: list[Taken] = []
        self.sent: deque[tuple[Frame, float]] = deque(maxlen=SENT_KEPT)

    def open(self, codec: Codec, bitrate: int | None) -> None:
        """A device was opened, and is spoken to in this way."""
        try:
            self._tap.on_open(bitrate)
            self._tap.on_codec(codec)
        except Exception:  # noqa: BLE001 - whatever it is: receiving goes on
            self._give_up()

    def flush(self, codec: Codec, now_s: float) -> None:
        """Tell what has come together; it was decoded by this codec."""
        try:
            if self.heard:
                self._tap.on_heard(self.heard)
            if self.sent:
                self._tap.on_sent(self._decoded(codec))
            self._tap.on_look(now_s)
        except Exception:  # noqa: BLE001 - whatever it is: receiving goes on
            self._give_up()
        self.heard = []

    def switch(self, before: Codec, codec: Codec, now_s: float) -> None:
        """From now on frames are decoded by another codec."""
        self.flush(before, now_s)
        try:
            self._tap.on_codec(codec)
        except Exception:  # noqa: BLE001 - whatever it is: receiving goes on
            self._give_up()

    def error_frame(self) -> None:
        """The adapter has reported an error on the bus."""
        try:
            self._tap.on_error_frame()
        except Exception:  # noqa: BLE001 - whatever it is: receiving goes on
            self._give_up()

    def _decoded(self, codec: Codec) -> list[Taken]:
        batch = []
        while self.sent:
            frame, at_s = self.sent.popleft()
            batch.append((codec.decode(frame), at_s, len(frame.data)))
        return batch

    def _give_up(self) -> None:
        _LOG.exception("What watches the bus has failed; it is told no more until reconnecting")
        self._tap = NoTap()
