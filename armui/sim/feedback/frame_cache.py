"""Encodes a periodic frame only when one of its values has changed."""

from __future__ import annotations

from armui.protocol.codec import Codec
from armui.protocol.frame import Frame


class FrameCache:
    """Keeps the last frame of each message; a new one is encoded when a value differs.

    Most of an arm's 3,000 frames a second repeat the ones before them.
    """

    def __init__(self, codec: Codec) -> None:
        self._codec = codec
        self._last: dict[str, tuple[dict[str, float], Frame]] = {}
        self._known: dict[str, frozenset[str]] = {}

    def frame(self, name: str, **signals: float) -> Frame:
        """The frame of a message; signals its generation does not have are left out."""
        last = self._last.get(name)
        if last is not None and last[0] == signals:
            return last[1]
        known = self._known.get(name)
        if known is None:
            known = self._known[name] = frozenset(self._codec.signals(name))
        frame = self._codec.encode(
            name, **{signal: value for signal, value in signals.items() if signal in known}
        )
        self._last[name] = signals, frame
        return frame
