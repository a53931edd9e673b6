"""Tells listeners of every frame on the bus, on the side of the thread that owns it."""

from __future__ import annotations

import logging
from collections import deque
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Final

from armui.protocol.frame import FrameFlag

if TYPE_CHECKING:
    from armui.protocol.codec import Codec
    from armui.protocol.frame import Frame
    from armui.telemetry.listener import Listener, ReceivedFrame

_LOG: Final = logging.getLogger(__name__)

SENT_KEPT: Final = 4096
"""The number of sent frames that may wait for the bus thread, which collects them every few
milliseconds.
"""


class Notifier:
    """Collects frames and passes them to the listeners in batches, in the bus thread.

    A listener that fails is told no more until the device is opened again: receiving goes on, and
    the other listeners hear as before.

    Args:
        listeners: The listeners at the beginning.

    Attributes:
        sent: Sent frames with their times, put in by the threads that send.
        received: Received frames.
    """

    def __init__(self, listeners: Sequence[Listener] = ()) -> None:
        self._wanted: tuple[Listener, ...] = tuple(listeners)
        self._followed: tuple[Listener, ...] = ()
        self._active: list[Listener] = []
        self._failed: list[Listener] = []
        self._opened: tuple[Codec, int | None] | None = None
        self.received: list[ReceivedFrame] = []
        self.sent: deque[tuple[Frame, float]] = deque(maxlen=SENT_KEPT)

    def set_listeners(self, listeners: Sequence[Listener]) -> None:
        """Replace the listeners; may be called from any thread, and takes effect at the next flush.

        A listener added while a device is open is first told that it was opened, and which codec
        decodes its frames.
        """
        self._wanted = tuple(listeners)

    def open(self, codec: Codec, bitrate: int | None) -> None:
        """Tell the listeners that a device was opened, with its codec and its bit rate in bit/s."""
        self._opened = codec, bitrate
        self._active, self._failed = [], []
        self._update_active()

    def flush(self, codec: Codec, now_s: float) -> None:
        """Pass on the frames that were collected since the last flush, decoded by this codec."""
        if self._wanted is not self._followed:
            self._update_active()
        received, self.received = self.received, []
        sent = self._decoded(codec) if self.sent else ()

        def pass_on(listener: Listener) -> None:
            if received:
                listener.on_heard(received)
            if sent:
                listener.on_sent(sent)
            listener.on_look(now_s)

        self._notify(pass_on, self._active)

    def switch(self, before: Codec, codec: Codec, now_s: float) -> None:
        """Tell the listeners that another codec decodes the frames from now on."""
        self.flush(before, now_s)
        if self._opened is not None:
            self._opened = codec, self._opened[1]
        self._notify(lambda listener: listener.on_codec(codec), self._active)

    def error_frame(self) -> None:
        """Tell the listeners that the adapter has reported an error on the bus."""
        self._notify(lambda listener: listener.on_error_frame(), self._active)

    def _update_active(self) -> None:
        """Start passing frames to added listeners, and stop for removed ones."""
        wanted = self._followed = self._wanted
        self._failed = [each for each in self._failed if each in wanted]
        came = [each for each in wanted if each not in self._active and each not in self._failed]
        self._active = [each for each in self._active if each in wanted]
        if self._opened is None:
            return
        codec, bitrate = self._opened

        def begin(listener: Listener) -> None:
            self._active.append(listener)
            listener.on_open(bitrate)
            listener.on_codec(codec)

        self._notify(begin, came)

    def _notify(self, word: Callable[[Listener], None], listeners: Sequence[Listener]) -> None:
        for listener in tuple(listeners):
            try:
                word(listener)
            except Exception:  # noqa: BLE001 - receiving must go on
                self._give_up(listener)

    def _decoded(self, codec: Codec) -> list[ReceivedFrame]:
        batch: list[ReceivedFrame] = []
        while self.sent:
            frame, at_s = self.sent.popleft()
            batch.append((codec.decode(frame), at_s, frame, FrameFlag.TRANSMITTED))
        return batch

    def _give_up(self, listener: Listener) -> None:
        _LOG.exception(
            "%s has failed; it is told no more until reconnecting", type(listener).__name__
        )
        self._active.remove(listener)
        self._failed.append(listener)
