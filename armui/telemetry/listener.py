"""The interface of objects that are told of every frame on the bus, in batches."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from armui.protocol.codec import Codec, InvalidFrame, Message
    from armui.protocol.frame import Frame
    from armui.protocol.generation import Generation

ReceivedFrame = tuple["Message | InvalidFrame", float, "Frame", int]
"""A decoded frame, its monotonic time in seconds, the frame itself, and its `FrameFlag` bits.

A repeated frame shares its decoded message, which must not be changed.
"""


class Listener:
    """Receives every frame; subclasses override the methods they need.

    All but `know_generation` is called by the bus thread.
    """

    def know_generation(self, generation: Generation | None) -> None:
        """Set the protocol that the arm was found to speak; ``None`` if it is not known."""

    def on_open(self, bitrate: int | None) -> None:
        """Handle the opening of a device."""

    def on_codec(self, codec: Codec) -> None:
        """Set the codec that decodes frames from now on."""

    def on_heard(self, batch: Sequence[ReceivedFrame]) -> None:
        """Handle frames that others sent."""

    def on_sent(self, batch: Sequence[ReceivedFrame]) -> None:
        """Handle frames that this program sent."""

    def on_error_frame(self) -> None:
        """Handle an error on the bus that the adapter has reported."""

    def on_look(self, now_s: float) -> None:
        """Do periodic work; called every few milliseconds."""
