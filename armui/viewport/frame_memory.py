"""Memory that two processes share: finished images are handed over in it without a copy.

Three images fit: one on the screen, one that waits for it, one that is being drawn. The name is
taken away as soon as both processes have the memory open; from then on it is freed with the last
of them, however they end.
"""

from __future__ import annotations

import contextlib
import errno
import os
import sys
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path
from typing import Final

from armui.viewport.messages import MemoryName

SLOTS: Final = 3
_ROUND_UP_BYTES: Final = 1 << 20
_TOO_LARGE: Final = 4
_PLACE: Final = Path("/dev/shm")  # noqa: S108 - where Linux keeps shared memory; nothing is opened


class FrameMemory:
    """Three images' worth of shared memory; closed with the last reference to it.

    An image made of a slot keeps no reference: whoever shows one keeps the memory, too.

    Args:
        memory: Open shared memory of at least three slots.
        slot_bytes: Size of one slot.
    """

    def __init__(self, memory: SharedMemory, slot_bytes: int) -> None:
        self._memory = memory
        self.slot_bytes = slot_bytes
        self._is_named = True

    @classmethod
    def create(cls, image_bytes: int) -> FrameMemory:
        """Memory for images of a size, rounded up.

        Raises:
            OSError: there is not so much shared memory; using it would end the process.
        """
        slot_bytes = -(-max(image_bytes, 1) // _ROUND_UP_BYTES) * _ROUND_UP_BYTES
        _check_room(SLOTS * slot_bytes)
        name = f"armui-{os.getpid()}-{os.urandom(4).hex()}"
        return cls(SharedMemory(name, create=True, size=SLOTS * slot_bytes), slot_bytes)

    @classmethod
    def attach(cls, named: MemoryName) -> FrameMemory:
        """Return the memory that another process has created."""
        return cls(SharedMemory(named.name), named.slot_bytes)

    @property
    def name(self) -> MemoryName:
        """The name and size by which the other process opens it."""
        return MemoryName(self._memory.name, self.slot_bytes)

    def suits(self, image_bytes: int) -> bool:
        """Return whether images of a size fit, without most of the memory lying idle."""
        enough = image_bytes <= self.slot_bytes
        return enough and self.slot_bytes <= max(_TOO_LARGE * image_bytes, _ROUND_UP_BYTES)

    def slot(self, number: int, image_bytes: int) -> memoryview:
        """Return the bytes of one image; to be let go before the memory is."""
        start = number * self.slot_bytes
        whole = self._memory.buf
        if whole is None:
            raise ValueError("the memory is closed")
        return whole[start : start + image_bytes]

    def unlink_name(self) -> None:
        """Both processes have it open: nobody needs its name any more; may be called twice."""
        if self._is_named:
            self._is_named = False
            with contextlib.suppress(FileNotFoundError):
                # where opening it failed in the other process, Python took its name away there
                self._memory.unlink()


def _check_room(size_bytes: int) -> None:
    """Linux gives out shared memory that it does not have, and ends whoever writes to it."""
    if sys.platform != "win32" and _PLACE.is_dir():
        room = os.statvfs(_PLACE)
        if room.f_blocks and room.f_bavail * room.f_frsize < size_bytes:
            text = f"{size_bytes >> 20} MB of shared memory wanted in {_PLACE}"
            raise OSError(errno.ENOSPC, text)
