"""The gripper table: pure, interpolated both ways, refused where it does not rise."""

import pytest

from armui.arm.refusal import Refusal
from armui.cell.cell import Cell, check_cell
from armui.cell.cell_file import from_text, to_text
from armui.cell.checks import CELL_FIGURE_BAD
from armui.cell.gripper_table import (
    GRIPPER_TABLE_LONG,
    GRIPPER_TABLE_NOT_RISING,
    GRIPPER_TABLE_SHORT,
    GripperTable,
    check_gripper_table,
)

PAIRS = ((10.0, 8.0), (45.0, 38.0), (60.0, 50.0))
TABLE = GripperTable(PAIRS)


@pytest.mark.parametrize(
    ("asked", "measured"),
    [
        *PAIRS,
        (27.5, 23.0),  # half of the first piece: 8 + 30 · 17.5 / 35
        (54.0, 45.2),  # 38 + 12 · 9 / 15
        (3.0, 2.0),  # below the first pair its piece goes on: 8 - 7 · 30 / 35
        (70.0, 58.0),  # above the last one, too: 50 + 10 · 12 / 15
    ],
)
def test_it_leads_there_and_back(asked, measured):
    assert TABLE.measured_mm(asked) == pytest.approx(measured)
    assert TABLE.asked_mm(measured) == pytest.approx(asked)


@pytest.mark.parametrize(
    ("pairs", "reason"),
    [
        (tuple((10.0 * k, 9.0 * k) for k in range(9)), GRIPPER_TABLE_LONG),
        (((10.0, 8.0),), GRIPPER_TABLE_SHORT),
        ((), GRIPPER_TABLE_SHORT),
        (((10.0, 8.0), (20.0, 8.05)), GRIPPER_TABLE_NOT_RISING),
        (((10.0, 8.0), (10.0, 9.0)), GRIPPER_TABLE_NOT_RISING),
        (((20.0, 8.0), (10.0, 9.0)), GRIPPER_TABLE_NOT_RISING),
        (((10.0, 8.0), (20.0, 200.5)), CELL_FIGURE_BAD),
        (((-1.0, 8.0), (20.0, 18.0)), CELL_FIGURE_BAD),
        (((0.0, float("nan")), (20.0, 18.0)), CELL_FIGURE_BAD),
    ],
)
def test_what_is_no_table_is_refused_with_the_reason(pairs, reason):
    refusal = check_gripper_table(pairs, used=True)
    assert refusal is not None
    assert refusal.reason == reason


def test_what_does_not_rise_is_named():
    refusal = check_gripper_table(((10.0, 8.0), (20.0, 7.0)), used=False)
    assert refusal == GRIPPER_TABLE_NOT_RISING(value=7.0, maximum=20.0, before=8.0, minimum=10.0)


def test_it_stands_in_the_cell_s_file_a_parameter_a_line():
    cell = Cell("bench", gripper_table=PAIRS, gripper_calibrated=True)
    text = to_text(cell)
    assert '      "asked_mm": 45.0,' in text.splitlines()
    assert '      "measured_mm": 38.0' in text.splitlines()
    assert from_text(text, "bench") == cell
    assert check_cell(cell) is None


def test_a_file_of_before_has_none_and_a_broken_one_is_refused_whole():
    assert from_text('{"format": "armui-cell", "version": 1}', "a") == Cell("a")
    text = to_text(Cell("a", gripper_table=PAIRS, gripper_calibrated=True))
    for old, new in (
        ('"measured_mm": 38.0', '"measured_mm": 8.0'),
        ('"gripper_calibrated": 1', '"gripper_calibrated": 2'),
        ('"asked_mm": 10.0', '"asked": 10.0'),
    ):
        assert old in text
        assert isinstance(from_text(text.replace(old, new), "a"), Refusal)
