"""What `armui decode` prints: every format, both generations, as a process."""

from __future__ import annotations

import gzip
import os
import threading

import pytest

from tests.decode.logs import (
    GOOD,
    JOINTS,
    TEXT_SUFFIXES,
    TRC_HEADER,
    decode,
    in_process,
    message,
    objects,
    record,
)
from tests.posix import make_pipe

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
            "ClearError=0 (No) Measure=0 (Opening) SetZero=0 (No)"
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
    make_pipe(pipe)
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
