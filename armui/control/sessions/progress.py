"""How a recording goes, and what is kept in memory."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from armui.control.events import Notice
from armui.telemetry.events import EventKind, Level

SESSION_FRAMES_LOST = Notice(
    "session_frames_lost",
    "{count} frames are missing in the recording: the disk is too slow",
    Level.WARNING,
    EventKind.PROGRAM,
)


@dataclass(frozen=True, slots=True)
class RecordingProgress:
    """The recording under way.

    Attributes:
        name: As it is called; "" until its folder was found writable.
        folder: Where it is.
        elapsed_s: Since it was begun.
        frames, total_bytes: On the disk by now.
        lost: Frames that are missing in it.
    """

    name: str
    folder: Path
    elapsed_s: float
    frames: int
    total_bytes: int
    lost: int


@dataclass(frozen=True, slots=True)
class RingContent:
    """What the ring holds.

    Attributes:
        frames: How many.
        span_s: From the first to the last.
        bytes_kept, most_bytes: The memory it takes now, and at most.
    """

    frames: int = 0
    span_s: float = 0.0
    bytes_kept: int = 0
    most_bytes: int = 0
