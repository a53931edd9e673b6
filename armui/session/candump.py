"""Whole blocks of ordinary candump lines at once, as python-can's reader gives them, but faster.

The tests hold it against that reader. A block with any other line goes through the reader.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Final

import numpy as np

from armui.protocol.frame import FrameFlag
from armui.session.frames import CLASSIC_BYTES, FrameBatch

if TYPE_CHECKING:
    from armui.session.gather import Gatherer

_LINE: Final = re.compile(
    r"^\((\d+\.\d+)\) ([^\s#]+) ([0-7][0-9A-Fa-f]{2}|[01][0-9A-Fa-f]{7})"
    r"#((?:[0-9A-Fa-f]{2}){0,8})( [RT])?$",
    re.ASCII | re.MULTILINE,
)
_HEX_BYTES: Final = 2 * CLASSIC_BYTES


def quick_batch(lines: list[str], gatherer: Gatherer) -> FrameBatch | None:
    """The frames of a block of lines.

    Args:
        lines: Stripped lines; empty ones are passed over.
        gatherer: Numbers frames and channels.

    Returns:
        The batch, or None when any line is not a data frame of at most 8 bytes written as
        ``candump -L`` writes it.
    """
    found = _LINE.findall("\n".join(lines))
    count = len(found)
    if count != len(lines) - lines.count(""):
        return None
    times, channels, ids, data, directions = zip(*found, strict=True) if count else ((),) * 5
    flags = np.zeros(count, np.uint8)
    id_digits = np.array(list(map(len, ids)), np.uint8)
    if " T" in directions:
        flags[[each == " T" for each in directions]] |= np.uint8(FrameFlag.TRANSMITTED)
    if (id_digits == 3).all():
        joined = bytes.fromhex("0" + "0".join(ids)) if count else b""
        id_column = np.frombuffer(joined, ">u2").astype(np.uint32)
    else:
        id_column = np.array([int(each, 16) for each in ids], np.uint32)
        flags[id_digits != 3] |= np.uint8(FrameFlag.EXTENDED)
    lengths = np.array(list(map(len, data)), np.uint8)
    if not (lengths == _HEX_BYTES).all():
        data = tuple(each.ljust(_HEX_BYTES, "0") for each in data)
    names = tuple(int(each) if each.isdigit() else each for each in channels)
    return gatherer.count(
        FrameBatch(
            first=gatherer.frames,
            times_s=np.array(list(map(float, times)), np.float64),
            ids=id_column,
            flags=flags,
            lengths=lengths // 2,
            payloads=np.frombuffer(bytes.fromhex("".join(data)), np.uint8).reshape(
                -1, CLASSIC_BYTES
            ),
            channels=gatherer.channel_column(names),
            channel_names=gatherer.channel_names,
        )
    )
