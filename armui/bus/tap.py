"""Who else is told of every frame on the bus, on the side of the thread that owns it."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from armui.protocol.frame import FrameFlag

if TYPE_CHECKING:
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame
    from armui.telemetry.tap import Taken, Tap

_LOG: Final = logging.getLogger(__name__)

SENT_KEPT: Final = 4096
"""So many frames that were sent may wait for the bus thread, which looks every few milliseconds."""


class TapLine:
    """Collects what taps are told, on the bus thread's side.

    A tap that fails is told no more until the device is opened again: receiving goes on, and the
    other taps hear as before.

    Args:
        taps: Who listens from the beginning.

    Attributes:
        sent: Frames as they went out and when, put in by the threads that send.
        heard: Frames as they came in.
    """

    def __init__(self, taps: Sequence[Tap] = ()) -> None:
        self._wanted: tuple[Tap, ...] = tuple(taps)
        self._followed: tuple[Tap, ...] = ()
        self._told: list[Tap] = []
        self._failed: list[Tap] = []
        self._opened: tuple[Codec, int | None] | None = None
        self.heard: list[Taken] = []
        self.sent: deque[tuple[Frame, float]] = deque(maxlen=SENT_KEPT)

    def want(self, taps: Sequence[Tap]) -> None:
        """Who listens from now on; called by any thread, followed at the next flush.

        One that comes while a device is open is told first that it was opened, and by which codec
        frames are decoded.
        """
        self._wanted = tuple(taps)

    def open(self, codec: Codec, bitrate: int | None) -> None:
        """A device was opened, and is spoken to in this way."""
        self._opened = codec, bitrate
        self._told, self._failed = [], []
        self._follow()

    def flush(self, codec: Codec, now_s: float) -> None:
        """Tell what has come together; it was decoded by this codec."""
        if self._wanted is not self._followed:
            self._follow()
        heard, self.heard = self.heard, []
        sent = self._decoded(codec) if self.sent else ()
        for tap in tuple(self._told):
            try:
                if heard:
                    tap.on_heard(heard)
                if sent:
                    tap.on_sent(sent)
                tap.on_look(now_s)
            except Exception:  # noqa: BLE001 - whatever it is: receiving goes on
                self._give_up(tap)

    def switch(self, before: Codec, codec: Codec, now_s: float) -> None:
        """From now on frames are decoded by another codec."""
        self.flush(before, now_s)
        if self._opened is not None:
            self._opened = codec, self._opened[1]
        self._tell(lambda tap: tap.on_codec(codec))

    def error_frame(self) -> None:
        """The adapter has reported an error on the bus."""
        self._tell(lambda tap: tap.on_error_frame())

    def _follow(self) -> None:
        """Begin to tell those who came, and tell those who left no more."""
        wanted = self._followed = self._wanted
        self._failed = [each for each in self._failed if each in wanted]
        came = [each for each in wanted if each not in self._told and each not in self._failed]
        self._told = [each for each in self._told if each in wanted]
        if self._opened is None:
            return
        codec, bitrate = self._opened
        for tap in came:
            self._told.append(tap)
            try:
                tap.on_open(bitrate)
                tap.on_codec(codec)
            except Exception:  # noqa: BLE001 - whatever it is: receiving goes on
                self._give_up(tap)

    def _tell(self, word: Callable[[Tap], None]) -> None:
        for tap in tuple(self._told):
            try:
                word(tap)
            except Exception:  # noqa: BLE001 - whatever it is: receiving goes on
                self._give_up(tap)

    def _decoded(self, codec: Codec) -> list[Taken]:
        batch: list[Taken] = []
        while self.sent:
            frame, at_s = self.sent.popleft()
            batch.append((codec.decode(frame), at_s, frame, FrameFlag.TRANSMITTED))
        return batch

    def _give_up(self, tap: Tap) -> None:
        _LOG.exception("%s has failed; it is told no more until reconnecting", type(tap).__name__)
        self._told.remove(tap)
        self._failed.append(tap)
