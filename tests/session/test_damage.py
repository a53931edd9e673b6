"""Broken off, mixed and hostile logs: what can be read is given, and memory stays small."""

from __future__ import annotations

import gzip
import random
import sqlite3
import tracemalloc
import zlib
from contextlib import suppress

import can
import pytest

from armui.session.frames import MOST_DAMAGES, NotALogError
from armui.session.reader import LogFile
from tests.session.foreign_blf import container, file, frame, obj
from tests.session.test_formats import read, written

LINE = "(1.0) can0 2A5#0000000000000000\n"
BOUND = 60_000_000


def some(count: int) -> list[can.Message]:
    return [
        can.Message(
            timestamp=n / 100, arbitration_id=0x2A5, data=n.to_bytes(8, "big"), is_extended_id=False
        )
        for n in range(count)
    ]


@pytest.fixture
def memory():
    """Peak of memory used by a test, held under a bound whatever the file's size."""
    tracemalloc.start()
    yield
    _now, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < BOUND


# --- BLF --------------------------------------------------------------------------------------


def test_frames_of_a_container_that_breaks_off_are_given(tmp_path):
    draw = random.Random(1)
    data = b"".join(frame(0x2A5, draw.randbytes(8), n) for n in range(2_000))
    whole = file(container(data))
    path = tmp_path / "cut.blf"
    path.write_bytes(whole[: len(whole) // 2])
    frames, damages = read(path)
    assert 500 < len(frames) < 1_500
    assert damages[0].place == f"byte {len(whole) // 2}"
    assert damages[0].reason.startswith("the file breaks off here")


def test_a_damaged_container_costs_only_what_it_holds(tmp_path):
    parts = [container(b"".join(frame(n, b"") for n in range(k, k + 50))) for k in (0, 50, 100)]
    parts[1] = parts[1][:40] + b"\xff" * 20 + parts[1][60:]
    path = tmp_path / "damaged.blf"
    path.write_bytes(file(*parts))
    frames, damages = read(path)
    ids = [f.frame.arbitration_id for f in frames]
    assert ids[:50] == list(range(50))
    assert ids[-50:] == list(range(100, 150))
    assert len(damages) == 1


@pytest.mark.parametrize("size", [0, 15, 1 << 31])
def test_an_object_that_lies_about_its_size_hangs_nothing(tmp_path, size):
    path = tmp_path / "lies.blf"
    liar = obj(1, bytes(16), size=size)[:48]
    path.write_bytes(file(container(frame(1, b"") + liar + frame(2, b"")), liar, frame(3, b"")))
    frames, damages = read(path)
    assert [f.frame.arbitration_id for f in frames] == [1, 2, 3]
    assert damages


def test_a_container_of_gigabytes_of_zeros_is_unpacked_piece_by_piece(tmp_path, memory):
    packer = zlib.compressobj(9)
    bomb = b"".join(packer.compress(bytes(1 << 20)) for _ in range(300)) + packer.flush()
    body = (2).to_bytes(8, "little") + bytes(8) + bomb
    head = b"LOBJ" + (16).to_bytes(2, "little") + b"\1\0"
    size = (16 + len(body)).to_bytes(4, "little")
    path = tmp_path / "bomb.blf"
    path.write_bytes(file(frame(1, b""), head + size + (10).to_bytes(4, "little") + body))
    frames, damages = read(path)
    assert len(frames) == 1
    assert len(damages) == 1


def test_noise_behind_a_blf(tmp_path, memory):
    path = tmp_path / "noise.blf"
    with path.open("wb") as stream:
        stream.write(file(container(frame(1, b""))))
        stream.truncate(200_000_000)
    frames, damages = read(path)
    assert len(frames) == 1
    assert len(damages) == 1


# --- text -------------------------------------------------------------------------------------


def test_a_line_that_never_ends(tmp_path, memory):
    path = tmp_path / "zeros.log"
    with path.open("wb") as stream:
        stream.truncate(5_000_000_000)
    with pytest.raises(NotALogError, match="no CAN log"):
        read(path)


def test_a_line_that_never_ends_between_two_frames(tmp_path, memory):
    path = tmp_path / "long.log"
    path.write_text(LINE + "x" * 3_000_000 + "\n" + LINE)
    frames, damages = read(path)
    assert len(frames) == 2
    assert [d.place for d in damages] == ["line 2"]


NASTY = {
    ".log": ["(1) c 123 [8] 00{} x", "(1.0) can0{} 2A5#00", "(1) c TX{}"],
    ".asc": ["1.0 {} a", "1.0 1{} status", "date{} x", "1.0{}", "begin triggerblock{}"],
    ".trc": ["1) 1.0{} st", "1{}"],
    ".csv": ["1.0{},1,0,0,0,0,"],
}


@pytest.mark.each_value(full="each line in each kind of file")
@pytest.mark.timeout(30)
@pytest.mark.parametrize("suffix", NASTY)
@pytest.mark.parametrize("filling", [" ", "1", "a ", "00 ", "B ", "1.1"])
def test_lines_made_to_be_slow_to_match_hang_nothing(tmp_path, suffix, filling):
    path = tmp_path / f"slow{suffix}"
    lines = [each.format(filling * (16_000 // len(filling))) for each in NASTY[suffix]]
    path.write_text("\n".join(lines * 20))
    with suppress(NotALogError):
        read(path)


def test_a_last_line_without_its_end_is_a_line(tmp_path):
    path = tmp_path / "run.log"
    path.write_bytes(b"\xef\xbb\xbf" + (LINE * 2).encode().replace(b"\n", b"\r\n").rstrip())
    frames, damages = read(path)
    assert (len(frames), damages) == (2, [])


def test_millions_of_bad_lines_are_counted_not_kept(tmp_path, memory):
    path = tmp_path / "bad.log"
    path.write_text(LINE + "abc def\n" * 60_000 + LINE)
    with LogFile(path) as log:
        count = sum(len(batch) for batch in log.batches())
        assert count == 2
        assert len(log.damages) == MOST_DAMAGES
        assert log.damages.count == 60_000
        assert log.damages.since(0)[0].before_frame == 1


def test_reading_ends_when_nothing_more_is_a_frame(tmp_path, monkeypatch):
    monkeypatch.setattr("armui.session.text_logs._PATIENT_BYTES", 1_000_000)
    path = tmp_path / "ends.log"
    path.write_text(LINE + "abc def\n" * 400_000)
    with LogFile(path) as log:
        assert sum(len(batch) for batch in log.batches()) == 1
        assert log.position < log.size
        assert log.damages.count < 400_000


@pytest.mark.parametrize("suffix", [".asc", ".trc", ".csv", ".txt"])
def test_nonsense_is_no_log(tmp_path, suffix):
    path = tmp_path / f"nonsense{suffix}"
    path.write_bytes(random.Random(2).randbytes(300_000))
    with pytest.raises(NotALogError, match="no CAN log"):
        read(path)


@pytest.mark.parametrize("right", [".asc", ".trc", ".csv", ".blf", ".db", ".log"])
def test_a_log_under_a_foreign_suffix_says_what_it_looks_like(tmp_path, right):
    whole = written(tmp_path / f"run{right}", some(5))
    wrong = tmp_path / ("renamed.csv" if right == ".log" else "renamed.log")
    wrong.write_bytes(whole.read_bytes())
    with pytest.raises(NotALogError, match=f"it looks like a {right} file"):
        read(wrong)


def test_logs_of_two_kinds_in_one_file(tmp_path):
    path = tmp_path / "mixed.log"
    path.write_text(LINE * 3 + "timestamp,arbitration_id\n1.0,0x2a5,0,0,0,0,\n" + LINE * 3)
    frames, damages = read(path)
    assert len(frames) == 6
    assert [d.place for d in damages] == ["line 4", "line 5"]
    assert [d.before_frame for d in damages] == [3, 3]


def test_a_packed_log_that_breaks_off(tmp_path):
    whole = gzip.compress("".join(f"({n}.0) can0 2A5#{n:016X}\n" for n in range(50_000)).encode())
    path = tmp_path / "run.log.gz"
    path.write_bytes(whole[: len(whole) // 2])
    frames, damages = read(path)
    assert 1_000 < len(frames) < 50_000
    assert len(damages) <= 2
    assert damages[-1].reason == "what is packed in it is damaged"


# --- databases --------------------------------------------------------------------------------


def test_rows_that_are_no_frames_are_named(tmp_path):
    path = written(tmp_path / "run.db", some(5))
    with sqlite3.connect(path) as database:
        database.execute("INSERT INTO messages VALUES (1.0, 'x', 0, 0, 0, 8, x'00')")
        database.execute("INSERT INTO messages VALUES (NULL, 1, 0, 0, 0, NULL, 'text')")
        database.execute("INSERT INTO messages VALUES (2.0, 677, 0, 0, 0, 1, x'07')")
    database.close()
    frames, damages = read(path)
    assert [f.frame.data for f in frames][-1] == b"\x07"
    assert len(frames) == 6
    assert [d.place for d in damages] == ["row 7", "row 6"]


def test_a_value_of_megabytes_is_not_loaded(tmp_path, memory):
    path = written(tmp_path / "run.db", some(5))
    with sqlite3.connect(path) as database:
        database.execute("INSERT INTO messages VALUES (1.0, 1, 0, 0, 0, 8, zeroblob(500000000))")
    database.close()
    frames, damages = read(path)
    assert len(frames) == 5
    assert len(damages) == 1


@pytest.mark.parametrize("content", [b"", b"SQLite format 3\0" + bytes(200), b"hello\n" * 100])
def test_no_database(tmp_path, content):
    path = tmp_path / "no.db"
    path.write_bytes(content)
    with pytest.raises(NotALogError, match="no CAN log"):
        read(path)


def test_an_endless_view_is_not_read(tmp_path):
    path = tmp_path / "view.db"
    with sqlite3.connect(path) as database:
        database.execute(
            "CREATE VIEW messages AS WITH RECURSIVE n(x) AS"
            " (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT x, 1, 0, 0, 0, 0, NULL FROM n"
        )
    database.close()
    with pytest.raises(NotALogError, match="no table"):
        read(path)


def test_reading_a_database_changes_nothing(tmp_path):
    path = written(tmp_path / "run.db", some(5))
    before = path.read_bytes()
    assert len(read(path)[0]) == 5
    assert path.read_bytes() == before
    assert [each.name for each in tmp_path.iterdir()] == ["run.db"]
