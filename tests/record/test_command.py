"""`armui record`: a bus into a file, without a window; its end, its words, its exit code."""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import threading
import time

import can
import pytest
from can.interfaces.virtual import VirtualBus

from armui import record
from armui.protocol.frame import FrameFlag
from armui.record.listening import BusListener
from armui.record.record_command import EXIT_CANNOT_BEGIN, EXIT_CUT_SHORT, EXIT_OK
from armui.session.recording.folder import list_recordings
from armui.session.recording.recorded_session import RecordedSession
from tests.session.recording.made import all_of
from tests.session.recording.test_disk import FullDisk

SAID = [
    can.Message(arbitration_id=0x2A1, data=bytes(8), is_extended_id=False),
    can.Message(arbitration_id=0x18FEF100, data=b"\x01\x02", is_extended_id=True),
    can.Message(arbitration_id=0x123, is_remote_frame=True, dlc=4, is_extended_id=False),
    can.Message(arbitration_id=0x80, data=bytes(8), is_error_frame=True, is_extended_id=False),
    can.Message(arbitration_id=0x321, data=bytes(64), is_fd=True, bitrate_switch=True,
                is_extended_id=False),
]  # fmt: skip


def ended(session):
    """How it ended: behind that stands only what was counted."""
    *_, end, counted = session.lines
    assert (end["kind"], counted["kind"]) == ("end", "counted")
    return end


def run(*words: str) -> int:
    parser = argparse.ArgumentParser()
    record.add_arguments(parser)
    return record.run(parser.parse_args(list(words)))


class Talker(threading.Thread):
    """Says the same on a virtual bus until it is ended."""

    def __init__(self, channel):
        super().__init__(daemon=True)
        self.bus = VirtualBus(channel)
        self.ending = threading.Event()

    def run(self):
        while not self.ending.wait(0.01):
            for message in SAID:
                self.bus.send(message)

    def end(self):
        self.ending.set()
        self.join()
        self.bus.shutdown()


@pytest.fixture
def channel(request):
    talker = Talker(request.node.name)
    talker.start()
    yield request.node.name
    talker.end()


@pytest.mark.parametrize("suffix", ["blf", "asc", "log"])
def test_every_sort_of_frame_is_recorded(tmp_path, channel, capsys, suffix):
    words = ["--interface", "virtual", "--channel", channel, "-o", str(tmp_path), "--name", "run"]
    assert run(*words, "--format", suffix, "--duration", "0.6") == EXIT_OK

    path = tmp_path / f"run.{suffix}"
    assert str(path) in capsys.readouterr().out
    session = RecordedSession(path)
    sorts = {int(each.flags) & ~FrameFlag.EXTENDED for each in all_of(session)}
    assert sorts == {0, FrameFlag.REMOTE, FrameFlag.ERROR, FrameFlag.FD | FrameFlag.BITRATE_SWITCH}
    extended = {each.frame.arbitration_id for each in all_of(session)} & {0x18FEF100}
    assert extended
    assert ended(session)["reason"] == "duration"


@pytest.mark.parametrize("asked", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_it_well(tmp_path, channel, asked):
    before = signal.getsignal(asked)
    timer = threading.Timer(0.8, os.kill, (os.getpid(), asked))
    timer.start()
    words = ["--interface", "virtual", "--channel", channel, "-o", str(tmp_path), "--name", "run"]
    assert run(*words) == EXIT_OK
    timer.join()
    assert signal.getsignal(asked) is before
    session = RecordedSession(tmp_path / "run.blf")
    assert ended(session)
    assert session.frames > 0


def test_a_full_disk_ends_it_with_a_word_and_a_code(tmp_path, channel, capsys, monkeypatch):
    FullDisk(monkeypatch, 50_000)
    words = ["--interface", "virtual", "--channel", channel, "-o", str(tmp_path), "--name", "run"]
    assert run(*words, "--format", "log", "--duration", "30") == EXIT_CUT_SHORT
    monkeypatch.undo()
    assert "The disk of" in capsys.readouterr().err
    assert RecordedSession(tmp_path / "run.log").frames > 0


def test_a_device_that_goes_ends_it_with_a_word_and_a_code(tmp_path, channel, capsys, monkeypatch):
    listen, heard = BusListener.listen, []

    def gone(listener):
        listen(listener)
        heard.append(listener.frames)
        if listener.frames > 100:
            raise can.CanOperationError("unplugged")

    monkeypatch.setattr(BusListener, "listen", gone)
    words = ["--interface", "virtual", "--channel", channel, "-o", str(tmp_path), "--name", "run"]
    assert run(*words) == EXIT_CUT_SHORT
    assert "is gone: unplugged" in capsys.readouterr().err
    assert RecordedSession(tmp_path / "run.blf").frames == heard[-1]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "name the bus"),
        (["--sim", "--interface", "virtual"], "leave out --interface"),
        (["--sim", "--name", "a/b"], "is no name"),
        (["--interface", "no_such", "--channel", "x"], "needs a Python package"),
    ],
)
def test_what_cannot_begin_says_why(capsys, words, said):
    assert run(*words) == EXIT_CANNOT_BEGIN
    assert said in capsys.readouterr().err


@pytest.mark.parametrize("words", [["--size", "0"], ["--duration", "-1"], ["--format", "mp3"]])
def test_options_out_of_range(words, capsys):
    with pytest.raises(SystemExit):
        run("--sim", *words)
    assert "error" in capsys.readouterr().err


def test_a_folder_that_cannot_be_written(tmp_path, channel, capsys):
    (tmp_path / "file").write_text("")
    words = ["--interface", "virtual", "--channel", channel, "-o", str(tmp_path / "file" / "x")]
    assert run(*words) == EXIT_CANNOT_BEGIN
    assert "armui record: " in capsys.readouterr().err


def test_the_simulated_arm_in_a_process_of_its_own_without_qt(tmp_path):
    """As a user starts it; Ctrl-C ends it."""
    code = (
        "import sys; from armui.cli import main; code = main(sys.argv[1:]); "
        "assert not [name for name in sys.modules if name.startswith('PySide6')]; sys.exit(code)"
    )
    command = [sys.executable, "-c", code, "record", "--sim", "-o", str(tmp_path), "--name", "arm"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    side = tmp_path / "arm.blf"
    until_s = time.monotonic() + 50.0
    while not (side.exists() and side.stat().st_size > 3000):
        assert time.monotonic() < until_s, process.communicate()
        assert process.poll() is None, process.communicate()
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert process.returncode == EXIT_OK, err
    assert str(side) in out
    session = RecordedSession(side)
    assert {each.frame.arbitration_id for each in all_of(session)} >= {0x2A1, 0x2A5, 0x2A6, 0x2A7}
    assert json.loads((tmp_path / "arm.armui.jsonl").read_text("utf-8").splitlines()[0])["device"]


def test_its_faults_are_counted_when_it_ends(tmp_path, capsys):
    assert run("--sim", "-o", str(tmp_path), "--name", "arm", "--duration", "1.5") == EXIT_OK
    (entry,) = list_recordings(tmp_path)
    assert (entry.faults, entry.stops, entry.ended) == (0, 0, True)
    assert not capsys.readouterr().err
