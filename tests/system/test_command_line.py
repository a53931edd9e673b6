"""What the commands print before anything begins: help that can be read, and files that are not."""

from __future__ import annotations

import argparse
import inspect
import io
import json
import re
import sys
import unicodedata

import pytest

from armui import cli
from armui.sim.faults.bugs import NAMES as BUG_NAMES
from armui.sim.faults.schedule import FAULTS
from armui.system import command_line
from armui.system.plain_words import translation

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
