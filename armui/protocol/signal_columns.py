"""Decodes one signal of many frames at once, for logs of millions of frames."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from armui.protocol.layout import SignalLayout

_WORD_BITS = 64


def payload_words(payloads: NDArray[np.uint8]) -> NDArray[np.uint64]:
    """Return payloads of 8 bytes, shape (rows, 8), as one big-endian number each."""
    return np.ascontiguousarray(payloads).view(">u8").reshape(-1).astype(np.uint64)


def signal_column(words: NDArray[np.uint64], signal: SignalLayout) -> NDArray[Any]:
    """Return the physical values of one signal, equal to those of `Codec.decode` frame by frame.

    Args:
        words: Payloads as `payload_words` gives them, shorter ones padded with zeros.
        signal: The signal's layout.

    Returns:
        int64 where the signal is not scaled, else float64; NaN in rows that hold something else in
        its place.
    """
    selection = signal.selection
    if selection is not None:
        rest = np.uint64(_WORD_BITS - selection.bits)
        there = words << np.uint64(selection.first_bit) >> rest == np.uint64(selection.raw)
        return np.where(there, _column(words, signal), np.nan)
    return _column(words, signal)


def _column(words: NDArray[np.uint64], signal: SignalLayout) -> NDArray[Any]:
    moved = words << np.uint64(signal.first_bit)
    rest = np.uint8(_WORD_BITS - signal.bits)
    raw = moved.view(np.int64) >> rest if signal.is_signed else (moved >> rest).view(np.int64)
    if not signal.is_scaled:
        return raw
    if signal.divisor is not None and not signal.offset:
        return raw / signal.divisor
    return raw * signal.scale + signal.offset


def bit_mask(signals: Iterable[SignalLayout]) -> int:
    """Return the bits of some signals in a payload word."""
    mask = 0
    for signal in signals:
        mask |= ((1 << signal.bits) - 1) << (_WORD_BITS - signal.first_bit - signal.bits)
    return mask
