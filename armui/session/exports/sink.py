"""What the formats have in common: they are given a log piece by piece."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Mapping

    import numpy as np
    from numpy.typing import NDArray

    from armui.kinematics.geometry import Geometry
    from armui.protocol.codec import Codec
    from armui.session.exports.history import History


@dataclass(frozen=True, slots=True)
class ExportFacts:
    """What a format may have to know of the recorded arm, and what it tells of it.

    Attributes:
        codec: Speaks its generation.
        geometry: Of the arm.
        gripper_turned_deg: How its gripper is mounted, about the flange's Z axis.
        start_s: When the log's first frame was recorded.
        notes: In words: source, generation, firmware; for the file's metadata.
    """

    codec: Codec
    geometry: Geometry
    gripper_turned_deg: float
    start_s: float
    notes: Mapping[str, str]


class TimeSpan:
    """A stretch of a log.

    Args:
        begin_s: From there on, as recorded; minus infinity for everything.
        end_s: Up to there, itself included; infinity for everything.
    """

    def __init__(self, begin_s: float, end_s: float) -> None:
        self.begin_s = begin_s
        self.end_s = end_s

    def holds(self, times_s: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which times lie in it."""
        inside: NDArray[np.bool_] = (times_s >= self.begin_s) & (times_s <= self.end_s)
        return inside


class Sink(Protocol):
    """A file of one format, being written.

    Attributes:
        items: Rows or messages written so far.
    """

    items: int

    def take(self, history: History, span: TimeSpan) -> None:
        """Write what a piece of the log adds.

        Args:
            history: Has just taken the piece.
            span: Only what lies in it is written.

        Raises:
            OSError: The disk does not take it.
        """

    def finish(self) -> None:
        """Write what comes at the end of the file.

        Raises:
            OSError: The disk does not take it.
        """

    def abandon(self) -> None:
        """Let go of the file, which nobody wants any more; never fails."""
