"""Reads the binary log format with python-can and notices where a file breaks off."""

from __future__ import annotations

from typing import IO, TYPE_CHECKING, BinaryIO, cast

import can

from armui.decode.entries import LogFrame, NotALogError, Unreadable, log_frame
from armui.system.error_text import error_text

if TYPE_CHECKING:
    from collections.abc import Iterator

_OBJECT_HEADER = 16
"""Bytes the reader asks for between two objects: a file that ends there is complete."""
_PADDING = 3
"""Most bytes between two objects; writers may leave the last ones out."""


class _Meter:
    """A binary stream that knows how far it was read, and whether it ended too early."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream = stream
        self.position = 0
        self.broken_at: int | None = None

    def read(self, size: int) -> bytes:
        """Reads from the file; a size below 0, from a damaged length field, reads nothing."""
        data = self._stream.read(max(size, 0))
        ends_rightly = not data and size == _OBJECT_HEADER
        if len(data) < size and size > _PADDING and not ends_rightly and self.broken_at is None:
            self.broken_at = self.position + len(data)
        self.position += len(data)
        return data

    def close(self) -> None:
        """Called by the reader at its end; the file belongs to whoever opened it."""


def read_blf_log(stream: IO[bytes]) -> Iterator[LogFrame | Unreadable]:
    """Frames of a log, in order; then where it breaks off, if it does.

    Args:
        stream: The file.

    Raises:
        NotALogError: The file does not begin as a log of this format.
    """
    meter = _Meter(stream)
    try:
        reader = can.BLFReader(cast("BinaryIO", meter))
    except Exception as error:  # a damaged header makes the reader raise whatever it hits
        raise NotALogError("it does not begin as a BLF file") from error
    messages = iter(reader)
    count = 0
    while True:
        try:
            message = next(messages)
        except StopIteration:
            break
        except Exception as error:  # noqa: BLE001 - damaged bytes raise whatever they hit
            broken_at = meter.position if meter.broken_at is None else meter.broken_at
            reason = f"damaged here ({error_text(error)}), after {count} frames"
            yield Unreadable(f"byte {broken_at}", reason)
            return
        count += 1
        yield log_frame(message) or Unreadable(f"frame {count}", "its parts contradict one another")
    if meter.broken_at is not None:
        yield Unreadable(
            f"byte {meter.broken_at}", f"the file breaks off here, after {count} frames"
        )
