"""Reads the bytes of a log: opens, unpacks and counts them, with no more than a block in memory."""

from __future__ import annotations

import gzip
import io
import os
import zlib
from typing import IO, TYPE_CHECKING, cast

from armui.session.frames import NotALogError
from armui.system.files import error_text, open_file, open_stream
from armui.system.sentence import Told

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

_BLOCK = 1 << 18
_LONGEST_LINE = 16_384
READ_ERRORS = (OSError, EOFError, zlib.error)
"""The exceptions of reading a damaged or vanished file."""


class LogSource:
    """An open file, read from its beginning to its end.

    Attributes:
        size: The size on the disk, 0 if not known (a pipe).
        taken: The bytes read so far, unpacked.
        broken: The reason why it could not be read to its end, "" if it could.
        is_pipe: True for a pipe: what comes through it cannot be read again.
        unended: True once the last line has been given, if it has no line end.
    """

    def __init__(self, log: Path | bytes, *, pipes: bool = False) -> None:
        """Open a file.

        Args:
            log: The file, or its bytes.
            pipes: True to accept a pipe; opening one waits for its writer.

        Raises:
            NotALogError: It cannot be opened.
        """
        self._is_packed = False
        self._raw: IO[bytes]
        if isinstance(log, bytes):
            self._raw, self.size = io.BytesIO(log), len(log)
        else:
            try:
                self._raw = open_stream(log) if pipes else open_file(log)
                self.size = os.fstat(self._raw.fileno()).st_size
            except OSError as error:
                raise NotALogError(error_text(error)) from error
            self._is_packed = log.suffix.lower() == ".gz"
        self._stream: IO[bytes] = (
            cast("IO[bytes]", gzip.GzipFile(fileobj=self._raw)) if self._is_packed else self._raw
        )
        self.is_pipe = not self._raw.seekable()
        self._ahead = b""
        self.taken = 0
        self.broken = ""
        self.unended = False

    @property
    def position(self) -> int:
        """The bytes of the file on the disk that were read, for a progress bar."""
        return self.taken if self.is_pipe else self._raw.tell()

    def peek(self) -> bytes:
        """Return the first bytes of a pipe; they will be read again."""
        try:
            self._ahead = self._ahead or cast("io.BufferedReader", self._stream).read1(_BLOCK)
        except READ_ERRORS as error:
            self.broken = _reason(error)
        return self._ahead

    def read(self, size: int) -> bytes:
        """Return the next bytes, fewer at the end or where the file is damaged."""
        if self.broken or size <= 0:
            return b""
        data, self._ahead = self._ahead[:size], self._ahead[size:]
        rest = size - len(data)
        try:
            data += self._packed(rest) if self._is_packed else self._stream.read(rest)
        except READ_ERRORS as error:
            self.broken = _reason(error)
        self.taken += len(data)
        return data

    def _block(self) -> bytes:
        """Return the next block for lines; of a pipe what has come, at once."""
        if not self.is_pipe or self.broken:
            return self.read(_BLOCK)
        data, self._ahead = self.peek(), b""
        self.taken += len(data)
        return data

    def _packed(self, size: int) -> bytes:
        """Read from a packed file; where it breaks, keep what was unpacked before."""
        stream = cast("gzip.GzipFile", self._stream)
        pieces = []
        while size > 0:
            try:
                piece = stream.read1(size)
            except READ_ERRORS as error:
                self.broken = _reason(error)
                break
            if not piece:
                break
            pieces.append(piece)
            size -= len(piece)
        return b"".join(pieces)

    def close(self) -> None:
        """Close the file, and the stream that reads it."""
        self._stream.close()
        self._raw.close()

    def lines(self, encoding: str = "utf-8") -> Iterator[list[str]]:
        """Yield blocks of stripped lines, blank ones included; an overlong line is truncated.

        Only line ends separate lines, so that the numbers are those of an editor.

        Args:
            encoding: The assumed encoding of a block that is not UTF-8.
        """
        carry = b""
        dropping = False
        first = True
        while block := self._block():
            *whole, rest = block.split(b"\n")
            if whole:
                if not dropping:
                    whole[0] = carry + whole[0]
                else:
                    whole[0] = carry
                carry, dropping = rest, False
            elif not dropping:
                carry += rest
            if len(carry) > _LONGEST_LINE:
                carry, dropping = carry[:_LONGEST_LINE], True
            yield self._texts(whole, encoding, first=first)
            first = first and not whole
        if carry:
            self.unended = True
            yield self._texts([carry], encoding, first=first)

    @staticmethod
    def _texts(lines: list[bytes], encoding: str, *, first: bool) -> list[str]:
        if first and lines:
            lines[0] = lines[0].removeprefix(b"\xef\xbb\xbf")
        joined = b"\n".join([line[:_LONGEST_LINE] for line in lines])
        try:
            text = joined.decode()
        except UnicodeDecodeError:
            text = joined.decode(encoding, "replace")
        return [line.strip() for line in text.split("\n")] if lines else []


def _reason(error: BaseException) -> Told:
    if isinstance(error, OSError) and error.strerror:
        return error_text(error)
    return Told("what is packed in it is damaged")
