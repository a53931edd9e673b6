"""The interface of those who are told of every frame on the bus, in batches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armui.protocol.codec import Codec, InvalidFrame, Message
    from armui.protocol.frame import Frame
    from armui.protocol.generation import Generation

ReceivedFrame = tuple["Message | InvalidFrame", float, "Frame", int]
"""A frame as decoded, its monotonic time in seconds, the frame itself, and its `FrameFlag` bits.

A frame that is repeated shares its decoded message: it must not be changed."""


class Listener:
    """Hears every frame; a subclass overrides what it needs.

    All but `know_generation` is called by the bus thread.
    """

    def know_generation(self, generation: Generation | None) -> None:
        """Which protocol the arm was found to speak; ``None``: not known, or not any more."""

    def on_open(self, bitrate: int | None) -> None:
        """A device was opened."""

    def on_codec(self, codec: Codec) -> None:
        """How frames are decoded from now on."""

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """Frames that others sent."""

    def on_sent(self, batch: Sequence[ReceivedFrame]) -> None:
        """Frames that this program sent."""

    def on_error_frame(self) -> None:
        """The adapter has reported an error on the bus."""

    def on_look(self, now_s: float) -> None:
        """Called every few milliseconds."""
