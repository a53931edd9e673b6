"""What the commands print before anything begins: help that can be read, and files that are not."""

from __future__ import annotations

import argparse
import inspect
import io
import json
import os
import pickle
import re
import sys
import unicodedata
from pathlib import Path

import pytest

from armui import cli
from armui.sim.faults.bugs import NAMES as BUG_NAMES
from armui.sim.faults.schedule import FAULTS
from armui.system import command_line
from armui.system.plain_words import translation
from armui.system.sentence import Told

_WIDTH = 80


def printed_help(capsys, *words):
    with pytest.raises(SystemExit) as ended:
        cli.main([*words, "--help"])
    assert ended.value.code == 0
    return capsys.readouterr().out


@pytest.mark.parametrize("command", ["", *cli._COMMANDS, "replay"])
def test_help_fits_a_terminal(capsys, command):
    lines = printed_help(capsys, *([command] if command else [])).splitlines()
    assert [line for line in lines if len(line) > _WIDTH] == []


def test_each_command_has_a_line_of_its_own(capsys):
    first_words = [line.split()[0] for line in printed_help(capsys).splitlines() if line.strip()]
    for command in (*cli._COMMANDS, "replay"):
        assert first_words.count(command) == 1


def test_each_fault_and_bug_of_the_simulated_arm_has_a_line_of_its_own(capsys):
    first_words = [line.split()[0] for line in printed_help(capsys, "sim").splitlines() if line]
    for name in (*FAULTS, *BUG_NAMES):
        assert first_words.count(name) == 1


@pytest.mark.parametrize(
    ("name", "says"), [("gone.blf", "No such file"), ("folder", "it is a folder")]
)
def test_a_log_that_cannot_be_read_opens_no_window(monkeypatch, capsys, tmp_path, name, says):
    (tmp_path / "folder").mkdir()
    monkeypatch.setitem(sys.modules, "armui.app", None)  # whoever imports it fails
    assert cli.main(["replay", str(tmp_path / name)]) == 2
    said = capsys.readouterr().err
    assert said.startswith(f"armui replay: {tmp_path / name}: ")
    assert says in said


@pytest.mark.parametrize("command", ["decode", "export"])
def test_the_other_commands_say_so_as_well(capsys, tmp_path, command):
    assert cli.main([command, str(tmp_path / "gone.blf")]) == 2
    assert "No such file" in capsys.readouterr().err


# In the operator's language -----------------------------------------------------------------------


@pytest.fixture
def chinese(monkeypatch):
    monkeypatch.setattr(command_line, "_language", lambda: "zh")


def columns(line):
    return sum(2 if unicodedata.east_asian_width(each) in "WF" else 1 for each in line)


@pytest.mark.parametrize("command", ["", *cli._COMMANDS, "replay"])
def test_help_is_whole_in_chinese_and_fits_a_terminal(capsys, chinese, command):
    text = printed_help(capsys, *([command] if command else []))
    lines = text.splitlines()
    assert [line for line in lines if columns(line) > _WIDTH] == []
    assert lines[0].startswith("用法：armui")
    prose = [line for line in lines if re.search(r"\b(the|and|of|is|it|show)\b", line)]
    assert prose == []


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--nonsense"], "armui：错误：无法识别的参数：--nonsense"),
        (["--bitrate", "x"], "参数 --bitrate：不是有效的 int 值：'x'"),
        (["decode"], "armui decode：错误：缺少以下参数：file"),
        (["--channel", "can0"], "--interface 与 --channel 必须同时给出"),
        (["--bitrate"], "需要一个值"),
    ],
)
def test_what_is_wrong_with_a_command_line_is_said_in_chinese(capsys, chinese, words, says):
    with pytest.raises(SystemExit) as ended:
        cli.main(words)
    assert ended.value.code == 2
    assert says in capsys.readouterr().err


def test_argparse_says_what_is_translated():
    """Its sentences are looked up as they stand in it; a Python that words them anew is found."""
    source = inspect.getsource(argparse)
    changing = ("invalid choice", "ignored explicit")
    missing = [
        text
        for text in command_line.OF_ARGPARSE
        if repr(text) not in source and not text.startswith(changing)
    ]
    assert missing == []


@pytest.mark.parametrize(
    ("words", "system", "chosen", "encoding", "expected"),
    [
        (["--help"], "zh", None, "utf-8", "zh"),
        (["--help"], "en", None, "utf-8", "en"),
        (["--help"], "en", "zh", "utf-8", "zh"),
        (["--help"], "zh", "en", "utf-8", "en"),
        (["--help"], "zh", None, "cp1252", "en"),
        (["--lang", "zh", "--help"], "en", None, "utf-8", "zh"),
        (["--lang", "en", "--help"], "zh", None, "utf-8", "en"),
    ],
)
def test_the_language_is_that_of_the_program_or_the_system(
    monkeypatch, tmp_path, words, system, chosen, encoding, expected
):
    settings = tmp_path / "settings.json"
    if chosen is not None:
        settings.write_text(json.dumps({"language": chosen}))
    monkeypatch.setattr(command_line, "settings_file", lambda: settings)
    for name in ("LC_MESSAGES", "LANG"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("LC_ALL", {"zh": "zh_CN.UTF-8", "en": "en_US.UTF-8"}[system])
    monkeypatch.setattr(sys, "argv", ["armui", *words])
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(io.BytesIO(), encoding=encoding))
    assert command_line._language() == expected


def test_a_command_line_that_is_right_reads_no_translation(monkeypatch):
    monkeypatch.setattr(command_line, "translation", None)
    monkeypatch.setattr(command_line, "settings_file", None)
    assert cli._parser().parse_args(["--sim"]).sim


def test_one_context_is_read_as_all_are():
    some, every = translation("zh", "CommandLine"), translation("zh")
    for text in command_line.OF_ARGPARSE:
        assert some("CommandLine", text) == every("CommandLine", text) != text
    assert translation("zh", "NoSuchContext")("NoSuchContext", "x") == "x"


def test_lines_break_at_words_and_before_no_mark():
    assert command_line.wrapped("一二三，四五 MOVE 六", 7) == ["一二", "三，四", "五 MOVE", "六"]
    assert command_line.wrapped("one two three", 7) == ["one two", "three"]


# Errors in the operator's language ----------------------------------------------------------------

_COMMANDS_OF_LOGS = ("decode", "export", "replay")
_BAD = {
    "gone.log": None,
    "folder.log": Path.mkdir,
    "nonsense.log": b"one line\nanother line\n" * 200,
    "unknown.xyz": b"x",
    "unpacked.mf4": b"x",
    "no.blf": b"x" * 400,
    "looks.log": b"LOGG" + bytes(400),
    "no.db": b"no database at all, and long enough" * 20,
    "no.log.gz": b"not packed",
}
_DAMAGED = b"(1.0) can0 2A5#0000000000000000\n(1.1) can0 nonsense\n"


def the_bad(folder, name):
    path, content = folder / name, _BAD[name]
    if isinstance(content, bytes):
        path.write_bytes(content)
    elif content is not None:
        content(path)
    return path


def assert_chinese(said, *names):
    """Every line is Chinese: no two English words follow one another, names left out."""
    assert said
    for name in map(str, names):
        said = said.replace(name, "…")
    lines = [line for line in said.splitlines() if not line.startswith((" ", "用法"))]
    for line in lines:
        plain = re.sub(r"armui( \w+)*|`[^`]*`|'[^']*'|（ ?choose.*|/ . : . .*", "…", line)
        assert re.search(r"[\u4e00-\u9fff]", plain), line
        assert not re.search(r"[A-Za-z]{3,} [a-z]{2,}", plain), line


@pytest.mark.parametrize("name", _BAD)
@pytest.mark.parametrize("command", ["decode", "export"])
def test_why_it_is_no_log_is_said_in_chinese(capsys, chinese, tmp_path, command, name):
    path = the_bad(tmp_path, name)
    assert cli.main([command, str(path)]) == 2
    assert_chinese(capsys.readouterr().err, path)


@pytest.mark.parametrize("name", ["gone.log", "folder.log"])
def test_why_nothing_can_be_replayed_is_said_in_chinese(capsys, chinese, tmp_path, name):
    path = the_bad(tmp_path, name)
    assert cli.main(["replay", str(path)]) == 2
    assert_chinese(capsys.readouterr().err, path)


@pytest.mark.parametrize("command", ["decode", "export"])
def test_a_damaged_log_is_told_in_chinese(capsys, chinese, tmp_path, command):
    path = tmp_path / "run.log"
    path.write_bytes(b"".join(b"(%d.0) can0 2A%d#%016d\n" % (1, n, 0) for n in (5, 6, 7)))
    path.write_bytes(path.read_bytes() + _DAMAGED)
    words = ["--to", "csv-messages"] if command == "export" else []
    assert cli.main([command, str(path), *words]) == 1
    said = capsys.readouterr().err
    assert_chinese(said, path)
    assert "第 5 行无法读取" in said


def test_why_nothing_was_exported_is_said_in_chinese(capsys, chinese, tmp_path):
    log = tmp_path / "run.log"
    log.write_bytes(_DAMAGED)
    cases = [
        (["-o", log], 2),
        (["--channel", "can7"], 2),
        (["--to", "csv", "--from", "99"], 2),
        (["--to", "csv-messages", "-o", tmp_path / "there"], 2),
        (["-o", tmp_path / "none" / "a.mcap"], 2),
    ]
    (tmp_path / "there").mkdir()
    for words, code in cases:
        assert cli.main(["export", str(log), *map(str, words)]) == code
        assert_chinese(capsys.readouterr().err, log, tmp_path)


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="root may read everything")
@pytest.mark.parametrize("command", _COMMANDS_OF_LOGS)
def test_a_closed_log_is_told_in_chinese(capsys, chinese, tmp_path, command):
    path = tmp_path / "run.log"
    path.write_bytes(_DAMAGED)
    path.chmod(0)
    assert cli.main([command, str(path)]) == 2
    assert "没有权限" in capsys.readouterr().err


def test_why_a_recording_cannot_begin_is_said_in_chinese(capsys, chinese, tmp_path):
    file = tmp_path / "file"
    file.write_bytes(b"")
    simulated = ["--sim", "--duration", "0.2"]
    cases = [
        [],
        ["--sim", "--interface", "socketcan"],
        ["--interface", "socketcan", "--channel", "no-such-can"],
        ["--interface", "no-such-adapter", "--channel", "0"],
        [*simulated, "--name", "a/b"],
        [*simulated, "-o", str(file / "below")],
    ]
    for words in cases:
        assert cli.main(["record", *words]) == 2
        assert_chinese(
            capsys.readouterr().err,
            tmp_path,
            "no-such-can",
            "no-such-adapter",
            "sudo modprobe",
            "pip install",
        )


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("decode", []),
        ("decode", ["a.log", "--nonsense"]),
        ("decode", ["a.log", "--generation", "3"]),
        ("decode", ["a.log", "--firmware", "1.8"]),
        ("export", []),
        ("export", ["a.log", "--from", "-1"]),
        ("export", ["a.log", "--to", "pdf"]),
        ("export", ["a.log", "--firmware", "1.8"]),
        ("record", ["--size", "0"]),
        ("record", ["--duration", "never"]),
        ("record", ["--format", "pdf"]),
        ("replay", []),
        ("replay", ["a.log", "--nonsense"]),
        ("replay", ["a.log", "--lang", "fr"]),
    ],
)
def test_a_wrong_option_of_a_command_is_told_in_chinese(capsys, chinese, command, words):
    with pytest.raises(SystemExit) as ended:
        cli.main([command, *words])
    assert ended.value.code == 2
    assert_chinese(capsys.readouterr().err)


def test_a_log_is_told_of_in_the_language_of_the_command_line(monkeypatch, capsys, tmp_path):
    path = tmp_path / "gone.log"
    for language, says in (("zh", "文件或文件夹不存在"), ("en", "No such file or directory")):
        words = ["decode", str(path), "--lang", language]
        monkeypatch.setattr(sys, "argv", ["armui", *words])
        monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(io.BytesIO(), encoding="utf-8"))
        assert cli.main(words) == 2
        assert says in capsys.readouterr().err


def test_a_text_remembers_its_sentence():
    """It does on its way to another process, too."""
    inner = Told("as asked for")
    told = pickle.loads(
        pickle.dumps(
            Told("{place} cannot be read: {reason}", place=Told("row {row}", row=3), reason=inner)
        )
    )
    assert told == "row 3 cannot be read: as asked for"
    assert told.translated(translation("zh", "CommandLine")) == "第 3 行无法读取：按要求"
