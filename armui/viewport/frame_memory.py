"""Memory that two processes share, so that finished images are passed without a copy.

It holds three images: one on the screen, one waiting, one being drawn. Its name is removed as soon
as both processes have opened it; from then on the memory is freed with the last of them, however
they end.
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
    """Shared memory for three images; closed with the last reference to it.

    An image made of a slot keeps no reference: keep the memory as long as the image is shown.

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
        """Return new memory for images of a size, rounded up.

        Raises:
            OSError: there is not enough shared memory; using it would end the process.
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
        """Return whether images of a size fit without wasting most of the memory."""
        enough = image_bytes <= self.slot_bytes
        return enough and self.slot_bytes <= max(_TOO_LARGE * image_bytes, _ROUND_UP_BYTES)

    def slot(self, number: int, image_bytes: int) -> memoryview:
        """Return the bytes of one image; release them before the memory."""
        start = number * self.slot_bytes
        whole = self._memory.buf
        if whole is None:
            raise ValueError("the memory is closed")
        return whole[start : start + image_bytes]

    def unlink_name(self) -> None:
        """Remove the name once both processes have opened the memory; may be called twice."""
        if self._is_named:
            self._is_named = False
            with contextlib.suppress(FileNotFoundError):
                # Python has removed the name already if the other process failed to open the memory
                self._memory.unlink()


def _check_room(size_bytes: int) -> None:
    """Raise OSError if too little is free: Linux would grant it, and kill who writes to it."""
    if sys.platform != "win32" and _PLACE.is_dir():
        room = os.statvfs(_PLACE)
        if room.f_blocks and room.f_bavail * room.f_frsize < size_bytes:
            text = f"{size_bytes >> 20} MB of shared memory wanted in {_PLACE}"
            raise OSError(errno.ENOSPC, text)
