"""The progress of a recording, and the contents of the ring."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from pathlib import Path

from armui.control.events import Notice
from armui.telemetry.events import EventKind, Level

SESSION_FRAMES_LOST = Notice(
    "session_frames_lost",
    "{count} frames are missing in the log: the disk is too slow",
    Level.WARNING,
    EventKind.PROGRAM,
)


class EpisodePhase(enum.Enum):
    """What can be marked in the log now."""

    NO_LOG = enum.auto()
    """Nothing: no log is being written."""
    NONE = enum.auto()
    """A beginning: there is no episode yet, or the last one is discarded."""
    UNDER_WAY = enum.auto()
    """The end of an episode, or that it is discarded."""
    ENDED = enum.auto()
    """A beginning, or that the last episode is discarded."""


@dataclass(frozen=True, slots=True)
class RecordingProgress:
    """The progress of the recording under way.

    Attributes:
        name: Its name; "" until its folder was found writable.
        folder: Its folder.
        elapsed_s: The time since its beginning.
        frames, total_bytes: The frames and bytes on the disk so far.
        lost: The number of frames missing in it.
    """

    name: str
    folder: Path
    elapsed_s: float
    frames: int
    total_bytes: int
    lost: int


@dataclass(frozen=True, slots=True)
class RingContent:
    """The contents of the ring.

    Attributes:
        frames: The number of frames.
        span_s: The time from the first to the last.
        bytes_kept, most_bytes: The memory in use, and its limit.
    """

    frames: int = 0
    span_s: float = 0.0
    bytes_kept: int = 0
    most_bytes: int = 0
