"""A file that was cut anywhere is read as far as it goes; by python-can, too, where a kill cuts."""

from __future__ import annotations

import subprocess
import sys

import can
import pytest

from armui.session.frames import NotALogError
from armui.session.reader import LogFile
from armui.session.recording import index_file, sidecar
from armui.session.recording.kinds import RecordingFormat
from armui.session.recording.recorded_session import RecordedSession
from armui.session.recording.rows import rows_of
from tests.session.recording.made import BASE, all_of, every_kind, plan, recorded, taken, writer

PAGE = 4096
FRAMES = taken(12_000)


def beginning(frames, count):
    return [frame for _, _, frame, _ in frames[:count]]


def test_a_blf_file_cut_at_any_page_is_read_by_python_can(tmp_path):
    """A killed program's write ends, if anywhere, where a page of the file system does."""
    path = recorded(tmp_path, FRAMES, block=137)
    whole = path.read_bytes()
    cut = tmp_path / "cut.blf"
    counts = []
    for size in range(PAGE, len(whole), PAGE):
        cut.write_bytes(whole[:size])
        with can.BLFReader(cut) as reader:
            read = [bytes(message.data) for message in reader]
        assert read == [frame.data for frame in beginning(FRAMES, len(read))]
        counts.append(len(read))
    assert len(counts) > 20
    assert counts == sorted(counts)
    assert counts[-1] > len(FRAMES) - 700


def test_no_head_of_a_container_lies_across_a_page(tmp_path):
    whole = recorded(tmp_path, taken(60_000), block=61).read_bytes()
    heads = []
    at = 144
    while at < len(whole):
        assert whole[at : at + 4] == b"LOBJ"
        heads.append(at)
        size = int.from_bytes(whole[at + 8 : at + 12], "little")
        at += size + size % 4
    assert len(heads) > 900
    assert [at for at in heads if at % PAGE > PAGE - 32] == []


@pytest.mark.parametrize("kind", RecordingFormat)
def test_a_file_cut_anywhere_is_opened_with_what_is_there(tmp_path, kind):
    frames = every_kind() + taken(900, BASE.steady_s + 2.0)
    path = recorded(tmp_path, frames, kind, block=100)
    whole = path.read_bytes()
    for size in range(len(whole) // 2, len(whole), 331):
        path.write_bytes(whole[:size])
        session = RecordedSession(path)
        with LogFile(path) as log:
            read = sum(map(len, log.batches()))
        found = all_of(session)
        assert len(found) <= read <= len(frames)
        assert len(found) >= read - 100  # the block that was cut is damaged; its rest is noted
        if kind is not RecordingFormat.ASC:
            assert [each.frame for each in found] == beginning(frames, len(found))


@pytest.mark.parametrize("kind", RecordingFormat)
def test_frames_that_are_not_in_the_index_yet_are_found(tmp_path, kind):
    path = recorded(tmp_path, FRAMES[:3000], kind, block=500)
    index = tmp_path / f"made{index_file.SUFFIX}"
    data = index.read_bytes()
    for size in (len(data) - 1, len(data) // 2, len(index_file.MAGIC)):
        index.write_bytes(data[:size])
        session = RecordedSession(path)
        assert session.frames == 3000
        assert [each.frame for each in all_of(session)] == beginning(FRAMES, 3000)
        last = all_of(session)[-1]
        assert last.time_s == pytest.approx(FRAMES[2999][1] + BASE.shift_s, abs=2e-6)
        assert len(session.snapshot_at(session.end_s)) > 25


def test_an_index_whose_bytes_are_wrong_ends_where_it_is_wrong(tmp_path):
    path = recorded(tmp_path, FRAMES[:3000], block=500)
    index = tmp_path / f"made{index_file.SUFFIX}"
    data = bytearray(index.read_bytes())
    data[-30] ^= 0x40
    index.write_bytes(data)

    assert len(list(index_file.read_blocks(bytes(data)))) == 5
    assert RecordedSession(path).frames == 3000


def test_a_recording_without_its_index_or_sidecar_is_any_log(tmp_path):
    path = recorded(tmp_path, FRAMES[:300])
    (tmp_path / f"made{index_file.SUFFIX}").unlink()
    with pytest.raises(NotALogError):
        RecordedSession(path)
    (tmp_path / f"made{sidecar.SUFFIX}").unlink()
    with pytest.raises(NotALogError, match="no sidecar"):
        RecordedSession(path)
    with LogFile(path) as log:
        assert sum(map(len, log.batches())) == 300


def test_a_sidecar_that_was_cut_in_a_line_is_read_as_far_as_it_goes(tmp_path):
    path = recorded(tmp_path, FRAMES[:300])
    side = tmp_path / f"made{sidecar.SUFFIX}"
    side.write_bytes(side.read_bytes()[:-20] + b"\xff{\x00")
    kinds = [line["kind"] for line in RecordedSession(path).lines]
    assert kinds == ["session", "file"]


def test_the_header_tells_the_beginning_and_the_frames_before_the_end(tmp_path):
    """As of a program that was killed: nothing was finished."""
    made = writer(tmp_path)
    made.write(rows_of(FRAMES[:700]))
    with can.BLFReader(made.path) as reader:
        assert reader.start_timestamp == int(BASE.unix_s)
        assert reader.object_count == 700
        assert reader.file_size == made.path.stat().st_size
        assert len(list(reader)) == 700
    made.finish({})


def test_two_recordings_of_one_name_in_one_folder_leave_each_other_alone(tmp_path):
    first, second = writer(tmp_path), writer(tmp_path)
    first.write(rows_of(FRAMES[:100]))
    second.write(rows_of(FRAMES[100:300]))
    first.write(rows_of(FRAMES[300:400]))
    for each in (first, second):
        each.finish({})
    assert (first.name, second.name) == ("made", "made-2")
    assert RecordedSession(first.path).frames == 200
    assert RecordedSession(second.path).frames == 200
    foreign = tmp_path / "made-3.blf"
    foreign.write_bytes(b"somebody else's")
    third = writer(tmp_path)
    third.write(rows_of(FRAMES[:10]))
    third.finish({})
    assert third.name == "made-4"
    assert foreign.read_bytes() == b"somebody else's"
    assert plan(tmp_path).name == "made"


@pytest.mark.skipif(sys.platform == "win32", reason="SIGKILL and fork")
@pytest.mark.parametrize("kind", ["blf", "log"])
def test_a_killed_program_loses_the_last_second_at_most(kind):
    """Ten kills at random moments; `python -m tests.kills` does a thousand."""
    command = [sys.executable, "-m", "tests.kills", "5", "--format", kind]
    done = subprocess.run(command, capture_output=True, text=True, timeout=55, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "5 kills" in done.stdout
