"""Reads Vector's binary log format with python-can."""

from __future__ import annotations

import struct
import zlib
from typing import TYPE_CHECKING, BinaryIO, Final, cast

import can
from can.io import blf

from armui.session.frames import NotALogError
from armui.system.files import error_text
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from armui.session.batch_builder import BatchBuilder
    from armui.session.frames import FrameBatch
    from armui.session.source import LogSource

# The objects of a BLF file, one after another, past whatever is damaged between them.
#
# The layout is that of python-can's reader, which is given these objects: a file header, then
# objects that begin with LOBJ, most of them containers with more objects inside, packed by zlib.

_SIGNATURE: Final = b"LOBJ"
_BASE: Final = struct.Struct("<4sHHLL")
"""An object's head: signature, header size, header version, object size, object type."""
_CONTAINER: Final = struct.Struct("<H6xL4x")
"""A container's head: method of compression, unpacked size."""
_HEADERS: Final = {
    1: _BASE.size + blf.OBJ_HEADER_V1_STRUCT.size,
    2: _BASE.size + blf.OBJ_HEADER_V2_STRUCT.size,
}
_BODIES: Final = {
    blf.CAN_MESSAGE: blf.CAN_MSG_STRUCT.size,
    blf.CAN_MESSAGE2: blf.CAN_MSG_STRUCT.size,
    blf.CAN_ERROR_EXT: blf.CAN_ERROR_EXT_STRUCT.size,
    blf.CAN_FD_MESSAGE: blf.CAN_FD_MSG_STRUCT.size,
    blf.CAN_FD_MESSAGE_64: blf.CAN_FD_MSG_64_STRUCT.size,
}
"""The bytes that the reader unpacks of an object, by type; some tools omit unused ones."""
_SPARED: Final = {blf.CAN_MESSAGE: 8, blf.CAN_MESSAGE2: 8, blf.CAN_FD_MESSAGE: 64}
"""The bytes of data at the end of an object that a writer may omit if the frame is shorter."""
_LARGEST: Final = 1 << 24
"""A larger object counts as a damaged length."""
_PIECE: Final = 1 << 20
_PACKED_PIECE: Final = 1 << 14
_PATIENT_BYTES: Final = 1 << 26
"""After this many unpacked bytes without an object the rest of a container is skipped."""
_PADDING: Final = 7
"""The most bytes between two objects."""

_ROWS: Final = 4_096
_HEADER: Final = blf.FILE_HEADER_STRUCT
_HEADER_SIZE_AT: Final = 4
_LARGEST_HEADER: Final = 4_096


class ObjectStream:
    """Yields whole unpacked objects in pieces of bounded size.

    Args:
        source: The file, positioned after its header.
        position: Bytes of the file read so far.
        note: Called with the byte's number and the reason for each damaged place.
    """

    def __init__(self, source: LogSource, position: int, note: Callable[[int, str], None]) -> None:
        self._source = source
        self.position = position
        self._note = note
        self._ahead = b""
        self._tail = b""
        self._cut = self._is_broken_off = False
        self._idle_bytes = 0

    def pieces(self) -> Iterator[bytes]:
        """Yield some whole objects at a time, without gaps between the pieces."""
        while (top := self._next_top()) is not None:
            place, kind, body = top
            if kind != blf.LOG_CONTAINER:
                yield from self._whole(body, place)
                continue
            for data in self._unpacked(body, place):
                yield from self._whole(data, place)
        if self._is_broken_off or self._tail.strip(b"\0"):
            # Noted once: a container that is cut also leaves a cut object behind.
            self._note(self.position, self._source.broken or Told("the file breaks off here"))

    def _take(self, size: int) -> bytes:
        if len(self._ahead) < size:
            self._ahead += self._source.read(size - len(self._ahead))
        data, self._ahead = self._ahead[:size], self._ahead[size:]
        self.position += len(data)
        return data

    def _next_top(self) -> tuple[int, int, bytes] | None:
        """Return place, type and bytes of the next object; a container's without its head."""
        while True:
            place = self.position
            head = self._take(_BASE.size)
            if len(head) < _BASE.size:
                if head.strip(b"\0") or self._source.broken:
                    self._is_broken_off = True
                return None
            signature, _header_size, _version, size, kind = _BASE.unpack(head)
            if signature != _SIGNATURE or not _BASE.size <= size <= _LARGEST:
                if not self._find_next(place, head):
                    return None
                continue
            body = self._take(size - _BASE.size)
            if len(body) < size - _BASE.size:
                self._is_broken_off = True
            else:
                self._take(size % 4)
            return place, kind, body if kind == blf.LOG_CONTAINER else head + body

    def _find_next(self, place: int, head: bytes) -> bool:
        """Skip to the next place with an object's signature; return whether there is one."""
        self._ahead = head[1:] + self._ahead
        self.position -= len(head) - 1
        skipped = head[:1]
        while (found := self._ahead.find(_SIGNATURE)) < 0:
            more = self._source.read(_PIECE)
            if not more:
                self._lose_thread()
                self._note(place, Told("no object begins here, and none follows"))
                return False
            gone = max(len(self._ahead) - len(_SIGNATURE) + 1, 0)
            skipped += self._ahead[: max(_PADDING + 1 - len(skipped), 0)]
            self.position += gone
            self._ahead = self._ahead[gone:] + more
        skipped += self._ahead[:found]
        self.position += found
        self._ahead = self._ahead[found:]
        if len(skipped) > _PADDING or skipped.strip(b"\0"):
            self._lose_thread()
            reason = Told("damaged here; the next object begins at byte {byte}", byte=self.position)
            self._note(place, reason)
        return True

    def _unpacked(self, body: bytes, place: int) -> Iterator[bytes]:
        """Return the content of a container, as far as it can be unpacked."""
        if len(body) < _CONTAINER.size:
            return
        method, _size = _CONTAINER.unpack_from(body)
        packed = memoryview(body)[_CONTAINER.size :]
        if method == blf.NO_COMPRESSION:
            yield bytes(packed)
            return
        if method != blf.ZLIB_DEFLATE:
            self._note(place, Told("packed by the unknown method {method}", method=method))
            self._lose_thread()
            return
        unpacker = zlib.decompressobj()
        try:
            for start in range(0, len(packed), _PACKED_PIECE):
                piece: bytes | memoryview = packed[start : start + _PACKED_PIECE]
                while piece:
                    yield unpacker.decompress(piece, _PIECE)
                    piece = unpacker.unconsumed_tail
                    if self._idle_bytes > _PATIENT_BYTES:
                        return
        except zlib.error as error:
            self._note(place, Told("damaged here ({error})", error=str(error)))
            self._lose_thread()

    def _lose_thread(self) -> None:
        """Forget a partly read object: the next bytes may begin in the middle of another one."""
        self._tail = b""
        self._cut = True
        self._idle_bytes = 0

    def _whole(self, data: bytes, place: int) -> Iterator[bytes]:
        """Return the whole objects in data that follow on the tail of what was there before."""
        data = self._tail + data
        self._tail = b""
        if self._cut:
            data = self._behind_damage(data)
        pos = run = 0
        unpack = _BASE.unpack_from
        while True:
            begin = data.find(_SIGNATURE, pos, pos + _PADDING + 1)
            if begin < 0:
                if len(data) - pos <= _PADDING:
                    break
                yield data[run:pos]
                begin = data.find(_SIGNATURE, pos)
                self._note(place, Told("what this part of the file holds is damaged"))
                if begin < 0:
                    self._lose_thread()
                    return
                run = pos = begin
            if len(data) - begin < _BASE.size:
                break
            _signature, _header_size, version, size, kind = unpack(data, begin)
            if not _BASE.size <= size <= _LARGEST:
                yield data[run:pos]
                reason = Told("an object in this part of the file claims {size} bytes", size=size)
                self._note(place, reason)
                run = pos = begin + 1
                continue
            if begin + size > len(data):
                break
            least = _HEADERS.get(version, 0) + _BODIES.get(kind, -_LARGEST)
            if size < least:
                yield data[run:pos]
                yield from self._completed(data[begin : begin + size], least, place)
                run = begin + size
            pos = begin + size
        yield data[run:pos]
        self._tail = data[pos:]

    def _behind_damage(self, data: bytes) -> bytes:
        """Return the data from the next object's signature on; nothing if there is none."""
        begin = data.find(_SIGNATURE)
        if begin < 0:
            self._idle_bytes += len(data)
            return b""
        self._cut = self._is_broken_off = False
        self._idle_bytes = 0
        return data[begin:]

    def _completed(self, shortened: bytes, least: int, place: int) -> Iterator[bytes]:
        """Return an object with the unused bytes it was cut by; nothing if more lacks."""
        signature, header_size, version, size, kind = _BASE.unpack_from(shortened)
        if least - size <= _SPARED.get(kind, -1):
            head = _BASE.pack(signature, header_size, version, least, kind)
            yield head + shortened[_BASE.size :].ljust(least - _BASE.size, b"\0")
        else:
            reason = Told(
                "an object in this part of the file has {size} bytes, not {least}",
                size=size,
                least=least,
            )
            self._note(place, reason)


def container(objects: bytes) -> bytes:
    """Return objects as an uncompressed container."""
    size = _BASE.size + _CONTAINER.size + len(objects)
    head = _BASE.pack(_SIGNATURE, _BASE.size, 1, size, blf.LOG_CONTAINER)
    return head + _CONTAINER.pack(blf.NO_COMPRESSION, len(objects)) + objects + bytes(size % 4)


class _Feed:
    """The stream that python-can's reader reads: a header and containers, all of them whole."""

    def __init__(self, header: bytes, pieces: Iterator[bytes]) -> None:
        self._header = header
        self._pieces = pieces
        self._waiting = memoryview(header)

    def read(self, size: int) -> bytes:
        """Return the next bytes, like a file."""
        while not self._waiting and size > 0:
            objects = next(self._pieces, None)
            if objects is None:
                return b""
            if objects:
                self._waiting = memoryview(container(objects))
        data, self._waiting = self._waiting[: max(size, 0)], self._waiting[max(size, 0) :]
        return bytes(data)

    def restart(self) -> None:
        """Drop the rest of the container, and begin again with the header."""
        self._waiting = memoryview(self._header)

    def close(self) -> None:
        """Do nothing: the reader calls this at its end, but the file belongs to its opener."""


def read_blf_log(source: LogSource, builder: BatchBuilder) -> Iterator[FrameBatch]:
    """Yield the frames of a log, in order.

    Objects other than CAN frames are skipped. Frames outside of a container are read as well.

    Args:
        source: The file.
        builder: Builds the batches, and notes what cannot be read.

    Raises:
        NotALogError: The file does not begin as a log of this format.
    """
    header = source.read(_HEADER.size)
    if len(header) < _HEADER.size or not header.startswith(b"LOGG"):
        raise NotALogError(Told("no CAN log: it does not begin as a BLF file"))
    builder.header_seen = True
    (header_size,) = struct.unpack_from("<L", header, _HEADER_SIZE_AT)
    rest = header_size - _HEADER.size
    skipped = source.read(rest) if 0 < rest <= _LARGEST_HEADER else b""
    gathered: list[can.Message] = []

    def note(byte: int, reason: str) -> None:
        count = builder.frames + len(gathered)
        place = Told("byte {byte}", byte=byte)
        told = Told("{reason}, after {count} frames", reason=reason, count=count)
        builder.note(place, told, len(gathered))

    def place(index: int) -> str:
        return Told("frame {frame}", frame=builder.frames + index + 1)

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
            note(objects.position, Told("damaged here ({error})", error=error_text(error)))
            feed.restart()
            messages = iter(can.BLFReader(cast("BinaryIO", feed)))
            continue
        gathered.append(message)
        if len(gathered) >= _ROWS:
            yield builder.batch(gathered, place)
            gathered.clear()
    if gathered:
        yield builder.batch(gathered, place)
