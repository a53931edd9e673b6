"""What the commands print before anything begins: help that can be read, and files that are not."""

from __future__ import annotations

import sys

import pytest

from armui import cli
from armui.sim.faults.bugs import NAMES as BUG_NAMES
from armui.sim.faults.schedule import FAULTS

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
