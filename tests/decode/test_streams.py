"""`armui decode` of what comes through a pipe, and every command with an output that fails."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from armui.cli import main
from armui.session.session import MarkKind
from armui.sim.mechanics.gripper import _OPENING_SPEED_MM_S
from tests.decode.logs import JOINTS, decode, objects
from tests.session.indexed import open_indexed

POSIX = pytest.mark.skipif(os.name == "nt", reason="of the shells of Linux")
ROOT = Path(__file__).parents[2]


def begun(*words: str, **more) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "armui", *words],
        cwd=ROOT, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, **more,
    )  # fmt: skip


@pytest.mark.timeout(60)
def test_lines_appear_as_they_come():
    with begun("decode", "-") as process:
        for number in range(3):
            process.stdin.write(f"(1.{number:06d}) can0 2A5#{JOINTS}\n")
            process.stdin.flush()
            assert "J1=90 deg" in process.stdout.readline()
        process.stdin.close()
        assert process.wait(timeout=30) == 0


@POSIX
@pytest.mark.timeout(60)
def test_ctrl_c_ends_it_quietly():
    with begun("decode", "-", "--generation", "2") as process:
        process.stdin.write(f"  can0  2A5   [8]  {bytes.fromhex(JOINTS).hex(' ')}\n")
        process.stdin.flush()
        assert process.stdout.readline()
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=30) == 130
        process.stdin.close()
        assert "Traceback" not in process.stderr.read()


@POSIX
@pytest.mark.timeout(60)
@pytest.mark.parametrize("name", ["-", "/dev/stdin"])
@pytest.mark.parametrize("through_pipe", [True, False])
def test_what_comes_first_tells_the_format(tmp_path, name, through_pipe):
    log = tmp_path / "run.asc"
    log.write_text(
        "date Don Okt 1 03:28:27.5 2026\nbase hex  timestamps absolute\n"
        "internal events logged\n   0.1 Start der Messung\n"
        f"   0.250000 1  2A5  Rx  d 8 {bytes.fromhex(JOINTS).hex(' ')}\n"
    )
    words = [sys.executable, "-m", "armui", "decode", name]
    with log.open() as file:
        if through_pipe:
            done = subprocess.run(
                words, cwd=ROOT, capture_output=True, text=True, input=file.read(), check=False
            )
        else:
            done = subprocess.run(
                words, cwd=ROOT, capture_output=True, text=True, stdin=file, check=False
            )
    assert (done.returncode, "J1=90 deg" in done.stdout) == (0, True)
    assert "cannot be read" not in done.stderr


@pytest.mark.timeout(60)
def test_a_pipe_whose_generation_shows_late_is_read_anew_from_there():
    with begun("decode", "-") as process:
        process.stdin.write(f"(0.000000) can0 2A5#{JOINTS}\n")
        process.stdin.flush()
        assert "J1=90 deg" in process.stdout.readline()
        process.stdin.write("(0.100000) can0 158#01\n(0.200000) can0 473#010708FFFF012C00\n")
        process.stdin.flush()
        process.stdin.close()
        assert "MaxSpeed=300 rpm" in process.stdout.read()
        assert "from here on read as generation 1" in process.stderr.read()


@pytest.mark.parametrize("command", ["export", "replay"])
def test_where_a_file_is_needed_it_is_said(command, capsys):
    assert main([command, "-"]) == 2
    assert "a file is needed here, not the standard input" in capsys.readouterr().err


# --- an output that fails -----------------------------------------------------------------------

COMMANDS = {
    "decode": "decode {log}",
    "doctor": "doctor --no-listen",
    "export": "export {log} -o {folder}/a.csv --force",
    "record": "record --sim --duration 0.3 --quiet -o {folder}",
    "sim": "sim --interface virtual --channel k",
    "help": "decode --help",
    "replay": "replay --help",
    "version": "--version",
}


@POSIX
@pytest.mark.timeout(60)
@pytest.mark.parametrize("ends", ["> /dev/full", ">&-"])
@pytest.mark.parametrize("name", COMMANDS)
def test_a_full_or_closed_output_costs_one_line(tmp_path, name, ends):
    log = tmp_path / "run.log"
    log.write_text("".join(f"(1.000000) can0 2A{n}#{JOINTS}\n" for n in (5, 6, 7)))
    words = COMMANDS[name].format(log=log, folder=tmp_path)
    done = subprocess.run(
        ["sh", "-c", f"exec {sys.executable} -m armui {words} {ends}"],
        cwd=ROOT, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert "Traceback" not in done.stderr
    assert "Exception" not in done.stderr
    assert done.stderr.count("the standard output cannot be written") == 1


# --- jumps of the gripper -----------------------------------------------------------------------


def gripper(at_s: float, raw: int, *, measure: int = 1, channel: str = "can0") -> str:
    return f"({at_s:.6f}) {channel} 2A8#{raw & 0xFFFFFFFF:08X}00000{measure:03X}\n"


@pytest.mark.parametrize("as_json", [False, True])
def test_a_reading_that_jumps_is_marked(tmp_path, capsys, as_json):
    log = tmp_path / "run.log"
    readings = [(0.0, 97_250), (0.005, 97_240), (0.01, 310), (0.015, 300), (0.02, 97_200)]
    log.write_text("".join(gripper(100 + at_s, raw) for at_s, raw in readings))
    decode(log, "--generation", "2", *(["--json"] if as_json else []))
    if as_json:
        lines, _errors = objects(capsys)
        details = [each.get("oddity", {}).get("detail", "") for each in lines]
    else:
        told = capsys.readouterr().out.splitlines()
        details = [each.partition("impossible jump: ")[2] for each in told]
    assert [bool(each) for each in details] == [False, False, True, False, True]
    assert "from 97.24 to 0.31 deg in 5 ms" in details[2]
    session = open_indexed(log)
    marks = [each for each in session.marks if each.entry["code"] == "gripper_jump"]
    assert [each.at_s for each in marks] == pytest.approx([100.01, 100.02])
    assert {each.kind for each in marks} == {MarkKind.NOTE}
    assert json.dumps(marks[0].entry)
    session.close()


def test_a_gripper_that_moves_is_not(tmp_path, capsys):
    """Ten times as fast as the simulated one; delivered in bursts of 16 ms; after a gap."""
    log = tmp_path / "run.log"
    speed = 10 * _OPENING_SPEED_MM_S
    lines = [
        gripper(0.016 * (n // 4), round(1e3 * min(speed * 0.004 * n, 100.0)), measure=0)
        for n in range(40)
    ]
    lines.append(gripper(3.0, 0, measure=0))
    lines.append(gripper(3.004, 95_000, measure=1))  # an angle is another thing than an opening
    lines.append(gripper(3.004, 90_000, measure=0, channel="can1"))  # another arm's
    log.write_text("".join(lines))
    decode(log, "--generation", "2")
    assert "impossible jump" not in capsys.readouterr().out
    session = open_indexed(log)
    assert [each for each in session.marks if each.entry["code"] == "gripper_jump"] == []
    session.close()
