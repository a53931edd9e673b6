"""Frames in memory as the text of a candump log, for example for a problem report."""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from armui.session.recording.formats import CandumpFormat
from armui.session.recording.rows import FrameRows

if TYPE_CHECKING:
    from armui.session.recording.writer import TimeBase

_ROWS_AT_ONCE: Final = 500


def candump_text(parts: Sequence[FrameRows], base: TimeBase, channel: str) -> bytes:
    """Return frames as lines with the time of day.

    Args:
        parts: In the order of time.
        base: The time base of the frames.
        channel: The bus's name.
    """
    lines = CandumpFormat(0.0, channel)
    blocks = []
    for rows in parts:
        table = rows.table.copy()
        table["time_s"] = lines.rounded(table["time_s"] + base.shift_s)
        shifted = FrameRows(table, rows.long_data)
        for begin in range(0, len(shifted), _ROWS_AT_ONCE):
            blocks.append(lines.block(shifted.part(begin, begin + _ROWS_AT_ONCE), 0))
            time.sleep(0)  # releases the GIL, so that other threads are not held up
    return b"".join(blocks)
