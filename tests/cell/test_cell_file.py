"""Cells as files: taken whole or refused whole, with the place of the fault."""

import json

import pytest

from armui.arm.refusal import Refusal
from armui.cell.cell import Cell, with_part, without_part
from armui.cell.cell_file import (
    CELL_FIELD_BAD,
    CELL_FOREIGN,
    CELL_NO_JSON,
    CELL_VERSION,
    Difference,
    differences,
    from_text,
    read_cell,
    to_text,
    write_cell,
)
from armui.cell.checks import CELL_FIGURE_BAD, CELL_NAME_BAD, CELL_NAME_TAKEN, check_name
from armui.cell.tools import Tool
from tests.each import check_each

PEN = Tool("pen", (1.0, -2.5, 120.0, 0.0, 90.0, -180.0), 12.5)
HOOK = Tool("hook", (0.0, 0.0, 80.0, 0.0, 0.0, 0.0))
BENCH = Cell("bench", (PEN, HOOK), "pen")


def test_a_file_has_a_parameter_a_line_with_its_unit():
    lines = to_text(BENCH).splitlines()
    assert '      "x_mm": 1.0,' in lines
    assert '      "rz_deg": -180.0,' in lines
    assert '      "radius_mm": 12.5' in lines


def test_what_was_written_is_read_and_named_after_its_file(tmp_path):
    path = tmp_path / "bench.armui-cell"
    assert write_cell(path, BENCH) is None
    assert read_cell(path) == BENCH
    path.rename(tmp_path / "桌 2.armui-cell")
    assert read_cell(tmp_path / "桌 2.armui-cell") == Cell("桌 2", (PEN, HOOK), "pen")


def changed(**changes):
    return json.dumps({**json.loads(to_text(BENCH)), **changes})


def with_pen(**changes):
    entries = json.loads(to_text(BENCH))
    entries["tools"][0].update(changes)
    return json.dumps(entries)


def without(name):
    entries = json.loads(to_text(BENCH))
    del entries["tools"][0][name]
    return json.dumps(entries)


BROKEN = {
    "cut short": (to_text(BENCH)[:80], CELL_NO_JSON),
    "nothing": ("", CELL_NO_JSON),
    "a list": ("[]", CELL_FOREIGN),
    "another file": ('{"format": "armui-parameters", "version": 1}', CELL_FOREIGN),
    "nested deep": ("[" * 100_000, CELL_FOREIGN),
    "newer": (changed(version=3), CELL_VERSION),
    "no version": (changed(version=True), CELL_FIELD_BAD),
    "an unknown part": (changed(walls=[]), CELL_FIELD_BAD),
    "a figure too large": (with_pen(x_mm=500.1), CELL_FIGURE_BAD),
    "a turn too large": (with_pen(rx_deg=180.5), CELL_FIGURE_BAD),
    "a text": (with_pen(z_mm="far"), CELL_FIELD_BAD),
    "no number": (with_pen(z_mm=float("nan")), CELL_FIELD_BAD),
    "a negative radius": (with_pen(radius_mm=-0.1), CELL_FIGURE_BAD),
    "an unknown figure": (with_pen(y_deg=0.0), CELL_FIELD_BAD),
    "a figure missing": (without("z_mm"), CELL_FIELD_BAD),
    "one name twice": (with_pen(name="HOOK"), CELL_NAME_TAKEN),
    "no name": (with_pen(name=""), CELL_NAME_BAD),
    "a choice that is not there": (changed(tool="saw"), None),
}


@pytest.mark.parametrize("fault", BROKEN)
def test_what_is_broken_is_refused_whole(fault):
    text, reason = BROKEN[fault]
    answer = from_text(text, "bench")
    assert isinstance(answer, Refusal)
    assert answer.reason == reason or reason is None


def test_a_place_is_named_of_what_is_wrong():
    answer = from_text(with_pen(z_mm="far"), "bench")
    assert answer.params["field"] == "tools[1].z_mm"
    assert from_text(changed(version=7), "bench").params == {"version": 7, "known": 2}
    assert from_text('{\n "format": x', "bench").params == {"line": 2, "column": 12}


def test_names_are_those_that_every_file_system_takes():
    def refused(name):
        assert check_name(name).reason == CELL_NAME_BAD

    def allowed(name):
        assert check_name(name) is None

    check_each(["", " a", "a ", ".a", "~a", "a.", "a/b", 'a"b', "a\nb", "con", "LPT1.x"], refused)
    check_each(["a", "a b", "夹爪 2", "x.y", "e-1", "a" * 40], allowed)
    assert check_name("a" * 41).params == {"value": "a" * 41, "maximum": 40}


def test_differences_name_the_parameter():
    raised = with_part(
        BENCH, Tool("pen", (1.0, -2.5, 130.0, 0.0, 90.0, -180.0), 12.5), instead_of="pen"
    )
    assert differences(BENCH, raised) == (Difference("tools.pen.z_mm", 120.0, 130.0),)
    gone = differences(BENCH, without_part(BENCH, Tool, "pen"))
    assert Difference("tool", "pen", "") in gone
    assert Difference("tools.pen.radius_mm", 12.5, None) in gone
    assert differences(BENCH, BENCH) == ()


def test_a_new_tool_is_chosen_and_a_renamed_one_stays_so():
    cell = with_part(Cell("a"), HOOK)
    assert (cell.tool, cell.tools) == ("hook", (HOOK,))
    cell = with_part(cell, Tool("claw", HOOK.pose), instead_of="hook")
    assert (cell.tool, cell.chosen_tool.name) == ("claw", "claw")
    assert without_part(cell, Tool, "claw") == Cell("a")


def test_the_capsule_is_as_long_as_the_tip_is_far():
    assert Tool("a", (30.0, 40.0, 120.0, 0.0, 0.0, 0.0)).length_mm == pytest.approx(130.0)
