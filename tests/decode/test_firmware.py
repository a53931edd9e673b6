"""Which firmware's MIT frames a log is read with: its own word, else --firmware, else today's."""

from __future__ import annotations

import pytest

from tests.decode.logs import decode

# 2 N·m to joint 1, as in the worked examples of the two layouts
OLDER, NEWER = "15A#851E7FF0519479F8", "15A#851E7FF0519478FF"


def is_2_nm(line: str) -> bool:
    """As near as a step of either layout comes."""
    return "Torque=1.976" in line or "Torque=1.9965" in line


def answer(version: str) -> list[str]:
    """Eleven frames of 0x4AF, the version at bytes 60-67 and a date behind it."""
    text = bytearray(88)
    text[0:8], text[60 : 60 + len(version)] = b"H-V1.2-1", version.encode()
    text[68:74] = b"260716"
    return [f"4AF#{text[start : start + 8].hex().upper()}" for start in range(0, 88, 8)]


def log_of(tmp_path, *frames: str):
    path = tmp_path / "run.log"
    lines = (f"({n / 1000:.6f}) {'can0 ' if ' ' not in f else ''}{f}" for n, f in enumerate(frames))
    path.write_text("\n".join(lines) + "\n")
    return path


def said(capsys) -> tuple[list[str], str]:
    output = capsys.readouterr()
    return [line for line in output.out.splitlines() if "0x15A" in line], output.err


@pytest.mark.parametrize(
    ("version", "frame"), [("S-V1.8-7", OLDER), ("S-V1.8-8", NEWER), ("S-V1.9-0", NEWER)]
)
def test_the_log_tells_it_wherever_it_stands(tmp_path, capsys, version, frame):
    log = log_of(tmp_path, frame, *answer(version), frame)
    assert decode(log, "--generation", "2") == 0
    lines, errors = said(capsys)
    assert len(lines) == 2
    assert all(is_2_nm(line) for line in lines)
    assert errors == f"armui decode: {log}: firmware {version}, as the log tells\n"


def test_what_the_log_tells_counts_more_than_the_option(tmp_path, capsys):
    log = log_of(tmp_path, *answer("S-V1.8-5"), OLDER)
    decode(log, "--generation", "2", "--firmware", "S-V1.8-9")
    (line,), errors = said(capsys)
    assert is_2_nm(line)
    assert "firmware S-V1.8-9, as --firmware says, unless the log tells another" in errors
    assert "firmware S-V1.8-5, as the log tells" in errors


@pytest.mark.parametrize(("version", "frame"), [("S-V1.8-5", OLDER), ("S-V1.8-9", NEWER)])
def test_else_the_option(tmp_path, capsys, version, frame):
    decode(log_of(tmp_path, frame), "--generation", "2", "--firmware", version)
    (line,), errors = said(capsys)
    assert is_2_nm(line)
    assert f"firmware {version}, as --firmware says" in errors


def test_without_any_word_todays_is_taken_and_said(tmp_path, capsys):
    decode(log_of(tmp_path, NEWER, OLDER), "--generation", "2")
    lines, errors = said(capsys)
    assert is_2_nm(lines[0])
    assert "Torque=3.94" in lines[1]  # an older frame read so: twice the torque
    assert errors.count("names no firmware: MIT frames are read as those of S-V1.8-8") == 1


def test_nothing_is_said_of_a_log_without_mit_frames(tmp_path, capsys):
    decode(log_of(tmp_path, "2A5#00015F90FFFFFFFF"), "--generation", "2")
    assert capsys.readouterr().err == ""


def test_two_arms_with_two_layouts_are_told(tmp_path, capsys):
    other = [f"can1 {frame}" for frame in answer("S-V1.8-9")]
    decode(log_of(tmp_path, *answer("S-V1.8-5"), *other, OLDER), "--generation", "2")
    _lines, errors = said(capsys)
    assert "firmware S-V1.8-9 on can1; all MIT frames are read as those of S-V1.8-5" in errors


def test_a_version_that_is_none_is_refused(tmp_path, capsys):
    with pytest.raises(SystemExit) as ended:
        decode(log_of(tmp_path, NEWER), "--firmware", "1.8")
    assert ended.value.code == 2
    assert "'1.8' is no firmware version; write it as S-V1.8-9" in capsys.readouterr().err


def test_the_gripper_by_angle_and_its_opening_side_by_side(tmp_path, capsys):
    """Frames of one identifier with different signals: each line has its own."""
    opening, angle = "2A8#000186A000004000", "2A8#0000753000004001"
    decode(log_of(tmp_path, opening, angle, opening), "--generation", "2")
    lines = capsys.readouterr().out.splitlines()
    assert ["Opening=100 mm" in line for line in lines] == [True, False, True]
    assert ["Angle=30 deg" in line for line in lines] == [False, True, False]
