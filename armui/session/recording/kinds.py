"""The formats of recordings, their files' names, and the reasons why writing fails: pure."""

from __future__ import annotations

import enum
import errno
import re
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Final, Protocol

from armui.arm.refusal import Reason, Refusal
from armui.system.files import error_text

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from armui.session.recording.rows import FrameRows

SESSION_DISK_FULL = Reason(
    "session_disk_full",
    "The disk of {folder} is full. What was written before can be read. Free some room or "
    "choose another folder, then record again.",
)
SESSION_READ_ONLY = Reason(
    "session_read_only",
    "The folder {folder} cannot be written. Choose another folder for the logs, "
    "or allow this one to be written.",
)
SESSION_FOLDER_GONE = Reason(
    "session_folder_gone",
    "The folder {folder}, or its disk, is gone. Plug it in again or choose another folder, "
    "then record again.",
)
SESSION_FAILED = Reason(
    "session_failed",
    "The log could not be written in {folder}: {text}. What was written before can be "
    "read. Choose another folder, or try again.",
)

_PART: Final = re.compile(r"(?P<name>.+)\.(?P<number>\d{3,})$")
_FORBIDDEN: Final = re.compile(r'[<>:"/\\|?*\x00-\x1f\x7f]')
LONGEST_NAME: Final = 120

_CODES: Final = {
    errno.ENOSPC: SESSION_DISK_FULL,
    errno.EDQUOT: SESSION_DISK_FULL,
    errno.EFBIG: SESSION_DISK_FULL,
    errno.EACCES: SESSION_READ_ONLY,
    errno.EPERM: SESSION_READ_ONLY,
    errno.EROFS: SESSION_READ_ONLY,
    errno.ENOENT: SESSION_FOLDER_GONE,
    errno.ENODEV: SESSION_FOLDER_GONE,
    errno.ENXIO: SESSION_FOLDER_GONE,
    errno.EIO: SESSION_FOLDER_GONE,
    errno.ESTALE: SESSION_FOLDER_GONE,
}


class RecordingFormat(enum.Enum):
    """A format of recordings, by the suffix of its files."""

    BLF = ".blf"
    ASC = ".asc"
    CANDUMP = ".log"


class BlockFormat(Protocol):
    """Converts frames into the bytes of one file; by default nothing stands around the frames.

    Attributes:
        start_s: The time since 1970 from which the file counts, if it does.
    """

    start_s: float

    def opening(self) -> bytes:
        """Return the beginning of the file."""
        return b""

    def header(self, size: int) -> bytes:  # noqa: ARG002 - for those whose beginning tells it
        """Return the file's new beginning for a size in bytes, if it changes with it."""
        return b""

    def closing(self) -> bytes:
        """Return the end of the file."""
        return b""

    def rounded(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return times as they will be read back."""

    def block(self, rows: FrameRows, at_byte: int) -> bytes:
        """Return the bytes of frames for a place in the file."""


# The names of a recording's files.
#
# A recording NAME has ``NAME.blf``, ``NAME.002.blf`` and so on, its sidecar ``NAME.armui.jsonl``
# and its index ``NAME.armui.idx``.


def file_name(name: str, number: int, suffix: str) -> str:
    """Return the name of a recording's file with a number, from 1."""
    return f"{name}{suffix}" if number == 1 else f"{name}.{number:03}{suffix}"


def names_of(path: Path) -> tuple[str, ...]:
    """Return the possible names of the recording that a file belongs to, the likeliest first."""
    stem = path.stem
    found = _PART.fullmatch(stem)
    return (stem,) if found is None else (found["name"], stem)


def name_for(at: datetime) -> str:
    """Return the name of a recording that begins at a time."""
    return f"session-{at:%Y%m%d-%H%M%S}"


def is_name(text: str) -> bool:
    """Return whether a text can be the name of a recording on every system."""
    return (
        0 < len(text) <= LONGEST_NAME
        and text == text.strip()
        and not text.startswith(".")
        and not text.endswith(".")
        and _FORBIDDEN.search(text) is None
        and _PART.fullmatch(text) is None
    )


def why_not_written(error: BaseException, folder: Path) -> Refusal:
    """Return the reason why a folder cannot be written, from the error of writing into it."""
    code = error.errno if isinstance(error, OSError) else None
    known = _CODES.get(code or 0)
    if known is not None:
        return Refusal(known, {"folder": str(folder)})
    return SESSION_FAILED(folder=str(folder), text=error_text(error))
