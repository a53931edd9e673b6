"""The formats in which a session can be recorded."""

from __future__ import annotations

import enum
from typing import TYPE_CHECKING, Final, Protocol

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from armui.session.recording.rows import FrameRows


class RecordingFormat(enum.Enum):
    """A format, by the suffix of its files."""

    BLF = ".blf"
    ASC = ".asc"
    CANDUMP = ".log"


MF4_SUFFIX: Final = ".mf4"
"""Of what is made of a recording afterwards; see `armui.session.recording.mf4`."""


class BlockFormat(Protocol):
    """Turns frames into the bytes of one file.

    Attributes:
        start_s: Time since 1970 from which the file counts, where it does.
    """

    start_s: float

    def opening(self) -> bytes:
        """What the file begins with."""

    def header(self, size: int) -> bytes:
        """What stands at the beginning of the file now that it has so many bytes, if that moves."""

    def closing(self) -> bytes:
        """What the file ends with."""

    def rounded(self, times_s: NDArray[np.float64]) -> NDArray[np.float64]:
        """Times as they will be read back."""

    def block(self, rows: FrameRows, at_byte: int) -> bytes:
        """Frames, to be written at a place of the file."""


def block_format(kind: RecordingFormat, start_s: float, channel: str) -> BlockFormat:
    """The format of a new file.

    Args:
        kind: Which.
        start_s: Time of its first frame, since 1970.
        channel: The bus's name, where the format has room for it.
    """
    from armui.session.recording.blf_format import BlfFormat  # noqa: PLC0415 - python-can
    from armui.session.recording.text_formats import AscFormat, CandumpFormat  # noqa: PLC0415 - as above

    if kind is RecordingFormat.BLF:
        return BlfFormat(start_s)
    if kind is RecordingFormat.ASC:
        return AscFormat(start_s, channel)
    return CandumpFormat(start_s, channel)
