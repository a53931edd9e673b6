"""What Windows and macOS do otherwise, emulated: refused replacements, throttled timers."""

import ctypes
import errno
import gc
import io
import logging
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QObject, Signal

from armui import app
from armui.control.link.link_state import LinkState
from armui.control.operating_state import OperatingState
from armui.doctor.probes import screen
from armui.system import command_line, command_process
from armui.system.atomic import write_whole
from armui.system.exact_timers import Activity, PowerThrottling, keep_on_windows
from armui.system.helper_process import pack, unpack
from armui.system.log_file import log_to
from armui.system.scratch import lives_on_windows
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


def test_windows_is_told_to_keep_the_timers_and_takes_them_back():
    told = []

    class Kernel:
        def SetProcessInformation(self, process, kind, state, size):  # noqa: N802 - its name
            content = ctypes.cast(state, ctypes.POINTER(PowerThrottling)).contents
            told.append((process, kind, bytes(content), size))
            return 1

    assert keep_on_windows(Kernel(), 7, kept=True)
    assert keep_on_windows(Kernel(), 7, kept=False)
    assert told == [
        (7, 4, bytes.fromhex("01000000 05000000 00000000"), 12),
        (7, 4, bytes.fromhex("01000000 00000000 00000000"), 12),
    ]


def test_macos_does_not_let_the_program_nap_while_a_device_is_open():
    told = []

    def send(receiver, message, *arguments):
        told.append((receiver, message, *arguments))
        return f"{message}'s"

    activity = Activity(send)
    for kept in (False, True, True, False, False):
        activity.keep(kept=kept)
    asked = [each for each in told if each[1] != "processInfo"]
    begun = "beginActivityWithOptions:reason:'s"
    why = ("NSString", "stringWithUTF8String:", b"A robot arm is connected")
    begin = ("processInfo's", "beginActivityWithOptions:reason:", 0xFF00EFFFFF)
    assert asked == [
        why,
        (*begin, "stringWithUTF8String:'s"),
        (begun, "retain"),
        ("processInfo's", "endActivity:", "retain's"),
        ("retain's", "release"),
    ]


@pytest.mark.parametrize("link", [each for each in LinkState if each is not LinkState.NO_DEVICE])
def test_the_timers_are_kept_only_while_a_device_is_open(qapp, monkeypatch, link):
    asked = []
    monkeypatch.setattr(app, "keep_timers", lambda *, kept: asked.append(kept))
    monkeypatch.setattr(app, "raise_in_background", lambda: None)
    controller: Any = Announcer()
    going_first = app._GoingFirst(qapp, controller)
    for each in (LinkState.NO_DEVICE, link, link, LinkState.NO_DEVICE):
        controller.operating_state_changed.emit(replace(OperatingState(), link=each))
    going_first.deleteLater()
    assert asked == [True, False]


class Announcer(QObject):
    """Tells how the program stands."""

    operating_state_changed = Signal(object)


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


class ClosedPipe(io.StringIO):
    """The output, once whoever read it on Windows has gone."""

    def flush(self):
        raise OSError(errno.EINVAL, "Invalid argument")


def test_an_output_that_nobody_reads_any_more_is_told_as_elsewhere(monkeypatch):
    monkeypatch.setattr(sys, "stdout", ClosedPipe())
    monkeypatch.setattr(sys, "platform", "win32")
    with pytest.raises(BrokenPipeError):
        command_line.write_out("a line\n")
    monkeypatch.setattr(sys, "platform", "linux")
    with pytest.raises(command_line.OutputError, match="Invalid argument"):
        command_line.write_out("a line\n")


@pytest.mark.parametrize(
    ("program", "command"),
    [("armui-window.exe", "armui.exe"), ("armui.exe", "armui.exe"), ("armui", "armui")],
)
def test_a_command_is_begun_by_the_program_whose_output_can_be_read(
    monkeypatch, tmp_path, program, command
):
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    monkeypatch.setattr(sys, "executable", str(tmp_path / program))
    assert command_process.this_program() == [str(tmp_path / command)]


def test_no_console_flashes_up_behind_the_window(monkeypatch):
    begun = []

    class Popen(subprocess.Popen[str]):
        def __init__(self, words, creationflags=0, **more):
            begun.append(creationflags)
            super().__init__(words, **more)

    monkeypatch.setattr(subprocess, "Popen", Popen)
    monkeypatch.setattr(command_process, "NO_CONSOLE", 0x08000000)
    monkeypatch.setattr(screen, "NO_CONSOLE", 0x08000000)
    heard = Listened(["--version"])
    assert heard.wait()
    screen._try("no such trial")
    assert begun == [0x08000000] * 2


class Listened(command_process.CommandProcess):
    """Reads what it says."""

    def __init__(self, words):
        super().__init__(words, lambda _answer: None)

    def _listen(self, process):
        process.communicate()


def test_two_programs_write_and_rotate_a_log_of_their_own_each(tmp_path):
    with log_to(tmp_path) as first:
        with log_to(tmp_path) as second:
            logging.getLogger("armui").warning("in both: both are of this process here")
        with log_to(tmp_path) as again:
            pass
    assert first == tmp_path / "armui.log"
    assert second == again == tmp_path / "armui-2.log"
    assert sorted(each.name for each in tmp_path.iterdir()) == ["armui-2.log", "armui.log"]
    with log_to(tmp_path) as next_one:
        assert next_one == first
