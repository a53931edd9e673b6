"""Values between two processes: large arrays travel as a file that the receiver maps.

Copying two hours of samples through a pipe holds Python's lock for tens of milliseconds at a
stretch, in which no button is heard. Writing them to a file and mapping it holds it for none.
"""

from __future__ import annotations

import contextlib
import mmap
import pickle
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from armui.system.files import open_file

LARGE_BYTES: Final = 1 << 18
"""Arrays of this size and more go into the file."""

_ALIGNED: Final = 64


@dataclass(frozen=True, slots=True)
class Packed:
    """A value on its way.

    Attributes:
        data: Everything but its large arrays.
        path: The file that holds those; the receiver removes it. ``None`` where there are none.
        spans: Where each begins in the file, and how many bytes it has.
    """

    data: bytes
    path: Path | None = None
    spans: tuple[tuple[int, int], ...] = ()


def pack(value: object, folder: Path) -> Packed:
    """Make a value ready to be sent.

    Args:
        value: Anything that can be pickled.
        folder: Where its large arrays may be written.

    Raises:
        OSError: They were not written.
    """
    large: list[memoryview] = []

    def is_small(buffer: pickle.PickleBuffer) -> bool:
        raw = buffer.raw()
        if raw.nbytes < LARGE_BYTES:
            return True
        large.append(raw)
        return False

    data = pickle.dumps(value, protocol=5, buffer_callback=is_small)
    if not large:
        return Packed(data)
    spans: list[tuple[int, int]] = []
    with tempfile.NamedTemporaryFile(dir=folder, delete=False) as file:
        for raw in large:
            begin = -(-file.tell() // _ALIGNED) * _ALIGNED
            file.seek(begin)
            file.write(raw)
            spans.append((begin, raw.nbytes))
    return Packed(data, Path(file.name), tuple(spans))


def unpack(packed: Packed) -> Any:
    """The value. Changes of its arrays are seen by nobody else.

    Raises:
        OSError: The file of its large arrays is gone.
    """
    if packed.path is None:
        return pickle.loads(packed.data)  # noqa: S301 - from our own process
    with open_file(packed.path) as file:
        whole = memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_COPY))
    # Windows removes no file that is mapped: there it goes with its folder
    with contextlib.suppress(OSError):
        packed.path.unlink()
    buffers = [whole[begin : begin + length] for begin, length in packed.spans]
    return pickle.loads(packed.data, buffers=buffers)  # noqa: S301 - as above


def call_packed(packed: Packed, folder: Path) -> Packed:
    """In the other process: call what was sent, send back what comes of it."""
    function, args, kwargs = unpack(packed)
    return pack(function(*args, **kwargs), folder)
