"""Which frames of a slice of a log must be looked at one by one when it is played fast."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from armui.protocol.columns import bit_mask, payload_words
from armui.telemetry.columns import NOT_OF_THE_ARM

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from armui.protocol.codec import Codec
    from armui.telemetry.columns import FrameColumns

_IDS: Final = 0x800
_MEASURED: Final = frozenset(
    {f"JointFeedback{pair}" for pair in (12, 34, 56)}
    | {f"EndPose{part}" for part in (1, 2, 3)}
    | {f"{kind}{joint}" for kind in ("DriverFast", "EndMotion") for joint in range(1, 7)}
)
"""Messages that say where the arm is: the last one counts."""
_TOLD: Final = frozenset(
    {"ArmStatus", "GripperFeedback", *(f"DriverSlow{joint}" for joint in range(1, 7))}
)
"""Messages with faults beside figures: each change of a fault or mode counts."""


class Folding:
    """Picks the frames that tell something new; what it leaves out was said again in the slice.

    Args:
        codec: How frames are decoded.
    """

    def __init__(self, codec: Codec) -> None:
        self._is_folded: NDArray[np.bool_] = np.zeros(_IDS, np.bool_)
        self._masks: dict[int, np.uint64] = {}
        self._last: dict[int, int] = {}
        for wire_id, layout in codec.layouts.items():
            if layout.name not in _MEASURED | _TOLD:
                continue
            self._is_folded[wire_id] = True
            if layout.name in _TOLD:
                codes = [each for each in layout.signals.values() if not each.unit]
                self._masks[wire_id] = np.uint64(bit_mask(codes))

    def rows(self, frames: FrameColumns) -> NDArray[np.int64]:
        """The rows to be taken in, in order.

        The first row is one of them: the time between it and what came before is a silence or none.
        """
        ordinary = (frames.flags & NOT_OF_THE_ARM) == 0
        folded = ordinary & self._is_folded[np.minimum(frames.ids, _IDS - 1)]
        folded &= frames.ids < _IDS
        keep = ~folded
        if keep.size:
            keep[0] = True
        rows = np.flatnonzero(folded)
        order = rows[np.argsort(frames.ids[rows], kind="stable")]
        edges = np.flatnonzero(np.diff(frames.ids[order])) + 1
        for same in np.split(order, edges) if order.size else ():
            keep[same[-1]] = True
            wire_id = int(frames.ids[same[0]])
            mask = self._masks.get(wire_id)
            if mask is not None:
                codes = payload_words(frames.payloads[same]) & mask
                before = np.uint64(self._last.get(wire_id, int(codes[0])))
                keep[same[np.diff(codes, prepend=before) != 0]] = True
                self._last[wire_id] = int(codes[-1])
        return np.flatnonzero(keep)
