"""Memory that two processes share."""

import os
import subprocess
import sys
from multiprocessing.shared_memory import SharedMemory
from pathlib import Path
from types import SimpleNamespace

import pytest

from armui.viewport import frame_memory
from armui.viewport.frame_memory import SLOTS, FrameMemory


def test_what_one_writes_the_other_reads_and_slots_do_not_overlap():
    memory = FrameMemory.create(1000)
    other = FrameMemory.attach(memory.name)
    for number in range(SLOTS):
        memory.slot(number, 1000)[:] = bytes([number + 1]) * 1000
    for number in range(SLOTS):
        assert bytes(other.slot(number, 1000)) == bytes([number + 1]) * 1000
    memory.unlink_name()
    memory.unlink_name()
    with pytest.raises(FileNotFoundError):
        SharedMemory(memory.name.name)
    assert other.slot(2, 1)[0] == 3  # without a name it is there until both have let go


def test_a_size_is_kept_while_it_suits():
    memory = FrameMemory.create(3_000_000)
    memory.unlink_name()
    assert memory.suits(3_000_000)
    assert memory.suits(1_000_000)
    assert not memory.suits(memory.slot_bytes + 1)
    assert not memory.suits(100_000)


def test_more_than_there_is_is_refused(monkeypatch):
    room = SimpleNamespace(f_blocks=1, f_bavail=10, f_frsize=4096)
    monkeypatch.setattr(os, "statvfs", lambda _path: room, raising=False)
    monkeypatch.setattr(frame_memory, "_PLACE", Path("/"))
    with pytest.raises(OSError, match="shared memory"):
        FrameMemory.create(1_000_000)


def test_its_end_is_silent():
    code = (
        "from armui.viewport.frame_memory import FrameMemory; "
        "memory = FrameMemory.create(1000); memory.slot(0, 10)[:] = bytes(10); "
        "memory.unlink_name()"
    )
    ended = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert ended.stderr == ""
