"""What Windows does otherwise, emulated: a refused replacement, throttled timers."""

import ctypes
import gc
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from armui.system.atomic import write_whole
from armui.system.helper_process import pack, unpack
from armui.system.scratch import lives_on_windows
from armui.system.thread_priority import PowerThrottling, end_throttling
from armui.viewport import process_link


class Scanner:
    """Holds a file so that its replacement is refused some times."""

    def __init__(self, monkeypatch, refusals):
        self.left = refusals
        self.slept_s: list[float] = []
        replace = Path.replace

        def refused(path, target):
            if self.left:
                self.left -= 1
                raise PermissionError(13, "Access is denied", str(target))
            return replace(path, target)

        monkeypatch.setattr(Path, "replace", refused)
        monkeypatch.setattr(time, "sleep", self.slept_s.append)


def test_a_save_outlasts_the_moment_of_a_virus_scanner(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "platform", "win32")
    path = tmp_path / "a"
    path.write_bytes(b"old")
    scanner = Scanner(monkeypatch, 3)

    write_whole(path, b"new", to_disk=False)

    assert path.read_bytes() == b"new"
    assert scanner.slept_s == [0.01, 0.02, 0.04]


def test_a_save_that_stays_refused_is_told_within_half_a_second(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "platform", "win32")
    path = tmp_path / "a"
    path.write_bytes(b"old")
    scanner = Scanner(monkeypatch, 1000)

    with pytest.raises(PermissionError):
        write_whole(path, b"new", to_disk=False)

    assert path.read_bytes() == b"old"
    assert [each.name for each in tmp_path.iterdir()] == ["a"]
    assert sum(scanner.slept_s) == pytest.approx(0.5)


def test_elsewhere_a_refusal_is_meant(tmp_path, monkeypatch):
    monkeypatch.setattr(sys, "platform", "linux")
    scanner = Scanner(monkeypatch, 1)

    with pytest.raises(PermissionError):
        write_whole(tmp_path / "a", b"new", to_disk=False)

    assert scanner.slept_s == []


def test_windows_is_told_to_keep_the_timers():
    told = []

    class Kernel:
        def SetProcessInformation(self, process, kind, state, size):  # noqa: N802 - its name
            content = ctypes.cast(state, ctypes.POINTER(PowerThrottling)).contents
            told.append((process, kind, bytes(content), size))
            return 1

    assert end_throttling(Kernel(), 7)
    assert told == [(7, 4, bytes.fromhex("01000000 05000000 00000000"), 12)]


def test_what_is_sent_without_a_limit_fits_into_a_pipe_of_windows():
    assert process_link._SMALL_BYTES < 8_192


class Processes:
    """What kernel32 tells of processes: number to what waiting for its end answers."""

    def __init__(self, waits):
        self.waits = waits
        self.closed: list[object] = []

    def OpenProcess(self, rights, _inherits, number):  # noqa: N802 - its name
        assert rights == 0x100000
        return number if number in self.waits else 0

    def WaitForSingleObject(self, handle, limit_ms):  # noqa: N802 - its name
        assert limit_ms == 0
        return self.waits[handle.value]

    def CloseHandle(self, handle):  # noqa: N802 - its name
        self.closed.append(handle.value)


@pytest.mark.parametrize(
    ("number", "error", "lives"),
    [(11, 0, True), (12, 0, False), (13, 87, False), (14, 5, True)],
    ids=["running", "ended", "unknown", "another user's"],
)
def test_whether_a_process_of_windows_lives_is_asked_without_ending_it(number, error, lives):
    kernel = Processes({11: 0x102, 12: 0})
    assert lives_on_windows(kernel, number, lambda: error) is lives
    assert kernel.closed == [number] * (number in kernel.waits)


def test_a_file_that_cannot_be_removed_while_it_is_mapped_is_removed_later(tmp_path, monkeypatch):
    sent = pack(np.arange(100_000), tmp_path)
    (file,) = tmp_path.iterdir()
    with monkeypatch.context() as windows:
        windows.setattr(Path, "unlink", raising(PermissionError(13, "it is mapped")))
        arrived = unpack(sent)
    assert file.exists()
    assert arrived[99_999] == 99_999
    del arrived
    gc.collect()
    assert not file.exists()


def raising(error):
    """Something that fails, whatever it is asked."""

    def fail(*_args, **_more):
        raise error

    return fail
