"""``python -m tests.kills [COUNT]``: kills a recording program at random moments, and reads back.

Each time a process records 3,000 made-up frames a second, which are numbered, by the same way as
frames of a bus: lane, collector, writing thread. It is killed (SIGKILL) at a random moment. Then
python-can's own reader, the program's reader of any log, and the recording opened by its index must
all give every frame from the first one on without a gap; what is missing at the end is measured in
seconds before the kill. Linux and macOS only.
"""

from __future__ import annotations

import argparse
import mmap
import os
import random
import struct
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import can

from armui.protocol.frame import Frame
from armui.session.reader import LogFile
from armui.session.recording.collector import Collector, FrameRing
from armui.session.recording.kinds import RecordingFormat
from armui.session.recording.lane import FrameLane
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.session_recording import SessionRecording
from armui.session.recording.writer import RecordingPlan, TimeBase
from armui.system.clock import steady_s
from tests.posix import kill, of_system

EVERY_S = 0.005
FRAMES_AT_ONCE = 15
LONGEST_S = 1.6
_SHARED = struct.Struct("<dd")


@dataclass(frozen=True)
class Killed:
    """What was found after one kill.

    Attributes:
        frames: That were read back.
        lost_s: From the last one to the kill.
        stalled_s: So long, at most, the process was not given its turn.
        problem: What was wrong, "" if nothing was.
    """

    frames: int
    lost_s: float
    stalled_s: float
    problem: str = ""


def record(folder: Path, kind: RecordingFormat, shared: mmap.mmap) -> None:
    """Record until killed."""
    lane = FrameLane()
    collector = Collector(lane, FrameRing())
    base = TimeBase(steady_s(), time.time())
    recording = SessionRecording(RecordingPlan(folder, "killed", kind, base, 40_000, "can0"))
    collector.add(recording.put)
    collector.start()
    number, worst_s, due_s = 0, 0.0, steady_s()
    while True:
        now_s = steady_s()
        worst_s = max(worst_s, now_s - due_s)
        batch = []
        for _ in range(FRAMES_AT_ONCE):
            frame = Frame(0x2A1 + number % 32, struct.pack(">Q", number))
            batch.append((None, now_s, frame, 0))
            number += 1
        lane.on_heard(batch)
        _SHARED.pack_into(shared, 0, worst_s, base.shift_s)
        due_s += EVERY_S
        time.sleep(max(0.0, due_s - steady_s()))


def kill_once(folder: Path, kind: RecordingFormat, after_s: float) -> Killed:
    """Have it record, kill it, look."""
    shared = mmap.mmap(-1, mmap.PAGESIZE)
    child = of_system("fork")()
    if child == 0:
        try:
            record(folder, kind, shared)
        finally:
            os._exit(1)
    time.sleep(after_s)
    kill(child)
    killed_s = steady_s()
    os.waitpid(child, 0)
    stalled_s, shift_s = _SHARED.unpack_from(shared, 0)
    return look(folder, kind, killed_s + shift_s, stalled_s)


def look(folder: Path, kind: RecordingFormat, killed_s: float, stalled_s: float) -> Killed:
    """Read back what it has left."""
    found = sorted(folder.glob(f"*{kind.value}"), key=lambda path: (len(path.name), path.name))
    paths = [path for path in found if path.stat().st_size]  # one may just have been made
    try:
        by_python_can = [message for path in paths for message in can.LogReader(path)]
        by_us = [each for path in paths for each in _frames(path)]
        session = RecordedSession(folder / f"killed{kind.value}")
    except Exception as error:  # noqa: BLE001 - whatever it is, it is what is looked for
        return Killed(0, 0.0, stalled_s, f"{type(error).__name__}: {error}")
    indexed = [each for batch in session.frames_between(0, 1e12) for each in batch]
    numbers = [int.from_bytes(each.frame.data, "big") for each in indexed]
    problem = ""
    if numbers != list(range(len(numbers))):
        problem = "a gap among the frames"
    elif (
        not [bytes(each.data) for each in by_python_can][: len(by_us)]
        == [each.frame.data for each in by_us]
        == [each.frame.data for each in indexed]
    ):
        counts = len(by_python_can), len(by_us), len(indexed)
        problem = f"python-can, reader, session read {counts} frames"
    lost_s = killed_s - session.end_s if numbers else 0.0
    return Killed(len(numbers), lost_s, stalled_s, problem)


def _frames(path: Path):
    with LogFile(path) as log:
        for batch in log.batches():
            yield from batch


def one_kill(kind: RecordingFormat) -> Killed:
    """Kill at a random moment."""
    with tempfile.TemporaryDirectory() as folder:
        return kill_once(Path(folder), kind, random.uniform(0.7, LONGEST_S))


def main() -> int:
    """Read the command line and kill.

    Returns:
        0 if every file could be read without a gap and nothing but the last second was lost.
    """
    parser = argparse.ArgumentParser(prog="python -m tests.kills", description=__doc__)
    parser.add_argument("count", nargs="?", type=int, default=1000)
    parser.add_argument("--format", choices=[kind.value[1:] for kind in RecordingFormat])
    options = parser.parse_args()
    kind = RecordingFormat(f".{options.format or 'blf'}")
    found = []
    for number in range(options.count):
        found.append(one_kill(kind))
        if found[-1].problem:
            print(f"kill {number + 1}: {found[-1].problem}", flush=True)
    lost = sorted(each.lost_s for each in found)
    stalled = max(each.stalled_s for each in found)
    late = [each for each in found if each.lost_s > 1.0 + each.stalled_s]
    bad = [each for each in found if each.problem]
    print(
        f"{len(found)} kills, {sum(each.frames for each in found)} frames read back, "
        f"{len(bad)} files with a problem, {len(late)} that lost more than the last second; "
        f"lost before the kill: median {lost[len(lost) // 2]:.3f} s, most {lost[-1]:.3f} s; "
        f"the process waited {stalled:.3f} s for its turn at most"
    )
    return int(bool(bad or late))


if __name__ == "__main__":
    sys.exit(main())
