"""What is recorded is read back frame by frame, by python-can and by this program."""

from __future__ import annotations

from collections import deque

import can
import pytest

from armui.protocol.frame import FrameFlag
from armui.session.frames import LoggedFrame
from armui.session.reader import LogFile
from armui.session.recording.kinds import RecordingFormat, file_name
from armui.session.recording.recorded_session import RecordedSession
from armui.session.session import REMEMBERED, REMEMBERED_IDS
from tests.session.recording.made import BASE, all_of, every_kind, recorded, taken

pytestmark = pytest.mark.parametrize("kind", RecordingFormat)

BUS_ERROR = 0x80


def told(kind, arbitration_id, data, flags):
    """What a format keeps of a frame."""
    if kind is RecordingFormat.ASC and flags & FrameFlag.ERROR:
        return None, b"", FrameFlag.ERROR  # ASC tells of an error frame only that there was one
    if flags & FrameFlag.ERROR:
        flags &= ~FrameFlag.EXTENDED  # candump's lines do not tell the two apart
    return arbitration_id, data, FrameFlag(flags)


def test_every_sort_of_frame_is_kept(tmp_path, kind):
    frames = every_kind()
    session = RecordedSession(recorded(tmp_path, frames, kind))

    read = [
        told(kind, each.frame.arbitration_id, each.frame.data, each.flags)
        for each in all_of(session)
    ]
    assert read == [
        told(kind, frame.arbitration_id, frame.data, flags) for _, _, frame, flags in frames
    ]
    times_s = [each.time_s - BASE.shift_s for each in all_of(session)]
    assert times_s == pytest.approx([at_s for _, at_s, _, _ in frames], abs=2e-6)
    assert session.damage_count == 0


def test_python_can_reads_every_frame(tmp_path, kind):
    frames = every_kind() + taken(3000, BASE.steady_s + 2.0)
    path = recorded(tmp_path, frames, kind)

    with can.LogReader(path) as reader:
        messages = list(reader)

    assert len(messages) == len(frames)
    start_s = BASE.unix_s if kind is RecordingFormat.ASC else 0.0
    for message, (_, at_s, frame, flags) in zip(messages, frames, strict=True):
        assert message.timestamp + start_s == pytest.approx(at_s + BASE.shift_s, abs=2e-6)
        if flags & FrameFlag.ERROR:
            # of candump's error frames python-can knows those of the class «bus error» only
            known = kind is not RecordingFormat.CANDUMP or frame.arbitration_id & BUS_ERROR
            assert message.is_error_frame is bool(known)
            continue
        assert (message.arbitration_id, bytes(message.data)) == frame
        assert message.is_rx is not bool(flags & FrameFlag.TRANSMITTED)
        assert message.is_extended_id is bool(flags & FrameFlag.EXTENDED)
        assert message.is_fd is bool(flags & FrameFlag.FD)
        assert message.is_remote_frame is bool(flags & FrameFlag.REMOTE)


def test_the_reader_of_any_log_reads_it_without_damage(tmp_path, kind):
    frames = every_kind() + taken(500, BASE.steady_s + 2.0)
    with LogFile(recorded(tmp_path, frames, kind)) as log:
        read = [each for batch in log.batches() for each in batch]
        assert log.damages.count == 0
    assert len(read) == len(frames)


def test_a_file_that_is_large_enough_is_followed_by_another(tmp_path, kind):
    frames = taken(6000)
    recorded(tmp_path, frames, kind, rotate_bytes=9000, block=500)

    paths = [tmp_path / file_name("made", number, kind.value) for number in range(1, 40)]
    there = [path for path in paths if path.exists()]
    assert len(there) > 2
    assert there == paths[: len(there)]
    assert all(path.stat().st_size >= 9000 for path in there[:-1])
    read = sum(1 for path in there for _ in can.LogReader(path))
    assert read == len(frames)
    for path in there:
        session = RecordedSession(path)
        assert [each.frame for each in all_of(session)] == [frame for _, _, frame, _ in frames]


def test_the_frames_of_a_stretch_and_their_numbers(tmp_path, kind):
    frames = taken(6000)
    session = RecordedSession(recorded(tmp_path, frames, kind, block=700))
    t0_s, t1_s = session.start_s + 0.5, session.start_s + 1.25

    batches = list(session.frames_between(t0_s, t1_s))
    everything = all_of(session)
    wanted = [each for each in everything if t0_s <= each.time_s < t1_s]
    assert [each for batch in batches for each in batch] == wanted
    for batch in batches:
        assert everything[batch.first] == batch.frame(0)


@pytest.mark.each_value(full="each moment in each format")
@pytest.mark.parametrize("after_s", [-1.0, 0.0, 0.2, 1.0, 1.7, 1.9999, 60.0])
def test_the_bus_as_it_stood_at_a_moment(tmp_path, kind, after_s):
    frames = taken(6000)
    session = RecordedSession(recorded(tmp_path, frames, kind, block=700))
    at_s = session.start_s + after_s

    last: dict[tuple[int, int], deque[LoggedFrame]] = {}
    for each in all_of(session):
        if each.time_s <= at_s:
            key = each.frame.arbitration_id, int(each.flags)
            most = REMEMBERED if key[0] in REMEMBERED_IDS else 1
            last.setdefault(key, deque(maxlen=most)).append(each)
    wanted = [each for kept in last.values() for each in kept]
    snapshot = session.snapshot_at(at_s)
    assert sorted(snapshot) == sorted(wanted)
    assert list(snapshot.times_s) == sorted(snapshot.times_s)
    several = [each for each in wanted if each.frame.arbitration_id == 0x473 and not each.flags]
    assert len(several) == (REMEMBERED if after_s > 1.0 else len(several))
