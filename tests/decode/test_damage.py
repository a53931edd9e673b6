"""`armui decode` on logs with damaged lines, BLF that breaks off, and files that are no log."""

from __future__ import annotations

import errno
import gzip
import os
from pathlib import Path

import can
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.decode.logs import (
    ASC_BEGIN,
    ASC_HEADER,
    CSV_HEADER,
    GOOD,
    HEADER,
    TEXT_SUFFIXES,
    TRC_HEADER,
    decode,
    message,
    objects,
    record,
)
from tests.examples import examples

# --- damaged lines ----------------------------------------------------------------------------

DAMAGED = {
    ".log": [
        "garbage", "(1.0) can0 2A5", "(1.0) can0 2A5#0", "(1.0) can0 2A5#00GG", "(x) can0 2A5#00",
        "(nan) can0 2A5#00", "# comment",
        "(1.0) can0 #00", "(1.0) can0 2A5##", "\x00\x01\x02", "(1.0) can0 -2A#00",
    ],
    ".asc": [
        "garbage", "1.000000 1  2A5             Rx   d 8 00 00 00 00 00 00 00 GG",
        "1.000000 1  XYZ             Rx   d 1 00", "1.000000 1  2A5             Rx   d",
        "1.0x 1 2A5 Rx d 0",
        "1.000000 CANFD   1 Rx        2A5   0 0",
    ],
    ".trc": [
        "garbage", "  1  1000.000 DT 02A5 Rx 8 00 GG",
        "  1  x DT 02A5 Rx 1 00", "  1  1000.000 QQ 02A5 Rx 1 00", "  1",
        "  1  1.0 DT 02A5 Rx x 00",
    ],
    ".csv": [
        "garbage", "1.0,0x2a5,0,0,0,8", "x,0x2a5,0,0,0,0,", "1.0,zz,0,0,0,0,",
        "nan,0x2a5,0,0,0,0,", "1.0,0xFFFFFFFFFFFFFFFFFF,0,0,0,0,",
        "1.0,0x2a5,0,0,0,x,AAAAAAAAAAA=",
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("suffix", "damage"), [(suffix, each) for suffix, many in DAMAGED.items() for each in many]
)
def test_a_damaged_line_is_reported_by_number_and_the_rest_decoded(
    tmp_path, capsys, suffix, damage
):
    good = GOOD[suffix]
    log = tmp_path / f"run{suffix}"
    log.write_text(HEADER[suffix] + f"{good}\n{good}\n{damage}\n{good}\n{damage}\n{damage}\n{good}")
    assert decode(log, "--generation", "2", "--json") == 1
    lines, errors = objects(capsys)
    assert [line["message"] for line in lines] == ["JointFeedback12"] * 4
    first = HEADER[suffix].count("\n") + 3
    reported = [line.split(": ")[2] for line in errors.splitlines()]
    assert reported == [f"line {n} cannot be read" for n in (first, first + 2, first + 3)]


CONTRADICTORY = [
    (".log", "(1.0) can0 2A5#000000000000000000"),
    (".log", "(1.0) can0 FFF#00"),
    (".asc", "1.000000 1  2A5             Rx   d 8 00 00 00 00 00 00 00"),
    (".asc", "1.000000 1  FFF             Rx   d 1 00"),
    (".trc", "  1  1000.000 DT 02A5 Rx 8 00 00"),
    (".csv", "1.0,0x2a5,0,0,0,8,AAA="),
]


@pytest.mark.parametrize(("suffix", "line"), CONTRADICTORY)
def test_a_frame_that_no_bus_can_have_carried_is_shown_and_named(tmp_path, capsys, suffix, line):
    """python-can reads it, so nothing is lost; what is wrong is said beside it."""
    good = GOOD[suffix]
    log = tmp_path / f"run{suffix}"
    log.write_text(HEADER[suffix] + f"{good}\n{line}\n{good}\n")
    assert decode(log, "--generation", "2", "--json") == 1
    lines, errors = objects(capsys)
    assert [each["message"] for each in lines] == ["JointFeedback12", None, "JointFeedback12"]
    assert lines[1]["oddity"]["kind"] == "impossible frame"
    number = HEADER[suffix].count("\n") + 2
    assert errors.count("\n") == 1
    assert f"line {number} contradicts itself" in errors


@pytest.mark.parametrize("suffix", TEXT_SUFFIXES)
def test_damage_before_the_first_frame_is_reported_too(tmp_path, capsys, suffix):
    log = tmp_path / f"run{suffix}"
    log.write_text(HEADER[suffix] + f"{DAMAGED[suffix][1]}\n{GOOD[suffix]}\n")
    assert decode(log, "--generation", "2", "--json") == 1
    lines, errors = objects(capsys)
    assert len(lines) == 1
    assert f"line {HEADER[suffix].count(chr(10)) + 1} cannot be read" in errors


def test_an_asc_log_without_its_usual_header_loses_no_frame(tmp_path, capsys):
    """python-can by itself swallows the line that follows a header without 'internal events'."""
    log = tmp_path / "run.asc"
    log.write_text(f"{ASC_HEADER}// a comment\n{GOOD['.asc']}\n{GOOD['.asc']}\n")
    assert decode(log, "--generation", "2") == 0
    assert len(capsys.readouterr().out.splitlines()) == 2


def test_a_csv_log_without_header_loses_no_frame(tmp_path, capsys):
    log = tmp_path / "run.csv"
    log.write_text(f"{GOOD['.csv']}\n{GOOD['.csv']}\n")
    assert decode(log, "--generation", "2") == 0
    assert len(capsys.readouterr().out.splitlines()) == 2


def test_events_and_comments_of_asc_and_trc_are_no_damage(tmp_path, capsys):
    asc = tmp_path / "run.asc"
    asc.write_text(
        f"{ASC_HEADER}{ASC_BEGIN}   0.000000 Start of measurement\n// note\n\n"
        "   0.100000 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%\n"
        "   0.200000 CAN 1 Status:chip status error active\n"
        f"{GOOD['.asc']}\nEnd TriggerBlock\n"
    )
    trc = tmp_path / "run.trc"
    trc.write_text(f"{TRC_HEADER}  1  0.5 ST Rx 00 00 00 00\n\n{GOOD['.trc']}\n; the end\n")
    for log in (asc, trc):
        assert decode(log, "--generation", "2") == 0
        output = capsys.readouterr()
        assert (len(output.out.splitlines()), output.err) == (1, "")


@pytest.mark.parametrize("suffix", [*TEXT_SUFFIXES, ".blf", ".log.gz", ".blf.gz"])
@settings(
    suppress_health_check=[HealthCheck.function_scoped_fixture],
    max_examples=examples(25),
    deadline=None,
    derandomize=True,
)
@given(data=st.data())
def test_no_damage_makes_it_fail(tmp_path, capsys, suffix, data):
    """Any bytes overwritten or cut off: an exit code, never an exception."""
    plain = tmp_path / f"whole{suffix.removesuffix('.gz')}"
    if not plain.exists():
        record(plain, *[message(1.0 + n / 100, 0x2A1 + n % 8, "00" * 8) for n in range(12)])
    whole = plain.read_bytes()
    damaged = bytearray(gzip.compress(whole, mtime=0) if suffix.endswith(".gz") else whole)
    for _ in range(data.draw(st.integers(0, 4))):
        damaged[data.draw(st.integers(0, len(damaged) - 1))] = data.draw(st.integers(0, 255))
    del damaged[data.draw(st.integers(0, len(damaged))) :]
    log = tmp_path / f"damaged{suffix}"
    log.write_bytes(damaged)
    assert decode(log, "--json", "--generation", data.draw(st.sampled_from("12"))) in {0, 1, 2}
    objects(capsys)


# --- BLF --------------------------------------------------------------------------------------


@pytest.fixture
def blf(tmp_path) -> Path:
    """Some 400 frames in several containers."""
    path = tmp_path / "run.blf"
    with can.BLFWriter(path) as writer:
        writer.max_container_size = 2_000
        for n in range(400):
            writer(message(1.0 + n / 200, 0x2A5, f"{n:08X}00000000"))
    return path


def test_a_truncated_blf_is_decoded_up_to_the_break(blf, capsys):
    whole = blf.read_bytes()
    blf.write_bytes(whole[: len(whole) // 2])
    assert decode(blf, "--generation", "2", "--json") == 1
    lines, errors = objects(capsys)
    assert 100 < len(lines) < 300
    assert [line["signals"]["J1"]["value"] for line in lines] == [
        n / 1000 for n in range(len(lines))
    ]
    assert f"byte {len(whole) // 2} cannot be read: the file breaks off here" in errors
    assert f"after {len(lines)} frames" in errors


def test_a_blf_damaged_in_the_middle_says_where_and_goes_on_behind_it(blf, capsys):
    whole = bytearray(blf.read_bytes())
    second = whole.index(b"LOBJ", whole.index(b"LOBJ") + 4)
    third = whole.index(b"LOBJ", second + 4)
    whole[second : second + 4] = b"JUNK"
    blf.write_bytes(whole)
    assert decode(blf, "--generation", "2", "--json") == 1
    lines, errors = objects(capsys)
    angles = [line["signals"]["J1"]["value"] for line in lines]
    assert angles[0] == 0
    assert angles[-1] == 0.399
    assert 300 < len(lines) < 400
    assert f"byte {second} cannot be read: damaged here; the next object begins at" in errors
    assert f"at byte {third}" in errors


def test_a_whole_blf_is_no_complaint(blf, capsys):
    assert decode(blf, "--generation", "2") == 0
    output = capsys.readouterr()
    assert (len(output.out.splitlines()), output.err) == (400, "")


# --- no log -----------------------------------------------------------------------------------


def assert_one_line_and_exit_2(path: Path, capsys, words: str, *options: str) -> None:
    assert decode(path, *options) == 2
    output = capsys.readouterr()
    assert output.out == ""
    assert len(output.err.splitlines()) == 1
    assert str(path) in output.err
    assert words in output.err


@pytest.mark.parametrize("options", [(), ("--generation", "1")])
@pytest.mark.parametrize("suffix", [*TEXT_SUFFIXES, ".blf"])
class TestNoLog:
    def test_missing(self, tmp_path, capsys, suffix, options):
        log = tmp_path / f"no{suffix}"
        assert_one_line_and_exit_2(log, capsys, "No such file or directory", *options)

    def test_directory(self, tmp_path, capsys, suffix, options):
        log = tmp_path / f"folder{suffix}"
        log.mkdir()
        assert_one_line_and_exit_2(log, capsys, "Is a directory", *options)

    def test_no_permission(self, tmp_path, capsys, monkeypatch, suffix, options):
        def refuse(*_arguments):  # a superuser, as in many containers, may read everything
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

        log = tmp_path / f"secret{suffix}"
        log.touch()
        monkeypatch.setattr("armui.session.source.open_stream", refuse)
        assert_one_line_and_exit_2(log, capsys, "Permission denied", *options)

    def test_empty(self, tmp_path, capsys, suffix, options):
        log = tmp_path / f"empty{suffix}"
        log.touch()
        assert_one_line_and_exit_2(log, capsys, "", *options)

    @pytest.mark.each_pair(full="all three together")
    @pytest.mark.parametrize("garbage", [bytes(range(256)) * 40, b"hello\nworld\n" * 3000, b"\0"])
    def test_garbage(self, tmp_path, capsys, suffix, options, garbage):
        log = tmp_path / f"garbage{suffix}"
        log.write_bytes(garbage)
        assert_one_line_and_exit_2(log, capsys, "", *options)


@pytest.mark.parametrize("name", ["notes.md", "noextension", "run.gz", "run.db.gz"])
def test_unknown_suffix(tmp_path, capsys, name):
    log = tmp_path / name
    log.write_text(GOOD[".log"])
    assert_one_line_and_exit_2(log, capsys, "known are .log, .asc, .blf, .trc, .csv, .db, .txt")


@pytest.mark.parametrize("name", ["run.mf4", "run.MF4.gz"])
def test_mf4_is_called_so_with_the_remedy(tmp_path, capsys, name):
    log = tmp_path / name
    log.write_bytes(b"MDF     4.10    ")
    assert_one_line_and_exit_2(log, capsys, "MF4 is not read: convert it to .asc or .blf")


def test_something_else_with_gz(tmp_path, capsys):
    log = tmp_path / "run.log.gz"
    log.write_text(GOOD[".log"])
    assert_one_line_and_exit_2(log, capsys, "no CAN log")


def test_a_log_without_frames_is_still_a_log(tmp_path, capsys):
    log = tmp_path / "run.csv"
    log.write_text(CSV_HEADER)
    assert decode(log, "--generation", "2") == 0
    assert capsys.readouterr() == ("", "")
