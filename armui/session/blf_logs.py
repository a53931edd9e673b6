"""Reads the binary log format with python-can."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, BinaryIO, Final, cast

import can
from can.io import blf

from armui.session.blf_objects import ObjectStream, container
from armui.session.frames import NotALogError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from armui.session.frames import FrameBatch
    from armui.session.gather import Gatherer
    from armui.session.source import Source

_ROWS: Final = 4_096
_HEADER: Final = blf.FILE_HEADER_STRUCT
_HEADER_SIZE_AT: Final = 4
_LARGEST_HEADER: Final = 4_096


class _Feed:
    """The stream that python-can's reader reads: a header and containers, all of them whole."""

    def __init__(self, header: bytes, pieces: Iterator[bytes]) -> None:
        self._header = header
        self._pieces = pieces
        self._waiting = memoryview(header)

    def read(self, size: int) -> bytes:
        """As a file's."""
        while not self._waiting and size > 0:
            objects = next(self._pieces, None)
            if objects is None:
                return b""
            if objects:
                self._waiting = memoryview(container(objects))
        data, self._waiting = self._waiting[: max(size, 0)], self._waiting[max(size, 0) :]
        return bytes(data)

    def restart(self) -> None:
        """Drops the rest of the container, and begins again with the header."""
        self._waiting = memoryview(self._header)

    def close(self) -> None:
        """Called by the reader at its end; the file belongs to whoever opened it."""


def read_blf_log(source: Source, gatherer: Gatherer) -> Iterator[FrameBatch]:
    """Frames of a log, in order.

    Objects that are no CAN frames are passed over. Frames that stand in the file by themselves,
    outside of a container, are read as well.

    Args:
        source: The file.
        gatherer: Makes the batches, and is told what cannot be read.

    Raises:
        NotALogError: The file does not begin as a log of this format.
    """
    header = source.read(_HEADER.size)
    if len(header) < _HEADER.size or not header.startswith(b"LOGG"):
        raise NotALogError("no CAN log: it does not begin as a BLF file")
    gatherer.header_seen = True
    (header_size,) = struct.unpack_from("<L", header, _HEADER_SIZE_AT)
    rest = header_size - _HEADER.size
    skipped = source.read(rest) if 0 < rest <= _LARGEST_HEADER else b""
    gathered: list[can.Message] = []

    def note(byte: int, reason: str) -> None:
        count = gatherer.frames + len(gathered)
        gatherer.note(f"byte {byte}", f"{reason}, after {count} frames", len(gathered))

    def place(index: int) -> str:
        return f"frame {gatherer.frames + index + 1}"

    own_header = bytearray(header)
    struct.pack_into("<L", own_header, _HEADER_SIZE_AT, _HEADER.size)
    objects = ObjectStream(source, len(header) + len(skipped), note)
    feed = _Feed(bytes(own_header), objects.pieces())
    messages = iter(can.BLFReader(cast("BinaryIO", feed)))
    while True:
        try:
            message = next(messages)
        except StopIteration:
            break
        except Exception as error:  # noqa: BLE001 - damaged bytes raise whatever they hit
            note(objects.position, f"damaged here ({str(error) or type(error).__name__})")
            feed.restart()
            messages = iter(can.BLFReader(cast("BinaryIO", feed)))
            continue
        gathered.append(message)
        if len(gathered) >= _ROWS:
            yield gatherer.batch(gathered, place)
            gathered.clear()
    if gathered:
        yield gatherer.batch(gathered, place)
