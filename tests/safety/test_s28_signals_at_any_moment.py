"""S28: a signal at any moment of a start, and in every command without a window, ends it well.

Within a second, with all processes it has begun, without a traceback, and no file is half written.
"""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import can
import pytest

from armui.session.recording.recorded_session import RecordedSession
from tests.examples import sample
from tests.posix import HANG_UP, kill

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="sends signals, reads /proc"),
    pytest.mark.timeout(150),
]

ROOT = Path(__file__).resolve().parents[2]
LONGEST_S = 1.0
BUSY_COMPUTER_S = 4.0
"""What a computer that runs other tests beside may add; what hangs takes longer."""
COUNTED_S = 5.0
"""A recording is whole at once; then what it tells is counted, for which numpy is loaded."""
BEGINS_WITHIN_S = 60.0
SIGNALS = (signal.SIGTERM, HANG_UP, signal.SIGINT)
MOMENTS_S = (0.03, 0.1, 0.2, 0.3, 0.45, 0.6, 0.8, 1.0, 1.2, 1.4, 1.7, 2.0, 2.5, 3.0)
"""From the start of the process: Python itself, imports, Qt, the window, the bus."""


def processes_of(session: int) -> list[int]:
    """Which processes live in a session of the system's."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _parent, _group, its_session = stat.read_text().rpartition(")")[2].split()[:4]
        except OSError:  # it has ended meanwhile
            continue
        if int(its_session) == session and state != "Z":
            found.append(int(stat.parent.name))
    return found


class Program:
    """`armui` with some words, in a session of its own."""

    def __init__(self, folder: Path, *words: str) -> None:
        own = ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_RUNTIME_DIR")
        self.process = subprocess.Popen(
            [sys.executable, "-m", "armui", *words],
            env={
                **os.environ,
                **dict.fromkeys(own, str(folder)),
                "QT_QPA_PLATFORM": "offscreen",
                "PYTHONPATH": str(ROOT),
            },
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # noqa: PLW1509 - no lock in it
        )

    def wait_for(self, condition) -> None:
        until_s = time.monotonic() + BEGINS_WITHIN_S
        while not condition():
            assert time.monotonic() < until_s
            assert self.process.poll() is None, self.process.communicate()
            time.sleep(0.02)

    def end(
        self, by: signal.Signals, times: int = 1, within_s: float = LONGEST_S
    ) -> tuple[int, str, str]:
        """Its exit code and what it has said, after one signal or more."""
        began_s = time.monotonic()
        for _ in range(times):
            self.process.send_signal(by)
            time.sleep(0.05)
        try:
            out, err = self.process.communicate(timeout=15.0)
            while left := processes_of(self.process.pid):
                assert time.monotonic() < began_s + within_s + BUSY_COMPUTER_S, left
                time.sleep(0.02)
        finally:
            for process in processes_of(self.process.pid):
                kill(process)
        gone_s = time.monotonic() - began_s
        print(f"{by.name}: ended with {self.process.returncode} after {gone_s:.2f} s")
        assert gone_s < within_s + BUSY_COMPUTER_S
        # until the first line of the program is run, Ctrl-C has Python itself answer
        assert not re.search(r"cli\.py\W+line \d+, in main\n", err), err
        return self.process.returncode, out, err


CASES = [(at_s, by, times) for at_s in MOMENTS_S for by in SIGNALS for times in (1, 2)]
AT_ONCE = [(0.2, signal.SIGINT, 1), (0.8, signal.SIGINT, 1), (1.2, signal.SIGINT, 2)]
"""Python's own answer to Ctrl-C was a traceback, an abort, or was lost in Qt."""


@pytest.mark.parametrize(("at_s", "by", "times"), [*AT_ONCE, *sample(CASES, 2)])
def test_a_start_is_ended_at_any_moment(tmp_path, at_s, by, times):
    program = Program(tmp_path, "--sim")
    time.sleep(at_s)
    code, _out, _err = program.end(by, times)
    assert code in {-by, 128 + by}  # one exit code in a shell
    for path in tmp_path.rglob("*.json"):
        json.loads(path.read_text())


@pytest.mark.parametrize(("by", "times"), sample([(by, n) for by in SIGNALS for n in (1, 2)], 1))
def test_a_replay_is_ended(tmp_path, by, times):
    log = tmp_path / "a.log"
    log.write_text("(1.0) can0 2A5#0000000000000000\n" * 300_000)
    program = Program(tmp_path, "replay", str(log))
    time.sleep(2.0)
    code, _out, _err = program.end(by, times)
    assert code in {-by, 128 + by}


@pytest.mark.parametrize("by", sample(SIGNALS, 2))
def test_a_simulated_arm_is_ended(tmp_path, by):
    flash = tmp_path / "flash.json"
    program = Program(tmp_path, "sim", "--interface", "virtual", "--flash", str(flash))
    assert program.process.stdout is not None
    assert "Ctrl-C ends it" in program.process.stdout.readline()
    code, _out, _err = program.end(by)
    assert code == 0


def recording(folder: Path) -> Program:
    """A simulated arm is being recorded."""
    program = Program(folder, "record", "--sim", "-o", str(folder), "--name", "run")
    path = folder / "run.blf"
    program.wait_for(lambda: path.exists() and path.stat().st_size > 3000)
    return program


@pytest.mark.parametrize(("by", "times"), sample([(by, n) for by in SIGNALS for n in (1, 2)], 3))
def test_a_recording_is_finished(tmp_path, by, times):
    code, out, err = recording(tmp_path).end(by, times, COUNTED_S)
    assert code == 0, err
    assert "run.blf" in out
    session = RecordedSession(tmp_path / "run.blf")
    assert session.frames > 0
    assert "end" in [line["kind"] for line in session.lines]


@pytest.mark.parametrize("by", sample(SIGNALS, 1))
@pytest.mark.parametrize("at_s", sample([0.05, 0.2, 0.4, 0.6, 0.9], 2))
@pytest.mark.parametrize("command", ["record", "export", "decode", "doctor"])
def test_a_command_that_begins_is_ended(tmp_path, command, at_s, by):
    log = tmp_path / "a.blf"
    with can.BLFWriter(log) as writer:
        for number in range(20_000):
            writer(can.Message(timestamp=1e9 + number / 1e3, arbitration_id=0x2A5, data=bytes(8)))
    words = {
        "record": ("--sim", "-o", str(tmp_path)),
        "export": (str(log), "-o", str(tmp_path / "a.csv")),
        "decode": (str(log),),
        "doctor": (),
    }
    program = Program(tmp_path, command, *words[command])
    time.sleep(at_s)
    code, _out, _err = program.end(by)
    assert code in {-by, 128 + by, 130, 0, 1}
    assert [path for path in tmp_path.rglob("*") if "armui-" in path.name] == []
