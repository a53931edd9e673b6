"""Encodes a periodic frame only when it says what was not said before."""

from __future__ import annotations

from typing import Final

from armui.protocol.codec import Codec
from armui.protocol.frame import Frame

_MOST: Final = 64
"""Of one message; joints on their way never say the same twice."""


class FrameCache:
    """Keeps frames of each message; one is encoded when its values are none of those kept.

    Most of an arm's 3,000 frames a second repeat the ones before them, or, like the supply's
    voltage with its noise, one of a few.
    """

    def __init__(self, codec: Codec) -> None:
        self._codec = codec
        self._kept: dict[str, dict[tuple[tuple[str, float], ...], Frame]] = {}
        self._known: dict[str, frozenset[str]] = {}

    def frame(self, name: str, **signals: float) -> Frame:
        """The frame of a message; signals its generation does not have are left out."""
        kept = self._kept.get(name)
        if kept is None:
            kept = self._kept[name] = {}
            self._known[name] = frozenset(self._codec.signals(name))
        said = tuple(signals.items())
        frame = kept.get(said)
        if frame is None:
            known = self._known[name]
            frame = self._codec.encode(
                name, **{signal: value for signal, value in said if signal in known}
            )
            if len(kept) == _MOST:
                kept.clear()
            kept[said] = frame
        return frame
