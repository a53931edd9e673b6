"""How long `armui decode` takes for a candump, beside `cantools decode` and python-can's reader.

Whole processes over the same file, which no frame's content repeats, taking turns in one run. Run
with `python -m pytest tests/benchmarks/test_decode_command.py -s`; DECODE_RUNS and DECODE_FRAMES
change what is measured. It fails when decode is not at least twice as fast as cantools.
"""

from __future__ import annotations

import os
import random
import resource
import statistics
import subprocess
import sys
from pathlib import Path

import pytest

from armui.protocol.codec import Codec
from armui.protocol.generation import Generation
from armui.protocol.layout import load_database
from armui.system.paths import RESOURCES
from tests.posix import of_system

RUNS = int(os.environ.get("DECODE_RUNS", "5"))
FRAMES = int(os.environ.get("DECODE_FRAMES", "200000"))
AIM = 2.0
LEFT_OUT = {"BusCurrent", "Angle"}
"""Without a sign; only there in place of the opening."""
BARE = "import can, sys\nfor message in can.LogReader(sys.argv[1]): pass"


@pytest.fixture(scope="module")
def candump(tmp_path_factory) -> Path:
    """What an arm of generation 2 sends, with content that differs from frame to frame."""
    draw = random.Random(1)
    codec = Codec(Generation.TWO)
    messages = [
        message
        for message in load_database(Generation.TWO).messages
        if message.cycle_time and not message.name.startswith("EndMotion")
    ]
    measured = {
        message.name: [
            signal
            for signal in codec.signals(message.name)
            if codec.unit(message.name, signal) in {"deg", "mm", "rad", "rad/s", "A", "N.m"}
            and signal not in LEFT_OUT
        ]
        for message in messages
    }
    path = tmp_path_factory.mktemp("decode") / "run.log"
    count, now_ms = 0, 0
    with path.open("w") as log:
        while count < FRAMES:
            due = [each for each in messages if now_ms % (each.cycle_time or 1) == 0]
            for place, each in enumerate(due[: FRAMES - count]):
                signals = {signal: draw.uniform(-20, 20) for signal in measured[each.name]}
                frame = codec.encode(each.name, **signals)
                time_s = 1_700_000_000 + now_ms / 1000 + place * 0.00012
                log.write(f"({time_s:.6f}) can0 {frame.arbitration_id:03X}#{frame.data.hex()}\n")
            count += len(due)
            now_ms += 5
    return path


def processor_s(command: list[str], log: Path) -> float:
    """Processor time of a whole process; its output goes nowhere."""
    before = of_system("getrusage", resource)(of_system("RUSAGE_CHILDREN", resource))
    with log.open("rb") as stream:
        subprocess.run(
            [sys.executable, *command], stdin=stream, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, check=True, cwd=Path(__file__).parents[2],
        )  # fmt: skip
    after = of_system("getrusage", resource)(of_system("RUSAGE_CHILDREN", resource))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


@pytest.mark.timeout(900)
def test_twice_as_fast_as_cantools(candump, capsys):
    dbc = str(RESOURCES / "protocol" / "agx_gen2.dbc")
    contestants = {
        "armui decode": ["-m", "armui", "decode", str(candump)],
        "armui decode --json": ["-m", "armui", "decode", "--json", str(candump)],
        "cantools decode --single-line": ["-m", "cantools", "decode", "-s", dbc],
        "bare can.LogReader": ["-c", BARE, str(candump)],
    }
    taken_s: dict[str, list[float]] = {name: [] for name in contestants}
    for _round in range(RUNS):
        for name, command in contestants.items():
            taken_s[name].append(processor_s(command, candump))
    medians = {name: statistics.median(each) for name, each in taken_s.items()}
    theirs = medians["cantools decode --single-line"]
    with capsys.disabled():
        print(f"\n{FRAMES} frames of candump, processor time, median of {RUNS}:")
        for name, median in medians.items():
            print(f"  {name}: {median:.2f} s, {theirs / median:.1f} times as fast as cantools")
    assert theirs / medians["armui decode"] >= AIM
    assert theirs / medians["armui decode --json"] >= AIM
