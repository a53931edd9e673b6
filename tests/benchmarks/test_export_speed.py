"""How long `armui export` takes, and how much memory, beside python-can's reader.

Whole processes over the same candump of a simulated arm, taking turns in one run. Run with
`python -m pytest tests/benchmarks/test_export_speed.py -s`; EXPORT_MINUTES changes how long the log
is. It fails when an export takes more than 300 MB, whatever the length of the log.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from armui.session.exports.request import ExportFormat
from tests.session.exports.logs import START_S, session

MINUTES = float(os.environ.get("EXPORT_MINUTES", "3"))
PIECE_S = 10.0
MOST_MB = 300
BARE = "import can, sys\nfor message in can.LogReader(sys.argv[1]): pass"

# a small process starts it: what the tests' own has in memory would count as its own
WATCHED = """
import os, subprocess, sys, time
began_s = time.monotonic()
process = subprocess.Popen(sys.argv[1:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
_pid, status, usage = os.wait4(process.pid, 0)
print(time.monotonic() - began_s, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024)
sys.exit(os.waitstatus_to_exitcode(status))
"""


@pytest.fixture(scope="module")
def candump(tmp_path_factory) -> Path:
    """Ten seconds of an arm over and over."""
    piece = [
        (at_s - START_S, f"can0 {frame.arbitration_id:03X}#{frame.data.hex().upper()}\n")
        for at_s, frame in session(PIECE_S)
    ]
    path = tmp_path_factory.mktemp("export") / "run.log"
    with path.open("w") as log:
        for turn in range(round(MINUTES * 60 / PIECE_S)):
            begin_s = START_S + turn * PIECE_S
            log.write("".join(f"({begin_s + at_s:.6f}) {text}" for at_s, text in piece))
    return path


def measured(command: list[str]) -> tuple[float, float, float]:
    """Seconds, seconds of processor time and MB at most of a whole process."""
    asked = subprocess.run(
        [sys.executable, "-c", WATCHED, sys.executable, *command],
        capture_output=True,
        check=True,
        cwd=Path(__file__).parents[2],
    )
    taken_s, processor_s, most_mb = map(float, asked.stdout.split())
    return taken_s, processor_s, most_mb


@pytest.mark.skipif(sys.platform != "linux", reason="measured by Linux's own means")
@pytest.mark.timeout(3600)
def test_in_bounded_memory(candump, capsys):
    results = {"bare can.LogReader": measured(["-c", BARE, str(candump)])}
    for kind in ExportFormat:
        target = str(candump.with_suffix(f".{kind}"))
        command = ["-m", "armui", "export", str(candump), "-o", target, "--force"]
        results[f"armui export --to {kind}"] = measured(command)
    with capsys.disabled():
        print(f"\n{MINUTES:g} minutes of an arm, {candump.stat().st_size / 1e6:.0f} MB of candump:")
        for name, (taken_s, processor_s, most_mb) in results.items():
            print(f"  {name}: {taken_s:.1f} s, processor {processor_s:.1f} s, {most_mb:.0f} MB")
    assert max(most_mb for *_times, most_mb in results.values()) < MOST_MB
