"""The command `armui decode` against logs of every format, whole and damaged."""

from __future__ import annotations

import argparse
import base64
import errno
import gzip
import json
import os
import subprocess
import sys
import threading
from pathlib import Path

import can
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from armui.decode import add_arguments, run

TEXT_SUFFIXES = (".log", ".asc", ".trc", ".csv")
# 90° = 90000 = 0x15F90, -0.001° = -1
JOINTS = "00015F90FFFFFFFF"


def message(time_s: float, arbitration_id: int, payload: str = "", **kind) -> can.Message:
    data = bytes.fromhex(payload)
    return can.Message(
        timestamp=time_s, arbitration_id=arbitration_id, data=data, dlc=kind.pop("dlc", len(data)),
        is_extended_id=kind.pop("extended", False), channel=1, **kind,
    )  # fmt: skip


def record(path: Path, *messages: can.Message) -> Path:
    with can.Logger(path) as logger:
        for each in messages:
            logger(each)
    return path


def decode(path: Path, *options: str) -> int:
    parser = argparse.ArgumentParser()
    add_arguments(parser)
    return run(parser.parse_args([*options, str(path)]))


def objects(capsys) -> tuple[list[dict], str]:
    output = capsys.readouterr()
    return [json.loads(line) for line in output.out.splitlines()], output.err


def in_process(*arguments: str, **keywords) -> subprocess.Popen:
    code = (
        "import argparse, sys; from armui.decode import add_arguments, run; "
        "p = argparse.ArgumentParser(); add_arguments(p); sys.exit(run(p.parse_args()))"
    )
    return subprocess.Popen(
        [sys.executable, "-c", code, *arguments],
        cwd=Path(__file__).parents[1],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **keywords,
    )


# --- what is printed --------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [*TEXT_SUFFIXES, ".blf"])
def test_every_format_gives_the_same_frames(tmp_path, capsys, suffix):
    log = record(
        tmp_path / f"run{suffix}",
        message(1.0, 0x2A5, JOINTS),
        message(1.25, 0x777, "0102"),
        message(1.5, 0x471, "0702000000000000"),
        message(1.75, 0x12345, "AA", extended=True),
    )
    assert decode(log, "--generation", "2", "--json") == 0
    lines, errors = objects(capsys)
    assert errors == ""
    assert [line["t"] - lines[0]["t"] for line in lines] == pytest.approx([0, 0.25, 0.5, 0.75])
    assert [line["id"] for line in lines] == ["0x2A5", "0x777", "0x471", "0x00012345"]
    assert [line["message"] for line in lines] == ["JointFeedback12", None, "MotorEnable", None]
    assert lines[0]["signals"] == {
        "J1": {"value": 90.0, "unit": "deg"},
        "J2": {"value": -0.001, "unit": "deg"},
    }
    assert lines[2]["signals"] == {
        "Joint": {"value": 7, "unit": "", "word": "All joints"},
        "Action": {"value": 2, "unit": "", "word": "Enable"},
    }
    assert lines[1]["oddity"] == {
        "kind": "unknown identifier",
        "detail": "0x777 is not in the tables of generation 2",
    }
    assert lines[1]["data"] == "0102"


def test_json_has_the_documented_keys_and_nothing_else(tmp_path, capsys):
    log = tmp_path / "run.log"
    log.write_text(f"(1.500000) can0 2A5#{JOINTS}\n")
    decode(log, "--generation", "2", "--json")
    assert capsys.readouterr().out == (
        '{"t": 1.5, "id": "0x2A5", "message": "JointFeedback12", "signals": '
        '{"J1": {"value": 90.0, "unit": "deg"}, "J2": {"value": -0.001, "unit": "deg"}}}\n'
    )


def test_text_has_time_identifier_message_and_units(tmp_path, capsys):
    log = tmp_path / "run.log"
    log.write_text(
        f"(1.500000) can0 2A5#{JOINTS}\n"
        "(1.600000) can0 159#0001117013880100\n"
        "(1.700000) can0 777#AB\n"
        "(1.800000) can0 47B#0900000000000000\n"
    )
    assert decode(log, "--generation", "2") == 0
    lines = [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()]
    assert lines == [
        "1.500000 0x2A5 JointFeedback12 J1=90 deg J2=-0.001 deg",
        (
            "1.600000 0x159 GripperCommand Opening=70 mm Torque=5 N.m Enable=1 (Enable) "
            "ClearError=0 (No) SetZero=0 (No)"
        ),
        (
            "1.700000 0x777 unknown "
            "(unknown identifier: 0x777 is not in the tables of generation 2) AB"
        ),
        (
            "1.800000 0x47B CollisionFeedback J1=9 J2=0 J3=0 J4=0 J5=0 J6=0 "
            "(value outside the table: CollisionFeedback.J1 is 9, not within 0 to 8)"
        ),
    ]


def test_the_generation_chooses_units(tmp_path, capsys):
    log = tmp_path / "run.log"
    # 0x12C = 300
    log.write_text("(0.0) can0 473#010708FFFF012C00\n")
    for generation, expected in (("1", "MaxSpeed=300 rpm"), ("2", "MaxSpeed=3 rad/s")):
        decode(log, "--generation", generation)
        assert expected in capsys.readouterr().out


def test_odd_values_keep_their_message(tmp_path, capsys):
    log = tmp_path / "run.log"
    log.write_text("(0.0) can0 2A1#0910000000000000\n(0.1) can0 2A5#0102\n")
    assert decode(log, "--generation", "2", "--json") == 0
    (status, short), _ = objects(capsys)
    assert status["message"] == "ArmStatus"
    assert status["signals"]["ControlMode"] == {"value": 9, "unit": ""}
    assert status["oddity"]["kind"] == "value outside the table"
    assert (short["message"], short["signals"], short["data"]) == (None, {}, "0102")
    assert short["oddity"] == {
        "kind": "wrong length",
        "detail": "JointFeedback12 has 2 bytes instead of 8",
    }


@pytest.mark.parametrize("suffix", [".log", ".asc", ".blf"])
def test_frames_the_arm_never_sends_are_shown_as_such(tmp_path, capsys, suffix):
    log = record(
        tmp_path / f"run{suffix}",
        message(1.0, 0x2A5, "00" * 16, is_fd=True),
        message(1.1, 0x2A5, is_remote_frame=True, dlc=8),
        message(1.2, 0, is_error_frame=True),
        message(1.3, 0x2A5, JOINTS, extended=True),
    )
    assert decode(log, "--generation", "2", "--json") == 0
    lines, _ = objects(capsys)
    assert [line["message"] for line in lines] == [None] * 4
    assert [line["oddity"]["kind"] for line in lines] == [
        "CAN FD frame", "remote frame", "error frame", "frame with a 29-bit identifier",
    ]  # fmt: skip
    assert lines[3]["id"] == "0x000002A5"


def test_candump_error_frames_of_every_class(tmp_path, capsys):
    """0x20000004 is a controller problem; python-can by itself takes it for a data frame."""
    log = tmp_path / "run.log"
    log.write_text("(0.0) can0 20000004#0004000000000000\n(0.1) can0 1FFFFFFF#00\n")
    decode(log, "--generation", "2", "--json")
    lines, _ = objects(capsys)
    assert [line["oddity"]["kind"] for line in lines] == [
        "error frame", "frame with a 29-bit identifier",
    ]  # fmt: skip


def test_compressed_logs(tmp_path, capsys):
    log = tmp_path / "run.log.gz"
    log.write_bytes(gzip.compress(f"(1.0) can0 2A5#{JOINTS}\n".encode()))
    assert decode(log, "--generation", "2") == 0
    assert "J1=90 deg" in capsys.readouterr().out


# --- damaged lines ----------------------------------------------------------------------------

ASC_HEADER = "date Sat Nov 21 02:00:00.000 2026\nbase hex  timestamps absolute\n"
ASC_BEGIN = "internal events logged\nBegin Triggerblock Thu Jan 01 00:00:00.0 1970\n"
TRC_HEADER = ";$FILEVERSION=2.1\n;$STARTTIME=25569.0\n;$COLUMNS=N,O,T,I,d,L,D\n;\n"
CSV_HEADER = "timestamp,arbitration_id,extended,remote,error,dlc,data\n"
GOOD = {
    ".log": "(1.0) can0 2A5#0000000000000000",
    ".asc": "1.000000 1  2A5             Rx   d 8 00 00 00 00 00 00 00 00",
    ".trc": "  1  1000.000 DT 02A5 Rx 8 00 00 00 00 00 00 00 00",
    ".csv": f"1.0,0x2a5,0,0,0,8,{base64.b64encode(bytes(8)).decode()}",
}
HEADER = {".log": "", ".asc": ASC_HEADER + ASC_BEGIN, ".trc": TRC_HEADER, ".csv": CSV_HEADER}
DAMAGED = {
    ".log": [
        "garbage", "(1.0) can0 2A5", "(1.0) can0 2A5#0", "(1.0) can0 2A5#00GG", "(x) can0 2A5#00",
        "(nan) can0 2A5#00", "(1.0) can0 2A5#000000000000000000", "(1.0) can0 FFF#00", "# comment",
        "(1.0) can0 #00", "(1.0) can0 2A5##", "\x00\x01\x02", "(1.0) can0 -2A#00",
    ],
    ".asc": [
        "garbage", "1.000000 1  2A5             Rx   d 8 00 00 00 00 00 00 00",
        "1.000000 1  2A5             Rx   d 8 00 00 00 00 00 00 00 GG",
        "1.000000 1  XYZ             Rx   d 1 00", "1.000000 1  2A5             Rx   d",
        "1.000000 1  FFF             Rx   d 1 00", "1.0x 1 2A5 Rx d 0",
        "1.000000 CANFD   1 Rx        2A5   0 0",
    ],
    ".trc": [
        "garbage", "  1  1000.000 DT 02A5 Rx 8 00 00", "  1  1000.000 DT 02A5 Rx 8 00 GG",
        "  1  x DT 02A5 Rx 1 00", "  1  1000.000 QQ 02A5 Rx 1 00", "  1",
        "  1  1.0 DT 02A5 Rx x 00",
    ],
    ".csv": [
        "garbage", "1.0,0x2a5,0,0,0,8", "x,0x2a5,0,0,0,0,", "1.0,zz,0,0,0,0,",
        "1.0,0x2a5,0,0,0,8,AAA=", "1.0,0x2a5,0,0,0,8,!", "nan,0x2a5,0,0,0,0,",
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
    max_examples=25,
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


def test_a_blf_damaged_in_the_middle_says_where(blf, capsys):
    whole = bytearray(blf.read_bytes())
    second = whole.index(b"LOBJ", whole.index(b"LOBJ") + 4)
    whole[second : second + 4] = b"JUNK"
    blf.write_bytes(whole)
    assert decode(blf, "--generation", "2", "--json") == 1
    lines, errors = objects(capsys)
    assert len(lines) > 0
    assert f"damaged here (BLFParseError), after {len(lines)} frames" in errors


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
        monkeypatch.setattr("pathlib.Path.open", refuse)
        assert_one_line_and_exit_2(log, capsys, "Permission denied", *options)

    def test_empty(self, tmp_path, capsys, suffix, options):
        log = tmp_path / f"empty{suffix}"
        log.touch()
        assert_one_line_and_exit_2(log, capsys, "", *options)

    @pytest.mark.parametrize("garbage", [bytes(range(256)) * 40, b"hello\nworld\n" * 3000, b"\0"])
    def test_garbage(self, tmp_path, capsys, suffix, options, garbage):
        log = tmp_path / f"garbage{suffix}"
        log.write_bytes(garbage)
        assert_one_line_and_exit_2(log, capsys, "", *options)


@pytest.mark.parametrize("name", ["notes.txt", "noextension", "run.gz", "run.txt.gz"])
def test_unknown_suffix(tmp_path, capsys, name):
    log = tmp_path / name
    log.write_text(GOOD[".log"])
    assert_one_line_and_exit_2(log, capsys, "known are .log, .asc, .blf, .trc, .csv")


def test_something_else_with_gz(tmp_path, capsys):
    log = tmp_path / "run.log.gz"
    log.write_text(GOOD[".log"])
    assert_one_line_and_exit_2(log, capsys, "no CAN log")


def test_a_log_without_frames_is_still_a_log(tmp_path, capsys):
    log = tmp_path / "run.csv"
    log.write_text(CSV_HEADER)
    assert decode(log, "--generation", "2") == 0
    assert capsys.readouterr() == ("", "")


# --- the generation ---------------------------------------------------------------------------


def test_auto_says_which_and_why(tmp_path, capsys):
    log = tmp_path / "run.log"
    log.write_text(
        "(0.0) can0 473#010708FFFF012C00\n(0.1) can0 4AF#532D56312E362D33\n"  # "S-V1.6-3"
    )
    assert decode(log) == 0
    output = capsys.readouterr()
    assert "MaxSpeed=3 rad/s" in output.out
    assert "read as generation 2: the arm named its firmware S-V1.6-3" in output.err


def test_auto_knows_generation_1_by_its_short_frames(tmp_path, capsys):
    log = tmp_path / "run.log"
    log.write_text("(0.0) can0 158#01\n(0.1) can0 473#010708FFFF012C00\n")
    assert decode(log) == 0
    output = capsys.readouterr()
    assert "MaxSpeed=300 rpm" in output.out
    assert "read as generation 1: frames that fit only this generation: 1" in output.err


def test_auto_reports_damaged_lines_once(tmp_path, capsys):
    log = tmp_path / "run.log"
    log.write_text(f"{GOOD['.log']}\ngarbage\n")
    assert decode(log) == 1
    assert capsys.readouterr().err.count("line 2 cannot be read") == 1


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_auto_reads_a_pipe_twice(tmp_path, capsys):
    pipe = tmp_path / "live.log"
    os.mkfifo(pipe)
    text = f"(0.0) can0 2A5#{JOINTS}\n(0.1) can0 4AF#532D56312E362D33\n"
    writer = threading.Thread(target=pipe.write_text, args=(text,))
    writer.start()
    try:
        assert decode(pipe) == 0
    finally:
        writer.join(timeout=10)
    output = capsys.readouterr()
    assert "J1=90 deg" in output.out
    assert "generation 2: the arm named its firmware" in output.err


# --- as a process -----------------------------------------------------------------------------


def test_a_reader_that_stops_early_ends_it_quietly(tmp_path):
    log = tmp_path / "run.log"
    log.write_text(f"{GOOD['.log']}\n" * 20_000)
    with in_process("--generation", "2", str(log)) as process:
        assert "JointFeedback12" in process.stdout.readline()
        process.stdout.close()
        errors = process.stderr.read()
        assert process.wait(timeout=30) == 0
    assert errors == ""


def test_the_readers_own_comments_stay_off_the_terminal(tmp_path):
    log = tmp_path / "run.trc"
    log.write_text(f"{TRC_HEADER}{GOOD['.trc']}\n  1\n")
    with in_process("--generation", "2", str(log)) as process:
        _, errors = process.communicate(timeout=30)
    assert process.returncode == 1
    assert errors == f"armui decode: {log}: line 6 cannot be read: '1'\n"
