"""A log of another program, indexed: every frame of it, at any place, and in the order of time."""

from __future__ import annotations

import gzip
import math
from pathlib import Path

import can
import numpy as np
import pytest

from armui.arm.refusal import Refusal
from armui.protocol.frame import Frame
from armui.protocol.generation import Generation
from armui.session.foreign.indexed import PROGRESS, ReadingProgress
from armui.session.foreign.indexing import index_log, index_or_reason, straightened
from armui.session.frames import FrameBatch, LoggedFrame
from armui.session.reader import LogFile
from armui.session.session import REMEMBERED_IDS
from armui.session.survey import survey
from tests.decode.logs import record
from tests.session.indexed import open_indexed
from tests.session.recordings import START_S, frames, greeting, write


def rows(batches) -> list[LoggedFrame]:
    return [frame for batch in batches for frame in batch]


def message(at_s: float, arbitration_id: int, data: bytes = b"", channel: int = 1, **kind):
    return can.Message(
        timestamp=at_s, arbitration_id=arbitration_id, data=data, channel=channel,
        is_extended_id=kind.pop("extended", False), **kind,
    )  # fmt: skip


@pytest.fixture(scope="module")
def log(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("log") / "arm.blf"
    write(path, frames(4.0, asked=greeting(Generation.TWO)))
    return path


def test_every_frame_is_there_in_order(log):
    session = open_indexed(log)

    with LogFile(log) as plain:
        assert rows(session.frames_between(-math.inf, math.inf)) == rows(plain.batches())
        assert session.frames == plain.frames
    assert (session.start_s, session.end_s) == pytest.approx((START_S, START_S + 3.995), abs=0.01)
    session.close()


def test_a_piece_has_its_beginning_and_not_its_end(log):
    session = open_indexed(log)
    everything = rows(session.frames_between(-math.inf, math.inf))
    begin_s, end_s = everything[5000].time_s, everything[7000].time_s

    piece = list(session.frames_between(begin_s, end_s))

    assert rows(piece) == [each for each in everything if begin_s <= each.time_s < end_s]
    assert piece[0].first == everything.index(piece[0].frame(0))
    session.close()


@pytest.mark.parametrize("share", [0.0, 0.1, 0.35, 0.8, 1.0])
def test_a_snapshot_is_the_last_word_of_each_identifier(log, share):
    session = open_indexed(log)
    at_s = session.start_s + share * (session.end_s - session.start_s)
    last: dict[int, LoggedFrame] = {}
    for each in rows(session.frames_between(-math.inf, math.nextafter(at_s, math.inf))):
        last[each.frame.arbitration_id] = each

    found = rows([session.snapshot_at(at_s)])

    once = [each for each in found if each.frame.arbitration_id not in REMEMBERED_IDS]
    expected = [each for number, each in last.items() if number not in REMEMBERED_IDS]
    assert sorted(once) == sorted(expected)
    assert [each.time_s for each in found] == sorted(each.time_s for each in found)
    session.close()


def test_a_snapshot_knows_the_limits_of_all_joints(log):
    session = open_indexed(log)

    found = rows([session.snapshot_at(session.end_s)])

    joints = {each.frame.data[0] for each in found if each.frame.arbitration_id == 0x473}
    assert joints == {1, 2, 3, 4, 5, 6}
    session.close()


def test_frames_of_other_sorts_and_long_data_stay_what_they_are(tmp_path):
    written = [
        message(1.0, 0x2A1, bytes(8)),
        message(1.1, 0x18FEF100, b"\1\2", extended=True),
        message(1.2, 0x300, bytes(range(48)), is_fd=True),
        message(1.3, 0x301, is_remote_frame=True, dlc=4),
        message(1.4, 0x2A1, b"\1"),
    ]
    session = open_indexed(record(tmp_path / "mixed.blf", *written))

    with LogFile(tmp_path / "mixed.blf") as plain:
        expected = rows(plain.batches())
    assert rows(session.frames_between(-math.inf, math.inf)) == expected
    snapshot = rows([session.snapshot_at(math.inf)])
    assert [each for each in snapshot if each.frame.arbitration_id == 0x300] == [expected[2]]
    assert len(snapshot) == 4
    session.close()


def test_the_columns_leave_the_disk(log, tmp_path):
    (tmp_path / "columns").mkdir()
    index_log(log, tmp_path / "columns")
    session = open_indexed(log)
    folder = session._folder

    session.close()

    assert not folder.exists()


def test_progress_is_told_while_reading(log, tmp_path):
    index_log(log, tmp_path)

    progress = ReadingProgress.read_from((tmp_path / PROGRESS).read_bytes())
    assert progress.frames > 10_000
    assert progress.share == 1.0


def test_a_log_that_is_too_long_is_cut_and_says_so(log):
    session = open_indexed(log, most_frames=5000)

    assert session.cut == "frames"
    assert 5000 <= session.frames < 12_000
    session.close()


def test_a_log_broken_off_shows_what_there_is(log, tmp_path):
    whole = log.read_bytes()
    (tmp_path / "cut.blf").write_bytes(whole[: len(whole) // 2])

    session = open_indexed(tmp_path / "cut.blf")

    assert session.frames > 1000
    assert session.damage_count >= 1
    assert session.damages[0].place.startswith("byte")
    session.close()


# Times that run backwards ---------------------------------------------------------------------


def put_right(*times_s: float, channels: list[int] | None = None) -> tuple[list[float], int]:
    own = np.array(channels or [0] * len(times_s), np.uint8)
    found, count = straightened(np.array(times_s), own)
    return found.tolist(), count


def test_times_in_order_are_left_alone():
    assert put_right(1.0, 1.0, 2.5) == ([1.0, 1.0, 2.5], 0)


def test_frames_out_of_order_by_little_keep_their_times():
    assert put_right(1.0, 1.2, 1.1, 1.3) == ([1.0, 1.2, 1.1, 1.3], 1)


def test_a_clock_that_was_set_back_goes_on_from_there():
    assert put_right(100.0, 101.0, 50.0, 51.0) == ([100.0, 101.0, 101.0, 102.0], 1)


def test_a_single_time_in_the_future_is_that_of_its_neighbour():
    assert put_right(1.0, 2.0, 9e9, 2.5, 3.0) == ([1.0, 2.0, 2.0, 2.5, 3.0], 1)


def test_each_channel_has_its_own_order():
    times = put_right(1.0, 5000.0, 2.0, 5001.0, channels=[0, 1, 0, 1])
    assert times == ([1.0, 5000.0, 2.0, 5001.0], 0)


def test_a_session_is_in_the_order_of_time(tmp_path):
    text = "".join(
        f"({at_s:.6f}) can0 {number:03X}#{number % 256:02X}\n"
        for at_s, number in ((10.0, 0x100), (10.3, 0x101), (10.1, 0x102), (4.0, 0x103))
    )
    (tmp_path / "back.log").write_text(text)

    session = open_indexed(tmp_path / "back.log")

    found = rows(session.frames_between(-math.inf, math.inf))
    assert [each.frame.arbitration_id for each in found] == [0x100, 0x102, 0x103, 0x101]
    assert session.reversed_times == 2
    session.close()


# What cannot be replayed ----------------------------------------------------------------------


def refused(path: Path, tmp_path: Path) -> Refusal:
    (tmp_path / "columns").mkdir()
    found = index_or_reason(path, tmp_path / "columns")
    assert isinstance(found, Refusal)
    return found


@pytest.mark.parametrize(
    ("name", "content", "code"),
    [
        ("empty.log", b"", "replay_empty"),
        ("empty.blf", b"", "replay_empty"),
        ("nonsense.log", bytes(range(256)) * 400, "replay_nothing_read"),
        ("blf.log", b"LOGG" + bytes(4000), "replay_no_log"),  # it is said what it looks like
        ("renamed.blf", b"PK\x03\x04" + bytes(4000), "replay_archive"),
        ("renamed.log", b"7z\xbc\xaf\x27\x1c" + bytes(4000), "replay_archive"),
        ("packed.asc", b"\x1f\x8b\x08" + bytes(4000), "replay_archive"),
        ("nonsense.blf", b"LOGX" + bytes(4000), "replay_no_log"),
        ("picture.png", b"\x89PNG", "replay_unknown_kind"),
        ("measured.mf4", b"MDF     4.10", "replay_mf4"),
        ("measured.MF4.gz", b"\x1f\x8b\x08", "replay_mf4"),
        ("header.asc", b"date Sat Nov 21 02:00:00.000 2026\nbase hex  timestamps absolute\n",
         "replay_empty"),
    ],
)  # fmt: skip
def test_what_is_no_log_is_called_so(tmp_path, name, content, code):
    (tmp_path / name).write_bytes(content)

    reason = refused(tmp_path / name, tmp_path)

    assert reason.code == code
    assert reason.params["name"] == name


def test_of_a_packed_log_that_breaks_off_what_there_is_is_read(tmp_path):
    lines = [f"({number}.0) can0 2A5#{number:016X}\n" for number in range(5000)]
    whole = gzip.compress("".join(lines).encode())
    (tmp_path / "cut.log.gz").write_bytes(whole[: len(whole) * 3 // 4])
    session = open_indexed(tmp_path / "cut.log.gz")
    assert 2500 < session.frames < 5000
    assert session.damage_count
    session.close()


def test_a_container_that_is_cut_is_one_damaged_place(tmp_path):
    write(tmp_path / "whole.blf", frames(0.5))
    whole = (tmp_path / "whole.blf").read_bytes()
    (tmp_path / "cut.blf").write_bytes(whole[:-1000])
    session = open_indexed(tmp_path / "cut.blf")
    assert session.damage_count == 1
    session.close()


def test_a_file_that_is_gone_is_called_so(tmp_path):
    reason = refused(tmp_path / "gone.blf", tmp_path)

    assert reason.code == "replay_unreadable"
    assert reason.params["text"] == "No such file or directory"


@pytest.mark.parametrize("name", ["huge.log", "huge.asc", "huge.csv", "huge.trc"])
def test_gigabytes_of_nothing_end_soon(tmp_path, name):
    with (tmp_path / name).open("wb") as file:
        file.truncate(2 << 30)

    assert refused(tmp_path / name, tmp_path).code == "replay_nothing_read"


# What it tells of its arms ---------------------------------------------------------------------


def test_the_version_in_the_log_tells_the_generation(log):
    session = open_indexed(log)

    (found,) = survey(session)

    assert (found.generation, found.is_certain) == (Generation.TWO, True)
    assert "S-V1.8" in found.reason
    session.close()


def test_without_a_version_the_frames_tell(tmp_path):
    write(tmp_path / "one.blf", frames(3.0, Generation.ONE))
    session = open_indexed(tmp_path / "one.blf")

    assert survey(session)[0].generation is Generation.ONE
    session.close()


def test_the_channel_with_the_arm_comes_first(tmp_path):
    arm = [(at_s, frame, 2) for at_s, frame in frames(1.0)]
    other = [(START_S + n * 0.01, Frame(0x7D0 + n % 5, bytes(8)), 1) for n in range(100)]
    with can.Logger(tmp_path / "two.blf") as logger:
        for at_s, frame, channel in sorted(arm + other, key=lambda each: each[0]):
            logger(message(at_s, frame.arbitration_id, frame.data, channel))
    session = open_indexed(tmp_path / "two.blf")

    first, second = survey(session)

    assert set(session.channels) == {1, 2}
    assert (first.channel, second.channel) == (2, 1)
    assert first.arm_ids > 10
    assert second.arm_ids == 0
    session.close()


def test_shifted_identifiers_are_found(tmp_path):
    moved = [
        (at_s, Frame(frame.arbitration_id + 0x20, frame.data))
        if 0x2A1 <= frame.arbitration_id <= 0x2A8
        else (at_s, frame)
        for at_s, frame in frames(1.0)
    ]
    write(tmp_path / "moved.blf", moved)
    session = open_indexed(tmp_path / "moved.blf")

    assert survey(session)[0].feedback_offset == 0x20
    session.close()


def test_an_empty_snapshot_has_no_rows(log):
    session = open_indexed(log)

    before: FrameBatch = session.snapshot_at(session.start_s - 1.0)

    assert len(before) == 0
    session.close()
