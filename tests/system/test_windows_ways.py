"""What Windows does otherwise, emulated: a refused replacement, throttled timers."""

import ctypes
import sys
import time
from pathlib import Path

import pytest

from armui.system.atomic import write_whole
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
