"""Which generation the arm of a log speaks, found out from the log's beginning."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from armui.protocol.detect import GenerationDetector
from armui.protocol.frame import Frame
from armui.session.frames import NOT_OF_THE_ARM

if TYPE_CHECKING:
    from collections.abc import Iterator

    from armui.protocol.detect import GenerationVerdict
    from armui.session.frames import FrameBatch

_FRAMES_LOOKED_AT: Final = 6_000
"""So many frames, two seconds of an arm, tell the generation as well as all of them."""
_MOST_FRAMES_LOOKED_AT: Final = 200_000
"""Among foreign frames the arm's are looked for longer, but not without end."""


def detect_generation(
    batches: Iterator[FrameBatch],
) -> tuple[list[FrameBatch], GenerationVerdict]:
    """Reads a log's beginning until its generation is certain.

    Returns:
        What was read for it, and the verdict.
    """
    detector = GenerationDetector()
    looked_at: list[FrameBatch] = []
    count = 0
    for batch in batches:
        looked_at.append(batch)
        for row in np.flatnonzero((batch.flags & NOT_OF_THE_ARM) == 0).tolist():
            detector.feed(Frame(int(batch.ids[row]), batch.data(row)), float(batch.times_s[row]))
            if detector.certain:
                return looked_at, detector.verdict()
            count += 1
            if count >= _FRAMES_LOOKED_AT and detector.has_evidence:
                return looked_at, detector.verdict()
        if count >= _MOST_FRAMES_LOOKED_AT:
            break
    return looked_at, detector.verdict()
