"""Made-up frames, and recordings of them."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from armui.protocol.frame import Frame, FrameFlag
from armui.session.frames import LoggedFrame
from armui.session.recording.kinds import RecordingFormat
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.rows import RecordedFrame, rows_of
from armui.session.recording.writer import RecordingPlan, RecordingWriter, TimeBase

BASE = TimeBase(steady_s=1000.0, unix_s=1_780_000_000.25)
IDS = (*range(0x251, 0x251 + 30), 0x473)
EVERY_KIND = (
    (0x2A1, bytes(range(8)), 0),
    (0x151, b"\x01\x02", FrameFlag.TRANSMITTED),
    (0x18FEF100, b"\xff" * 8, FrameFlag.EXTENDED),
    (0x2A5, b"", 0),
    (0x123, b"", FrameFlag.REMOTE),
    (0x004, b"\x00\x08\x00\x00\x00\x00\x00\x60", FrameFlag.ERROR),
    (0x088, b"\x00\x00\x19\x00\x00\x00\x00\x00", FrameFlag.ERROR),
    (0x321, bytes(range(64)), FrameFlag.FD),
    (0x322, bytes(12), FrameFlag.FD | FrameFlag.BITRATE_SWITCH | FrameFlag.ERROR_STATE),
    (0x7FF, b"\xaa", 0),
)


def plan(folder: Path, kind: RecordingFormat = RecordingFormat.BLF, **more) -> RecordingPlan:
    """What to record; `more` are fields of the plan."""
    ordinary = RecordingPlan(folder, "made", kind, BASE, 10**9, "can0")
    return replace(ordinary, **more)


def still_clock() -> float:
    return BASE.steady_s


def writer(folder: Path, kind: RecordingFormat = RecordingFormat.BLF, **more) -> RecordingWriter:
    """One whose clocks agree."""
    return RecordingWriter(plan(folder, kind, **more), still_clock, lambda: BASE.unix_s)


def taken(count: int, start_s: float = BASE.steady_s, seed: int = 0) -> list[RecordedFrame]:
    """Ordinary frames of some thirty identifiers, 3,000 a second."""
    chance = random.Random(seed)
    return [
        (
            None,
            start_s + number / 3000,
            Frame(IDS[chance.randrange(len(IDS))], chance.randbytes(chance.choice((8, 8, 8, 3)))),
            FrameFlag.TRANSMITTED if chance.random() < 0.05 else 0,
        )
        for number in range(count)
    ]


def every_kind(start_s: float = BASE.steady_s) -> list[RecordedFrame]:
    """One of each sort, a tenth of a second apart."""
    return [
        (None, start_s + number / 10, Frame(arbitration_id, data), int(flags))
        for number, (arbitration_id, data, flags) in enumerate(EVERY_KIND)
    ]


def recorded(
    folder: Path,
    frames: Sequence[RecordedFrame],
    kind: RecordingFormat = RecordingFormat.BLF,
    *,
    block: int = 1000,
    **more,
) -> Path:
    """A whole recording; returns its first file."""
    made = writer(folder, kind, **more)
    for begin in range(0, len(frames), block):
        made.write(rows_of(frames[begin : begin + block]))
    made.finish({"reason": "test"})
    return made.path


def all_of(session: RecordedSession) -> list[LoggedFrame]:
    return [each for batch in session.frames_between(0.0, 1e12) for each in batch]
